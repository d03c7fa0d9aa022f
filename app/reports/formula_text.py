"""The docstring of a formula, taken apart for a reader: what it is, its assumptions and range, an example."""

import inspect
import re
from dataclasses import dataclass
from functools import cache
from typing import Any

from markupsafe import Markup

from app.engine.formula import Formula
from app.reports import mathml
from app.reports.writer import Translate

_QUOTED = re.compile(r"``([^`]+)``")


@dataclass(frozen=True)
class FormulaText:
    """What a docstring says: ``summary`` (first paragraph), further ``paragraphs``, the ``example`` that tests run."""

    summary: str
    paragraphs: tuple[str, ...]
    example: str


@cache
def read(formula: Formula[..., Any]) -> FormulaText:
    """Take the docstring of a formula apart; what it raises concerns programs and is left out."""
    blocks = re.split(r"\n\s*\n", inspect.getdoc(formula.function) or "")
    prose = [" ".join(block.split()) for block in blocks if not block.lstrip().startswith((">>>", "Raises "))]
    examples = [block.strip() for block in blocks if block.lstrip().startswith(">>>")]
    return FormulaText(prose[0] if prose else "", tuple(prose[1:]), "\n".join(examples))


def to_html(paragraph: str, formula: Formula[..., Any], translate: Translate = str) -> Markup:
    """A paragraph for a page: quoted names become symbols where they are arguments, code otherwise."""
    made = Markup("")
    for index, part in enumerate(_QUOTED.split(translate(paragraph))):
        if index % 2 == 0:
            made += part
        elif part in formula.parameters:
            made += mathml.symbol(part)
        else:
            made += Markup("<code>{}</code>").format(part)
    return made


def to_plain(paragraph: str, translate: Translate = str) -> str:
    """A paragraph as plain text, without the quotes around names.

    >>> to_plain("``m`` mass")
    'm mass'
    """
    return _QUOTED.sub(r"\1", translate(paragraph))
