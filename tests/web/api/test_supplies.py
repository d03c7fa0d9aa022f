"""Several axes on one supply over REST: the numbers of the hand calculation in ``tests.supply_requests``."""

from typing import Any

import pytest
from starlette.testclient import TestClient

from app.web.api.models import SupplyAnswer
from app.web.errors import Problem
from tests.supply_requests import MAINS_AXIS, two_axes

ADDRESS = "/api/v1/supplies"
Path = tuple[str | int, ...]


@pytest.fixture(scope="module")
def http(loaded_file: Any, tmp_path_factory: pytest.TempPathFactory) -> Any:
    """One application for the whole list; nothing here is stored."""
    from app.main import create_app
    from tests.conftest import make_settings, sqlite_url

    path = tmp_path_factory.mktemp("supplies") / "drivewright.db"
    path.write_bytes(loaded_file.read_bytes())
    with TestClient(create_app(make_settings(sqlite_url(path)))) as client:
        yield client


def calculate(http: TestClient, body: Any) -> dict[str, Any]:
    """An accepted answer."""
    response = http.post(ADDRESS, json=body)
    assert response.status_code == 200, response.text
    found: dict[str, Any] = response.json()
    return found


def values(answer: dict[str, Any]) -> dict[str, float]:
    """Value of each step, in the unit it is shown in."""
    return {step["key"]: step["value"] for step in answer["steps"]}


def with_value(path: Path, value: Any) -> dict[str, Any]:
    """The good request with one value replaced."""
    request = two_axes()
    here: Any = request
    *outer, last = path
    for part in outer:
        here = here[part]
    here[last] = value
    return request


def refused(http: TestClient, body: Any) -> dict[Path, str]:
    """What is said about each refused value, by its path."""
    response = http.post(ADDRESS, json=body)
    assert response.status_code == 422, response.text
    assert response.headers["content-type"] == "application/problem+json"
    return {tuple(error.path): error.message for error in Problem.model_validate_json(response.content).errors}


def test_currents_are_those_of_all_axes_together(http: TestClient):
    """Each axis: 10 N m / 2 N m/A = 5 A, on average 1.25 A. Module: 1.5 * 4 A. Supply: 2 * 8 A."""
    answer = calculate(http, two_axes())
    found = values(answer)
    assert (found["axis_1_mean_current"], found["axis_2_mean_current"]) == (1.25, 1.25)
    assert (found["supply_peak_current"], found["supply_mean_current"]) == (10, 2.5)
    checks = {check["key"]: check for check in answer["checks"]}
    demands = {key: (check["demanded"], check["permitted"], check["verdict"]) for key, check in checks.items()}
    assert demands["axis_1_peak_current"] == (5, 6, "tight")
    assert demands["axis_2_mean_current"] == (1.25, 4, "ok")
    assert demands["supply_peak_current"] == (10, 16, "ok")
    assert demands["supply_mean_current"] == (2.5, 8, "ok")
    assert checks["axis_2_peak_current"]["utilisation"] == pytest.approx(5 / 6, rel=1e-12)


@pytest.mark.parametrize(
    ("start", "time", "mean", "net"),
    [(0, 0.5, 200, 400), (0.25, 0.75, 100 / 0.75, 300), (1, 1, 100, 200), (2, 1, 100, 200)],
)
def test_braking_of_axes_that_start_at_different_times(
    http: TestClient, start: float, time: float, mean: float, net: float
):
    """50 J each, returned from 1 s to 1.5 s after the start.

    Later by 0.25 s: 0.75 s in which one of them brakes; together they take most at 0.5 s, 200 W + 100 W.
    """
    found = values(calculate(http, two_axes(start)))
    assert found["braking_energy_of_cycle"] == pytest.approx(100, rel=1e-12)
    assert found["braking_time"] == pytest.approx(time, rel=1e-9)
    assert found["mean_braking_power"] == pytest.approx(mean, rel=1e-9)
    assert found["braking_peak"] == pytest.approx(400, rel=1e-12)
    assert found["supply_peak_power"] == pytest.approx(400, rel=1e-12)
    assert found["mean_motoring_power"] == pytest.approx(100 / 4, rel=1e-12)
    assert found["net_peak_power"] == pytest.approx(net, rel=1e-5)
    assert found["worst_peak_power"] == pytest.approx(400, rel=1e-5)


def test_what_one_axis_returns_another_one_takes(http: TestClient):
    """Start 1 s later: from 1 s on one returns 200 W - 400 W/s * t while the other takes 400 W/s * t.

    For 0.25 s more is returned than taken: 200 W * 0.25 s / 2 = 25 J. The second braking finds no taker: 50 J in 0.5 s.
    """
    body = two_axes(1)
    body["supply"]["exchange"] = "shared"
    found = values(calculate(http, body))
    assert found["net_braking_energy"] == pytest.approx(25 + 50, rel=1e-4)
    assert found["net_braking_power"] == pytest.approx(75 / 0.75, rel=1e-4)


def test_the_heat_sink_carries_the_losses(http: TestClient):
    """14 W/A * 2.5 A for each axis, 2 W/A * 5 A, half of 12 W + 2 * 13 W: 99 W; 0.2 K/W: 19.8 K below 80 degC."""
    answer = calculate(http, two_axes())
    found = values(answer)
    assert found["axis_1_losses"] == pytest.approx(35, rel=1e-12)
    assert found["heat_sink_losses"] == pytest.approx(99, rel=1e-12)
    assert found["heat_sink_rise"] == pytest.approx(19.8, rel=1e-12)
    assert found["permitted_ambient"] == pytest.approx(60.2, rel=1e-12)
    (check,) = (check for check in answer["checks"] if check["key"] == "ambient_temperature")
    assert (check["demanded"], check["permitted"], check["unit"]) == (40, pytest.approx(60.2), "degC")


def test_the_answer_has_the_documented_shape(http: TestClient):
    response = http.post(ADDRESS, json=two_axes())
    answer = SupplyAnswer.model_validate_json(response.content, strict=True)
    assert set(response.json()) == set(SupplyAnswer.model_fields)
    assert [axis.name for axis in answer.axes] == ["X", "Y"]
    assert answer.verdict == "tight"
    assert {headline.key for headline in answer.headlines} >= {"supply_peak_current", "permitted_ambient"}


def test_a_supply_that_is_too_small_fails(http: TestClient):
    answer = calculate(http, with_value(("supply", "supply_current_a"), 4.9))
    (check,) = (check for check in answer["checks"] if check["key"] == "supply_peak_current")
    assert (check["verdict"], check["utilisation"]) == ("fails", pytest.approx(10 / 9.8))
    assert answer["verdict"] == "fails"


def test_a_longer_cycle_may_hold_several_of_a_shorter_one(http: TestClient):
    """4 s and 8 s: in 8 s two times 50 J and once 50 J; mean torque 10 N m * 1 s / 8 s = 1.25 N m: 0.625 A."""
    found = values(calculate(http, with_value(("axes", 1, "sizing", "motion", "cycle_time_s"), 8)))
    assert found["braking_energy_of_cycle"] == pytest.approx(150, rel=1e-12)
    assert found["supply_mean_current"] == pytest.approx(1.25 + 0.625, rel=1e-12)


BAD: list[tuple[Path, Any, str]] = [
    (("axes", 0, "module", "rated_current_a"), "4 kg", "'kg' does not measure the same thing as 'A'"),
    (("axes", 1, "module", "peak_factor"), 0.5, "must be at least 1"),
    (("axes", 1, "start_s"), "soon", "'soon' is not a number"),
    (("axes", 1, "start_s"), -1, "must be at least 0 s"),
    (("axes", 1, "sizing", "mechanism", "slide_mass_kg"), "heavy", "'heavy' is not a number"),
    (("axes", 1, "sizing", "motion", "moves", 0, "distance_mm"), "1 kg", "does not measure the same thing"),
    (("axes", 1, "sizing", "motion", "moves", 0, "time_s"), 0.1, "takes 1.5 s, not 0.1 s"),
    (("axes", 0, "sizing", "drive", "rule_set"), "none", "must be 'usual' or 'lachman'"),
    (("axes", 0, "module"), 4, "must be an object"),
    (("axes", 0), 5, "must be an object"),
    (("axes",), [], "at least 1"),
    (("supply", "supply_current_a"), 0, "must be greater than 0 A"),
    (("supply", "exchange"), "some", "must be 'none' or 'shared'"),
    (("supply", "supply_curent_a"), 8, "did you mean supply_current_a?"),
]


@pytest.mark.parametrize(("path", "value", "words"), BAD, ids=lambda value: str(value)[:40])
def test_a_bad_value_is_refused_at_its_path(http: TestClient, path: Path, value: Any, words: str):
    errors = refused(http, with_value(path, value))
    assert list(errors) == [path]
    assert words in errors[path]


def test_every_refused_value_is_told_at_once(http: TestClient):
    body = with_value(("axes", 0, "module", "rated_current_a"), "4 kg")
    body["axes"][1]["sizing"]["mechanism"]["slide_mass_kg"] = "heavy"
    body["supply"]["supply_current_a"] = 0
    assert set(refused(http, body)) == {
        ("axes", 0, "module", "rated_current_a"),
        ("axes", 1, "sizing", "mechanism", "slide_mass_kg"),
        ("supply", "supply_current_a"),
    }


@pytest.mark.parametrize(
    ("path", "value", "at", "words"),
    [
        (("axes", 1, "sizing"), MAINS_AXIS, ("axes", 1, "sizing", "drive", "kind"), "needs a servo drive"),
        (("axes", 1, "sizing", "drive", "motor"), None, ("axes", 1, "sizing", "drive", "motor"), "currents"),
        (("axes", 1, "sizing", "drive", "motor", "own", "stall_current_a"), None,
         ("axes", 1, "sizing", "drive", "motor"), "torque constant or rated current"),
        (("axes", 1, "sizing", "drive", "motor"), {"id": "none"}, ("axes", 1, "sizing", "drive", "motor", "id"),
         "names no servo motor"),
        (("supply", "braking_resistor"), {"id": "none"}, ("supply", "braking_resistor", "id"),
         "names no braking resistor"),
        (("axes", 1, "sizing", "motion", "cycle_time_s"), 6, ("axes",), "X: 4 s, Y: 6 s"),
    ],
    ids=["mains", "no-motor", "no-current", "unknown-motor", "unknown-resistor", "cycles"],
)  # fmt: skip
def test_an_axis_that_cannot_be_joined_is_told_with_the_reason(
    http: TestClient, path: Path, value: Any, at: Path, words: str
):
    errors = refused(http, with_value(path, value))
    assert list(errors) == [at]
    assert words in errors[at]
