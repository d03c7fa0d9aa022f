"""Several axes on one DC link: what they take and return on a common time axis, and how much they exchange."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from app.engine.cycle import FloatArray
from app.engine.diagram import Diagram, Series, series
from app.engine.resistor import PowerSegment

OVERLAP = 1e-6
"""Time in which a power that falls and one that rises are made to meet in the worst phase [s]"""
_SHORTEST = 1e-9
"""Time between borders that are one and the same [s]"""


@dataclass(frozen=True)
class AxisPower:
    """Power of one axis over its cycle: straight in each segment; arrays of shape (n,) unless said."""

    name: str
    time: FloatArray
    """Segment borders from 0, shape (n + 1,) [s]"""
    start: FloatArray
    """Power at the start of each segment [W], negative where it is returned"""
    end: FloatArray
    label: tuple[str, ...]
    ramp: tuple[bool, ...]
    """Whether the axis slows down in each segment"""
    shift: float = 0.0
    """By how much the cycle begins later than the common one [s]"""

    @property
    def cycle_time(self) -> float:
        """[s]"""
        return float(self.time[-1])

    def repeated(self, times: int) -> "AxisPower":
        """The same over several cycles."""
        offsets = np.arange(times) * self.cycle_time
        borders = np.concatenate([self.time[:-1] + offset for offset in offsets] + [[times * self.cycle_time]])
        return replace(self, time=borders, start=np.tile(self.start, times), end=np.tile(self.end, times),
                       label=self.label * times, ramp=self.ramp * times)  # fmt: skip

    def borders(self) -> FloatArray:
        """Segment borders on the common time axis, within one cycle."""
        return np.unique(np.mod(self.time + self.shift, self.cycle_time).round(12))

    def at(self, moments: FloatArray) -> FloatArray:
        """Power at moments inside segments."""
        inside = np.mod(moments - self.shift, self.cycle_time)
        k = np.clip(np.searchsorted(self.time, inside, side="right") - 1, 0, len(self.start) - 1)
        share = (inside - self.time[k]) / (self.time[k + 1] - self.time[k])
        found: FloatArray = self.start[k] + (self.end[k] - self.start[k]) * share
        return found

    def segments(self) -> list[PowerSegment]:
        """The axis alone, segment by segment."""
        width = np.diff(self.time)
        return [
            PowerSegment(f"{self.name}: {self.label[k]}", float(width[k]), float(self.start[k]), float(self.end[k]),
                         self.ramp[k])
            for k in range(len(width))
        ]  # fmt: skip


def common_cycles(axes: Sequence[AxisPower]) -> list[AxisPower] | None:
    """All axes over the longest cycle; None where it is no whole multiple of the others."""
    longest = max(axis.cycle_time for axis in axes)
    found = []
    for axis in axes:
        times = round(longest / axis.cycle_time)
        if abs(times * axis.cycle_time - longest) > 1e-6 * longest:
            return None
        found.append(axis.repeated(times) if times > 1 else axis)
    return found


def net_segments(axes: Sequence[AxisPower]) -> list[PowerSegment]:
    """The sum of all axes, segment by segment: what one of them returns another one may take."""
    width, start, end = _net(axes)
    return [
        PowerSegment("all axes", *one) for one in zip(width.tolist(), start.tolist(), end.tolist(), strict=True)
    ]  # fmt: skip


def returned_segments(axes: Sequence[AxisPower]) -> list[PowerSegment]:
    """What all axes return together, segment by segment, nothing of it taken by another axis; negative."""
    return net_segments([_only_returned(axis) for axis in axes])


def _only_returned(axis: AxisPower) -> AxisPower:
    """The same axis without what it takes."""
    time, start, end = [0.0], [], []
    for k, segment in enumerate(axis.segments()):
        part, begin, until = segment.returned(), float(axis.time[k]), float(axis.time[k + 1])
        width = 0.0 if part is None else part.duration
        low = (0.0, 0.0) if part is None else (-part.start, -part.end)
        pieces = [(width, *low), (until - begin - width, 0.0, 0.0)]
        for duration, first, last in pieces if segment.start < 0 else pieces[::-1]:
            if duration > _SHORTEST:
                time.append(time[-1] + duration)
                start.append(first)
                end.append(last)
    return replace(axis, time=np.array(time), start=np.array(start), end=np.array(end), label=("",) * len(start),
                   ramp=(False,) * len(start))  # fmt: skip


def _net(axes: Sequence[AxisPower]) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Duration and power at both ends of every segment of the sum."""
    total = axes[0].cycle_time
    borders = np.unique(np.concatenate([[0.0, total], *[axis.borders() for axis in axes]]).round(12))
    borders = borders[np.concatenate(([True], np.diff(borders) > _SHORTEST))]
    width = np.diff(borders)
    # straight inside, but it may jump at the borders: prolonged from two moments inside
    early, late = np.sum(
        [axis.at(np.stack((borders[:-1] + width / 4, borders[1:] - width / 4))) for axis in axes], axis=0
    )
    rise = (late - early) / 2
    return width, early - rise, late + rise


def returning_time(axes: Sequence[AxisPower]) -> float:
    """Time of a cycle in which at least one axis returns power, exchange left out [s]."""
    total = axes[0].cycle_time
    borders = np.unique(np.concatenate([[0.0, total], *[axis.borders() for axis in axes]]))
    middle = (borders[:-1] + borders[1:]) / 2
    returns = np.zeros(len(middle), dtype=bool)
    for axis in axes:
        returns |= axis.at(middle) < 0
    return float(np.diff(borders)[returns].sum())


def worst_phase(axes: Sequence[AxisPower]) -> tuple[list[AxisPower], float]:
    """Shifts at which the axes together take most power, and that power [W]; the first axis stays where it is.

    Power is straight in each segment, so every axis takes most at an end of a segment. Axes that may begin at any time
    are shifted until all these moments meet; no phase takes more than all of them together. Where one power falls away
    just after its moment and another one rises to it just before, they overlap by ``OVERLAP``: the power returned is
    the one that is approached as this becomes shorter.
    """
    tops = [_strongest(axis) for axis in axes]
    power = sum(top.power for top in tops)
    if _largest(axes) >= power - 1e-9 * sum(abs(top.power) for top in tops):
        return list(axes), power
    first = axes[0].shift + tops[0].moment
    placed = [axes[0]]
    for axis, top in zip(axes[1:], tops[1:], strict=True):
        apart = (0.0 if top.rises == tops[0].rises else OVERLAP) * (1 if tops[0].rises else -1)
        placed.append(replace(axis, shift=float(np.mod(first - apart - top.moment, axis.cycle_time))))
    return placed, power


@dataclass(frozen=True)
class _Strongest:
    """Where an axis takes most."""

    power: float
    """[W]"""
    moment: float
    """In its own cycle [s]"""
    rises: bool
    """Whether that power is reached from before the moment, so that it may be gone after it."""


def _strongest(axis: AxisPower) -> _Strongest:
    start, end = int(np.argmax(axis.start)), int(np.argmax(axis.end))
    if axis.end[end] >= axis.start[start]:
        return _Strongest(float(axis.end[end]), float(axis.time[end + 1]), rises=True)
    return _Strongest(float(axis.start[start]), float(axis.time[start]), rises=False)


def _largest(axes: Sequence[AxisPower]) -> float:
    _, start, end = _net(axes)
    return float(max(start.max(), end.max()))


def power_diagram(axes: Sequence[AxisPower]) -> Diagram:
    """Power in the DC link over time: each axis and the sum."""
    total = axes[0].cycle_time
    borders = np.unique(np.concatenate([[0.0, total], *[axis.borders() for axis in axes]]))
    inner = np.minimum(np.diff(borders) * 1e-4, 1e-6)
    moments = np.column_stack([borders[:-1] + inner, borders[1:] - inner]).ravel()
    shown: list[Series] = [series(axis.name, moments, axis.at(moments)) for axis in axes]
    if len(axes) > 1:
        shown.append(series("all axes", moments, sum(axis.at(moments) for axis in axes), "sum"))
    return Diagram("dc_link", "Power in the DC link", "time", "s", "power", "kW", tuple(shown))
