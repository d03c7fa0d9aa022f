"""Loads whose torque depends on the speed: a fan that a line-fed motor starts, brakes and changes over, by hand."""

import math
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.engine.drives.mains_shaft import Gravity, MotorSide
from app.engine.mechanisms.load import LoadState, Statics
from app.engine.sheet import Verdict
from tests.line_fed_requests import calculated, motor, request, size

ONE = "running"
SPEED = 1000 * math.pi / 30
TORQUE = 8000 / SPEED
"""76.394 N m"""
STEPS = 1 + 1 / (2 * 32**2)
"""What 32 straight steps make of the mean of a parabola."""
FAN: dict[str, Any] = {
    "mechanism": {"kind": "fan", "rated_speed_rpm": 1000, "rated_power_kw": 8, "rotor_inertia_kgm2": 8},
    "motion": {"kind": "rotations", "speed_rpm": 1000, "runs": [{"duration_s": 600}], "pause_s": 600},
    "drive": {
        "kind": "mains",
        "motor": motor(
            {"poles": 6, "frequency_hz": 52, "rated_power_kw": 11, "rated_speed_rpm": 1000,
             "run_up_torque_nm": 100},
            rotor_inertia_kgm2=0.5, rotor_inertia_with_brake_kgm2=0.5,
        ),
        "brake": {"own": {"torque_nm": 50, "application_time_dc_ms": 20}},
        "starting_factors": [{"state": ONE, "factor": 0.7}],
    },
}  # fmt: skip
"""8 kg m2 and 8 kW at 1000 rpm, directly on a motor of 0.5 kg m2 and 100 N m."""
GEARED = {"gear_unit": {"own": {"ratio": 2, "efficiency": 0.8}}, "service_factor": 1.3}


# --- starting and stopping --------------------------------------------------------------------------------------------


def test_during_the_run_up_a_fan_takes_a_third_on_average():
    """76.394 / 3 N m; the time is that of the whole course: 8.5 kg m2 * 104.72 rad/s / 100 N m * artanh(r) / r with
    r^2 = 76.394 / 100 is 13.75 s, as with 100 - 890.1 / 13.75 = 35.27 N m all the time; with the mean it is 11.94 s."""
    sheet = size(FAN).sheet
    assert sheet.value(f"{ONE}_load_torque") == pytest.approx(76.394, rel=1e-5)
    assert sheet.value(f"{ONE}_mean_run_up_load_torque") == pytest.approx(76.394 / 3, rel=1e-3)
    assert sheet.value(f"{ONE}_starting_load_torque") == pytest.approx(TORQUE / 3 * STEPS)
    r = math.sqrt(TORQUE / 100)
    time = 8.5 * SPEED / 100 * math.atanh(r) / r
    assert time == pytest.approx(13.75, rel=1e-3)
    assert sheet.value(f"{ONE}_run_up_time") == pytest.approx(time, rel=1e-3)
    assert sheet.value(f"{ONE}_equivalent_load_torque") == pytest.approx(35.27, rel=2e-3)
    assert sheet.value(f"{ONE}_load_torque_factor") == pytest.approx(1 - 0.3527, rel=2e-3)
    assert sheet.value(f"{ONE}_static_power") == pytest.approx(8000)


def test_it_helps_to_brake_with_the_same_mean():
    """8.5 * 104.72 / (50 + 25.46) = 11.80 s."""
    time = size(FAN).sheet.value(f"{ONE}_braking_time")
    assert time == pytest.approx(8.5 * SPEED / (50 + TORQUE / 3 * STEPS))
    assert time == pytest.approx(11.80, rel=1e-3)


def test_friction_of_its_bearings_does_not_depend_on_the_speed():
    """6 N m and a parabola up to the rest."""
    sheet = size(FAN, mechanism={"friction_torque_nm": 6}).sheet
    assert sheet.value(f"{ONE}_mean_run_up_load_torque") == pytest.approx(6 + (TORQUE - 6) / 3 * STEPS)


def test_behind_a_gear_unit_the_mean_stands_at_the_motor():
    """500 rpm with a quarter of the torque, i = 2, 80 %: 6.366 / 2 N m, 6.366 / 1.6 N m with losses."""
    sheet = size(FAN, drive=GEARED, motion={"speed_rpm": 500}).sheet
    assert sheet.value(f"{ONE}_mean_run_up_load_torque") == pytest.approx(TORQUE / 24 * STEPS)
    assert sheet.value(f"{ONE}_starting_load_torque") == pytest.approx(TORQUE / 19.2 * STEPS)


@pytest.mark.parametrize(("torque", "verdict"), [(100, Verdict.OK), (80, Verdict.TIGHT), (70, Verdict.FAILS)])
def test_the_motor_must_be_stronger_at_every_speed(torque: float, verdict: Verdict):
    """76.394 N m at full speed: with 70 N m the fan never reaches it, although the mean is 25 N m."""
    own = {"own": {**FAN["drive"]["motor"]["own"]}}
    own["own"]["windings"] = [{**own["own"]["windings"][0], "run_up_torque_nm": torque}]
    sizing, checks = calculated(FAN, drive={"motor": own})
    check = checks[f"run_up_torque_{ONE}"]
    assert (check.demanded, check.permitted) == (pytest.approx(TORQUE), pytest.approx(torque))
    assert check.verdict == verdict
    assert sizing.sheet.has(f"{ONE}_run_up_time") == (verdict != Verdict.FAILS)
    assert (checks["starting_frequency"].verdict == Verdict.NOT_CHECKED) == (verdict == Verdict.FAILS)


def with_run_up_torque(torque: float) -> dict[str, Any]:
    """The motor with another mean run-up torque in delta [N m]."""
    own = {**FAN["drive"]["motor"]["own"]}
    own["windings"] = [{**own["windings"][0], "run_up_torque_nm": torque}]
    return {"starting": "star_delta", "motor": {"own": own}}


@pytest.mark.parametrize(
    ("share", "verdict"),
    [(0.66, Verdict.FAILS), (0.89, Verdict.FAILS), (0.93, Verdict.TIGHT), (0.99, Verdict.TIGHT)],
)
def test_in_star_a_fan_becomes_only_so_fast(share: float, verdict: Verdict):
    """A third of the torque is share^2 of what the fan takes at 1000 rpm: the motor stays at that share of the speed.

    It changes over at 98 % of it: J W / (share T) * artanh(0.98) in star. In delta r^2 = T / M_H:
    J W / (M_H r) * (artanh(r) - artanh(0.98 * share * r)).
    """
    M_H = 3 * share**2 * TORQUE
    sizing, checks = calculated(FAN, drive=with_run_up_torque(M_H))
    sheet, check = sizing.sheet, checks[f"star_speed_{ONE}"]
    assert sheet.value(f"{ONE}_speed_in_star") == pytest.approx(share * SPEED, rel=1e-3)
    assert (check.demanded, check.permitted) == (pytest.approx(0.9 * SPEED), pytest.approx(share * SPEED, rel=1e-3))
    assert check.verdict == verdict
    assert checks[f"run_up_torque_{ONE}"].permitted == pytest.approx(M_H)
    r = math.sqrt(TORQUE / M_H)
    star = 8.5 * SPEED / (share * TORQUE) * math.atanh(0.98)
    delta = 8.5 * SPEED / (M_H * r) * (math.atanh(r) - math.atanh(0.98 * share * r))
    assert sheet.value(f"{ONE}_star_time") == pytest.approx(star, rel=0.01)
    assert sheet.value(f"{ONE}_delta_time") == pytest.approx(delta, rel=0.01)
    assert sheet.value(f"{ONE}_run_up_time") == pytest.approx(star + delta, rel=0.01)
    assert "starting_frequency" in checks


def test_a_small_fan_runs_up_in_star_alone():
    """33.3 N m for 76.394 / 4 / 1.6 = 11.94 N m: J = 0.5 + 8 / 4 / 0.8 kg m2, r^2 = 11.94 / 33.33."""
    star = {**GEARED, "starting": "star_delta"}
    sizing, checks = calculated(FAN, drive=star, motion={"speed_rpm": 500})
    r = math.sqrt(TORQUE / 6.4 / (100 / 3))
    time = 3 * SPEED / (100 / 3) * math.atanh(r) / r
    assert sizing.sheet.value(f"{ONE}_run_up_time") == pytest.approx(time, rel=1e-3)
    assert checks[f"star_speed_{ONE}"].permitted == pytest.approx(SPEED)
    assert checks[f"star_speed_{ONE}"].verdict == Verdict.TIGHT
    assert not sizing.sheet.has(f"{ONE}_star_time")


def test_star_that_does_not_move_the_load_starts_nothing():
    """40 N m of bearings for 33.3 N m."""
    drive = {"starting": "star_delta"}
    sizing, checks = calculated(FAN, mechanism={"friction_torque_nm": 40}, drive=drive)
    assert (checks[f"star_speed_{ONE}"].permitted, checks[f"star_speed_{ONE}"].verdict) == (0, Verdict.FAILS)
    assert not sizing.sheet.has(f"{ONE}_run_up_time")
    assert checks["starting_frequency"].verdict == Verdict.NOT_CHECKED


# --- the motor's own speed --------------------------------------------------------------------------------------------


def test_a_motor_on_the_mains_does_not_run_at_the_speed_that_is_wished():
    """8 kW at 1450 rpm: 1 kW at 725 rpm, 8 kW * (1400 / 1450)^3 = 7.20 kW at the 1400 rpm of the motor, 1.5 kW."""
    made = request(FAN, mechanism={"rated_speed_rpm": 1450}, motion={"speed_rpm": 725})
    rated = {"poles": 4, "frequency_hz": 50, "rated_power_kw": 1.5, "rated_speed_rpm": 1400}
    made["drive"]["motor"] = motor(rated, rotor_inertia_kgm2=0.01, rotor_inertia_with_brake_kgm2=0.01)
    sizing, checks = calculated(made)
    assert sizing.sheet.value(f"{ONE}_static_power") == pytest.approx(1000)
    own = 8000 * (1400 / 1450) ** 3
    assert sizing.sheet.value(f"{ONE}_running_power") == pytest.approx(own)
    assert (checks["static_power"].demanded, checks["static_power"].permitted) == (pytest.approx(own), 1500)
    assert checks["static_power"].verdict == Verdict.FAILS
    assert checks["load_speed"].demanded == pytest.approx(1400 / 725 - 1)
    assert checks["load_speed"].verdict == Verdict.FAILS
    assert checks[f"run_up_torque_{ONE}"].demanded == pytest.approx(own / (1400 * math.pi / 30))


def test_a_direct_motor_at_the_wished_speed_is_in_order():
    checks = calculated(FAN)[1]
    assert checks["load_speed"].demanded == pytest.approx(0, abs=1e-9)
    assert checks["static_power"].demanded == pytest.approx(8000)


@pytest.mark.parametrize("speed", [10.0, 49.0, 90.0, 100.0, 130.0, 400.0])
def test_a_curve_goes_on_with_the_square_of_the_speed(speed: float):
    """3 N m + 0.002 N m s2 * n^2, known up to 50 rad/s behind i = 2."""
    points = tuple((float(n), 3 + 0.002 * n**2) for n in range(0, 51, 5))
    state = LoadState(key="on", label="on", direction=1, torque=points[-1][1], inertia=1, speed=50, curve=points)
    found = MotorSide(state=state, ratio=2, gear_efficiency=1, motor_inertia=0.1).at_speed(speed)
    assert found.state.torque == pytest.approx(3 + 0.002 * (speed / 2) ** 2)
    assert found.state.curve[-1] == (pytest.approx(speed / 2), pytest.approx(found.state.torque))
    speeds, torques = zip(*found.state.curve, strict=True)
    assert list(speeds) == sorted(speeds)
    assert torques == pytest.approx([3 + 0.002 * n**2 for n in speeds])
    assert found.state.inertia == 1


def test_the_chart_shows_the_curve_of_the_fan():
    (shown,) = size(FAN).drive.diagrams
    load = next(one for one in shown.series if one.name.startswith("load:"))
    assert load.y[16] == pytest.approx(TORQUE / 4)
    assert load.x[16] == pytest.approx(SPEED / 2)


def test_between_two_speeds_only_that_part_of_the_curve_counts():
    """1000 and 500 rpm: TORQUE * (1 + 1/2 + 1/4) / 3 while changing over, TORQUE / 4 / 3 while braking from 500 rpm."""
    windings = ({"poles": 12, "frequency_hz": 52, "rated_power_kw": 2, "rated_speed_rpm": 500, "run_up_torque_nm": 40},
                {"poles": 6, "frequency_hz": 52, "rated_power_kw": 11, "rated_speed_rpm": 1000,
             "run_up_torque_nm": 100})  # fmt: skip
    changing = motor(*windings, rotor_inertia_kgm2=0.5, rotor_inertia_with_brake_kgm2=0.5)
    sheet = size(request(FAN, drive={"kind": "pole_changing", "motor": changing})).sheet
    assert sheet.value(f"{ONE}_change_load_torque") == pytest.approx(TORQUE * 1.75 / 3, rel=1e-3)
    assert sheet.value(f"{ONE}_braking_load_torque") == pytest.approx(TORQUE / 12, rel=2e-3)
    assert sheet.value(f"{ONE}_braking_emergency_load_torque") == pytest.approx(TORQUE / 3, rel=1e-3)


# --- curves -----------------------------------------------------------------------------------------------------------


def side(*torques: float, process: float = 0.0) -> MotorSide:
    """A load with these torques at equal steps up to 100 rad/s, behind i = 2."""
    points = tuple((100 * k / (len(torques) - 1), torque + process) for k, torque in enumerate(torques))
    state = LoadState(key="on", label="on", direction=1, torque=points[-1][1], inertia=1, speed=100, curve=points,
                      process_torque=process)  # fmt: skip
    return MotorSide(state=state, ratio=2, gear_efficiency=1, motor_inertia=0.1)


@given(torques=st.lists(st.floats(0, 1000), min_size=2, max_size=20), process=st.floats(0, 100))
def test_a_process_at_full_speed_is_no_part_of_the_mean(torques: list[float], process: float):
    made = side(*torques, process=process)
    assert made.changing.state.torque == pytest.approx(side(*torques).changing.state.torque, abs=1e-9)
    assert made.changing.changing == made.changing
    assert made.averaged.state.torque == pytest.approx(made.changing.state.torque + process, abs=1e-9)


@given(torques=st.lists(st.floats(0, 1000), min_size=2, max_size=20), share=st.floats(0.01, 0.99))
def test_the_parts_of_a_curve_make_up_the_whole(torques: list[float], share: float):
    made = side(*torques)
    low, high = made.between(0, share), made.between(share, 1)
    both = share * low.averaged.load_torque + (1 - share) * high.averaged.load_torque
    assert both == pytest.approx(made.averaged.load_torque, abs=1e-6)
    assert low.load_torque == pytest.approx(high.state.curve[0][1] / 2)


def test_a_torque_that_is_the_same_at_every_speed_has_no_curve():
    """Nothing is averaged or cut."""
    made = side(10, 10)
    plain = replace(made, state=replace(made.state, curve=()))
    assert plain.averaged is plain
    assert plain.between(0, 0.5) is plain
    assert made.averaged.load_torque == pytest.approx(plain.load_torque)


# --- gravity ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("torques", "back"),
    [((12, -8), -8), ((12, 4), 4), ((12, None), -8)],
    ids=["it falls", "friction holds it", "only one way is known"],
)
def test_what_pulls_a_load_back(torques: tuple[float, float | None], back: float):
    """Friction 2 and weight 10 N m, friction 8 and weight 4 N m, or what holding takes beyond friction."""
    up = LoadState(key="up", label="up", direction=1, torque=torques[0], inertia=1, speed=1)
    states = [up]
    if torques[1] is not None:
        states.append(replace(up, key="down", direction=-1, torque=torques[1]))
    friction = 8 if back > 0 else 2
    statics = Statics(friction=friction, forward=12, backward=0, holding=4 if back > 0 else 10, working=0,
                      rapid_speed=1, working_speed=1)  # fmt: skip
    found = Gravity(tuple(states), statics).opposite(up)
    assert (found.direction, found.torque, found.key) == (-1, pytest.approx(back), "up")
