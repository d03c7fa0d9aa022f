"""Pole-changing motor: change-over, creep speed and heating, calculated by hand on a table and a hoist."""

import math
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.engine.sheet import Verdict
from tests.line_fed_requests import BRAKE, HOIST, TABLE, calculated, example, motor, refused, request, size

ONE = "unladen_forward"
UP, DOWN = "unladen_lifting", "unladen_lowering"
LOW: dict[str, Any] = {"poles": 8, "rated_power_kw": 0.14, "rated_speed_rpm": "70 rad/s", "run_up_torque_nm": 4}
HIGH: dict[str, Any] = {"poles": 2, "rated_power_kw": 3, "rated_speed_rpm": "300 rad/s"}
"""2 N m at 70 rad/s, run-up 4 N m; 10 N m at 300 rad/s, run-up 20 N m; synchronous 78.54 and 314.16 rad/s."""
DRIVE: dict[str, Any] = {
    "kind": "pole_changing", "motor": motor(LOW, HIGH), "gear_unit": {"own": {"ratio": 20, "efficiency": 0.8}},
}  # fmt: skip
FAST, FALLING = request(TABLE, drive=DRIVE), request(HOIST, drive=DRIVE)
"""The table: 0.01 kg m2 and 2 N m on the motor shaft; the hoist: 0.0025 kg m2 and 5 N m; all without losses."""
LOW_SYNC, HIGH_SYNC = 25 * math.pi, 100 * math.pi


def with_low(**values: Any) -> dict[str, Any]:
    return {"motor": motor({**LOW, **values}, HIGH)}


# --- changing over ----------------------------------------------------------------------------------------------------


def test_the_low_winding_slows_the_table_down():
    """2.5 * 4 = 10 N m. (0.01 + 0.01 * 0.8) * (300 - 70) / (10 + 2 * 0.8) = 0.35690 s; 15 to 3.5 rad/s at the table."""
    sheet = size(FAST).sheet
    time = 0.018 * 230 / 11.6
    assert sheet.value("change_over_torque") == pytest.approx(10)
    assert sheet.value(f"{ONE}_change_over_time") == pytest.approx(time)
    assert sheet.value(f"{ONE}_change_over_deceleration") == pytest.approx(11.5 / time)
    assert sheet.value(f"{ONE}_change_over_distance") == pytest.approx(18.5 / 2 * time)


def test_a_soft_change_has_half_the_torque():
    """0.018 * 230 / (5 + 1.6) s; the run-up does not change."""
    hard, soft = size(FAST).sheet, size(FAST, drive={"soft_change": True}).sheet
    assert soft.value(f"{ONE}_change_over_time") == pytest.approx(0.018 * 230 / 6.6)
    assert soft.value(f"{ONE}_run_up_time") == hard.value(f"{ONE}_run_up_time")


def test_where_friction_slows_down_harder_than_the_motor_losses_divide():
    """0.5 N m of change-over torque against 2 N m: the rotor still drives. 0.0225 * 230 / (0.5 + 2 / 0.8) s."""
    sheet = size(FAST, drive=with_low(run_up_torque_nm=0.2)).sheet
    assert sheet.value(f"{ONE}_change_over_time") == pytest.approx(0.0225 * 230 / 3)


def test_a_lowered_load_is_changed_over_between_synchronous_speeds():
    """Down: (0.01 + 0.0025 * 0.8) * (314.16 - 78.54) / (10 - 5 * 0.8) = 0.47124 s."""
    sheet = size(FALLING).sheet
    assert sheet.value(f"{DOWN}_change_over_time") == pytest.approx(0.012 * (HIGH_SYNC - LOW_SYNC) / 6)
    assert sheet.value(f"{DOWN}_low_speed") == pytest.approx(LOW_SYNC * 0.1 / 20)


@given(friction=st.floats(0, 200), inertia=st.floats(0.5, 50), torque=st.floats(0.5, 20), eta=st.floats(0.5, 1))
def test_changing_over_takes_what_is_stored_less_what_friction_takes(
    friction: float, inertia: float, torque: float, eta: float
):
    """M_U phi = J_M / 2 (n_2^2 - n_1^2) + what the load gives through the gear unit, or takes."""
    mechanism = {"bodies": [{"shape": "point", "mass_kg": inertia, "radius_mm": 1000}], "friction_torque_nm": friction}
    gear = {"gear_unit": {"own": {"ratio": 20, "efficiency": eta}}}
    sheet = size(FAST, mechanism=mechanism, drive={**with_low(run_up_torque_nm=torque), **gear}).sheet
    stored = (300**2 - 70**2) / 2
    angle = (300 + 70) / 2 * sheet.value(f"{ONE}_change_over_time")
    given_back = inertia / 400 * stored - friction / 20 * angle
    work = 0.01 * stored + given_back * (eta if given_back > 0 else 1 / eta)
    assert 2.5 * torque * angle == pytest.approx(work)


def test_a_load_stronger_than_the_low_winding_cannot_be_changed_over():
    """1 N m * 2.5 against 5 N m * 0.8 that arrive from the load."""
    sizing, checks = calculated(FALLING, drive=with_low(run_up_torque_nm=1))
    check = checks[f"change_over_{DOWN}"]
    assert (check.demanded, check.permitted) == (pytest.approx(4), pytest.approx(2.5))
    assert check.verdict == Verdict.FAILS
    assert not sizing.sheet.has(f"{DOWN}_change_over_time")
    assert sizing.sheet.has(f"{UP}_change_over_time")


def test_a_hoist_is_not_changed_over_softly():
    _, checks = calculated(FALLING, drive={"soft_change": True})
    assert checks["soft_change"].verdict == Verdict.FAILS
    assert "soft_change" not in calculated(FALLING)[1]
    assert "soft_change" not in calculated(FAST, drive={"soft_change": True})[1]


def test_an_empty_trolley_slips_without_a_soft_change():
    """SEW 2001, 8.3, recomputed: 1.21838 m/s2 with three phases, 0.64481 m/s2 softly; the wheels bear 0.73575 m/s2."""
    key = "slip_changing_unladen_forward"
    hard = calculated(example("sew-08-3-travel-drive-pole-changing", "hard"))[1][key]
    soft = calculated(example("sew-08-3-travel-drive-pole-changing"))[1][key]
    assert (hard.demanded, hard.verdict) == (pytest.approx(1.218379305, rel=1e-6), Verdict.FAILS)
    assert (soft.demanded, soft.verdict) == (pytest.approx(0.6448077766, rel=1e-6), Verdict.TIGHT)
    assert soft.permitted == pytest.approx(0.73575)


@pytest.mark.parametrize(("flywheel", "verdict"), [(0.003037, Verdict.FAILS), (0.003038, Verdict.TIGHT)])
def test_a_flywheel_does_it_too(flywheel: float, verdict: Verdict):
    """SEW 2001, 8.3, recomputed: 0.003037965698 kg m2 instead of the soft change."""
    hard = example("sew-08-3-travel-drive-pole-changing", "hard")
    sizing, checks = calculated(hard, drive={"flywheel_inertia_kgm2": flywheel, "service_factor": 1.3})
    assert checks["slip_changing_unladen_forward"].verdict == verdict
    assert sizing.sheet.value("unladen_forward_least_flywheel_for_change") == pytest.approx(0.003037965698, rel=1e-6)


# --- starting and stopping --------------------------------------------------------------------------------------------


def test_it_runs_up_on_the_high_winding():
    """(0.01 + 0.01 / 0.8) * 300 / (20 - 2 / 0.8) = 0.38571 s."""
    assert size(FAST).sheet.value(f"{ONE}_run_up_time") == pytest.approx(0.0225 * 300 / 17.5)


def test_a_winding_that_starts_the_load_must_be_stronger_than_it():
    """2 N m of the low winding against 2.5 N m."""
    sizing, checks = calculated(FAST, drive={**with_low(run_up_torque_nm=2), "start_winding": "low"})
    check = checks[f"run_up_torque_{ONE}_low"]
    assert (check.demanded, check.permitted) == (pytest.approx(2.5), pytest.approx(2))
    assert check.name == "Run-up torque: unladen, low-speed winding"
    assert sizing.verdict == Verdict.FAILS
    assert checks["starting_frequency"].verdict == Verdict.NOT_CHECKED
    assert f"run_up_torque_{ONE}_low" not in calculated(FAST, drive=with_low(run_up_torque_nm=2))[1]


def test_started_low_it_first_reaches_the_low_speed():
    """(0.01 + 0.01 / 0.8) * 70 / (4 - 2 / 0.8) s."""
    sheet = size(FAST, drive={"start_winding": "low"}).sheet
    assert sheet.value(f"{ONE}_low_run_up_time") == pytest.approx(0.0225 * 70 / 1.5)
    assert sheet.value(f"{ONE}_run_up_time") == pytest.approx(0.0225 * 300 / 17.5)


def test_changing_over_heats_and_starting_low_cools():
    """1000/h * 0.01 / 0.0225 * (1 - 2.5 / 20) * 0.7 = 272.2/h; times 0.7 for the heat; times 1.25 started low."""
    plain = 1000 / 2.25 * 0.875 * 0.7
    high, low = size(FAST).sheet, size(FAST, drive={"start_winding": "low"}).sheet
    assert high.value("permissible_cycles_before_change") * 3600 == pytest.approx(plain)
    assert high.value("permissible_cycles") * 3600 == pytest.approx(plain * 0.7)
    assert low.value("permissible_cycles") * 3600 == pytest.approx(plain * 0.7 * 1.25)
    own = size(FAST, drive={"start_winding": "low", "low_start_gain": 1.1, "heating_factor": 0.6}).sheet
    assert own.value("permissible_cycles") * 3600 == pytest.approx(plain * 0.6 * 1.1)


def test_the_starts_of_a_cycle_add_up():
    """SEW 2001, 8.3, recomputed: 126.777/h laden and 320.961/h unladen make 90.880 cycles per hour."""
    sheet = size(example("sew-08-3-travel-drive-pole-changing", "high_start")).sheet
    assert sheet.value("laden_forward_starting_frequency_with_change") * 3600 == pytest.approx(126.7765085, rel=1e-6)
    assert sheet.value("permissible_cycles") * 3600 == pytest.approx(90.87985702, rel=1e-6)


def test_the_brake_stops_from_the_low_speed():
    """0.018 * 70 / (10 + 1.6) s; 3.5 rad/s * (0.02 s + half of it); 10 N m * 70 rad/s * t / 2."""
    sheet, time = size(FAST).sheet, 0.018 * 70 / 11.6
    assert sheet.value(f"{ONE}_braking_time") == pytest.approx(time)
    assert sheet.value(f"{ONE}_stopping_distance") == pytest.approx(3.5 * (0.02 + time / 2))
    assert sheet.value(f"{ONE}_braking_work") == pytest.approx(350 * time)


def test_when_the_mains_fail_it_stops_from_the_high_speed():
    """314.16 + 14.16 * 4 / 10 = 319.82 rad/s, plus 4 * 0.02 / 0.012 until the brake applies."""
    sheet = size(FALLING).sheet
    speed = HIGH_SYNC + (HIGH_SYNC - 300) * 0.4
    assert sheet.value(f"{DOWN}_oversynchronous_speed") == pytest.approx(speed)
    assert sheet.value(f"{DOWN}_emergency_braking_time") == pytest.approx(0.012 * (speed + 4 * 0.02 / 0.012) / 6)


def test_a_stop_from_the_high_speed_must_not_burn_the_brake():
    """Low: 10 N m * 85.2 rad/s * 0.1704 s / 2 = 73 J; mains failed: 10 * 326.5 * 0.653 / 2 = 1066 J."""
    own = {"own": {**BRAKE["own"], "max_work_per_operation_j": 500}}
    assert calculated(FALLING, drive={"brake": own})[1]["brake_work"].verdict == Verdict.FAILS


def test_a_load_that_does_not_drive_is_stopped_from_the_high_speed_too():
    """0.018 * 300 / 11.6 s and 10 N m * 300 rad/s * t / 2 when the mains fail, 350 J/s * t from the low speed."""
    sizing, checks = calculated(FAST)
    assert sizing.sheet.value(f"{ONE}_emergency_braking_time") == pytest.approx(0.018 * 300 / 11.6)
    assert checks["brake_work"].demanded == pytest.approx(1500 * 0.018 * 300 / 11.6)
    assert sizing.sheet.value("mean_braking_work") == pytest.approx(350 * 0.018 * 70 / 11.6)


# --- input ------------------------------------------------------------------------------------------------------------


def test_the_order_of_the_windings_does_not_matter():
    here = size(FAST).sheet
    there = size(FAST, drive={"motor": motor(HIGH, LOW)}).sheet
    assert [(step.key, step.value) for step in here.steps] == [(step.key, step.value) for step in there.steps]


def test_one_winding_is_too_few():
    assert refused(FAST, drive={"motor": motor(HIGH)}) == [("drive.motor", "a pole-changing motor has two windings")]


def test_a_motor_weaker_than_its_load_fails_and_the_rest_is_still_told():
    sizing, checks = calculated(FAST, drive={"motor": motor(LOW, {**HIGH, "run_up_torque_ratio": 0.2})})
    check = checks[f"run_up_torque_{ONE}"]
    assert (check.demanded, check.permitted) == (pytest.approx(2.5), pytest.approx(2))
    assert check.verdict == Verdict.FAILS
    assert not sizing.sheet.has(f"{ONE}_run_up_time")
    assert sizing.sheet.has(f"{ONE}_change_over_time")


@pytest.mark.parametrize("which", ["low", "high"])
def test_a_winding_without_run_up_torque_is_named(which: str):
    lacking = {"run_up_torque_nm": None, "run_up_torque_ratio": None}
    made = motor({**LOW, **(lacking if which == "low" else {})}, {**HIGH, **(lacking if which == "high" else {})})
    sizing, checks = calculated(FAST, drive={"motor": made})
    assert checks[f"run_up_torque_{which}"].verdict == Verdict.NOT_CHECKED
    assert "run-up torque" in checks[f"run_up_torque_{which}"].missing
    assert not sizing.sheet.has("change_over_torque")


@pytest.mark.parametrize(("rated", "verdict"), [(0.14, Verdict.FAILS), (0.18, Verdict.TIGHT), (0.25, Verdict.OK)])
def test_the_low_speed_winding_must_bear_the_load_too(rated: float, verdict: Verdict):
    """2 N m / 0.8 * 70 rad/s = 175 W; 750 W of 3 kW at the high speed."""
    checks = calculated(FAST, drive=with_low(rated_power_kw=rated))[1]
    assert checks["static_power_low"].demanded == pytest.approx(175)
    assert checks["static_power_low"].permitted == pytest.approx(rated * 1000)
    assert checks["static_power_low"].verdict == verdict
    assert (checks["static_power"].demanded, checks["static_power"].permitted) == (pytest.approx(750), 3000)


def test_a_process_at_full_speed_is_no_load_of_creeping():
    """100 N m more at full speed: 7 / 0.8 N m * 300 rad/s, and 175 W on the low-speed winding as before."""
    run = {"duration_s": 10, "process_torque_nm": 100, "process_during": "constant_speed"}
    checks = calculated(FAST, motion={"runs": [run]})[1]
    assert checks["static_power"].demanded == pytest.approx(7 / 0.8 * 300)
    assert checks["static_power_low"].demanded == pytest.approx(175)
