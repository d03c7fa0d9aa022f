"""Whatever is sent, the answer is a clear error at the field: on every address that takes a body."""

import copy
import json
from collections.abc import Callable
from typing import Any

import pytest
from starlette.testclient import TestClient

from app.web.errors import Problem
from tests.sizing_requests import SCREW_AXIS

API = "/api/v1"


def in_project(request: dict[str, Any]) -> dict[str, Any]:
    return {"title": "Portal", "axes": [{"name": "X", "request": request}]}


POSTS: dict[str, tuple[str, Callable[[dict[str, Any]], dict[str, Any]], str]] = {
    "sizings": (f"{API}/sizings", lambda request: request, ""),
    "charts": (f"{API}/charts", lambda request: request, ""),
    "selections": (f"{API}/selections", lambda request: request, ""),
    "explain": (f"{API}/selections/explain", lambda request: {**request, "motor_id": "own"}, ""),
    "projects": (f"{API}/projects", in_project, "axes.0.request."),
}
"""Address, body around a sizing request, and what stands before the names of its fields."""

BAD_VALUES = [
    ("mechanism.slide_mass_kg", "heavy", "'heavy' is not a number"),
    ("mechanism.slide_mass_kg", "400 mm", "'mm' does not measure the same thing as 'kg'"),
    ("mechanism.slide_mass_kg", "NaN", "is not a number"),
    ("mechanism.slide_mass_kg", "1e400", "is not a finite number"),
    ("mechanism.slide_mass_kg", 10**400, "is too large for a number"),
    ("mechanism.slide_mass_kg", -400, "must be"),
    ("mechanism.slide_mass_kg", None, "is not a number"),
    ("mechanism.slide_mass_kg", True, "is not a number"),
    ("mechanism.slide_mass_kg", [400], "is not a number"),
    ("mechanism.slide_mass_kg", {"value": 400}, "is not a number"),
    ("mechanism.nominal_diameter_mm", 0, "must be greater than 0 mm"),
    ("mechanism.lead_mm", "", "is not a number"),
    ("mechanism.kind", "perpetuum_mobile", "is none of"),
    ("mechanism.kind", 7, "is none of"),
    ("mechanism", "ball_screw", "must be an object with named values"),
    ("mechanism.lead_m", 1, "is not known here; did you mean lead_mm?"),
    ("motion.kind", "constant_rotation", "is missing"),
    ("motion.moves", [], "must have at least 1 entries"),
    ("motion.moves.0.distance_mm", "x" * 10_000, "is not a number"),
    ("motion.moves.0.speed_m_s", "fast", "'fast' is not a number"),
    ("environment", {"gravity_m_s2": "9.81 kg"}, "does not measure the same thing"),
    ("drive.motor", {}, 'give either "id" or "own"'),
    ("drive.motor", {"id": "no-such-motor"}, "names no servo motor"),
    ("drive.rule_set", "none", "must be 'usual' or 'lachman'"),
    ("notes", "x" * 5000, "must have at most 4000 characters"),
]


def with_value(path: str, value: object) -> dict[str, Any]:
    """The good request with one value replaced."""
    request = copy.deepcopy(SCREW_AXIS)
    here: Any = request
    *outer, last = path.split(".")
    for part in outer:
        here = here[int(part)] if isinstance(here, list) else here.setdefault(part, {})
    here[last] = value
    return request


def problem(response: Any, status: int) -> Problem:
    """The problem in an answer of that status."""
    assert response.status_code == status, response.text[:500]
    assert response.headers["content-type"] == "application/problem+json"
    return Problem.model_validate_json(response.content)


@pytest.fixture(scope="module")
def http(loaded_file: Any, tmp_path_factory: pytest.TempPathFactory) -> Any:
    """One application for the whole list; nothing here is stored."""
    from app.main import create_app
    from tests.conftest import make_settings, sqlite_url

    path = tmp_path_factory.mktemp("bad") / "drivewright.db"
    path.write_bytes(loaded_file.read_bytes())
    with TestClient(create_app(make_settings(sqlite_url(path)))) as client:
        yield client


@pytest.mark.parametrize("post", POSTS)
def test_what_is_plainly_right_is_accepted(http: TestClient, post: str):
    address, body, _ = POSTS[post]
    assert http.post(address, json=body(SCREW_AXIS)).status_code in (200, 201)


UNKNOWN_PRODUCT = {"id": "no-such-motor"}
"""A project may name a product of a catalogue that is not loaded here; a calculation may not."""

CASES = [(post, *bad) for post in POSTS for bad in BAD_VALUES if post != "projects" or bad[1] != UNKNOWN_PRODUCT]


@pytest.mark.parametrize(("post", "path", "value", "words"), CASES, ids=lambda value: str(value)[:30])
def test_a_bad_value_is_refused_at_its_field(http: TestClient, post: str, path: str, value: object, words: str):
    address, body, prefix = POSTS[post]
    found = problem(http.post(address, json=body(with_value(path, value))), 422)
    errors = {error.name: error.message for error in found.errors}
    at_field = [message for name, message in errors.items() if name.startswith(prefix + path.removesuffix(".kind"))]
    assert any(words in message for message in at_field), errors


@pytest.mark.parametrize("post", ["sizings", "selections", "explain"])
def test_an_impossible_move_is_refused_with_the_reason_at_its_field(http: TestClient, post: str):
    """0.5 m/s2 for 4 s: up for 2 s to 1 m/s and down again is 2 m; 3 m cannot be reached."""
    address, body, _ = POSTS[post]
    move = {"distance_mm": 3000, "time_s": 4, "acceleration_m_s2": 0.5}
    found = problem(http.post(address, json=body(with_value("motion.moves", [move]))), 422)
    (error,) = found.errors
    assert error.path[:3] == ["motion", "moves", 0]
    assert "0.5 m/s2 for 4 s covers at most 2 m" in error.message


@pytest.mark.parametrize("post", ["sizings", "selections"])
def test_a_rotary_motion_on_a_linear_mechanism_is_refused_at_its_kind(http: TestClient, post: str):
    turns = {"kind": "turns", "moves": [{"distance_deg": 90, "speed_rpm": 10, "acceleration_rad_s2": 5}]}
    (error,) = problem(http.post(POSTS[post][0], json={**SCREW_AXIS, "motion": turns}), 422).errors
    assert error.name == "motion.kind"
    assert "needs a linear motion" in error.message


BAD_BODIES = [
    (b"", 400),
    (b"{", 400),
    (b"null", 422),
    (b"[]", 422),
    (b'"text"', 422),
    (b"17", 422),
    (b'{"mechanism": NaN}', 400),
    (b'{"mechanism": {"kind": "ball_screw", "slide_mass_kg": 1e400}}', 422),
    (b'{"a": 1, "a": 2}', 400),
    (b'{"a": "\xff"}', 400),
    (b'{"a": "\\ud800"}', 400),
    (b'{"a": "\\u0000"}', 400),
    (b"[" * 50_000, 400),
    (b'{"a":' * 50_000 + b"1" + b"}" * 50_000, 400),
    (b'{"mechanism": ' * 150 + b"1" + b"}" * 150, 422),
    (b"9" * 5000, 400),
    (json.dumps({f"name{n}": n for n in range(20_000)}).encode(), 422),
]


@pytest.mark.parametrize("post", POSTS)
@pytest.mark.parametrize(("body", "status"), BAD_BODIES, ids=lambda value: str(value)[:30])
def test_a_bad_body_is_refused(http: TestClient, post: str, body: bytes, status: int):
    response = http.post(POSTS[post][0], content=body, headers={"content-type": "application/json"})
    found = problem(response, status)
    assert len(response.content) < 100_000
    assert found.detail


@pytest.mark.parametrize("post", POSTS)
@pytest.mark.parametrize("chunked", [False, True])
def test_a_body_of_ten_megabytes_is_refused(http: TestClient, post: str, chunked: bool):
    block = b"x" * 65536
    body: Any = (block for _ in range(160)) if chunked else block * 160
    response = http.post(POSTS[post][0], content=body, headers={"content-type": "application/json"})
    assert "1024 KiB" in problem(response, 413).detail


@pytest.mark.parametrize("post", POSTS)
def test_a_body_that_is_not_json_is_refused(http: TestClient, post: str):
    problem(http.post(POSTS[post][0], data={"mechanism": "x"}), 415)


def test_what_was_typed_comes_back_with_the_error(http: TestClient):
    (error,) = problem(http.post(f"{API}/sizings", json=with_value("mechanism.lead_mm", " 1O mm ")), 422).errors
    assert error.value == " 1O mm "


@pytest.mark.parametrize(
    ("address", "status"),
    [
        ("/projects/unknown", 404),
        ("/projects/" + "x" * 200, 422),
        ("/projects/unknown/revisions/0", 422),
        ("/projects/unknown/revisions/99999999999999999999", 422),
        ("/catalog/unicorns", 404),
        ("/catalog/servo_motor/unknown", 404),
        ("/catalog/servo_motor?limit=201", 422),
        ("/catalog/servo_motor?limit=0", 422),
        ("/catalog/servo_motor?offset=-1", 422),
        ("/catalog/servo_motor?offset=1000000001", 422),
        ("/catalog/servo_motor?sort=colour", 422),
        ("/examples/unknown", 404),
        ("/formulas/unknown", 404),
        ("/mechanisms/unknown", 404),
        ("/nowhere", 404),
    ],
)
def test_what_does_not_exist_is_told(http: TestClient, address: str, status: int):
    assert problem(http.get(API + address), status).detail


def test_a_method_that_is_not_possible_is_told(http: TestClient):
    assert problem(http.delete(f"{API}/sizings"), 405).detail


def test_an_empty_catalogue_is_told_with_what_to_do(empty_database: str):
    from app.main import create_app
    from tests.conftest import make_settings

    request = with_value("drive.motor", None)
    with TestClient(create_app(make_settings(empty_database))) as client:
        assert "drivewright load-catalog" in problem(client.post(f"{API}/selections", json=request), 409).detail
        assert client.get(f"{API}/catalog/servo_motor").json()["total"] == 0
        assert client.post(f"{API}/sizings", json=SCREW_AXIS).status_code == 200
