"""What a servo motor can give over its speed: continuous (S1) curve and peak curve, from what the data sheet says.

Speeds are unsigned [rad/s], torques [N m]. Beyond its last point a curve keeps the last value: that the speed is too
high is the business of the speed check.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from app.engine.cycle import FloatArray
from app.engine.formulas.servo import continuous_torque, torque_between_points
from app.engine.products import ServoMotor
from app.engine.sheet import Sheet

Points = tuple[tuple[float, float], ...]
_CHART_POINTS = 24


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
        return None

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


def continuous_table(limits: Sequence[ServoLimits], speeds: FloatArray) -> FloatArray:
    """S1 torque of every motor at every speed, shape (motors, speeds); NaN where a motor's curve is not known."""
    found: FloatArray = np.full((len(limits), speeds.size), np.nan)
    lines = [
        (row, limit.two_points, limit.max_speed) for row, limit in enumerate(limits) if limit.two_points is not None
    ]
    if lines:
        rows = [row for row, _, _ in lines]
        stall, rated, rated_speed = (np.array([points[k] for _, points, _ in lines])[:, None] for k in range(3))
        ends = np.array([end for _, _, end in lines])[:, None]
        found[rows] = continuous_torque(stall, rated, rated_speed, n=np.minimum(speeds, ends))
    for row, limit in enumerate(limits):
        if limit.motor.continuous_curve:
            found[row] = limit.continuous(speeds)
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
