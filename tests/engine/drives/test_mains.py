"""Line-fed motor: run-up, starting frequency, braking and holding, calculated by hand on a table and a hoist."""

import math
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.engine.sheet import Verdict
from tests.line_fed_requests import BRAKE, GEAR, HOIST, TABLE, calculated, example, motor, refused, request, size

ONE = "unladen_forward"
UP, DOWN = "unladen_lifting", "unladen_lowering"
SYNCHRONOUS = 50 * math.pi


def table(inertia: float, friction: float = 40.0) -> dict[str, Any]:
    """The mechanism with another inertia [kg m2] and friction [N m]."""
    return {"bodies": [{"shape": "point", "mass_kg": inertia, "radius_mm": 1000}], "friction_torque_nm": friction}


def brake(torque: float, **values: Any) -> dict[str, Any]:
    return {"own": {**BRAKE["own"], "torque_nm": torque, **values}}


# --- run-up -----------------------------------------------------------------------------------------------------------


def test_the_table_runs_up_in_0_6_s():
    """(0.01 + 0.04 / 0.8) kg m2 * 150 rad/s / (20 - 4 / 0.8) N m = 0.6 s; 15 rad/s / 0.6 s; 15 rad/s * 0.6 s / 2."""
    sheet = size(TABLE).sheet
    assert sheet.value("rated_torque") == pytest.approx(10)
    assert sheet.value("run_up_torque") == pytest.approx(20)
    assert sheet.value(f"{ONE}_starting_inertia") == pytest.approx(0.06)
    assert sheet.value(f"{ONE}_run_up_time") == pytest.approx(0.6)
    assert sheet.value(f"{ONE}_run_up_acceleration") == pytest.approx(25)
    assert sheet.value(f"{ONE}_run_up_distance") == pytest.approx(4.5)


def test_the_hoist_lifts_to_rated_and_lowers_to_synchronous_speed():
    """Up: 0.0225 * 150 / (20 - 12.5) = 0.45 s. Down: 20 N m make 10 N m of load fall faster than it would by itself, so
    the motor drives: 0.0225 * 157.08 / (20 + 12.5) = 0.1087 s."""
    sheet = size(HOIST).sheet
    assert sheet.value(f"{UP}_run_up_time") == pytest.approx(0.45)
    assert sheet.value(f"{UP}_run_up_acceleration") == pytest.approx(1.5 / 0.45)
    assert sheet.value(f"{DOWN}_run_up_time") == pytest.approx(0.0225 * SYNCHRONOUS / 32.5)


def test_a_weak_motor_is_driven_by_the_load_that_it_lowers():
    """5 N m: the load pulls the rotor, losses multiply: (0.01 + 0.01 * 0.8) * 157.08 / (5 + 10 * 0.8) = 0.2175 s."""
    sizing, checks = calculated(HOIST, drive={"motor": motor({"run_up_torque_ratio": 0.5})})
    assert sizing.sheet.value(f"{DOWN}_run_up_time") == pytest.approx(0.018 * SYNCHRONOUS / 13)
    assert checks[f"run_up_torque_{UP}"].verdict == Verdict.FAILS  # 12.5 N m to lift


@pytest.mark.parametrize(("flywheel", "time"), [(0.02, 0.8), (0.06, 1.2), (0.14, 2.0)])
def test_a_heavier_flywheel_starts_more_gently_and_less_often(flywheel: float, time: float):
    """(0.06 + J_Z) * 150 / 15; the starting frequency falls by the same factor; the flywheel has no losses."""
    bare, heavy = size(TABLE).sheet, size(TABLE, drive={"flywheel_inertia_kgm2": flywheel}).sheet
    assert heavy.value(f"{ONE}_run_up_time") == pytest.approx(time)
    assert heavy.value(f"{ONE}_run_up_acceleration") == pytest.approx(15 / time)
    ratio = heavy.value(f"{ONE}_starting_frequency") / bare.value(f"{ONE}_starting_frequency")
    assert ratio == pytest.approx(0.6 / time)


def test_a_process_at_full_speed_is_not_started_against():
    """100 N m of process: 17.5 N m in steady running, 5 N m while starting; throughout it would take 3.6 s."""
    run = {"duration_s": 10, "process_torque_nm": 100}
    at_speed = size(TABLE, motion={"runs": [{**run, "process_during": "constant_speed"}]}).sheet
    assert at_speed.value(f"{ONE}_static_torque") == pytest.approx(17.5)
    assert at_speed.value(f"{ONE}_run_up_time") == pytest.approx(0.6)
    assert size(TABLE, motion={"runs": [run]}).sheet.value(f"{ONE}_run_up_time") == pytest.approx(0.06 * 150 / 2.5)


@given(inertia=st.floats(0.1, 50), more=st.floats(1.01, 5), friction=st.floats(0, 150))
def test_more_inertia_takes_longer_and_fewer_starts(inertia: float, more: float, friction: float):
    light, heavy = (size(TABLE, mechanism=table(J, friction)).sheet for J in (inertia, inertia * more))
    assert 0 < light.value(f"{ONE}_run_up_time") < heavy.value(f"{ONE}_run_up_time")
    assert light.value(f"{ONE}_run_up_acceleration") > heavy.value(f"{ONE}_run_up_acceleration")
    assert light.value("permissible_cycles") > heavy.value("permissible_cycles")


@given(inertia=st.floats(0.1, 50), friction=st.floats(0, 150), eta=st.floats(0.5, 1))
def test_the_motor_puts_in_what_is_stored_lost_and_rubbed_away(inertia: float, friction: float, eta: float):
    """M_H phi = J_M omega^2 / 2 + (J_L omega_L^2 / 2 + M_f phi_L) / eta: no torque or time of the engine is used."""
    gear = {"own": {"ratio": 10, "efficiency": eta}}
    sheet = size(TABLE, mechanism=table(inertia, friction), drive={"gear_unit": gear}).sheet
    if not sheet.has(f"{ONE}_run_up_time"):
        assert friction / 10 / eta >= 20 * (1 - 1e-9)
        return
    angle = 150 * sheet.value(f"{ONE}_run_up_time") / 2
    put_in = 0.01 * 150**2 / 2 + (inertia * 15**2 / 2 + friction * angle / 10) / eta
    assert 20 * angle == pytest.approx(put_in)


@given(friction=st.floats(160.1, 5000))
def test_a_motor_weaker_than_its_load_fails_and_never_arrives(friction: float):
    """20 N m bear 160 N m of friction behind i = 10 and 80 %, no more."""
    sizing, checks = calculated(TABLE, mechanism=table(4, friction))
    check = checks[f"run_up_torque_{ONE}"]
    assert check.demanded == pytest.approx(friction / 8)
    assert check.permitted == pytest.approx(20)
    assert check.verdict == Verdict.FAILS
    assert check.name == "Run-up torque: unladen"
    assert not sizing.sheet.has(f"{ONE}_run_up_time")
    assert sizing.verdict == Verdict.FAILS


# --- wheels that slip -------------------------------------------------------------------------------------------------

TROLLEY = example("sew-08-1-travel-drive-two-pole")
"""SEW 2001, 8.1: 1.5 t with 1.5 t of load, 0.55 kW at 2700 rpm, flywheel of 0.002 kg m2; a_p = 0.73575 m/s2."""


def test_the_trolley_slips_when_it_starts_empty():
    """SEW 2001, 8.1, recomputed: laden 0.41802 m/s2, unladen 0.75828 m/s2, although the source accepts its flywheel."""
    _, checks = calculated(TROLLEY)
    assert checks["slip_starting_laden_forward"].demanded == pytest.approx(0.4180228161, rel=1e-6)
    assert checks["slip_starting_laden_forward"].verdict == Verdict.OK
    assert checks["slip_starting_unladen_forward"].demanded == pytest.approx(0.7582775276, rel=1e-6)
    assert checks["slip_starting_unladen_forward"].permitted == pytest.approx(0.73575)
    assert checks["slip_starting_unladen_forward"].verdict == Verdict.FAILS


@pytest.mark.parametrize(("share", "verdict"), [(0.999, Verdict.FAILS), (1.0, Verdict.TIGHT), (2.5, Verdict.OK)])
def test_the_least_flywheel_just_keeps_the_wheels_from_slipping(share: float, verdict: Verdict):
    """SEW 2001, 8.1, recomputed: 0.002246090025 kg m2."""
    sizing, checks = calculated(TROLLEY, drive={"flywheel_inertia_kgm2": 0.002246090025 * share})
    assert checks["slip_starting_unladen_forward"].verdict == verdict
    assert sizing.sheet.value("unladen_forward_least_flywheel") == pytest.approx(0.002246090025, rel=1e-6)


# --- starting frequency -----------------------------------------------------------------------------------------------


def test_the_starting_frequency_has_three_factors():
    """1000/h * 0.01 / 0.06 * (1 - 5 / 20) * 0.7 = 87.5/h; a start every 20 s is 180/h."""
    sizing, checks = calculated(TABLE)
    assert sizing.sheet.value(f"{ONE}_starting_frequency") * 3600 == pytest.approx(87.5)
    check = checks["starting_frequency"]
    assert check.demanded is not None
    assert check.demanded * 3600 == pytest.approx(180)
    assert check.verdict == Verdict.FAILS


@pytest.mark.parametrize(("unladen_runs", "cycles"), [(1, 27.87610619), (2, 21.14093960)])
def test_the_heating_of_different_starts_adds_up(unladen_runs: int, cycles: float):
    """Laden 0.01 + 0.08 / 0.8 = 0.11 kg m2: 1000 / 11 * 0.75 * 0.6 = 40.909/h. 1 / (1 / 40.909 + n / 87.5)."""
    runs = [{"duration_s": 1, "payload_inertia_kgm2": 4}, *[{"duration_s": 1}] * unladen_runs]
    factors = [{"state": "laden_forward", "factor": 0.6}, {"state": ONE, "factor": 0.7}]
    sheet = size(TABLE, motion={"runs": runs}, drive={"starting_factors": factors}).sheet
    assert sheet.value("laden_forward_starting_frequency") * 3600 == pytest.approx(450 / 11)
    assert sheet.value("permissible_cycles") * 3600 == pytest.approx(cycles)


def test_a_load_that_helps_is_counted_as_if_it_opposed():
    """Down: K_M = 1 - 12.5 / 20, although the run-up is short; what physics would allow stands beside it: 1.625."""
    sheet = size(HOIST).sheet
    assert sheet.value(f"{DOWN}_load_torque_factor") == pytest.approx(0.375)
    assert sheet.value(f"{DOWN}_physical_load_torque_factor") == pytest.approx(1.625)
    # 1000/h * 0.01 / 0.0225 * 0.375 * 0.5 each, two of them in a cycle
    assert sheet.value("permissible_cycles") * 3600 == pytest.approx(1000 / 2.25 * 0.375 * 0.5 / 2)


@pytest.mark.parametrize(
    ("ratio", "key", "verdict"),
    [(1.2, UP, Verdict.NOT_CHECKED), (1.26, "", Verdict.FAILS), (0.5, UP, Verdict.NOT_CHECKED)],
)
def test_a_state_that_cannot_start_leaves_no_cycles(ratio: float, key: str, verdict: Verdict):
    """12.5 N m to lift: 12 and 5 N m do not start, and 12.6 N m leave 0.8 % of the starts."""
    sizing, checks = calculated(HOIST, drive={"motor": motor({"run_up_torque_ratio": ratio})})
    assert (checks[f"run_up_torque_{UP}"].verdict == Verdict.FAILS) == bool(key)
    check = checks["starting_frequency"]
    assert check.verdict == verdict
    assert ("unladen, lifting" in check.missing) == bool(key)
    assert sizing.sheet.has("permissible_cycles") == (not key)


def test_a_load_that_takes_all_of_the_run_up_torque_permits_no_start():
    """Lowering with 12.5 N m of help counts as 12.5 N m against 12 N m; nothing is lifted."""
    made = request(HOIST, drive={"motor": motor({"run_up_torque_ratio": 1.2})})
    made["motion"]["runs"] = [{"distance_m": 6, "direction": "backward"}]
    sizing, checks = calculated(made)
    check = checks["starting_frequency"]
    assert (check.permitted, check.verdict) == (0, Verdict.FAILS)
    assert "No start is permitted" in [decision.text for decision in sizing.sheet.decisions]


def test_a_factor_of_a_state_that_is_not_there_is_refused():
    factors = [{"state": ONE, "factor": 0.7}, {"state": "laden_sideways", "factor": 0.5}]
    ((name, message),) = refused(TABLE, drive={"starting_factors": factors})
    assert name == "drive.starting_factors.1.state"
    assert ONE in message


# --- braking ----------------------------------------------------------------------------------------------------------


def test_friction_and_losses_help_to_stop_the_table():
    """(0.01 + 0.04 * 0.8) kg m2 * 150 rad/s / (10 + 4 * 0.8) N m = 0.47727 s; 15 rad/s * (0.02 + 0.47727 / 2) s."""
    sheet = size(TABLE).sheet
    assert sheet.value(f"{ONE}_braking_time") == pytest.approx(0.042 * 150 / 13.2)
    assert sheet.value(f"{ONE}_braking_deceleration") == pytest.approx(15 * 13.2 / 6.3)
    assert sheet.value(f"{ONE}_stopping_distance") == pytest.approx(15 * (0.02 + 0.5 * 6.3 / 13.2))
    assert sheet.value(f"{ONE}_stopping_accuracy") == pytest.approx(0.12 * 15 * (0.02 + 0.5 * 6.3 / 13.2))


def test_the_retrograde_efficiency_is_a_choice():
    """eta' = 2 - 1 / 0.8 = 0.75: (0.01 + 0.04 * 0.75) * 150 / (10 + 4 * 0.75) = 0.46154 s; starting stays as it is."""
    sheet = size(TABLE, environment={"regeneration": "sew"}).sheet
    assert sheet.value(f"{ONE}_braking_time") == pytest.approx(0.04 * 150 / 13)
    assert sheet.value(f"{ONE}_run_up_time") == pytest.approx(0.6)


def test_until_the_brake_applies_lifting_slows_and_lowering_quickens():
    """Up: -12.5 N m * 0.02 s / 0.0225 kg m2 = -11.11 rad/s, stop in 0.0225 * 138.89 / 22.5 s.
    Down: +8 * 0.02 / 0.018 = 8.89 rad/s onto 157.08, stop in 0.018 * 165.97 / (10 - 8) s."""
    sheet = size(HOIST).sheet
    up = 150 - 12.5 * 0.02 / 0.0225
    assert sheet.value(f"{UP}_braking_time") == pytest.approx(0.0225 * up / 22.5)
    assert sheet.value(f"{UP}_stopping_distance") == pytest.approx(
        0.01 * ((150 + up) / 2 * 0.02 + up / 2 * 0.0225 * up / 22.5)
    )
    down = SYNCHRONOUS + 8 * 0.02 / 0.018
    assert sheet.value(f"{DOWN}_braking_time") == pytest.approx(0.018 * down / 2)
    assert sheet.value(f"{DOWN}_braking_deceleration") == pytest.approx(2 / 0.018 * 0.01)


@given(
    inertia=st.floats(0.01, 50), friction=st.floats(0, 150), torque=st.floats(1, 200), eta=st.floats(0.5, 1),
)  # fmt: skip
def test_the_brake_takes_what_is_stored_less_what_friction_takes(
    inertia: float, friction: float, torque: float, eta: float
):
    """The load gives J_L omega_L^2 / 2 - M_f phi_L through the gear unit, or takes it where friction alone is harder
    than the brake; the rotor gives J_M omega^2 / 2."""
    parts = {"brake": brake(torque), "gear_unit": {"own": {"ratio": 10, "efficiency": eta}}}
    sheet = size(TABLE, mechanism=table(inertia, friction), drive=parts).sheet
    angle = 150 * sheet.value(f"{ONE}_braking_time") / 2
    given_back = inertia * 15**2 / 2 - friction * angle / 10
    work = 0.01 * 150**2 / 2 + given_back * (eta if given_back > 0 else 1 / eta)
    assert sheet.value(f"{ONE}_braking_work") == pytest.approx(work, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize(("torque", "verdict"), [(7.9, Verdict.FAILS), (8.1, Verdict.TIGHT), (10.1, Verdict.OK)])
def test_the_brake_must_be_stronger_than_what_it_lowers(torque: float, verdict: Verdict):
    """10 N m * 0.8 arrive at the motor."""
    sizing, checks = calculated(HOIST, drive={"brake": brake(torque)})
    check = checks[f"brake_stops_{DOWN}"]
    assert check.demanded == pytest.approx(8)
    assert check.verdict == verdict
    assert sizing.sheet.has(f"{DOWN}_braking_time") == (torque > 8)


def test_a_brake_holds_with_reserve():
    """1000 N * 0.1 m / 10 = 10 N m, no help of losses, twice."""
    for torque, verdict in ((19.9, Verdict.FAILS), (20.0, Verdict.TIGHT), (25.1, Verdict.OK)):
        _, checks = calculated(HOIST, drive={"brake": brake(torque)})
        assert checks["brake_holding"].demanded == pytest.approx(20)
        assert checks["brake_holding"].verdict == verdict
    assert "brake_holding" not in calculated(TABLE)[1]


@pytest.mark.parametrize(
    "drive",
    [
        {"motor": motor({"run_up_torque_ratio": None})},
        {"motor": motor(rotor_inertia_kgm2=None, rotor_inertia_with_brake_kgm2=None)},
        {"brake": {"own": {"torque_nm": 10}}},
        {"brake": None},
        {"motor": None, "gear_unit": None, "brake": None},
    ],
)
def test_holding_a_hoist_is_checked_or_said_not_to_be(drive: dict[str, Any]):
    """20 N m are needed; neither run-up torque, inertia nor application time of the brake has to do with it."""
    check = calculated(HOIST, drive=drive)[1]["brake_holding"]
    assert check.demanded == pytest.approx(20 if drive.get("gear_unit", GEAR) else 200)
    if drive.get("brake", BRAKE) is None:
        assert (check.verdict, check.missing) == (Verdict.NOT_CHECKED, "brake with its torque")
    else:
        assert check.verdict == Verdict.FAILS


def test_when_the_mains_fail_the_load_runs_above_synchronous_speed():
    """8 N m of 10 N m: 0.8 of the rated slip of 7.08 rad/s beyond 157.08 rad/s."""
    sheet = size(HOIST).sheet
    speed = SYNCHRONOUS + 0.8 * (SYNCHRONOUS - 150)
    assert sheet.value(f"{DOWN}_oversynchronous_speed") == pytest.approx(speed)
    assert sheet.value(f"{DOWN}_emergency_braking_time") == pytest.approx(0.018 * (speed + 8 * 0.02 / 0.018) / 2)
    assert not sheet.has(f"{UP}_oversynchronous_speed")


def test_the_hardest_stop_decides_on_the_work_of_the_brake():
    """Lowering, mains failed: 10 N m, 171.63 rad/s, 1.5447 s: 1325.6 J; out of synchronous speed 1239.5 J."""
    sizing, checks = calculated(HOIST, drive={"brake": brake(10, max_work_per_operation_j=1300)})
    assert checks["brake_work"].demanded == pytest.approx(1325.6, rel=1e-4)
    assert checks["brake_work"].verdict == Verdict.FAILS
    # stops after a failure are rare: they do not count for the life of the brake
    stops = sum(sizing.sheet.value(f"{key}_braking_work") for key in (UP, DOWN))
    assert sizing.sheet.value("mean_braking_work") == pytest.approx(stops / 2)


def test_brake_work_life_and_accuracy_are_checked():
    """10 N m * 150 rad/s * 0.47727 s / 2 = 357.95 J; 1 MJ lasts for 2793.7 stops, one in 20 s; 12 % of 12.5 mm."""
    own = brake(10, max_work_per_operation_j=350, work_until_adjustment_mj=1)
    sizing, checks = calculated(TABLE, drive={"brake": own})
    assert checks["brake_work"].demanded == pytest.approx(1500 * 6.3 / 13.2 / 2)
    assert checks["brake_work"].verdict == Verdict.FAILS
    assert sizing.sheet.value("brake_life") == pytest.approx(1e6 / (750 * 6.3 / 13.2) * 20)
    _, checks = calculated(HOIST, drive={"accuracy_mm": 16})
    assert checks[f"stopping_accuracy_{UP}"].demanded == pytest.approx(0.12 * 0.1253395, rel=1e-6)
    assert checks[f"stopping_accuracy_{UP}"].verdict == Verdict.TIGHT
    assert checks[f"stopping_accuracy_{DOWN}"].verdict == Verdict.FAILS


# --- rating and lacking data ------------------------------------------------------------------------------------------


def test_the_rating_rises_with_the_duty_type():
    """40 N m * 15 rad/s / 0.8 = 750 W of 1500 W; 1.2 times that at short duty."""
    assert calculated(TABLE)[1]["static_power"].utilisation == pytest.approx(0.5)
    check = calculated(TABLE, drive={"power_increase": 1.2})[1]["static_power"]
    assert (check.demanded, check.permitted) == (pytest.approx(750), pytest.approx(1800))


def test_a_rated_torque_that_was_typed_is_used():
    """9 N m instead of 1.5 kW / 150 rad/s = 10 N m: twice that to run up."""
    sheet = size(TABLE, drive={"motor": motor({"rated_torque_nm": 9})}).sheet
    assert sheet.value("rated_torque") == pytest.approx(9)
    assert sheet.value("run_up_torque") == pytest.approx(18)


@pytest.mark.parametrize(
    ("drive", "key", "word"),
    [
        ({"motor": motor({"run_up_torque_ratio": None})}, "run_up_torque", "run-up torque"),
        ({"motor": motor(rotor_inertia_kgm2=None, rotor_inertia_with_brake_kgm2=None)}, "run_up_inertia", "inertia"),
        ({"motor": motor({"no_load_starting_frequency_1_h": None})}, "starting_frequency", "no-load starting"),
        ({"brake": {"own": {"torque_nm": 10}}}, "brake_stops", "application time"),
    ],
)
def test_what_a_data_sheet_lacks_is_named_and_not_guessed(drive: dict[str, Any], key: str, word: str):
    _, checks = calculated(TABLE, drive=drive)
    assert checks[key].verdict == Verdict.NOT_CHECKED
    assert word in checks[key].missing
    assert calculated(TABLE)[1].get(key, checks["static_power"]).verdict != Verdict.NOT_CHECKED


def test_without_a_gear_unit_the_motor_drives_directly():
    """0.01 + 4 kg m2 and 40 N m on the motor shaft itself: the motor cannot start."""
    sizing, checks = calculated(TABLE, drive={"gear_unit": None})
    assert checks[f"run_up_torque_{ONE}"].demanded == pytest.approx(40)
    assert sizing.drive.ratio == 1
    assert any("directly" in decision.text for decision in sizing.sheet.decisions)


def test_the_inertia_of_the_gear_unit_sits_on_the_motor_shaft():
    """0.06 + 0.003 kg m2, no losses on it."""
    sheet = size(TABLE, drive={"gear_unit": {"own": {**GEAR["own"], "inertia_kgm2": 0.003}}}).sheet
    assert sheet.value(f"{ONE}_starting_inertia") == pytest.approx(0.063)


def test_ramps_of_a_motion_are_not_those_of_the_motor():
    """A motion with ramps of its own gives the same run-up: 15 rad/s is what counts."""
    moves = [{"distance_deg": "150 rad", "speed_rpm": "15 rad/s", "acceleration_rad_s2": 0.9, "dwell_s": 10}]
    made = request(TABLE)
    made["motion"] = {"kind": "turns", "moves": moves}
    assert size(made).sheet.value(f"{ONE}_run_up_time") == pytest.approx(0.6)
