"""The cycle over time: speed, torque and power at the motor shaft on one time axis."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from app.charts.figure import RPM, Figure, Translate, axis, band, figure, line, thinned
from app.engine.cycle import LoadCycle
from app.engine.drives.base import ShaftPoints

_DOMAINS = ([0.7, 1.0], [0.36, 0.64], [0.0, 0.3])


def cycle_figure(points: ShaftPoints, load: LoadCycle, translate: Translate = str) -> Figure:
    """Three stacked charts over time; the segment with the largest torque is shaded, so are closed brakes.

    Torque is that of the motor, beside it that of the load at the gear unit's output.
    """
    times = np.column_stack([points.time[:-1], points.time[1:]]).ravel()
    speed = np.column_stack([points.speed_start, points.speed_end]).ravel()
    traces = [_trace(times, speed * RPM, translate("motor speed"), "series-1", "")]
    if points.torque is not None:
        torque = np.repeat(points.torque, 2)
        traces.append(_trace(times, torque, translate("motor torque"), "series-2", "2"))
        traces.append(_trace(times, torque * speed, translate("motor power"), "series-3", "3"))
    load_name = translate("load torque at the output")
    traces.append(_trace(times, np.repeat(load.torque, 2), load_name, "series-5", "2", dash="dash"))
    titles = (translate("speed in rpm"), translate("torque in N m"), translate("power in W"))
    axes = {
        f"yaxis{number}": axis(title, domain=domain)
        for number, title, domain in zip(("", "2", "3"), titles, _DOMAINS, strict=True)
    }
    return figure(
        traces, translate("Speed, torque and power over one cycle"), shapes=[*_bands(points, load)],
        xaxis=axis(translate("time in s"), anchor="y3"), **axes,
    )  # fmt: skip


def _trace(
    x: NDArray[np.float64], y: NDArray[np.float64], name: str, colour: str, axis_: str, dash: str = "solid"
) -> dict[str, object]:
    return line(*thinned(x, y), name, colour, dash=dash, axis=axis_)


def _bands(points: ShaftPoints, load: LoadCycle) -> Iterator[dict[str, object]]:
    """The worst segment, and each stretch with the brake closed."""
    if points.torque is not None and np.any(points.torque):
        worst = int(np.argmax(np.abs(points.torque)))
        yield band(float(points.time[worst]), float(points.time[worst + 1]), "series-2")
    edges = np.flatnonzero(np.diff(np.concatenate(([0], load.braked.astype(int), [0]))))
    for start, stop in edges.reshape(-1, 2)[:50]:
        yield band(float(points.time[start]), float(points.time[stop]))
