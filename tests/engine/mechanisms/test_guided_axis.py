"""Masses, weight and friction of a guided axis, whatever moves it."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.engine.environment import Environment
from app.engine.mechanisms.guided_axis import GuidedAxis, split
from app.engine.sheet import Sheet
from tests.engine.mechanisms.screw_cases import ROUND_TRIP, profile

AXES = st.fixed_dictionaries(
    {
        "slide_mass": st.floats(1, 3000),
        "inclination": st.floats(0.01, math.pi / 2),
        "counterweight_mass": st.floats(0, 3000),
        "counterbalance_force": st.floats(0, 5000),
        "external_force": st.floats(-5000, 5000),
        "friction_model": st.sampled_from(["normal_force", "share_of_weight", "per_mass", "none"]),
        "friction_force": st.floats(0, 300),
    }
)


@settings(max_examples=30, deadline=None)
@given(AXES, st.floats(0, 500))
def test_the_sheet_records_the_forces_of_the_cycle(axis: dict[str, float], payload: float):
    body, environment = GuidedAxis.si(**axis), Environment.si()
    constant, friction = body.record_forces(Sheet(), payload, environment)
    assert constant == pytest.approx(body.constant_force(payload, 9.81), abs=1e-6)
    assert friction == pytest.approx(body.friction(payload, 9.81))


@settings(max_examples=30, deadline=None)
@given(AXES)
def test_a_counterweight_adds_mass_and_takes_weight(axis: dict[str, float]):
    alone = GuidedAxis.si(**{**axis, "counterweight_mass": 0.0})
    relieved = GuidedAxis.si(**axis)
    assert relieved.moved_mass(0.0) - alone.moved_mass(0.0) == pytest.approx(axis["counterweight_mass"])
    less = alone.constant_force(0.0, 9.81) - relieved.constant_force(0.0, 9.81)
    assert less == pytest.approx(axis["counterweight_mass"] * 9.81, abs=1e-6)
    assert relieved.friction(0.0, 9.81) >= alone.friction(0.0, 9.81)


def test_friction_opposes_motion_and_is_gone_at_standstill():
    body = GuidedAxis.si(slide_mass=100.0, friction_model="none", friction_force=70.0, inclination=math.pi / 6)
    motion = profile([(1, 0.5, 0.5, 0, 1, "up"), (1, -0.5, -0.5, 0, -1, "down"), (1, 0, 0, 20, -1, "stands")])
    weight = 100 * 9.81 / 2
    # at standstill the process force acts against the direction of the move before
    assert body.force(motion, 9.81) == pytest.approx([weight + 70, weight - 70, weight - 20])


def test_friction_on_the_normal_force_by_inclination():
    # 0.2 * 100 kg * 9.81 * cos 60 degrees
    body = GuidedAxis.si(slide_mass=100.0, friction_coefficient=0.2, inclination=math.pi / 3)
    assert body.friction(0.0, 9.81) == pytest.approx(98.1)
    assert GuidedAxis.si(slide_mass=100.0, inclination=math.pi / 2).friction(0.0, 9.81) == pytest.approx(0, abs=1e-9)


def test_only_directions_that_differ_are_two():
    assert not GuidedAxis.si(slide_mass=1.0).inclined
    assert GuidedAxis.si(slide_mass=1.0, inclination=0.1).inclined
    assert GuidedAxis.si(slide_mass=1.0, external_force=10.0).inclined


@settings(max_examples=30, deadline=None)
@given(st.lists(st.integers(1, 7), min_size=len(ROUND_TRIP.duration), max_size=len(ROUND_TRIP.duration)))
def test_pieces_make_the_whole_motion(parts: list[int]):
    pieces = split(ROUND_TRIP, np.array(parts))
    assert len(pieces.duration) == sum(parts)
    assert pieces.cycle_time == pytest.approx(ROUND_TRIP.cycle_time)
    assert pieces.position[np.cumsum([0, *parts])] == pytest.approx(ROUND_TRIP.position)
    assert pieces.speed_end[:-1] == pytest.approx(pieces.speed_start[1:])
    ends = np.cumsum(parts) - 1
    assert (pieces.speed_end[ends] == ROUND_TRIP.speed_end).all()


def test_ramps_are_refined_only_where_friction_grows_with_speed():
    assert GuidedAxis.si(slide_mass=1.0).refined(ROUND_TRIP) is ROUND_TRIP
    fine = GuidedAxis.si(slide_mass=1.0, viscous_coefficient=10.0).refined(ROUND_TRIP)
    step = np.abs(fine.speed_end - fine.speed_start).max()
    assert step <= ROUND_TRIP.max_speed / 256 * (1 + 1e-9)
