"""Calculations with formulas of the book: numbers by hand, and every refusal at its field."""

import math
from typing import Any

import pytest

from app.services.calculation import MAX_STEPS, Calculation, CalculationService
from app.services.errors import InvalidInputError

RATED: dict[str, Any] = {"formula": "rated_torque", "values": {"P_N": "0.55 kW", "n_N": "2700 rpm"}}
RUN_UP: dict[str, Any] = {"formula": "run_up_torque", "values": {"r_H": 1.9, "M_N": "=rated_torque"}}


def run(*steps: dict[str, Any], **more: Any) -> Calculation:
    return CalculationService().calculate({"calculation": list(steps), **more})


def refusals(*steps: dict[str, Any]) -> list[tuple[str, str, Any]]:
    with pytest.raises(InvalidInputError) as caught:
        run(*steps)
    return [(error.name, error.message, error.value) for error in caught.value.errors]


def step(formula: str, **values: Any) -> dict[str, Any]:
    return {"formula": formula, "values": values}


# --- numbers ----------------------------------------------------------------------------------------------------------


def test_a_later_step_uses_the_result_of_an_earlier_one():
    """SEW 2001, 8.1, recomputed: 0.55 kW at 2700 rpm are 1.945227 N m; 1.9 times that to run up."""
    found = run(RATED, RUN_UP, name="motor")
    assert found.sheet.value("rated_torque") == pytest.approx(1.945227082)
    assert found.sheet.value("run_up_torque") == pytest.approx(3.695931456)
    assert found.asked.name == "motor"
    assert [(one.key, one.unit) for one in found.sheet.steps] == [("rated_torque", "N m"), ("run_up_torque", "N m")]


def test_the_same_formula_twice_under_two_names():
    """0.3 m/s and 0.6 m/s on a radius of 125 mm."""
    steps = [
        {**step("shaft_speed", v="0.3 m/s", A=0.125), "key": "slow"},
        {**step("shaft_speed", v="36 m/min", A=0.125), "key": "fast"},
        step("speed_range", n_2="=fast", n_1="=slow"),
    ]
    sheet = run(*steps).sheet
    assert (sheet.value("slow"), sheet.value("fast")) == (pytest.approx(2.4), pytest.approx(4.8))
    assert sheet.value("speed_range") == pytest.approx(2)


def test_a_list_may_hold_numbers_texts_and_results():
    """1 s + 500 ms + 2.4 s."""
    steps = [step("slowing_time", v=1.2, v_P=0, a=0.5), step("sum_of_times", t_k=[1, "500 ms", "=slowing_time"])]
    assert run(*steps).sheet.value("sum_of_times") == pytest.approx(3.9)


@pytest.mark.parametrize("given", [550, 550.0, "550", "550 W", "0.55 kW", "0,55 kW"])
def test_a_number_is_si_and_a_text_carries_its_unit(given: Any):
    found = run(step("rated_torque", P_N=given, n_N="100 rad/s"))
    assert found.sheet.value("rated_torque") == pytest.approx(5.5)
    assert found.raw["calculation"][0]["values"]["P_N"] == given


def test_a_temperature_is_no_difference_of_temperatures():
    """80 degrees less 24 K: 56 degrees."""
    found = run(step("permitted_ambient", theta_2="80 degC", d_theta=24))
    assert found.sheet.steps[0].shown_value == pytest.approx(56)


def test_mixed_duty_of_the_handbook():
    """SEW 2001, 8.3, recomputed: two starts of 49/h, one of 402/h, one of 181/h: 20.4797 cycles per hour."""
    rates = [f"{rate} 1/h" for rate in (49, 402, 181)]
    found = run(step("permissible_cycles", z_k=[2, 1, 1], Z_k=rates)).sheet.value("permissible_cycles")
    assert found * 3600 == pytest.approx(20.47973761)


def test_every_step_shows_its_formula_and_numbers():
    (made,) = run(RATED).sheet.steps
    assert made.formula.name == "rated_torque"
    assert made.inputs == {"P_N": pytest.approx(550), "n_N": pytest.approx(90 * math.pi)}


# --- refusals ---------------------------------------------------------------------------------------------------------

AT = "calculation.1"


@pytest.mark.parametrize(
    ("second", "name", "message"),
    [
        (step("rated_tork", P_N=1), f"{AT}.formula", "is not in the formula book"),
        (RATED, f"{AT}.key", "names another step already"),
        ({**step("synchronous_speed", f_1=50, z_p=4), "key": "rated_torque"}, f"{AT}.key", "names another step"),
        (step("run_up_torque", r_H=1.9), f"{AT}.values.M_N", "is needed, in N m"),
        (step("run_up_torque", r_H=1, M_N=1, M_K=1), f"{AT}.values.M_K", "is no argument; there are r_H, M_N"),
        (step("run_up_torque", r_H=1, M_N="=M"), f"{AT}.values.M_N", "'M' is the name of no earlier step"),
        (step("run_up_torque", r_H=1, M_N="=run_up_torque"), f"{AT}.values.M_N", "'run_up_torque' is the name of no"),
        (step("run_up_torque", r_H=1, M_N="5 kg"), f"{AT}.values.M_N", "'kg' does not measure the same thing"),
        (step("run_up_torque", r_H=1, M_N="much"), f"{AT}.values.M_N", "'much' is not a number"),
        (step("run_up_torque", r_H=1, M_N="nan"), f"{AT}.values.M_N", "'nan' is not a number"),
        (step("run_up_torque", r_H=1, M_N=math.inf), f"{AT}.values.M_N", "is not a finite number"),
        (step("sum_of_times", t_k=[1, "later"]), f"{AT}.values.t_k", "'later' is not a number"),
        (step("braking_deceleration", v=1, t_B=0), f"{AT}.values", "Mean deceleration while the brake acts"),
        (step("highest_frequency_of_rated_power", f_1=1e300, r_K=1e300, k_K=1), f"{AT}.values", "Frequency"),
        ({"formula": "rated_torque"}, f"{AT}.values", "is missing"),
        ({"values": {}}, f"{AT}.formula", "is missing"),
        ({**RUN_UP, "unit": "N m"}, f"{AT}.unit", "is not known here"),
        ({**RUN_UP, "key": "x" * 101}, f"{AT}.key", "must have at most 100 characters"),
        ({**RUN_UP, "values": [1.9, 2]}, f"{AT}.values", "must be an object with named values"),
        ("run_up_torque", AT, "must be an object with named values"),
    ],
)  # fmt: skip
def test_a_wrong_step_is_refused_at_its_place(second: Any, name: str, message: str):
    ((found, told, _),) = refusals(RATED, second)
    assert found == name
    assert told.startswith(message)


def test_every_wrong_value_of_a_step_is_told_at_once():
    found = refusals(step("braking_time", J_tot="heavy", omega="5 m", M_B=1, M_K=2))
    assert {name.rsplit(".", 1)[1] for name, _, _ in found} == {"J_tot", "omega", "M_L", "M_K"}
    assert {value for _, _, value in found} == {"heavy", "5 m", None, 2}


@pytest.mark.parametrize("given", [None, {}, [[1]], "", "x" * 61])
def test_what_is_no_value_at_all_is_refused_there(given: Any):
    found = refusals(step("run_up_torque", r_H=1, M_N=given))
    assert {name.removesuffix(".0") for name, _, _ in found} == {"calculation.0.values.M_N"}


@pytest.mark.parametrize(
    ("raw", "name", "message"),
    [
        (None, "", "must be an object with named values"),
        ({}, "calculation", "is missing"),
        ({"calculation": []}, "calculation", "must have at least 1 entries"),
        ({"calculation": [RATED] * (MAX_STEPS + 1)}, "calculation", "must have at most 200 entries"),
        ({"calculation": [RATED], "name": "x" * 201}, "name", "must have at most 200 characters"),
        ({"calculation": [RATED], "title": "x"}, "title", "is not known here"),
    ],
)
def test_a_wrong_request_is_refused_at_its_place(raw: Any, name: str, message: str):
    with pytest.raises(InvalidInputError) as caught:
        CalculationService().calculate(raw)
    (error,) = caught.value.errors
    assert error.name == name
    assert error.message.startswith(message)


@pytest.mark.parametrize(
    "wrong",
    [
        step("rated_torque", P_N=[550, 750], n_N=100),  # a list where one number belongs
        step("rated_torque", P_N=[550], n_N=100),
        step("permissible_cycles", z_k=[1, 1, 1], Z_k=[1, 2]),  # lists of different lengths
    ],
)
def test_lists_that_do_not_fit_are_refused(wrong: dict[str, Any]):
    assert all(name.startswith("calculation.0.values") for name, _, _ in refusals(wrong))
