"""Puts solved moves one after another as segments of constant acceleration.

A phase of constant acceleration is one segment. A jerk phase is cut into steps whose acceleration is constant: each
step but the last has the acceleration in its middle, the last half step has the peak itself, and the small excess of
that half step is taken evenly from the others. So the end speed, the distance and the peak acceleration are exact,
and the effective acceleration is within 0.03 % of the exact one.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from app.engine.motion.profile import MotionProfile
from app.engine.motion.shape import MoveShape, Ramp

JERK_STEPS = 16
"""Full steps of a jerk phase."""
_SHARPEST = 1e-7
"""Shortest jerk phase that is cut into steps, as a share of the ramp; rounding would blur a shorter one."""

Hold = Literal["motor", "brake"]


@dataclass(frozen=True)
class Burden:
    """What a move carries and works against."""

    payload: float = 0.0
    process_force: float = 0.0
    during: Literal["motion", "constant_speed", "motion_and_standstill"] = "motion"

    def force(self, phase: Literal["ramp", "constant", "standstill"]) -> float:
        """Process force in a phase of the move."""
        acts = {
            "motion": phase != "standstill",
            "constant_speed": phase == "constant",
            "motion_and_standstill": True,
        }[self.during]
        return self.process_force if acts else 0.0


def ramp_steps(ramp: Ramp, steps: int = JERK_STEPS) -> list[tuple[float, float]]:
    """Steps (duration, acceleration) of a ramp in time order, all unsigned.

    >>> ramp_steps(Ramp(time=2.0, acceleration=1.0))
    [(2.0, 1.0)]
    """
    if ramp.jerk_time <= _SHARPEST * ramp.time:
        return [(ramp.time, ramp.acceleration)]
    width = ramp.jerk_time / (steps + 0.5)
    jerk = ramp.acceleration / ramp.jerk_time
    lowered = jerk * width**2 / 8 / (ramp.jerk_time - width / 2)
    rise = [(width, jerk * width * (index + 0.5) - lowered) for index in range(steps)]
    top = ramp.time - 2 * (ramp.jerk_time - width / 2)
    return [*rise, (top, ramp.acceleration), *reversed(rise)]


@dataclass
class Segments:
    """Collects the segments of a cycle. Speeds are signed; every move starts and ends at standstill."""

    kind: Literal["linear", "rotary"]
    jerk_steps: int = JERK_STEPS
    _rows: list[tuple[float, float, float, float, float, float, bool, str]] = field(default_factory=list)

    @property
    def duration(self) -> float:
        """Time of all segments so far [s]."""
        return sum(row[0] for row in self._rows)

    @property
    def travel(self) -> float:
        """Signed distance of all segments so far."""
        return sum(row[0] * (row[1] + row[2]) / 2 for row in self._rows)

    def add(
        self, duration: float, speed_start: float, speed_end: float, burden: Burden, force: float, direction: float,
        label: str, *, braked: bool = False,
    ) -> None:  # fmt: skip
        """Add one segment; one without duration is left out."""
        if duration > 0:
            row = (duration, speed_start, speed_end, burden.payload, force, direction, braked, label)
            self._rows.append(row)

    def move(self, shape: MoveShape, direction: float, burden: Burden, name: str) -> None:
        """Add a move: its ramps, what is between them, and settling held by the motor."""
        self.ramp(shape.up, 0.0, shape.speed, direction, burden, f"{name}: accelerating")
        speed = direction * shape.speed
        constant = burden.force("constant")
        self.add(shape.constant_time, speed, speed, burden, constant, direction, f"{name}: constant speed")
        self.ramp(shape.down, shape.speed, shape.creep_speed, direction, burden, f"{name}: decelerating")
        creeping = direction * shape.creep_speed
        self.add(shape.creep_time, creeping, creeping, burden, constant, direction, f"{name}: creeping")
        self.add(shape.settling, 0.0, 0.0, burden, burden.force("standstill"), direction, f"{name}: settling")

    def ramp(self, ramp: Ramp, start: float, end: float, direction: float, burden: Burden, label: str) -> None:
        """Add a change of speed between two unsigned speeds."""
        sign = 1.0 if end > start else -1.0
        pieces = ramp_steps(ramp, self.jerk_steps)
        borders = np.cumsum([0.0, *(time * rate for time, rate in pieces)])
        borders *= abs(end - start) / borders[-1]  # rounding only: the last border is the end speed itself
        speeds = [start, *(start + sign * borders[1:-1]), end]
        for (time, _), before, after in zip(pieces, speeds, speeds[1:], strict=False):
            self.add(time, direction * before, direction * after, burden, burden.force("ramp"), direction, label)

    def standstill(self, duration: float, direction: float, burden: Burden, hold: Hold, name: str) -> None:
        """Add a dwell or pause."""
        label = f"{name}, {'brake' if hold == 'brake' else 'motor'} holds"
        force = burden.force("standstill")
        self.add(duration, 0.0, 0.0, burden, force, direction, label, braked=hold == "brake")

    def profile(
        self, *, own_ramps: bool = False, endless: bool = False, at_speed_only: Sequence[bool] | None = None
    ) -> MotionProfile:
        """The collected segments as arrays; see the attributes of the profile."""
        numbers = np.array([row[:6] for row in self._rows], dtype=float).T
        duration, start, end, payload, force, direction = numbers
        return MotionProfile(
            kind=self.kind, duration=duration, speed_start=start, speed_end=end, payload=payload, process_force=force,
            direction=direction, braked=np.array([row[6] for row in self._rows], dtype=bool),
            label=tuple(row[7] for row in self._rows), own_ramps=own_ramps, endless=endless,
            at_speed_only=None if at_speed_only is None else np.array(at_speed_only, dtype=bool),
        )  # fmt: skip
