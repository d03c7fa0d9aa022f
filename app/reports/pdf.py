"""A calculation as a PDF: title block, inputs, checks, charts, assumptions and the sheet with its formulas.

Typst sets the pages. The same input gives the same bytes: the document carries no date, and its fonts are those that
come with the compiler. Only a text in a script which these lack (Chinese, for instance) is set in a font of the system.
"""

import re
from dataclasses import dataclass
from functools import cache

import typst

from app.engine.sheet import Sheet
from app.reports import typst as notation
from app.reports.pdf_parts import LAYOUT, bar, chart, grid, heading, text
from app.reports.sheet_view import SheetView, StepView, sheet_view
from app.reports.typst import literal
from app.reports.writer import Translate

_FIRST_FOREIGN = 0x0530
"""First code point behind Latin, Greek and Cyrillic, which the compiler's own fonts cover."""
_INVISIBLE = re.compile(r'dot\.op|class\("unary", minus\)|attach|upright|frac|lr\b|cases|quad|[bt]: |[",() ]')
_LONG_LINE = 60
"""Characters that fit on a line of a formula for certain."""


@dataclass(frozen=True)
class Table:
    """A table of texts: ``columns`` are its headings, ``numeric`` the indices of those that are set to the right."""

    title: str
    columns: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    numeric: frozenset[int] = frozenset()


@dataclass(frozen=True)
class Chart:
    """A chart as SVG source, with its caption."""

    caption: str
    svg: str


@dataclass(frozen=True)
class Report:
    """What a report shows. Texts are plain and in the reader's language; only ``sheet`` is translated on the way."""

    title: str
    sheet: Sheet
    title_block: tuple[tuple[str, str], ...] = ()
    """Pairs such as ("Axis", "X"), ("Mechanism", "..."), ("Engine version", "0.1.0"), ("Catalogue edition", "...")."""
    inputs: tuple[tuple[str, str, str], ...] = ()
    """(meaning, symbol as spelt in code, value with unit) per input."""
    drawing: str = ""
    """SVG source of the sketch, or nothing."""
    charts: tuple[Chart, ...] = ()
    tables: tuple[Table, ...] = ()
    """Further tables: parts list, alternatives, rejected candidates."""
    warnings: tuple[str, ...] = ()
    language: str = "en"


def report_pdf(report: Report, translate: Translate = str) -> bytes:
    """The report as the bytes of a PDF of A4 pages.

    Raises typst.TypstError when a chart or drawing is no SVG.
    """
    source = report_source(report, translate)
    made = typst.compile(source.encode(), font_paths=_fonts(any(ord(c) >= _FIRST_FOREIGN for c in source)))
    assert isinstance(made, bytes)
    return made


def report_source(report: Report, translate: Translate = str) -> str:
    """The report as Typst source."""
    view = sheet_view(report.sheet, translate, lines_of=notation.with_numbers, notes=False)
    parts: list[str] = [
        f"#set document(title: {literal(report.title)}, date: none)",
        f"#set text(lang: {literal(report.language[:2])})",
        f"#let running-title = {literal(report.title)}",
        f"#let page-word = {literal(translate('Page'))}",
        LAYOUT,
        f"#block(below: 1.2em)[#text(size: 17pt, weight: 600, {literal(report.title)})]",
        *_title_block(report, view, translate),
        *_inputs(report, translate),
        *_checks(view, translate),
        *_charts(report),
        *(part for table in report.tables for part in _table(table)),
        *_assumptions(view, translate),
        *_calculation(view, translate),
    ]
    return "\n".join(parts) + "\n"


@cache
def _fonts(with_system: bool) -> typst.Fonts:
    return typst.Fonts(include_system_fonts=with_system)


def _title_block(report: Report, view: SheetView, translate: Translate) -> list[str]:
    verdict = [(translate("Verdict"), f"{view.verdict_word} ({_counts(view, translate)})")] if view.checks else []
    rows = [[text(name), text(value)] for name, value in (*report.title_block, *verdict)]
    made = [grid([], rows, widths="(auto, 1fr)")] if rows else []
    made += [f"#block(inset: (left: 8pt), stroke: (left: 2pt + tight))[{text(warning)}]" for warning in report.warnings]
    return made + ([f"#align(center, {chart(report.drawing, '70mm')})"] if report.drawing else [])


def _counts(view: SheetView, translate: Translate) -> str:
    words = {check.verdict: check.verdict_word for check in view.checks}
    return ", ".join(f"{count} {words[verdict]}" for verdict, count in view.counts.items() if count)


def _inputs(report: Report, translate: Translate) -> list[str]:
    if not report.inputs:
        return []
    rows = [[text(about), _symbol(symbol), text(value)] for about, symbol, value in report.inputs]
    columns = [translate("Input"), translate("Symbol"), translate("Value")]
    return [heading(translate("Inputs")), grid(columns, rows, widths="(1fr, auto, auto)", numeric={2})]


def _symbol(name: str) -> str:
    return f"${notation.symbol(name)}$" if name else text("")


def _checks(view: SheetView, translate: Translate) -> list[str]:
    columns = ["Check", "Demanded", "Permitted", "Utilisation", "", "Verdict"]
    rows = [
        [
            text(check.name) + (f"#linebreak()#note({literal(check.source)})" if check.source else ""),
            text(check.demanded), text(check.permitted), text(check.utilisation),
            bar(check.bar, check.limit, check.verdict),
            f"#text(fill: {check.verdict.replace('_', '-')}, {literal(f'{check.icon} {check.verdict_word}')})",
        ]
        for check in view.checks
    ]  # fmt: skip
    if not rows:
        return []
    table = grid([translate(c) if c else "" for c in columns], rows, widths="(1fr, auto, auto, auto, 22mm, auto)",
                 numeric={1, 2, 3})  # fmt: skip
    missing = [f"{check.name}: {check.missing}" for check in view.checks if check.missing]
    notes = [heading(translate("Not checked"), 2), *(f"- {text(line)}" for line in missing)] if missing else []
    return [heading(translate("Checks")), table, *notes]


def _charts(report: Report) -> list[str]:
    return [f"#figure({chart(item.svg, '100%')}, caption: [{text(item.caption)}])" for item in report.charts]


def _table(table: Table) -> list[str]:
    rows = [[text(cell) for cell in row] for row in table.rows]
    return [heading(table.title), grid(list(table.columns), rows, numeric=table.numeric)] if rows else []


def _assumptions(view: SheetView, translate: Translate) -> list[str]:
    if not view.assumptions:
        return []
    rows = [
        [
            text(item.text if item.count == 1 else f"{item.text} (× {item.count})"),
            _symbol(item.symbol_name),
            text(item.value),
            text(item.source),
        ]
        for item in view.assumptions
    ]
    columns = [translate(name) for name in ("Assumed", "Symbol", "Value", "Source")]
    return [heading(translate("Assumptions")), grid(columns, rows, widths="(1fr, auto, auto, 1fr)", numeric={2})]


def _calculation(view: SheetView, translate: Translate) -> list[str]:
    parts = [heading(translate("Calculation"))] if view.sections else []
    for section in view.sections:
        if section.title:
            parts.append(heading(section.title, 2))
        for item in section.items:
            if isinstance(item, StepView):
                parts.append(_step(item))
            else:
                parts.append(f"#decision({literal(item.text)}, {literal(item.reason)})")
    return parts


def _step(item: StepView) -> str:
    lines = "".join(f"fitted[$ {line} $], " if _may_be_long(line) else f"$ {line} $, " for line in item.lines)
    return f"#step({literal(item.label)}, {literal(item.source)}, ({lines}))"


def _may_be_long(line: str) -> bool:
    """Whether a line may be wider than the page; measuring every one would double the time of a report."""
    return len(_INVISIBLE.sub("", line)) > _LONG_LINE
