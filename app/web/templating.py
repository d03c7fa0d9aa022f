"""Rendering of the pages: one Jinja environment, texts in the reader's language, contexts as dataclasses."""

import dataclasses
import gettext
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple, Protocol

from fastapi import Request
from fastapi.responses import HTMLResponse
from jinja2 import Environment, FileSystemLoader, StrictUndefined
from markupsafe import Markup, escape

from app.engine.sheet import TIGHT
from app.reports import mathml
from app.reports.numbers import unit_text
from app.reports.sheet_view import BAR_END
from app.services.version import ENGINE_VERSION
from app.settings import PROJECT_ROOT
from app.web.errors import Problem

Translate = Callable[[str], str]


class Translations(Protocol):
    """Texts of one language: what :mod:`gettext` calls translations."""

    def gettext(self, message: str) -> str:
        """The text in this language; the English source where there is no translation."""

    def ngettext(self, msgid1: str, msgid2: str, n: int) -> str:
        """The text for a number of things."""


class Caption(NamedTuple):
    """What an input is, taken apart for a form."""

    label: str
    hint: str


def caption(text: str) -> Caption:
    """Divide the meaning of an input at the first colon or semicolon: a short label, and what explains it.

    >>> caption("lead: travel per revolution")
    Caption(label='Lead', hint='travel per revolution')
    """
    places = [place for place in (text.find(": "), text.find("; ")) if place > 0]
    cut = min(places, default=len(text))
    return Caption(capital(text[:cut]), text[cut + 1 :].strip())


def capital(text: str) -> str:
    """The text with a capital at its beginning.

    >>> capital("own data sheet")
    'Own data sheet'
    """
    return text[:1].upper() + text[1:]


def make_environment() -> Environment:
    """The environment of all templates: everything escaped, an unknown name is an error, gettext built in."""
    environment = Environment(
        loader=FileSystemLoader(PROJECT_ROOT / "templates"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        extensions=["jinja2.ext.i18n", "jinja2.ext.do"],
    )
    environment.globals.update(engine_version=ENGINE_VERSION, bar_tight=round(100 * TIGHT / BAR_END, 1))
    environment.filters.update(caption=caption, capital=capital, symbol=mathml.symbol, unit=unit_text)
    return environment


def texts(translations: Translations) -> dict[str, Callable[..., str]]:
    """Names that a template calls for its texts; ``_("{n} of %(all)s", all=3)`` escapes what is put in."""

    def gettext(message: str, **values: Any) -> str:
        return _filled(translations.gettext(message) if message else "", values)

    def ngettext(one: str, many: str, n: int, **values: Any) -> str:
        return _filled(translations.ngettext(one, many, n), {"num": n, **values})

    return {"gettext": gettext, "ngettext": ngettext, "_": gettext}


def _filled(text: str, values: Mapping[str, Any]) -> str:
    return Markup(escape(text)) % values if values else text


class Templates:
    """Renders a template with a context dataclass. One per application, at ``request.app.state.templates``."""

    def __init__(
        self, language_of: Callable[[Request], tuple[str, Translations]], languages: Mapping[str, str]
    ) -> None:
        self._environment = make_environment()
        self._language_of = language_of
        self._languages = languages

    def translations(self, request: Request) -> Translations:
        """The texts of the language that this reader wants."""
        return self._language_of(request)[1]

    def render(self, request: Request, template: str, context: object) -> str:
        """HTML of a template; the fields of ``context`` are its variables."""
        language, translations = self._language_of(request)
        values = {field.name: getattr(context, field.name) for field in dataclasses.fields(context)}  # type: ignore[arg-type]
        return self._environment.get_template(template).render(
            **values, **texts(translations), request=request, language=language, languages=self._languages,
        )  # fmt: skip

    def page(self, request: Request, template: str, context: object, status_code: int = 200) -> HTMLResponse:
        """The answer to a request: a whole page or a fragment of one."""
        return HTMLResponse(
            self.render(request, template, context), status_code, headers={"Vary": "Cookie, Accept-Language"}
        )


def english(request: Request) -> tuple[str, Translations]:
    """The language of the source texts, for everybody."""
    return "en", gettext.NullTranslations()


def templates_of(request: Request) -> Templates:
    """The templates of the running application."""
    found: Templates = request.app.state.templates
    return found


def page(request: Request, template: str, context: object, status_code: int = 200) -> HTMLResponse:
    """Render a page of the running application."""
    return templates_of(request).page(request, template, context, status_code)


def translator(request: Request) -> Translate:
    """Turns the English texts of engine and services into the reader's language."""
    return templates_of(request).translations(request).gettext


@dataclasses.dataclass(frozen=True)
class ErrorPage:
    """Context of ``error.html``."""

    problem: Problem


def problem_page(request: Request, problem: Problem) -> HTMLResponse:
    """A problem as a page; installed as ``app.state.problem_page``."""
    return page(request, "error.html", ErrorPage(problem), problem.status)
