"""The standard tables over REST."""

import pytest
from starlette.testclient import TestClient

from app.settings import PROJECT_ROOT

ADDRESS = "/api/v1/tables"


def test_pages_of_the_list_follow_each_other(client: TestClient):
    whole = client.get(ADDRESS, params={"limit": 200}).json()
    keys = [path.stem for path in (PROJECT_ROOT / "catalog_data" / "standards").glob("*/*.json")]
    assert sorted(one["key"] for one in whole["items"]) == sorted(keys)
    assert whole["total"] == len(keys)
    parts = [client.get(ADDRESS, params={"limit": 15, "offset": at}).json()["items"] for at in (0, 15, 30, 45)]
    assert [one for part in parts for one in part] == whole["items"]
    assert set(whole["items"][0]) == {"key", "title", "topic", "unit", "note", "source"}


def test_the_list_is_searched_and_narrowed(client: TestClient):
    found = client.get(ADDRESS, params={"q": "insulation", "topic": "protection"}).json()
    assert [one["key"] for one in found["items"]] == ["insulation_classes"]
    assert client.get(ADDRESS, params={"topic": "none"}).json()["total"] == 0


def test_a_table_has_its_data_and_its_rows(client: TestClient):
    found = client.get(f"{ADDRESS}/insulation_classes").json()
    assert found["data"][1] == {"class": "F", "max_temperature_rise_K": 105, "PTC_trip_temperature_degC": 150}
    assert found["chart"] is None
    (grid,) = found["grids"]
    assert [column["unit"] for column in grid["columns"]] == ["", "K", "°C"]
    assert grid["rows"][1] == ["F", "105", "150"]
    assert "SEW" in found["source"]


def test_a_chart_has_its_curves(client: TestClient):
    found = client.get(f"{ADDRESS}/derating_f_h").json()
    chart = found["chart"]
    assert (chart["x"], chart["value"], chart["family"], chart["clamped"]) == ("altitude in m", "factor f_H", "", False)
    # Siemens, NEMA motors 05/08: 1 up to 1000 m, 0.94 at 2000 m
    (curve,) = chart["curves"]
    assert curve["points"][0] == [1000, 1]
    assert [2000, 0.94] in curve["points"]


def test_every_table_of_the_list_can_be_asked_for(client: TestClient):
    for one in client.get(ADDRESS, params={"limit": 200}).json()["items"]:
        found = client.get(f"{ADDRESS}/{one['key']}")
        assert found.status_code == 200, one["key"]
        assert {name: found.json()[name] for name in one} == one


@pytest.mark.parametrize("key", ["none", "Duty_types", "1"])
def test_an_unknown_key_is_a_problem(client: TestClient, key: str):
    answer = client.get(f"{ADDRESS}/{key}")
    assert answer.status_code == 404
    assert answer.headers["content-type"] == "application/problem+json"
    assert answer.json()["type"].endswith("not-found")
