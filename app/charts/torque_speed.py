"""Torque over speed: what the motor can give, and every point of the cycle that asks for it."""

import numpy as np

from app.charts.figure import RPM, Figure, Translate, axis, figure, line, thinned
from app.engine.drives.base import DriveResult, Points, ShaftPoints


def torque_speed_figure(result: DriveResult, translate: Translate = str, *, four_quadrants: bool = False) -> Figure:
    """S1 and peak curve, the cycle in time order, and the point (mean speed, effective torque); rpm and N m.

    By default everything is folded into the first quadrant, where limits are read; ``four_quadrants`` keeps the signs.
    Without a motor only the demand is shown.
    """
    traces = []
    if result.limits is not None:
        traces += _limit(result.limits.peak_points(), translate("peak curve"), "series-2", "solid", four_quadrants)
        s1 = translate("S1 curve (continuous)")
        traces += _limit(result.limits.continuous_points(), s1, "series-3", "dash", four_quadrants)
    shown: set[tuple[float, float]] = set()
    for points, name, colour, dash in (
        (result.cycle, translate("cycle"), "series-1", "solid"),
        (result.opposite, translate("opposite direction"), "series-5", "dot"),
    ):
        if points is not None and points.torque is not None:
            x, y, labels = _path(points, four_quadrants)
            corners = {(round(a, 3), round(b, 3)) for a, b in zip(x, y, strict=True)}
            if corners <= shown:
                continue  # a cycle that runs both ways shows the opposite direction already
            shown |= corners
            traces.append(line(x, y, name, colour, dash=dash, width=1.5, mode="lines+markers", text=labels))
    if result.effective_torque is not None and result.mean_speed is not None:
        mean = ([result.mean_speed * RPM], [result.effective_torque])
        name = translate("mean speed, effective torque")
        traces.append(line(*mean, name, "series-4", mode="markers", symbol="diamond"))
    top = result.limits.max_speed if result.limits is not None else None
    shapes = [] if top is None else [_speed_limit(top * RPM)]
    title = translate("Torque and speed at the motor shaft")
    return figure(
        traces, title, shapes=shapes,
        xaxis=axis(translate("motor speed in rpm")), yaxis=axis(translate("motor torque in N m")),
    )  # fmt: skip


def _path(points: ShaftPoints, signed: bool) -> tuple[list[float], list[float], list[str]]:
    """Both ends of every segment in time order."""
    assert points.torque is not None
    speed = np.column_stack([points.speed_start, points.speed_end]).ravel() * RPM
    torque = np.repeat(points.torque, 2)
    if not signed:
        speed, torque = np.abs(speed), np.abs(torque)
    labels = [label for label in points.label for _ in range(2)]
    if speed.size > 2000:
        x, y = thinned(speed, torque)
        return x.tolist(), y.tolist(), []
    return speed.tolist(), torque.tolist(), labels


def _limit(points: Points, name: str, colour: str, dash: str, signed: bool) -> list[dict[str, object]]:
    if not points:
        return []
    speeds = np.array([n for n, _ in points]) * RPM
    torques = np.array([torque for _, torque in points])
    made = [line(speeds, torques, name, colour, dash=dash)]
    if signed:
        mirrored = [(speeds, -torques), (-speeds, torques), (-speeds, -torques)]
        made += [line(x, y, name, colour, dash=dash, legend=False) for x, y in mirrored]
    return made


def _speed_limit(rpm: float) -> dict[str, object]:
    """Highest speed of the motor as an upright line."""
    return {
        "type": "line", "xref": "x", "yref": "paper", "x0": float(rpm), "x1": float(rpm), "y0": 0, "y1": 1,
        "line": {"width": 1, "dash": "dot"},
    }  # fmt: skip
