"""The first page: mechanisms to begin with, worked examples, and saved projects."""

from dataclasses import dataclass
from typing import Annotated
from urllib.parse import urlsplit

from fastapi import APIRouter, Form, Request, Response
from fastapi.responses import RedirectResponse

from app.services.mechanisms import MechanismKind, mechanism_kinds
from app.web.deps import Examples
from app.web.templating import page

router = APIRouter()


@dataclass(frozen=True)
class ExampleCard:
    """One worked example."""

    title: str
    source: str
    url: str


@dataclass(frozen=True)
class StartPage:
    """Context of ``start.html``."""

    mechanisms: tuple[MechanismKind, ...]
    examples: tuple[ExampleCard, ...]


@router.get("/")
def show_start(request: Request, examples: Examples) -> Response:
    """Mechanisms as cards, worked examples, and how to open a project."""
    cards = tuple(ExampleCard(one.title, one.source, f"/examples/{one.id}") for one in examples.files())
    return page(request, "start.html", StartPage(tuple(mechanism_kinds()), cards))


@router.post("/open")
def open_link(link: Annotated[str, Form(max_length=2000)] = "") -> Response:
    """Open a project by its link, or by the part of it behind ``/p/``."""
    token = urlsplit(link.strip()).path.rstrip("/").rpartition("/")[2]
    known = "".join(sign for sign in token if sign.isascii() and (sign.isalnum() or sign in "-_"))
    return RedirectResponse(f"/p/{known}" if known else "/", 303)
