"""The load cycle: what every mechanism produces and every drive consumes.

It stands at the drive's output shaft, behind the gear unit. Torque is signed in the direction of positive speed: the
torque that the drive must give, so torque * speed > 0 means that the load absorbs power.

What a drive with ratio i, factors of the efficiency and inertia J on the motor shaft must give in segment k is
``M_k = p_s * T_k + q * alpha_k`` with ``q = J * i`` and ``p_s`` by direction of power: 1 / (i * eta) driving, eta' / i
returning, 1 / i holding at standstill. So the effective torque of any drive follows from a few sums over the cycle
(:class:`CycleSums`), and its peak torque from the outermost points only (:class:`CycleHull`).
"""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull, QhullError

FloatArray = NDArray[np.float64]
BoolArray = NDArray[np.bool_]
IndexArray = NDArray[np.intp]

DIRECTIONS = (1, -1, 0)
"""Directions of power: +1 driving, -1 returning, 0 holding at standstill."""
_FLAT = 1e-12
"""Extent below which a cloud of points counts as flat, relative to its largest extent."""


@dataclass(frozen=True)
class CycleSums:
    """What remains of a cycle for effective torque and mean speed; a braked segment counts as time only."""

    driving_torque2: float
    """Sum of T^2 dt where the load absorbs power [N2 m2 s]"""
    returning_torque2: float
    """Sum of T^2 dt where the load returns power [N2 m2 s]"""
    holding_torque2: float
    """Sum of T^2 dt where the motor holds at standstill [N2 m2 s]"""
    driving_torque_alpha: float
    """Sum of T alpha dt where the load absorbs power [N m rad/s]"""
    returning_torque_alpha: float
    """Sum of T alpha dt where the load returns power [N m rad/s]"""
    alpha2: float
    """Sum of alpha^2 dt [rad2/s3]"""
    angle: float
    """Sum of abs(omega) dt: angle turned, both directions counted positive [rad]"""
    torque3_angle: float
    """Sum of abs(T)^3 abs(omega) dt: what wears a gear unit [N3 m3 rad]"""
    time: float
    """[s]"""


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

    @cached_property
    def held(self) -> tuple[FloatArray, FloatArray]:
        """Torque [N m] and acceleration [rad/s2] that the motor must give: both zero where the brake is closed."""
        if not self.braked.any():
            return self.torque, self.acceleration
        return np.where(self.braked, 0.0, self.torque), np.where(self.braked, 0.0, self.acceleration)

    @cached_property
    def sums(self) -> CycleSums:
        """The sums over the cycle from which the effective torque of every drive follows."""
        torque, alpha = self.held
        weighted = torque * self.duration
        angle = np.abs(self.mean_speed) * self.duration
        driving, returning = self.power_direction > 0, self.power_direction < 0
        squares = weighted * torque
        products = weighted * alpha
        drive2, return2 = float(squares @ driving), float(squares @ returning)
        standing = self.power_direction == 0
        return CycleSums(
            driving_torque2=drive2,
            returning_torque2=return2,
            holding_torque2=float(squares @ standing),
            driving_torque_alpha=float(products @ driving),
            returning_torque_alpha=float(products @ returning),
            alpha2=float((alpha * self.duration) @ alpha),
            angle=float(angle.sum()),
            torque3_angle=float(np.abs(torque) ** 3 @ angle),
            time=self.cycle_time,
        )

    @cached_property
    def hull(self) -> "CycleHull":
        """The outermost points of this cycle alone."""
        return CycleHull((self,))


@dataclass(frozen=True)
class Envelope:
    """Largest ``abs(p * T + q * alpha)`` over the segments of one direction of power, for any p >= 0 and q >= 0.

    The lines that can be largest, by rising acceleration; shape (lines,), none when no segment has this direction.
    """

    torque: FloatArray
    """[N m]"""
    acceleration: FloatArray
    """[rad/s2]"""

    def peak(self, p: FloatArray | float, q: FloatArray | float) -> FloatArray:
        """Largest magnitude of the motor torque for ``p`` [1] and ``q`` [kg m2], which broadcast; 0 without lines."""
        found: FloatArray = np.zeros(np.broadcast(p, q).shape)
        for torque, acceleration in zip(self.torque, self.acceleration, strict=True):
            np.maximum(found, np.multiply(p, torque) + np.multiply(q, acceleration), out=found)
        return found


def upper_envelope(torque: FloatArray, acceleration: FloatArray) -> Envelope:
    """Reduce the points (torque, acceleration), shape (n,) each, and their mirror images to their envelope.

    The envelope is the part of the convex hull that faces the first quadrant. Most points go in three vectorised
    passes (those below the chord between the two extremes cannot matter); the few that remain are chained.
    """
    x = np.concatenate((torque, -torque))
    y = np.concatenate((acceleration, -acceleration))
    if x.size == 0:
        return Envelope(x, y)
    top = _best(y, x)
    right = _best(x, y)
    if x[top] == x[right]:
        return Envelope(x[[top]], y[[top]])
    outside = _above(x, y, top, right)
    if outside.any():
        far = int(np.argmax(_height(x, y, top, right)))
        outside &= _above(x, y, top, far) | _above(x, y, far, right)
        outside[far] = True
    inner = np.flatnonzero(outside)
    chain: list[int] = [right]
    for index in (*inner[np.lexsort((x[inner], y[inner]))].tolist(), top):
        while len(chain) > 1 and _turn(x, y, chain[-2], chain[-1], index) <= 0:
            chain.pop()
        chain.append(index)
    return Envelope(x[chain], y[chain])


def _best(first: FloatArray, second: FloatArray) -> int:
    """Index of the largest ``first``, among equals that of the largest ``second``."""
    ties = np.flatnonzero(first == first.max())
    return int(ties[np.argmax(second[ties])])


def _height(x: FloatArray, y: FloatArray, a: int, b: int) -> FloatArray:
    """Distance (times the chord's length) of every point from the chord a-b, positive on the side of larger x and y."""
    found: FloatArray = (x - x[a]) * (y[a] - y[b]) + (y - y[a]) * (x[b] - x[a])
    return found


def _above(x: FloatArray, y: FloatArray, a: int, b: int) -> BoolArray:
    """Which points lie beyond the chord a-b by more than rounding."""
    noise = 4e-16 * (abs(x[b] - x[a]) * np.abs(y).max() + abs(y[b] - y[a]) * np.abs(x).max())
    found: BoolArray = _height(x, y, a, b) > noise
    return found


def _turn(x: FloatArray, y: FloatArray, a: int, b: int, c: int) -> float:
    """Positive when the path a, b, c turns left."""
    return float((x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a]))


class CycleHull:
    """The outermost points of one or several load cycles: all that peak torque and speed limits can depend on."""

    def __init__(self, cycles: Iterable[LoadCycle]) -> None:
        self.cycles = tuple(cycles)

    @cached_property
    def max_speed(self) -> float:
        """Highest unsigned speed of the output shaft [rad/s]."""
        return max(cycle.max_speed for cycle in self.cycles)

    @cached_property
    def extreme_torque(self) -> float:
        """Torque of largest magnitude at the output shaft, signed [N m]."""
        extremes = [float(end) for cycle in self.cycles for end in (cycle.held[0].max(), cycle.held[0].min())]
        return max(extremes, key=abs)

    @property
    def max_torque(self) -> float:
        """Largest unsigned torque at the output shaft [N m]."""
        return abs(self.extreme_torque)

    @cached_property
    def max_acceleration(self) -> float:
        """Largest unsigned angular acceleration of the output shaft [rad/s2]."""
        return max(float(np.abs(cycle.held[1]).max()) for cycle in self.cycles)

    @cached_property
    def envelopes(self) -> dict[int, Envelope]:
        """Envelope of each direction of power (keys of ``DIRECTIONS``), for limits that do not depend on speed."""
        found = {}
        for direction in DIRECTIONS:
            chosen = [cycle.power_direction == direction for cycle in self.cycles]
            parts = [
                tuple(values[mask] for values in cycle.held) for cycle, mask in zip(self.cycles, chosen, strict=True)
            ]
            found[direction] = upper_envelope(*(np.concatenate(part) for part in zip(*parts, strict=True)))
        return found

    @cached_property
    def points(self) -> dict[int, FloatArray]:
        """Distinct points (T, alpha, abs(omega)) of all segment ends by direction of power, shape (n, 3)."""
        found: dict[int, list[FloatArray]] = {direction: [] for direction in DIRECTIONS}
        for cycle in self.cycles:
            torque, alpha = cycle.held
            for speed in (cycle.speed_start, cycle.speed_end):
                rows = np.column_stack((torque, alpha, np.abs(speed)))
                for direction in DIRECTIONS:
                    found[direction].append(rows[(cycle.power_direction == direction) & ~cycle.braked])
        return {direction: np.unique(np.concatenate(rows), axis=0) for direction, rows in found.items()}

    @cached_property
    def vertices(self) -> dict[int, FloatArray]:
        """The corners of the convex hull of ``points``: enough for every straight line of a limit curve."""
        return {direction: rows[hull_vertices(rows)] for direction, rows in self.points.items()}


def hull_vertices(points: FloatArray) -> IndexArray:
    """Indices of the corners of the convex hull of ``points``, shape (n, d); a flat cloud is handled in its own plane.

    May return more than the corners (every point where the cloud is too small or too flat to be sure), never fewer.
    """
    everything = np.arange(len(points))
    if len(points) <= points.shape[1] + 1:
        return everything
    extent = np.ptp(points, axis=0)
    scaled = (points - points.mean(axis=0)) / np.where(extent > 0, extent, 1.0)
    _, sizes, axes = np.linalg.svd(scaled, full_matrices=False)
    rank = int(np.sum(sizes > _FLAT * sizes[0]))
    if rank == 0:
        return everything[:1]
    flat = scaled @ axes[:rank].T
    if rank == 1:
        return np.unique([int(np.argmin(flat)), int(np.argmax(flat))])
    try:
        return np.sort(ConvexHull(flat).vertices).astype(np.intp)
    except QhullError:
        return everything
