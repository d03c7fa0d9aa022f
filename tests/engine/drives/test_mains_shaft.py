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
            {"poles": 6, "rated_power_kw": 11, "rated_speed_rpm": 1000, "run_up_torque_nm": 100},
            rotor_inertia_kgm2=0.5, rotor_inertia_with_brake_kgm2=0.5,
        ),
        "brake": {"own": {"torque_nm": 50, "application_time_dc_ms": 20}},
        "starting_factors": [{"state": ONE, "factor": 0.7}],
    },
}  # fmt: skip
"""8 kg m2 and 8 kW at 1000 rpm, directly on a motor of 0.5 kg m2 and 100 N m."""


# --- starting and stopping --------------------------------------------------------------------------------------------


def test_during_the_run_up_a_fan_takes_a_third_on_average():
    """76.394 / 3 N m: 8.5 kg m2 * 104.72 rad/s / (100 - 25.46) N m = 11.94 s; at full speed the whole torque."""
    sheet = size(FAN).sheet
    assert sheet.value(f"{ONE}_load_torque") == pytest.approx(76.394, rel=1e-5)
    assert sheet.value(f"{ONE}_mean_run_up_load_torque") == pytest.approx(76.394 / 3, rel=1e-3)
    assert sheet.value(f"{ONE}_starting_load_torque") == pytest.approx(TORQUE / 3 * STEPS)
    assert sheet.value(f"{ONE}_run_up_time") == pytest.approx(8.5 * SPEED / (100 - TORQUE / 3 * STEPS))
    assert sheet.value(f"{ONE}_run_up_time") == pytest.approx(11.94, rel=1e-3)
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
    """i = 2, 80 %: 25.46 / 2 N m, 25.46 / 1.6 N m with losses."""
    gear = {"gear_unit": {"own": {"ratio": 2, "efficiency": 0.8}}, "service_factor": 1.3}
    sheet = size(FAN, drive=gear).sheet
    assert sheet.value(f"{ONE}_mean_run_up_load_torque") == pytest.approx(TORQUE / 6 * STEPS)
    assert sheet.value(f"{ONE}_starting_load_torque") == pytest.approx(TORQUE / 4.8 * STEPS)


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


def test_in_star_a_fan_at_full_torque_is_too_much():
    """33.3 N m for 76.4 N m; for half the speed, with a quarter of the torque, they do."""
    key, star = f"run_up_torque_{ONE}", {"starting": "star_delta"}
    assert calculated(FAN, drive=star)[1][key].verdict == Verdict.FAILS
    slow = calculated(FAN, drive=star, motion={"speed_rpm": 500})[1][key]
    assert (slow.demanded, slow.permitted) == (pytest.approx(TORQUE / 4), pytest.approx(100 / 3))
    assert slow.verdict == Verdict.OK


def test_the_chart_shows_the_curve_of_the_fan():
    (shown,) = size(FAN).drive.diagrams
    load = next(one for one in shown.series if one.name.startswith("load:"))
    assert load.y[16] == pytest.approx(TORQUE / 4)
    assert load.x[16] == pytest.approx(SPEED / 2)


def test_between_two_speeds_only_that_part_of_the_curve_counts():
    """1000 and 500 rpm: TORQUE * (1 + 1/2 + 1/4) / 3 while changing over, TORQUE / 4 / 3 while braking from 500 rpm."""
    windings = ({"poles": 12, "rated_power_kw": 2, "rated_speed_rpm": 500, "run_up_torque_nm": 40},
                {"poles": 6, "rated_power_kw": 11, "rated_speed_rpm": 1000, "run_up_torque_nm": 100})  # fmt: skip
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
