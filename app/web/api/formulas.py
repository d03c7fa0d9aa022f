"""The formula library: what is computed, from which source, and how it is written."""

from typing import Annotated

from fastapi import APIRouter, Path, Query

from app.reports import book
from app.services.errors import NotFoundError
from app.web.api.library_models import FormulaAnswer, FormulaArgument, FormulaSummary
from app.web.api.models import Page
from app.web.deps import Limit, Offset
from app.web.errors import problems

router = APIRouter(prefix="/formulas", tags=["formulas"])

Name = Annotated[str, Path(max_length=100, description="Name of a formula")]


@router.get("", operation_id="listFormulas", responses=problems(422), summary="List the formulas")
def list_formulas(
    topic: Annotated[str, Query(max_length=60, description="Only this topic; empty: all")] = "",
    limit: Limit = 50,
    offset: Offset = 0,
) -> Page[FormulaSummary]:
    """Every formula of the library, by topic."""
    found = [entry for one in book.formula_book() if topic in ("", one.name) for entry in one.formulas]
    items = [FormulaSummary(**_summary(entry)) for entry in found[offset : offset + limit]]
    return Page(items=items, total=len(found), limit=limit, offset=offset)


@router.get("/{name}", operation_id="getFormula", responses=problems(404, 422), summary="Show a formula")
def get_formula(name: Name) -> FormulaAnswer:
    """One formula with its arguments, as MathML and as Typst."""
    try:
        found = book.find(name)
    except KeyError as error:
        raise NotFoundError(f"The library has no formula {name!r}.") from error
    arguments = [
        FormulaArgument(name=a.name, symbol=a.symbol_text, meaning=a.meaning, unit=a.unit) for a in found.arguments
    ]
    return FormulaAnswer(
        **_summary(found), si_unit=found.si_unit, arguments=arguments, mathml=[str(line) for line in found.lines],
        typst=list(found.typst), notes=list(found.plain_notes), example=found.example,
    )  # fmt: skip


def _summary(entry: book.FormulaEntry) -> dict[str, str]:
    return {
        "name": entry.name, "topic": entry.topic, "symbol": entry.symbol_text, "unit": entry.unit,
        "summary": entry.summary, "source": entry.source,
    }  # fmt: skip
