"""The formula book."""

from dataclasses import dataclass

from fastapi import APIRouter, Request, Response

from app.reports.book import Topic, formula_book
from app.web.templating import page, translator

router = APIRouter()


@dataclass(frozen=True)
class FormulasPage:
    """Context of ``formulas/book.html``."""

    topics: tuple[Topic, ...]


@router.get("/formulas")
def show_formulas(request: Request) -> Response:
    """Every formula by topic, each where the steps of a sheet link to."""
    return page(request, "formulas/book.html", FormulasPage(formula_book(translator(request))))
