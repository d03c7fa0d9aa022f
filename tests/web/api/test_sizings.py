"""Sizing over REST gives the numbers of the service, in the shape that is documented."""

import json
import math
from typing import Any

import pytest
from starlette.testclient import TestClient

from app.engine.quantity import from_si
from app.services.catalogue import CatalogueCache
from app.services.sizing import SizingService
from app.web.api.models import SizingAnswer
from tests.line_fed_requests import TABLE, request
from tests.sizing_requests import SCREW_AXIS

ADDRESS = "/api/v1/sizings"


def no_catalogue() -> CatalogueCache:
    """A catalogue that must not be asked."""

    def refuse() -> None:
        raise AssertionError("this request needs no catalogue")

    return CatalogueCache(refuse)  # type: ignore[arg-type]


def test_the_answer_has_the_documented_shape(client: TestClient):
    response = client.post(ADDRESS, json=SCREW_AXIS)
    assert response.status_code == 200
    answer = SizingAnswer.model_validate_json(response.content, strict=True)
    assert set(response.json()) == set(SizingAnswer.model_fields)
    assert set(response.json()["steps"][0]) == {*SizingAnswer.model_fields["steps"].annotation.__args__[0].model_fields}
    assert answer.request == SCREW_AXIS


def test_a_request_that_names_no_product_needs_no_catalogue_and_gives_the_same_numbers(client: TestClient):
    sizing = SizingService(no_catalogue()).size(SCREW_AXIS)
    answer = client.post(ADDRESS, json=SCREW_AXIS).json()
    assert {step["key"]: step["value_si"] for step in answer["steps"]} == {s.key: s.value for s in sizing.sheet.steps}
    assert [check["utilisation"] for check in answer["checks"]] == [check.utilisation for check in sizing.sheet.checks]
    assert answer["verdict"] == sizing.verdict
    assert answer["catalogue"] == {"version": "", "editions": {}}


def test_the_top_motor_speed_is_that_of_the_hand_calculation(client: TestClient):
    """0.5 m/s on a lead of 10 mm is 50 turns per second: 3000 rpm, of 0.9 * 4000 rpm permitted."""
    answer = client.post(ADDRESS, json=SCREW_AXIS).json()
    (speed,) = (step for step in answer["steps"] if step["key"] == "motor_speed_max")
    assert (speed["value"], speed["unit"]) == (pytest.approx(3000, rel=1e-12), "rpm")
    assert speed["value_si"] == pytest.approx(2 * math.pi * 50, rel=1e-12)
    (check,) = (check for check in answer["checks"] if check["key"] == "speed")
    assert (check["demanded"], check["permitted"]) == (pytest.approx(3000), pytest.approx(3600))
    assert (check["verdict"], check["utilisation"]) == ("tight", pytest.approx(3000 / 3600))


def test_values_are_shown_in_the_unit_named_beside_them(client: TestClient):
    for step in client.post(ADDRESS, json=SCREW_AXIS).json()["steps"]:
        assert step["value"] == from_si(step["value_si"], step["unit"]), step["key"]


def test_the_same_numbers_typed_otherwise_give_the_same_result(client: TestClient):
    typed = {**SCREW_AXIS, "mechanism": {**SCREW_AXIS["mechanism"], "lead_mm": "1,0 cm", "slide_mass_kg": "400000 g"}}
    first, second = (client.post(ADDRESS, json=request).json() for request in (SCREW_AXIS, typed))
    assert second["request"] == typed
    for one, other in zip(first["steps"], second["steps"], strict=True):
        assert other["value_si"] == pytest.approx(one["value_si"], rel=1e-12)


def test_a_kept_answer_is_the_same_and_a_refusal_is_not_kept(client: TestClient):
    first, again = (client.post(ADDRESS, json=SCREW_AXIS).content for _ in range(2))
    assert first == again
    bad = {**SCREW_AXIS, "mechanism": {}}
    assert [client.post(ADDRESS, json=bad).status_code for _ in range(2)] == [422, 422]


def test_a_motor_of_the_catalogue_is_named_with_its_edition(client: TestClient):
    (motor,) = client.get("/api/v1/catalog/servo_motor", params={"q": "1FT5 106", "limit": 1}).json()["items"]
    request = {**SCREW_AXIS, "drive": {"motor": {"id": motor["id"]}}}
    answer = client.post(ADDRESS, json=request).json()
    assert answer["parts"]["motor"]["id"] == motor["id"]
    assert list(answer["catalogue"]["editions"]) == [motor["edition"]]
    assert answer["catalogue"]["version"]


def test_defaults_are_assumptions_until_they_are_confirmed(client: TestClient):
    def assumed(request: object) -> set[str]:
        return {found["key"] for found in client.post(ADDRESS, json=request).json()["assumptions"]}

    assert "environment.gravity_m_s2" in assumed(SCREW_AXIS)
    assert "environment.gravity_m_s2" not in assumed({**SCREW_AXIS, "environment": {"gravity_m_s2": 9.81}})


def test_without_a_motor_the_demand_is_told(client: TestClient):
    request = {name: value for name, value in SCREW_AXIS.items() if name != "drive"}
    answer = client.post(ADDRESS, json=request)
    assert answer.status_code == 200
    keys = {step["key"] for step in json.loads(answer.content)["steps"]}
    assert {"motor_speed_max", "peak_load_torque_on_motor", "required_motor_inertia"} <= keys
    assert answer.json()["parts"] == {"motor": None, "gear_unit": None, "servo_drive": None}


@pytest.mark.parametrize(
    ("duty", "seconds", "permitted"),
    [
        ({"duty_type": "S3", "duty_percent": 40}, 10, 1.725),  # 1.15 * 1.5 kW
        ({"duty_type": "S3", "duty_percent": 50}, 10, 1.6875),  # between 1.15 and 1.1
        ({"duty_type": "S2"}, 1800, 1.8),  # 30 minutes: 1.2
        ({"duty_type": "S2"}, 7200, None),  # beyond the table
    ],
)
def test_the_rating_follows_the_duty_type(client: TestClient, duty: dict[str, Any], seconds: float, permitted: float):
    """A motor of 1.5 kW; the factors of SEW 2001, 2.3."""
    made = request(TABLE, motion={"runs": [{"duration_s": seconds}]}, drive=duty)
    answer = client.post("/api/v1/sizings", json=made).json()
    (check,) = (one for one in answer["checks"] if one["key"] == "static_power")
    assert check["permitted"] == (permitted if permitted is None else pytest.approx(permitted))
