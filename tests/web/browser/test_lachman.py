"""The main job in a real browser: the feed axis of Lachman and Mendricky, typed with the keyboard.

Expected values are those of the worked example: total stiffness 423.6 N/um, natural frequency 163.8 Hz, static working
torque 48.92 N m (examples/lachman-ball-screw-axis.json).
"""

from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from playwright.sync_api import Page, Request

MECHANISM = {
    "slide_mass_kg": "400",
    "inclination_deg": "60",
    "specific_friction_n_kg": "1",
    "nominal_diameter_mm": "50",
    "lead_mm": "20",
    "length_mm": "1 m",
    "bearing_stiffness_n_um": "1000",
    "loaded_turns": "3,5",
    "stressed_length_mm": "540",
    "efficiency": "1",
}
CHOICES = {
    "mechanism.friction_model": "per_mass",
    "mechanism.mounting": "supported_supported",
    "mechanism.screw_friction": "diameter_rule",
}
MOVES = (
    {"distance_mm": "180", "speed_m_s": "30 m/min", "acceleration_m_s2": "5"},
    {"distance_mm": "-180", "speed_m_s": "30 m/min", "acceleration_m_s2": "5"},
    {"distance_mm": "180", "speed_m_s": "12 m/min", "acceleration_m_s2": "5", "process_force_n": "10 kN"},
    {"distance_mm": "-180", "speed_m_s": "12 m/min", "acceleration_m_s2": "5"},
)


def control_of(name: str) -> str:
    """Selector of the control of a dotted path."""
    return f'[name="{name}"]'


def reveal(page: "Page", name: str) -> None:
    """Open every closed group around an entry with the keyboard."""
    closed = page.locator(f"details:not([open]):has({control_of(name)}) > summary")
    while closed.count():
        closed.first.press("Enter")


def type_in(page: "Page", name: str, text: str) -> None:
    """Type into an entry as a reader does."""
    reveal(page, name)
    entry = page.locator(control_of(name))
    entry.focus()
    page.keyboard.type(text)


def fill_form(page: "Page") -> None:
    """Type the whole axis."""
    for name, value in CHOICES.items():
        reveal(page, name)
        page.locator(control_of(name)).select_option(value)
    for name, text in MECHANISM.items():
        type_in(page, f"mechanism.{name}", text)
    for index, move in enumerate(MOVES):
        if index:
            add = page.locator('button[name="add"][value="motion.moves"]')
            add.focus()
            page.keyboard.press("Enter")
            page.wait_for_selector(control_of(f"motion.moves.{index}.distance_mm"), state="attached")
        for name, text in move.items():
            type_in(page, f"motion.moves.{index}.{name}", text)


def test_the_feed_axis_typed_by_hand(page: "Page") -> None:
    page.goto("/workbench/ball_screw")
    assert page.locator("[data-verdict]").inner_text().count("to go")
    fill_form(page)
    stiffness = page.locator('[data-headline="total_stiffness"] dd')
    stiffness.wait_for()
    assert stiffness.inner_text().startswith("423.6")
    assert page.locator('[data-headline="natural_frequency"] dd').inner_text().startswith("163.8") or page.locator(
        '[data-headline="natural_frequency"] dd'
    ).inner_text().startswith("163.79")
    page.get_by_role("tab", name="Calculation sheet").press("Enter")
    working = page.locator("#step-max_static_working_torque .step-result").first
    working.wait_for()
    assert "48.92" in working.inner_text()
    page.get_by_role("tab", name="Alternatives").press("Enter")
    rows = page.locator("table.alternatives tbody tr")
    rows.first.wait_for()
    assert rows.count() >= 5
    rows.first.get_by_role("button").press("Enter")
    page.locator(".parts-line").wait_for()
    assert page.locator('[data-check="peak_torque"]').count() == 1


def test_the_same_axis_without_scripts(page_without_scripts: "Page") -> None:
    page = page_without_scripts
    page.goto("/workbench/ball_screw")
    for name, value in CHOICES.items():
        reveal(page, name)
        page.locator(control_of(name)).select_option(value)
    for name, text in MECHANISM.items():
        type_in(page, f"mechanism.{name}", text)
    for name, text in MOVES[2].items():
        type_in(page, f"motion.moves.0.{name}", text)
    page.locator(".form-actions button[value=calculate]").press("Enter")
    page.wait_for_load_state()
    assert page.locator('[data-headline="total_stiffness"] dd').inner_text().startswith("423.6")
    assert page.locator("table.alternatives tbody tr").count() >= 5
    assert page.locator(".chart-figure svg.chart").count() >= 2
    assert page.locator(control_of("mechanism.length_mm")).input_value() == "1 m"


@pytest.mark.parametrize("text", ["abc", "5 kg", "NaN", "1e400", "-3", "0"])
def test_a_refused_entry_says_so_at_its_field_and_keeps_what_was_typed(page: "Page", text: str) -> None:
    page.goto("/workbench/ball_screw?example=lachman-ball-screw-axis&request=main")
    entry = page.locator(control_of("mechanism.nominal_diameter_mm"))
    entry.fill(text)
    error = page.locator('[data-field="mechanism.nominal_diameter_mm"] .error')
    error.wait_for()
    assert entry.input_value() == text
    assert entry.get_attribute("aria-invalid") == "true"
    assert "mm" in error.inner_text()


def test_an_answer_to_older_entries_is_dropped(page: "Page") -> None:
    page.goto("/workbench/ball_screw?example=lachman-ball-screw-axis&request=main")
    held = []
    page.route("**/result", lambda route: held.append(route) if not held else route.continue_())
    lead = page.locator(control_of("mechanism.lead_mm"))
    with page.expect_request("**/result"):
        lead.fill("10")
    lead.fill("40")
    page.wait_for_function(
        "() => document.querySelector('[data-headline=\"motor_speed_max\"] dd').textContent.includes('750')"
    )
    held[0].abort()
    assert "750" in page.locator('[data-headline="motor_speed_max"] dd').inner_text()


def test_a_narrow_window_needs_no_sideways_scrolling(page: "Page") -> None:
    page.set_viewport_size({"width": 380, "height": 800})
    for address in ("/", "/workbench/ball_screw?example=lachman-ball-screw-axis&request=main", "/examples"):
        page.goto(address)
        wide = page.evaluate("document.documentElement.scrollWidth - document.documentElement.clientWidth")
        assert wide <= 0, address


@pytest.mark.parametrize(
    "address",
    [
        "/",
        "/workbench/ball_screw",
        "/workbench/ball_screw?example=lachman-ball-screw-axis&request=main",
        "/workbench/timing_belt?mechanism.pulley_diameter_mm=abc",
        "/examples/lachman-ball-screw-axis",
        "/catalogue/servo_motor",
        "/formulas",
    ],
)
def test_a_page_has_no_barrier_that_axe_finds(page: "Page", address: str) -> None:
    from axe_playwright_python.sync_playwright import Axe

    page.goto(address)
    page.wait_for_load_state("networkidle")
    found = Axe().run(page)
    assert found.violations_count == 0, found.generate_report()


def test_the_first_page_is_light(page: "Page") -> None:
    requests: list[Request] = []
    page.on("requestfinished", lambda request: requests.append(request))  # a bound built-in is refused
    page.goto("/")
    page.wait_for_load_state("networkidle")
    sizes = [request.sizes()["responseBodySize"] for request in requests]
    assert 3 < len(sizes) < 20
    assert 10_000 < sum(sizes) < 100_000
