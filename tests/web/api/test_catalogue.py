"""The catalogue over REST: as printed, in pages, with few questions to the database."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import pytest
from sqlalchemy import event
from starlette.testclient import TestClient

ADDRESS = "/api/v1/catalog"


@contextmanager
def counted(client: TestClient) -> Iterator[list[str]]:
    """Every statement that is sent to the database inside."""
    statements: list[str] = []
    engine = client.app.state.running.engine  # type: ignore[attr-defined]

    def note(_connection: Any, _cursor: Any, statement: str, *_more: Any) -> None:
        if not statement.startswith(("PRAGMA", "BEGIN")):
            statements.append(statement)

    event.listen(engine, "before_cursor_execute", note)
    try:
        yield statements
    finally:
        event.remove(engine, "before_cursor_execute", note)


def test_every_kind_is_counted(client: TestClient):
    kinds = {kind["kind"]: kind["count"] for kind in client.get(ADDRESS).json()}
    for kind, count in kinds.items():
        page = client.get(f"{ADDRESS}/{kind}", params={"limit": 1}).json()
        if kind != "induction_motor":  # one row per operating point
            assert page["total"] == count, kind
    assert kinds["servo_motor"] > 400


@pytest.mark.parametrize("kind", ["servo_motor", "servo_gear_unit", "induction_motor", "braking_resistor"])
def test_pages_follow_each_other(client: TestClient, kind: str):
    whole = client.get(f"{ADDRESS}/{kind}", params={"limit": 20}).json()
    parts = [client.get(f"{ADDRESS}/{kind}", params={"limit": 7, "offset": n}).json()["items"] for n in (0, 7, 14)]
    assert [item for part in parts for item in part][:20] == whole["items"]


def test_search_filter_and_sort(client: TestClient):
    found = client.get(f"{ADDRESS}/servo_motor", params={"q": "1ft5", "sort": "rated_torque_nm", "descending": True})
    torques = [item["rated_torque_nm"] for item in found.json()["items"] if item["rated_torque_nm"] is not None]
    assert torques == sorted(torques, reverse=True)
    assert len(torques) > 5
    makers = client.get(f"{ADDRESS}/servo_motor", params={"manufacturer": ["Lafert", "Siemens"], "limit": 200}).json()
    assert {item["manufacturer"] for item in makers["items"]} == {"Lafert", "Siemens"}


def test_a_product_has_every_column_and_its_source(client: TestClient):
    page = client.get(f"{ADDRESS}/servo_motor", params={"limit": 1}).json()
    product = client.get(f"{ADDRESS}/servo_motor/{page['items'][0]['id']}").json()
    (row,) = product["rows"]
    assert {column["name"] for column in product["columns"]} <= set(row)
    assert row["source"]
    torque = next(column for column in product["columns"] if column["name"] == "rated_torque_nm")
    assert (torque["unit"], torque["symbol"]) == ("N m", "M_N")


@pytest.mark.parametrize(
    ("address", "most"),
    [
        ("", 10),
        ("/editions", 13),
        ("/servo_motor?limit=200", 3),
        ("/induction_motor?limit=200", 3),
        ("/servo_gear_unit?limit=200&q=neugart&sort=ratio", 3),
    ],
)
def test_a_page_asks_the_database_a_fixed_number_of_questions(client: TestClient, address: str, most: int):
    with counted(client) as statements:
        assert client.get(ADDRESS + address).status_code == 200
    assert len(statements) <= most, statements


def test_a_list_of_revisions_asks_the_database_a_fixed_number_of_questions(client: TestClient):
    from tests.sizing_requests import SCREW_AXIS

    body = {"title": "x", "axes": [{"name": "X", "request": SCREW_AXIS}]}
    token = client.post("/api/v1/projects", json=body).json()["edit_token"]
    for version in range(1, 6):
        client.put(f"/api/v1/projects/{token}", json=body, headers={"If-Match": str(version)})
    with counted(client) as statements:
        assert client.get(f"/api/v1/projects/{token}/revisions").json()["total"] == 6
    assert len(statements) == 3, statements
    assert not any("document" in statement for statement in statements)
