"""Best lead, diameter and ratio for acceleration: the formulas of Jakab, each optimum confirmed by brute force."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from app.engine.environment import Environment
from app.engine.mechanisms.ball_screw import BallScrew
from app.engine.mechanisms.base import Mechanism
from app.engine.mechanisms.rack_pinion import RackPinion
from app.engine.mechanisms.rotary_load import RotaryLoad
from app.engine.mechanisms.timing_belt import TimingBelt
from app.engine.motion.profile import MotionProfile
from app.engine.optimum import OptimumInput, OptimumResult, optimum
from app.engine.sheet import Sheet
from tests.engine.mechanisms.laws import FEW
from tests.engine.mechanisms.screw_cases import run

MOTION = run((1, 0.5, 0))
SCREW: dict[str, Any] = {
    "slide_mass_kg": 300, "friction_model": "none", "nominal_diameter_mm": 50, "lead_mm": 20, "screw_inertia_kgcm2": 30,
    "coupling_inertia_kgcm2": 4, "efficiency": 1,
}  # fmt: skip
BELT: dict[str, Any] = {
    "slide_mass_kg": 5, "friction_coefficient": 0.05, "pulley_diameter_mm": 60, "drive_pulley_inertia_kgcm2": 3,
    "idler_inertia_kgcm2": 3, "efficiency": 0.9, "efficiency_covers": "load_side",
}  # fmt: skip


def found(
    mechanism: Mechanism, motion: MotionProfile = MOTION, *, J: float, i: float = 1.0, **options: Any
) -> tuple[OptimumResult | None, Sheet]:
    """Optimum of a mechanism on a motor with inertia ``J`` and ratio ``i``."""
    sheet, environment = Sheet(), Environment.si()
    more = {name: options.pop(name) for name in ("gear_efficiency", "peak_torque") if name in options}
    load = mechanism.load(motion, environment, Sheet())
    given_options = OptimumInput.si(**options)
    result = optimum(mechanism, load, motion, environment, given_options, sheet, drive_inertia=J, ratio=i, **more)
    return result, sheet


def best(mechanism: Mechanism, motion: MotionProfile = MOTION, **options: Any) -> OptimumResult:
    result, _ = found(mechanism, motion, **options)
    assert result is not None
    return result


def where_largest(function: Callable[[np.ndarray], np.ndarray], about: float) -> tuple[float, float]:
    """Brute force: the place and value of the maximum on ever finer grids around a wide range about a value."""
    low, high = about / 50, about * 50
    for _ in range(12):
        grid = np.geomspace(low, high, 400)
        values = function(grid)
        k = int(values.argmax())
        low, high = grid[max(k - 2, 0)], grid[min(k + 2, len(grid) - 1)]
    return float(grid[k]), float(values[k])


# --- the cases worked out for the formulas of Jakab -------------------------------------------------------------------


def test_screw_direct():
    result, sheet = found(BallScrew.model_validate(SCREW), J=0.006, accelerating_torque=20.0)
    assert result is not None
    A = 0.02 / (2 * math.pi)
    assert sheet.value("slide_inertia") == pytest.approx(300 * A**2)  # (3.3)
    assert sheet.value("motor_side_inertia") == pytest.approx(0.006 + 0.0004 + 0.003 + 300 * A**2)  # (3.1)
    assert result.acceleration == pytest.approx(5.117672233)
    assert result.size == pytest.approx(2 * math.pi * math.sqrt(0.0094 / 300))  # (3.7)
    assert result.acceleration_at_size == pytest.approx(20 / (2 * math.sqrt(300 * 0.0094)))
    assert (result.size_name, result.match) == ("lead", pytest.approx(1))


def test_screw_with_gear_stage():
    # the driven wheel of 0.002 kg m2 sits on the screw in place of the coupling; k = 1 / 2
    screw = BallScrew.model_validate({**SCREW, "coupling_inertia_kgcm2": 20})
    result, sheet = found(screw, J=0.0065, i=2.0, accelerating_torque=20.0)
    assert result is not None
    assert sheet.value("motor_side_inertia") == pytest.approx(0.008509908877)  # (3.2)
    assert result.acceleration == pytest.approx(3.740461746)
    assert result.size == pytest.approx(0.06387046646)  # (3.5)
    assert sheet.value("optimum_reduction") == pytest.approx(0.8991631466)  # (3.6)
    assert result.ratio == pytest.approx(1 / 0.8991631466)
    assert result.acceleration_at_ratio == pytest.approx(4.403269521)
    assert result.bound == pytest.approx(20 / (2 * math.sqrt(300 * 0.0065)))
    assert result.joint is None


def test_screw_against_a_force():
    screw = BallScrew.model_validate({**SCREW, "external_force_n": 800})
    result = best(screw, J=0.006, accelerating_torque=20.0, resistances="subtracted")
    assert result.size == pytest.approx(0.02816678457)
    assert result.acceleration_at_size == pytest.approx(4.769024464)
    assert result.match is not None
    assert result.match < 1


def test_belt_direct_with_gear_and_with_solid_pulleys():
    motion = run((1, 2, 0), a=20.0)
    direct, sheet = found(TimingBelt.model_validate(BELT), motion, J=0.0012, accelerating_torque=6.0)
    assert direct is not None
    assert sheet.value("motor_side_inertia") == pytest.approx(0.0063)  # (3.8)
    assert direct.acceleration == pytest.approx(0.03 * 6 / 0.0063)  # (3.9)
    assert direct.size == pytest.approx(2 * math.sqrt(0.0018 / 5))  # (3.10)
    assert sheet.value("accelerating_torque_needed") == pytest.approx(4.2)  # (4.4)
    geared = TimingBelt.model_validate({**BELT, "drive_pulley_inertia_kgcm2": 8})
    result = best(geared, motion, J=0.00125, i=2.0, accelerating_torque=6.0)
    assert result.acceleration == pytest.approx(33.96226415)  # (3.11)
    assert result.size == pytest.approx(0.06985699679)  # (3.12)
    assert result.ratio == pytest.approx(1 / 0.4724555913)  # (3.13)
    assert result.bound == pytest.approx(37.94733192)
    plain = {name: value for name, value in BELT.items() if "inertia" not in name}
    solid = TimingBelt.model_validate({**plain, "pulley_width_mm": 30, "pulley_density_kg_m3": 2700})
    result = best(solid, motion, J=0.0012, accelerating_torque=6.0)
    assert result.size == pytest.approx(0.03044972824)
    assert result.acceleration_at_size == pytest.approx(38.5008298)


# --- brute force ------------------------------------------------------------------------------------------------------


CASES = st.fixed_dictionaries(
    {
        "slide_mass": st.floats(1, 500), "payload": st.floats(0, 100), "J": st.floats(1e-4, 0.02),
        "i": st.floats(0.5, 20), "M": st.floats(5, 100), "force": st.floats(0, 200), "J_s": st.floats(1e-5, 0.02),
        "eta": st.floats(0.5, 1), "eta_G": st.floats(0.5, 1),
    }
)  # fmt: skip


@FEW
@given(CASES, st.sampled_from(["left_out", "subtracted"]))
def test_brute_force_finds_the_same_lead_and_ratio(case: dict[str, float], resistances: str):
    # the full model: what the motor gives, less what accelerates rotor, screw and slide and opposes it, losses included
    lossy = resistances == "subtracted"
    eta, eta_G = (case["eta"], case["eta_G"]) if lossy else (1.0, 1.0)
    force = case["force"] if lossy else 0.0
    m = case["slide_mass"] + case["payload"]

    def acceleration(A: Any, i: Any) -> Any:
        # M = J i a/A + (J_s a/A + (m a + F) A / eta) / (i eta_G), solved for a
        per_a = case["J"] * i / A + (case["J_s"] / A + m * A / eta) / (i * eta_G)
        return (case["M"] - force * A / (eta * eta_G * i)) / per_a

    screw = BallScrew.si(
        slide_mass=case["slide_mass"], friction_model="none", nominal_diameter=0.05, lead=0.02, efficiency=case["eta"],
        screw_inertia=case["J_s"], external_force=case["force"],
    )  # fmt: skip
    result = best(
        screw, run((1, 0.5, 0), m=case["payload"]), J=case["J"], i=case["i"], accelerating_torque=case["M"],
        resistances=resistances, gear_efficiency=case["eta_G"],
    )  # fmt: skip
    A = 0.02 / (2 * math.pi)
    assert result.acceleration == pytest.approx(float(acceleration(A, case["i"])))
    size, peak = where_largest(lambda A: acceleration(A, case["i"]), result.size / (2 * math.pi))
    assert (result.size, result.acceleration_at_size) == (
        pytest.approx(2 * math.pi * size, rel=1e-5), pytest.approx(peak, rel=1e-9),
    )  # fmt: skip
    ratio, peak = where_largest(lambda i: acceleration(A, i), result.ratio)
    assert (result.ratio, result.acceleration_at_ratio) == (
        pytest.approx(ratio, rel=1e-5), pytest.approx(peak, rel=1e-9),
    )  # fmt: skip
    steps = np.geomspace(0.2, 1e4, 300)
    anywhere = acceleration(np.geomspace(1e-5, 1e3, 300)[:, None], steps[None, :])
    assert anywhere.max() < result.bound
    assert anywhere.max() == pytest.approx(result.bound, rel=0.02)


@FEW
@given(CASES, st.floats(0.01, 0.1), st.sampled_from(["left_out", "subtracted"]))
def test_brute_force_finds_the_same_diameter_of_solid_pulleys(case: dict[str, float], width: float, resistances: str):
    force = case["force"] if resistances == "subtracted" else 0.0
    belt = TimingBelt.si(
        slide_mass=case["slide_mass"], friction_model="none", pulley_diameter=0.06, pulley_width=width, efficiency=1.0,
        external_force=case["force"],
    )  # fmt: skip
    result = best(belt, J=case["J"], i=case["i"], accelerating_torque=case["M"], resistances=resistances)

    def acceleration(d: Any) -> Any:
        pulleys = 2 * math.pi * 2700 * width * d**4 / 32
        inertia = case["J"] * case["i"] ** 2 + pulleys + case["slide_mass"] * d**2 / 4
        return d / 2 * (case["M"] * case["i"] - force * d / 2) / inertia

    size, peak = where_largest(acceleration, result.size)
    assert result.size == pytest.approx(size, rel=1e-5)
    assert result.acceleration_at_size == pytest.approx(peak, rel=1e-9)


@FEW
@given(CASES, st.floats(0.005, 0.05), st.floats(1.05, 20), st.floats(0.5, 3), st.floats(1.1, 20))
def test_brute_force_finds_the_same_pair_inside_bounds(
    case: dict[str, float], low: float, size_range: float, i_low: float, ratio_range: float
):
    rack = RackPinion.si(
        slide_mass=case["slide_mass"], friction_model="none", module=0.002, teeth=20, pinion_inertia=case["J_s"],
        efficiency=1.0, external_force=case["force"],
    )  # fmt: skip
    result = best(
        rack, J=case["J"], accelerating_torque=case["M"], resistances="subtracted", size_min=low,
        size_max=low * size_range, ratio_min=i_low, ratio_max=i_low * ratio_range,
    )  # fmt: skip
    A = np.linspace(low, low * size_range, 400)[:, None] / 2
    i = np.linspace(i_low, i_low * ratio_range, 400)[None, :]
    inertia = case["J"] + (case["J_s"] + case["slide_mass"] * A**2) / i**2
    grid = A / i * (case["M"] - case["force"] * A / i) / inertia
    assert result.joint is not None
    assert result.joint.acceleration >= grid.max() - 1e-9 * abs(grid.max())
    assert result.joint.acceleration == pytest.approx(grid.max(), rel=1e-2)
    assert result.joint.bounds
    assert low <= result.joint.size <= low * size_range * (1 + 1e-12)
    assert i_low <= result.joint.ratio <= i_low * ratio_range * (1 + 1e-12)


@FEW
@given(CASES)
def test_at_the_optimum_the_moved_mass_weighs_as_much_as_everything_else(case: dict[str, float]):
    screw = BallScrew.si(
        slide_mass=case["slide_mass"], friction_model="none", nominal_diameter=0.05, lead=0.02, efficiency=1.0,
        screw_inertia=case["J_s"],
    )  # fmt: skip
    result = best(screw, J=case["J"], i=case["i"], accelerating_torque=case["M"])
    assert result.match == pytest.approx(1)
    mass_at_motor = case["slide_mass"] * (result.size / (2 * math.pi)) ** 2 / case["i"] ** 2
    assert mass_at_motor == pytest.approx(case["J"] + case["J_s"] / case["i"] ** 2)
    load_at_motor = (case["J_s"] + case["slide_mass"] * (0.02 / (2 * math.pi)) ** 2) / result.ratio**2
    assert load_at_motor == pytest.approx(case["J"])


# --- other mechanisms and what is missing -----------------------------------------------------------------------------


def test_a_rotary_load_has_a_best_ratio():
    # J = 0.9 kg m2 on a rotor of 0.001 kg m2: sqrt(900) = 30; against 40 N m of friction a larger ratio
    disc = RotaryLoad.model_validate({"bodies": [{"shape": "given", "inertia_kgm2": 0.9}], "friction_torque_nm": 40})
    free = best(disc, J=0.001, accelerating_torque=5.0)
    assert (free.ratio, free.size, free.joint) == (pytest.approx(30), None, None)
    held = best(disc, J=0.001, accelerating_torque=5.0, resistances="subtracted")
    ratio, _ = where_largest(lambda i: (5 - 40 / i) / (0.001 * i + 0.9 / i), held.ratio)
    assert held.ratio == pytest.approx(ratio, rel=1e-5)


def test_the_peak_torque_of_the_motor_stands_in_for_a_missing_torque():
    screw = BallScrew.model_validate(SCREW)
    given_torque = best(screw, J=0.006, accelerating_torque=20.0)
    assert best(screw, J=0.006, peak_torque=20.0) == given_torque
    assert best(screw, J=0.006, peak_torque=99.0, accelerating_torque=20.0) == given_torque


@pytest.mark.parametrize(
    ("J", "options", "reason"),
    [
        (0.006, {}, "no torque is given, and no motor with a known peak torque is chosen"),
        (0.0, {"accelerating_torque": 20.0}, "the inertia of the motor is not known"),
    ],
)
def test_without_torque_or_motor_there_is_no_optimum_and_the_reason_is_said(J: float, options: Any, reason: str):
    result, sheet = found(BallScrew.model_validate(SCREW), J=J, **options)
    assert result is None
    assert [decision.reason for decision in sheet.decisions] == [reason]


def test_an_axis_that_does_not_start_is_said_and_still_has_an_optimum():
    heavy = BallScrew.model_validate({**SCREW, "inclination_deg": 90})
    result, sheet = found(heavy, J=0.006, accelerating_torque=5.0, resistances="subtracted")
    assert result is not None
    assert result.acceleration is not None
    assert result.acceleration < 0 < result.acceleration_at_size  # type: ignore[operator]
    assert "As it stands the axis does not accelerate" in [decision.text for decision in sheet.decisions]


@pytest.mark.parametrize(
    ("values", "field"),
    [
        ({"size_min_mm": 20, "size_max_mm": 10}, "size_max_mm"),
        ({"ratio_max": 0.5}, "ratio_max"),
        ({"accelerating_torque_nm": 0}, "accelerating_torque_nm"),
    ],
)
def test_bounds_out_of_order_are_refused_at_their_field(values: dict[str, float], field: str):
    with pytest.raises(ValidationError) as caught:
        OptimumInput.model_validate(values)
    assert [error["loc"] for error in caught.value.errors()] == [(field,)]
