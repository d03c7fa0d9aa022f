"""What a motion is once it is solved: consecutive segments of constant acceleration, signed, in SI.

A linear motion is in m, m/s, m/s2; a rotary one in rad, rad/s, rad/s2. Positive is the direction away from the start;
on an inclined axis positive is up.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import groupby
from typing import Literal

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
BoolArray = NDArray[np.bool_]


@dataclass(frozen=True)
class Phase:
    """Consecutive segments that belong together for the reader: one phase of one move."""

    label: str
    """e.g. ``"move 1: accelerating"``"""
    start: int
    stop: int
    """Segments ``start`` to ``stop`` (exclusive) of the profile."""


@dataclass(frozen=True)
class MotionProfile:
    """Segments of one cycle; all arrays have shape (n,), n >= 1. No segment changes its direction of motion inside."""

    kind: Literal["linear", "rotary"]
    duration: FloatArray
    """[s], each > 0"""
    speed_start: FloatArray
    """[m/s or rad/s]"""
    speed_end: FloatArray
    payload: FloatArray
    """Mass [kg] (linear) or inertia [kg m2] (rotary) carried in this segment beside the mechanism's own."""
    process_force: FloatArray
    """Force [N] (linear) or torque [N m] (rotary) that resists the motion; negative where it helps. At standstill it
    acts against the direction of the move before."""
    direction: FloatArray
    """+1 or -1: direction of the motion; at standstill that of the move before."""
    braked: BoolArray
    """True where the axis stands and a brake holds it; False where it moves or the motor holds."""
    label: tuple[str, ...]
    """Phase of each segment, for the reader."""
    at_speed_only: BoolArray | None = None
    """True where the process force acts at full speed only, shape (n,); None: nowhere. Matters where the drive makes
    its own ramps; other motions show it by their segments."""
    endless: bool = False
    """Whether it simply runs on: then its length is nominal and means nothing."""
    own_ramps: bool = False
    """Whether the drive makes its own ramps: then the segments hold none, and only such a drive can follow them."""

    @cached_property
    def acceleration(self) -> FloatArray:
        """Constant acceleration of each segment [m/s2 or rad/s2]."""
        return (self.speed_end - self.speed_start) / self.duration

    @cached_property
    def mean_speed(self) -> FloatArray:
        """Signed mean speed of each segment."""
        return (self.speed_start + self.speed_end) / 2

    @property
    def cycle_time(self) -> float:
        """Length of the cycle [s]."""
        return float(self.duration.sum())

    @property
    def max_speed(self) -> float:
        """Highest speed of the cycle, unsigned."""
        return float(max(np.abs(self.speed_start).max(), np.abs(self.speed_end).max()))

    @cached_property
    def position(self) -> FloatArray:
        """Position at the segment borders, shape (n + 1,), from 0."""
        return np.concatenate(([0.0], np.cumsum(self.mean_speed * self.duration)))

    @cached_property
    def phases(self) -> tuple[Phase, ...]:
        """Runs of segments with the same label, in time order."""
        found, index = [], 0
        for label, run in groupby(self.label):
            length = len(list(run))
            found.append(Phase(label, index, index + length))
            index += length
        return tuple(found)

    def mirrored(self) -> "MotionProfile":
        """The same motion in the opposite direction."""
        return replace(
            self, speed_start=-self.speed_start, speed_end=-self.speed_end, direction=-self.direction, label=self.label
        )

    def segment(self, k: int, duration: float) -> "MotionProfile":
        """Segment ``k`` alone, at constant speed for another time [s]."""
        one = slice(k, k + 1)
        return replace(
            self, duration=np.array([duration]), speed_start=self.speed_start[one], speed_end=self.speed_end[one],
            payload=self.payload[one], process_force=self.process_force[one], direction=self.direction[one],
            braked=self.braked[one], label=self.label[one],
            at_speed_only=None if self.at_speed_only is None else self.at_speed_only[one],
        )  # fmt: skip


def joined(profiles: Sequence[MotionProfile]) -> MotionProfile:
    """One motion after the other; at least one, all of one kind."""
    return replace(
        profiles[0],
        duration=np.concatenate([one.duration for one in profiles]),
        speed_start=np.concatenate([one.speed_start for one in profiles]),
        speed_end=np.concatenate([one.speed_end for one in profiles]),
        payload=np.concatenate([one.payload for one in profiles]),
        process_force=np.concatenate([one.process_force for one in profiles]),
        direction=np.concatenate([one.direction for one in profiles]),
        braked=np.concatenate([one.braked for one in profiles]),
        label=tuple(text for one in profiles for text in one.label),
        at_speed_only=None,
    )
