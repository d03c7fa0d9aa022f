"""Load against run-up curve: what the motor gives over its speed, and what every state of the load asks."""

from collections.abc import Sequence
from typing import Literal

import numpy as np

from app.engine.diagram import Diagram, Series, series
from app.engine.drives.line_fed import MotorData
from app.engine.drives.mains_shaft import MotorSide


def run_up_diagram(data: MotorData, sides: Sequence[MotorSide], more: Sequence[MotorData] = ()) -> Diagram:
    """Torque over speed of each winding, of the load in each state, and single points of the data sheet."""
    shown: list[Series] = []
    for one in (data, *more):
        name = "mean run-up torque" if not more else f"mean run-up torque, {one.winding.poles} poles"
        if one.star:
            # in star every torque is the same share of that in delta, so the curve keeps its shape
            shown.append(_run_up(one, f"{name}, in star", (one.run_up or 0.0) / (one.full_run_up or 1.0)))
        shown.append(_run_up(one, name))
        points = _points(one)
        if points:
            speeds, torques = zip(*points, strict=True)
            shown.append(series("points of the data sheet", speeds, torques, "point"))
    top = max(one.synchronous_speed for one in (data, *more))
    for side in sides:
        k = side.factor(driving=not side.driven_by_load)
        if side.state.curve:
            speeds, torques = zip(*side.state.curve, strict=True)
            x, y = np.array(speeds) * side.ratio, np.array(torques) / side.ratio * k
        else:
            x, y = np.array([0.0, top]), np.full(2, side.load_torque * k)
        shown.append(series(f"load: {side.state.label}", x, y))
    return Diagram("run_up", "Motor and load over the speed", "motor speed", "rpm", "torque at the motor shaft", "N m",
                   tuple(shown))  # fmt: skip


def _run_up(data: MotorData, name: str, share: float = 1.0) -> Series:
    """The mean run-up torque up to the working branch, then down to no torque at synchronous speed.

    ``share`` of it in star; the curve in delta is then only a comparison.
    """
    run_up = data.full_run_up or data.rated_torque
    slip, top = data.synchronous_speed - data.rated_speed, share * run_up
    knee = max(data.synchronous_speed - slip * run_up / data.rated_torque, 0.0) if slip > 0 else data.rated_speed
    role: Literal["limit", "second"] = "second" if data.star and share == 1.0 else "limit"
    return series(name, [0.0, knee, data.synchronous_speed], [top, top, 0.0], role)


def _points(data: MotorData) -> list[tuple[float, float]]:
    """Starting point and rated point (speed [rad/s], torque [N m]) as far as they are known."""
    found = [(data.rated_speed, data.rated_torque)]
    if data.winding.starting_torque_ratio is not None:
        found.append((0.0, data.winding.starting_torque_ratio * data.rated_torque))
    return found
