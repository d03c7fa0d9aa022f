"""The record of a calculation: order, keys, assumptions, verdicts, and no value that is none."""

import math
from typing import Annotated

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.engine.errors import RangeError
from app.engine.formula import Formula, sqrt, total
from app.engine.quantity import Declared, Option, Quantity
from app.engine.sheet import Sheet, Verdict, utilisation, verdict
from app.engine.units import Metre, MetrePerSecond, Newton, NewtonMetre, One, Second


def _lever(F: Newton, r: Metre) -> NewtonMetre:
    """Torque of a force on a lever."""
    return F * r


def _speed(s: Metre, t: Second) -> MetrePerSecond:
    """Mean speed."""
    return s / t


def _root(x: One) -> One:
    """Square root."""
    return sqrt(x)


def _sum(x_k: One) -> One:
    """Sum."""
    return total(x_k)


lever = Formula(_lever, "M", "N cm", "test")
speed = Formula(_speed, "v", "m/min", "test")
root = Formula(_root, "y", "1", "test")
total_of = Formula(_sum, "y", "1", "test")


def test_a_step_records_what_was_computed() -> None:
    sheet = Sheet()
    with sheet.section("Statics"):
        assert sheet(lever, F=3.0, r=0.5) == 1.5
    (step,) = sheet.steps
    assert (step.key, step.section, step.label, step.symbol, step.unit) == (
        "_lever", "Statics", "Torque of a force on a lever.", "M", "N cm",
    )  # fmt: skip
    assert (step.inputs, step.value, step.shown_value) == ({"F": 3.0, "r": 0.5}, 1.5, 150.0)
    assert step.formula is lever


def test_one_formula_may_serve_several_quantities() -> None:
    sheet = Sheet()
    sheet(lever, key="front", symbol="M_f", label="front wheel", unit="N m", F=1.0, r=1.0)
    (step,) = sheet.steps
    assert (step.key, step.symbol, step.label, step.unit, step.shown_value) == (
        "front", "M_f", "front wheel", "N m", 1.0,
    )  # fmt: skip


def test_keys_are_unique() -> None:
    sheet = Sheet()
    for force in (1.0, 2.0, 3.0):
        sheet(lever, F=force, r=1.0)
    sheet(lever, key="_lever#2", F=4.0, r=1.0)
    assert [step.key for step in sheet.steps] == ["_lever", "_lever#2", "_lever#3", "_lever#2#2"]
    assert [sheet.value(step.key) for step in sheet.steps] == [1.0, 2.0, 3.0, 4.0]


def test_checks_have_unique_keys_too() -> None:
    sheet = Sheet()
    assert [sheet.check("peak", "Peak", 1.0, 2.0, "N m", "").key for _ in range(3)] == ["peak", "peak#2", "peak#3"]


def test_a_value_is_found_by_its_key() -> None:
    sheet = Sheet()
    sheet(lever, key="front", F=1.0, r=2.0)
    assert sheet.value("front") == 2.0
    assert sheet.has("front")
    assert not sheet.has("back")
    with pytest.raises(KeyError):
        sheet.value("back")


@pytest.mark.parametrize(
    ("formula", "values"),
    [
        (speed, {"s": 1.0, "t": 0.0}),
        (speed, {"s": 0.0, "t": 0.0}),
        (speed, {"s": math.nan, "t": 1.0}),
        (speed, {"s": math.inf, "t": 1.0}),
        (root, {"x": -1.0}),
        (lever, {"F": 1e308, "r": 1e308}),
        (total_of, {"x_k": [1.0, math.nan]}),
    ],
)  # fmt: skip
def test_a_result_that_is_no_finite_number_is_refused(formula: Formula[..., float], values: dict[str, float]) -> None:
    sheet = Sheet()
    with pytest.raises(RangeError, match="cannot be computed from"):
        sheet(formula, **values)
    assert sheet.steps == []


def test_an_argument_that_is_missing_is_a_mistake_of_the_program() -> None:
    with pytest.raises(TypeError):
        Sheet()(lever, F=1.0)


def test_sections_may_be_nested_and_end_with_an_error_too() -> None:
    sheet = Sheet()
    with sheet.section("outer"):
        with pytest.raises(RangeError), sheet.section("inner"):
            sheet(root, x=-1.0)
        sheet(root, x=1.0)
        with sheet.section("inner"):
            sheet.decide("a", "b")
            sheet.check("c", "c", 1.0, 2.0, "N", "")
    sheet(root, x=4.0)
    assert [step.section for step in sheet.steps] == ["outer", ""]
    assert (sheet.decisions[0].section, sheet.checks[0].section) == ("inner", "inner")


def test_a_decision_knows_where_it_stands() -> None:
    sheet = Sheet()
    sheet.decide("first", "")
    sheet(root, x=1.0)
    sheet.decide("second", "because")
    assert [(d.text, d.reason, d.position) for d in sheet.decisions] == [("first", "", 0), ("second", "because", 1)]


def test_an_assumption_is_recorded_once() -> None:
    sheet = Sheet()
    sheet.assume("g", "gravity", value=9.81, unit="m/s2", symbol="g", source="DIN 1305")
    sheet.assume("g", "gravity once more", value=9.8)
    (kept,) = sheet.assumptions
    assert (kept.text, kept.value, kept.unit, kept.symbol, kept.source) == ("gravity", 9.81, "m/s2", "g", "DIN 1305")


class Guide(Declared):
    friction: Annotated[float, Quantity("1", symbol="mu", ge=0, default=0.1, about="friction", source="handbook")]


class Axis(Declared):
    mass: Annotated[float, Quantity("kg", gt=0)]
    lead: Annotated[float, Quantity("mm", symbol="p", gt=0, default=0.01, about="lead", source="usual")]
    mounting: Annotated[str, Option(about="mounting", default="fixed_free")]
    note: Annotated[str, Option(about="note", default="")]
    guide: Guide = Guide()
    guides: tuple[Guide, ...] = ()


def test_every_default_that_was_taken_is_an_assumption_nested_ones_too() -> None:
    sheet = Sheet()
    sheet.assume_defaults(Axis.model_validate({"mass_kg": 5, "guides": [{"friction": 0.1}, {}]}), "mechanism.")
    assert {item.key: (item.text, item.value, item.unit, item.source) for item in sheet.assumptions} == {
        "mechanism.lead_mm": ("lead", 0.01, "mm", "usual"),
        "mechanism.mounting": ("mounting", "fixed_free", "1", ""),
        "mechanism.guide.friction": ("friction", 0.1, "1", "handbook"),
        "mechanism.guides.1.friction": ("friction", 0.1, "1", "handbook"),
    }


def test_a_confirmed_default_is_no_assumption() -> None:
    sheet = Sheet()
    sheet.assume_defaults(Axis.model_validate({"mass_kg": 5, "lead_mm": 10, "mounting": "fixed_free",
                                               "guide": {"friction": 0.1}}))  # fmt: skip
    assert sheet.assumptions == []


@pytest.mark.parametrize(
    ("used", "expected"),
    [
        (0.0, Verdict.OK),
        (0.8, Verdict.OK),
        (0.8000001, Verdict.TIGHT),
        (1.0, Verdict.TIGHT),
        (1.0 + 1e-12, Verdict.TIGHT),  # noise of the arithmetic
        (1.0 + 1e-8, Verdict.FAILS),
        (math.inf, Verdict.FAILS),
        (None, Verdict.NOT_CHECKED),
    ],
)
def test_a_verdict_changes_at_its_border(used: float | None, expected: Verdict) -> None:
    assert verdict(used) is expected


@pytest.mark.parametrize(
    ("demanded", "permitted", "used"),
    [
        (5.0, 10.0, 0.5),
        (10.0, 10.0, 1.0),
        (0.0, 10.0, 0.0),
        (0.0, 0.0, 0.0),
        (-3.0, 10.0, 0.0),
        (1.0, 0.0, math.inf),
        (1.0, -5.0, math.inf),
        (0.0, -5.0, math.inf),  # not even standing still is permitted
        (-6.0, -5.0, 0.0),
        (1.0, math.inf, 0.0),
        (math.inf, 1.0, math.inf),
    ],
)
def test_utilisation_at_the_edges(demanded: float, permitted: float, used: float) -> None:
    assert utilisation(demanded, permitted) == used


@given(st.floats(-1e6, 1e6), st.floats(-1e6, 1e6))
def test_a_check_holds_exactly_when_the_demand_is_within_the_limit(demanded: float, permitted: float) -> None:
    check = Sheet().check("key", "name", demanded, permitted, "N", "")
    near = math.isclose(demanded, permitted, rel_tol=1e-8)
    assert near or (check.verdict in (Verdict.OK, Verdict.TIGHT)) == (demanded <= permitted)


@pytest.mark.parametrize(("demanded", "permitted"), [(None, 1.0), (1.0, None), (None, None)])
def test_what_is_not_known_is_not_checked(demanded: float | None, permitted: float | None) -> None:
    sheet = Sheet()
    check = sheet.check("key", "name", demanded, permitted, "N", "", missing="rated force")
    assert (check.utilisation, check.verdict, check.missing) == (None, Verdict.NOT_CHECKED, "rated force")
    with pytest.raises(ValueError, match="say what is missing"):
        sheet.check("other", "name", demanded, permitted, "N", "")


@pytest.mark.parametrize(("demanded", "permitted"), [(math.nan, 1.0), (1.0, math.nan), (math.nan, None)])
def test_nan_is_no_demand_and_no_limit(demanded: float, permitted: float | None) -> None:
    sheet = Sheet()
    with pytest.raises(RangeError):
        sheet.check("key", "Peak torque", demanded, permitted, "N m", "", missing="x")
    assert sheet.checks == []


def test_two_sheets_know_nothing_of_each_other() -> None:
    first, second = Sheet(), Sheet()
    first(root, x=4.0)
    first.assume("a", "a")
    assert second == Sheet()
