"""Belt conveyor with a stage before the drum: by hand, and what must hold for every conveyor."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from app.engine.mechanisms import mechanisms
from app.engine.mechanisms.belt_conveyor import BeltConveyor
from app.engine.motion.profile import MotionProfile
from app.engine.sheet import Verdict
from tests.engine.mechanisms import laws
from tests.engine.mechanisms.laws import FEW, loaded, written
from tests.engine.mechanisms.screw_cases import run

TWO_STAGES: dict[str, Any] = {
    "load_mass_kg": 50, "friction_coefficient": 0.6, "drum_diameter_mm": 120, "efficiency": 1, "stage_ratio": 2,
    "stage_efficiency": 1,
}  # fmt: skip
TRANSFER = run((2, 0.5, 0), a=2.5)


def conveyor(**values: Any) -> BeltConveyor:
    return BeltConveyor.model_validate(values)


def test_conveyor_with_a_second_stage():
    # 50 kg, mu 0.6, g 9.8: friction 294 N, accelerating 125 N; r = 60 mm, the stage of 2 halves the torque
    found = loaded(conveyor(**TWO_STAGES), TRANSFER, gravity=9.8)
    assert found.cycle.torque == pytest.approx([419 * 0.06 / 2, 294 * 0.06 / 2, 169 * 0.06 / 2])
    assert found.cycle.max_speed == pytest.approx(0.5 / 0.06 * 2)
    assert found.cycle.inertia == pytest.approx(50 * 0.06**2 / 4)
    sheet = written(conveyor(**TWO_STAGES), TRANSFER, gravity=9.8)
    assert sheet.value("friction_force") == pytest.approx(294)
    assert sheet.value("drum_torque") == pytest.approx(419 * 0.06)
    assert sheet.value("stage_input_torque") == pytest.approx(419 * 0.03)
    assert sheet.value("inertia_before_stage") == pytest.approx(0.045)


def test_belt_rollers_drums_and_stage_count_each_in_its_place():
    # belt 8 kg (carrying half rubs), rollers 4 kg as tubes, drums 0.01 kg m2, input shaft of the stage 0.002 kg m2
    axis = conveyor(
        **{**TWO_STAGES, "efficiency": 0.8, "stage_efficiency": 0.9}, belt_mass_kg=8, roller_mass_kg=4,
        drum_inertia_kgcm2=100, stage_inertia_kgcm2=20,
    )  # fmt: skip
    found = loaded(axis, TRANSFER)
    force = 0.6 * 54 * 9.81 + 62 * 2.5
    drum = (force * 0.06 + 0.01 * 2.5 / 0.06) / 0.8
    assert found.cycle.torque[0] == pytest.approx(drum / 0.9 / 2 + 0.002 * 2.5 / 0.06 * 2)
    assert found.cycle.inertia == pytest.approx((62 * 0.06**2 + 0.01) / 4 + 0.002)
    sheet = written(axis, TRANSFER)
    assert sheet.value("stage_input_torque_total") == pytest.approx(found.cycle.torque[0])


def test_a_stage_without_efficiency_takes_that_of_a_chain_as_an_assumption():
    lossy = conveyor(**{**TWO_STAGES, "stage_efficiency": None})
    assert loaded(lossy, TRANSFER, gravity=9.8).cycle.torque[1] == pytest.approx(294 * 0.06 / 0.9 / 2)
    found = {assumption.key: assumption.value for assumption in written(lossy, TRANSFER).assumptions}
    assert found["mechanism.stage_efficiency"] == 0.9
    none = conveyor(**{**TWO_STAGES, "stage_efficiency": None, "stage_ratio": 1})
    assert loaded(none, TRANSFER, gravity=9.8).cycle.torque[1] == pytest.approx(294 * 0.06)
    assert not written(none, TRANSFER).assumptions


def test_an_inclined_conveyor_lifts_its_load_and_holds_it():
    uphill = conveyor(**{**TWO_STAGES, "inclination_deg": 30}, belt_mass_kg=10)
    found = loaded(uphill, TRANSFER)
    weight, friction = 50 * 9.81 / 2, 0.6 * 55 * 9.81 * math.cos(math.radians(30))
    assert found.cycle.torque[1] == pytest.approx((weight + friction) * 0.03)
    assert found.statics.holding == pytest.approx(weight * 0.03)
    assert found.opposite is None
    back = loaded(conveyor(**{**TWO_STAGES, "inclination_deg": 30, "reversing": True}), TRANSFER)
    assert back.opposite is not None


def test_grip_of_the_drum_by_rope_friction():
    # half a turn, mu 0.3: e^(0.3 pi) - 1 = 1.5663; 300 N hold 469.9 N, the belt needs 294.3 + 125 N
    axis = conveyor(**TWO_STAGES, slack_tension_n=300, drum_friction=0.3)
    (check,) = written(axis, TRANSFER).checks
    assert (check.demanded, check.permitted) == pytest.approx((419.3, 300 * (math.exp(0.3 * math.pi) - 1)))
    (unknown,) = written(conveyor(**TWO_STAGES), TRANSFER).checks
    assert unknown.verdict is Verdict.NOT_CHECKED
    assert unknown.missing == "tension of the slack strand, drum friction"


@pytest.mark.parametrize("field", ["load_mass_kg", "drum_diameter_mm", "stage_ratio", "stage_efficiency"])
def test_a_conveyor_without_load_drum_or_ratio_is_refused_at_that_field(field: str):
    with pytest.raises(ValidationError) as caught:
        conveyor(**{**TWO_STAGES, field: 0})
    assert [error["loc"] for error in caught.value.errors()] == [(field,)]


AXES = st.fixed_dictionaries(
    {
        "load_mass": st.floats(1, 1000), "belt_mass": st.floats(0, 100), "inclination": st.floats(0, 1),
        "friction_coefficient": st.floats(0, 0.8), "friction_force": st.floats(0, 200),
        "drum_diameter": st.floats(0.05, 0.8), "drum_inertia": st.floats(0, 0.5), "roller_mass": st.floats(0, 50),
        "efficiency": st.floats(0.3, 1), "stage_ratio": st.floats(0.5, 5), "stage_efficiency": st.floats(0.3, 1),
        "stage_inertia": st.floats(0, 0.05),
    }
)  # fmt: skip
MOVES = st.lists(st.tuples(st.floats(0.5, 2), st.floats(0.05, 1), st.floats(-100, 500)), min_size=1, max_size=3).map(
    lambda moves: run(*moves, *[(-s, v, force) for s, v, force in moves], m=5.0)
)
MODELS = st.sampled_from(["eta", "sew"])


@FEW
@given(AXES, MOVES, MODELS)
def test_power_balances_over_both_stages(axis: dict[str, Any], motion: MotionProfile, model: str):
    found = loaded(BeltConveyor.si(**axis), motion, regeneration=model).cycle
    moved = axis["load_mass"] + 5 + axis["belt_mass"] + axis["roller_mass"]
    weight = (axis["load_mass"] + 5) * 9.81 * math.sin(axis["inclination"])
    normal = (axis["load_mass"] + 5 + axis["belt_mass"] / 2) * 9.81 * math.cos(axis["inclination"])
    rub = (axis["friction_coefficient"] * normal + axis["friction_force"]) * np.sign(motion.mean_speed)
    force = moved * motion.acceleration + weight + rub + motion.process_force * motion.direction
    drum_speed = motion.mean_speed / (axis["drum_diameter"] / 2)
    drum_alpha = motion.acceleration / (axis["drum_diameter"] / 2)
    power = force * motion.mean_speed + axis["drum_inertia"] * drum_alpha * drum_speed
    for eta in (axis["efficiency"], axis["stage_efficiency"]):
        power = np.where(power > 0, power / eta, power * (eta if model == "eta" else max(2 - 1 / eta, 0)))
    power = power + axis["stage_inertia"] * drum_alpha * drum_speed * axis["stage_ratio"] ** 2
    np.testing.assert_allclose(found.torque * found.mean_speed, power, rtol=1e-9, atol=1e-6)


@FEW
@given(AXES, st.floats(1, 300))
def test_inertia_is_twice_the_kinetic_energy(axis: dict[str, Any], omega: float):
    drum = omega / axis["stage_ratio"]
    mass = axis["load_mass"] + 5 + axis["belt_mass"] + axis["roller_mass"]
    energy = mass * (drum * axis["drum_diameter"] / 2) ** 2 / 2 + axis["drum_inertia"] * drum**2 / 2
    energy += axis["stage_inertia"] * omega**2 / 2
    assert loaded(BeltConveyor.si(**axis), run((3, 1, 0), m=5.0)).cycle.inertia == pytest.approx(2 * energy / omega**2)


@FEW
@given(AXES, MOVES, MODELS, st.floats(0.5, 0.99), st.integers(2, 5))
def test_losses_mirror_and_split(axis: dict[str, Any], motion: MotionProfile, model: str, share: float, pieces: int):
    mechanism = BeltConveyor.si(**axis)
    lossier = BeltConveyor.si(**{**axis, "stage_efficiency": axis["stage_efficiency"] * share})
    laws.losses_never_help(mechanism, lossier, motion, model)
    laws.mirrored_motion_mirrors_the_torques(BeltConveyor.si(**{**axis, "inclination": 0.0}), motion, model)
    laws.splitting_changes_nothing(mechanism, motion, pieces)


@FEW
@given(AXES)
def test_the_statics_are_the_steady_torques_of_the_cycle(axis: dict[str, Any]):
    plain = run((1, 0.5, 0), (-1, 0.5, 0), m=5.0)
    found = loaded(BeltConveyor.si(**axis), plain)
    assert (found.statics.forward, found.statics.backward) == pytest.approx(tuple(found.cycle.torque[[1, 4]]), abs=1e-9)


def test_arrays_equal_a_scalar_loop():
    laws.arrays_equal_a_loop(conveyor(**TWO_STAGES), run((1, 0.5, 100), (-1, 0.4, -50), a=2.0, m=10.0))


def test_the_drawing_carries_symbols_of_fields():
    laws.drawing_shows_fields([BeltConveyor], BeltConveyor.drawing, {"m_L", "m_b", "alpha", "D", "mu", "i_2"})


def test_it_is_found_by_its_kind():
    assert mechanisms()["belt_conveyor"] is BeltConveyor
