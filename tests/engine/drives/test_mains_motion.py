"""Starting in star, and loads that come to rest before their brake applies: by hand on the table and the hoist."""

import math
from typing import Any

import numpy as np
import pytest

from app.engine.sheet import Verdict
from tests.line_fed_requests import BRAKE, HOIST, TABLE, calculated, example, motor, request, size

ONE = "unladen_forward"
UP, DOWN = "unladen_lifting", "unladen_lowering"
STAR: dict[str, Any] = {"starting": "star_delta"}


def slow_brake(torque: float, delay: float, **values: Any) -> dict[str, Any]:
    """Application time in ms."""
    return {"brake": {"own": {"torque_nm": torque, "application_time_dc_ms": delay, **values}}}


def texts(base: dict[str, Any], **parts: dict[str, Any]) -> list[str]:
    return [decision.text for decision in size(base, **parts).sheet.decisions]


# --- star-delta -------------------------------------------------------------------------------------------------------


def test_in_star_the_table_runs_up_with_a_third_of_the_torque():
    """20 / 3 N m: 0.06 kg m2 * 150 rad/s / (20 / 3 - 5) N m = 5.4 s instead of 0.6 s; 15 rad/s / 5.4 s."""
    sizing, checks = calculated(TABLE, drive=STAR)
    sheet = sizing.sheet
    assert sheet.value("run_up_torque") == pytest.approx(20)
    assert sheet.value("star_run_up_torque") == pytest.approx(20 / 3)
    assert sheet.value(f"{ONE}_run_up_time") == pytest.approx(5.4)
    assert sheet.value(f"{ONE}_run_up_acceleration") == pytest.approx(15 / 5.4)
    check = checks[f"run_up_torque_{ONE}"]
    assert (check.demanded, check.permitted) == (pytest.approx(5), pytest.approx(20 / 3))
    assert any("star" in text for text in texts(TABLE, drive=STAR))
    assert not any("star" in text for text in texts(TABLE))


def test_in_star_it_heats_more():
    """1000/h * 0.01 / 0.06 * (1 - 5 / 6.667) * 0.7 = 29.17/h; in delta 1 - 5 / 20."""
    starts = {name: size(TABLE, drive={"starting": name}).sheet.value("permissible_cycles") * 3600
              for name in ("direct", "star_delta")}  # fmt: skip
    assert starts["star_delta"] == pytest.approx(1000 / 6 * 0.25 * 0.7)
    assert starts["direct"] == pytest.approx(1000 / 6 * 0.75 * 0.7)


def test_steady_running_and_braking_do_not_change():
    direct, star = size(TABLE), size(TABLE, drive=STAR)
    for key in (f"{ONE}_static_power", "rated_torque", f"{ONE}_braking_time", f"{ONE}_braking_work"):
        assert star.sheet.value(key) == direct.sheet.value(key)


@pytest.mark.parametrize(("friction", "verdict"), [(40, Verdict.OK), (50, Verdict.TIGHT), (54, Verdict.FAILS)])
def test_a_load_above_the_torque_in_star_is_not_started(friction: float, verdict: Verdict):
    """54 N m / 8 = 6.75 N m of 6.67 N m; in delta there are 20 N m."""
    table = {"friction_torque_nm": friction}
    sizing, checks = calculated(TABLE, mechanism=table, drive=STAR)
    assert checks[f"run_up_torque_{ONE}"].verdict == verdict
    assert sizing.sheet.has(f"{ONE}_run_up_time") == (verdict != Verdict.FAILS)
    assert calculated(TABLE, mechanism=table)[1][f"run_up_torque_{ONE}"].verdict == Verdict.OK


def test_in_star_the_trolley_needs_no_flywheel():
    """SEW 2001, 8.1 in star: (3.695931 / 3 - 0.2495662) * 0.5 / (0.73575 * 282.7433) - 0.0060373 < 0 kg m2."""
    sizing, checks = calculated(example("sew-08-1-travel-drive-two-pole"), drive=STAR)
    least = (3.695931 / 3 - 0.2495662) * 0.5 / (0.73575 * 282.7433) - 0.000551 - 0.0054863
    assert sizing.sheet.value("unladen_forward_least_flywheel") == pytest.approx(least, rel=1e-4)
    assert least < 0
    assert checks["slip_starting_unladen_forward"].verdict == Verdict.OK


def test_the_chart_shows_star_beside_delta():
    """20 N m and 20 / 3 N m; both fall to nothing at 157.08 rad/s from the same speed on."""
    (shown,) = size(TABLE, drive=STAR).drive.diagrams
    lines = {one.name: one for one in shown.series}
    star, delta = lines["mean run-up torque, in star"], lines["mean run-up torque"]
    assert (star.role, delta.role) == ("limit", "second")
    assert star.y == pytest.approx(delta.y / 3)
    assert star.x == pytest.approx(delta.x)
    assert delta.y[0] == pytest.approx(20)
    (plain,) = size(TABLE).drive.diagrams
    assert [one.role for one in plain.series if one.name.startswith("mean run-up")] == ["limit"]


def test_the_gear_unit_must_bear_the_torque_in_delta():
    """The change to delta comes with the whole torque: what the gear unit bears does not become easier."""
    keys = [{step.key: step.value for step in size(TABLE, drive=drive).sheet.steps} for drive in ({}, STAR)]
    same = [key for key in keys[0] if "service" in key or "gear" in key]
    assert same
    assert [keys[0][key] for key in same] == [keys[1][key] for key in same]


@pytest.mark.parametrize(("winding", "low", "high"), [("high", 4, 20 / 3), ("low", 4 / 3, 20)])
def test_only_the_winding_that_starts_is_in_star(winding: str, low: float, high: float):
    """4 and 20 N m; the change-over takes 2.5 * 4 N m whatever the start does."""
    windings = ({"poles": 8, "rated_power_kw": 0.14, "rated_speed_rpm": "70 rad/s", "run_up_torque_nm": 4},
                {"poles": 2, "rated_power_kw": 3, "rated_speed_rpm": "300 rad/s"})  # fmt: skip
    drive = {**STAR, "kind": "pole_changing", "motor": motor(*windings), "start_winding": winding,
             "gear_unit": {"own": {"ratio": 20, "efficiency": 0.8}}}  # fmt: skip
    _, checks = calculated(TABLE, drive=drive)
    assert checks[f"run_up_torque_{ONE}"].permitted == pytest.approx(high)
    if winding == "low":
        assert checks[f"run_up_torque_{ONE}_low"].permitted == pytest.approx(low)
    assert size(TABLE, drive=drive).sheet.value("change_over_torque") == pytest.approx(10)


# --- at rest before the brake applies ---------------------------------------------------------------------------------


def test_a_hoist_that_falls_back_is_stopped_from_there():
    """Lifting ends by itself after 0.0225 * 150 / 12.5 = 0.27 s. For the 0.13 s that are left of 0.4 s it falls with
    8 / 0.018 rad/s2, then 20 - 8 N m stop it."""
    sizing, checks = calculated(HOIST, drive=slow_brake(20, 400))
    sheet, speed = sizing.sheet, 8 / 0.018 * 0.13
    time = 0.018 * speed / 12
    assert sheet.value(f"{UP}_coasting_time") == pytest.approx(0.27)
    assert sheet.value(f"{UP}_falling_back_speed") == pytest.approx(speed)
    assert sheet.value(f"{UP}_braking_time") == pytest.approx(time)
    assert sheet.value(f"{UP}_braking_speed") == pytest.approx(speed * 0.01)
    assert sheet.value(f"{UP}_braking_work") == pytest.approx(20 * speed * time / 2)
    path = 0.01 * (150 * 0.27 + speed * 0.13 + speed * time) / 2
    assert sheet.value(f"{UP}_stopping_distance") == pytest.approx(path)
    check = checks[f"brake_stops_{UP}"]
    assert (check.demanded, check.permitted) == (pytest.approx(8), pytest.approx(20))
    assert "The load falls back before the brake applies" in [one.text for one in sheet.decisions]


def test_a_brake_too_weak_for_what_falls_back_fails():
    """7.9 N m against 8 N m."""
    sizing, checks = calculated(HOIST, drive=slow_brake(7.9, 400))
    assert checks[f"brake_stops_{UP}"].verdict == Verdict.FAILS
    assert not sizing.sheet.has(f"{UP}_braking_time")


def test_a_load_that_friction_stops_just_stands():
    """2200 N up, 200 N against it on its way down: 0.0225 * 150 / 27.5 s and half of 150 rad/s, no brake work."""
    made = request(HOIST, mechanism={"friction_force_n": 1200}, drive=slow_brake(20, 400, work_until_adjustment_mj=1))
    made["motion"]["runs"] = made["motion"]["runs"][:1]
    sizing, checks = calculated(made)
    sheet, time = sizing.sheet, 0.0225 * 150 / 27.5
    assert sheet.value(f"{UP}_coasting_time") == pytest.approx(time)
    assert sheet.value(f"{UP}_coasting_distance") == pytest.approx(0.01 * 150 * time / 2)
    assert sheet.value(f"{UP}_stopping_distance") == pytest.approx(0.01 * 150 * time / 2)
    assert sheet.value(f"{UP}_coasting_deceleration") == pytest.approx(1.5 / time)
    assert not sheet.has(f"{UP}_braking_time")
    assert checks[f"brake_stops_{UP}"].demanded == 0
    assert "The load stands before the brake applies" in [one.text for one in sheet.decisions]
    assert sheet.value("mean_braking_work") == 0
    assert not sheet.has("brake_life")


def test_a_brake_that_applies_as_the_load_stands_only_holds():
    """0.27 s to the moment."""
    sheet = size(HOIST, drive=slow_brake(20, 270)).sheet
    assert sheet.value(f"{UP}_stopping_distance") == pytest.approx(0.01 * 150 * 0.27 / 2, rel=1e-6)
    almost = size(HOIST, drive=slow_brake(20, 269.99)).sheet
    assert almost.value(f"{UP}_stopping_distance") == pytest.approx(0.01 * 150 * 0.27 / 2, rel=1e-4)


def test_the_path_does_not_jump_where_the_load_just_stands():
    """Longer application times let it fall further, from 0.27 s on."""
    paths = [size(HOIST, drive=slow_brake(20, ms)).sheet.value(f"{UP}_stopping_distance")
             for ms in np.linspace(240, 300, 13)]  # fmt: skip
    assert np.abs(np.diff(paths)).max() < 0.01
    assert paths[-1] > 0.01 * 150 * 0.27 / 2


def test_an_unbalance_swings_back():
    """20 N m of friction, 60 N m of unbalance: 8 N m slow the table down, 4 N m pull it back through the gear unit.
    0.06 * 150 / 10 = 0.9 s, then 4 * 0.8 N m on 0.01 + 0.04 * 0.8 kg m2 for 0.1 s."""
    unbalance = {"axis_tilt_deg": 90, "unbalance_mass_kg": 6, "unbalance_radius_mm": 1000}
    table, factors = {**unbalance, "friction_torque_nm": 20}, [{"state": ONE, "factor": 1}]
    factors.append({"state": "unladen_backward", "factor": 1})
    drive = {**slow_brake(20, 1000), "starting_factors": factors}
    sheet = size(TABLE, mechanism=table, environment={"gravity_m_s2": 10}, drive=drive).sheet
    assert sheet.value(f"{ONE}_coasting_time") == pytest.approx(0.9)
    assert sheet.value(f"{ONE}_falling_back_speed") == pytest.approx(4 * 0.8 / 0.042 * 0.1)


def test_lowering_quickens_however_long_the_brake_takes():
    """Synchronous speed and 8 / 0.018 rad/s2 for 0.4 s."""
    sheet = size(HOIST, drive=slow_brake(20, 400)).sheet
    down = 50 * math.pi + 8 / 0.018 * 0.4
    assert sheet.value(f"{DOWN}_braking_time") == pytest.approx(0.018 * down / 12)
    assert not sheet.has(f"{DOWN}_coasting_time")


def test_a_table_that_nothing_pulls_is_not_slowed_down_in_the_delay():
    """Friction slows it down, but the longer path counts."""
    own = {"brake": {"own": {**BRAKE["own"], "application_time_dc_ms": 5000}}}
    assert size(TABLE, drive=own).sheet.value(f"{ONE}_stopping_distance") > 15 * 5
