"""The pages of several axes on one supply: numbers of the hand calculation in ``tests.supply_requests``."""

import re
from html import unescape
from typing import TYPE_CHECKING, Any

import pytest

from tests.supply_requests import MAINS_AXIS, SERVO_AXIS, project

if TYPE_CHECKING:
    from starlette.testclient import TestClient

HTML = {"accept": "text/html"}
EXAMPLE = {"example": "sew-16-gantry-electronics", "request": "main"}
MODULES = {f"axes.{number}.module.rated_current_a": "4" for number in range(2)}
NO_SERVO = "There is no servo axis yet."


def text_of(markup: str) -> str:
    """Words of a part of a page."""
    return " ".join(unescape(re.sub(r"<script.*?</script>|<[^>]+>", " ", markup, flags=re.S)).split())


def shown(client: "TestClient", address: str, status: int = 200, **typed: str) -> str:
    """The page for what was typed, without its frame."""
    answer = client.get(address, params=typed, headers=HTML)
    assert answer.status_code == status
    assert len(re.findall(r"<h1[ >]", answer.text)) == 1
    return answer.text.split("<main", 1)[1].split("</main>", 1)[0]


def entries(page: str) -> dict[str, str]:
    """What the form sends while nothing is typed."""
    form = page.split('<form action="', 1)[1].split("</form>", 1)[0] if '<form action="/' in page else ""
    found = dict(re.findall(r'<input[^>]* name="([^"]+)"(?: value="([^"]*)")?', form))
    for name, options in re.findall(r'<select[^>]* name="([^"]+)".*?>(.*?)</select>', form, re.S):
        selected = re.search(r'<option value="([^"]*)" selected', options)
        found[name] = "" if selected is None else selected[1]
    return {name: unescape(value) for name, value in found.items()}


def sent(client: "TestClient", address: str, status: int = 200, **typed: str) -> str:
    """The page after its form is filled and sent, empty entries included."""
    form = entries(shown(client, address))
    assert set(typed) <= set(form)
    return shown(client, address, status, **{**form, **typed})


def headlines(page: str) -> dict[str, str]:
    """The results that are shown first."""
    found = re.findall(r'data-headline="(\w+)".*?<dd[^>]*>(.*?)</dd>', page, re.S)
    return {key: text_of(value) for key, value in found}


def typed_in(page: str, name: str) -> str:
    """What stands in an entry."""
    found = re.search(rf'<input[^>]* name="{re.escape(name)}" value="([^"]*)"', page)
    assert found is not None, f"no entry {name}"
    return unescape(found[1])


def check_line(page: str, key: str) -> str:
    """One check beside the entries."""
    found = re.search(rf'<li[^>]*data-check="{key}".*?</li>', page, re.S)
    assert found is not None, f"no check {key}"
    return text_of(found[0])


def error_at(page: str, name: str) -> str:
    """The error at an entry, empty where there is none."""
    found = re.search(rf'data-field="{re.escape(name)}".*?<div class="notes">(.*?)</div>', page, re.S)
    assert found is not None, f"no entry {name}"
    error = re.search(r'<p class="error".*?</p>', found[1], re.S)
    return "" if error is None else text_of(error[0]).removeprefix("Error: ")


def saved(client: "TestClient", **axes: dict[str, Any]) -> dict[str, Any]:
    """A saved project with these axes."""
    answer = client.post("/api/v1/projects", json=project(**axes))
    assert answer.status_code == 201, answer.text
    found: dict[str, Any] = answer.json()
    return found


@pytest.fixture
def address(client: "TestClient") -> str:
    """The supply of a saved project with two servo axes."""
    return f"/p/{saved(client, X=SERVO_AXIS, Y=SERVO_AXIS)['edit_token']}/supply"


def test_a_project_leads_to_the_supply_of_its_axes(client: "TestClient", address: str) -> None:
    assert f'href="{address}"' in client.get(address.removesuffix("/supply")).text
    page = shown(client, address)
    assert re.findall(r'<h2 id="axis-\d">.*?</span>(.*?)</h2>', page, re.S) == ["X", "Y"]
    assert headlines(page) == {}
    assert "The result appears here" in text_of(page)
    assert NO_SERVO not in page


def test_two_axes_are_calculated_together(client: "TestClient", address: str) -> None:
    """2 * 5 A, 2 * 1.25 A; both brake at once: 100 J in 0.5 s; 99 W * 0.2 K/W below 80 degC."""
    page = sent(client, address, **MODULES, **{"supply.supply_current_a": "8", "supply.thermal_resistance_k_w": "0.2"})
    assert headlines(page) == {
        "supply_peak_current": "10 A",
        "supply_mean_current": "2.5 A",
        "supply_peak_power": "400 W",
        "mean_braking_power": "200 W",
        "braking_peak": "400 W",
        "permitted_ambient": "60.2 °C",
    }
    # 10 A of 2 * 8 A, 5 A of 1.5 * 4 A
    assert "62.5 %" in check_line(page, "supply_peak_current")
    assert "83.3 %" in check_line(page, "axis_2_peak_current")
    assert 'data-chart="dc-link"' in page
    assert re.search(r'id="step-worst_peak_power"', page)


def test_a_later_start_spreads_the_braking_and_is_kept(client: "TestClient", address: str) -> None:
    """Later by 1 s no braking meets another one: 100 J in 1 s."""
    page = sent(client, address, **{"axes.1.start_s": "1000 ms", "supply.supply_current_a": "8,0"})
    assert headlines(page)["mean_braking_power"] == "100 W"
    assert typed_in(page, "axes.1.start_s") == "1000 ms"
    assert typed_in(page, "axes.0.start_s") == ""
    assert typed_in(page, "supply.supply_current_a") == "8,0"


def test_what_is_typed_is_not_saved_with_the_project(client: "TestClient", address: str) -> None:
    before = client.get(f"/api/v1{address.replace('/p/', '/projects/').removesuffix('/supply')}").json()
    sent(client, address, **MODULES)
    after = client.get(f"/api/v1{address.replace('/p/', '/projects/').removesuffix('/supply')}").json()
    assert (after["version"], after["document"]) == (before["version"], before["document"])
    assert typed_in(shown(client, address), "axes.0.module.rated_current_a") == ""


@pytest.mark.parametrize(
    ("name", "value", "words"),
    [
        ("axes.0.module.rated_current_a", "4 kg", "'kg' does not measure the same thing as 'A'"),
        ("axes.1.module.rated_current_a", "-4", "must be greater than 0 A"),
        ("axes.1.start_s", "soon", "'soon' is not a number"),
        ("supply.supply_current_a", '"><script>', "is not a number"),
        ("supply.thermal_resistance_k_w", "1e400", "is not a finite number"),
    ],
)
def test_a_bad_value_is_told_at_its_entry_and_kept(
    client: "TestClient", address: str, name: str, value: str, words: str
) -> None:
    page = sent(client, address, 422, **{name: value, "supply.base_losses_w": "12 W"})
    assert words in error_at(page, name)
    assert typed_in(page, name) == value
    assert typed_in(page, "supply.base_losses_w") == "12 W"
    assert error_at(page, "supply.base_losses_w") == ""
    assert headlines(page) == {}
    assert f"{name}: " in text_of(page)


def test_axes_of_another_kind_are_named_and_left_out(client: "TestClient") -> None:
    token = saved(client, Trolley=MAINS_AXIS, X=SERVO_AXIS)["edit_token"]
    page = sent(client, f"/p/{token}/supply", **{"axes.0.module.rated_current_a": "4"})
    assert "Not on the supply, since they are no servo axes: Trolley" in text_of(page)
    # one axis only: 5 A of 1.5 * 4 A
    assert headlines(page)["supply_peak_current"] == "5 A"
    assert "83.3 %" in check_line(page, "axis_1_peak_current")
    assert 'name="axes.1.start_s"' not in page


@pytest.mark.parametrize("typed", [{}, {"supply.supply_current_a": "8"}])
def test_a_project_without_servo_axes_says_so(client: "TestClient", typed: dict[str, str]) -> None:
    token = saved(client, Trolley=MAINS_AXIS)["edit_token"]
    page = shown(client, f"/p/{token}/supply", **typed)
    assert NO_SERVO in page
    assert "they are no servo axes: Trolley" in text_of(page)
    assert 'name="supply.supply_current_a"' not in page
    assert headlines(page) == {}


def test_an_axis_whose_currents_are_unknown_is_told(client: "TestClient") -> None:
    token = saved(client, X=SERVO_AXIS, Y={**SERVO_AXIS, "drive": {"kind": "servo"}})["edit_token"]
    page = sent(client, f"/p/{token}/supply", 422, **MODULES)
    assert "axes.1.sizing.drive.motor: its currents are not known: motor" in text_of(page)
    assert typed_in(page, "axes.0.module.rated_current_a") == "4"


def test_the_link_to_view_shows_the_supply_and_no_link_to_edit(client: "TestClient") -> None:
    made = saved(client, X=SERVO_AXIS, Y=SERVO_AXIS)
    page = sent(client, f"/p/{made['view_token']}/supply", **MODULES)
    assert headlines(page)["supply_peak_current"] == "10 A"
    assert made["edit_token"] not in page


@pytest.mark.parametrize("token", ["none", "x" * 100, "%2e%2e"])
def test_a_link_that_opens_nothing_is_told(client: "TestClient", token: str) -> None:
    page = shown(client, f"/p/{token}/supply", 404)
    assert "No project opens with this link" in text_of(page)
    assert "<form" not in page


def test_a_deleted_project_has_no_supply(client: "TestClient", address: str) -> None:
    project_address = f"/api/v1{address.replace('/p/', '/projects/').removesuffix('/supply')}"
    assert client.delete(project_address, headers={"If-Match": "1"}).status_code == 204
    shown(client, address, 404)


def test_an_example_is_shown_with_its_own_entries(client: "TestClient") -> None:
    """SEW 2001, 16.5 prints 10.7 A and 1.4 A; 53 degC follow once its effective current is corrected."""
    page = shown(client, "/supply", **EXAMPLE)
    assert re.findall(r'<h2 id="axis-\d">.*?</span>(.*?)</h2>', page, re.S) == ["Hoist", "Travel"]
    assert typed_in(page, "axes.1.start_s") == "3.5"
    assert typed_in(page, "supply.supply_current_a") == "20"
    assert float(headlines(page)["supply_peak_current"].removesuffix(" A")) == pytest.approx(10.7, rel=0.03)
    assert float(headlines(page)["supply_mean_current"].removesuffix(" A")) == pytest.approx(1.4, rel=0.01)
    assert float(headlines(page)["permitted_ambient"].removesuffix(" °C")) == pytest.approx(53, rel=0.01)


def test_other_entries_than_those_of_the_example_are_calculated(client: "TestClient") -> None:
    """The heat sink stays 27.1 K below 80 degC with 0.4 K/W, so half of that with 0.2 K/W."""
    first = shown(client, "/supply", **EXAMPLE)
    form = entries(first)
    assert {**form, **EXAMPLE} == form
    second = shown(client, "/supply", **{**form, "supply.thermal_resistance_k_w": "0.2"})
    before, after = (float(headlines(page)["permitted_ambient"].removesuffix(" °C")) for page in (first, second))
    assert 80 - after == pytest.approx((80 - before) / 2, rel=1e-3)


@pytest.mark.parametrize(
    ("query", "status", "words"),
    [
        ({}, 422, "example"),
        ({"example": "none"}, 404, "none"),
        ({"example": "sew-16-gantry-electronics", "request": "none"}, 404, "The example has no supply 'none'."),
        ({"example": "tr-ball-screw"}, 404, "The example has no supply 'main'."),
    ],
)
def test_what_is_not_there_is_told(client: "TestClient", query: dict[str, str], status: int, words: str) -> None:
    page = shown(client, "/supply", status, **query)
    assert words in text_of(page)
    assert "<form" not in page


@pytest.mark.parametrize("number", [0, 1])
def test_what_is_typed_for_one_axis_stays_with_it(client: "TestClient", address: str, number: int) -> None:
    """5 A of 1.5 * 4 A in the axis that has a module; nothing is checked in the other one."""
    page = sent(client, address, **{f"axes.{number}.module.rated_current_a": "4"})
    assert typed_in(page, f"axes.{number}.module.rated_current_a") == "4"
    assert typed_in(page, f"axes.{1 - number}.module.rated_current_a") == ""
    assert "83.3 %" in check_line(page, f"axis_{number + 1}_peak_current")
    assert f'data-check="axis_{2 - number}_peak_current"' not in page
