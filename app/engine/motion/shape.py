"""Shape of one move over time: accelerate, run at constant speed, brake; with or without rounded corners.

All values are unsigned and SI: m, m/s, m/s2 for a linear move, rad, rad/s, rad/s2 for a rotary one.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

from app.engine.formulas import motion as formulas


@dataclass(frozen=True)
class Ramp:
    """One change of speed between standstill and the peak speed; its acceleration is symmetric in time."""

    time: float
    acceleration: float
    """Highest acceleration reached."""
    jerk_time: float = 0.0
    """Time in which the acceleration rises to its peak, and in which it falls again; 0 without jerk limit."""


@dataclass(frozen=True)
class MoveShape:
    """A solved move from standstill to standstill."""

    distance: float
    speed: float
    """Peak speed."""
    up: Ramp
    down: Ramp
    constant_time: float
    settling: float = 0.0
    creep_speed: float = 0.0
    """Speed to which ``down`` leads, 0 for a standstill."""
    creep_time: float = 0.0
    """Time at creep speed, after which a brake stops the axis."""

    @property
    def motion_time(self) -> float:
        """Time in which the axis moves."""
        return self.up.time + self.constant_time + self.down.time + self.creep_time

    @property
    def time(self) -> float:
        """Time from the start until the axis has settled."""
        return self.motion_time + self.settling


@dataclass(frozen=True)
class Smoothing:
    """How the corners of a trapezoid are rounded: by a jerk, by a share of the ramp's time, or (neither) not at all."""

    jerk: float | None = None
    share: float | None = None

    def ramp_time(self, speed: float, acceleration: float) -> float:
        """Time to reach ``speed`` with at most ``acceleration``."""
        if self.jerk is not None:
            return float(formulas.s_curve_ramp_time(speed, acceleration, self.jerk))
        return float(formulas.ramp_time(speed, self.mean(acceleration)))

    def mean(self, acceleration: float) -> float:
        """Mean acceleration of a ramp whose corners are rounded by a share of its time (not for a jerk)."""
        return float(formulas.mean_ramp_acceleration(acceleration, self.share)) if self.share else acceleration

    def ramp(self, speed: float, acceleration: float) -> Ramp:
        """The ramp to ``speed`` with at most ``acceleration``."""
        time = self.ramp_time(speed, acceleration)
        if self.jerk is not None:
            peak = formulas.s_curve_peak_acceleration(speed, acceleration, self.jerk)
            return Ramp(time, peak, min(formulas.jerk_time(peak, self.jerk), time / 2))
        return Ramp(time, acceleration, (self.share or 0.0) * time / 2)


NO_SMOOTHING = Smoothing()


def root(function: Callable[[float], float], low: float, high: float) -> float:
    """Where a monotone function passes zero between ``low`` and ``high``, to rounding (Ridders' method).

    An end is returned when the function does not change its sign in between: the caller has made sure that the root is
    there up to rounding.
    """
    f_low, f_high = function(low), function(high)
    if f_low * f_high >= 0:
        return low if abs(f_low) < abs(f_high) else high
    for _ in range(100):
        middle = (low + high) / 2
        f_middle = function(middle)
        if f_middle == 0 or high - low <= 1e-15 * abs(middle):
            return middle
        # The exponential through the three points straightens the function before its zero is taken.
        step = (middle - low) * f_middle / math.sqrt(f_middle**2 - f_low * f_high)
        guess = min(max(middle + (step if f_low > f_high else -step), low), high)
        f_guess = function(guess)
        if f_guess == 0:
            return guess
        ends = sorted([(low, f_low), (middle, f_middle), (guess, f_guess), (high, f_high)])
        for (x_1, f_1), (x_2, f_2) in pairwise(ends):
            if f_1 * f_2 <= 0:
                if (low, high) == (x_1, x_2):
                    return guess
                (low, f_low), (high, f_high) = (x_1, f_1), (x_2, f_2)
                break
    return (low + high) / 2


def minimum_of(function: Callable[[float], float], low: float, high: float, points: int = 24) -> float:
    """Where a function with one minimum (infinite where it is not defined) is smallest: grid, then golden section."""
    step = (high - low) / points
    best = min((low + index * step for index in range(1, points + 1)), key=function)
    low, high = max(best - step, low), min(best + step, high)
    ratio = (5**0.5 - 1) / 2
    for _ in range(40):
        left, right = high - ratio * (high - low), low + ratio * (high - low)
        if function(left) <= function(right):
            high = right
        else:
            low = left
    return (low + high) / 2
