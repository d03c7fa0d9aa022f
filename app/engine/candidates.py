"""Catalogue products as arrays, and the utilisation of every motor with every gear unit as sums of few products.

A candidate is a motor (row) with a gear unit or none (column). Each criterion of a rule set becomes a :class:`Term`
that gives the utilisation of any block of candidates from factors that belong to the row and factors that belong to
the column, so that no candidate ever looks at the segments of the cycle. Utilisations are handled squared: that of the
effective torque is squared by nature, and squares compare alike.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from app.engine.cycle import BoolArray, FloatArray, IndexArray
from app.engine.drives.limits import ContinuousLimits, ServoLimits
from app.engine.drives.rules import ServoRules, permitted_speed, rotor_inertia
from app.engine.products import ServoGearUnit, ServoMotor

UNLIMITED = 1e75
"""Stands for an infinite utilisation: something is demanded where nothing is permitted."""


@dataclass(frozen=True)
class MotorArrays:
    """Servo motors as arrays of shape (m,), NaN where the source does not say; built once per catalogue version."""

    records: tuple[ServoMotor, ...]
    limits: tuple[ServoLimits, ...]
    continuous: ContinuousLimits
    rotor: FloatArray
    """J_M without brake [kg m2]"""
    rotor_with_brake: FloatArray
    """J_M with brake where the source gives it, else without [kg m2]"""
    brake_torque: FloatArray
    flat_peak: FloatArray
    """Peak torque that does not depend on speed [N m]; NaN where there is a curve, or nothing"""
    peak_unknown: BoolArray
    curved: IndexArray
    """Rows with a peak curve"""
    rated_torque: FloatArray
    """M_N, else M_0 [N m]"""
    mass: FloatArray

    @classmethod
    def from_records(cls, records: Iterable[ServoMotor]) -> "MotorArrays":
        """Collect the motors; their order is the row order."""
        motors = tuple(records)
        limits = tuple(ServoLimits(motor) for motor in motors)
        return cls(
            records=motors,
            limits=limits,
            continuous=ContinuousLimits.of(limits),
            rotor=_column(rotor_inertia(motor, False) for motor in motors),
            rotor_with_brake=_column(rotor_inertia(motor, True) for motor in motors),
            brake_torque=_column(motor.brake_torque for motor in motors),
            flat_peak=_column(limit.flat_peak for limit in limits),
            peak_unknown=np.array([bool(limit.peak_missing) for limit in limits], dtype=bool),
            curved=np.array([row for row, motor in enumerate(motors) if motor.peak_curve], dtype=np.intp),
            rated_torque=_column(
                motor.stall_torque if motor.rated_torque is None else motor.rated_torque for motor in motors
            ),
            mass=_column(motor.mass for motor in motors),
        )

    def __len__(self) -> int:
        return len(self.records)

    def permitted_speed(self, rules: ServoRules) -> FloatArray:
        """Permitted speed of every motor under the rules, shape (m,) [rad/s]; NaN where it is not known."""
        return _column(permitted_speed(motor, rules) for motor in self.records)


@dataclass(frozen=True)
class GearArrays:
    """Gear units as arrays of shape (g,), NaN where the source does not say; built once per catalogue version.

    The first column is the direct drive without a gear unit, which has no limits of its own.
    """

    records: tuple[ServoGearUnit, ...]
    ratio: FloatArray
    efficiency: FloatArray
    inertia: FloatArray
    acceleration_torque: FloatArray
    nominal_torque: FloatArray
    emergency_torque: FloatArray
    nominal_input_speed: FloatArray
    max_input_speed: FloatArray
    mass: FloatArray

    @classmethod
    def from_records(cls, records: Iterable[ServoGearUnit]) -> "GearArrays":
        """Collect the gear units; column k + 1 is record k."""
        gears = tuple(records)

        def column(direct: float, values: Iterable[float | None]) -> FloatArray:
            return np.concatenate(([direct], _column(values)))

        return cls(
            records=gears,
            ratio=column(1.0, (gear.ratio for gear in gears)),
            efficiency=column(1.0, (gear.efficiency for gear in gears)),
            inertia=column(0.0, (gear.inertia for gear in gears)),
            acceleration_torque=column(np.inf, (gear.acceleration_torque for gear in gears)),
            nominal_torque=column(np.inf, (gear.nominal_torque for gear in gears)),
            emergency_torque=column(np.inf, (gear.emergency_torque for gear in gears)),
            nominal_input_speed=column(np.inf, (gear.nominal_input_speed for gear in gears)),
            max_input_speed=column(np.inf, (gear.max_input_speed for gear in gears)),
            mass=column(0.0, (gear.mass for gear in gears)),
        )

    def __len__(self) -> int:
        return len(self.records)

    @cached_property
    def has_gear(self) -> BoolArray:
        """Which columns are a gear unit."""
        return np.arange(self.ratio.size) > 0

    @cached_property
    def incomplete(self) -> BoolArray:
        """Columns without efficiency or inertia: torques on the motor shaft are not known."""
        return np.isnan(self.efficiency) | np.isnan(self.inertia)

    @cached_property
    def ratios(self) -> tuple[FloatArray, IndexArray]:
        """The distinct ratios, and for every column the place of its own among them."""
        distinct, place = np.unique(self.ratio, return_inverse=True)
        return distinct, place


@dataclass(frozen=True)
class Missing:
    """Where a check cannot be made: in whole rows, in whole columns, and where a row and a column meet."""

    rows: BoolArray
    columns: BoolArray
    pair_rows: BoolArray | None = None
    pair_columns: BoolArray | None = None

    def at(self, row: int, column: int) -> bool:
        """Whether the check cannot be made for one candidate."""
        found = self.rows[row] or self.columns[column]
        if self.pair_rows is not None and self.pair_columns is not None:
            found = found or (self.pair_rows[row] and self.pair_columns[column])
        return bool(found)

    @classmethod
    def any_of(cls, parts: Sequence["Missing"]) -> "Missing":
        """Where any of several checks cannot be made; at most one of them may meet in pairs."""
        rows = np.logical_or.reduce([part.rows for part in parts])
        columns = np.logical_or.reduce([part.columns for part in parts])
        paired = next((part for part in parts if part.pair_rows is not None), None)
        if paired is None:
            return cls(rows, columns)
        return cls(rows, columns, paired.pair_rows, paired.pair_columns)

    def drop(self, rows: slice, columns: slice, block: BoolArray) -> None:
        """Take the candidates of a block for which the check cannot be made out of ``block``."""
        np.logical_and(block, ~self.rows[rows, None], out=block)
        np.logical_and(block, ~self.columns[columns], out=block)
        if self.pair_rows is not None and self.pair_columns is not None:
            block &= ~(self.pair_rows[rows, None] & self.pair_columns[columns])


class Term:
    """A part of one check: squared utilisation of any block of candidates. Zero where it cannot be computed."""

    key: str

    def squares(self, rows: slice, columns: slice, out: FloatArray, spare: FloatArray) -> None:
        """Write the squared utilisation of a block to ``out``; ``spare`` is another array of its shape."""
        raise NotImplementedError

    def at(self, rows: IndexArray, columns: IndexArray) -> FloatArray:
        """Utilisation of single candidates, shape of ``rows``."""
        raise NotImplementedError


@dataclass(frozen=True)
class ColumnTerm(Term):
    """A criterion of the gear unit alone."""

    key: str
    used: FloatArray
    """Utilisation, shape (g,)"""

    def at(self, rows: IndexArray, columns: IndexArray) -> FloatArray:
        """As in the base."""
        return self.used[columns]


@dataclass(frozen=True)
class ProductTerm(Term):
    """Utilisation as the largest of several sums of row factor times column factor.

    One line of one factor is a demand of the column against a limit of the row; lines of two factors are an envelope
    of straight lines in the inertia of the motor.
    """

    key: str
    rows: FloatArray
    """Shape (m, k)"""
    lines: tuple[FloatArray, ...]
    """Each of shape (k, g)"""

    def squares(self, rows: slice, columns: slice, out: FloatArray, spare: FloatArray) -> None:
        """As in the base."""
        if len(self.lines) == 1 and self.rows.shape[1] == 1:
            np.multiply(self.rows[rows] ** 2, self.lines[0][:, columns] ** 2, out=out)
            return
        factors = self.rows[rows]
        for number, line in enumerate(self.lines):
            np.matmul(factors, line[:, columns], out=spare if number else out)
            if number:
                np.maximum(out, spare, out=out)
        np.multiply(out, out, out=out)

    def at(self, rows: IndexArray, columns: IndexArray) -> FloatArray:
        """As in the base."""
        factors = self.rows[rows]
        found: FloatArray = np.max([np.sum(factors * line[:, columns].T, axis=1) for line in self.lines], axis=0)
        return found


@dataclass(frozen=True)
class TableTerm(Term):
    """Square of the utilisation as a sum of row factor times column factor, over the square of a limit by ratio."""

    key: str
    rows: FloatArray | None
    """Shape (m, k); None for ones"""
    columns: FloatArray
    """Shape (k, g); k = 1 without rows"""
    table: FloatArray
    """Reciprocal square of the limit, shape (m, ratios)"""
    place: IndexArray
    """Which ratio each column has, shape (g,)"""

    def squares(self, rows: slice, columns: slice, out: FloatArray, spare: FloatArray) -> None:
        """As in the base."""
        np.take(self.table[rows], self.place[columns], axis=1, out=out, mode="clip")
        if self.rows is None:
            np.multiply(out, self.columns[:, columns], out=out)
        else:
            np.matmul(self.rows[rows], self.columns[:, columns], out=spare)
            np.multiply(out, spare, out=out)

    def at(self, rows: IndexArray, columns: IndexArray) -> FloatArray:
        """As in the base."""
        factors = 1.0 if self.rows is None else self.rows[rows]
        squares = np.sum(factors * self.columns[:, columns].T, axis=1) * self.table[rows, self.place[columns]]
        found: FloatArray = np.sqrt(np.maximum(squares, 0.0))
        return found


@dataclass(frozen=True)
class EnvelopeTerm(Term):
    """Utilisation by an envelope of so many lines that looking it up is cheaper than drawing every line.

    The envelope E(x) is convex: the utilisation is ``row * p * E(x)`` with ``x = (J_M + J_x) * slope``.
    """

    key: str
    scale: FloatArray
    """Reciprocal of the limit, shape (m,)"""
    rotor: FloatArray
    """J_M, shape (m,)"""
    inertia: FloatArray
    """J_x, shape (g,)"""
    factor: FloatArray
    """p, shape (g,)"""
    slope: FloatArray
    """q / (J * p), shape (g,)"""
    corners: FloatArray
    """Values of x at which the leading line changes, rising from 0"""
    heights: FloatArray
    """E at the corners"""
    last: tuple[float, float]
    """Torque and acceleration of the line that leads beyond the last corner"""

    def _used(self, x: FloatArray, scale: FloatArray, factor: FloatArray) -> FloatArray:
        height = np.maximum(np.interp(x, self.corners, self.heights), self.last[0] + self.last[1] * x)
        return np.asarray(height * scale * factor)

    def squares(self, rows: slice, columns: slice, out: FloatArray, spare: FloatArray) -> None:
        """As in the base."""
        np.add(self.rotor[rows, None], self.inertia[columns], out=spare)
        np.multiply(spare, self.slope[columns], out=spare)
        np.multiply(self._used(spare, self.scale[rows, None], self.factor[columns]), 1.0, out=out)
        np.multiply(out, out, out=out)

    def at(self, rows: IndexArray, columns: IndexArray) -> FloatArray:
        """As in the base."""
        x = (self.rotor[rows] + self.inertia[columns]) * self.slope[columns]
        return self._used(x, self.scale[rows], self.factor[columns])


@dataclass(frozen=True)
class RowsTerm(Term):
    """Utilisations computed beforehand for a few motors (those with a peak curve), zero for all others."""

    key: str
    place: IndexArray
    """Row of ``used`` for every motor, -1 where it has none; shape (m,)"""
    used: FloatArray
    """Shape (some, g)"""

    def squares(self, rows: slice, columns: slice, out: FloatArray, spare: FloatArray) -> None:
        """As in the base."""
        out[...] = 0.0
        for offset, place in enumerate(self.place[rows]):
            if place >= 0:
                np.square(self.used[place, columns], out=out[offset])

    def at(self, rows: IndexArray, columns: IndexArray) -> FloatArray:
        """As in the base."""
        place = self.place[rows]
        return np.where(place >= 0, self.used[np.maximum(place, 0), columns], 0.0)


def reciprocal(limit: FloatArray) -> FloatArray:
    """1 / limit; 0 where the limit is not known or infinite, ``UNLIMITED`` where nothing is permitted."""
    with np.errstate(divide="ignore"):
        found: FloatArray = np.minimum(1 / limit, UNLIMITED)
    found[np.isnan(found)] = 0.0
    return found


def known(values: FloatArray) -> FloatArray:
    """The values with 0 where they are not known."""
    return np.nan_to_num(values, nan=0.0, posinf=np.inf)


def _column(values: Iterable[float | None]) -> FloatArray:
    listed: Sequence[float] = [np.nan if value is None else float(value) for value in values]
    return np.array(listed, dtype=float)
