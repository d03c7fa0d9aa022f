"""Projects on the pages: saved, shared, changed by two people, restored, copied and closed."""

import json
import re
from typing import TYPE_CHECKING, Any
from urllib.parse import urlencode

import pytest

from app.settings import PROJECT_ROOT
from app.web.form_data import flat

if TYPE_CHECKING:
    from httpx import Response
    from starlette.testclient import TestClient

Pairs = list[tuple[str, str]]


@pytest.fixture(scope="module")
def axis() -> Pairs:
    """The horizontal screw axis as the form sends it."""
    file = json.loads((PROJECT_ROOT / "examples" / "tr-ball-screw.json").read_text(encoding="utf-8"))
    return list(flat(next(iter(file["requests"].values()))))


def post(client: "TestClient", address: str, pairs: Pairs) -> "Response":
    """Send a form without following where it leads."""
    headers = {"content-type": "application/x-www-form-urlencoded", "accept": "text/html"}
    return client.post(address, content=urlencode(pairs), headers=headers, follow_redirects=False)


def save(client: "TestClient", axis: Pairs) -> tuple[str, str]:
    """A new project: tokens to edit and to view."""
    answer = post(client, "/workbench/ball_screw", [*axis, ("action", "save")])
    assert answer.status_code == 303
    edit = answer.headers["location"].removeprefix("/p/").partition("?")[0]
    text = client.get(answer.headers["location"]).text
    view = re.search(r'id="view-link" value="[^"]*/p/([^"]+)"', text)
    assert view is not None
    return edit, view[1]


def again(axis: Pairs, version: int, **more: str) -> Pairs:
    """The form of a saved axis, as its page sends it."""
    return [*axis, ("_version", str(version)), ("_axis", "0"), ("action", "save"), *more.items()]


def document(client: "TestClient", token: str) -> Any:
    """What is stored."""
    return client.get(f"/api/v1/projects/{token}").json()["document"]


def test_a_link_to_view_shows_the_results_without_a_form(client: "TestClient", axis: Pairs) -> None:
    edit, view = save(client, axis)
    editable, readable = client.get(f"/p/{edit}").text, client.get(f"/p/{view}").text
    assert 'name="mechanism.lead_mm"' in editable
    assert "<form" not in readable.split("<main", 1)[1]
    # the worked example: 1500 rpm
    for text in (editable, readable):
        assert re.search(r'data-headline="motor_speed_max".*?1500 rpm', text, re.S)
    assert post(client, f"/p/{view}", again(axis, 1)).status_code == 403


def test_what_was_typed_is_what_is_stored(client: "TestClient", axis: Pairs) -> None:
    typed = [(name, "0.79 in" if name == "mechanism.lead_mm" else value) for name, value in axis]
    edit, _ = save(client, typed)
    assert document(client, edit)["axes"][0]["request"]["mechanism"]["lead_mm"] == "0.79 in"


def test_the_second_of_two_saves_is_told_and_loses_nothing(client: "TestClient", axis: Pairs) -> None:
    edit, _ = save(client, axis)
    assert post(client, f"/p/{edit}", again(axis, 1)).status_code == 303
    mine = [(name, "25" if name == "mechanism.lead_mm" else value) for name, value in axis]
    late = post(client, f"/p/{edit}", again(mine, 1))
    assert late.status_code == 412
    assert "Someone else saved this project" in late.text
    assert re.search(r'name="mechanism.lead_mm" value="25"', late.text)
    assert post(client, f"/p/{edit}", again(mine, 2)).status_code == 303
    assert document(client, edit)["axes"][0]["request"]["mechanism"]["lead_mm"] == "25"


def test_revisions_are_compared_and_restored(client: "TestClient", axis: Pairs) -> None:
    edit, _ = save(client, axis)
    changed = [(name, "25" if name == "mechanism.lead_mm" else value) for name, value in axis]
    post(client, f"/p/{edit}", again(changed, 1, _comment="steeper"))
    page = client.get(f"/p/{edit}/revisions?from=1&to=2").text
    assert "steeper" in page
    assert re.search(r"mechanism\.lead_mm.*?<td>2 cm</td><td>25</td>", page, re.S)
    assert "<form" not in client.get(f"/p/{edit}?revision=1").text.split("workbench-form")[1]
    assert post(client, f"/p/{edit}/restore", [("_version", "2"), ("_revision", "1")]).status_code == 303
    assert document(client, edit)["axes"][0]["request"]["mechanism"]["lead_mm"] == "2 cm"


def test_axes_are_copied_renamed_and_removed(client: "TestClient", axis: Pairs) -> None:
    edit, _ = save(client, axis)
    settings = f"/p/{edit}/settings"
    assert post(client, settings, [("_version", "1"), ("action", "duplicate-0")]).status_code == 303
    names = [("_version", "2"), ("_title", "Press"), ("_name_0", "X"), ("_name_1", "X"), ("action", "rename")]
    assert post(client, settings, names).status_code == 422  # two axes of one name
    names[3] = ("_name_1", "Y")
    assert post(client, settings, names).status_code == 303
    assert [one["name"] for one in document(client, edit)["axes"]] == ["X", "Y"]
    assert post(client, settings, [("_version", "3"), ("action", "remove-0")]).status_code == 303
    assert [one["name"] for one in document(client, edit)["axes"]] == ["Y"]
    assert client.get(f"/p/{edit}/new/timing_belt").status_code == 200


def test_an_export_is_imported_as_a_new_project(client: "TestClient", axis: Pairs) -> None:
    edit, _ = save(client, axis)
    exported = client.get(f"/p/{edit}/export").content
    made = client.post("/import", files={"file": ("project.json", exported)}, follow_redirects=False)
    copy = made.headers["location"].removeprefix("/p/").partition("?")[0]
    assert copy != edit
    assert document(client, copy) == document(client, edit)
    assert edit.encode() not in exported
    refused = client.post("/import", files={"file": ("project.json", b"no project")}, headers={"accept": "text/html"})
    assert refused.status_code == 400


def test_a_deleted_project_opens_no_more(client: "TestClient", axis: Pairs) -> None:
    edit, view = save(client, axis)
    assert post(client, f"/p/{edit}/settings", [("_version", "1"), ("action", "delete")]).status_code == 303
    assert {client.get(f"/p/{token}").status_code for token in (edit, view)} == {404}
