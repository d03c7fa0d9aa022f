"""The declaration of the tables, held to itself and to the engine's records."""

import dataclasses
import doctest
from types import ModuleType

import pytest

from app.catalog import names
from app.catalog.checks import RULES, Order
from app.catalog.records import FIELDS
from app.catalog.schema import TABLES, UNIT_KINDS, ColumnSpec
from app.db import columns
from app.db.columns import column_suffix
from app.engine.products import GearUnit
from app.engine.quantity import si_factor

COLUMNS = [
    pytest.param(spec, id=f"{table.name}.{spec.name}") for table in TABLES.values() for spec in table.columns.values()
]


@pytest.mark.parametrize("spec", COLUMNS)
def test_a_column_says_what_it_holds(spec: ColumnSpec):
    assert spec.name.endswith(column_suffix(spec.unit))
    assert spec.meaning.label
    if spec.type == "number":
        assert spec.unit == "1" or any(spec.unit in units for units in UNIT_KINDS.values())
        assert spec.meaning.low < spec.meaning.high
    if spec.type == "text":
        assert spec.max_length
        assert all(len(choice) <= spec.max_length for choice in spec.meaning.choices)


@pytest.mark.parametrize("kind", UNIT_KINDS)
def test_units_of_one_kind_convert_into_each_other_and_have_names_of_their_own(kind: str):
    assert all(si_factor(unit)[0] > 0 and si_factor(unit)[1] == 0 for unit in UNIT_KINDS[kind])
    others = {column_suffix(unit) for other, units in UNIT_KINDS.items() if other != kind for unit in units}
    mine = [column_suffix(unit) for unit in UNIT_KINDS[kind]]
    assert len(set(mine)) == len(mine)
    assert not others & set(mine)


def test_every_rule_names_columns_of_its_table():
    for table, rules in RULES.items():
        for rule in rules:
            names = [rule.larger, rule.smaller] if isinstance(rule, Order) else []
            assert set(names) <= set(TABLES[table].columns)


def test_every_field_of_an_engine_record_has_its_column():
    shared = {"id", "manufacturer", "series", "model", "source", "note", "peak_curve", "continuous_curve"}
    shared |= {"windings", "ratings"}  # from operating points, from several columns
    for record, (table, fields) in FIELDS.items():
        typed_only = {"backlash"} if record is GearUnit else set()
        assert set(fields) == {field.name for field in dataclasses.fields(record)} - shared - typed_only
        assert set(fields.values()) <= set(TABLES[table].columns)


@pytest.mark.parametrize("module", [names, columns])
def test_examples_in_the_documentation_hold(module: ModuleType):
    result = doctest.testmod(module)
    assert result.attempted > 0
    assert result.failed == 0
