"""A tabulated chart as a figure: every curve with its points."""

from collections.abc import Sequence

from app.charts.figure import PALETTE, Figure, Translate, axis, figure, line
from app.engine.tables import Table

Points = Sequence[tuple[float, float]]

_DASHES = ("solid", "dash", "dot")
_LEVEL_END = 0.25
"""What is drawn of a level stretch at the end, as a share of what lies before it."""


def table_figure(table: Table, x: str, family: str, value: str, translate: Translate = str) -> Figure:
    """Figure of a table; ``x``, ``family`` and ``value`` say in words what its numbers are, ``family`` may be empty.

    A long level stretch at the end is cut short: at full length it would press everything else together.
    """
    traces = []
    for number, (at, points) in enumerate(table.curves):
        shown = drawn(points)
        name = f"{translate(family)}: {at:g}" if family else translate(value) if value else translate("Value")
        traces.append(line(
            [one for one, _ in shown], [one for _, one in shown], name, list(PALETTE)[number % len(PALETTE)],
            dash=_DASHES[number // len(PALETTE) % len(_DASHES)], mode="lines+markers" if len(shown) > 1 else "markers",
            legend=len(table.curves) > 1,
        ))  # fmt: skip
    upright = axis(translate(value) if value else translate("Value"))
    return figure(traces, translate(table.title), xaxis=axis(translate(x)), yaxis=upright)


def drawn(points: Points) -> Points:
    """The points as they are drawn; the same object where nothing is cut.

    >>> drawn([(0, 3), (10, 1), (1000, 1)])
    [(0, 3), (10, 1), (12.5, 1)]
    """
    if len(points) < 3 or points[-1][1] != points[-2][1]:
        return points
    (begin, _), (end, level) = points[0], points[-2]
    cut = end + _LEVEL_END * (end - begin)
    return points if points[-1][0] <= cut else [*points[:-1], (cut, level)]
