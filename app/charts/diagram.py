"""Any diagram of the engine as a figure: series over a common axis, in the units it is shown in."""

import numpy as np

from app.charts.figure import Figure, Translate, axis, figure, line, thinned
from app.engine.diagram import Diagram, Series
from app.engine.quantity import si_factor

_LOOKS = {
    "demand": ("series-1", "solid", "lines"),
    "limit": ("series-2", "dash", "lines"),
    "second": ("series-3", "dot", "lines"),
    "point": ("series-4", "solid", "markers"),
    "sum": ("series-4", "solid", "lines"),
}
"""Colour, dash and mode by role; further series of a role take the next colour."""
_COLOURS = ("series-1", "series-3", "series-5", "series-2", "series-4")


def diagram_figure(diagram: Diagram, translate: Translate = str) -> Figure:
    """Figure of one diagram."""
    used: list[str] = []
    traces = [_trace(one, diagram, used, translate) for one in diagram.series]
    x_unit, y_unit = _unit_words(diagram.x_unit), _unit_words(diagram.y_unit)
    return figure(
        traces, translate(diagram.title),
        xaxis=axis(translate(diagram.x_label) + x_unit), yaxis=axis(translate(diagram.y_label) + y_unit),
    )  # fmt: skip


def _trace(one: Series, diagram: Diagram, used: list[str], translate: Translate) -> dict[str, object]:
    colour, dash, mode = _LOOKS[one.role]
    if colour in used:
        colour = next((other for other in _COLOURS if other not in used), colour)
    used.append(colour)
    x, y = _shown(one.x, diagram.x_unit), _shown(one.y, diagram.y_unit)
    if mode == "lines":
        x, y = thinned(x, y)
    width = 3.0 if one.role == "sum" else 2.0
    return line(x, y, translate(one.name), colour, dash=dash, mode=mode, symbol="diamond", width=width)


def _shown(values: np.typing.NDArray[np.float64], unit: str) -> np.typing.NDArray[np.float64]:
    scale, offset = si_factor(unit)
    return (values - offset) / scale


def _unit_words(unit: str) -> str:
    return "" if unit == "1" else f" in {unit}"
