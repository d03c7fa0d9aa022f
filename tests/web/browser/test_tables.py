"""The standard tables in a real browser: the chart is drawn, and a narrow window does not scroll sideways."""

from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from playwright.sync_api import Page

NARROW = {"width": 360, "height": 740}
WIDE_TABLES = ["duty_types", "iec_60034_30_1_nominal_efficiency_50hz", "derating", "service_factor_f_b_class_2"]


def test_from_the_catalogue_to_a_chart(page: "Page") -> None:
    page.goto("/catalogue")
    page.get_by_role("link", name="All standard tables").click()
    page.get_by_label("Topic").select_option(label="Gear units")
    page.get_by_role("button", name="Search").click()
    page.get_by_role("link", name="Service factor f_B of gear units, load class II", exact=True).click()
    page.locator(".chart-live .js-plotly-plot, .chart-live.js-plotly-plot").wait_for()
    assert page.locator(".chart-static").is_hidden()
    assert page.locator(".chart-live .scatterlayer .trace").count() == 3
    assert page.locator("tbody tr").count() == 12


@pytest.mark.parametrize("key", WIDE_TABLES)
def test_a_wide_table_scrolls_inside_a_narrow_window(page: "Page", key: str) -> None:
    page.set_viewport_size(NARROW)
    page.goto(f"/tables/{key}")
    page.wait_for_load_state("networkidle")
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    inner = page.locator(".table-scroll").first
    assert inner.evaluate("one => one.scrollWidth > one.clientWidth")
    inner.evaluate("one => { one.scrollLeft = 1000 }")
    assert inner.evaluate("one => one.scrollLeft") > 0
