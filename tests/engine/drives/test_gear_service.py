"""Industrial gear units: service factor by load class, worm factors, overhung load, backlash, speed of the ratio."""

import numpy as np
import pytest

from app.engine.drives.gear_service import GearCase, GearService, load_changes, record_gear_service
from app.engine.mechanisms.load import Load, LoadState, Statics
from app.engine.products import GearUnit
from app.engine.sheet import Check, Sheet, Verdict
from app.engine.tables import Table
from tests.engine.drives.cases import cycle

RPM = np.pi / 30
TABLES = {
    "service_factor_f_b_class_1": 1.1,
    "service_factor_f_b_class_2": 1.3,
    "service_factor_f_b_class_3": 1.6,
    "overhung_f_z_sprocket": 1.25,
    "worm_f_b1": 1.38,
}
"""One value per table, whatever is asked."""


def case(state: dict[str, object] | None = None, gear: dict[str, object] | None = None, **more: object) -> GearCase:
    """The gear unit of SEW 2001, 8.2: R27 with 130 N m and 3530 N behind 0.55 kW at 2700 rpm, i = 45."""
    known: dict[str, object] = {
        "key": "laden_forward", "label": "laden", "direction": 1.0, "torque": 60.0, "inertia": 1.0,
        "speed": 60 * RPM, "efficiency": 0.9, "travel": 0.125, "starts": 2.0,
    }  # fmt: skip
    of = cycle((48.0, 6.0, 6.0, 60.0, False))
    statics = Statics(60.0, 60.0, -60.0, 0.0, 60.0, 6.0, 6.0)
    unit: dict[str, object] = {"kind": "helical", "ratio": 45.0, "max_output_torque": 130.0,
                               "permissible_overhung_load": 3530.0}  # fmt: skip
    service = GearService.model_validate(more.pop("service", {}))
    values: dict[str, object] = {
        "gear": GearUnit(id="g", manufacturer="", series="", model="", source="test", **(unit | (gear or {}))),
        "service": service, "load": Load(cycle=of, statics=statics, states=(LoadState(**(known | (state or {}))),)),
        "motor_speed": 2700 * RPM, "rated_torque": 550 / (2700 * RPM), "external_inertia": 0.0047,
        "motor_inertia": 0.0025, "efficiency": 0.95, "ambient": 313.15, "duty": 0.667,
    }  # fmt: skip
    return GearCase(**(values | more))  # type: ignore[arg-type]


def run(of: GearCase, tables: dict[str, float] = TABLES) -> tuple[Sheet, dict[str, Check]]:
    made = {key: Table(key, key, "test", ((0.0, ((0.0, value),)),), clamped=True) for key, value in tables.items()}
    sheet = Sheet(tables=made)
    record_gear_service(of, sheet)
    return sheet, {check.key: check for check in sheet.checks}


def test_the_gear_unit_of_the_handbook_has_a_service_factor_of_1_49():
    """SEW 2001, 8.2: 87.5 N m at 60 rpm, 130 N m permitted: f_B = 1.49."""
    sheet, checks = run(case())
    assert sheet.value("gear_output_torque") == pytest.approx(87.535, rel=1e-4)
    assert checks["service_factor"].permitted == pytest.approx(1.485, rel=1e-3)
    assert checks["service_factor"].demanded == 1.3  # 0.0047 / 0.0025 = 1.88: class II


@pytest.mark.parametrize(
    ("external", "factor"), [(0.0005, 1.1), (0.00051, 1.3), (0.0075, 1.3), (0.0076, 1.6), (0.025, 1.6)]
)
def test_the_load_class_changes_at_0_2_and_3(external: float, factor: float):
    assert run(case(external_inertia=external))[1]["service_factor"].demanded == factor


def test_above_a_factor_of_inertia_of_10_only_the_maker_knows():
    assert run(case(external_inertia=0.0251))[1]["service_factor"].verdict == Verdict.NOT_CHECKED
    own = case(external_inertia=0.0251, service={"service_factor": 1.45})
    assert run(own)[1]["service_factor"].demanded == 1.45


def test_without_a_table_nothing_is_guessed():
    assert run(case(), {})[1]["service_factor"].verdict == Verdict.NOT_CHECKED


def test_each_start_is_two_load_changes():
    """2 starts in 48 s are 150 per hour; each is followed by a stop."""
    assert load_changes(case(), Sheet()) == pytest.approx(300)
    assert load_changes(case(service={"load_changes_per_hour": 12}), Sheet()) == 12


@pytest.mark.parametrize("kind", ["worm", "helical_worm"])
def test_worm_gear_units_have_two_more_factors(kind: str):
    """The maker's catalogue: 1.51 * 1.38 * 0.95 = 1.98."""
    service = {"service_factor": 1.51, "duty_factor": 0.95}
    assert run(case(gear={"kind": kind}, service=service))[1]["service_factor"].demanded == pytest.approx(1.97961)
    lacking = run(case(gear={"kind": kind}, service={"service_factor": 1.51}))[1]["service_factor"]
    assert lacking.verdict == Verdict.NOT_CHECKED


def test_overhung_load_takes_the_sprocket_on_the_gear_shaft():
    """SEW 2001, 8.2: 17 teeth, 135.4 mm: 1617 N of 3530 N."""
    service = {"output_element": "sprocket", "output_element_diameter_mm": 135.4, "output_element_teeth": 17}
    check = run(case(service=service))[1]["overhung_load"]
    assert check.demanded == pytest.approx(1616.2, rel=1e-4)
    assert check.verdict == Verdict.OK
    blind = run(case(service={"output_element": "sprocket"}))[1]["overhung_load"]
    assert "diameter" in blind.missing


@pytest.mark.parametrize(("efficiency", "word"), [(0.5, "holds the load"), (0.51, "does not hold")])
def test_half_an_efficiency_is_self_locking(efficiency: float, word: str):
    sheet, _ = run(case(gear={"kind": "worm"}, efficiency=efficiency))
    assert any(word in decision.text for decision in sheet.decisions)


def test_backlash_becomes_a_distance_on_the_machine():
    """1 mrad on a radius of 125 mm is 0.125 mm."""
    sheet, checks = run(case(gear={"backlash": 0.001}, service={"permitted_backlash_mm": 0.1}))
    assert sheet.value("backlash_on_load") == pytest.approx(0.125e-3)
    assert checks["backlash"].verdict == Verdict.FAILS


def test_the_speed_of_the_chosen_ratio_is_compared_with_the_demanded_one():
    """SEW 2001, 11: 0.481 m/s instead of 0.5 m/s: 3.8 % less."""
    slow = {"speed": 60 * RPM * 0.5 / 0.481}
    sheet, checks = run(case(slow))
    assert sheet.value("gear_speed_deviation") == pytest.approx(-0.038)
    assert checks["load_speed"].verdict == Verdict.OK
    assert run(case(slow, service={"speed_tolerance_percent": 3}))[1]["load_speed"].verdict == Verdict.FAILS
    assert "load_speed" not in run(case(slow, highest_speed=300.0))[1]


def test_the_highest_speed_of_an_inverter_counts_at_the_input():
    unit = {"max_input_speed": 290.0}
    assert run(case(gear=unit))[1]["gear_input_speed"].verdict == Verdict.TIGHT
    assert run(case(gear=unit, highest_speed=300.0))[1]["gear_input_speed"].verdict == Verdict.FAILS


def test_a_worm_gear_unit_must_start_at_the_efficiency_of_standstill():
    """60 N m / 0.9 behind i = 45 at an efficiency of 0.4: 3.704 N m."""
    check = run(case(service={"start_up_efficiency": 0.4}, run_up_torque=3.7))[1]["break_away"]
    assert check.demanded == pytest.approx(60 / 0.9 / 45 / 0.4)
    assert check.verdict == Verdict.FAILS
    assert run(case(service={"start_up_efficiency": 0.4}))[1]["break_away"].verdict == Verdict.NOT_CHECKED
