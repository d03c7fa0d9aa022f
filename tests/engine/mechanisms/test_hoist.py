"""Hoist: weight, counterweight, reeving, states of lifting and lowering."""

import numpy as np
import pytest

from app.engine.environment import Environment
from app.engine.mechanisms.hoist import Hoist
from app.engine.motion import Moves
from app.engine.motion.trips import LinearRun
from app.engine.sheet import Sheet
from tests.engine.mechanisms.laws import drawing_shows_fields

MOTION = {"moves": [{"distance_mm": 1000, "speed_m_s": 0.3, "acceleration_m_s2": 0.3, "payload_kg": 300}], "pause_s": 1}


def load(**more: object):
    hoist = Hoist.model_validate({"cage_mass_kg": 200, "drum_diameter_mm": 250, "efficiency": 0.9, **more})
    sheet = Sheet()
    return hoist.load(Moves.model_validate(MOTION).solve(Sheet()), Environment.model_validate({}), sheet), sheet


def test_lifting_takes_the_weight_and_lowering_gives_it_back():
    """SEW 2001, 9.1: 500 kg on a sprocket of 250 mm: 4905 N * 0.125 m = 613.125 N m, / 0.9 = 681.25 N m."""
    found, _ = load()
    states = {state.key: state for state in found.states}
    assert states["laden_lifting"].torque == pytest.approx(613.125)
    assert states["laden_lowering"].torque == pytest.approx(-613.125)
    assert states["unladen_lifting"].torque == pytest.approx(245.25)
    assert found.statics.forward == pytest.approx(681.25)
    assert found.statics.backward == pytest.approx(613.125 * 0.9)
    assert found.statics.holding == pytest.approx(613.125)


def test_falls_divide_torque_and_way():
    one, two = load()[0], load(falls=2)[0]
    assert two.statics.forward == pytest.approx(one.statics.forward / 2)
    assert two.cycle.max_speed == pytest.approx(one.cycle.max_speed * 2)


def test_a_counterweight_takes_weight_and_adds_inertia():
    """250 kg against 500 kg: half the weight, 750 kg instead of 500 kg to be accelerated."""
    plain, balanced = load()[0], load(counterweight_mass_kg=250)[0]
    assert balanced.statics.holding == pytest.approx(plain.statics.holding / 2)
    assert balanced.cycle.inertia == pytest.approx(plain.cycle.inertia * 1.5)


def test_lowering_empty_against_a_counterweight_must_be_driven():
    found, _ = load(counterweight_mass_kg=300)
    empty = next(state for state in found.states if state.key == "unladen_lowering")
    assert empty.torque == pytest.approx((300 - 200) * 9.81 * 0.125)


def test_the_opposite_cycle_returns_power_while_lowering():
    found, _ = load()
    assert found.opposite is not None
    power = found.opposite.torque * found.opposite.mean_speed
    assert power[np.abs(found.opposite.acceleration) < 1e-9].min() == pytest.approx(-613.125 * 0.9 * 2.4)


def test_the_drawing_shows_the_fields():
    drawing_shows_fields([Hoist, LinearRun], "hoist.svg", {"m_0", "m_c", "m_p", "D", "n_r", "eta_L", "J_D", "i_2"})


@pytest.mark.parametrize(("a", "counterweight", "verdict"), [(12, 0, "ok"), (-12, 0, "fails"), (12, 100, "fails")])
def test_a_rope_only_pulls(a: float, counterweight: float, verdict: str):
    """Stopping while lifting, or starting to lower, by more than g; a counterweight falls on the other side."""
    rate, stop = (abs(a), 2.0) if a > 0 else (2.0, abs(a))
    move = {"distance_mm": 1000, "speed_m_s": 0.5, "acceleration_m_s2": rate, "deceleration_m_s2": stop}
    hoist = Hoist.model_validate(
        {"cage_mass_kg": 200, "drum_diameter_mm": 250, "counterweight_mass_kg": counterweight}
    )  # fmt: skip
    sheet = Sheet()
    hoist.load(Moves.model_validate({"moves": [move]}).solve(Sheet()), Environment.model_validate({}), sheet)
    assert [check.verdict for check in sheet.checks if check.key == "rope_slack"] == [verdict]
