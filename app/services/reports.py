"""The report of one axis as a PDF: from a sizing, the same numbers as the page."""

import re
from collections.abc import Callable, Iterator
from typing import Any

from app.charts import axis_figures, svg
from app.engine.quantity import Declared, Quantity, declaration, in_shown_order
from app.reports.numbers import show
from app.reports.pdf import Chart, Report, Table, report_pdf
from app.services.sizing import Sizing

Translate = Callable[[str], str]
_VARIABLE = re.compile(r"var\(--[\w-]+,\s*([^)]+)\)")
INK = "#1b2026"
ROLES = {
    "motor": "Motor", "gear_unit": "Gear unit", "servo_drive": "Servo drive", "brake": "Brake",
    "inverter": "Inverter", "braking_resistor": "Braking resistor",
}  # fmt: skip
"""Parts of a drive by role, for the reader."""


def axis_report(sizing: Sizing, drawing: str = "", translate: Translate = str, language: str = "en") -> bytes:
    """PDF of one axis; ``drawing`` is the SVG of its mechanism. The same input gives the same bytes."""
    request = sizing.typed.request
    unchecked = [check for check in sizing.sheet.checks if check.utilisation is None]
    report = Report(
        title=request.name or translate(request.mechanism.title),
        sheet=sizing.sheet,
        title_block=tuple(_title_block(sizing, translate)),
        inputs=tuple(_inputs(request, translate)),
        drawing=printable(drawing),
        charts=tuple(_charts(sizing, translate)),
        tables=tuple(_tables(sizing, translate)),
        warnings=tuple(f"{translate('Not checked')}: {translate(c.name)} ({translate(c.missing)})" for c in unchecked),
        language=language,
    )
    return report_pdf(report, translate)


def printable(markup: str) -> str:
    """An SVG without the colours of a page: custom properties by their fall-back, text by ink, ground by white.

    >>> printable('<path stroke="var(--line, #ddd)" fill="currentColor"/>')
    '<path stroke="#ddd" fill="#1b2026"/>'
    >>> printable('<rect fill="Canvas"/>')
    '<rect fill="#fff"/>'
    """
    plain = _VARIABLE.sub(lambda found: found[1].strip(), markup)
    return plain.replace("currentColor", INK).replace('"Canvas"', '"#fff"')


def _title_block(sizing: Sizing, translate: Translate) -> Iterator[tuple[str, str]]:
    request = sizing.typed.request
    yield translate("Mechanism"), translate(request.mechanism.title)
    for role, product in sizing.parts.chosen():
        yield translate(ROLES.get(role, role)), product.name
    yield translate("Program"), f"Drivewright {sizing.engine_version}"
    for key, citation in sizing.editions.items():
        yield translate("Catalogue edition"), f"{citation} ({key})"
    if request.notes:
        yield translate("Notes"), request.notes


def _inputs(model: Declared, translate: Translate) -> Iterator[tuple[str, str, str]]:
    """Every given value in the order in which inputs are shown, nested parts included."""
    for name, info in in_shown_order(type(model)):
        value, found = getattr(model, name), declaration(info)
        if isinstance(value, Declared):
            yield from _inputs(value, translate)
        elif isinstance(value, (list, tuple)):
            for item in value:
                if isinstance(item, Declared):
                    yield from _inputs(item, translate)
        elif found is not None and name in model.model_fields_set and value not in (None, ""):
            yield translate(found.about), found.symbol, _shown(found, value, translate)


def _shown(found: Any, value: Any, translate: Translate) -> str:
    if isinstance(found, Quantity):
        return show(value, found.unit)
    return translate(str(getattr(found, "labels", {}).get(value, value)))


def _charts(sizing: Sizing, translate: Translate) -> Iterator[Chart]:
    for key, figure in axis_figures(sizing.drive, sizing.load, translate):
        yield Chart(figure["layout"]["title"]["text"], printable(svg(figure, f"chart-{key}")))


def _tables(sizing: Sizing, translate: Translate) -> Iterator[Table]:
    rows = tuple(
        (translate(ROLES.get(role, role)), product.manufacturer, product.model, product.source)
        for role, product in sizing.parts.chosen()
    )
    if rows:
        heads = tuple(translate(word) for word in ("Part", "Maker", "Type", "Source"))
        yield Table(translate("Parts list"), heads, rows)
