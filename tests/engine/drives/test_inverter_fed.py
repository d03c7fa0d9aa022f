"""Induction motor on an inverter: torque limit, field weakening, cooling, effective torque, currents and braking."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.engine.drives.inverter_limits import InverterLimits
from app.engine.sheet import Verdict
from tests.line_fed_requests import BRAKE, HOIST, INDEXING, calculated, example, motor, refused, request, size

SYNCHRONOUS = 50 * math.pi
STRONG = {"motor": motor({"breakdown_torque_ratio": 2.5})}
DOUBLE = {"own": {"ratio": 20, "efficiency": 0.8}}
"""Twice the ratio: 300 rad/s at the motor, twice its rated speed."""


def moves(*speeds: float, seconds: float = 2, **values: Any) -> dict[str, Any]:
    """Moves of the table at these speeds [rad/s], 1 s of acceleration and of braking each."""
    return {
        "moves": [
            {"distance_deg": f"{speed * (seconds + 1)} rad", "speed_rpm": f"{speed} rad/s",
             "acceleration_rad_s2": speed, **values}
            for speed in speeds
        ]
    }  # fmt: skip


# --- torque -----------------------------------------------------------------------------------------------------------


def test_effective_torque_of_two_moves():
    """Each way: (40 + 60) / 8 + 0.01 * 150 = 14 N m for 1 s, 40 / 8 = 5 N m for 2 s, (40 - 60) * 0.08 - 1.5 = -3.1 N m
    for 1 s, 4 s with the brake closed: sqrt((196 + 50 + 9.61) / 8) = 5.6525 N m at (75 + 300 + 75) / 8 rad/s."""
    sizing, checks = calculated(INDEXING)
    assert sizing.sheet.value("peak_torque") == pytest.approx(14)
    assert sizing.sheet.value("phase_3_torque") == pytest.approx(-3.1)
    assert sizing.sheet.value("mean_speed") == pytest.approx(56.25)
    check = checks["effective_torque"]
    assert (check.demanded, check.permitted) == (pytest.approx(math.sqrt(255.61 / 8)), pytest.approx(10))


def test_a_motor_that_holds_instead_of_the_brake_is_not_heated_by_friction():
    """Standstill with the motor on: no friction to hold, the same effective torque; the hoist is held with 10 N m."""
    held = [{**move, "hold": "motor"} for move in INDEXING["motion"]["moves"]]
    assert size(INDEXING, motion={"moves": held}).sheet.value("effective_torque") == pytest.approx(5.65254, rel=1e-5)
    move = {"distance_mm": 1500, "speed_m_s": 1.5, "acceleration_m_s2": 1.5, "dwell_s": 2}
    hoist = request(HOIST, drive={"kind": "inverter_fed", "starting_factors": None})
    rms = {}
    for hold in ("brake", "motor"):
        hoist["motion"] = {"kind": "moves", "moves": [{**move, "distance_mm": s, "hold": hold} for s in (1500, -1500)]}
        rms[hold] = size(hoist).sheet.value("effective_torque")
    assert rms["motor"] ** 2 - rms["brake"] ** 2 == pytest.approx(10**2 * 4 / 8)


@pytest.mark.parametrize(
    ("limit", "verdict"), [(None, Verdict.FAILS), (139, Verdict.FAILS), (140, Verdict.TIGHT), (150, Verdict.TIGHT)]
)
def test_while_starting_the_torque_limit_is_130_percent_unless_the_inverter_gives_more(
    limit: float | None, verdict: Verdict
):
    """14 N m of 10 N m; SEW 2001, 8.4: 150 % current gives 130 % torque."""
    sizing, checks = calculated(INDEXING, drive={"torque_limit_percent": limit})
    check = checks["torque_limit"]
    assert sizing.sheet.value("torque_ratio") == pytest.approx(1.4)
    assert (check.demanded, check.permitted) == (pytest.approx(14), pytest.approx((limit or 130) / 10))
    assert check.verdict == verdict
    assumed = {assumption.key for assumption in sizing.sheet.assumptions}
    assert ("drive.torque_limit_percent" in assumed) == (limit is None)


@pytest.mark.parametrize(("process", "verdict"), [(72, Verdict.TIGHT), (79.9, Verdict.TIGHT), (80.1, Verdict.FAILS)])
def test_above_a_quarter_of_rated_speed_the_torque_limit_is_150_percent(process: float, verdict: Verdict):
    """(40 + 72) / 8 = 14 N m at full speed only, and 5 + 0.1 * (0.04 / 0.8 + 0.01) * 150 = 5.9 N m to get there."""
    move = {"distance_deg": "450 rad", "speed_rpm": "15 rad/s", "acceleration_rad_s2": 1.5}
    motion = {"moves": [{**move, "process_torque_nm": process, "process_during": "constant_speed"}]}
    check = calculated(INDEXING, motion=motion)[1]["torque_limit"]
    assert (check.demanded, check.permitted) == (pytest.approx(5 + process / 8), pytest.approx(15))
    assert check.verdict == verdict
    own = calculated(INDEXING, motion=motion, drive={"torque_limit_percent": 130})[1]["torque_limit"]
    assert (own.permitted, own.verdict) == (pytest.approx(13), Verdict.FAILS)


def test_below_a_quarter_of_rated_speed_it_is_130_percent_at_every_speed():
    """37.5 rad/s of 150 rad/s; the table that turns by 30 rad/s at most is started with 14 N m."""
    limits = InverterLimits(rated_torque=10, rated_speed=150, peak=1.5, breakdown=None, max_speed=200,
                            starting_peak=1.3, starting_speed=37.5)  # fmt: skip
    speeds = np.array([0, 37.4, -37.4, 37.5, 150, -150, 300])
    assert limits.largest(speeds) == pytest.approx([13, 13, 13, 15, 15, 15, 7.5])
    shown = dict(limits.peak_points())
    assert (shown[0.0], shown[37.5], shown[150.0]) == (pytest.approx(13), pytest.approx(15), pytest.approx(15))
    sizing, checks = calculated(INDEXING, motion=moves(3, acceleration_rad_s2=15))
    assert (checks["torque_limit"].demanded, checks["torque_limit"].permitted) == (pytest.approx(14), pytest.approx(13))
    assumed = {one.key: one.value for one in sizing.sheet.assumptions}
    assert (assumed["drive.torque_limit_percent"], assumed["drive.torque_limit_percent.starting"]) == (1.5, 1.3)


@pytest.mark.parametrize("key", ["torque_limit", "effective_torque", "inverter_peak_current", "resistor_mean_power"])
def test_torque_without_the_rotor_is_not_judged(key: str):
    """12.5 of 13 N m would hold; a rotor of 0.01 kg m2 makes it 14."""
    unknown = motor({"rated_current_a": 4}, rotor_inertia_kgm2=None, rotor_inertia_with_brake_kgm2=None)
    resistor = {"own": {"ratings": [{"duty_percent": 100, "power_kw": 1}]}}
    lacking = {"motor": unknown, "inverter": {"own": {"rated_current_a": 6}}, "braking_resistor": resistor}
    sizing, checks = calculated(INDEXING, drive=lacking)
    assert (checks[key].verdict, checks[key].missing) == (Verdict.NOT_CHECKED, "rotor inertia of the motor")
    assert sizing.drive.effective_torque is None
    assert sizing.drive.cycle is not None
    assert sizing.drive.cycle.torque is None
    assert "drive.motor.rotor_inertia" in {one.key for one in sizing.sheet.assumptions}


def test_a_rotor_that_never_accelerates_need_not_be_known():
    """40 N m / 8 all the time."""
    lacking = {"motor": motor(rotor_inertia_kgm2=None, rotor_inertia_with_brake_kgm2=None)}
    made = request(INDEXING, drive=lacking)
    made["motion"] = {"kind": "constant_rotation", "speed_rpm": "15 rad/s"}
    check = calculated(made)[1]["effective_torque"]
    assert (check.demanded, check.permitted) == (pytest.approx(5), pytest.approx(10))


def test_a_flywheel_takes_torque_without_losses():
    """0.02 kg m2 * 150 rad/s2 more: 17 N m."""
    assert size(INDEXING, drive={"flywheel_inertia_kgm2": 0.02}).sheet.value("peak_torque") == pytest.approx(17)


def test_the_opposite_direction_of_a_hoist_counts_for_the_peak():
    """Only lowered in its motion: lifting (1000 + 150) N * 0.1 m / 8 + 0.01 * 150 = 15.875 N m all the same."""
    made = request(HOIST, drive={"kind": "inverter_fed", "starting_factors": None})
    made["motion"] = {"kind": "moves", "moves": [{"distance_mm": -3000, "speed_m_s": 1.5, "acceleration_m_s2": 1.5}]}
    assert size(made).sheet.value("peak_torque") == pytest.approx(15.875)


# --- field weakening --------------------------------------------------------------------------------------------------


def test_in_field_weakening_the_breakdown_torque_falls_with_the_square():
    """300 rad/s: (300 + 7.0796 * 2.5 / 10) * 4 / 4 pi = 96.056 Hz. M_N 10 * 50 / 96.056 = 5.205 N m, M_K
    25 * (50 / 96.056)^2 = 6.774 N m; 100 / 16 + 0.01 * 300 = 9.25 N m are needed: 0.732 of 1.25."""
    sizing, checks = calculated(INDEXING, drive={**STRONG, "gear_unit": DOUBLE})
    f = (300 + (SYNCHRONOUS - 150) * 0.25) / math.pi
    assert sizing.sheet.value("highest_frequency") == pytest.approx(f)
    assert sizing.sheet.value("weakened_rated_torque") == pytest.approx(500 / f)
    assert sizing.sheet.value("weakened_breakdown_torque") == pytest.approx(25 * (50 / f) ** 2)
    check = checks["breakdown_reserve"]
    assert (check.demanded, check.permitted) == (1.25, pytest.approx(25 * (50 / f) ** 2 / 9.25))
    assert check.verdict == Verdict.FAILS
    # torque limit at twice the rated speed: 25 N m / 1.25 / 4, less than 1.3 * 10 N m / 2
    assert checks["torque_limit"].permitted == pytest.approx(5)


def test_a_higher_limit_of_frequency_is_judged_at_that_frequency():
    """Permitted up to 120 Hz, whatever the motion needs: 25 N m * (50 / 120)^2."""
    drive = {**STRONG, "gear_unit": DOUBLE, "max_frequency_hz": 120}
    sheet = size(INDEXING, drive=drive).sheet
    assert sheet.value("weakened_breakdown_torque") == pytest.approx(25 * (50 / 120) ** 2)


def test_without_breakdown_torque_field_weakening_is_not_checked():
    _, checks = calculated(INDEXING, drive={"gear_unit": DOUBLE})
    assert checks["breakdown_reserve"].verdict == Verdict.NOT_CHECKED
    assert "breakdown torque" in checks["breakdown_reserve"].missing
    assert "breakdown_reserve" not in calculated(INDEXING, drive=STRONG)[1]  # not above 50 Hz


@pytest.mark.parametrize(("ratio", "weak"), [(17.7, False), (17.8, True)])
def test_in_delta_at_87_hz_the_flux_stays(ratio: float, weak: bool):
    """Rated slip stays: 157.08 * 87 / 50 - 7.08 = 266.24 rad/s, or 15 rad/s times 17.749."""
    gear = {"own": {"ratio": ratio, "efficiency": 0.8}}
    _, checks = calculated(INDEXING, drive={**STRONG, "gear_unit": gear, "knee_frequency_hz": 87})
    assert ("breakdown_reserve" in checks) == weak
    assert "breakdown_reserve" in calculated(INDEXING, drive={**STRONG, "gear_unit": gear})[1]


@given(speed=st.floats(0, 2000), knee=st.floats(10, 400), peak=st.floats(1, 2), breakdown=st.floats(1.5, 4))
def test_limits_of_torque_over_speed(speed: float, knee: float, peak: float, breakdown: float):
    """1 / f for the rated torque, 1 / f^2 for the breakdown torque; neither sign of the speed matters."""
    limits = InverterLimits(rated_torque=10, rated_speed=knee, peak=peak, breakdown=10 * breakdown, max_speed=None)
    weak = max(speed / knee, 1)
    largest, rated = (float(limit(np.array([speed]))[0]) for limit in (limits.largest, limits.continuous))
    assert rated == pytest.approx(10 / weak)
    expected = 10 * peak if weak == 1 else min(10 * peak / weak, 10 * breakdown / weak**2)
    assert largest == pytest.approx(expected)
    assert float(limits.largest(np.array([-speed]))[0]) == largest


def test_the_motor_of_the_handbook_runs_at_100_hz():
    """SEW 2001, 8.4, recomputed: empty back at 100 Hz, 14.9 N m at 1410 rpm with M_K / M_N = 2.349: 8.75 N m."""
    sheet = size(example("sew-08-4-travel-drive-inverter")).sheet
    assert sheet.value("rated_torque") == pytest.approx(2200 / (1410 * math.pi / 30))
    expected = 2.3490545074735434 * 2200 / (1410 * math.pi / 30) * 0.25
    assert sheet.value("weakened_breakdown_torque") == pytest.approx(expected)


# --- frequency and speed range ----------------------------------------------------------------------------------------


def test_hoists_reach_their_speed_at_70_hz_unless_told():
    """1.5 m/s is 15 rad/s: i = 10 gives 150 rad/s + 1.25 * 7.08 = 50.56 Hz, i = 15 more than 70 Hz."""
    move = {"distance_mm": 4500, "speed_m_s": 1.5, "acceleration_m_s2": 1.5}
    made = request(HOIST, drive={"kind": "inverter_fed", "starting_factors": None})
    made["motion"] = {"kind": "moves", "moves": [move]}
    sizing, checks = calculated(made)
    check = checks["highest_frequency"]
    assert check.demanded == pytest.approx((150 + (SYNCHRONOUS - 150) * 1.25) / math.pi)
    assert (check.permitted, check.verdict) == (70, Verdict.OK)
    assert "drive.max_frequency" in {assumption.key for assumption in sizing.sheet.assumptions}
    fast = {"gear_unit": {"own": {"ratio": 15, "efficiency": 0.8}}}
    assert calculated(made, drive=fast)[1]["highest_frequency"].verdict == Verdict.FAILS
    assert calculated(made, drive={**fast, "max_frequency_hz": 100})[1]["highest_frequency"].verdict == Verdict.OK
    assert "highest_frequency" not in calculated(INDEXING)[1]


@pytest.mark.parametrize(("slow", "verdict"), [(2.99, Verdict.FAILS), (3.01, Verdict.TIGHT), (5.0, Verdict.OK)])
def test_an_own_fan_cools_over_a_range_of_5(slow: float, verdict: Verdict):
    """15 rad/s over the slowest steady speed."""
    sizing, checks = calculated(INDEXING, motion=moves(15, slow))
    assert checks["speed_range"].demanded == pytest.approx(15 / slow)
    assert checks["speed_range"].verdict == verdict
    assert sizing.sheet.value("speed_range") == pytest.approx(15 / slow)
    forced = calculated(INDEXING, motion=moves(15, slow), drive={"cooling": "forced"})[1]
    assert "speed_range" not in forced
    assert "reduced_power" not in forced


def test_with_an_own_fan_only_the_next_smaller_rating_counts():
    """3 N m steady and no more: a table that hardly has inertia. 24 N m / 8 * 150 rad/s = 450 W of 1.1 kW."""
    thin = {"bodies": [{"shape": "point", "mass_kg": 1e-6, "radius_mm": 1000}], "friction_torque_nm": 24}
    drive: dict[str, Any] = {"motor": motor(rotor_inertia_kgm2=1e-9, rotor_inertia_with_brake_kgm2=1e-9)}
    _, checks = calculated(INDEXING, mechanism=thin, motion=moves(15, 5), drive={**drive, "reduced_power_kw": 1.1})
    assert checks["reduced_power"].demanded == pytest.approx(450, rel=1e-4)
    assert checks["reduced_power"].permitted == pytest.approx(1100)
    unknown = calculated(INDEXING, mechanism=thin, motion=moves(15, 5), drive=drive)[1]["reduced_power"]
    assert (unknown.verdict, bool(unknown.missing)) == (Verdict.NOT_CHECKED, True)


# --- inverter and resistor --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("number", "overload", "rated", "peak"),
    [
        (1, None, Verdict.TIGHT, Verdict.TIGHT),
        (1, 5.5, Verdict.TIGHT, Verdict.FAILS),
        (2, 12, Verdict.FAILS, Verdict.TIGHT),
    ],
)
def test_the_inverter_bears_rated_and_peak_current(number: int, overload: float | None, rated: Verdict, peak: Verdict):
    """4 A for 10 N m: 14 N m are 5.6 A of 150 % of 4 A each."""
    inverter = {"own": {"rated_current_a": 4, **({"overload_current_a": overload} if overload else {})}}
    drive = {"motor": motor({"rated_current_a": 4}), "inverter": inverter, "motors_per_inverter": number}
    _, checks = calculated(INDEXING, drive=drive)
    assert checks["inverter_current"].demanded == pytest.approx(4 * number)
    assert checks["inverter_current"].verdict == rated
    assert checks["inverter_peak_current"].demanded == pytest.approx(5.6 * number)
    assert checks["inverter_peak_current"].permitted == pytest.approx(overload or 6)
    assert checks["inverter_peak_current"].verdict == peak


def test_currents_that_are_not_known_are_named():
    check = calculated(INDEXING, drive={"inverter": {"own": {"motor_power_kw": 1.1}}})[1]
    assert check["inverter_current"].missing == "rated current of the motor, rated current of the inverter"
    assert check["inverter_power"].verdict == Verdict.FAILS  # 1.5 kW of 1.1 kW


def test_braking_returns_465_joules_in_a_cycle():
    """3.1 N m from 150 rad/s to 0 in 1 s, twice in 16 s: 232.5 W, peak 465 W, 12.5 % of the time: the 25 % row."""
    ratings = [{"duty_percent": 6, "power_kw": 1}, {"duty_percent": 12, "power_kw": 0.6},
               {"duty_percent": 25, "power_kw": 0.3}, {"duty_percent": 100, "power_kw": 0.1}]  # fmt: skip
    drive = {"braking_resistor": {"own": {"ratings": ratings}}, "chopper_limit_kw": 0.4}
    sizing, checks = calculated(INDEXING, drive=drive)
    assert sizing.sheet.value("braking_energy_of_cycle") == pytest.approx(465)
    assert sizing.sheet.value("braking_duty") == pytest.approx(0.125)
    mean, peak, chopper = (checks[key] for key in ("resistor_mean_power", "resistor_peak_power", "chopper_power"))
    assert (mean.demanded, mean.permitted) == (pytest.approx(232.5), pytest.approx(300))
    assert (peak.demanded, peak.permitted) == (pytest.approx(465), pytest.approx(1000))
    assert chopper.verdict == Verdict.FAILS


def test_lowering_at_constant_speed_is_braking_too():
    """1000 N * 1.5 m/s * 0.8 for 1 s: 1200 J beside the two ramps."""
    made = request(HOIST, drive={"kind": "inverter_fed", "starting_factors": None})
    move = {"distance_mm": -3000, "speed_m_s": 1.5, "acceleration_m_s2": 1.5}
    made["motion"] = {"kind": "moves", "moves": [move]}
    sheet = size(made).sheet
    # ramps: (1000 -+ 150) N * 0.01 m * 0.8 -+ 1.5 N m = 5.3 and 10.7 N m over 75 rad each
    assert sheet.value("braking_energy_of_cycle") == pytest.approx(1200 + 75 * (5.3 + 10.7))
    assert sheet.value("peak_braking_power") == pytest.approx(10.7 * 150)


def test_the_brake_stops_from_creep_speed_only():
    """A tenth of 150 rad/s: 0.042 * 15 / 13.2 s, 1.5 rad/s * (0.02 s + half of it)."""
    motion = moves(15, creep_share=0.1, creep_time_s=0.5, dwell_s=4, hold="brake")
    sheet = size(INDEXING, motion=motion, drive={"brake": BRAKE}).sheet
    assert sheet.value("creep_motor_speed") == pytest.approx(15)
    assert sheet.value("unladen_forward_braking_time") == pytest.approx(0.042 * 15 / 13.2)
    assert sheet.value("unladen_forward_stopping_distance") == pytest.approx(1.5 * (0.02 + 0.5 * 0.63 / 13.2))
    assert not size(INDEXING, drive={"brake": BRAKE}).sheet.has("creep_motor_speed")


def test_when_the_mains_fail_the_brake_stops_from_full_speed():
    """0.042 * 150 / 13.2 s; 10 N m * 150 rad/s * t / 2, whether or not there is a creep speed."""
    sizing, checks = calculated(INDEXING, drive={"brake": BRAKE})
    time = 0.042 * 150 / 13.2
    assert sizing.sheet.value("unladen_forward_emergency_braking_time") == pytest.approx(time)
    assert checks["brake_work"].demanded == pytest.approx(750 * time)
    assert not sizing.sheet.has("mean_braking_work")


def test_a_stop_with_an_unknown_rotor_is_not_checked():
    lacking = {"motor": motor(rotor_inertia_kgm2=None, rotor_inertia_with_brake_kgm2=None), "brake": BRAKE}
    check = calculated(INDEXING, drive=lacking)[1]["brake_stops"]
    assert (check.verdict, check.missing) == (Verdict.NOT_CHECKED, "rotor inertia of the motor")


@pytest.mark.parametrize("brake", [None, {"own": {"torque_nm": 10}}])
def test_holding_a_hoist_is_checked_or_said_not_to_be(brake: dict[str, Any] | None):
    """1000 N * 0.1 m / 10, twice."""
    made = request(HOIST, drive={"kind": "inverter_fed", "starting_factors": None, "brake": brake})
    made["motion"] = {"kind": "moves", "moves": [{"distance_mm": 3000, "speed_m_s": 1.5, "acceleration_m_s2": 1.5}]}
    check = calculated(made)[1]["brake_holding"]
    assert check.demanded == pytest.approx(20)
    assert check.verdict == (Verdict.NOT_CHECKED if brake is None else Verdict.FAILS)


def test_the_chopper_is_checked_without_a_resistor_too():
    """465 W at the peak, of 400 W and of 1 kW; without a limit there is nothing to check."""
    for limit, verdict in ((0.4, Verdict.FAILS), (1, Verdict.OK)):
        check = calculated(INDEXING, drive={"chopper_limit_kw": limit})[1]["chopper_power"]
        assert (check.demanded, check.permitted) == (pytest.approx(465), pytest.approx(limit * 1000))
        assert check.verdict == verdict
    assert "chopper_power" not in calculated(INDEXING)[1]
    unknown = motor(rotor_inertia_kgm2=None, rotor_inertia_with_brake_kgm2=None)
    check = calculated(INDEXING, drive={"chopper_limit_kw": 1, "motor": unknown})[1]["chopper_power"]
    assert (check.verdict, check.missing) == (Verdict.NOT_CHECKED, "rotor inertia of the motor")


def test_stops_without_a_motor_say_that_its_rotor_is_left_out():
    """0.04 * 0.8 kg m2 of the table alone."""
    sheet = size(INDEXING, drive={"motor": None, "brake": BRAKE}).sheet
    assert sheet.value("unladen_forward_emergency_braking_time") == pytest.approx(0.032 * 150 / 13.2)
    (found,) = (one for one in sheet.assumptions if one.key == "drive.motor.rotor_inertia")
    assert "stop" in found.text


@pytest.mark.parametrize(("frequency", "accepted"), [(2.2, False), (2.3, True)])
def test_a_knee_below_the_slip_is_refused(frequency: float, accepted: bool):
    """150 of 157.08 rad/s at 50 Hz: slip of 2.254 Hz."""
    drive = {"knee_frequency_hz": frequency}
    if accepted:
        assert "torque_limit" in calculated(INDEXING, drive=drive)[1]
        return
    ((name, message),) = refused(INDEXING, drive=drive)
    assert name == "drive.knee_frequency_hz"
    assert "2.254 Hz" in message


@pytest.mark.parametrize(("speed", "verdict"), [(2.9, Verdict.FAILS), (3.1, Verdict.TIGHT), (7.5, Verdict.OK)])
def test_one_low_speed_is_too_little_for_an_own_fan(speed: float, verdict: Verdict):
    """150 rad/s rated over i = 10 times the only speed: 5.17, 4.84 and 2 of 5."""
    sizing, checks = calculated(INDEXING, motion=moves(speed))
    assert checks["speed_range"].demanded == pytest.approx(15 / speed)
    assert checks["speed_range"].verdict == verdict
    assert sizing.sheet.value("cooling_range") == pytest.approx(15 / speed)
    assert "speed_range" not in calculated(INDEXING, motion=moves(speed), drive={"cooling": "forced"})[1]
    # from half of the rated speed on it gives rated torque; below that its rating is reduced
    assert ("reduced_power" in checks) == (speed < 7.5)


def test_two_low_speeds_are_compared_with_the_rated_one():
    """4 and 2 rad/s are 1 : 2, but 1 : 7.5 of the rated speed; the torque counts at rated speed."""
    sizing, checks = calculated(INDEXING, motion=moves(4, 2), drive={"reduced_power_kw": 1.1})
    assert sizing.sheet.value("speed_range") == pytest.approx(2)
    assert checks["speed_range"].demanded == pytest.approx(7.5)
    power = sizing.sheet.value("effective_torque") * 150
    assert checks["reduced_power"].demanded == pytest.approx(power)


def test_at_rated_speed_and_above_there_is_nothing_to_reduce():
    for speed in (15, 16):
        assert "speed_range" not in calculated(INDEXING, motion=moves(speed))[1]


def test_a_speed_that_changes_slowly_is_kept_all_the_same():
    """A web of 1 m/s on a core of 0.1 m: 20 rad/s, 4 rad/s at 0.5 m; i = 5 gives 100 down to 20 of 150 rad/s."""
    made: dict[str, Any] = {
        "mechanism": {"kind": "winder", "core_diameter_mm": 100, "full_diameter_mm": 500, "width_mm": 100,
                      "thickness_mm": 1, "density_kg_m3": 1, "tension_n": 50},
        "motion": {"kind": "constant", "speed_m_s": 1},
        "drive": {**INDEXING["drive"], "gear_unit": {"own": {"ratio": 5, "efficiency": 0.8}}},
    }  # fmt: skip
    check = calculated(made)[1]["speed_range"]
    assert check.demanded == pytest.approx(7.5, rel=0.02)
    assert check.verdict == Verdict.FAILS
