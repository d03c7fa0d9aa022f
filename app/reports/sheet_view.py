"""A calculation sheet made ready for reading: every text, number and formula that a page or a PDF shows, in order.

The pages hand :class:`SheetView` to ``templates/partials/sheet/sheet.html``; templates compute nothing.
"""

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace
from typing import Any

from markupsafe import Markup

from app.engine.glossary import meaning
from app.engine.sheet import Assumption, Check, Decision, Sheet, Step, Verdict
from app.reports import expression, formula_text, mathml, symbols
from app.reports.numbers import ABSENT, join_unit, number, percent, show
from app.reports.writer import Translate, never_empty

VERDICT_WORDS = {
    Verdict.OK: "holds",
    Verdict.TIGHT: "tight",
    Verdict.FAILS: "fails",
    Verdict.NOT_CHECKED: "not checked",
}
VERDICT_ICONS = {Verdict.OK: "✓", Verdict.TIGHT: "!", Verdict.FAILS: "✗", Verdict.NOT_CHECKED: "?"}
Lines = Callable[..., tuple[str, ...]]
"""Writes an evaluated formula: ``mathml.with_numbers``, ``typst.with_numbers``."""
TABLE_KEY = "table."
"""How the key of an assumption begins that was read from a standard table."""
BAR_END = 1.25
"""Utilisation at the right end of a bar, so that an exceeded limit is seen to be exceeded."""


@dataclass(frozen=True)
class InputView:
    """One number that was put into a formula."""

    symbol: Markup
    symbol_text: str
    meaning: str
    value: str


@dataclass(frozen=True)
class StepView:
    """One evaluated formula."""

    key: str
    anchor: str
    label: str
    symbol: Markup
    symbol_text: str
    value: str
    lines: tuple[str, ...]
    """Each equation in symbols and with numbers, in the notation of the view."""
    inputs: tuple[InputView, ...]
    formula: str
    formula_anchor: str
    source: str
    summary: str
    """What the formula computes; empty where the label says that already."""
    notes: tuple[Markup, ...]
    """Assumptions and range of the formula."""
    is_step: bool = True


@dataclass(frozen=True)
class DecisionView:
    """A branch that was taken, and why."""

    text: str
    reason: str
    is_step: bool = False


@dataclass
class SectionView:
    """What stands under one heading, in the order in which it was computed; ``title`` may be empty."""

    title: str
    anchor: str
    items: list[StepView | DecisionView] = field(default_factory=list)


@dataclass(frozen=True)
class AssumptionView:
    """A value that the user did not give."""

    key: str
    anchor: str
    text: str
    symbol: Markup
    symbol_text: str
    symbol_name: str
    """The symbol as it is spelt in code, for a notation other than MathML."""
    value: str
    source: str
    count: int = 1
    """How often the same was assumed, for one move after the other for instance."""
    table: str = ""
    """Key of the standard table that the value was read from; empty where it comes from elsewhere."""


@dataclass(frozen=True)
class CheckView:
    """A demand against its limit, with what a utilisation bar needs."""

    key: str
    anchor: str
    name: str
    section: str
    demanded: str
    permitted: str
    utilisation: str
    bar: float
    """Length of the bar in percent of its track, 0 to 100."""
    limit: float
    """Where on the track the limit stands, in percent."""
    verdict: str
    """``ok``, ``tight``, ``fails`` or ``not_checked``: for classes, never for reading."""
    verdict_word: str
    icon: str
    source: str
    step_anchor: str
    """Anchor of the step behind the demanded value, empty where there is none."""
    missing: str


@dataclass(frozen=True)
class SheetView:
    """A sheet for a reader."""

    sections: tuple[SectionView, ...]
    assumptions: tuple[AssumptionView, ...]
    checks: tuple[CheckView, ...]
    verdict: str
    verdict_word: str
    counts: dict[str, int]
    """Number of checks by verdict."""


def sheet_view(
    sheet: Sheet, translate: Translate = str, *, lines_of: Lines = mathml.with_numbers, notes: bool = True
) -> SheetView:
    """Make a sheet ready for reading; ``translate`` turns the engine's English texts into the reader's language.

    ``lines_of`` writes an evaluated formula, as MathML unless said otherwise. Without ``notes`` the details of each
    step (inputs, assumptions and range of its formula) are left out.
    """
    translate = never_empty(translate)
    verdict = overall(check.verdict for check in sheet.checks)
    return SheetView(
        sections=_sections(sheet, lambda step: _step(step, translate, lines_of, notes), translate),
        assumptions=_assumptions(sheet.assumptions, translate),
        checks=tuple(check_view(item, sheet, translate) for item in sheet.checks),
        verdict=str(verdict),
        verdict_word=translate(VERDICT_WORDS[verdict]),
        counts={str(kind): sum(check.verdict == kind for check in sheet.checks) for kind in Verdict},
    )


def overall(verdicts: Iterable[Verdict]) -> Verdict:
    """The worst of the checks that could be made; ``not_checked`` where none could.

    >>> str(overall([Verdict.OK, Verdict.NOT_CHECKED, Verdict.TIGHT]))
    'tight'
    """
    rank = [Verdict.NOT_CHECKED, Verdict.OK, Verdict.TIGHT, Verdict.FAILS]
    return max(verdicts, key=rank.index, default=Verdict.NOT_CHECKED)


def anchor(prefix: str, key: str) -> str:
    """An identifier for an element of a page: what an URL fragment cannot carry becomes a hyphen.

    >>> anchor("step", "torque_of_force#2")
    'step-torque_of_force-2'
    """
    return f"{prefix}-{re.sub(r'[^A-Za-z0-9_.-]+', '-', key).strip('-')}"


def _sections(sheet: Sheet, show_step: Callable[[Step], StepView], translate: Translate) -> tuple[SectionView, ...]:
    entries: list[tuple[int, int, Step | Decision]] = [(n, 1, step) for n, step in enumerate(sheet.steps)]
    entries += [(decision.position, 0, decision) for decision in sheet.decisions]
    made: dict[str, SectionView] = {}
    for _, _, entry in sorted(entries, key=lambda entry: entry[:2]):
        title = entry.section
        if title not in made:
            made[title] = SectionView(translate(title), f"section-{len(made) + 1}")
        if isinstance(entry, Step):
            made[title].items.append(show_step(entry))
        else:
            made[title].items.append(DecisionView(translate(entry.text), translate(entry.reason)))
    return tuple(made.values())


def _step(step: Step, translate: Translate, lines_of: Lines, notes: bool) -> StepView:
    text = formula_text.read(step.formula)
    name, summary = step.symbol, translate(text.summary)
    label = _first_clause(summary) if step.label == text.summary else translate(step.label).removesuffix(".")
    return StepView(
        key=step.key,
        anchor=anchor("step", step.key),
        label=label,
        symbol=mathml.symbol(name),
        symbol_text=symbols.read(name).text,
        value=show(step.value, step.unit),
        lines=lines_of(step.formula, step.inputs, step.value, name=name, unit=step.unit, translate=translate),
        inputs=tuple(_inputs(step, translate)) if notes else (),
        formula=step.formula.name,
        formula_anchor=anchor("formula", step.formula.name),
        source=step.formula.source,
        summary="" if summary == f"{label}." else summary,
        notes=tuple(formula_text.to_html(p, step.formula, translate) for p in text.paragraphs) if notes else (),
    )


def _first_clause(summary: str) -> str:
    """What heads a step that has no label of its own: the summary of its formula up to the first semicolon."""
    return re.split("[;；]", summary)[0].strip().removesuffix(".").removesuffix("。")


def _inputs(step: Step, translate: Translate) -> Iterable[InputView]:
    for name, value in expression.all_inputs(step.formula, step.inputs).items():
        shown = show(value, step.formula.parameters[name])
        yield InputView(mathml.symbol(name), symbols.read(name).text, translate(meaning(name)), shown)


def _assumptions(items: Iterable[Assumption], translate: Translate) -> tuple[AssumptionView, ...]:
    """What reads the same is one line."""
    shown = [_assumption(item, translate) for item in items]
    same = [(view.text, view.symbol_name, view.value, view.source) for view in shown]
    return tuple(replace(view, count=same.count(key)) for n, (view, key) in enumerate(zip(shown, same, strict=True))
                 if key not in same[:n])  # fmt: skip


def _assumption(item: Assumption, translate: Translate) -> AssumptionView:
    return AssumptionView(
        key=item.key,
        anchor=anchor("assumption", item.key),
        text=translate(item.text),
        symbol=mathml.symbol(item.symbol),
        symbol_text=symbols.read(item.symbol).text if item.symbol else "",
        symbol_name=item.symbol,
        value=_any_value(item.value, item.unit, translate),
        source=translate(item.source),
        table=_table(item.key),
    )


def _table(key: str) -> str:
    """The table behind an assumption, whose key names a further reading of it by a number (``table.f_h#2``)."""
    return key.removeprefix(TABLE_KEY).partition("#")[0] if key.startswith(TABLE_KEY) else ""


def _any_value(value: Any, unit: str, translate: Translate) -> str:
    """A quantity, a flag, a count or a chosen word."""
    match value:
        case None:
            return ""
        case bool():
            return translate("yes") if value else translate("no")
        case int():
            return join_unit(number(value), unit) if unit == "1" else show(value, unit)
        case float():
            return show(value, unit)
        case str():
            return translate(value.replace("_", " ")) if value else ABSENT
        case list() | tuple():
            return "; ".join(_any_value(item, unit, translate) for item in value)
    return str(value)


def check_view(check: Check, sheet: Sheet, translate: Translate = str) -> CheckView:
    """One check made ready for reading; its step is looked up on ``sheet``."""
    used = check.utilisation
    behind = next((step for step in reversed(sheet.steps) if check.formula and _belongs(step, check.formula)), None)
    return CheckView(
        key=check.key,
        anchor=anchor("check", check.key),
        name=translate(check.name),
        section=translate(check.section),
        demanded=show(check.demanded, check.unit),
        permitted=show(check.permitted, check.unit),
        utilisation=percent(used),
        bar=round(100 * min(used or 0.0, BAR_END) / BAR_END, 1),
        limit=round(100 / BAR_END, 1),
        verdict=str(check.verdict),
        verdict_word=translate(VERDICT_WORDS[check.verdict]),
        icon=VERDICT_ICONS[check.verdict],
        source=translate(check.source),
        step_anchor=anchor("step", behind.key) if behind else "",
        missing=translate(check.missing),
    )


def _belongs(step: Step, formula: str) -> bool:
    return formula in (step.key, step.formula.name)
