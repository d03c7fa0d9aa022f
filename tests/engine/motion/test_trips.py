"""Runs whose ramps are the drive's own, and the states of load that follow from a motion."""

import pytest
from pydantic import ValidationError

from app.engine.environment import Environment
from app.engine.errors import MotionError
from app.engine.mechanisms.states import steady_runs
from app.engine.mechanisms.travel_drive import TravelDrive
from app.engine.motion import Moves, Trips
from app.engine.sheet import Sheet

TROLLEY = {"vehicle_mass_kg": 1500, "wheel_diameter_mm": 250, "journal_diameter_mm": 60}


def trips(**more: object) -> Trips:
    runs = [{"label": "laden", "payload_kg": 1500, "duration_s": 9.6},
            {"label": "unladen", "direction": "backward", "distance_m": 4.8}]  # fmt: skip
    return Trips.model_validate({"speed_m_s": 0.5, "runs": runs, **more})


def test_cycle_of_75_trips_per_hour_has_40_percent_duty() -> None:
    """SEW 2001, 8.1: 75 trips each way in an hour at 40 %: 48 s per cycle, 9.6 s per run (4.8 m at 0.5 m/s)."""
    sheet = Sheet()
    profile = trips(cycles_per_hour=75).solve(sheet)
    assert profile.cycle_time == pytest.approx(48.0)
    assert sheet.value("duty_share") == pytest.approx(0.4)
    assert profile.own_ramps
    laden, unladen = steady_runs(profile)
    assert (laden.key, laden.starts, laden.duration) == ("laden_forward", 1.0, pytest.approx(9.6))
    assert (unladen.key, unladen.starts, unladen.duration) == ("unladen_backward", 1.0, pytest.approx(9.6))


def test_states_of_a_trolley_are_those_of_the_handbook() -> None:
    """Rolling resistance 241.326 N laden, 120.663 N unladen (SEW 2001, 8.1) on a wheel of 0.125 m; J = m r^2."""
    motion = trips(cycles_per_hour=75).solve(Sheet())
    load = TravelDrive.model_validate(TROLLEY).load(motion, Environment.model_validate({}), Sheet())
    laden, unladen = load.states
    assert laden.torque == pytest.approx(241.326 * 0.125)
    assert unladen.torque == pytest.approx(120.663 * 0.125)
    assert laden.inertia == pytest.approx(3000 * 0.125**2)
    assert laden.permissible_acceleration == pytest.approx(0.73575)
    assert laden.speed == pytest.approx(4.0)


def test_a_slope_adds_the_other_direction_with_the_sign_of_the_weight() -> None:
    motion = Moves.model_validate(
        {"moves": [{"distance_mm": 1000, "speed_m_s": 0.5, "acceleration_m_s2": 1, "payload_kg": 100}], "pause_s": 1}
    ).solve(Sheet())
    trolley = TravelDrive.model_validate({**TROLLEY, "slope_deg": 30})
    load = trolley.load(motion, Environment.model_validate({}), Sheet())
    by_key = {state.key: state for state in load.states}
    assert set(by_key) == {"laden_forward", "laden_backward", "unladen_forward", "unladen_backward"}
    weight = 1600 * 9.81 * 0.5 * 0.125
    up, down = by_key["laden_forward"].torque, by_key["laden_backward"].torque
    assert up - down == pytest.approx(2 * weight)
    assert down < 0 < up
    assert by_key["laden_forward"].starts == 1
    assert by_key["laden_backward"].starts == 0


def test_too_many_cycles_are_refused_at_their_field() -> None:
    with pytest.raises(MotionError) as error:
        trips(cycles_per_hour=200).solve(Sheet())
    assert error.value.path == ("cycles_per_hour",)


def test_a_run_needs_a_way_or_a_time() -> None:
    for run in ({}, {"distance_m": 1, "duration_s": 1}):
        with pytest.raises(ValidationError, match="either the way"):
            Trips.model_validate({"speed_m_s": 1, "runs": [run]})
