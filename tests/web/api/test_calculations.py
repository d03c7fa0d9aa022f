"""Formulas over REST: numbers of a hand calculation, results used further, and the path of each refused value."""

from typing import Any

import pytest
from starlette.testclient import TestClient

from app.web.api.models import CalculationAnswer
from app.web.errors import Problem

ADDRESS = "/api/v1/calculations"
WEIGHT = {"formula": "normal_force", "values": {"m": "100000 g", "g": 9.81, "alpha": "60 deg"}}
FRICTION = {"formula": "sliding_friction", "values": {"mu": "20 %", "F_N": "=normal_force"}}


def calculate(client: TestClient, *steps: dict[str, Any]) -> dict[str, dict[str, Any]]:
    """The steps of an accepted calculation by their keys."""
    response = client.post(ADDRESS, json={"calculation": list(steps)})
    assert response.status_code == 200, response.text
    return {step["key"]: step for step in response.json()["steps"]}


def refused(client: TestClient, body: Any) -> dict[tuple[str | int, ...], str]:
    """What is said about each refused value, by its path."""
    response = client.post(ADDRESS, json=body)
    assert response.status_code == 422, response.text
    assert response.headers["content-type"] == "application/problem+json"
    found = Problem.model_validate_json(response.content)
    assert [error.name for error in found.errors] == [".".join(map(str, error.path)) for error in found.errors]
    return {tuple(error.path): error.message for error in found.errors}


def with_value(name: str, value: Any) -> dict[str, Any]:
    """The weight calculation with one argument replaced."""
    return {"calculation": [{**WEIGHT, "values": {**WEIGHT["values"], name: value}}]}  # type: ignore[dict-item]


def test_a_later_step_uses_the_result_of_an_earlier_one(client: TestClient):
    """100 kg * 9.81 m/s2 * cos 60 deg = 490.5 N; a fifth of it is 98.1 N."""
    steps = calculate(client, WEIGHT, {**FRICTION, "key": "friction"})
    assert list(steps) == ["normal_force", "friction"]
    assert (steps["normal_force"]["value"], steps["normal_force"]["unit"]) == (490.5, "N")
    assert (steps["friction"]["value"], steps["friction"]["formula"]) == (98.1, "sliding_friction")
    assert steps["friction"]["inputs"] == {"mu": 0.2, "F_N": pytest.approx(490.5, rel=1e-12)}
    assert steps["friction"]["source"].startswith("SEW 2001")


def test_a_result_is_shown_in_the_unit_of_its_formula(client: TestClient):
    """0.5 m over 0.125 m/rad are 4 rad: 229.183... degrees; 90 W of 0.1 kW are 90 %."""
    steps = calculate(
        client,
        {"formula": "angle_of_way", "values": {"s": "50 cm", "A": "125 mm/rad"}},
        {"formula": "power_share", "values": {"P": 90, "P_T": "0,1 kW"}},
    )
    assert steps["angle_of_way"]["value_si"] == pytest.approx(4, rel=1e-12)
    assert (steps["angle_of_way"]["value"], steps["angle_of_way"]["unit"]) == (229.183118052, "deg")
    assert (steps["power_share"]["value"], steps["power_share"]["unit"]) == (90, "%")


def test_several_values_of_one_argument_and_earlier_results_among_them(client: TestClient):
    """1.5 A + 500 mA = 2 A; 2 A + 250 mA = 2.25 A."""
    first = {"formula": "sum_of_currents", "values": {"I_k": [1.5, "500 mA"]}}
    second = {"formula": "sum_of_currents", "key": "all", "values": {"I_k": ["=sum_of_currents", "250 mA"]}}
    steps = calculate(client, first, second)
    assert [step["value"] for step in steps.values()] == [2, 2.25]


def test_the_answer_has_the_documented_shape(client: TestClient):
    response = client.post(ADDRESS, json={"name": "Friction", "calculation": [WEIGHT, FRICTION]})
    answer = CalculationAnswer.model_validate_json(response.content, strict=True)
    assert set(response.json()) == set(CalculationAnswer.model_fields)
    assert [step.key for step in answer.steps] == ["normal_force", "sliding_friction"]


@pytest.mark.parametrize(
    ("value", "words"),
    [
        ("100 N", "'N' does not measure the same thing as 'kg'"),
        ("heavy", "'heavy' is not a number"),
        ("1e400", "is not a finite number"),
        ("NaN", "is not a number"),
        ("5 unicorns", "unicorns"),
        ("=later", "'later' is the name of no earlier step"),
        (["1 kg", "1 mm"], "'mm' does not measure the same thing as 'kg'"),
    ],
    ids=str,
)
def test_a_bad_value_is_refused_at_its_argument(client: TestClient, value: Any, words: str):
    errors = refused(client, with_value("m", value))
    assert list(errors) == [("calculation", 0, "values", "m")]
    assert words in errors["calculation", 0, "values", "m"]


@pytest.mark.parametrize("value", [None, {}, "", True, "9" * 61 + " kg"], ids=lambda value: str(value)[:10])
def test_what_is_no_value_is_refused_at_its_argument(client: TestClient, value: Any):
    assert set(refused(client, with_value("m", value))) == {("calculation", 0, "values", "m")}


@pytest.mark.parametrize(
    ("formula", "values"),
    [
        ("sliding_friction", {"mu": [0.1, 0.2], "F_N": 5}),  # one number would be wanted
        ("permissible_cycles", {"z_k": [1, 2, 3], "Z_k": [4, 5]}),  # as many of one as of the other
    ],
)
def test_more_values_than_a_formula_takes_are_refused(client: TestClient, formula: str, values: dict[str, Any]):
    errors = refused(client, {"calculation": [{"formula": formula, "values": values}]})
    assert {path[:3] for path in errors} == {("calculation", 0, "values")}


def test_every_wrong_argument_is_told_at_once(client: TestClient):
    errors = refused(
        client, {"calculation": [WEIGHT, {"formula": "sliding_friction", "values": {"mu": 0.1, "F_G": 5}}]}
    )
    assert set(errors) == {("calculation", 1, "values", "F_N"), ("calculation", 1, "values", "F_G")}
    assert errors["calculation", 1, "values", "F_N"] == "is needed, in N"
    assert "there are mu, F_N" in errors["calculation", 1, "values", "F_G"]


def test_what_cannot_be_computed_is_told_with_its_numbers(client: TestClient):
    step = {"formula": "rated_torque", "values": {"P_N": "1.5 kW", "n_N": 0}}
    errors = refused(client, {"calculation": [step]})
    assert list(errors) == [("calculation", 0, "values")]
    assert "P_N = 1500.0, n_N = 0.0" in errors["calculation", 0, "values"]


@pytest.mark.parametrize(
    ("body", "path", "words"),
    [
        ({"calculation": [WEIGHT, {**FRICTION, "formula": "none"}]}, ("calculation", 1, "formula"), "formula book"),
        ({"calculation": [WEIGHT, WEIGHT]}, ("calculation", 1, "key"), "names another step already"),
        ({"calculation": [FRICTION, WEIGHT]}, ("calculation", 0, "values", "F_N"), "no earlier step"),
        ({"calculation": [{"formula": "normal_force"}]}, ("calculation", 0, "values"), "is missing"),
        ({"calculation": [{**WEIGHT, "kee": "x"}]}, ("calculation", 0, "kee"), "did you mean key?"),
        ({"calculation": []}, ("calculation",), "at least 1"),
        ({"calculation": [WEIGHT] * 201}, ("calculation",), "at most 200"),
        ({}, ("calculation",), "is missing"),
        ([], (), "must be an object"),
    ],
    ids=lambda value: ".".join(map(str, value)) if isinstance(value, tuple) else "",
)
def test_a_bad_step_is_refused_at_its_place(client: TestClient, body: Any, path: tuple[str | int, ...], words: str):
    errors = refused(client, body)
    assert list(errors) == [path]
    assert words in errors[path]


def test_the_calculation_of_an_example_gives_its_printed_numbers(client: TestClient):
    """2.2 kW at 3000 rpm: 2200 / (100 pi) = 7.0028 N m; 20 N m at 500 rpm: 1047.2 W (SEW 2001, 5.1)."""
    example = client.get("/api/v1/examples/sew-05-variable-speed-gear").json()
    steps = calculate(client, *example["requests"]["main"]["calculation"])
    assert steps["torque_constant_torque_law"]["value"] == pytest.approx(7.00281749604, rel=1e-11)
    assert steps["power_constant_power_law"]["value_si"] == pytest.approx(1047.19755119660, rel=1e-12)


def test_a_kept_answer_is_the_same_and_a_refusal_is_not_kept(client: TestClient):
    body = {"calculation": [WEIGHT, FRICTION]}
    assert client.post(ADDRESS, json=body).content == client.post(ADDRESS, json=body).content
    first, again = (refused(client, {"calculation": [FRICTION]}) for _ in range(2))
    assert first == again == {("calculation", 0, "values", "F_N"): "'normal_force' is the name of no earlier step"}
