"""Which products are wanted, and the same as conditions on a table."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from sqlalchemy import ColumnElement, or_

from app.catalog.schema import TableSpec

VOLTAGE_TOLERANCE = 0.1
"""A product for 380 V is found for mains of 400 V: IEC 60038 lets the supply differ by 10 % from its nominal value."""


@dataclass(frozen=True, kw_only=True)
class ProductFilter:
    """Which products are wanted; an empty condition admits all.

    A product that does not state what a condition asks for (its voltage, say) is not admitted by that condition.
    """

    manufacturers: Sequence[str] = ()
    series: Sequence[str] = ()
    editions: Sequence[str] = ()
    """Edition keys, ``maker:edition``."""
    kinds: Sequence[str] = ()
    voltage: float | None = None
    """Supply voltage [V]; the product's own must not differ by more than 10 %."""
    text: str = ""
    """Words that all occur in maker, series or order code."""


def conditions(spec: TableSpec, wanted: ProductFilter, edition_ids: Sequence[int] | None) -> list[ColumnElement[bool]]:
    """The filter as conditions on the product table; ``edition_ids`` stands for its editions (None: all)."""
    column = spec.table.c
    found: list[ColumnElement[bool]] = []
    if wanted.manufacturers:
        found.append(column.manufacturer.in_(wanted.manufacturers))
    if wanted.series:
        found.append(column.series.in_(wanted.series))
    if edition_ids is not None:
        found.append(column.edition_id.in_(edition_ids))
    if wanted.kinds and "kind" in column:
        found.append(column.kind.in_(wanted.kinds))
    if wanted.voltage is not None:
        found += _voltage_conditions(spec, wanted.voltage)
    return found + _text_conditions(column, wanted.text)


def _voltage_conditions(spec: TableSpec, voltage: float) -> list[ColumnElement[bool]]:
    """The voltage lies within the printed one or range, tolerance included; without such columns: no condition."""
    for table in (spec.table, spec.detail):
        if table is None:
            continue
        for low, high in (
            ("supply_voltage_v",) * 2,
            ("supply_voltage_min_v", "supply_voltage_max_v"),
            ("voltage_v",) * 2,
        ):
            if low in table.c:
                return [
                    table.c[low] <= voltage * (1 + VOLTAGE_TOLERANCE),
                    table.c[high] >= voltage * (1 - VOLTAGE_TOLERANCE),
                ]
    return []


def _text_conditions(column: Any, text: str) -> list[ColumnElement[bool]]:
    places = (column.manufacturer, column.series, column.model)
    return [or_(*(place.icontains(word, autoescape=True) for place in places)) for word in text.split()]
