"""The formula book: every formula of the library for a reader, by topic."""

from dataclasses import dataclass
from typing import Any

from markupsafe import Markup

import app.engine.formulas  # noqa: F401  (registers every formula)
from app.engine.formula import Formula, registered
from app.engine.glossary import meaning
from app.reports import formula_text, mathml, symbols
from app.reports import typst as typst_notation
from app.reports.numbers import unit_text
from app.reports.sheet_view import anchor
from app.reports.writer import Translate, never_empty

TITLES = {
    "brake": "Brake",
    "conversion": "Force, torque and speed along the transmission",
    "duty": "Duty cycle",
    "efficiency": "Efficiency",
    "gear": "Gear unit",
    "inertia": "Moments of inertia",
    "motion": "Motion",
    "optimum": "Optimum transmission",
    "resistance": "Resistance to motion",
    "screw": "Ball and lead screws",
    "servo": "Servo drive",
    "stiffness": "Stiffness and natural frequency",
}
"""Headings of the topics (modules of the library); another module is headed by its own name."""


@dataclass(frozen=True)
class ArgumentEntry:
    """One argument of a formula."""

    name: str
    symbol: Markup
    symbol_text: str
    meaning: str
    unit: str
    """SI unit in which the formula takes it, as it is spelt in code (``kg m2``)."""
    unit_text: str


@dataclass(frozen=True)
class FormulaEntry:
    """One formula."""

    name: str
    anchor: str
    topic: str
    symbol: Markup
    symbol_text: str
    unit: str
    """Unit in which the result is shown."""
    unit_text: str
    si_unit: str
    source: str
    summary: str
    lines: tuple[Markup, ...]
    """MathML: the named intermediates, then the result."""
    typst: tuple[str, ...]
    """The same lines as Typst source."""
    notes: tuple[Markup, ...]
    plain_notes: tuple[str, ...]
    arguments: tuple[ArgumentEntry, ...]
    example: str


@dataclass(frozen=True)
class Topic:
    """The formulas of one module of the library."""

    name: str
    title: str
    anchor: str
    formulas: tuple[FormulaEntry, ...]


def formula_book(translate: Translate = str) -> tuple[Topic, ...]:
    """All formulas of the library, topics by heading, formulas by name."""
    by_topic: dict[str, list[FormulaEntry]] = {}
    for formula in registered().values():
        if formula.function.__module__.startswith("app.engine."):
            by_topic.setdefault(formula.topic, []).append(entry(formula, translate))
    topics = [
        Topic(name, translate(title(name)), anchor("topic", name), tuple(found)) for name, found in by_topic.items()
    ]
    return tuple(sorted(topics, key=lambda topic: topic.title))


def find(name: str, translate: Translate = str) -> FormulaEntry:
    """The formula of that name. Raises KeyError when there is none."""
    return entry(registered()[name], translate)


def title(topic: str) -> str:
    """Heading of a topic.

    >>> title("dc_link")
    'Dc link'
    """
    return TITLES.get(topic, topic.replace("_", " ").capitalize())


def entry(formula: Formula[..., Any], translate: Translate = str) -> FormulaEntry:
    """One formula for a reader."""
    translate = never_empty(translate)
    text = formula_text.read(formula)
    return FormulaEntry(
        name=formula.name,
        anchor=anchor("formula", formula.name),
        topic=formula.topic,
        symbol=mathml.symbol(formula.symbol),
        symbol_text=symbols.read(formula.symbol).text,
        unit=formula.unit,
        unit_text=unit_text(formula.unit),
        si_unit=formula.si_unit,
        source=formula.source,
        summary=translate(text.summary),
        lines=mathml.symbolic(formula, translate=translate),
        typst=typst_notation.symbolic(formula, translate=translate),
        notes=tuple(formula_text.to_html(paragraph, formula, translate) for paragraph in text.paragraphs),
        plain_notes=tuple(formula_text.to_plain(paragraph, translate) for paragraph in text.paragraphs),
        arguments=tuple(
            ArgumentEntry(
                name, mathml.symbol(name), symbols.read(name).text, translate(meaning(name)), unit, unit_text(unit)
            )
            for name, unit in formula.parameters.items()
        ),
        example=text.example,
    )
