"""A figure as SVG: what a reader sees without scripts, in print and in the PDF.

Draws what our figures use: lines and markers on one or several stacked y axes over one x axis, bands and upright lines.
Colours are CSS custom properties of the page with the light colours as fall-back.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from html import escape
from typing import Any

from app.charts.figure import PALETTE, Figure

WIDTH, LEFT, RIGHT, BOTTOM = 760.0, 70.0, 14.0, 46.0
_LEGEND_LINE = 20.0
_PANEL_HEIGHT = {1: 320.0, 2: 190.0, 3: 140.0}
_PANEL_GAP = 22.0
_DASHES = {"dash": "8 5", "dot": "2 4", "dashdot": "8 4 2 4"}
_LETTER = 7.0
"""Width of a letter of the legend, about."""


@dataclass(frozen=True)
class Scale:
    """Maps values to the page between two ends, with round tick values."""

    low: float
    high: float
    start: float
    end: float
    ticks: tuple[float, ...]

    def __call__(self, value: float) -> float:
        """Place of a value."""
        return self.start + (value - self.low) / (self.high - self.low) * (self.end - self.start)

    @classmethod
    def over(cls, values: list[float], start: float, end: float, wanted: int = 6) -> "Scale":
        """A scale that holds zero and all values and ends on round ticks."""
        low, high = min([0.0, *values]), max([0.0, *values])
        if high == low:
            high = low + 1.0
        step = round_step((high - low) / wanted)
        first, last = math.floor(low / step + 1e-9), math.ceil(high / step - 1e-9)
        ticks = tuple(step * index for index in range(first, last + 1))
        return cls(ticks[0], ticks[-1], start, end, ticks)


def round_step(rough: float) -> float:
    """Smallest of 1, 2, 2.5, 5 times a power of ten that is not below ``rough``.

    >>> [round_step(x) for x in (0.7, 1.1, 2.2, 3.0, 6.0)]
    [1.0, 2.0, 2.5, 5.0, 10.0]
    """
    power = 10.0 ** math.floor(math.log10(rough))
    return next(factor * power for factor in (1.0, 2.0, 2.5, 5.0, 10.0) if factor * power >= rough * (1 - 1e-9))


def svg(figure: Figure, identifier: str) -> str:
    """SVG of a figure; ``identifier`` is unique on its page and begins the ids of title and description."""
    layout, traces = figure["layout"], figure["data"]
    axes = [name for name in ("", "2", "3") if f"yaxis{name}" in layout]
    legend = list(_legend(traces))
    top = 8.0 + _LEGEND_LINE * (1 + max((row for row, _, _ in legend), default=0))
    height = _PANEL_HEIGHT[len(axes)]
    bottom = top + len(axes) * height + (len(axes) - 1) * _PANEL_GAP
    spread = [x for trace in traces for x in trace["x"]] + [shape["x1"] for shape in layout.get("shapes", ())]
    across = Scale.over(spread, LEFT, WIDTH - RIGHT, 8)
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" class="chart" viewBox="0 0 {WIDTH:g} {bottom + BOTTOM:g}" role="img" '
        f'aria-labelledby="{escape(identifier)}-title">',
        f'<title id="{escape(identifier)}-title">{escape(layout["title"]["text"])}</title>',
        *(_legend_entry(trace, 8.0 + row * _LEGEND_LINE, x) for row, x, trace in legend),
    ]
    for index, name in enumerate(axes):
        y0 = top + index * (height + _PANEL_GAP)
        own = [trace for trace in traces if trace.get("yaxis", "y") == f"y{name}"]
        values = [y for trace in own for y in trace["y"]]
        upright = Scale.over(values, y0 + height, y0, 6 if len(axes) == 1 else 4)
        last = index == len(axes) - 1
        parts += _panel(layout, across, upright, layout[f"yaxis{name}"]["title"]["text"], last)
        parts += [_curve(trace, across, upright) for trace in own]
    parts.append(_text(LEFT + (WIDTH - LEFT - RIGHT) / 2, bottom + 38, layout["xaxis"]["title"]["text"], "middle"))
    return "".join([*parts, "</svg>"])


def _panel(layout: Any, across: Scale, upright: Scale, title: str, last: bool) -> Iterator[str]:
    """Grid, ticks, bands and title of one chart."""
    low, high = upright.start, upright.end
    for shape in layout.get("shapes", ()):
        x0, x1 = across(shape["x0"]), across(shape["x1"])
        if shape["type"] == "rect":
            yield f'<rect x="{x0:.1f}" y="{high:.1f}" width="{max(x1 - x0, 1):.1f}" height="{low - high:.1f}" '
            yield f'fill="{_colour_of_fill(shape["fillcolor"])}" opacity="0.12"/>'
        else:
            yield f'<path d="M{x0:.1f} {low:.1f}V{high:.1f}" class="chart-limit" stroke="currentColor" '
            yield 'stroke-dasharray="2 4"/>'
    grid = '<path d="{path}" stroke="var(--line, #d4d8dd)" fill="none"{more}/>'
    for value in upright.ticks:
        y = upright(value)
        more = ' stroke-width="1.5" style="stroke: var(--line-strong, #8a929c)"' if value == 0 else ""
        yield grid.format(path=f"M{across.start:.1f} {y:.1f}H{across.end:.1f}", more=more)
        yield _text(across.start - 8, y + 4, _tick(value), "end")
    for value in across.ticks:
        x = across(value)
        yield grid.format(path=f"M{x:.1f} {low:.1f}V{high:.1f}", more="")
        if last:
            yield _text(x, low + 18, _tick(value), "middle")
    middle = (low + high) / 2
    turned = f"translate(14 {middle:.1f}) rotate(-90)"
    yield f'<text transform="{turned}" text-anchor="middle" {_FONT}>{escape(title)}</text>'


_FONT = 'font-size="13" fill="currentColor"'


def _text(x: float, y: float, text: str, anchor: str) -> str:
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" {_FONT}>{escape(text)}</text>'


def _tick(value: float) -> str:
    return f"{round(value, 9):g}".replace("-", "−")


def _colour(trace: Any) -> str:
    name = trace["meta"]["color"]
    return f"var(--{name}, {PALETTE[name]})"


def _colour_of_fill(colour: str) -> str:
    name = next((name for name, value in PALETTE.items() if value == colour), "series-5")
    return f"var(--{name}, {PALETTE[name]})"


def _curve(trace: Any, across: Scale, upright: Scale) -> str:
    """Line and markers of one trace."""
    places = [(across(x), upright(y)) for x, y in zip(trace["x"], trace["y"], strict=True)]
    made, colour = "", _colour(trace)
    if "lines" in trace["mode"] and places:
        path = "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in places)
        made += f'<path d="{path}" fill="none" stroke="{colour}" {_stroke(trace)}/>'
    if "markers" in trace["mode"] and len(places) <= 200:
        made += "".join(_marker(trace, x, y) for x, y in dict.fromkeys(places))
    return made


def _stroke(trace: Any) -> str:
    dash = _DASHES.get(trace["line"]["dash"])
    return f'stroke-width="{trace["line"]["width"]:g}"' + (f' stroke-dasharray="{dash}"' if dash else "")


def _marker(trace: Any, x: float, y: float) -> str:
    if trace["marker"]["symbol"] == "diamond":
        return f'<path d="M{x:.1f} {y - 7:.1f}l7 7-7 7-7-7z" fill="{_colour(trace)}"/>'
    return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{_colour(trace)}"/>'


def _legend(traces: list[Any]) -> Iterator[tuple[int, float, Any]]:
    """Row and x of each entry."""
    row, x = 0, LEFT
    for trace in traces:
        if not trace["showlegend"]:
            continue
        width = 44 + _LETTER * len(trace["name"])
        if x + width > WIDTH and x > LEFT:
            row, x = row + 1, LEFT
        yield row, x, trace
        x += width


def _legend_entry(trace: Any, y: float, x: float) -> str:
    sample = ""
    if "lines" in trace["mode"]:
        sample = f'<path d="M{x:.1f} {y + 5:.1f}h26" fill="none" stroke="{_colour(trace)}" {_stroke(trace)}/>'
    if "markers" in trace["mode"]:
        sample += _marker(trace, x + 13, y + 5)
    return sample + _text(x + 32, y + 9, trace["name"], "start")
