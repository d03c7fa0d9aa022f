"""The pages of the standard tables: the list, every table with its source, and the way to them from a sheet."""

import re
from html import unescape
from typing import TYPE_CHECKING

import pytest

from app.settings import PROJECT_ROOT

if TYPE_CHECKING:
    from starlette.testclient import TestClient

KEYS = sorted(path.stem for path in (PROJECT_ROOT / "catalog_data" / "standards").glob("*/*.json"))


def test_the_list_leads_to_every_table(client: "TestClient") -> None:
    text = client.get("/tables").text
    assert sorted(re.findall(r'href="/tables/([^"?]+)"', text)) == KEYS
    assert f"{len(KEYS)} tables" in text
    assert len(re.findall(r"<h1[ >]", text)) == 1
    for place in ("/", "/catalogue"):
        assert 'href="/tables"' in client.get(place).text


def test_the_list_is_filtered_and_keeps_what_was_asked(client: "TestClient") -> None:
    text = client.get("/tables?text=friction&topic=friction").text
    found = re.findall(r'href="/tables/([^"?]+)"', text)
    assert "sliding_friction" in found
    assert "duty_types" not in found
    assert 'value="friction"' in text
    assert '<option value="friction" selected>' in text
    assert "0 tables" in client.get("/tables?text=nothing-like-it").text


def test_every_table_is_shown_with_explanation_and_source(client: "TestClient") -> None:
    for key in KEYS:
        answer = client.get(f"/tables/{key}")
        assert answer.status_code == 200, key
        assert len(re.findall(r"<h1[ >]", answer.text)) == 1, key
        assert "<tbody>" in answer.text, key
        assert "Source:" in answer.text, key
        assert 'class="explanation"' in answer.text, key
        rows = [row.count("<th") + row.count("<td") for row in re.findall(r"<tr>(.*?)</tr>", answer.text, re.S)]
        assert rows, key


def test_a_chart_is_drawn_with_its_points_below(client: "TestClient") -> None:
    text = client.get("/tables/derating_f_t").text
    assert 'data-chart="derating-f-t"' in text
    assert "<svg" in text
    assert "/static/js/charts.js" in text
    assert re.search(r'<th scope="row" class="numeric">50</th>\s*<td class="numeric">0.92</td>', text)
    assert "[°C]" in text
    single = client.get("/tables/overhung_f_z_v_belt").text
    assert "data-chart" not in single  # one point is no curve
    assert "Beyond its ends" in single
    assert "drawn shortened" in client.get("/tables/din_22101_c_factor").text


@pytest.mark.parametrize("key", ["none", "duty_types%20", "..%2Fetc"])
def test_an_unknown_table_is_a_page_that_says_so(client: "TestClient", key: str) -> None:
    answer = client.get(f"/tables/{key}", headers={"accept": "text/html"})
    assert answer.status_code == 404
    assert len(re.findall(r"<h1[ >]", answer.text)) == 1


def test_a_reading_on_the_sheet_leads_to_its_table(client: "TestClient") -> None:
    """SEW 2001, 13: factor C and starting frequency factor are read from charts."""
    text = client.get("/workbench/din_belt_conveyor?example=sew-13-belt-conveyor&request=main").text
    links = set(re.findall(r'<a href="(/tables/[^"]+)">([^<]+)</a>', text))
    assert {link for link, _ in links} == {"/tables/din_22101_c_factor", "/tables/starting_frequency_k_p"}
    for link, shown in links:
        title = re.search(r"<h1>(.*?)</h1>", client.get(link).text)
        assert title is not None
        assert unescape(shown).startswith(unescape(title[1]))
