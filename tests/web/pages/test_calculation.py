"""The page that calculates with one formula, or shows the formulas of an example."""

import re
from html import unescape
from typing import TYPE_CHECKING

import pytest

from app.engine.formula import registered

if TYPE_CHECKING:
    from starlette.testclient import TestClient

HTML = {"accept": "text/html"}


def shown(client: "TestClient", status: int = 200, **query: str) -> str:
    """The page for what was typed, without its frame."""
    answer = client.get("/calculation", params=query, headers=HTML)
    assert answer.status_code == status
    assert len(re.findall(r"<h1[ >]", answer.text)) == 1
    return answer.text.split("<main", 1)[1].split("</main>", 1)[0]


def text_of(markup: str) -> str:
    """Words of a part of a page."""
    return " ".join(unescape(re.sub(r"<[^>]+>", " ", markup)).split())


def field(page: str, name: str) -> str:
    """The entry of an argument."""
    found = re.search(rf'<div class="field[^"]*" data-field="{name}".*?<div class="notes">.*?</div>', page, re.S)
    assert found is not None, f"no entry for {name}"
    return found[0]


def typed(page: str) -> dict[str, str]:
    """What stands in the entries."""
    return {name: unescape(value) for name, value in re.findall(r'<input[^>]* name="(\w+)" value="([^"]*)"', page)}


def errors(page: str) -> dict[str, str]:
    """Error of each entry that has one."""
    entries = {name: field(page, name) for name in re.findall(r'data-field="(\w+)"', page)}
    found = {name: re.search(r'<p class="error"[^>]*>(.*?)</p>', entry, re.S) for name, entry in entries.items()}
    for name, entry in entries.items():
        assert ('aria-invalid="true"' in entry) == (found[name] is not None)
    return {name: text_of(error[1]).removeprefix("Error: ") for name, error in found.items() if error is not None}


def result(page: str) -> str:
    """The result of the only step."""
    (found,) = re.findall(r'<span class="step-result">(.*?)</span>', page, re.S)
    return text_of(found)


def test_a_formula_of_the_book_leads_to_its_arguments(client: "TestClient") -> None:
    link = re.search(r'href="(/calculation\?formula=rated_torque)"', client.get("/formulas").text)
    assert link is not None
    page = shown(client, formula="rated_torque")
    assert "Rated torque of a motor" in text_of(page)
    assert typed(page) == {"formula": "rated_torque", "P_N": "", "n_N": ""}
    assert "Rated power" in text_of(field(page, "P_N"))
    assert 'class="step-result"' not in page
    assert errors(page) == {}


def test_numbers_with_units_give_the_result_of_the_hand_calculation(client: "TestClient") -> None:
    """1.5 kW over 1500 rpm: 1500 W / (50 pi rad/s) = 9.5493 N m."""
    page = shown(client, formula="rated_torque", P_N="1.5 kW", n_N="1500 rpm")
    assert result(page).endswith("= 9.5493 N·m")
    assert typed(page) == {"formula": "rated_torque", "P_N": "1.5 kW", "n_N": "1500 rpm"}
    assert "1500 W" in text_of(page)
    assert "157.08 rad/s" in text_of(page)


@pytest.mark.parametrize(
    ("formula", "values", "expected"),
    [
        # bare numbers are SI: 0.5 m/s2 * 2 s
        ("speed_after", {"a": "0.5", "t": "2"}, "1 m/s"),
        # 500 mm/s2 * 1/30 min
        ("speed_after", {"a": "500 mm/s2", "t": "0,5 min"}, "15 m/s"),
        # 100 kg * 9.81 m/s2 * cos 60 deg
        ("normal_force", {"m": "0.1 t", "g": "9.81", "alpha": "60 deg"}, "490.5 N"),
        # 1.5 A + 500 mA + 3 A
        ("sum_of_currents", {"I_k": "1.5; 500 mA ;3"}, "5 A"),
        # 80 degC - 20 K
        ("permitted_ambient", {"theta_2": "80 degC", "d_theta": "20"}, "60 °C"),
    ],
)
def test_a_number_may_carry_its_unit(client: "TestClient", formula: str, values: dict[str, str], expected: str) -> None:
    assert result(shown(client, formula=formula, **values)).rpartition("= ")[2] == expected


@pytest.mark.parametrize(
    ("value", "words"),
    [
        ("1.5 kg", "'kg' does not measure the same thing as 'W'"),
        ("much", "'much' is not a number"),
        ("5 unicorns", "unicorns"),
        ("NaN", "is not a number"),
        ("1e400", "is not a finite number"),
        ("1 kW; 2 mm", "'mm' does not measure the same thing as 'W'"),
        ("=speed", "'speed' is the name of no earlier step"),
        ('"><script>', "is not a number"),
    ],
)
def test_a_bad_value_is_told_at_its_entry_and_kept(client: "TestClient", value: str, words: str) -> None:
    page = shown(client, 422, formula="rated_torque", P_N=value, n_N="1500 rpm")
    assert typed(page) == {"formula": "rated_torque", "P_N": value, "n_N": "1500 rpm"}
    found = errors(page)
    assert list(found) == ["P_N"]
    assert words in found["P_N"]
    assert "<script>" not in page
    assert 'class="step-result"' not in page


@pytest.mark.parametrize("value", ["1;2", "1 kW; 2 kW; 3 kW"])
def test_several_values_for_a_single_number_are_told_and_kept(client: "TestClient", value: str) -> None:
    page = shown(client, 422, formula="rated_torque", P_N=value, n_N="1500 rpm")
    assert typed(page)["P_N"] == value
    assert errors(page)


def test_a_long_text_is_refused_in_words_that_fit(client: "TestClient") -> None:
    found = errors(shown(client, 422, formula="rated_torque", P_N="much " * 13, n_N="1500 rpm"))
    assert list(found) == ["P_N"]
    assert "list" not in found["P_N"]


def test_every_bad_entry_is_told(client: "TestClient") -> None:
    found = errors(shown(client, 422, formula="normal_force", m="100 N", alpha="60 deg"))
    assert set(found) == {"m", "g"}
    assert found["g"] == "is needed, in m/s2"


def test_what_cannot_be_computed_is_told_with_its_numbers(client: "TestClient") -> None:
    page = shown(client, 422, formula="rated_torque", P_N="1 kW", n_N="0")
    assert "n_N = 0" in " ".join(errors(page).values())
    assert typed(page)["P_N"] == "1 kW"


@pytest.mark.parametrize(
    ("query", "words"),
    [
        ({"formula": "perpetuum_mobile"}, "There is no formula 'perpetuum_mobile' in the formula book."),
        ({"formula": "<b>"}, "There is no formula '<b>' in the formula book."),
        ({}, "There is no formula"),
        ({"example": "none", "request": "main"}, "none"),
        ({"example": "sew-05-variable-speed-gear", "request": "none"}, "The example has no calculation 'none'."),
        # an axis, not a calculation
        ({"example": "tr-ball-screw", "request": "main"}, "The example has no calculation 'main'."),
    ],
)
def test_what_is_not_there_is_told(client: "TestClient", query: dict[str, str], words: str) -> None:
    page = shown(client, 404, **query)
    assert words in text_of(page)
    assert "<b>" not in page
    assert "<form" not in page


def test_the_calculation_of_an_example_is_shown(client: "TestClient") -> None:
    """2.2 kW at 3000 rpm: 7.0028 N m (SEW 2001, 5.1); back leads to the example."""
    page = shown(client, example="sew-05-variable-speed-gear", request="main")
    assert "= 7.0028 N·m" in text_of(page)
    assert 'href="/examples/sew-05-variable-speed-gear"' in page
    link = 'href="/calculation?example=sew-05-variable-speed-gear&amp;request=main"'
    assert link in client.get("/examples/sew-05-variable-speed-gear").text


def test_every_formula_of_the_book_asks_for_all_its_arguments(client: "TestClient") -> None:
    import app.engine.formulas  # noqa: F401  registers every formula

    for name, formula in registered().items():
        assert set(typed(shown(client, formula=name))) == {"formula", *formula.parameters}, name
