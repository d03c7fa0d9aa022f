"""From table rows to products of the engine: the catalogue's units become SI here, once."""

from collections.abc import Mapping, Sequence
from typing import Any, TypeVar

from app.catalog.names import product_id
from app.catalog.schema import TABLES, TableSpec
from app.engine.products import (
    BrakingResistor,
    GearUnit,
    InductionMotor,
    Inverter,
    MotorBrake,
    Product,
    ServoDrive,
    ServoGearUnit,
    ServoMotor,
    Winding,
)

ProductT = TypeVar("ProductT", bound=Product)

FIELDS: dict[type[Product], tuple[str, dict[str, str]]] = {
    ServoMotor: (
        "servo_motor",
        {
            "kind": "kind",
            "cooling": "cooling",
            "rated_speed": "rated_speed_rpm",
            "max_speed": "max_speed_rpm",
            "stall_torque": "stall_torque_nm",
            "rated_torque": "rated_torque_nm",
            "peak_torque": "peak_torque_nm",
            "stall_current": "stall_current_a",
            "rated_current": "rated_current_a",
            "peak_current": "peak_current_a",
            "rated_power": "rated_power_kw",
            "rotor_inertia": "rotor_inertia_kgcm2",
            "rotor_inertia_with_brake": "rotor_inertia_with_brake_kgcm2",
            "brake_torque": "brake_torque_nm",
            "mass": "mass_kg",
            "torque_constant": "torque_constant_nm_a",
        },
    ),
    ServoGearUnit: (
        "servo_gear_unit",
        {
            "ratio": "ratio",
            "stages": "stages",
            "nominal_torque": "nominal_torque_nm",
            "acceleration_torque": "acceleration_torque_nm",
            "emergency_torque": "emergency_torque_nm",
            "nominal_input_speed": "nominal_input_speed_rpm",
            "max_input_speed": "max_input_speed_rpm",
            "efficiency": "efficiency",
            "backlash": "backlash_arcmin",
            "torsional_stiffness": "torsional_stiffness_nm_arcmin",
            "inertia": "inertia_kgcm2",
            "max_radial_force": "max_radial_force_n",
            "max_axial_force": "max_axial_force_n",
            "mass": "mass_kg",
        },
    ),
    ServoDrive: (
        "servo_drive",
        {
            "supply_voltage": "supply_voltage_max_v",
            "phases": "phases",
            "continuous_current": "continuous_current_a",
            "peak_current": "peak_current_a",
            "peak_time": "peak_time_s",
            "motor_power": "motor_power_kw",
        },
    ),
    InductionMotor: (
        "induction_motor",
        {
            "rotor_inertia": "rotor_inertia_kgm2",
            "rotor_inertia_with_brake": "rotor_inertia_with_brake_kgm2",
            "mass": "mass_kg",
            "frame_size": "frame_size_mm",
        },
    ),
    MotorBrake: (
        "motor_brake",
        {
            "fits_motor": "fits_motor",
            "torque": "brake_torque_nm",
            "min_torque": "min_brake_torque_nm",
            "inertia": "inertia_kgm2",
            "work_until_adjustment": "work_until_adjustment_mj",
            "max_work_per_operation": "max_work_per_operation_j",
            "release_time": "release_time_ms",
            "application_time_ac": "application_time_ac_ms",
            "application_time_dc": "application_time_dc_ms",
        },
    ),
    GearUnit: (
        "gear_unit",
        {
            "kind": "kind",
            "ratio": "ratio",
            "stages": "stages",
            "max_output_torque": "max_output_torque_nm",
            "reference_input_speed": "reference_input_speed_rpm",
            "max_input_speed": "max_input_speed_rpm",
            "efficiency": "efficiency",
            "permissible_overhung_load": "permissible_overhung_load_n",
            "service_factor": "service_factor",
            "inertia": "inertia_kgm2",
            "mass": "mass_kg",
        },
    ),
    Inverter: (
        "inverter",
        {
            "supply_voltage": "supply_voltage_max_v",
            "phases": "phases",
            "motor_power": "motor_power_kw",
            "rated_current": "rated_current_a",
            "overload_current": "overload_current_a",
            "overload_time": "overload_time_s",
            "min_braking_resistance": "min_braking_resistance_ohm",
        },
    ),
    BrakingResistor: (
        "braking_resistor",
        {
            "resistance": "resistance_ohm",
            "duty_cycle_time": "duty_cycle_time_s",
            "peak_power": "peak_power_kw",
            "pulse_energy": "pulse_energy_kj",
            "mass": "mass_kg",
        },
    ),
}
"""Per engine type: its table, and the column behind each of its fields. Of a supply range the upper end is taken."""


WINDING_FIELDS = {
    "poles": "poles",
    "frequency": "frequency_hz",
    "rated_power": "rated_power_kw",
    "rated_speed": "rated_speed_rpm",
    "rated_torque": "rated_torque_nm",
    "voltage": "voltage_v",
    "rated_current": "rated_current_a",
    "power_factor": "power_factor",
    "efficiency": "efficiency_100_percent",
    "starting_torque_ratio": "starting_torque_ratio",
    "run_up_torque_ratio": "run_up_torque_ratio",
    "run_up_torque": "run_up_torque_nm",
    "breakdown_torque_ratio": "breakdown_torque_ratio",
    "starting_current_ratio": "starting_current_ratio",
    "no_load_starting_frequency": "no_load_starting_frequency_per_h",
}
"""Column of an operating point behind each field of a winding."""

DUTIES = {1.0: "100", 0.5: "50", 0.4: "40", 0.25: "25", 0.15: "15", 0.12: "12", 0.1: "10", 0.06: "6"}
"""Duties of the columns in which braking resistors are rated."""


def table_of(product: type[Product]) -> TableSpec:
    """Table that holds products of this engine type."""
    return TABLES[FIELDS[product][0]]


def product_from_row(product: type[ProductT], row: Mapping[Any, Any], edition_key: str, citation: str) -> ProductT:
    """Engine record of a table row, in SI. ``row`` holds the columns of the table by name."""
    table, fields = FIELDS[product]
    columns = TABLES[table].columns
    values = {field: _in_si(row[column], columns[column].si_scale) for field, column in fields.items()}
    if "phases" in values:
        values["phases"] = int(row["phases"]) if row["phases"] in ("1", "3") else None
    if product is BrakingResistor:
        powers = {duty: row[f"power_{name}_kw"] for duty, name in DUTIES.items()}
        values["ratings"] = tuple(sorted((duty, power * 1e3) for duty, power in powers.items() if power is not None))
    if product is InductionMotor:
        values["windings"] = windings(row["points"])
    if product is MotorBrake:
        values["fits_motor"] = row["fits_motor"] or ""
    page = row["source_page"]
    return product(
        id=product_id(table, edition_key, row["slug"]),
        manufacturer=row["manufacturer"],
        series=row["series"] or "",
        model=row["model"],
        source=f"{citation}, {page}" if page else citation,
        note=row["note"] or "",
        **values,
    )


def windings(points: Sequence[Mapping[Any, Any]]) -> tuple[Winding, ...]:
    """Windings of a motor from its operating points as printed: most poles first, one for each number of poles.

    Of several voltages or frequencies the point at 50 Hz nearest to 400 V is taken.
    """
    best: dict[int, Mapping[Any, Any]] = {}
    for point in points:
        known = best.get(point["poles"])
        if known is None or _distance(point) < _distance(known):
            best[point["poles"]] = point
    columns = TABLES["induction_motor"].columns
    return tuple(
        Winding(**{field: _in_si(point[name], columns[name].si_scale) for field, name in WINDING_FIELDS.items()})
        for _, point in sorted(best.items(), reverse=True)
    )


def _distance(point: Mapping[Any, Any]) -> tuple[float, float]:
    """How far an operating point is from mains of 50 Hz and 400 V."""
    return abs(point["frequency_hz"] - 50.0), abs((point["voltage_v"] or 400.0) - 400.0)


def _in_si(value: Any, scale: float) -> Any:
    return value * scale if isinstance(value, float) else value
