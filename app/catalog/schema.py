"""The catalogue's tables as their files and the browser page see them, read from the declared columns of the models.

A header cell names a column exactly (``rated_torque_nm``), or the same quantity in another unit of its kind
(``rated_torque_ncm``), so that a file keeps the unit that its data sheet prints.
"""

import difflib
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

from sqlalchemy import Float, Integer, Table

from app.db.columns import Meaning, column_suffix, meaning_of
from app.db.models import (
    BallScrew,
    BrakingResistor,
    GearUnit,
    InductionMotor,
    InductionMotorOperatingPoint,
    Inverter,
    MotorBrake,
    ProductColumns,
    ServoDrive,
    ServoGearUnit,
    ServoMotor,
    TimingBelt,
)
from app.engine.quantity import si_factor

UNIT_KINDS: dict[str, tuple[str, ...]] = {
    "torque": ("N m", "mN m", "N cm", "kN m", "ozf in", "lbf in", "lbf ft"),
    "moment of inertia": ("kg cm2", "kg m2", "g cm2", "kg mm2", "lb in2"),
    "speed of rotation": ("rpm", "rad/s"),
    "power": ("kW", "W", "hp"),
    "energy": ("J", "kJ", "MJ"),
    "current": ("A", "mA"),
    "voltage": ("V", "kV"),
    "mass": ("kg", "g", "lb"),
    "length": ("mm", "cm", "m", "in"),
    "force": ("N", "kN", "lbf"),
    "angle": ("arcmin", "deg"),
    "torsional stiffness": ("N m/arcmin", "N m/rad"),
    "torque constant": ("N m/A",),
    "voltage constant": ("V s/rad",),
    "resistance": ("ohm", "mohm"),
    "inductance": ("mH", "H"),
    "time": ("s", "ms"),
    "frequency": ("Hz",),
    "frequency of starts": ("1/h",),
    "speed": ("m/min", "m/s"),
    "mass per length": ("kg/m", "g/m"),
    "diameter times speed": ("mm rpm",),
    "share": ("%",),
}
"""Units that a header may end in, by what they measure; those of one kind convert into each other."""

_KIND_OF = {unit: kind for kind, units in UNIT_KINDS.items() for unit in units}
_UNIT_OF_SUFFIX = {column_suffix(unit): unit for unit in _KIND_OF}


@dataclass(frozen=True)
class ColumnSpec:
    """One column that a file may fill."""

    name: str
    meaning: Meaning
    type: Literal["number", "integer", "text"]
    required: bool
    max_length: int | None
    table: str
    """Name of the database table that holds it (motor or operating point, say)."""

    @property
    def unit(self) -> str | None:
        """Unit of the stored value; ``"1"`` for a plain ratio, None for a text or a count."""
        return self.meaning.unit

    @property
    def quantity(self) -> str:
        """The name without its unit: ``rated_torque``."""
        return self.name.removesuffix(column_suffix(self.unit))

    @cached_property
    def si_scale(self) -> float:
        """Factor that turns the stored value into SI."""
        return si_factor(self.unit)[0] if self.unit else 1.0


@dataclass(frozen=True)
class TableSpec:
    """One kind of product: its file is ``<name>.csv``."""

    name: str
    title: str
    model: type[ProductColumns]
    columns: dict[str, ColumnSpec]
    key: tuple[str, ...]
    table: Table
    detail: Table | None = None
    """Second table that holds a part of each row (the operating points of induction motors)."""

    def column(self, header: str) -> "HeaderCell":
        """What a header cell means.

        Raises HeaderError with the reason when it means nothing here.
        """
        if header in self.columns:
            return HeaderCell(self.columns[header], 1.0)
        for spec in self.columns.values():
            if spec.unit in (None, "1"):
                continue
            given = header.removeprefix(spec.quantity)
            if given == header:
                continue
            unit = _UNIT_OF_SUFFIX.get(given)
            if unit is not None:
                return HeaderCell(spec, _unit_scale(header, unit, spec))
            if given == "":
                raise HeaderError(f"{header!r} needs its unit: {spec.name!r}")
        near = difflib.get_close_matches(header, self.columns, n=1)
        raise HeaderError(f"unknown column {header!r}" + (f"; did you mean {near[0]!r}?" if near else ""))


@dataclass(frozen=True)
class HeaderCell:
    """A column found in a header, and the factor from the header's unit to the column's."""

    spec: ColumnSpec
    scale: float


class HeaderError(ValueError):
    """A header cell that no column answers to."""


def _unit_scale(header: str, unit: str, spec: ColumnSpec) -> float:
    wanted = str(spec.unit)
    kind = _KIND_OF[wanted]
    if _KIND_OF[unit] != kind:
        allowed = ", ".join(UNIT_KINDS[kind])
        raise HeaderError(f"{header!r}: {unit} is no unit of {kind}; {spec.name!r} takes {allowed}")
    return si_factor(unit)[0] / si_factor(wanted)[0]


def _column_specs(table: Table) -> dict[str, ColumnSpec]:
    found = {}
    for column in table.columns:
        meaning = meaning_of(column.info)
        if meaning is None:
            continue
        kind: Literal["number", "integer", "text"] = "text"
        if isinstance(column.type, Float):
            kind = "number"
        elif isinstance(column.type, Integer):
            kind = "integer"
        length: Any = getattr(column.type, "length", None)
        found[column.name] = ColumnSpec(column.name, meaning, kind, not column.nullable, length, table.name)
    return found


def _table_spec(model: Any, detail: Any = None) -> TableSpec:
    columns = _column_specs(model.__table__)
    if detail is not None:
        columns |= _column_specs(detail.__table__)
        for last in ("source_page", "note"):
            columns[last] = columns.pop(last)
    return TableSpec(
        name=model.__tablename__,
        title=model.title,
        model=model,
        columns=columns,
        key=model.key,
        table=model.__table__,
        detail=None if detail is None else detail.__table__,
    )


TABLES: dict[str, TableSpec] = {
    spec.name: spec
    for spec in (
        _table_spec(ServoMotor),
        _table_spec(ServoGearUnit),
        _table_spec(ServoDrive),
        _table_spec(InductionMotor, InductionMotorOperatingPoint),
        _table_spec(MotorBrake),
        _table_spec(GearUnit),
        _table_spec(Inverter),
        _table_spec(BrakingResistor),
        _table_spec(BallScrew),
        _table_spec(TimingBelt),
    )
}
"""Every product table by name, in the order in which a reader meets them."""
