"""Drawings of the mechanisms as markup."""

from functools import cache

from markupsafe import Markup

from app.settings import PROJECT_ROOT


@cache
def drawing_of(file: str) -> Markup:
    """A drawing as markup that stands in the page and takes its colours; empty where there is none (yet)."""
    path = PROJECT_ROOT / "static" / "drawings" / file
    return Markup(path.read_text(encoding="utf-8")) if path.is_file() else Markup("")
