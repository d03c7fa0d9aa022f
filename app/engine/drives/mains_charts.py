"""Load against run-up curve: what the motor gives over its speed, and what every state of the load asks."""

from collections.abc import Sequence

import numpy as np

from app.engine.diagram import Diagram, Series, series
from app.engine.drives.line_fed import MotorData
from app.engine.drives.mains_shaft import MotorSide


def run_up_diagram(data: MotorData, sides: Sequence[MotorSide], more: Sequence[MotorData] = ()) -> Diagram:
    """Torque over speed of each winding, of the load in each state, and single points of the data sheet."""
    shown: list[Series] = []
    for one in (data, *more):
        name = "mean run-up torque" if not more else f"mean run-up torque, {one.winding.poles} poles"
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


def _run_up(data: MotorData, name: str) -> Series:
    """The mean run-up torque up to the working branch, then down to no torque at synchronous speed."""
    run_up = data.run_up or data.rated_torque
    slope = data.rated_torque / (data.synchronous_speed - data.rated_speed)
    knee = max(data.synchronous_speed - run_up / slope, 0.0) if slope > 0 else data.rated_speed
    return series(name, [0.0, knee, data.synchronous_speed], [run_up, run_up, 0.0], "limit")


def _points(data: MotorData) -> list[tuple[float, float]]:
    """Starting point and rated point (speed [rad/s], torque [N m]) as far as they are known."""
    found = [(data.rated_speed, data.rated_torque)]
    if data.winding.starting_torque_ratio is not None:
        found.append((0.0, data.winding.starting_torque_ratio * data.rated_torque))
    return found
