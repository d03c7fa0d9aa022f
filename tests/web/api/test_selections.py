"""Selection over REST: the catalogue's own answer to a worked example, filters, pages and explanations."""

import json
from pathlib import Path
from typing import Any

import pytest
from starlette.testclient import TestClient

from app.web.api.models import ExplanationAnswer, SelectionAnswer
from tests.sizing_requests import SCREW_AXIS

ADDRESS = "/api/v1/selections"
EXAMPLES = Path(__file__).resolve().parents[3] / "examples"
OPEN_AXIS = {**SCREW_AXIS, "drive": {}}
LACHMAN_SERIES = {"series": ["1FT5"], "geared": False}


def lachman_axis() -> dict[str, Any]:
    """The axis of the worked example, its motor left open."""
    request: dict[str, Any] = json.loads((EXAMPLES / "lachman-ball-screw-axis.json").read_text())["requests"]["main"]
    request["drive"] = {name: value for name, value in request["drive"].items() if name != "motor"}
    assert request["drive"]["rule_set"] == "lachman"
    return request


def select(client: TestClient, request: dict[str, Any], **more: Any) -> dict[str, Any]:
    response = client.post(ADDRESS, json={**request, **more})
    assert response.status_code == 200, response.text[:500]
    SelectionAnswer.model_validate_json(response.content, strict=True)
    found: dict[str, Any] = response.json()
    return found


def motor_id(client: TestClient, name: str) -> str:
    items = client.get("/api/v1/catalog/servo_motor", params={"q": name, "manufacturer": "Siemens"}).json()["items"]
    (found,) = (item["id"] for item in items if item["model"].startswith(name))
    return str(found)


def test_the_lachman_axis_finds_1ft5_106_and_not_104(client: TestClient):
    """Lachman chooses 1FT5 106; 104 lacks continuous torque at the working speed (Mendricky 2015, part 6)."""
    found = select(client, lachman_axis(), filters=LACHMAN_SERIES)
    models = [item["motor"]["model"] for item in found["items"]]
    assert [model.split("-")[0] for model in models] == ["1FT5 106", "1FT5 108"]
    assert found["evaluated"] == 10
    response = client.post(
        f"{ADDRESS}/explain", json={**lachman_axis(), "motor_id": motor_id(client, "1FT5 104"), "gear_unit_id": None}
    )
    why = ExplanationAnswer.model_validate_json(response.content, strict=True)
    assert why.verdict == "fails"
    failing = {check.key for check in why.checks if check.verdict == "fails"}
    assert "working_torque" in failing


def test_candidates_are_counted_and_paged(client: TestClient):
    whole = select(client, OPEN_AXIS, limit=20)
    assert whole["admitted"] == whole["total"] > 20
    assert whole["evaluated"] == whole["admitted"] + whole["rejected"] > 800_000
    assert sum(whole["rejected_by"].values()) == whole["rejected"]
    parts = [select(client, OPEN_AXIS, limit=10, offset=offset)["items"] for offset in (0, 10)]
    assert parts[0] + parts[1] == whole["items"]
    assert [item["rank"] for item in whole["items"]] == list(range(1, 21))
    assert select(client, OPEN_AXIS, offset=whole["admitted"])["items"] == []


def test_an_admitted_candidate_is_explained_by_the_numbers_it_was_ranked_by(client: TestClient):
    for item in select(client, OPEN_AXIS, limit=5)["items"]:
        gear = item["gear_unit"] and item["gear_unit"]["id"]
        response = client.post(
            f"{ADDRESS}/explain", json={**OPEN_AXIS, "motor_id": item["motor"]["id"], "gear_unit_id": gear}
        )
        checks = {check["key"]: check["utilisation"] for check in response.json()["checks"]}
        for key, used in item["utilisations"].items():
            assert checks[key] == pytest.approx(used, rel=1e-9)
        assert {key for key, used in checks.items() if used is None} == set(item["not_checked"])


def test_a_chosen_candidate_is_sized_with_the_same_utilisation(client: TestClient):
    from app.services.selection import choose

    (item,) = select(client, OPEN_AXIS, limit=1)["items"]
    request = choose({**OPEN_AXIS, "limit": 1}, item["motor"]["id"], item["gear_unit"] and item["gear_unit"]["id"])
    answer = client.post("/api/v1/sizings", json=request).json()
    checks = {check["key"]: check["utilisation"] for check in answer["checks"]}
    assert checks[item["deciding_check"]] == pytest.approx(item["utilisation"], rel=1e-9)


def test_a_motor_named_in_the_request_is_kept(client: TestClient):
    found = select(client, SCREW_AXIS, filters={"geared": False})
    assert (found["evaluated"], [item["motor"]["id"] for item in found["items"]]) == (1, ["own"])
    with_gears = select(client, SCREW_AXIS, limit=200)
    assert {item["motor"]["id"] for item in with_gears["items"]} == {"own"}
    assert with_gears["evaluated"] > 1000


def test_a_gear_unit_named_in_the_request_is_kept(client: TestClient):
    request = {**OPEN_AXIS, "drive": {"gear_unit": {"own": {"ratio": 3}}}}
    found = select(client, request, limit=50)
    assert {item["gear_unit"]["id"] for item in found["items"]} == {"own"}
    assert {item["ratio"] for item in found["items"]} == {3.0}


@pytest.mark.parametrize(
    ("filters", "holds"),
    [
        ({"geared": False}, lambda item: item["gear_unit"] is None),
        ({"direct": False}, lambda item: item["gear_unit"] is not None),
        ({"manufacturers": ["Lafert"]}, lambda item: item["motor"]["manufacturer"] == "Lafert"),
        ({"max_ratio": 4}, lambda item: item["ratio"] <= 4),
        (
            {"gear_manufacturers": ["Neugart"], "direct": False},
            lambda item: item["gear_unit"]["manufacturer"] == "Neugart",
        ),
    ],
)
def test_a_filter_admits_only_what_it_names(client: TestClient, filters: dict[str, Any], holds: Any):
    items = select(client, OPEN_AXIS, filters=filters, limit=100)["items"]
    assert items
    assert all(holds(item) for item in items)


def test_demanding_all_checks_leaves_none_unchecked(client: TestClient):
    found = select(client, OPEN_AXIS, demand_all_checks=True, limit=100)
    assert found["items"]
    assert all(item["not_checked"] == [] for item in found["items"])
    assert found["rejected_by"]["not_checked"] > 0


def test_a_ranking_by_mass_lists_the_lightest_first_but_those_checked_in_full_before(client: TestClient):
    items = select(client, OPEN_AXIS, ranking="mass", limit=50)["items"]
    places = [
        (bool(item["not_checked"]), item["mass_kg"] is None, item["mass_kg"] or 0.0)
        for item in items
    ]  # fmt: skip
    assert places == sorted(places)
    assert {unchecked for unchecked, _, _ in places} == {False, True}
    assert sum(not unknown for _, unknown, _ in places) > 1


@pytest.mark.parametrize(
    ("more", "name", "words"),
    [
        ({"filters": {"manufacturers": ["Lafrt"]}}, "filters.manufacturers.0", "did you mean Lafert?"),
        ({"filters": {"series": ["unobtainable"]}}, "filters.series.0", "is not in the catalogue"),
        ({"filters": {"direct": False, "geared": False}}, "filters.geared", "with gear unit, without, or both"),
        ({"filters": {"max_ratio": 0.5}}, "filters.max_ratio", "must be at least 1"),
        ({"ranking": "price"}, "ranking", "must be"),
        ({"limit": 201}, "limit", "must be"),
        ({"offset": -1}, "offset", "must be"),
    ],
)
def test_a_wrong_question_is_refused_at_its_place(client: TestClient, more: dict[str, Any], name: str, words: str):
    response = client.post(ADDRESS, json={**OPEN_AXIS, **more})
    assert response.status_code == 422
    errors = {error["name"]: error["message"] for error in response.json()["errors"]}
    assert words in errors[name], errors
