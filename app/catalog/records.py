"""From table rows to products of the engine: the catalogue's units become SI here, once."""

from collections.abc import Mapping
from typing import Any, TypeVar

from app.catalog.names import product_id
from app.catalog.schema import TABLES, TableSpec
from app.engine.products import Product, ServoDrive, ServoGearUnit, ServoMotor

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
}
"""Per engine type: its table, and the column behind each of its fields. Of a supply range the upper end is taken."""


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


def _in_si(value: Any, scale: float) -> Any:
    return value * scale if isinstance(value, float) else value
