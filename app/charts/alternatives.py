"""Candidates at a glance: mass against utilisation."""

from collections.abc import Sequence

from app.charts.figure import Figure, Translate, axis, figure, line


def alternatives_figure(points: Sequence[tuple[float, float, str, bool]], translate: Translate = str) -> Figure:
    """A scatter chart; each point is (mass [kg], largest utilisation, name, whether it drives directly)."""
    traces = []
    for direct, name, colour, symbol in (
        (False, translate("with gear unit"), "series-1", "circle"),
        (True, translate("direct drive"), "series-2", "diamond"),
    ):
        chosen = [point for point in points if point[3] is direct]
        if chosen:
            mass, used, names, _ = zip(*chosen, strict=True)
            shares = [100 * share for share in used]
            traces.append(line(mass, shares, name, colour, mode="markers", symbol=symbol, text=list(names)))
    return figure(
        traces, translate("Mass and utilisation of the listed candidates"),
        xaxis=axis(translate("mass in kg")), yaxis=axis(translate("largest utilisation in %")),
    )  # fmt: skip
