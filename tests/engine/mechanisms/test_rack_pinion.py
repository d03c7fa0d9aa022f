"""Rack and pinion: the axis of the Chinese text by hand, and what must hold for every pinion."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from app.engine.environment import Environment
from app.engine.mechanisms import mechanisms
from app.engine.mechanisms.rack_pinion import RackPinion
from app.engine.motion.profile import MotionProfile
from app.engine.sheet import Verdict
from tests.engine.mechanisms import laws
from tests.engine.mechanisms.laws import FEW, loaded, written
from tests.engine.mechanisms.screw_cases import run

HELIX = math.degrees(math.acos(0.3 * math.pi))
"""One tooth of module 3 then advances 10 mm, so 25 teeth advance 250 mm per revolution"""
AXIS: dict[str, Any] = {
    "slide_mass_kg": 400, "friction_coefficient": 0.15, "module_mm": 3, "teeth": 25, "helix_angle_deg": HELIX,
    "efficiency": 1,
}  # fmt: skip
STROKE = run((1, 0.5, 0), a=2.0)


def rack(**values: Any) -> RackPinion:
    return RackPinion.model_validate(values)


def test_level_axis_on_a_helical_rack():
    # R = 250 mm / 2 pi = 39.789 mm; force 400 * (2 + 0.15 * 9.81) = 1388.6 N
    R = 0.25 / (2 * math.pi)
    found, sheet = loaded(rack(**AXIS), STROKE), written(rack(**AXIS), STROKE)
    assert sheet.value("pitch_radius") == pytest.approx(R)
    assert sheet.value("travel_per_pinion_revolution") == pytest.approx(0.25)
    assert sheet.value("tangential_force") == pytest.approx(1388.6)
    assert sheet.value("pinion_torque") == pytest.approx(1388.6 * R)
    assert found.cycle.max_speed == pytest.approx(2 * 2 * math.pi)  # 120 rpm
    assert found.cycle.torque == pytest.approx([1388.6 * R, 588.6 * R, -211.4 * R])
    assert found.cycle.inertia == pytest.approx(400 * R**2)
    assert found.opposite is None
    assert found.statics.friction == pytest.approx(588.6 * R)
    assert (found.statics.forward, found.statics.backward) == pytest.approx((588.6 * R, -588.6 * R))


def test_forces_on_the_shaft_of_the_pinion():
    sheet = written(rack(**AXIS), STROKE)
    assert sheet.value("pinion_radial_force") == pytest.approx(1388.6 * math.tan(math.radians(20)) / (0.3 * math.pi))
    assert sheet.value("pinion_axial_force") == pytest.approx(1388.6 * math.tan(math.radians(HELIX)))
    assert not written(rack(**{**AXIS, "helix_angle_deg": 0}), STROKE).has("pinion_axial_force")


@pytest.mark.parametrize(
    ("permitted", "verdict"),
    [(None, Verdict.NOT_CHECKED), (3000, Verdict.OK), (1400, Verdict.TIGHT), (1300, Verdict.FAILS)],
)
def test_the_tangential_force_is_checked_where_the_limit_is_known(permitted: float | None, verdict: Verdict):
    (check,) = written(rack(**AXIS, permitted_force_n=permitted), STROKE).checks
    assert (check.key, check.verdict, check.demanded) == ("tangential_force", verdict, pytest.approx(1388.6))


def test_what_travels_along_is_moved_lifted_and_guided():
    # straight teeth: R = 37.5 mm; 45 degrees up: m (a + g sin + mu g cos)
    steep = {**AXIS, "helix_angle_deg": 0, "inclination_deg": 45, "drive_mass_kg": 60}
    found = loaded(rack(**steep), STROKE)
    g = 9.81 * math.sqrt(0.5)
    assert found.cycle.torque[0] == pytest.approx(460 * (2 + g + 0.15 * g) * 0.0375)
    assert found.statics.holding == pytest.approx(460 * g * 0.0375)
    assert found.opposite is not None
    rack_travels = {**steep, "moving": "rack", "rack_mass_kg": 60}
    del rack_travels["drive_mass_kg"]
    np.testing.assert_allclose(loaded(rack(**rack_travels), STROKE).cycle.torque, found.cycle.torque)


def test_the_pinion_itself_is_before_the_losses():
    axis = {**AXIS, "helix_angle_deg": 0, "pinion_inertia_kgcm2": 100, "efficiency": 0.8}
    torque = loaded(rack(**axis), STROKE).cycle.torque
    own = 0.01 * 2 / 0.0375
    assert torque[0] == pytest.approx(1388.6 * 0.0375 / 0.8 + own)
    assert torque[2] == pytest.approx(-211.4 * 0.0375 * 0.8 - own)


@pytest.mark.parametrize("change", [{"teeth": 2}, {"module_mm": 0}, {"helix_angle_deg": 60}, {"efficiency": 1.2}])
def test_what_cannot_be_is_refused_at_its_field(change: dict[str, Any]):
    with pytest.raises(ValidationError) as caught:
        rack(**{**AXIS, **change})
    assert [error["loc"] for error in caught.value.errors()] == [tuple(change)]


@pytest.mark.parametrize(("moving", "field"), [("pinion", "rack_mass_kg"), ("rack", "drive_mass_kg")])
def test_what_stands_has_no_moved_mass(moving: str, field: str):
    with pytest.raises(ValidationError) as caught:
        rack(**AXIS, moving=moving, **{field: 20})
    assert [error["loc"] for error in caught.value.errors()] == [(field,)]
    assert field.removesuffix("_kg") not in {name for name, _, _ in rack(**AXIS, moving=moving).defaults_taken()}


AXES = st.fixed_dictionaries(
    {
        "slide_mass": st.floats(1, 2000), "inclination": st.floats(0.05, math.pi / 2), "module": st.floats(0.001, 0.01),
        "teeth": st.integers(15, 60), "helix_angle": st.floats(0, 0.5), "pinion_inertia": st.floats(0, 0.05),
        "drive_mass": st.floats(0, 100), "friction_coefficient": st.floats(0, 0.3),
        "friction_force": st.floats(0, 500), "efficiency": st.floats(0.3, 1),
    }
)  # fmt: skip
MOVES = st.lists(st.tuples(st.floats(0.5, 2), st.floats(0.05, 1), st.floats(-500, 2000)), min_size=1, max_size=3).map(
    lambda moves: run(*moves, *[(-s, v, force) for s, v, force in moves], m=25.0)
)
MODELS = st.sampled_from(["eta", "sew"])


def pitch_radius(axis: dict[str, Any]) -> float:
    return float(axis["teeth"] * axis["module"] / math.cos(axis["helix_angle"]) / 2)


@FEW
@given(AXES, MOVES, MODELS)
def test_power_of_force_and_torque_balance_in_every_segment(axis: dict[str, Any], motion: MotionProfile, model: str):
    found = loaded(RackPinion.si(**axis), motion, regeneration=model).cycle
    net = RackPinion.si(**axis).force(motion, 9.81) * motion.mean_speed
    back = axis["efficiency"] if model == "eta" else max(2 - 1 / axis["efficiency"], 0)
    expected = np.where(net > 0, net / axis["efficiency"], net * back)
    expected += axis["pinion_inertia"] * found.acceleration * found.mean_speed
    np.testing.assert_allclose(found.torque * found.mean_speed, expected, rtol=1e-9, atol=1e-6)
    np.testing.assert_allclose(found.mean_speed * pitch_radius(axis), motion.mean_speed)


@FEW
@given(AXES, MOVES)
def test_energy_of_a_closed_cycle_is_net_work_and_losses(axis: dict[str, Any], motion: MotionProfile):
    found = loaded(RackPinion.si(**{**axis, "efficiency": 1.0}), motion)
    path = np.abs(motion.mean_speed) * motion.duration
    expected = float((path * (RackPinion.si(**axis).friction(25.0, 9.81) + motion.process_force)).sum())
    assert laws.work(found) == pytest.approx(expected, abs=1e-9 * laws.turnover(found))


@FEW
@given(AXES, MOVES, MODELS, st.floats(0.5, 0.99))
def test_losses_never_help(axis: dict[str, Any], motion: MotionProfile, model: str, share: float):
    lossier = RackPinion.si(**{**axis, "efficiency": axis["efficiency"] * share})
    laws.losses_never_help(RackPinion.si(**axis), lossier, motion, model)


@FEW
@given(AXES, st.floats(1, 300))
def test_inertia_is_twice_the_kinetic_energy(axis: dict[str, Any], omega: float):
    mass = axis["slide_mass"] + axis["drive_mass"] + 25
    energy = mass * (omega * pitch_radius(axis)) ** 2 / 2 + axis["pinion_inertia"] * omega**2 / 2
    assert loaded(RackPinion.si(**axis), run((3, 1, 0), m=25.0)).cycle.inertia == pytest.approx(2 * energy / omega**2)


@FEW
@given(AXES, MOVES, MODELS, st.integers(2, 5))
def test_mirror_and_split(axis: dict[str, Any], motion: MotionProfile, model: str, pieces: int):
    laws.mirrored_motion_mirrors_the_torques(RackPinion.si(**{**axis, "inclination": 0.0}), motion, model)
    laws.splitting_changes_nothing(RackPinion.si(**axis), motion, pieces)


def test_arrays_equal_a_scalar_loop():
    laws.arrays_equal_a_loop(rack(**{**AXIS, "efficiency": 0.8}), run((1, 0.5, 100), (-1, 0.4, -50), a=2.0, m=10.0))


def test_its_transmission_is_that_of_the_cycle():
    found = rack(**AXIS).transmission(10.0, Environment.si())
    assert (found.size, found.constant, found.mass) == ("diameter", pytest.approx(0.25 / (2 * math.pi)), 410)
    assert found.resisting_force == pytest.approx(0.15 * 410 * 9.81)


def test_the_drawing_carries_symbols_of_fields():
    laws.drawing_shows_fields([RackPinion], RackPinion.drawing, {"m", "m_2", "m_n", "z", "beta", "J_p", "alpha", "F_e"})


def test_it_is_found_by_its_kind():
    assert mechanisms()["rack_pinion"] is RackPinion
