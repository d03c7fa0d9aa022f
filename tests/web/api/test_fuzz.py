"""The interface, attacked from its own description: every operation, right and wrong input, all checks."""

from typing import Any

import pytest
import schemathesis
from hypothesis import HealthCheck, Phase, settings
from schemathesis.config import SchemathesisConfig

EXAMPLES = 12

CONFIG = SchemathesisConfig.from_dict({
    "checks": {
        # What is well-formed may still be impossible: a move that cannot be, a motor that the catalogue lacks.
        "positive_data_acceptance": {"expected-statuses": [200, 201, 204, 403, 404, 409, 412, 422, 428]},
        "negative_data_rejection": {"expected-statuses": [400, 404, 405, 409, 413, 415, 422, 428]},
    },
})  # fmt: skip


@pytest.fixture(scope="module")
def attacked(loaded_file: Any, tmp_path_factory: pytest.TempPathFactory) -> Any:
    """The description of an application on a database of its own."""
    from app.main import create_app
    from tests.conftest import make_settings, sqlite_url

    path = tmp_path_factory.mktemp("fuzz") / "drivewright.db"
    path.write_bytes(loaded_file.read_bytes())
    return schemathesis.openapi.from_asgi(
        "/api/v1/openapi.json", create_app(make_settings(sqlite_url(path))), config=CONFIG
    )


schema = schemathesis.pytest.from_fixture("attacked")


@schema.parametrize()
@settings(
    max_examples=EXAMPLES,
    deadline=None,
    derandomize=True,
    suppress_health_check=list(HealthCheck),
    phases=[Phase.explicit, Phase.generate],
)
def test_the_interface_keeps_its_promises(case: Any):
    case.call_and_validate()
