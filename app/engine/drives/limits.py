"""What a servo motor can give over its speed: continuous (S1) curve and peak curve, from what the data sheet says.

Speeds are unsigned [rad/s], torques [N m]. Beyond its last point a curve keeps the last value: that the speed is too
high is the business of the speed check.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from app.engine.cycle import BoolArray, FloatArray
from app.engine.formulas.servo import continuous_torque, torque_between_points
from app.engine.products import ServoMotor
from app.engine.sheet import Sheet

Points = tuple[tuple[float, float], ...]
_CHART_POINTS = 24
_ROWS_AT_ONCE = 32
"""Motors evaluated together: their intermediate results stay in the cache."""


@dataclass(frozen=True)
class ServoLimits:
    """The limits of one motor. A limit that the source does not carry is None, and ``..._missing`` says what lacks."""

    motor: ServoMotor

    @cached_property
    def max_speed(self) -> float | None:
        """Speed at which the curves end [rad/s]: the highest permitted one, else rated speed, else the last point."""
        ends = [points[-1][0] for points in (self.motor.peak_curve, self.motor.continuous_curve) if points]
        return self.motor.max_speed or self.motor.rated_speed or max(ends, default=None)

    @cached_property
    def stall_torque(self) -> float | None:
        """Continuous torque at standstill; where the source gives none, that at rated speed."""
        if self.motor.continuous_curve:
            return self.motor.continuous_curve[0][1]
        return self.motor.rated_torque if self.motor.stall_torque is None else self.motor.stall_torque

    @cached_property
    def two_points(self) -> tuple[float, float, float] | None:
        """M_0, M_N and n_N where the S1 curve is built from stall and rated point."""
        motor = self.motor
        if motor.continuous_curve or self.stall_torque is None:
            return None
        if motor.rated_torque is None or not motor.rated_speed:
            return None
        return self.stall_torque, motor.rated_torque, motor.rated_speed

    @property
    def continuous_missing(self) -> str:
        """What lacks for the S1 curve, empty when it is there."""
        if self.motor.continuous_curve or self.two_points:
            return ""
        return "rated torque and rated speed of the motor"

    @property
    def peak_missing(self) -> str:
        """What lacks for the peak curve, empty when it is there."""
        return "" if self.motor.peak_curve or self.motor.peak_torque is not None else "peak torque of the motor"

    @property
    def flat_peak(self) -> float | None:
        """Peak torque where it does not depend on the speed; None where there is a curve, or nothing."""
        return None if self.motor.peak_curve else self.motor.peak_torque

    def continuous(self, speed: Any) -> Any:
        """S1 torque at a speed (float or array); raises ValueError where ``continuous_missing``."""
        if self.motor.continuous_curve:
            return _interpolated(self.motor.continuous_curve, speed)
        if self.two_points is None:
            raise ValueError(self.continuous_missing)
        return continuous_torque(*self.two_points, n=self._within(speed))

    def peak(self, speed: Any) -> Any:
        """Peak torque at a speed (float or array); raises ValueError where ``peak_missing``."""
        if self.motor.peak_curve:
            return _interpolated(self.motor.peak_curve, speed)
        if self.motor.peak_torque is None:
            raise ValueError(self.peak_missing)
        return self.motor.peak_torque if np.ndim(speed) == 0 else np.full(np.shape(speed), self.motor.peak_torque)

    def _within(self, speed: Any) -> Any:
        return np.minimum(speed, np.inf if self.max_speed is None else self.max_speed)

    def record_continuous(self, sheet: Sheet, speed: float, *, key: str, label: str) -> float | None:
        """Put the S1 torque at one speed on the sheet and return it; None where it is not known."""
        if self.two_points is not None:
            stall, rated, rated_speed = self.two_points
            n = float(self._within(speed))
            return sheet(continuous_torque, key=key, label=label, M_0=stall, M_N=rated, n_N=rated_speed, n=n)
        if self.motor.continuous_curve:
            return _record_point(sheet, self.motor.continuous_curve, speed, key=key, symbol="M_S1", label=label)
        return self.stall_torque if speed == 0 else None

    def record_peak(self, sheet: Sheet, speed: float, *, key: str, label: str) -> None:
        """Put the peak torque at one speed on the sheet where it is read from a curve."""
        if self.motor.peak_curve:
            _record_point(sheet, self.motor.peak_curve, speed, key=key, symbol="M_max", label=label)

    def assume(self, sheet: Sheet) -> None:
        """Put on the sheet how the curves were built."""
        for key, text in self._assumptions():
            sheet.assume(f"drive.motor.{key}", text, source=self.motor.source)

    def _assumptions(self) -> Iterator[tuple[str, str]]:
        motor = self.motor
        if self.two_points is not None:
            if motor.stall_torque is None:
                yield (
                    "stall_torque",
                    "no stall torque is given: the continuous torque at rated speed holds from standstill",
                )
            else:
                yield "continuous_curve", "the S1 curve is a straight line between stall and rated torque"
            if motor.max_speed is not None and motor.max_speed > self.two_points[2]:
                text = "above rated speed the S1 curve is the lower of that line prolonged and constant power"
                yield "field_weakening", text
        if self.flat_peak is not None:
            yield "peak_curve", "no peak curve is given: the peak torque holds over the whole speed range"
        if motor.max_speed is None and motor.rated_speed is not None:
            yield "max_speed", "no highest speed is given: rated speed is taken as the limit"

    def continuous_points(self) -> Points:
        """The S1 curve as a polyline for a chart; empty where it is not known."""
        if self.motor.continuous_curve:
            return self.motor.continuous_curve
        if self.two_points is None or self.max_speed is None:
            return ()
        rated_speed = self.two_points[2]
        speeds = [0.0, rated_speed, *np.linspace(rated_speed, self.max_speed, _CHART_POINTS)[1:].tolist()]
        return tuple((n, float(self.continuous(n))) for n in speeds if n <= self.max_speed)

    def peak_points(self) -> Points:
        """The peak curve as a polyline for a chart; empty where it is not known."""
        if self.flat_peak is None or self.max_speed is None:
            return self.motor.peak_curve
        return (0.0, self.flat_peak), (self.max_speed, self.flat_peak)


@dataclass(frozen=True)
class ContinuousLimits:
    """The S1 curves of many motors at once, by the same formula as for one; arrays have shape (motors,)."""

    limits: tuple[ServoLimits, ...]
    points: FloatArray
    """M_0, M_N, n_N and last speed of the curves built from two points, NaN for the others; shape (4, motors)"""
    stall: FloatArray
    """Continuous torque at standstill, NaN where it is not known"""

    @classmethod
    def of(cls, limits: Sequence[ServoLimits]) -> "ContinuousLimits":
        """Collect the curves of ``limits``."""
        points: FloatArray = np.full((4, len(limits)), np.nan)
        for row, limit in enumerate(limits):
            if limit.two_points is not None and limit.max_speed is not None:
                points[:, row] = (*limit.two_points, limit.max_speed)
        stall = [np.nan if limit.stall_torque is None else limit.stall_torque for limit in limits]
        return cls(tuple(limits), points, np.array(stall, dtype=float))

    @cached_property
    def unknown(self) -> BoolArray:
        """Where the curve is not known."""
        return np.array([bool(limit.continuous_missing) for limit in self.limits], dtype=bool)

    def table(self, speeds: FloatArray) -> FloatArray:
        """S1 torque of every motor at every speed, shape (motors, speeds); NaN where it is not known."""
        found: FloatArray = np.empty((len(self.limits), speeds.size))
        for top in range(0, len(found), _ROWS_AT_ONCE):
            stall, rated, rated_speed, end = (row[top : top + _ROWS_AT_ONCE, None] for row in self.points)
            found[top : top + _ROWS_AT_ONCE] = continuous_torque(stall, rated, rated_speed, n=np.minimum(speeds, end))
        for row, limit in enumerate(self.limits):
            if limit.motor.continuous_curve:
                found[row] = limit.continuous(speeds)
        still = np.flatnonzero(speeds == 0)
        if still.size:
            found[:, still] = np.where(np.isnan(found[:, still]), self.stall[:, None], found[:, still])
        return found


def _interpolated(points: Points, speed: Any) -> Any:
    speeds, torques = zip(*points, strict=True)
    found = np.interp(speed, speeds, torques)
    return float(found) if np.ndim(speed) == 0 else found


def _record_point(sheet: Sheet, points: Points, speed: float, *, key: str, symbol: str, label: str) -> float:
    """Record the reading of a curve: between its two neighbouring points, at the outermost one beyond its end."""
    speeds = np.array([n for n, _ in points])
    n = float(np.clip(speed, speeds[0], speeds[-1]))
    if len(points) == 1:
        (n_a, M_a), (n_b, M_b) = points[0], (points[0][0] + 1.0, points[0][1])
    else:
        right = int(np.clip(np.searchsorted(speeds, n), 1, len(points) - 1))
        (n_a, M_a), (n_b, M_b) = points[right - 1], points[right]
    return sheet(torque_between_points, key=key, symbol=symbol, label=label, n=n, n_a=n_a, M_a=M_a, n_b=n_b, M_b=M_b)
