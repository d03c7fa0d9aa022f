"""Fans and pumps: the laws of affinity, and the static head."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic import ValidationError

from app.engine.mechanisms.fan import Fan
from app.engine.mechanisms.pump import Pump
from app.engine.motion.constant import ConstantRotation
from app.engine.motion.profile import MotionProfile
from app.engine.sheet import Sheet
from tests.engine.mechanisms.laws import drawing_shows_fields, loaded, written

FAN = {"rated_speed_rpm": 1000, "volume_flow_m3_h": 18000, "pressure_pa": 1200, "fan_efficiency": 0.75,
       "rotor_inertia_kgm2": 8}  # fmt: skip
PUMP = {"rated_speed_rpm": 1450, "volume_flow_m3_h": 72, "head_m": 30, "pump_efficiency": 0.75,
        "rotor_inertia_kgm2": 0.05}  # fmt: skip
STATIC = PUMP | {"static_head_m": 10, "closed_valve_head_m": 40}


def fan(**other: Any) -> Fan:
    return Fan.model_validate(FAN | other)


def turning(rpm: float, **other: Any) -> MotionProfile:
    return ConstantRotation.model_validate({"speed_rpm": rpm, **other}).solve(Sheet())


def torque_at(machine: Fan | Pump, rpm: float) -> float:
    return float(loaded(machine, turning(rpm)).cycle.torque[0])


def test_power_of_a_fan_by_hand():
    """5 m3/s * 1200 Pa / 0.75 = 8 kW; at 1000 rpm 76.394 N m."""
    sheet = written(fan(), turning(1000))
    assert sheet.value("fan_power") == pytest.approx(8000)
    assert sheet.value("rated_load_torque") == pytest.approx(76.394, abs=1e-3)


@settings(max_examples=30, deadline=None)
@given(share=st.floats(0.05, 2))
def test_torque_with_the_square_power_with_the_cube(share: float):
    assert torque_at(fan(), 1000 * share) == pytest.approx(torque_at(fan(), 1000) * share**2)
    assert torque_at(Pump.model_validate(PUMP), 1450 * share) == pytest.approx(
        torque_at(Pump.model_validate(PUMP), 1450) * share**2
    )


def test_friction_does_not_depend_on_the_speed():
    """2 + (76.394 - 2) / 4"""
    assert torque_at(fan(friction_torque_nm=2), 500) == pytest.approx(20.5986, abs=1e-3)


def test_run_up_takes_the_kinetic_energy_and_what_the_gas_takes():
    """8 kg m2 * (104.72 rad/s)^2 / 2 = 43.865 kJ, and P t / 4 of a torque that grows with the square."""
    cycle = loaded(fan(), turning(1000, run_up_time_s=10, starts_per_hour=10)).cycle
    up = np.array([label.startswith("run-up") for label in cycle.label])
    work = float((cycle.torque * cycle.mean_speed * cycle.duration)[up].sum())
    assert work == pytest.approx(43864.9 + 8000 * 10 / 4, rel=1e-4)


def test_pump_at_its_operating_point_by_hand():
    """1000 * 9.81 * 0.02 * 30 / 0.75 = 7848 W over 151.844 rad/s."""
    sheet = written(Pump.model_validate(PUMP), turning(1450))
    assert sheet.value("pump_power") == pytest.approx(7848)
    assert sheet.value("rated_load_torque") == pytest.approx(51.685, abs=1e-3)


def test_a_static_head_stops_the_flow_above_standstill():
    """H_0 n^2 = H_st at half speed; there the torque is 0.4 of that of the operating point by the square: 0.4 / 4."""
    pump = Pump.model_validate(STATIC)
    sheet = written(pump, turning(725))
    assert sheet.value("highest_flow") == pytest.approx(0, abs=1e-9)
    assert torque_at(pump, 725) == pytest.approx(51.685 * 0.1, abs=1e-3)
    assert torque_at(pump, 1450) == pytest.approx(51.685, abs=1e-3)


def test_flow_and_head_lie_on_both_curves():
    """At 80 % speed: Q = sqrt((25.6 - 10) / 30) of 72 m3/h = 51.92 m3/h; head 10 + 20 * 0.52 = 20.4 m; the pump gives
    25.6 - 10 * 0.52 = 20.4 m too."""
    sheet = written(Pump.model_validate(STATIC), turning(1160))
    assert sheet.value("highest_flow") * 3600 == pytest.approx(51.92, abs=0.01)
    assert sheet.value("head_of_system") == pytest.approx(20.4)


def test_the_state_of_load_carries_the_curve():
    (state,) = loaded(fan(), turning(1000, run_up_time_s=10, starts_per_hour=2)).states
    speeds, torques = np.array(state.curve).T
    np.testing.assert_allclose(torques, state.torque * (speeds / state.speed) ** 2)


@pytest.mark.parametrize(
    ("model", "values", "field", "words"),
    [
        (Fan, FAN | {"pressure_pa": None}, "pressure_pa", "give the power at the shaft"),
        (Fan, {"rated_speed_rpm": 900, "rotor_inertia_kgm2": 1}, "rated_power_kw", "is missing"),
        (Fan, FAN | {"friction_torque_nm": 80}, "friction_torque_nm", "76.39 N m"),
        (Pump, PUMP | {"static_head_m": 10}, "closed_valve_head_m", "this head is needed"),
        (Pump, STATIC | {"static_head_m": 35}, "static_head_m", "smaller than the head"),
        (Pump, STATIC | {"closed_valve_head_m": 20}, "closed_valve_head_m", "larger than the head"),
    ],
)
def test_what_does_not_fit_together(model: Any, values: dict[str, Any], field: str, words: str):
    with pytest.raises(ValidationError, match=words) as caught:
        model.model_validate(values)
    assert caught.value.errors()[0]["loc"] == (field,)


def test_drawings():
    drawing_shows_fields([Fan], "fan.svg", {"Q", "p_t", "n_W", "J_R"})
    drawing_shows_fields([Pump], "pump.svg", {"Q", "H", "H_st", "n_W"})
