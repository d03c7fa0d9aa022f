"""Standard tables: every shipped one in rows and columns with nothing lost, charts with all points, and the list."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.db.session import make_engine, session_factory
from app.services.errors import NotFoundError
from app.services.table_shapes import Column, Grid, grids, text_of
from app.services.tables import OTHER, TOPICS, ShownTable, TableService, by_topic

STANDARDS = Path(__file__).resolve().parents[2] / "catalog_data" / "standards"
FILES = sorted(STANDARDS.glob("*/*.json"))

texts = st.text(max_size=12)
leaves = st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | texts
anything = st.recursive(
    leaves, lambda inner: st.lists(inner, max_size=4) | st.dictionaries(texts, inner, max_size=4), max_leaves=30
)
row_lists = st.dictionaries(texts, st.lists(st.fixed_dictionaries({"a": leaves}, optional={"b": anything}), max_size=4))


@pytest.fixture
def tables(database: str) -> Iterator[TableService]:
    engine = make_engine(database)
    with session_factory(engine)() as session:
        yield TableService(session)
    engine.dispose()


def leaves_of(value: Any) -> Iterator[Any]:
    if isinstance(value, dict | list):
        for inner in value.values() if isinstance(value, dict) else value:
            yield from leaves_of(inner)
    else:
        yield value


def only(payload: Any, unit: str = "") -> Grid:
    (grid,) = grids(payload, unit)
    return grid


def labels(grid: Grid) -> list[str]:
    return [f"{one.label} [{one.unit}]" if one.unit else one.label for one in grid.columns]


def assert_rectangular(made: tuple[Grid, ...]) -> None:
    for grid in made:
        assert grid.columns
        assert all(len(row) == len(grid.columns) for row in grid.rows)
        assert all(isinstance(cell, str) for row in grid.rows for cell in row)
        assert sum(span for _, span in grid.groups) in (0, len(grid.columns))


# --- every table that is shipped --------------------------------------------------------------------------------------


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_a_shipped_table_is_shown_with_every_value(tables: TableService, file: Path):
    kept = json.loads(file.read_text(encoding="utf-8"))
    found = tables.table(file.stem)
    assert found.payload == kept["data"]
    assert found.entry.title == kept["title"]
    assert found.entry.topic != OTHER
    assert len(found.entry.note) > 60, "says what the table is for"
    assert found.grids
    assert_rectangular(found.grids)
    assert all(grid.rows for grid in found.grids)
    assert all("_" not in column.label or found.chart for grid in found.grids for column in grid.columns)
    if found.chart is None:
        assert_nothing_is_lost(found)
    else:
        assert found.chart.x
        assert found.chart.value
        assert bool(found.chart.family) == (len(found.chart.table.curves) > 1)


def assert_nothing_is_lost(found: ShownTable) -> None:
    cells = [cell for grid in found.grids for row in grid.rows for cell in row]
    heads = [column.label for grid in found.grids for column in grid.columns]
    shown = "\n".join([*cells, *heads])
    values = [value for value in leaves_of(found.payload) if value is not None]
    lost = {value for value in values if not isinstance(value, str) and text_of(value) not in shown}
    assert lost == set()
    told = {text_of(value) for value in values if isinstance(value, str)} - {""}
    named = isinstance(found.payload, dict) and "columns" in found.payload
    assert named or {text for text in told if text not in shown} == set()


def test_every_point_of_a_chart_stands_in_its_table(tables: TableService):
    found = tables.table("service_factor_f_b_class_2")
    assert found.chart is not None
    (grid,) = found.grids
    assert grid.groups == (("", 1), ("operating hours per day", 3))
    assert labels(grid) == ["Starts, brakings and speed changes per hour", "8", "16", "24"]
    # the readings of the source that the curves were drawn through: 1.2 at 10 per hour, 1.5 at 300, both 16 h a day
    rows = {row[0]: row[1:] for row in grid.rows}
    assert float(rows["10"][1]) == pytest.approx(1.2, abs=0.02)
    assert float(rows["300"][1]) == pytest.approx(1.5, abs=0.02)
    points = sum(len(points) for _, points in found.chart.table.curves)
    assert sum(cell != "–" for row in grid.rows for cell in row[1:]) == points


def test_both_sides_of_a_step_are_told_apart(tables: TableService):
    """DIN 22101 in SEW 2001, 13.1: 3 below 20 m, 2.5 at 20 m; 1.06 at 2000 m, 1.05 above."""
    (grid,) = tables.table("din_22101_c_factor").grids
    assert grid.columns == (Column("Length of the conveyor", "m", True), Column("Factor C", "", True))
    rows = dict(grid.rows)
    assert [rows[at] for at in ("below 20", "20", "2000", "above 2000")] == ["3", "2.5", "1.06", "1.05"]


# --- shapes -----------------------------------------------------------------------------------------------------------


def test_groups_with_the_same_names_stand_side_by_side():
    grid = only({"steel_steel": {"dry": [0.12, 0.6], "greased": 0.1}, "wood_steel": {"dry": 0.5}})
    assert labels(grid) == ["", "Dry", "Greased"]
    assert grid.rows == (("Steel steel", "0.12 to 0.6", "0.1"), ("Wood steel", "0.5", "–"))
    assert [column.numeric for column in grid.columns] == [False, True, True]


def test_groups_with_names_of_their_own_stand_below_each_other():
    grid = only({"S2": {"60 min": 1.1}, "S3": {"40 %": 1.15, "25 %": 1.3}, "S1": 1}, "kW")
    assert labels(grid) == ["", "", "Value [kW]"]
    assert grid.rows == (("S2", "60 min", "1.1"), ("S3", "40 %", "1.15"), ("S3", "25 %", "1.3"), ("S1", "", "1"))
    assert grid.row_headings == 2


def test_rows_keep_their_order_and_name_their_units():
    grid = only([{"P_kW": 0.75, "eff_percent": 72.1}, {"P_kW": 1.1, "note": "a_word", "limit": {"low_K": 3}}])
    assert labels(grid) == ["P [kW]", "Efficiency [%]", "Note", "Limit: Low [K]"]
    assert grid.rows == (("0.75", "72.1", "–", "–"), ("1.1", "–", "a word", "3"))


def test_columns_may_be_named_once():
    grid = only({"columns": ["adapter", "P_kW"], "data": [["AM63", 0.25], ["AM71", 0.37]]})
    assert (grid.title, labels(grid), grid.rows) == ("", ["Adapter", "P [kW]"], (("AM63", "0.25"), ("AM71", "0.37")))


def test_lists_that_begin_alike_are_joined_by_their_first_column():
    two = [{"P_kW": 3, "height_mm": [90, 100]}, {"P_kW": 4, "height_mm": [112]}]
    grid = only({"2 poles": two, "4 poles": [{"P_kW": 0.12, "height_mm": [63]}, {"P_kW": 4, "height_mm": [112]}]})
    assert grid.groups == (("", 1), ("2 poles", 1), ("4 poles", 1))
    assert labels(grid) == ["P [kW]", "Height [mm]", "Height [mm]"]
    assert grid.rows == (("0.12", "–", "63"), ("3", "90, 100", "–"), ("4", "112", "112"))


def test_values_and_lists_side_by_side_become_several_tables():
    made = grids({"coefficient_mm": {"cotton": 80}, "g": 9.81, "data": [{"d_mm": 100}]})
    assert [(grid.title, labels(grid), grid.rows) for grid in made] == [
        ("", ["", "Value"], (("g", "9.81"),)),
        ("Coefficient", ["", "Value [mm]"], (("Cotton", "80"),)),
        ("", ["d [mm]"], (("100",),)),
    ]


def test_numbers_are_shown_as_they_are_kept():
    assert [text_of(one) for one in (4.4e-05, 0.10, -3, 1234567, True, None, "", 1500.0)] == [
        "4.4·10⁻⁵", "0.1", "−3", "1234567", "yes", "–", "–", "1500",
    ]  # fmt: skip


@given(anything | row_lists)
def test_whatever_json_holds_can_be_shown(payload: Any):
    assert_rectangular(grids(payload))


def test_values_that_lie_very_deep_are_shown_as_json():
    payload: Any = 1
    for _ in range(200):
        payload = {"a": [payload]}
    made = grids(payload)
    assert_rectangular(made)
    assert '{"a":' in made[0].rows[0][-1]


# --- the list ---------------------------------------------------------------------------------------------------------


def test_the_list_is_ordered_by_topic(tables: TableService):
    found = tables.entries()
    assert sorted(one.key for one in found) == sorted(file.stem for file in FILES)
    groups = dict(by_topic(found))
    assert list(groups) == list(TOPICS)
    assert [one.title for one in groups[TOPICS[0]]] == sorted(one.title for one in groups[TOPICS[0]])


def test_words_and_topic_narrow_the_list(tables: TableService):
    assert {one.key for one in tables.entries("ROLLING friction lever")} == {"rolling_friction_arm_f_mm"}
    assert {one.topic.name for one in tables.entries(topic="brakes")} == {"brakes"}
    assert tables.entries("friction", "brakes") == []
    assert tables.entries(topic="none") == []


def test_an_unknown_table_is_not_found(tables: TableService):
    with pytest.raises(NotFoundError):
        tables.table("none")


# --- facts of SEW 2001, 2.3 to 2.6 ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("key", "row"),
    [
        ("insulation_classes", ("F", "105", "150")),
        ("degrees_of_protection", ("5", "dust, as far as it would harm", "water jets")),
        ("motor_protection", ("heavy start or reversal", "none", "limited", "complete", "limited")),
        ("motor_protection", ("bearing damage", "none", "none", "complete", "complete")),
        ("brake_contactors", ("24 V DC", "DC-3 contacts")),
        ("iec_60034_1_tolerances", ("efficiency η", "up to 50 kW", "−0.15 · (1 − η)")),
        ("motor_rating_conditions", ("Highest ambient temperature", "40 °C")),
        ("pole_changing_windings", ("4/2", "1500", "3000", "Dahlander, delta / double star")),
    ],
)
def test_a_row_of_the_source(tables: TableService, key: str, row: tuple[str, ...]):
    (grid,) = tables.table(key).grids
    assert row in grid.rows


def test_all_ten_duty_types_are_there(tables: TableService):
    (grid,) = tables.table("duty_types").grids
    assert [row[0] for row in grid.rows] == [f"S{number}" for number in range(1, 11)]
