"""The description of the interface is complete enough for a generated client."""

import re
from collections.abc import Iterator
from typing import Any

import pytest
from starlette.testclient import TestClient

METHODS = {"get", "post", "put", "delete", "patch"}
REFERENCE = "#/components/schemas/"


@pytest.fixture(scope="module")
def described() -> dict[str, Any]:
    from app.main import create_app
    from tests.conftest import make_settings

    found: dict[str, Any] = create_app(make_settings("sqlite:///never-opened.db")).openapi()
    return found


def operations(described: dict[str, Any]) -> Iterator[tuple[str, str, dict[str, Any]]]:
    for path, item in described["paths"].items():
        for method, operation in item.items():
            if method in METHODS:
                yield path, method, operation


def references(value: object) -> Iterator[str]:
    if isinstance(value, dict):
        if isinstance(value.get("$ref"), str):
            yield value["$ref"]
        for inner in value.values():
            yield from references(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from references(inner)


def test_every_operation_has_a_readable_name_of_its_own(described: dict[str, Any]):
    names = [operation["operationId"] for _, _, operation in operations(described)]
    assert len(names) == len(set(names))
    assert [name for name in names if not re.fullmatch(r"[a-z]+([A-Z][a-z]+)+", name)] == []


def test_every_operation_is_described(described: dict[str, Any]):
    lacking = [
        (path, method, field)
        for path, method, operation in operations(described)
        for field in ("summary", "description", "tags")
        if not operation.get(field)
    ]
    assert lacking == []
    parameters = [
        (path, parameter["name"])
        for path, _, operation in operations(described)
        for parameter in operation.get("parameters", [])
        if not parameter.get("description") and parameter["name"] != "descending"
    ]
    assert parameters == []


def test_every_answer_has_a_schema_and_every_error_is_a_problem(described: dict[str, Any]):
    for path, method, operation in operations(described):
        for status, response in operation["responses"].items():
            where = f"{method} {path} {status}"
            if status == "204":
                assert "content" not in response, where
            elif status.startswith("2"):
                kinds = {"application/pdf"} if path.endswith("/reports") else {"application/json"}
                assert set(response["content"]) == kinds, where
                assert all(one["schema"] for one in response["content"].values()), where
            else:
                schema = response["content"]["application/problem+json"]["schema"]
                assert schema == {"$ref": REFERENCE + "Problem"}, where
                assert set(response["content"]) == {"application/problem+json"}, where


def test_every_reference_leads_somewhere(described: dict[str, Any]):
    schemas = described["components"]["schemas"]
    assert {ref for ref in references(described) if ref.removeprefix(REFERENCE) not in schemas} == set()


def test_lists_are_paged(described: dict[str, Any]):
    for path, _, operation in operations(described):
        if operation["operationId"].startswith("list") and path != "/api/v1/catalog":
            names = {parameter["name"] for parameter in operation["parameters"]}
            assert {"limit", "offset"} <= names, path


def test_quantities_carry_unit_symbol_and_bounds(described: dict[str, Any]):
    lead = described["components"]["schemas"]["BallScrew"]["properties"]["lead_mm"]
    assert lead["x-unit"] == "mm"
    assert lead["x-symbol"]
    assert lead["description"]
    assert lead["anyOf"][0]["exclusiveMinimum"] == 0


def test_every_mechanism_is_in_the_request(described: dict[str, Any]):
    from app.engine.mechanisms import mechanisms

    mapping = described["components"]["schemas"]["SizingRequest"]["properties"]["mechanism"]["discriminator"]["mapping"]
    assert set(mapping) == set(mechanisms())


def test_the_description_is_served(client: TestClient):
    response = client.get("/api/v1/openapi.json")
    assert response.status_code == 200
    assert response.json()["openapi"].startswith("3.")
