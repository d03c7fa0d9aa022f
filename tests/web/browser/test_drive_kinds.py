"""Each kind of drive on a travel drive, chosen and typed from a data sheet with nothing but the keyboard.

1500 kg on wheels of 250 mm at 0.5 m/s: the wheels turn with 0.5 / 0.125 = 4 rad/s, which is 38.197 rpm.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any
from urllib.parse import urlencode

import pytest

from app.engine.drives import drives
from app.web.form_data import flat
from tests.web.browser.keyboard import Keyboard

if TYPE_CHECKING:
    from playwright.sync_api import Page

MECHANISM = {
    "kind": "travel_drive",
    "vehicle_mass_kg": 1500,
    "wheel_diameter_mm": 250,
    "journal_diameter_mm": 60,
    "stage_ratio": 1,
}
TRIPS = {
    "kind": "trips",
    "speed_m_s": 0.5,
    "cycles_per_hour": 75,
    "runs": [{"label": "laden", "payload_kg": 1500, "duration_s": 9.6}, {"label": "empty", "duration_s": 9.6}],
}
MOVES = {
    "kind": "moves",
    "moves": [{"label": "out", "distance_mm": 5000, "speed_m_s": 0.5, "acceleration_m_s2": 0.25, "payload_kg": 1500}],
    "cycle_time_s": 30,
}


@dataclass(frozen=True)
class Case:
    """What is typed for one kind of drive, and what must be seen then."""

    begin: str
    """Kind of drive that is chosen before."""
    motion: dict[str, Any]
    typed: tuple[tuple[str, str], ...]
    """Entries in the order of the page: ``choose`` in front of a choice, ``add`` in front of a list."""
    headlines: dict[str, str]
    charts: dict[str, set[str]]
    """Series of each chart."""


MOTOR, GEAR = "drive.motor", "drive.gear_unit"
WINDING = f"{MOTOR}.own.windings"
OVER_TIME = {
    "torque-speed": {"S1 curve (continuous)", "peak curve", "cycle", "mean speed, effective torque"},
    "cycle": {"motor speed", "motor torque", "motor power", "load torque at the output"},
}


def own_motor(**entries: str) -> tuple[tuple[str, str], ...]:
    """Entries of a motor from its data sheet."""
    return (
        (f"choose {MOTOR}._choice", "own"),
        *((f"{MOTOR}.own.{name}", text) for name, text in entries.items()),
    )


def winding(number: int, **entries: str) -> tuple[tuple[str, str], ...]:
    """Entries of one winding."""
    return tuple((f"{WINDING}.{number}.{name}", text) for name, text in entries.items())


def own_gear_unit(ratio: str) -> tuple[tuple[str, str], ...]:
    """Entries of a gear unit from its data sheet."""
    return ((f"choose {GEAR}._choice", "own"), (f"{GEAR}.own.ratio", ratio))


CASES = {
    # 4 rad/s * 50 = 200 rad/s
    "servo": Case(
        begin="inverter_fed",
        motion=MOVES,
        typed=(
            *own_motor(
                rated_speed_rpm="3000", stall_torque_nm="12", rated_torque_nm="9,5", peak_torque_nm="36",
                rotor_inertia_kgcm2="21 kgcm2",
            ),
            *own_gear_unit("50"),
        ),
        headlines={"motor_speed_max": "1909.9 rpm"},
        charts=OVER_TIME,
    ),
    # 550 W / (2700 * pi / 30 rad/s) = 1.9452 N m, run-up 1.9 of that
    "mains": Case(
        begin="servo",
        motion=TRIPS,
        typed=(
            *own_motor(rotor_inertia_kgm2="5.51 kgcm2"),
            *winding(0, poles="2", rated_power_kw="550 W", rated_speed_rpm="2700", run_up_torque_ratio="1.9"),
            *own_gear_unit("70,7"),
        ),
        headlines={"rated_torque": "1.9452 N·m", "run_up_torque": "3.6959 N·m"},
        charts={"run-up": {"mean run-up torque", "points of the data sheet", "load: laden"}},
    ),
    # 250 W / (2670 * pi / 30 rad/s) * 1.8 = 1.6094 N m; 2.5 * 60 W / (675 * pi / 30 rad/s) * 1.4 = 2.9709 N m
    "pole_changing": Case(
        begin="mains",
        motion=TRIPS,
        typed=(
            *own_motor(rotor_inertia_kgm2="0.00053"),
            *winding(0, poles="8", rated_power_kw="0.06", rated_speed_rpm="675", run_up_torque_ratio="1.4"),
            ("add", WINDING),
            *winding(1, poles="2", rated_power_kw="0.25", rated_speed_rpm="2670", run_up_torque_ratio="1.8"),
            *own_gear_unit("69.9"),
        ),
        headlines={"run_up_torque_high": "1.6094 N·m", "change_over_torque": "2.9709 N·m"},
        charts={"run-up": {"mean run-up torque, 2 poles", "mean run-up torque, 8 poles", "load: laden"}},
    ),
    # 4 rad/s * 20 = 80 rad/s
    "inverter_fed": Case(
        begin="servo",
        motion=MOVES,
        typed=(
            *own_motor(rotor_inertia_kgm2="0.0059"),
            *winding(0, poles="4", rated_power_kw="2.2", rated_speed_rpm="1410"),
            *own_gear_unit("20"),
        ),
        headlines={"motor_speed_max": "763.94 rpm"},
        charts=OVER_TIME,
    ),
    # a quarter of 38.197 rpm
    "variator": Case(
        begin="servo",
        motion=TRIPS,
        typed=(
            ("choose drive.variable_speed_gear._choice", "given"),
            ("choose drive.variable_speed_gear.design", "belt"),
            ("drive.variable_speed_gear.lowest_speed_rpm", "9"),
            ("drive.variable_speed_gear.highest_speed_rpm", "54"),
            ("drive.variable_speed_gear.torque_at_lowest_speed_nm", "300"),
            ("drive.variable_speed_gear.torque_at_highest_speed_nm", "120"),
            ("drive.variable_speed_gear.efficiency", "0.85"),
            *own_motor(rotor_inertia_kgm2="0.0035"),
            *winding(0, poles="4", rated_power_kw="1.5", rated_speed_rpm="1400", run_up_torque_ratio="2"),
            ("drive.speed_range", "4"),
        ),
        headlines={"lowest_output_speed": "9.5493 rpm"},
        charts={"variator": {"demanded", "permitted"}},
    ),
}  # fmt: skip


def enter(keyboard: Keyboard, entries: tuple[tuple[str, str], ...]) -> None:
    """Enter everything, in the order of the page."""
    for what, text in entries:
        word, _, name = what.rpartition(" ")
        if word == "choose":
            keyboard.choose(name, text)
        elif what == "add":
            keyboard.add(text)
        else:
            keyboard.type(name, text)


def opened(page: "Page", case: Case) -> Keyboard:
    """The travel drive with its motion and another kind of drive, no part of it chosen."""
    request = {"mechanism": MECHANISM, "motion": case.motion, "drive": {"kind": case.begin}}
    page.goto("/workbench/travel_drive?" + urlencode(list(flat(request))))
    return Keyboard(page)


def series_of(page: "Page", chart: str) -> set[str]:
    """Names of the series of a chart, out of the table below it."""
    return set(page.locator(f'#charts [data-chart="{chart}"] caption').all_text_contents())


def test_every_kind_of_drive_has_its_case() -> None:
    assert set(CASES) == set(drives())


@pytest.mark.parametrize("kind", drives())
def test_a_drive_is_chosen_and_typed_with_the_keyboard(page: "Page", kind: str) -> None:
    case = CASES[kind]
    keyboard = opened(page, case)
    keyboard.skip_to_content()
    keyboard.choose("drive.kind", kind)
    enter(keyboard, case.typed)
    for key, value in case.headlines.items():
        page.locator(f'[data-headline="{key}"] dd', has_text=value).wait_for()
    for what, text in case.typed:
        if what != "add":
            assert page.locator(f'[name="{what.rpartition(" ")[2]}"]').input_value() == text
    assert page.locator("[aria-invalid]").count() == 0
    assert page.locator("[data-verdict] .verdict-banner-word").inner_text() in (
        "Holds", "Holds, but tight", "Does not hold",
    )  # fmt: skip
    assert "own motor" in page.locator(".parts-line").inner_text()
    for chart, series in case.charts.items():
        figure = page.locator(f'#charts [data-chart="{chart}"]')
        figure.wait_for()
        assert figure.locator("svg").locator("visible=true").count() >= 1
        assert series <= series_of(page, chart)
