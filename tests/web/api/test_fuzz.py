"""The interface, attacked from its own description: every operation, right and wrong input, all checks.

A body that fits the schema may still describe what cannot be (a move that is too short, a motor that the catalogue
lacks), so a refusal of it is right as long as it has a documented status and shape.
"""

from collections.abc import Iterator
from typing import Any

import pytest
import schemathesis
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st
from hypothesis.errors import Unsatisfiable
from schemathesis import GenerationMode
from schemathesis.config import SchemathesisConfig
from starlette.testclient import TestClient

from tests.sizing_requests import SCREW_AXIS

REFUSALS = [400, 403, 404, 409, 412, 415, 422, 428]
CONFIG = SchemathesisConfig.from_dict({
    "checks": {
        "positive_data_acceptance": {"expected-statuses": [200, 201, 204, *REFUSALS]},
        "negative_data_rejection": {"expected-statuses": [405, 413, *REFUSALS]},
    },
})  # fmt: skip
BOUNDED = settings(
    max_examples=20,
    deadline=None,
    derandomize=True,
    database=None,
    suppress_health_check=list(HealthCheck),
    phases=[Phase.explicit, Phase.generate],
)


def operations() -> dict[str, Any]:
    """Every operation of the description, which is made without opening anything."""
    from app.main import create_app
    from tests.conftest import make_settings

    described = create_app(make_settings("sqlite:///never-opened.db")).openapi()
    schema = schemathesis.openapi.from_dict(described, config=CONFIG)
    return {operation.label: operation for operation in (result.ok() for result in schema.get_all_operations())}


OPERATIONS = operations()
OF_A_PROJECT = [label for label in OPERATIONS if "{token}" in label]


@pytest.fixture(scope="module")
def http(loaded_file: Any, tmp_path_factory: pytest.TempPathFactory) -> Iterator[TestClient]:
    """An application on a database of its own, for all attacks."""
    from app.main import create_app
    from tests.conftest import make_settings, sqlite_url

    path = tmp_path_factory.mktemp("fuzz") / "drivewright.db"
    path.write_bytes(loaded_file.read_bytes())
    with TestClient(create_app(make_settings(sqlite_url(path)))) as client:
        yield client


def attack(http: TestClient, case: Any) -> None:
    """Send one case and hold the answer to the description; an exception in the application fails, too."""
    sent = case.as_transport_kwargs(base_url="http://testserver")
    if "data" in sent:
        sent["content"] = sent.pop("data")
    for name in ("allow_redirects", "cookies"):
        sent.pop(name, None)
    case.validate_response(http.request(**sent))


@pytest.mark.parametrize("mode", list(GenerationMode), ids=str)
@pytest.mark.parametrize("label", OPERATIONS)
def test_every_operation_keeps_its_promises(http: TestClient, label: str, mode: GenerationMode):
    @BOUNDED
    @given(OPERATIONS[label].as_strategy(generation_mode=mode))
    def attacked(case: Any) -> None:
        attack(http, case)

    try:
        attacked()
    except Unsatisfiable:
        assert mode == GenerationMode.NEGATIVE, "nothing fits this schema"


@pytest.mark.parametrize("label", OF_A_PROJECT)
def test_every_operation_on_a_real_project_keeps_its_promises(http: TestClient, label: str):
    body = {"title": "x", "axes": [{"name": "X", "request": SCREW_AXIS}]}
    made = http.post("/api/v1/projects", json=body).json()
    tokens = st.sampled_from([made["edit_token"], made["view_token"]])

    @BOUNDED
    @given(OPERATIONS[label].as_strategy(), tokens, st.integers(1, 3))
    def attacked(case: Any, token: str, version: int) -> None:
        case.path_parameters["token"] = token
        if case.operation.method.upper() != "GET":
            case.headers["If-Match"] = f'"{version}"'
        attack(http, case)

    attacked()
