"""Tabulated points of a chart or a standard: data with a source, interpolated, replaceable by the user."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise


@dataclass(frozen=True)
class Table:
    """Points of one curve or of a family of curves (one per ``family`` value), by rising ``x``.

    Between the points of a curve the value is interpolated in a straight line, between two curves likewise. Outside
    the table there is no value: nothing is extrapolated.
    """

    key: str
    title: str
    source: str
    curves: tuple[tuple[float, tuple[tuple[float, float], ...]], ...]
    """(family value, points (x, value)) by rising family value; a single curve has the family value 0."""
    clamped: bool = False
    """Whether the end values hold beyond the ends (a factor that stays at 1, say)."""

    def value(self, x: float, family: float = 0.0) -> float | None:
        """Interpolated value; None outside the table."""
        found = [(at, _on_curve(points, x, clamped=self.clamped)) for at, points in self.curves]
        known = [(at, value) for at, value in found if value is not None]
        if len(self.curves) == 1:
            return known[0][1] if known else None
        return _on_curve(known, family, clamped=self.clamped)


def _on_curve(points: Sequence[tuple[float, float]], x: float, *, clamped: bool) -> float | None:
    """Straight-line interpolation in points by rising x; None outside."""
    if not points:
        return None
    first, last = points[0], points[-1]
    if x < first[0] or x > last[0]:
        if not clamped:
            return None
        return first[1] if x < first[0] else last[1]
    if len(points) == 1:
        return first[1]
    for (x_0, y_0), (x_1, y_1) in pairwise(points):
        if x_0 <= x <= x_1:
            return y_0 if x_1 == x_0 else y_0 + (y_1 - y_0) * (x - x_0) / (x_1 - x_0)
    return None
