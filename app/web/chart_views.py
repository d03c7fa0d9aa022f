"""Charts as a page shows them: the SVG that every reader sees, the figure for Plotly, and the points as tables."""

import json
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from markupsafe import Markup

from app.charts import Figure, axis_figures, svg
from app.services.sizing import Sizing

MAX_ROWS = 60
"""Points of a table; a longer series is thinned out evenly, first and last kept."""


@dataclass(frozen=True)
class SeriesView:
    """The points of one trace."""

    name: str
    x_title: str
    y_title: str
    points: tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class ChartView:
    """One chart."""

    key: str
    title: str
    svg: Markup
    figure: Markup
    """JSON that may stand in a script element."""
    series: tuple[SeriesView, ...]


def charts_of(
    sizing: Sizing, translate: Callable[[str], str], *, four_quadrants: bool = False
) -> tuple[ChartView, ...]:
    """Every chart of one sizing; ``four_quadrants`` keeps the signs of speed and torque."""
    figures = axis_figures(sizing.drive, sizing.load, translate, four_quadrants=four_quadrants)
    return tuple(chart_view(key, figure) for key, figure in figures)


def chart_view(key: str, figure: Figure) -> ChartView:
    """A figure made ready for a page; ``key`` is unique there."""
    return ChartView(
        key=key,
        title=figure["layout"]["title"]["text"],
        svg=Markup(svg(figure, f"chart-{key}")),
        figure=script_json(figure),
        series=tuple(_series(figure)),
    )


def script_json(value: Any) -> Markup:
    """JSON that cannot end the script element it stands in."""
    text = json.dumps(value, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    return Markup(text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026"))


def _series(figure: Figure) -> Iterator[SeriesView]:
    layout = figure["layout"]
    for trace in figure["data"]:
        axis = layout["yaxis" + trace.get("yaxis", "y")[1:]]
        pairs = list(zip(trace["x"], trace["y"], strict=True))
        step = max(1, -(-len(pairs) // MAX_ROWS))
        kept = pairs[::step] + ([pairs[-1]] if pairs and (len(pairs) - 1) % step else [])
        points = tuple((f"{x:.5g}".replace("-", "−"), f"{y:.5g}".replace("-", "−")) for x, y in kept)
        yield SeriesView(trace["name"], layout["xaxis"]["title"]["text"], axis["title"]["text"], points)
