"""Timing belt axis: the hoist with counterweight by hand, and what must hold for every belt."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from app.engine.environment import Environment
from app.engine.mechanisms import mechanisms
from app.engine.mechanisms.timing_belt import TimingBelt
from app.engine.motion.profile import MotionProfile
from app.engine.sheet import Verdict
from tests.engine.mechanisms import laws
from tests.engine.mechanisms.laws import FEW, loaded, written
from tests.engine.mechanisms.screw_cases import profile, run

HOIST: dict[str, Any] = {
    "slide_mass_kg": 30, "counterweight_mass_kg": 25, "inclination_deg": 90, "friction_model": "share_of_weight",
    "friction_coefficient": 0.03, "pulley_diameter_mm": 100, "efficiency": 1,
}  # fmt: skip
LEVEL: dict[str, Any] = {"slide_mass_kg": 5, "pulley_diameter_mm": 60, "friction_coefficient": 0.05, "efficiency": 0.9}
LIFT = run((6, 3, 0), a=2.0, m=10.0)


def belt(**values: Any) -> TimingBelt:
    return TimingBelt.model_validate(values)


# --- worked by hand ---------------------------------------------------------------------------------------------------


def test_hoist_with_counterweight():
    # 30 + 10 kg against 25 kg on r = 50 mm, a = 2 m/s2: every body is accelerated and rubs, the weights are subtracted
    found, sheet = loaded(belt(**HOIST), LIFT), written(belt(**HOIST), LIFT)
    assert sheet.value("accelerating_force") == pytest.approx(65 * 2)
    assert sheet.value("friction_force") == pytest.approx(0.03 * 65 * 9.81)
    assert sheet.value("gravity_force") == pytest.approx(15 * 9.81)
    assert sheet.value("peripheral_force") == pytest.approx(296.2795)
    assert sheet.value("pulley_torque") == pytest.approx(14.813975)
    assert sheet.value("load_inertia_at_pulley") == pytest.approx(65 * 0.05**2)
    assert found.cycle.torque == pytest.approx([14.813975, 8.313975, 1.813975])
    assert found.cycle.max_speed == pytest.approx(60)
    # down: -130 + 147.15 - 19.1295, 128.0205, 130 + 128.0205, all times 0.05 m
    assert found.opposite is not None
    assert found.opposite.torque == pytest.approx([-0.098975, 6.401025, 12.901025])
    assert found.statics.holding == pytest.approx(15 * 9.81 * 0.05)
    assert (found.statics.forward, found.statics.backward) == pytest.approx((8.313975, 6.401025))


def test_strands_of_the_hoist():
    # the slide's strand carries 296.2795 N more than the counterweight's, which pulls 25 * (9.81 - 2) = 195.25 N
    axis = belt(**HOIST, pretension_n=100, permitted_strand_force_n=600, permitted_peripheral_force_n=250)
    checks = {check.key: check for check in written(axis, LIFT).checks}
    assert checks["strand_force"].demanded == pytest.approx(100 + 296.2795 + 195.25)
    assert checks["strand_force"].verdict is Verdict.TIGHT
    assert checks["peripheral_force"].verdict is Verdict.FAILS
    assert checks["belt_pretension"].verdict is Verdict.FAILS


def test_what_is_not_known_of_the_belt_is_not_checked():
    checks = {check.key: check for check in written(belt(**HOIST), LIFT).checks}
    assert {check.verdict for check in checks.values()} == {Verdict.NOT_CHECKED}
    assert checks["strand_force"].missing == "pretension, permitted strand force"
    hanging = written(belt(**HOIST, pretension_n=0), LIFT)
    assert "belt_pretension" not in {check.key for check in hanging.checks}


def test_the_efficiency_acts_on_the_belt_or_on_the_whole_load_side():
    # level, 5 kg on r = 30 mm, 2 m/s in 0.1 s: alpha = 666.67 rad/s2, friction 0.05 * 5 * 9.81 * 0.03 = 0.073575 N m,
    # moving mass 0.0045 kg m2 * alpha = 3 N m, each pulley 0.0003 * alpha = 0.2 N m
    axis = {**LEVEL, "drive_pulley_inertia_kgcm2": 3, "idler_inertia_kgcm2": 3}
    motion = run((1, 2, 0), a=20.0)
    driving = {"belt": (3 + 0.2 + 0.073575) / 0.9 + 0.2, "load_side": (3 + 0.2 + 0.2 + 0.073575) / 0.9}
    returning = {"belt": (-3 - 0.2 + 0.073575) * 0.9 - 0.2, "load_side": (-3 - 0.2 - 0.2 + 0.073575) * 0.9}
    for covers in ("belt", "load_side"):
        torque = loaded(belt(**axis, efficiency_covers=covers), motion).cycle.torque
        assert torque[[0, 2]] == pytest.approx([driving[covers], returning[covers]])


def test_belt_pulleys_by_teeth_mass_or_width_and_the_mass_of_the_belt():
    # 40 teeth of 5 mm: d = 200 mm / pi; belt 0.25 kg/m * 6 m = 1.5 kg
    by_teeth = {**LEVEL, "pulley_diameter_mm": None, "pulley_teeth": 40, "belt_pitch_mm": 5}
    motion, r = run((1, 2, 0), a=20.0), 0.1 / math.pi
    axis = belt(**by_teeth, belt_mass_per_length_kg_m=0.25, belt_length_m=6, drive_pulley_mass_kg=2, idler_mass_kg=1)
    inertia = loaded(axis, motion).cycle.inertia
    assert inertia == pytest.approx((5 + 1.5) * r**2 + (2 + 1) * (2 * r) ** 2 / 8)
    wide = belt(**LEVEL, pulley_width_mm=30, pulley_density_kg_m3=2700)
    each = math.pi * 2700 * 0.03 * 0.06**4 / 32
    assert loaded(wide, motion).cycle.inertia == pytest.approx(5 * 0.03**2 + 2 * each)


@pytest.mark.parametrize(
    ("change", "field"),
    [
        ({"pulley_diameter_mm": None}, "pulley_diameter_mm"),
        ({"pulley_teeth": 20, "belt_pitch_mm": 5}, "pulley_diameter_mm"),
        ({"pulley_teeth": 20}, "belt_pitch_mm"),
        ({"drive_pulley_mass_kg": 1, "drive_pulley_inertia_kgcm2": 1}, "drive_pulley_mass_kg"),
        ({"pulley_width_mm": 10, "idler_mass_kg": 1}, "pulley_width_mm"),
        ({"counterweight_mass_kg": 3}, "counterweight_mass_kg"),
        ({"pulley_diameter_mm": 0}, "pulley_diameter_mm"),
        ({"slide_mass_kg": -5}, "slide_mass_kg"),
    ],
)
def test_what_does_not_fit_is_refused_at_its_field(change: dict[str, Any], field: str):
    with pytest.raises(ValidationError) as caught:
        belt(**{**LEVEL, **change})
    assert [error["loc"] for error in caught.value.errors()] == [(field,)]


def test_pulleys_left_out_are_an_assumption():
    keys = {assumption.key for assumption in written(belt(**LEVEL), LIFT).assumptions}
    assert {"mechanism.drive_pulley_inertia_kgcm2", "mechanism.idler_inertia_kgcm2"} <= keys


# --- what must hold for every belt ------------------------------------------------------------------------------------


AXES = st.fixed_dictionaries(
    {
        "slide_mass": st.floats(1, 500), "inclination": st.floats(0.05, math.pi / 2),
        "counterweight_mass": st.floats(0, 300), "pulley_diameter": st.floats(0.02, 0.5),
        "friction_model": st.sampled_from(["normal_force", "share_of_weight"]),
        "friction_coefficient": st.floats(0, 0.3), "friction_force": st.floats(0, 200),
        "external_force": st.floats(-500, 500), "efficiency": st.floats(0.3, 1),
        "efficiency_covers": st.sampled_from(["belt", "load_side"]), "drive_pulley_inertia": st.floats(0, 0.05),
        "idler_inertia": st.floats(0, 0.05), "belt_mass_per_length": st.floats(0, 2), "belt_length": st.floats(0, 10),
    }
)  # fmt: skip
MOVES = st.lists(st.tuples(st.floats(0.5, 2), st.floats(0.05, 1), st.floats(-500, 1000)), min_size=1, max_size=3).map(
    lambda moves: run(*moves, *[(-s, v, force) for s, v, force in moves], m=10.0)
)
MODELS = st.sampled_from(["eta", "sew"])


@FEW
@given(st.floats(1, 200), st.floats(0, 100), st.floats(5, 200), st.floats(0.01, 0.2), st.floats(0.5, 5))
def test_a_counterweight_is_accelerated_and_rubs_and_its_weight_helps(
    slide: float, payload: float, counterweight: float, mu: float, a: float
):
    axis = TimingBelt.si(
        slide_mass=slide, counterweight_mass=counterweight, inclination=math.pi / 2, pulley_diameter=0.1,
        friction_model="share_of_weight", friction_coefficient=mu, efficiency=1.0,
    )  # fmt: skip
    found = loaded(axis, run((3, 1, 0), a=a, m=payload))
    assert found.opposite is not None
    faster, up, _ = found.cycle.torque / 0.05
    down = found.opposite.torque[1] / 0.05
    together = slide + payload + counterweight
    assert faster - up == pytest.approx(together * a)  # fails when the counterweight is taken off the moved mass
    assert (up - down) / 2 == pytest.approx(mu * together * 9.81)  # fails when friction is taken on the difference
    assert (up + down) / 2 == pytest.approx((slide + payload - counterweight) * 9.81)  # fails when weight is forgotten
    assert found.cycle.inertia == pytest.approx(together * 0.05**2)


@FEW
@given(AXES, MOVES, MODELS)
def test_power_of_force_and_torque_balance_in_every_segment(axis: dict[str, Any], motion: MotionProfile, model: str):
    found = loaded(TimingBelt.si(**axis), motion, regeneration=model).cycle
    whole = axis["efficiency_covers"] == "load_side"
    front = 0.0 if whole else axis["drive_pulley_inertia"]
    rear = axis["idler_inertia"] + (axis["drive_pulley_inertia"] if whole else 0.0)
    belt_mass = axis["belt_mass_per_length"] * axis["belt_length"]
    force = TimingBelt.si(**axis).force(motion, 9.81) + belt_mass * motion.acceleration
    omega, eta = found.mean_speed, axis["efficiency"]
    net = force * motion.mean_speed + rear * found.acceleration * omega
    back = eta if model == "eta" else max(2 - 1 / eta, 0)
    expected = np.where(net > 0, net / eta, net * back) + front * found.acceleration * omega
    np.testing.assert_allclose(found.torque * omega, expected, rtol=1e-9, atol=1e-6)


@FEW
@given(AXES, MOVES)
def test_energy_of_a_closed_cycle_is_net_work_and_losses(axis: dict[str, Any], motion: MotionProfile):
    # back at the start: weight, external force and kinetic energy leave nothing; friction and process force remain
    found = loaded(TimingBelt.si(**{**axis, "efficiency": 1.0}), motion)
    path = np.abs(motion.mean_speed) * motion.duration
    friction = TimingBelt.si(**axis).friction(10.0, 9.81)
    expected = float((path * (friction + motion.process_force)).sum())
    assert laws.work(found) == pytest.approx(expected, abs=1e-9 * laws.turnover(found))


@FEW
@given(AXES, MOVES, MODELS, st.floats(0.5, 0.99))
def test_losses_never_help(axis: dict[str, Any], motion: MotionProfile, model: str, share: float):
    lossier = {**axis, "efficiency": axis["efficiency"] * share}
    laws.losses_never_help(TimingBelt.si(**axis), TimingBelt.si(**lossier), motion, model)


@FEW
@given(AXES, st.floats(1, 300))
def test_inertia_is_twice_the_kinetic_energy(axis: dict[str, Any], omega: float):
    v = omega * axis["pulley_diameter"] / 2
    mass = axis["slide_mass"] + 10 + axis["counterweight_mass"] + axis["belt_mass_per_length"] * axis["belt_length"]
    energy = mass * v**2 / 2 + (axis["drive_pulley_inertia"] + axis["idler_inertia"]) * omega**2 / 2
    found = loaded(TimingBelt.si(**axis), run((3, 1, 0), m=10.0))
    assert found.cycle.inertia == pytest.approx(2 * energy / omega**2)


@FEW
@given(AXES, MOVES, MODELS)
def test_mirrored_motion_mirrors_the_torques_of_a_horizontal_axis(axis: dict[str, Any], motion: Any, model: str):
    level = TimingBelt.si(**{**axis, "inclination": 0.0, "counterweight_mass": 0.0, "external_force": 0.0})
    assert loaded(level, motion).opposite is None
    laws.mirrored_motion_mirrors_the_torques(level, motion, model)


@FEW
@given(AXES, MOVES, st.integers(2, 5))
def test_splitting_a_segment_changes_nothing(axis: dict[str, Any], motion: MotionProfile, pieces: int):
    laws.splitting_changes_nothing(TimingBelt.si(**axis), motion, pieces)


@FEW
@given(AXES, MOVES)
def test_the_sheet_shows_what_the_arrays_hold(axis: dict[str, Any], motion: MotionProfile):
    mechanism = TimingBelt.si(**axis)
    sheet, torque = written(mechanism, motion), loaded(mechanism, motion).cycle.torque
    assert abs(sheet.value("pulley_torque")) == pytest.approx(np.abs(torque).max())
    for k in range(len(torque)):
        if sheet.has(f"phase_{k + 1}_pulley_torque"):
            assert sheet.value(f"phase_{k + 1}_pulley_torque") == pytest.approx(torque[k])


def test_arrays_equal_a_scalar_loop():
    laws.arrays_equal_a_loop(belt(**{**HOIST, "efficiency": 0.8}), run((6, 3, 100), (-6, 2, -50), a=2.0, m=10.0))


def test_a_held_axis_needs_the_holding_torque_and_a_braked_one_nothing():
    motion = profile([(1, 0, 0, 0, 1, "motor holds"), (1, 0, 0, 0, 1, "brake holds")], 10.0)
    motion.braked[1] = True
    found = loaded(belt(**{**HOIST, "efficiency": 0.5}), motion)
    assert found.cycle.torque == pytest.approx([15 * 9.81 * 0.05, 0])


def test_an_empty_slide_may_ask_for_more_than_a_laden_one():
    # 10 kg against 25 kg: laden with 20 kg the slide outweighs by 5 kg, empty the counterweight by 15 kg, r = 50 mm
    axis = belt(**{**HOIST, "slide_mass_kg": 10, "friction_coefficient": 0})
    motion = run((6, 3, 0), (-6, 3, 0), a=2.0)
    motion.payload[:3] = 20
    found, sheet = loaded(axis, motion), written(axis, motion)
    empty = -15 * 9.81 * 0.05
    assert found.cycle.torque[[1, 4]] == pytest.approx([5 * 9.81 * 0.05, empty])
    assert (found.statics.forward, found.statics.backward, found.statics.holding) == pytest.approx((empty,) * 3)
    assert sheet.value("holding_torque") == pytest.approx(empty)


def test_its_transmission_is_that_of_the_cycle():
    axis = belt(**HOIST, drive_pulley_inertia_kgcm2=3)
    found = axis.transmission(10.0, Environment.si())
    assert (found.constant, found.mass, found.front_inertia) == pytest.approx((0.05, 65, 3e-4))
    assert found.resisting_force == pytest.approx(15 * 9.81 + 0.03 * 65 * 9.81)


def test_the_drawing_carries_symbols_of_fields():
    laws.drawing_shows_fields([TimingBelt], TimingBelt.drawing, {"m", "m_c", "alpha", "d", "J_t", "J_u", "F_V", "F_e"})


def test_it_is_found_by_its_kind():
    assert mechanisms()["timing_belt"] is TimingBelt
