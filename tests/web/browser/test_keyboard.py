"""Every mechanism that is registered, filled in and calculated with nothing but the keyboard.

A new mechanism is tested here without a line of its own: its values are found from its declarations. Where they do not
fit together, the test says that it needs a case in ``entries.py``.
"""

import itertools
from typing import TYPE_CHECKING, Any
from urllib.parse import urlencode

import pytest

from app.engine.mechanisms import mechanisms
from app.engine.quantity import declaration
from app.reports.numbers import show
from app.web.form_data import flat
from app.web.form_models import border, row_of
from tests.web.browser.entries import BODIES, CASES, SHAPES, TURNING, Case, found_values, post, request_of, typed
from tests.web.browser.keyboard import Keyboard, Stop

if TYPE_CHECKING:
    from playwright.sync_api import Page, Route

KINDS = list(mechanisms())
OTHER_SHAPES = list(SHAPES)[1:]
"""All but the one that a new row begins with."""
DRAWN = """() => [...document.querySelectorAll("[data-chart]")].every((chart) => {
  const box = chart.getBoundingClientRect();
  const frame = document.querySelector(".workbench-result").getBoundingClientRect();
  const away = box.bottom <= frame.top + 1 || box.top >= Math.min(frame.bottom, innerHeight) - 1;
  return !box.height || away || chart.querySelector(".chart-static").hidden;
})"""
"""Every chart in view is a live one."""
LARGE = """key => [...document.querySelectorAll(`#charts [data-chart="${key}"] svg`)].some((one) => {
  const box = one.getBoundingClientRect();
  return Math.min(box.width, box.height) > 100;
})"""
"""A chart is drawn, be it the one of the server or the live one."""
ENTRIES = "input:not([type=hidden]), select, textarea"


def opened(page: "Page", kind: str) -> Keyboard:
    """The workbench of a mechanism with nothing in it, the focus before its first entry."""
    page.goto(f"/workbench/{kind}")
    keyboard = Keyboard(page)
    keyboard.skip_to_content()
    return keyboard


# --- the whole way ----------------------------------------------------------------------------------------------------


def numbers_are_shown(page: "Page", server: str, case: Case, request: dict[str, Any]) -> None:
    """The numbers known by hand, all others as REST gives them, and the further body on the calculation sheet."""
    answer = post(server, "sizings", request)
    assert answer.status_code == 200, answer.text
    expected = {one["key"]: show(one["value_si"], one["unit"]) for one in answer.json()["headlines"]}
    for key, text in (expected | case.headlines).items():
        page.locator(f'[data-headline="{key}"] dd', has_text=text).wait_for()
    numbers = page.locator("[data-headline]").evaluate_all(
        "all => all.map((one) => [one.dataset.headline, one.querySelector('dd').textContent.trim()])"
    )
    assert dict(numbers) == expected
    assert case.headlines.items() <= expected.items()
    inertia = page.locator("#step-further_inertia .step-result strong").first.text_content()
    assert inertia in ("0.01 kg·m²", "100 kg·cm²")


def charts_are_shown(page: "Page", server: str, case: Case, request: dict[str, Any]) -> None:
    """Every chart of the axis is drawn, with the series and axes that REST names."""
    answer = post(server, "charts", request).json()
    figures = {"torque-speed": answer["torque_speed"], "cycle": answer["cycle"], **answer["diagrams"]}
    figures = {key: figure for key, figure in figures.items() if figure is not None}
    assert case.diagrams.keys() <= figures.keys()
    assert page.locator("#charts").is_visible()
    shown = page.locator("#charts [data-chart]").evaluate_all("all => all.map((one) => one.dataset.chart)")
    assert sorted(shown) == sorted(figures)
    for key, figure in figures.items():
        chart = page.locator(f'#charts [data-chart="{key}"]')
        page.wait_for_function(LARGE, arg=key)
        assert chart.locator("caption").all_text_contents() == [trace["name"] for trace in figure["data"]]
    for key, axes in case.diagrams.items():
        heads = page.locator(f'#charts [data-chart="{key}"] table').first.locator("th").all_text_contents()
        assert [head.partition(" [")[0].partition(" in ")[0] for head in heads] == list(axes)


def table_opens(page: "Page", keyboard: Keyboard, chart: str) -> None:
    """The reader goes on to a chart and has its points listed."""
    keyboard.reach_element("#quadrants")
    page.wait_for_function(DRAWN)
    keyboard.reach_element(f'#charts [data-chart="{chart}"] summary', DRAWN)
    keyboard.press("Enter")
    table = page.locator(f'#charts [data-chart="{chart}"] table').first
    table.wait_for()
    assert table.locator("tbody tr").count() > 1


def filled_in(page: "Page", server: str, kind: str, case: Case, shape: str) -> None:
    """Fill in a case and read its result."""
    request = request_of(kind, case, shape)
    keyboard = opened(page, kind)
    entries = typed(request)
    keyboard.fill(entries)
    numbers_are_shown(page, server, case, request)
    for name, text in entries.items():
        assert page.locator(f'[name="{name}"]').input_value() == text
    assert page.locator("[aria-invalid]").count() == 0
    charts_are_shown(page, server, case, request)
    last = page.locator("#charts [data-chart]").last.get_attribute("data-chart")
    table_opens(page, keyboard, next(iter(case.diagrams), str(last)))


def case_of(kind: str, server: str) -> Case:
    """The case picked by hand, else one out of the declarations."""
    return CASES.get(kind) or Case(found_values(kind, server), {})


@pytest.mark.parametrize("kind", KINDS)
def test_a_mechanism_is_filled_in_with_the_keyboard(
    page: "Page", complaints: list[str], live_server: str, kind: str
) -> None:
    shape = OTHER_SHAPES[KINDS.index(kind) % len(OTHER_SHAPES)]
    filled_in(page, live_server, kind, case_of(kind, live_server), shape)
    assert complaints == []


def test_a_flying_saw_on_a_timing_belt(page: "Page", complaints: list[str], live_server: str) -> None:
    """The saw stops on 0.2 m/s squared / 2 = 0.02 m; the return of 0.82 m in 2 s at 1 m/s2 takes 1 - sqrt(1 - 0.82) =
    0.57574 m/s, which is 5.3557 rad/s on a pulley of 215 mm. From cut to cut 1 m / 0.2 m/s."""
    case = Case(
        {"slide_mass_kg": "50", "pulley_diameter_mm": "215"},
        {"motor_speed_max": "51.143 rpm"},
        motion={"kind": "flying_saw", "feed_speed_m_s": "0,2", "cut_length_mm": "1 m", "cutting_time_s": "1",
                "stroke_mm": "800", "acceleration_m_s2": "1", "return_time_s": "2"},
    )  # fmt: skip
    filled_in(page, live_server, "timing_belt", case, "hollow_cylinder")
    speed = page.locator('#charts [data-chart="cycle"] table').first
    assert speed.locator("tbody tr").last.locator("td").first.text_content() == "5"
    assert page.locator("#step-cycle_time .step-result strong").first.text_content() == "5 s"
    assert complaints == []


def test_a_fan_that_is_started_in_star(page: "Page", complaints: list[str], live_server: str) -> None:
    """11 kW over 1460 rpm = 152.89 rad/s: 71.947 N m, run-up twice that, in star a third of it."""
    winding = {"poles": "4", "rated_power_kw": "11", "rated_speed_rpm": "1460", "run_up_torque_ratio": "2"}
    case = Case(
        {"rated_speed_rpm": "1460", "rated_power_kw": "4 kW", "rotor_inertia_kgm2": "0,5"},
        {"rated_torque": "71.947 N·m", "run_up_torque": "143.89 N·m", "star_run_up_torque": "47.965 N·m"},
        motion=TURNING | {"speed_rpm": "1460"},
        drive={"kind": "mains", "motor": {"own": {"rotor_inertia_kgm2": "0.05", "windings": [winding]}},
               "starting": "star_delta"},
        diagrams={"run-up": ("motor speed", "torque at the motor shaft"), "machine-torque": ("Speed", "Torque")},
    )  # fmt: skip
    filled_in(page, live_server, "fan", case, "hollow_cylinder")
    series = page.locator('#charts [data-chart="run-up"] caption').all_text_contents()
    assert {"mean run-up torque, in star", "mean run-up torque", "load: running"} <= set(series)
    assert complaints == []


def test_what_two_entries_demand_of_a_third_leads_to_it(page: "Page") -> None:
    """A fan with speed and inertia still needs its power: the word for it is a link to that entry."""
    keyboard = opened(page, "fan")
    request = {"mechanism": {"rated_speed_rpm": "1000", "rotor_inertia_kgm2": "8"}, "motion": TURNING}
    keyboard.fill(typed(request))
    link = page.locator("[data-result] a", has_text="power").first
    link.wait_for()
    assert link.get_attribute("href") == "#f-mechanism-rated_power_kw"


def test_a_chart_that_comes_late_does_not_push_the_focus_away(page: "Page") -> None:
    """On a slow line the reader stands below the last chart before the charts are live."""
    held: list[Route] = []
    page.route("**/plotly.min.js", lambda route: held.append(route))
    request = request_of("travel_drive", CASES["travel_drive"], "given")
    keyboard = opened(page, "travel_drive?" + urlencode(list(flat(request))))
    keyboard.reach_element('#charts [data-chart="cycle"] summary')
    assert len(held) == 1
    held[0].continue_()
    page.wait_for_function(DRAWN)
    assert keyboard.stop() is not None


# --- the order of the entries -----------------------------------------------------------------------------------------


def all_stops(keyboard: Keyboard, last: str) -> list[Stop]:
    """Every stop up to an entry; closed groups are opened on the way."""
    found = []
    for stop in keyboard.walk(lambda stop: stop.name == last):
        if stop.folded:
            keyboard.press("Enter")
        found.append(stop)
    return found


@pytest.mark.parametrize("kind", KINDS)
def test_tab_passes_every_entry_once_and_in_the_order_of_the_page(
    page: "Page", complaints: list[str], kind: str
) -> None:
    keyboard = opened(page, kind)
    stops = all_stops(keyboard, "motion.kind")
    entries = [stop for stop in stops if stop.name.startswith("mechanism.")]
    names = [stop.name for stop in entries]
    on_page = page.locator("[aria-labelledby=part-mechanism]").locator(ENTRIES).locator("visible=true")
    assert names == on_page.evaluate_all("all => all.map((one) => one.name)")
    fields = mechanisms()[kind].model_fields.items()
    declared = [border(name, info) for name, info in fields if declaration(info) is not None and row_of(info) is None]
    assert {f"mechanism.{name}" for name in declared} <= set(names)
    for one, following in itertools.pairwise(entries):
        left, top, right, bottom = one.box
        assert following.box[3] > top, f"{following.name} stands above {one.name}"
        assert following.box[0] >= right or following.box[1] >= bottom, f"{following.name} stands before {one.name}"
        assert left >= 0
    first = stops[0]
    back = list(keyboard.walk(lambda stop: stop.key == first.key, back=True))
    assert [stop.key for stop in back] == [stop.key for stop in stops[-2::-1]]
    assert complaints == []


@pytest.mark.parametrize("kind", ["ball_screw", "rotary_load", "fan"])
def test_nothing_lies_over_what_has_the_focus(page: "Page", kind: str) -> None:
    """From the first entry to the last one, the notes: in the longest form, one with a list, and a short one."""
    hidden = [f"{stop.key} lies below {stop.below}" for stop in all_stops(opened(page, kind), "notes") if stop.below]
    assert not hidden, "\n".join(hidden)


# --- the values themselves --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", KINDS)
def test_a_mechanism_without_a_case_gets_values_from_its_declarations(live_server: str, kind: str) -> None:
    assert found_values(kind, live_server)


def test_every_shape_has_its_values_and_its_turn() -> None:
    assert set(BODIES) == set(SHAPES)
    assert len(KINDS) >= len(OTHER_SHAPES)
