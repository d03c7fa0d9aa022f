"""Slider-crank: the exact kinematics against geometry, and the pallet pusher of the handbook."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic import ValidationError

from app.engine.errors import EngineError
from app.engine.formulas import crank as formulas
from app.engine.mechanisms.crank import Crank
from app.engine.motion.constant import ConstantRotation
from app.engine.motion.profile import MotionProfile
from app.engine.sheet import Sheet
from tests.engine.mechanisms.laws import drawing_shows_fields, loaded, written

PUSHER = {
    "crank_radius_mm": 500, "rod_length_mm": 2000, "load_mass_kg": 500, "wheel_diameter_mm": 250,
    "journal_diameter_mm": 60, "rolling_arm_mm": 1.2, "bearing_friction": 0.005, "rim_friction": 0.003,
    "efficiency": 0.9,
}  # fmt: skip
"""Pallet pusher of SEW 2001, 14."""


def pusher(**other: Any) -> Crank:
    return Crank.model_validate(PUSHER | other)


def turning(rpm: float = 42.0) -> MotionProfile:
    return ConstantRotation.model_validate({"speed_rpm": rpm}).solve(Sheet())


@settings(max_examples=50, deadline=None)
@given(phi=st.floats(-10, 10), share=st.floats(0.05, 0.8), omega=st.floats(-5, 5), alpha=st.floats(-5, 5))
def test_speed_and_acceleration_are_the_derivatives_of_the_way(phi: float, share: float, omega: float, alpha: float):
    r, l, h = share, 1.0, 1e-4
    way = [formulas.crank_way(phi + omega * t + alpha * t**2 / 2, r, l) for t in (-h, 0.0, h)]
    A = formulas.crank_transmission(phi, r, l)
    assert A * omega == pytest.approx((way[2] - way[0]) / (2 * h), abs=1e-5)
    a = formulas.crank_slide_acceleration(phi, omega, alpha, A, r, l)
    assert a == pytest.approx((way[2] - 2 * way[1] + way[0]) / h**2, rel=1e-3, abs=1e-3)


def test_the_slide_is_where_the_rod_puts_it():
    """Pythagoras: the crank pin at (r cos, r sin), the slide on the axis at the distance l from it."""
    for degrees in (0, 37, 90, 143, 180, 250):
        phi = math.radians(degrees)
        x = 2.5 - formulas.crank_way(phi, 0.5, 2.0)
        assert math.hypot(x - 0.5 * math.cos(phi), 0.5 * math.sin(phi)) == pytest.approx(2.0)


def test_the_approximation_tends_to_the_exact_speed_with_a_long_rod():
    angles = np.linspace(0, 2 * np.pi, 50)
    exact = formulas.crank_transmission(angles, 0.1, 10.0)
    np.testing.assert_allclose(formulas.crank_speed_approximate(1.0, angles, 0.1, 0.01), exact, atol=1e-7)


def test_the_pallet_pusher_of_the_handbook():
    """SEW 2001, 14, with exact kinematics: 7.97 kW at 36.85 degrees, returning at 323.53 degrees."""
    sheet, omega = written(pusher(efficiency=0.9 * 0.95), turning()), 42 * math.pi / 30
    assert sheet.value("resistance_loaded") == pytest.approx(67.689)
    assert sheet.value("largest_slide_speed") == pytest.approx(2.267029459)
    assert sheet.value("driving_torque") * omega == pytest.approx(7972.715024, rel=1e-6)
    assert sheet.value("returning_torque") * omega == pytest.approx(-5645.44682, rel=1e-6)
    angle = {step.key: step.inputs for step in sheet.steps}["driving_transmission"]["phi"]
    assert math.degrees(angle) == pytest.approx(36.85333985, abs=1e-3)


def test_effective_torque_over_a_turn():
    cycle = loaded(pusher(), turning()).cycle
    assert math.sqrt(float((cycle.torque**2 * cycle.duration).sum()) / cycle.cycle_time) == pytest.approx(
        937.715, rel=1e-5
    )
    # loaded on the way in only, the rest costs nothing
    cycle = loaded(pusher(loaded="inward", slide_mass_kg=1e-6), turning()).cycle
    assert math.sqrt(float((cycle.torque**2 * cycle.duration).sum()) / cycle.cycle_time) == pytest.approx(
        672.906, rel=1e-5
    )


def test_inertia_gives_no_work_over_a_turn():
    """Without losses the mean torque is the friction work of two strokes over a turn: 4 r F / 2 pi = 21.5455 N m."""
    cycle = loaded(pusher(efficiency=1), turning()).cycle
    assert float((cycle.torque * cycle.duration).sum()) / cycle.cycle_time == pytest.approx(21.54553094, rel=1e-4)


def test_a_slide_that_climbs_needs_its_weight_at_the_right_angle():
    """Crawling, without friction: m g A(phi), largest where the travel per radian is."""
    lifting = pusher(inclination_deg=90, friction_coefficient=0, wheel_diameter_mm=None, efficiency=1)
    cycle = loaded(lifting, turning(1e-3)).cycle
    assert cycle.torque.max() == pytest.approx(500 * 9.81 * 0.5154413, rel=1e-4)
    assert cycle.torque.min() == pytest.approx(-500 * 9.81 * 0.5154413, rel=1e-4)


def test_whole_turns_of_a_long_run_are_weighted():
    motion = ConstantRotation.model_validate(
        {"speed_rpm": 60, "run_up_time_s": 1, "starts_per_hour": 12}
    ).solve(Sheet())  # fmt: skip
    cycle = loaded(pusher(), motion).cycle
    assert len(cycle.duration) < 5000
    assert cycle.cycle_time == pytest.approx(300)
    assert float((cycle.mean_speed * cycle.duration).sum()) == pytest.approx(299 * 2 * math.pi)


def exact_power(phi: float, omega: float, rod: float, goods: float, share: float, slope: float) -> float:
    """Rate of the kinetic and potential energy of the rod's two masses and the slide, by numerical differentiation."""
    r, l, g, h = 0.5, 2.0, 9.81, 1e-5

    def energy(angle: float) -> float:
        v = formulas.crank_transmission(angle, r, l) * omega
        pin = rod * (1 - share)
        # the slide climbs inward with the slideway; the pin starts outward and rises first
        height = -r * math.cos(angle) * math.sin(slope) + r * math.sin(angle) * math.cos(slope)
        climbed = formulas.crank_way(angle, r, l) * math.sin(slope)
        moved = goods + rod * share
        return moved * v**2 / 2 + pin * (r * omega) ** 2 / 2 + moved * g * climbed + pin * g * height

    return (energy(phi + h) - energy(phi - h)) / (2 * h) * omega


@pytest.mark.parametrize("slope", [0.0, 30.0, 90.0, -90.0])
def test_the_weight_of_the_rod_turns_the_crank(slope: float):
    heavy = pusher(load_mass_kg=25, rod_mass_kg=100, efficiency=1, friction_coefficient=0, wheel_diameter_mm=None,
                   inclination_deg=slope)  # fmt: skip
    cycle = loaded(heavy, turning(10)).cycle
    angles = (np.cumsum(cycle.duration) - cycle.duration / 2) * (math.pi / 3)
    omega, tilt = math.pi / 3, math.radians(slope)
    expected = [exact_power(float(phi), omega, 100, 25, 0.5, tilt) / omega for phi in angles]
    np.testing.assert_allclose(cycle.torque, expected, atol=1e-3 * np.abs(cycle.torque).max())


def test_a_counterweight_relieves_the_crank():
    """Half of 100 kg at 0.5 m: 25 kg m, 245.25 N m to hold; a counterweight takes it away."""
    level = {"load_mass_kg": 1, "rod_mass_kg": 100, "friction_coefficient": 0, "wheel_diameter_mm": None}
    assert loaded(pusher(**level), turning()).statics.holding == pytest.approx(245.25)
    assert loaded(pusher(**level, unbalance_kgm=-25), turning()).statics.holding == pytest.approx(0, abs=1e-9)


def test_the_steady_torque_behind_a_stage_with_losses_covers_the_driving_half_of_the_turn():
    """Here the crank is driven harder than it drives; through a stage of 50 % driving still asks for more."""
    helped = pusher(load_mass_kg=1, process_force_n=-10, unbalance_kgm=0.5, stage_efficiency=0.5)
    found = loaded(helped, turning(10))
    assert np.abs(found.cycle.torque).max() <= found.statics.forward


def test_more_turns_in_the_ramps_than_can_be_followed_are_refused():
    motion = ConstantRotation.model_validate({"speed_rpm": 3000, "run_up_time_s": 100, "starts_per_hour": 1})
    with pytest.raises(EngineError, match="5000 turns in its ramps"):
        loaded(pusher(), motion.solve(Sheet()))


def test_a_rod_as_short_as_the_crank_is_refused():
    with pytest.raises(ValidationError, match="too short for this crank: at least 625 mm"):
        pusher(rod_length_mm=500)


def test_drawing():
    drawing_shows_fields([Crank], "crank.svg", {"r", "l", "m", "m_0", "F_p"})
