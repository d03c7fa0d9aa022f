"""Ball screw axis: worked examples by hand, and what must hold for every screw."""

import math
import re
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.engine.environment import Environment
from app.engine.mechanisms import mechanisms
from app.engine.mechanisms.ball_screw import BallScrew
from app.engine.mechanisms.guided_axis import split
from app.engine.mechanisms.load import Load
from app.engine.motion.profile import MotionProfile
from app.engine.quantity import to_si
from app.engine.sheet import Sheet
from tests.engine.mechanisms.screw_cases import LACHMAN, PLAIN, ROUND_TRIP, RPM, load, profile, run

DRAWING = Path(__file__).resolve().parents[3] / "static/drawings" / BallScrew.drawing
FEW = settings(max_examples=30, deadline=None)


# --- worked by hand ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("key", "expected", "unit"),
    [  # the inclined feed axis of Lachman and Mendricky, recomputed without rounding
        ("gravity_force", 400 * 9.81 * math.sqrt(3) / 2, "N"),
        ("friction_force", 400, "N"),
        ("screw_inertia", math.pi * 0.05**4 * 1.0 * 7850 / 32, "kg m2"),
        ("screw_friction_torque", 5, "N m"),
        ("screw_speed_rapid", 1500, "rpm"),
        ("screw_speed_working", 600, "rpm"),
        ("limit_speed", math.sqrt(5 * 0.18), "m/s"),
        ("dn_factor", 75000, "mm rpm"),
        ("ball_contact_stiffness", 3.5 * 5 * 50, "N/um"),
        ("bearing_stiffness_total", 2000, "N/um"),
        ("screw_tension_stiffness", 1649.336143, "N/um"),
        ("screw_torsion_stiffness", 8971.723576, "N/um"),
        ("total_stiffness", 423.6169875, "N/um"),
        ("natural_frequency", 163.7860162, "Hz"),
        ("damping", 82327.83126, "N s/m"),
        ("lost_motion_friction", 1.888498393, "um"),
        ("load_inertia_on_screw", 0.00886954702, "kg m2"),
        ("friction_torque_on_screw", 5 + 400 * 0.02 / (2 * math.pi), "N m"),
        ("rest_torque_upward", 17.09031247, "N m"),
        ("rest_torque_downward", 4.543833383, "N m"),
        ("max_static_working_torque", 48.92130109, "N m"),
        ("angular_acceleration", 500 * math.pi, "rad/s2"),
    ],
)
def test_inclined_feed_axis(key: str, expected: float, unit: str):
    _, sheet = load(LACHMAN, ROUND_TRIP)
    assert sheet.value(key) == pytest.approx(to_si(expected, unit), rel=1e-6)


def test_statics_of_the_inclined_feed_axis():
    found = load(LACHMAN, ROUND_TRIP)[0].statics
    A = 0.02 / (2 * math.pi)
    weight = 400 * 9.81 * math.sin(math.radians(60))
    assert found.friction == pytest.approx(5 + 400 * A)
    assert found.forward == pytest.approx((weight + 400) * A + 5)
    assert found.backward == pytest.approx((weight - 400) * A - 5)
    assert found.holding == pytest.approx(weight * A)
    assert found.working == pytest.approx((weight + 400 + 1e4) * A + 5)
    assert (found.rapid_speed, found.working_speed) == pytest.approx((1500 * RPM, 600 * RPM))


def test_efficiency_over_the_whole_load_side_as_in_the_turkish_example():
    axis = {
        "slide_mass_kg": 200, "lead_mm": 20, "nominal_diameter_mm": 50, "screw_mass_kg": 40, "efficiency": 0.9,
        "friction_coefficient": 0.2,
    }  # fmt: skip
    motion = run((0.5, 0.5, 0), a=2.5)
    A, alpha = 0.02 / (2 * math.pi), 2.5 * 2 * math.pi / 0.02
    for covers, screw_share in (("load_side", 0.0125 * alpha / 0.9), ("nut", 0.0125 * alpha)):
        found, sheet = load({**axis, "efficiency_covers": covers}, motion, gravity_m_s2=9.8)
        assert sheet.value("friction_torque_on_screw") == pytest.approx(200 * 9.8 * 0.2 * A / 0.9)
        assert sheet.value("load_acceleration_torque") == pytest.approx(200 * 2.5 * A / 0.9)
        assert sheet.value("screw_acceleration_torque") == pytest.approx(screw_share)
        peak = (200 * 9.8 * 0.2 + 200 * 2.5) * A / 0.9 + screw_share
        assert found.cycle.torque.max() == pytest.approx(peak)
        assert found.cycle.inertia == pytest.approx(0.0125 + 200 * A**2)


def test_lowering_returns_power_multiplied_by_the_efficiency():
    # vertical, 400 kg, A = 3.1831 mm: ideal 400 * 9.81 * A = 12.490 N m; raising 12.490 / 0.8, lowering 12.490 * 0.8,
    # SEW: 12.490 * (2 - 1 / 0.8)
    axis = {**PLAIN, "inclination_deg": 90, "efficiency": 0.8, "screw_inertia_kgcm2": 0}
    ideal = 400 * 9.81 * 0.02 / (2 * math.pi)
    down = run((-0.5, 0.5, 0))
    assert load(axis, down)[0].cycle.torque[1] == pytest.approx(ideal * 0.8)
    assert load(axis, down, regeneration="sew")[0].cycle.torque[1] == pytest.approx(ideal * 0.75)
    assert load(axis, down)[0].opposite.cycle_time == pytest.approx(down.cycle_time)
    assert load(axis, down)[0].opposite.torque[1] == pytest.approx(ideal / 0.8)


def test_the_counterweight_relieves_the_drive_of_weight_but_not_of_inertia():
    axis = {**PLAIN, "inclination_deg": 90, "counterweight_mass_kg": 400, "screw_inertia_kgcm2": 0}
    found, _ = load(axis, run((0.5, 0.5, 0)))
    A = 0.02 / (2 * math.pi)
    assert found.statics.holding == pytest.approx(0, abs=1e-9)
    assert found.cycle.inertia == pytest.approx(800 * A**2)
    assert found.cycle.torque[0] == pytest.approx(800 * 5 * A)


def test_friction_counts_per_guided_body():
    axis = {
        **PLAIN, "inclination_deg": 90, "counterweight_mass_kg": 100, "friction_model": "share_of_weight",
        "friction_coefficient": 0.1, "friction_force_n": 50,
        "further_masses": [{"mass_kg": 20, "guided": True}, {"mass_kg": 30}],
    }  # fmt: skip
    assert load(axis, ROUND_TRIP)[1].value("friction_force") == pytest.approx(0.1 * (400 + 20 + 100) * 9.81 + 50)
    apart = {**axis, "counterweight_guided": False}
    assert load(apart, ROUND_TRIP)[1].value("friction_force") == pytest.approx(0.1 * (400 + 20) * 9.81 + 50)


def test_weight_of_a_further_mass_acts_unless_it_is_carried_elsewhere():
    bodies = [{"mass_kg": 20}, {"mass_kg": 30, "weight_acts": False}]
    found, sheet = load({**PLAIN, "inclination_deg": 30, "further_masses": bodies}, ROUND_TRIP)
    assert sheet.value("gravity_force") == pytest.approx(420 * 9.81 / 2)
    A = 0.02 / (2 * math.pi)
    assert found.cycle.inertia - sheet.value("rotating_inertia") == pytest.approx(450 * A**2)


def test_counterbalance_and_external_force_act_whatever_the_motion():
    axis = {**PLAIN, "counterbalance_force_n": 300, "external_force_n": 1000, "screw_inertia_kgcm2": 0}
    found, _ = load(axis, run((0.5, 0.5, 0), (-0.5, 0.5, 0)))
    A = 0.02 / (2 * math.pi)
    assert found.cycle.torque[[1, 4]] == pytest.approx([700 * A, 700 * A])
    assert found.opposite is not None


def test_a_held_axis_needs_the_holding_torque_and_a_braked_one_nothing():
    rows = [
        (0.1, 0, 0.5, 0, 1, "up"), (0.1, 0.5, 0, 0, 1, "up"), (1, 0, 0, 0, 1, "motor holds"), (1, 0, 0, 0, 1, "brake"),
    ]  # fmt: skip
    motion = profile(rows)
    motion.braked[3] = True
    axis = {
        **PLAIN,
        "inclination_deg": 90,
        "efficiency": 0.5,
        "friction_model": "per_mass",
        "screw_friction_torque_nm": 3,
    }
    found, _ = load(axis, motion)
    assert found.cycle.torque[2:] == pytest.approx([400 * 9.81 * 0.02 / (2 * math.pi), 0])
    assert found.cycle.braked.tolist() == [False, False, False, True]


# --- what must hold for every screw -----------------------------------------------------------------------------------


AXES = st.fixed_dictionaries(
    {
        "slide_mass": st.floats(1, 3000), "inclination": st.floats(0, math.pi / 2),
        "nominal_diameter": st.floats(0.01, 0.1), "lead": st.floats(0.002, 0.06),
        "length": st.floats(0.2, 3), "efficiency": st.floats(0.3, 1),
        "efficiency_covers": st.sampled_from(["nut", "load_side"]), "friction_coefficient": st.floats(0, 0.3),
        "friction_force": st.floats(0, 500), "screw_friction_torque": st.floats(0, 5),
    }
)  # fmt: skip
MOVES = st.lists(
    st.tuples(st.floats(0.3, 2), st.floats(0.05, 0.9), st.floats(-2000, 5000)), min_size=1, max_size=3
).map(lambda moves: run(*moves, *[(-s, v, force) for s, v, force in moves], m=40.0))
MODELS = st.sampled_from(["eta", "sew"])


def loaded(axis: dict[str, Any], motion: MotionProfile, model: str = "eta") -> Load:
    return BallScrew.si(**axis).load(motion, Environment.si(regeneration=model), Sheet())


def angles(found: Load) -> np.ndarray:
    return found.cycle.mean_speed * found.cycle.duration


@FEW
@given(AXES, MOVES, MODELS)
def test_power_of_force_and_torque_balance_in_every_segment(axis: dict[str, Any], motion: MotionProfile, model: str):
    screw, found = BallScrew.si(**axis), loaded(axis, motion, model)
    force = screw.force(motion, 9.81)
    omega, eta = found.cycle.mean_speed, axis["efficiency"]
    own = (screw.shaft_inertia * found.cycle.acceleration + axis["screw_friction_torque"] * np.sign(omega)) * omega
    nut = force * motion.mean_speed
    returning = eta if model == "eta" else max(2 - 1 / eta, 0)
    if axis["efficiency_covers"] == "nut":
        expected = np.where(nut > 0, nut / eta, nut * returning) + own
    else:
        expected = np.where(nut + own > 0, (nut + own) / eta, (nut + own) * returning)
    np.testing.assert_allclose(found.cycle.torque * omega, expected, rtol=1e-9, atol=1e-6)


@FEW
@given(AXES, MOVES)
def test_energy_of_a_closed_cycle_is_net_work_and_losses(axis: dict[str, Any], motion: MotionProfile):
    # the axis comes back: weight and kinetic energy leave nothing; friction and process force remain
    found = loaded({**axis, "efficiency": 1.0}, motion)
    work = float((found.cycle.torque * angles(found)).sum())
    path = np.abs(motion.mean_speed) * motion.duration
    friction = BallScrew.si(**axis).friction(40.0, 9.81)
    drag = axis["screw_friction_torque"] * np.abs(angles(found)).sum()
    scale = float(np.abs(found.cycle.torque * angles(found)).sum())
    assert work == pytest.approx(float((path * (friction + motion.process_force)).sum()) + drag, abs=1e-9 * scale)
    lossy = loaded(axis, motion)
    assert float((lossy.cycle.torque * angles(lossy)).sum()) >= work - 1e-9 * scale


@FEW
@given(AXES, MODELS, st.floats(0.3, 0.95), st.floats(0.01, 0.3))
def test_a_lowered_screw_returns_less_the_more_it_loses(axis: dict[str, Any], model: str, eta: float, less: float):
    axis = {**axis, "inclination": math.pi / 2, "friction_force": 0.0, "screw_friction_torque": 0.0}
    down = run((-1.5, 0.5, 0.0))
    torque = [
        loaded({**axis, "efficiency": value}, down, model).cycle.torque[1] for value in (1.0, eta, eta * (1 - less))
    ]
    ideal, some, least = torque
    assert ideal == pytest.approx(axis["slide_mass"] * 9.81 * axis["lead"] / (2 * math.pi))
    assert 0 <= least <= some < ideal
    assert some == pytest.approx(ideal * (eta if model == "eta" else max(2 - 1 / eta, 0)))


@FEW
@given(AXES, st.floats(0, 500), st.floats(0, 2000), st.floats(0.1, 300))
def test_inertia_is_twice_the_kinetic_energy(axis: dict[str, Any], coupling: float, counterweight: float, omega: float):
    axis = {
        **axis,
        "inclination": math.pi / 4,
        "coupling_inertia": coupling * 1e-4,
        "counterweight_mass": counterweight,
    }
    found = loaded(axis, run((1.5, 0.5, 0), m=25.0))
    v = omega * axis["lead"] / (2 * math.pi)
    cylinder = math.pi / 32 * axis["nominal_diameter"] ** 4 * axis["length"] * 7850
    energy = (axis["slide_mass"] + 25 + counterweight) * v**2 / 2 + (cylinder + coupling * 1e-4) * omega**2 / 2
    assert found.cycle.inertia == pytest.approx(2 * energy / omega**2)


@FEW
@given(AXES, MOVES, MODELS)
def test_mirrored_motion_mirrors_the_torques_of_a_horizontal_axis(axis: dict[str, Any], motion: Any, model: str):
    axis = {**axis, "inclination": 0.0}
    there, back = loaded(axis, motion, model), loaded(axis, motion.mirrored(), model)
    assert there.opposite is None
    np.testing.assert_allclose(back.cycle.torque, -there.cycle.torque)
    np.testing.assert_allclose(back.cycle.speed_start, -there.cycle.speed_start)


@FEW
@given(AXES, MOVES)
def test_the_opposite_cycle_is_the_mirrored_motion(axis: dict[str, Any], motion: MotionProfile):
    axis = {**axis, "inclination": 1.0}
    np.testing.assert_allclose(loaded(axis, motion).opposite.torque, loaded(axis, motion.mirrored()).cycle.torque)


@FEW
@given(AXES, MOVES, st.integers(2, 5))
def test_splitting_a_segment_changes_nothing(axis: dict[str, Any], motion: MotionProfile, pieces: int):
    parts = np.ones(len(motion.duration), dtype=int)
    parts[::2] = pieces
    whole, pieced = loaded(axis, motion), loaded(axis, split(motion, parts))
    np.testing.assert_allclose(pieced.cycle.torque, np.repeat(whole.cycle.torque, parts), rtol=1e-9, atol=1e-9)
    assert pieced.cycle.cycle_time == pytest.approx(whole.cycle.cycle_time)
    assert vars(pieced.statics) == pytest.approx(vars(whole.statics))


@FEW
@given(AXES, MOVES)
def test_the_sheet_shows_what_the_arrays_hold(axis: dict[str, Any], motion: MotionProfile):
    sheet = Sheet()
    found = BallScrew.si(**axis).load(motion, Environment.si(), sheet)
    peak = sheet.value("peak_torque_at_screw")
    assert abs(peak) == pytest.approx(np.abs(found.cycle.torque).max())
    for step in sheet.steps:
        shown = re.fullmatch(r"phase_(\d+)_torque", step.key)
        if shown:
            assert step.value == pytest.approx(found.cycle.torque[int(shown[1]) - 1])


def test_arrays_equal_a_scalar_loop():
    axis = {**LACHMAN, "efficiency": 0.85}
    whole, _ = load(axis, ROUND_TRIP)
    for k in range(len(ROUND_TRIP.duration)):
        one = profile([(
            ROUND_TRIP.duration[k], ROUND_TRIP.speed_start[k], ROUND_TRIP.speed_end[k], ROUND_TRIP.process_force[k],
            ROUND_TRIP.direction[k], "alone",
        )])  # fmt: skip
        assert load(axis, one)[0].cycle.torque[0] == pytest.approx(whole.cycle.torque[k])


def test_viscous_friction_is_sampled_finely_enough():
    axis = {**PLAIN, "viscous_coefficient_ns_m": 4000}
    motion = run((0.5, 0.5, 0), (-0.5, 0.5, 0))
    found, _ = load(axis, motion)
    finer, _ = load(axis, split(motion, np.full(6, 512)))

    def effective(case: Load) -> float:
        return math.sqrt(float((case.cycle.torque**2 * case.cycle.duration).sum()))

    assert effective(found) == pytest.approx(effective(finer), rel=1e-4)
    assert found.cycle.torque.max() == pytest.approx(finer.cycle.torque.max(), rel=1e-3)
    # closed form: the friction work of one way is k_v * integral of v^2 dt = k_v (2/3 v^2 t_a + v^2 t_c)
    work = float((found.cycle.torque * angles(found)).sum())
    assert work == pytest.approx(2 * 4000 * 0.25 * (2 / 3 * 0.1 + 0.9), rel=1e-4)


def test_the_drawing_carries_symbols_of_fields():
    texts = ElementTree.parse(DRAWING).getroot().iter("{http://www.w3.org/2000/svg}text")
    drawn = {symbol for item in texts if (symbol := item.get("data-symbol"))}
    assert {"m", "alpha", "D", "h", "l", "x", "F_e"} <= drawn
    assert drawn <= {found.symbol for _, _, found in BallScrew.declarations()}


def test_it_is_found_by_its_kind():
    assert mechanisms()["ball_screw"] is BallScrew
