"""Building blocks of a figure: traces, axes, bands; points thinned out without losing an extreme."""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Figure = dict[str, Any]
Translate = Callable[[str], str]

PALETTE = {
    "series-1": "#0b5cad",
    "series-2": "#c2410c",
    "series-3": "#1f7a4d",
    "series-4": "#7c3aed",
    "series-5": "#64748b",
}
"""Colours of the light theme, told apart by readers with any colour vision; dashes and markers differ as well."""
MAX_POINTS = 2000
"""Points of one trace; a longer one is thinned out to this."""
_DIGITS = 6
RPM = 60 / (2 * np.pi)
"""rad/s to rpm: charts show rotational speed in rpm."""


def thinned(x: ArrayLike, y: ArrayLike, most: int = MAX_POINTS) -> tuple[NDArray[Any], NDArray[Any]]:
    """At most about ``most`` points of a line: first, last, and both extremes of y in each of equal stretches."""
    xs, ys = np.asarray(x, dtype=float), np.asarray(y, dtype=float)
    if xs.size <= most:
        return xs, ys
    kept = [0, xs.size - 1]
    for stretch in np.array_split(np.arange(xs.size), most // 2):
        kept += [int(stretch[np.argmin(ys[stretch])]), int(stretch[np.argmax(ys[stretch])])]
    index = np.unique(kept)
    return xs[index], ys[index]


def plain(values: ArrayLike) -> list[float]:
    """Numbers for JSON, rounded to what a chart can show."""
    return [float(f"{value:.{_DIGITS}g}") for value in np.asarray(values, dtype=float).ravel()]


def line(x: ArrayLike, y: ArrayLike, name: str, colour: str, *, dash: str = "solid", width: float = 2.0,
         mode: str = "lines", symbol: str = "circle", axis: str = "", text: list[str] | None = None,
         legend: bool = True) -> dict[str, Any]:  # fmt: skip
    """A trace: a line, markers or both. ``axis`` is "", "2", "3" for stacked axes."""
    made: dict[str, Any] = {
        "type": "scatter",
        "mode": mode,
        "name": name,
        "x": plain(x),
        "y": plain(y),
        "line": {"color": PALETTE[colour], "dash": dash, "width": width},
        "marker": {"color": PALETTE[colour], "symbol": symbol, "size": 8},
        "meta": {"color": colour},
        "showlegend": legend,
        "hovertemplate": "%{x:.5g}<br>%{y:.5g}" + ("<br>%{text}" if text else "") + f"<extra>{name}</extra>",
    }
    if axis:
        made["yaxis"] = f"y{axis}"
    if text:
        made["text"] = text
    return made


def figure(traces: list[dict[str, Any]], title: str, **layout: Any) -> Figure:
    """A figure with the layout that all share."""
    shared = {
        "title": {"text": title},
        "margin": {"l": 64, "r": 16, "t": 16, "b": 48},
        "hovermode": "closest",
        "legend": {"orientation": "h", "y": 1.02, "yanchor": "bottom", "x": 0},
    }
    return {"data": traces, "layout": {**shared, **layout}}


def axis(title: str, **more: Any) -> dict[str, Any]:
    """An axis with a title and a visible zero line."""
    return {"title": {"text": title}, "zeroline": True, "automargin": True, **more}


def band(start: float, end: float, colour: str = "series-5") -> dict[str, Any]:
    """A shaded stretch of the x axis over the full height."""
    return {
        "type": "rect", "xref": "x", "yref": "paper", "x0": start, "x1": end, "y0": 0, "y1": 1,
        "fillcolor": PALETTE[colour], "opacity": 0.12, "line": {"width": 0}, "layer": "below",
    }  # fmt: skip
