"""Rotary load: bodies, bearing, unbalance and stage by hand, and what must hold for every rotary load."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from app.engine.mechanisms import mechanisms
from app.engine.mechanisms.bodies import Cuboid, Cylinder, GivenInertia, HollowCylinder, PointMass
from app.engine.mechanisms.guided_axis import split
from app.engine.mechanisms.rotary_load import RotaryLoad
from app.engine.motion.profile import MotionProfile
from tests.engine.mechanisms import laws
from tests.engine.mechanisms.laws import FEW, loaded, written
from tests.engine.mechanisms.screw_cases import run

DISC: dict[str, Any] = {"bodies": [{"shape": "cylinder", "mass_kg": 50, "diameter_mm": 500}]}
TURN = 2 * math.pi


def turns(*moves: tuple[float, float, float], alpha: float = 10.0, inertia: float = 0.0) -> MotionProfile:
    """Turns (signed angle [rad], speed [rad/s], process torque [N m]), each from rest to rest."""
    return replace(run(*moves, a=alpha, m=inertia), kind="rotary")


def rotary(**values: Any) -> RotaryLoad:
    return RotaryLoad.model_validate(values)


ONE_TURN = turns((TURN, 5, 0))


@pytest.mark.parametrize(
    ("body", "inertia"),
    [
        ({"shape": "cylinder", "mass_kg": 50, "diameter_mm": 500}, 50 * 0.5**2 / 8),
        ({"shape": "cylinder", "mass_kg": 8, "diameter_mm": 200, "offset_mm": 300}, 8 * 0.2**2 / 8 + 8 * 0.3**2),
        ({"shape": "hollow_cylinder", "mass_kg": 8, "diameter_mm": 500, "inner_diameter_mm": 300}, 0.34),
        ({"shape": "cuboid", "mass_kg": 12, "width_mm": 300, "length_mm": 400, "offset_mm": 500}, 0.25 + 3),
        ({"shape": "point", "mass_kg": 3, "radius_mm": 400}, 3 * 0.16),
        ({"shape": "given", "inertia_kgm2": 1.75}, 1.75),
    ],
)
def test_inertia_of_a_body(body: dict[str, Any], inertia: float):
    axis = rotary(bodies=[body, {"shape": "given", "inertia_kgm2": 1}])
    assert written(axis, ONE_TURN).value("body_1_inertia") == pytest.approx(inertia)
    assert loaded(axis, ONE_TURN).cycle.inertia == pytest.approx(inertia + 1)


def test_disc_with_bearing_friction_and_a_stage():
    # J = 1.5625 kg m2; bearing 0.005 * 50 kg * 9.81 * 0.2 m / 2 = 0.24525 N m, seals 2 N m; stage 4, 0.9
    axis = rotary(**DISC, friction_torque_nm=2, bearing_diameter_mm=200, stage_ratio=4, stage_efficiency=0.9)
    found = loaded(axis, ONE_TURN)
    drive, brake = 15.625 + 2.24525, -15.625 + 2.24525
    assert found.cycle.torque == pytest.approx([drive / 0.9 / 4, 2.24525 / 0.9 / 4, brake * 0.9 / 4])
    assert found.cycle.inertia == pytest.approx(1.5625 / 16)
    assert found.cycle.max_speed == pytest.approx(20)
    assert found.statics.friction == pytest.approx(2.24525 / 4)
    assert written(axis, ONE_TURN).value("stage_input_torque") == pytest.approx(drive / 0.9 / 4)
    assert found.opposite is None


def test_payload_process_torque_and_external_torque():
    axis = rotary(**DISC, external_torque_nm=7)
    found = loaded(axis, turns((TURN, 5, 3), (-TURN, 5, 3), inertia=0.5))
    assert found.cycle.inertia == pytest.approx(2.0625)
    assert found.cycle.torque == pytest.approx([20.625 + 10, 10, -20.625 + 10, -20.625 + 4, 4, 20.625 + 4])
    assert (found.statics.forward, found.statics.backward, found.statics.holding) == pytest.approx((7, 7, 7))
    assert found.statics.working == pytest.approx(10)
    assert found.opposite is not None


UNBALANCED: dict[str, Any] = {**DISC, "unbalance_mass_kg": 10, "unbalance_radius_mm": 200, "axis_tilt_deg": 90}
"""Arm of 10 kg * 9.81 * 0.2 m = 19.62 N m"""


def test_the_unbalance_at_its_worst_adds_to_whatever_the_motor_gives():
    found = loaded(rotary(**UNBALANCED), ONE_TURN)
    assert found.cycle.torque == pytest.approx([15.625 + 19.62, 19.62, -15.625 - 19.62])
    assert found.statics.holding == pytest.approx(19.62)
    tilted = loaded(rotary(**{**UNBALANCED, "axis_tilt_deg": 30}), ONE_TURN)
    assert tilted.cycle.torque[1] == pytest.approx(19.62 / 2)
    upright = loaded(rotary(**{**UNBALANCED, "axis_tilt_deg": 0}), ONE_TURN)
    assert upright.cycle.torque == pytest.approx([15.625, 0, -15.625])


def test_the_unbalance_by_angle_does_no_work_over_a_turn():
    axis = rotary(**UNBALANCED, unbalance_follows="angle")
    steady = replace(turns((TURN, 5, 0)), duration=np.array([1e-9, TURN / 5, 1e-9]))
    found = loaded(axis, steady)
    assert abs(laws.work(found)) < 1e-3 * laws.turnover(found)
    assert found.cycle.torque[1:-1].max() == pytest.approx(19.62, rel=1e-3)
    assert found.cycle.torque[1:-1].min() == pytest.approx(-19.62, rel=1e-3)
    effective = math.sqrt(float((found.cycle.torque[1:-1] ** 2).mean()))
    assert effective == pytest.approx(19.62 / math.sqrt(2), rel=1e-3)


def test_the_arm_falls_from_its_start_angle():
    # from upright (90 degrees) a quarter turn forward: the weight pulls forward all the way, 19.62 N m at the end
    quarter = turns((-TURN / 4, 1, 0), (TURN / 4, 1, 0))
    found = loaded(rotary(**UNBALANCED, unbalance_follows="angle", start_angle_deg=90), quarter)
    level = np.flatnonzero(np.array(found.cycle.label) == "move 1: constant speed")
    assert (found.cycle.torque[level] > 0).all()  # turning backward it falls, the motor holds against it
    angle = math.pi / 2 - (TURN / 4 - 0.05)
    assert found.cycle.torque[level[-1]] == pytest.approx(19.62 * math.cos(angle), rel=0.02)


def test_finer_steps_of_the_angle_change_nothing():
    axis, motion = rotary(**UNBALANCED, unbalance_follows="angle"), turns((TURN, 5, 0), (-TURN, 4, 2))
    found, finer = loaded(axis, motion), loaded(axis, split(motion, np.full(6, 700)))

    def effective(case: Any) -> float:
        return math.sqrt(float((case.cycle.torque**2 * case.cycle.duration).sum()))

    assert len(finer.cycle.torque) >= 4 * len(found.cycle.torque)
    assert effective(found) == pytest.approx(effective(finer), rel=1e-3)
    assert np.abs(found.cycle.torque).max() == pytest.approx(np.abs(finer.cycle.torque).max(), rel=1e-3)


@pytest.mark.parametrize(
    ("motion", "reason"),
    [
        (turns((TURN / 3, 2, 0)), "the cycle ends at another angle than it began, so in time it meets every angle"),
        (turns((500 * TURN, 50, 0)), "the cycle has too many turns to follow the angle"),
    ],
)
def test_where_the_angle_cannot_be_followed_the_worst_is_taken_and_said(motion: MotionProfile, reason: str):
    axis = rotary(**UNBALANCED, unbalance_follows="angle")
    assert [decision.reason for decision in written(axis, motion).decisions] == [reason]
    np.testing.assert_allclose(loaded(axis, motion).cycle.torque, loaded(rotary(**UNBALANCED), motion).cycle.torque)


@pytest.mark.parametrize(
    ("change", "location"),
    [
        ({"bodies": []}, ("bodies",)),
        ({"unbalance_mass_kg": 3}, ("unbalance_radius_mm",)),
        ({"unbalance_radius_mm": 3}, ("unbalance_mass_kg",)),
        ({"stage_ratio": -1}, ("stage_ratio",)),
        ({"bodies": [{"shape": "cone"}]}, ("bodies", 0)),
        ({"bodies": [{"shape": "point", "mass_kg": 1}]}, ("bodies", 0, "point", "radius_mm")),
        (
            {"bodies": [{"shape": "hollow_cylinder", "mass_kg": 1, "diameter_mm": 9, "inner_diameter_mm": 9}]},
            ("bodies", 0, "hollow_cylinder", "inner_diameter_mm"),
        ),
    ],
)
def test_what_cannot_be_is_refused_at_its_field(change: dict[str, Any], location: tuple[Any, ...]):
    with pytest.raises(ValidationError) as caught:
        rotary(**{**DISC, **change})
    assert location in [error["loc"] for error in caught.value.errors()]


def test_only_what_counts_is_an_assumption():
    taken = {name for name, _, _ in rotary(**DISC).defaults_taken()}
    assert taken == {"friction_torque", "external_torque", "stage_ratio"}
    assert {name for name, _, _ in rotary(**DISC, bearing_diameter_mm=100).defaults_taken()} - taken == {
        "bearing_friction"
    }


# --- what must hold for every rotary load -----------------------------------------------------------------------------


AXES = st.fixed_dictionaries(
    {
        "bodies": st.lists(
            st.fixed_dictionaries(
                {"shape": st.just("cylinder"), "mass": st.floats(0.1, 100), "diameter": st.floats(0.01, 1),
                 "offset": st.floats(0, 1)}
            ), min_size=1, max_size=3,
        ),
        "friction_torque": st.floats(0, 20), "stage_ratio": st.floats(0.5, 10), "stage_efficiency": st.floats(0.3, 1),
        "stage_inertia": st.floats(0, 0.1),
    }
)  # fmt: skip
MOVES = st.lists(st.tuples(st.floats(3, 20), st.floats(0.2, 5), st.floats(-10, 30)), min_size=1, max_size=3).map(
    lambda moves: turns(*moves, *[(-s, v, torque) for s, v, torque in moves], inertia=0.3)
)
MODELS = st.sampled_from(["eta", "sew"])


@FEW
@given(AXES, MOVES, MODELS)
def test_power_balances_over_the_stage(axis: dict[str, Any], motion: MotionProfile, model: str):
    found = loaded(RotaryLoad.si(**axis), motion, regeneration=model).cycle
    inertia = sum(b["mass"] * (b["diameter"] ** 2 / 8 + b["offset"] ** 2) for b in axis["bodies"]) + 0.3
    net = inertia * motion.acceleration + axis["friction_torque"] * np.sign(motion.mean_speed)
    net = (net + motion.process_force * motion.direction) * motion.mean_speed
    back = axis["stage_efficiency"] if model == "eta" else max(2 - 1 / axis["stage_efficiency"], 0)
    expected = np.where(net > 0, net / axis["stage_efficiency"], net * back)
    expected += axis["stage_inertia"] * axis["stage_ratio"] ** 2 * motion.acceleration * motion.mean_speed
    np.testing.assert_allclose(found.torque * found.mean_speed, expected, rtol=1e-9, atol=1e-6)
    assert found.inertia == pytest.approx(inertia / axis["stage_ratio"] ** 2 + axis["stage_inertia"])


@FEW
@given(AXES, MOVES)
def test_energy_of_a_closed_cycle_is_net_work_and_losses(axis: dict[str, Any], motion: MotionProfile):
    found = loaded(RotaryLoad.si(**{**axis, "stage_efficiency": 1.0}), motion)
    path = np.abs(motion.mean_speed) * motion.duration
    expected = float((path * (axis["friction_torque"] + motion.process_force)).sum())
    assert laws.work(found) == pytest.approx(expected, abs=1e-9 * laws.turnover(found))


@FEW
@given(AXES, MOVES, MODELS, st.floats(0.5, 0.99), st.integers(2, 5))
def test_losses_mirror_and_split(axis: dict[str, Any], motion: MotionProfile, model: str, share: float, pieces: int):
    mechanism = RotaryLoad.si(**axis)
    lossier = RotaryLoad.si(**{**axis, "stage_efficiency": axis["stage_efficiency"] * share})
    laws.losses_never_help(mechanism, lossier, motion, model)
    laws.mirrored_motion_mirrors_the_torques(mechanism, motion, model)
    laws.splitting_changes_nothing(mechanism, motion, pieces)


def test_arrays_equal_a_scalar_loop():
    laws.arrays_equal_a_loop(rotary(**UNBALANCED, stage_ratio=3), turns((TURN, 5, 1), (-TURN, 4, 2), inertia=0.3))


def test_the_drawing_carries_symbols_of_fields():
    models = [RotaryLoad, Cylinder, HollowCylinder, Cuboid, PointMass, GivenInertia]
    laws.drawing_shows_fields(models, RotaryLoad.drawing, {"m", "D", "r", "delta", "m_u", "r_u", "d_L", "i_2"})


def test_it_is_found_by_its_kind():
    assert mechanisms()["rotary_load"] is RotaryLoad
