"""Checks between the cells of a row and between the rows of an edition.

What cannot be (peak torque below rated torque, a motor faster than its rotating field, a power ten times torque times
speed) is an error: a slip in the file. What a maker may well print and merely looks odd is a warning.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from app.catalog.parse import Row, Value
from app.catalog.report import LoadReport, Severity
from app.catalog.schema import TableSpec

POWER_FACTOR_ERROR = 2.0
"""A rated power further than this from rated torque times rated speed is a slip (kW for W, a shifted column)."""
POWER_FACTOR_WARNING = 1.1
"""... and further than this looks odd; makers round to about 5 %."""

RPM = math.pi / 30


@dataclass(frozen=True)
class Order:
    """``larger`` is at least ``smaller`` where a row has both."""

    larger: str
    smaller: str
    severity: Severity

    def findings(self, row: Row) -> Iterator[tuple[Severity, str, str]]:
        """The finding of this rule in ``row``, if any: severity, column, text."""
        larger, smaller = row.number(self.larger), row.number(self.smaller)
        if larger is not None and smaller is not None and larger < smaller:
            yield self.severity, self.larger, f"{larger:g} is less than {self.smaller} {smaller:g}"


@dataclass(frozen=True)
class PowerMatches:
    """Rated power, rated torque and rated speed belong together: P = M * omega."""

    power: str = "rated_power_kw"
    torque: str = "rated_torque_nm"
    speed: str = "rated_speed_rpm"

    def findings(self, row: Row) -> Iterator[tuple[Severity, str, str]]:
        """The finding of this rule in ``row``, if any: severity, column, text."""
        power, torque, speed = row.number(self.power), row.number(self.torque), row.number(self.speed)
        if power is None or torque is None or speed is None:
            return
        expected = torque * speed * RPM / 1000
        off = max(power / expected, expected / power)
        if off > POWER_FACTOR_WARNING:
            severity: Severity = "error" if off > POWER_FACTOR_ERROR else "warning"
            yield severity, self.power, f"{power:g} kW does not match torque times speed: {expected:.3g} kW"


@dataclass(frozen=True)
class BelowSynchronousSpeed:
    """An induction motor runs slower than its rotating field."""

    def findings(self, row: Row) -> Iterator[tuple[Severity, str, str]]:
        """The finding of this rule in ``row``, if any: severity, column, text."""
        poles, frequency, speed = row.number("poles"), row.number("frequency_hz"), row.number("rated_speed_rpm")
        if poles is None or frequency is None or speed is None:
            return
        synchronous = 120 * frequency / poles
        if speed >= synchronous:
            yield "error", "rated_speed_rpm", f"{speed:g} rpm is not below the synchronous speed {synchronous:g} rpm"


Rule = Order | PowerMatches | BelowSynchronousSpeed


def _falling(*columns: str) -> list[Rule]:
    """Each column at least the next ones: a resistor takes more power at a shorter duty."""
    return [Order(a, b, "warning") for i, a in enumerate(columns) for b in columns[i + 1 :]]


RULES: dict[str, Sequence[Rule]] = {
    "servo_motor": [
        Order("peak_torque_nm", "rated_torque_nm", "error"),
        Order("peak_torque_nm", "stall_torque_nm", "error"),
        Order("stall_torque_nm", "rated_torque_nm", "warning"),
        Order("max_speed_rpm", "rated_speed_rpm", "warning"),
        Order("peak_current_a", "rated_current_a", "warning"),
        Order("peak_current_a", "stall_current_a", "warning"),
        Order("rotor_inertia_with_brake_kgcm2", "rotor_inertia_kgcm2", "warning"),
        PowerMatches(),
    ],
    "servo_gear_unit": [
        Order("acceleration_torque_nm", "nominal_torque_nm", "warning"),
        Order("emergency_torque_nm", "acceleration_torque_nm", "warning"),
        Order("max_input_speed_rpm", "nominal_input_speed_rpm", "warning"),
    ],
    "servo_drive": [
        Order("peak_current_a", "continuous_current_a", "error"),
        Order("supply_voltage_max_v", "supply_voltage_min_v", "error"),
    ],
    "induction_motor": [
        BelowSynchronousSpeed(),
        PowerMatches(),
        Order("rotor_inertia_with_brake_kgm2", "rotor_inertia_kgm2", "warning"),
    ],
    "motor_brake": [Order("brake_torque_nm", "min_brake_torque_nm", "error")],
    "inverter": [
        Order("overload_current_a", "rated_current_a", "warning"),
        Order("supply_voltage_max_v", "supply_voltage_min_v", "error"),
    ],
    "braking_resistor": _falling(*(f"power_{duty}_kw" for duty in (6, 10, 12, 15, 25, 40, 50, 100))),
    "ball_screw": [
        Order("nominal_diameter_mm", "root_diameter_mm", "warning"),
        Order("ball_pitch_diameter_mm", "root_diameter_mm", "error"),
    ],
}


def check_rows(rows: list[Row], table: TableSpec, file: str, report: LoadReport) -> None:
    """Hold the rows of one file to the rules of its table and to each other."""
    for row in rows:
        for rule in RULES.get(table.name, ()):
            for severity, column, text in rule.findings(row):
                add = report.error if severity == "error" else report.warn
                add(file, text, row.line, column)
    _check_identity(rows, table, file, report)


def row_key(row: Row, table: TableSpec) -> tuple[Value, ...]:
    """What tells the product of ``row`` apart from the others of its edition."""
    return tuple(row.values[name] for name in table.key)


def point_key(row: Row) -> tuple[Value, ...]:
    """What tells the operating points of one induction motor apart."""
    return tuple(row.values[name] for name in ("poles", "voltage_v", "frequency_hz"))


def _check_identity(rows: list[Row], table: TableSpec, file: str, report: LoadReport) -> None:
    """No product twice; the operating points of one motor differ as points and agree in what belongs to the motor."""
    first: dict[tuple[Value, ...], Row] = {}
    points: dict[tuple[Value, ...], int] = {}
    for row in rows:
        key = row_key(row, table)
        earlier = first.setdefault(key, row)
        if table.detail is not None:
            place = points.setdefault(key + point_key(row), row.line)
            _check_same_motor(row, earlier, table, file, report)
        else:
            place = earlier.line
        if place != row.line:
            name = " ".join(str(part) for part in key if part is not None)
            report.error(file, f"{name!r} stands already in line {place}", row.line, table.key[0])


def _check_same_motor(row: Row, earlier: Row, table: TableSpec, file: str, report: LoadReport) -> None:
    for spec in table.columns.values():
        if spec.table != table.name or spec.name in ("note", "source_page"):
            continue
        if row.values[spec.name] != earlier.values[spec.name]:
            text = f"differs from line {earlier.line}, another operating point of the same motor"
            report.error(file, text, row.line, spec.name)
