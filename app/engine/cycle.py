"""The load cycle: what every mechanism produces and every drive consumes.

It stands at the drive's output shaft, behind the gear unit. Torque is signed in the direction of positive speed: the
torque that the drive must give, so torque * speed > 0 means that the load absorbs power.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
BoolArray = NDArray[np.bool_]


@dataclass(frozen=True)
class LoadCycle:
    """Segments of constant torque and constant angular acceleration; all arrays have shape (n,), n >= 1."""

    duration: FloatArray
    """[s], each > 0"""
    speed_start: FloatArray
    """Angular speed of the output shaft at the start of each segment [rad/s]; no segment crosses zero speed inside"""
    speed_end: FloatArray
    torque: FloatArray
    """Torque that the load asks of the output shaft [N m]: resistances and load inertia, efficiency of the mechanism
    already applied by direction of power; zero where the brake holds."""
    braked: BoolArray
    """True where the axis stands with its brake closed."""
    label: tuple[str, ...]
    """What happens in each segment, for the reader"""
    inertia: float
    """Largest inertia of the load referred to this shaft, payload included [kg m2]"""

    @cached_property
    def acceleration(self) -> FloatArray:
        """Angular acceleration of each segment [rad/s2]."""
        return (self.speed_end - self.speed_start) / self.duration

    @cached_property
    def mean_speed(self) -> FloatArray:
        """Signed mean speed of each segment [rad/s]."""
        return (self.speed_start + self.speed_end) / 2

    @cached_property
    def power_direction(self) -> FloatArray:
        """s_k: +1 where the load absorbs power, -1 where it returns power, 0 where the motor holds at standstill."""
        return np.sign(self.torque * self.mean_speed)

    @property
    def cycle_time(self) -> float:
        """[s]"""
        return float(self.duration.sum())

    @property
    def max_speed(self) -> float:
        """Highest unsigned speed [rad/s]."""
        return float(max(np.abs(self.speed_start).max(), np.abs(self.speed_end).max()))
