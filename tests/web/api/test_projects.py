"""Projects over REST: links, versions and revisions."""

from typing import Any

import pytest
from starlette.testclient import TestClient

from tests.sizing_requests import SCREW_AXIS

ADDRESS = "/api/v1/projects"


def document(title: str = "Portal", lead: Any = 10) -> dict[str, Any]:
    request = {**SCREW_AXIS, "mechanism": {**SCREW_AXIS["mechanism"], "lead_mm": lead}}
    return {"title": title, "axes": [{"name": "X", "request": request}]}


@pytest.fixture
def project(client: TestClient) -> dict[str, Any]:
    response = client.post(ADDRESS, json=document(), params={"comment": "first"})
    assert response.status_code == 201
    found: dict[str, Any] = response.json()
    return found


def save(client: TestClient, token: str, body: Any, version: object) -> Any:
    headers = {} if version is None else {"If-Match": str(version)}
    return client.put(f"{ADDRESS}/{token}", json=body, headers=headers)


def test_a_new_project_tells_both_links_once(client: TestClient, project: dict[str, Any]):
    assert project["version"] == 1
    assert project["comment"] == "first"
    opened = client.get(f"{ADDRESS}/{project['edit_token']}")
    assert "edit_token" not in opened.json()
    assert opened.json()["view_token"] == project["view_token"]
    assert opened.headers["etag"] == '"1"'
    assert opened.headers["cache-control"] == "no-store"


def test_the_request_comes_back_as_it_was_typed(client: TestClient):
    token = client.post(ADDRESS, json=document(lead="10,00 mm")).json()["edit_token"]
    shown = client.get(f"{ADDRESS}/{token}").json()["document"]["axes"][0]["request"]
    assert shown["mechanism"]["lead_mm"] == "10,00 mm"


@pytest.mark.parametrize("version", ['"1"', "1", 'W/"1"'])
def test_a_save_names_the_version_it_was_made_from(client: TestClient, project: dict[str, Any], version: str):
    response = save(client, project["edit_token"], document("Portal 2"), version)
    assert response.status_code == 200
    assert response.headers["etag"] == '"2"'
    assert response.json()["title"] == "Portal 2"


@pytest.mark.parametrize("version", [None, "*", '"new"', "-1", "99999999999999999999", "²"])
def test_a_save_without_a_version_is_refused(client: TestClient, project: dict[str, Any], version: str | None):
    headers = {} if version is None else {"If-Match": version.encode()}
    response = client.put(f"{ADDRESS}/{project['edit_token']}", json=document(), headers=headers)  # type: ignore[arg-type]
    assert response.status_code == 428
    assert "If-Match" in response.json()["detail"]


def test_of_two_saves_from_one_version_the_second_is_refused(client: TestClient, project: dict[str, Any]):
    assert save(client, project["edit_token"], document("first"), 1).status_code == 200
    refused = save(client, project["edit_token"], document("second"), 1)
    assert refused.status_code == 412
    assert refused.json()["current_version"] == 2
    assert client.get(f"{ADDRESS}/{project['edit_token']}").json()["title"] == "first"


def test_the_view_link_changes_nothing(client: TestClient, project: dict[str, Any]):
    token = project["view_token"]
    assert client.get(f"{ADDRESS}/{token}").json()["can_edit"] is False
    assert save(client, token, document(), 1).status_code == 403
    assert client.delete(f"{ADDRESS}/{token}", headers={"If-Match": "1"}).status_code == 403
    restore = client.post(f"{ADDRESS}/{token}/revisions/1/restore", headers={"If-Match": "1"})
    assert restore.status_code == 403


def test_revisions_are_listed_opened_compared_and_restored(client: TestClient, project: dict[str, Any]):
    address = f"{ADDRESS}/{project['edit_token']}"
    save(client, project["edit_token"], document(lead=20), 1)
    listed = client.get(f"{address}/revisions", params={"limit": 1}).json()
    assert (listed["total"], [item["number"] for item in listed["items"]]) == (2, [2])
    assert client.get(f"{address}/revisions/1").json()["document"] == project["document"]
    compared = client.get(f"{address}/comparison", params={"first": 1, "second": 2}).json()
    path = ["axes", 0, "request", "mechanism", "lead_mm"]
    assert compared["differences"] == [{"path": path, "before": 10, "after": 20}]
    restored = client.post(f"{address}/revisions/1/restore", headers={"If-Match": '"2"'}).json()
    assert (restored["version"], restored["document"]) == (3, project["document"])
    assert client.get(f"{address}/revisions/9").status_code == 404


def test_an_export_holds_no_token_and_is_imported_as_it_is(client: TestClient, project: dict[str, Any]):
    response = client.get(f"{ADDRESS}/{project['view_token']}/export")
    assert "attachment" in response.headers["content-disposition"]
    assert project["edit_token"] not in response.text
    assert project["view_token"] not in response.text
    again = client.post(ADDRESS, content=response.content, headers={"content-type": "application/json"})
    assert again.status_code == 201
    assert again.json()["document"] == response.json()


def test_a_duplicate_has_links_of_its_own(client: TestClient, project: dict[str, Any]):
    copy = client.post(f"{ADDRESS}/{project['view_token']}/duplicate")
    assert copy.status_code == 201
    assert copy.json()["edit_token"] != project["edit_token"]
    assert save(client, copy.json()["edit_token"], document("copy"), 1).status_code == 200
    assert client.get(f"{ADDRESS}/{project['edit_token']}").json()["title"] == "Portal"


def test_a_deleted_project_is_gone(client: TestClient, project: dict[str, Any]):
    address = f"{ADDRESS}/{project['edit_token']}"
    assert client.delete(address, headers={"If-Match": "2"}).status_code == 412
    assert client.delete(address, headers={"If-Match": "1"}).status_code == 204
    assert client.get(address).status_code == 404
    assert client.get(f"{ADDRESS}/{project['view_token']}").status_code == 404


def test_a_refused_save_stores_nothing(client: TestClient, project: dict[str, Any]):
    refused = save(client, project["edit_token"], document(lead="ten"), 1)
    assert refused.status_code == 422
    assert refused.json()["errors"][0]["name"] == "axes.0.request.mechanism.lead_mm"
    assert client.get(f"{ADDRESS}/{project['edit_token']}/revisions").json()["total"] == 1


def test_the_editions_in_use_are_kept_with_every_save(client: TestClient, project: dict[str, Any]):
    loaded = client.get("/api/v1/catalog/editions", params={"limit": 200}).json()
    assert {edition["key"] for edition in project["catalogue_editions"]} == {item["key"] for item in loaded["items"]}
