"""States of load: how often a motion starts, counted by hand."""

from typing import Any

import pytest

from app.engine.mechanisms.states import SteadyRun, departures, steady_runs
from app.engine.motion.constant import ConstantRotation
from app.engine.motion.moves import Moves
from app.engine.motion.segments import Burden, Segments
from app.engine.sheet import Sheet
from tests.line_fed_requests import WINDING, calculated

NOTHING = Burden(0.0, 0.0)


def linear(*speeds: tuple[float, float], payload: tuple[float, ...] = ()) -> tuple[SteadyRun, ...]:
    """The runs of segments of 1 s each, given as (speed at the start, at the end)."""
    segments = Segments("linear")
    for number, (start, end) in enumerate(speeds):
        burden = Burden(payload[number], 0.0) if payload else NOTHING
        segments.add(1.0, start, end, burden, 0.0, 1.0 if start + end >= 0 else -1.0, f"{number}")
    return steady_runs(segments.profile())


def moves(*distances: float, dwell: float = 0.0) -> tuple[SteadyRun, ...]:
    rows = [{"distance_mm": way, "speed_m_s": 1, "acceleration_m_s2": 1, "dwell_s": dwell} for way in distances]
    return steady_runs(Moves.model_validate({"moves": rows}).solve(Sheet()))


def rotation(**values: Any) -> tuple[SteadyRun, ...]:
    return steady_runs(ConstantRotation.model_validate({"speed_rpm": 600, **values}).solve(Sheet()))


@pytest.mark.parametrize(
    ("values", "starts"),
    [
        ({}, 0),  # runs on
        ({"duration_s": 100}, 0),
        ({"run_up_time_s": 2, "starts_per_hour": 60}, 1),  # no pause, but 0 rpm at both ends of the cycle
        ({"run_up_time_s": 2, "starts_per_hour": 60, "duration_s": 30}, 1),
        ({"run_up_time_s": 2, "duration_s": 30}, 1),
    ],
)
def test_a_rotation_that_comes_to_rest_starts_once_a_cycle(values: dict[str, Any], starts: int):
    (run,) = rotation(**values)
    assert run.starts == starts


@pytest.mark.parametrize("dwell", [0.0, 3.0])
def test_forward_and_back_are_two_starts_with_and_without_a_pause(dwell: float):
    forward, backward = moves(4000, -4000, dwell=dwell)
    assert (forward.starts, backward.starts) == (1, 1)


@pytest.mark.parametrize("dwell", [0.0, 3.0])
def test_each_of_three_moves_in_one_direction_is_a_start(dwell: float):
    """Each takes 1 s to 1 m/s, 3 s and 1 s: 5 s."""
    forward, backward = moves(4000, 4000, 4000, -12000, dwell=dwell)
    assert (forward.starts, backward.starts) == (3, 1)
    assert forward.duration == pytest.approx(15)


def test_runs_without_a_pause_between_them_keep_their_own_loads():
    """0-1-0 m/s with 5 kg, then 0-2-0 m/s without."""
    laden, unladen = linear((0, 1), (1, 0), (0, 2), (2, 0), payload=(5, 5, 0, 0))
    assert (laden.payload, laden.speed, laden.starts, laden.duration) == (5, 1, 1, 2)
    assert (unladen.payload, unladen.speed, unladen.starts, unladen.duration) == (0, 2, 1, 2)


def test_a_cycle_cut_inside_a_run_counts_it_once():
    """The run that the cycle begins with is the end of the one that it ends with."""
    (run,) = linear((1, 1), (1, 0), (0, 0), (0, 1))
    assert (run.starts, run.duration) == (1, 3)


def test_changing_the_speed_without_standing_is_no_start():
    (run,) = linear((1, 2), (2, 2), (2, 1))
    assert run.starts == 0


def test_a_speed_that_jumps_from_or_through_standstill_departs():
    segments = Segments("linear")
    for start, end in ((0, 0), (1, 1), (-1, -1), (-1, -1)):
        segments.add(1.0, start, end, NOTHING, 0.0, 1.0 if start >= 0 else -1.0, "x")
    assert departures(segments.profile()).tolist() == [False, True, True, False]


FAN: dict[str, Any] = {
    "mechanism": {"kind": "fan", "rated_speed_rpm": "150 rad/s", "rated_power_kw": 0.75, "rotor_inertia_kgm2": 0.01},
    "motion": {"kind": "constant_rotation", "speed_rpm": "150 rad/s", "run_up_time_s": 1, "starts_per_hour": 60},
    "drive": {
        "kind": "mains",
        "motor": {"own": {"rotor_inertia_kgm2": 0.01, "windings": [WINDING]}},
        "starting_factors": [{"state": "running", "factor": 0.7}],
    },
}


def test_a_fan_that_starts_60_times_an_hour_has_its_starting_frequency_checked():
    _, checks = calculated(FAN)
    assert checks["starting_frequency"].demanded == pytest.approx(60 / 3600)
    assert checks["starting_frequency"].permitted is not None
