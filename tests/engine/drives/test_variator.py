"""Variable-speed gear: three ways of dimensioning, both ends of the range, service factors, motor."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic import ValidationError

from app.engine.drives.base import DriveResult, Given
from app.engine.drives.parts import parts_of
from app.engine.drives.variator import VariatorDrive
from app.engine.drives.variator_range import VariatorCase, torque_between
from app.engine.environment import Environment
from app.engine.errors import EngineError
from app.engine.mechanisms.load import Load, LoadState, Statics
from app.engine.motion.constant import ConstantMotion
from app.engine.sheet import Check, Sheet, Verdict
from tests.engine.drives.cases import cycle

RADIUS = 0.315 / 2
SPEED = 0.6 / RADIUS
UNIT = {
    "design": "belt", "lowest_speed_rpm": 6.2, "highest_speed_rpm": 37, "torque_at_lowest_speed_nm": 1450,
    "torque_at_highest_speed_nm": 870, "power_at_highest_speed_kw": 3.3, "efficiency": 0.76 / 0.9,
}  # fmt: skip
MOTOR = {
    "own": {
        "rotor_inertia_with_brake_kgm2": 0.01102,
        "windings": [{"poles": 4, "rated_power_kw": 4, "rated_speed_rpm": 1420, "run_up_torque_ratio": 2.1}],
    }
}


def conveyor(force: float = 5030.448, holding: float = 0.0) -> Load:
    """Drum of the belt conveyor of SEW 2001, 13.1, as recomputed: 10 228 kg and idlers like 464 kg, 0.6 m/s."""
    torque, inertia = force * RADIUS, (30 * 340.9259 + 464.335) * RADIUS**2
    state = LoadState(key="laden_forward", label="laden", direction=1.0, torque=torque, inertia=inertia, speed=SPEED,
                      efficiency=0.9, travel=RADIUS)  # fmt: skip
    statics = Statics(torque, torque / 0.9, -torque / 0.9, holding, torque, SPEED, SPEED)
    return Load(cycle=cycle((10.0, SPEED, SPEED, torque / 0.9, False)), statics=statics, states=(state,))


def run(load: Load, environment: dict[str, object] | None = None, **more: object) -> tuple[Sheet, dict[str, Check]]:
    sheet, _ = result(load, environment, **more)
    return sheet, {check.key: check for check in sheet.checks}


def result(
    load: Load, environment: dict[str, object] | None = None, **more: object
) -> tuple[Sheet, DriveResult]:  # fmt: skip
    drive = VariatorDrive.model_validate({"speed_range": 3, "variable_speed_gear": UNIT, **more})
    products = {role: part.typed for role, part in parts_of(drive) if part.typed is not None}
    sheet = Sheet()
    profile = ConstantMotion.model_validate({"speed_m_s": 0.6}).solve(Sheet())
    asked = Given(load, profile, products, Environment.model_validate(environment or {}))
    return sheet, drive.check(asked, sheet)


def test_the_unit_of_the_handbook_is_too_weak_at_its_highest_speed():
    """SEW 2001, 13.2 takes R87 VU31: 880 N m and 3.35 kW are needed, 870 N m and 3.3 kW listed."""
    sheet, checks = run(conveyor())
    assert checks["variator_torque_high"].demanded == pytest.approx(880.328, rel=1e-5)
    assert checks["variator_torque_high"].verdict == Verdict.FAILS
    assert checks["variator_power_high"].demanded == pytest.approx(3353.63, rel=1e-5)
    assert checks["variator_power_high"].verdict == Verdict.FAILS
    assert checks["variator_torque_low"].verdict == Verdict.OK
    assert checks["variator_speed_low"].verdict == Verdict.OK
    assert sheet.value("lowest_output_speed") == pytest.approx(12.126 * np.pi / 30, rel=1e-4)


def test_the_motor_of_the_handbook_runs_up_in_1_2_s():
    """SEW 2001, 13.1, recomputed: 3.97 kW of 4 kW; J_X 0.1741 kg m2, t_A 1.199 s, a_A 0.5006 m/s2."""
    sheet, checks = run(conveyor(), motor=MOTOR)
    assert checks["static_power"].demanded == pytest.approx(3971.4, rel=1e-4)
    assert checks["static_power"].verdict == Verdict.TIGHT
    assert sheet.value("laden_forward_external_inertia") == pytest.approx(0.17407, rel=1e-4)
    assert sheet.value("laden_forward_run_up_time") == pytest.approx(1.19866, rel=1e-4)
    assert sheet.value("laden_forward_run_up_acceleration") == pytest.approx(0.50056, rel=1e-4)


def test_the_brake_stops_with_the_help_of_the_load():
    """40 N m: (0.01102 + 0.174073 * 0.76) kg m2 * 148.70 rad/s / (40 + 20.297 * 0.76) N m = 0.3845 s."""
    brake = {"own": {"torque_nm": 40, "application_time_dc_ms": 30}}
    _, checks = run(conveyor(holding=100.0), motor=MOTOR, brake=brake, accuracy_mm=1)
    still, _ = run(conveyor(), motor=MOTOR, brake=brake)
    assert still.value("laden_forward_braking_time") == pytest.approx(0.3845, rel=1e-3)
    assert checks["brake_holding"].demanded == pytest.approx(2 * 100 / 39.0343, rel=1e-4)
    assert checks["stopping_accuracy_laden_forward"].verdict == Verdict.FAILS


def test_constant_power_asks_three_times_the_torque_at_a_third_of_the_speed():
    sheet, checks = run(conveyor(), law="constant_power")
    assert sheet.value("lowest_speed_torque") == pytest.approx(3 * 880.328, rel=1e-5)
    assert sheet.value("extra_torque") == 2.0
    assert checks["variator_torque_low"].verdict == Verdict.FAILS


def test_both_laws_meet_at_the_corner():
    """Power constant down to half the speed (18.189 rpm): twice the torque there and below; P_min = 2/3 of P."""
    sheet, checks = run(conveyor(), law="both", corner_speed_rpm=SPEED / 2 * 30 / np.pi)
    assert checks["variator_torque_corner"].demanded == pytest.approx(2 * 880.328, rel=1e-5)
    assert checks["variator_torque_low"].demanded == pytest.approx(2 * 880.328, rel=1e-5)
    assert sheet.value("lowest_output_power") == pytest.approx(3353.63 * 2 / 3, rel=1e-5)


def test_the_corner_lies_in_the_range():
    with pytest.raises(ValidationError, match="where they meet"):
        VariatorDrive.model_validate({"law": "both"})
    with pytest.raises(EngineError) as caught:
        run(conveyor(), law="both", corner_speed_rpm=40)
    assert caught.value.field == "corner_speed_rpm"


@pytest.mark.parametrize(("load_class", "factor"), [("I", 1.0), ("II", 1.25), ("III", 1.5)])
def test_the_load_class_multiplies_the_demand(load_class: str, factor: float):
    _, checks = run(conveyor(), load_class=load_class, temperature_factor=1.2)
    assert checks["variator_torque_high"].demanded == pytest.approx(880.328 * factor * 1.2, rel=1e-5)


def test_in_a_hot_place_the_chart_of_the_maker_is_needed():
    _, checks = run(conveyor(), {"ambient_temperature_degc": 45})
    assert checks["variator_torque_high"].verdict == Verdict.NOT_CHECKED
    _, checks = run(conveyor(), {"ambient_temperature_degc": 45}, temperature_factor=1.1)
    assert checks["variator_torque_high"].demanded == pytest.approx(880.328 * 1.1, rel=1e-5)


def test_friction_discs_bear_no_shocks():
    disc = {"variable_speed_gear": {**UNIT, "design": "friction_disc"}}
    assert run(conveyor(), **disc)[1]["variator_shocks"].verdict == Verdict.TIGHT
    assert run(conveyor(), load_class="II", **disc)[1]["variator_shocks"].verdict == Verdict.FAILS
    assert "variator_shocks" not in run(conveyor(), load_class="II")[1]


def test_a_speed_beyond_the_list_has_no_permitted_torque():
    """1 : 10 is 3.64 rpm, the list begins at 6.2 rpm."""
    _, checks = run(conveyor(), speed_range=10)
    assert checks["variator_speed_low"].verdict == Verdict.FAILS
    assert checks["variator_torque_low"].verdict == Verdict.NOT_CHECKED


def test_without_parts_it_says_what_they_must_do():
    sheet, found = result(conveyor(), variable_speed_gear=None)
    assert found.checks == ()
    assert {"output_torque", "output_power", "lowest_speed_torque"} <= {step.key for step in sheet.steps}


def test_what_is_not_known_is_not_checked():
    unit = {name: value for name, value in UNIT.items() if name != "efficiency"}
    _, checks = run(conveyor(), variable_speed_gear=unit, motor=MOTOR)
    assert checks["static_power"].verdict == Verdict.NOT_CHECKED
    assert "efficiency" in checks["run_up_torque"].missing
    assert run(conveyor(holding=100.0))[1]["brake_holding"].verdict == Verdict.NOT_CHECKED


def test_a_load_that_drives_loses_on_its_way_to_the_gear():
    """Lowering: 5030 N * 0.1575 m * 0.9 arrive at the output."""
    sheet, _ = run(conveyor(-5030.448))
    assert sheet.value("output_torque") == pytest.approx(5030.448 * RADIUS * 0.9)


def test_the_chart_shows_demand_and_list():
    _, found = result(conveyor())
    (chart,) = found.diagrams
    demanded, permitted = chart.series
    assert demanded.y[-1] == pytest.approx(880.328, rel=1e-5)
    assert permitted.y[0] == pytest.approx(1450)
    assert permitted.y[-1] == pytest.approx(870)


@settings(max_examples=50, deadline=None)
@given(
    low=st.floats(0.1, 10), ratio=st.floats(1.5, 10), torque=st.floats(1, 1e4), fall=st.floats(0.1, 1),
    share=st.floats(0, 1),
)  # fmt: skip
def test_between_the_ends_the_power_is_a_straight_line_below_that_of_the_torque(
    low: float, ratio: float, torque: float, fall: float, share: float
):
    case = VariatorCase(lowest_speed=low, highest_speed=low * ratio, lowest_torque=torque, highest_torque=torque * fall,
                        highest_power=None, uniform_only=False)  # fmt: skip
    speed = low + share * (case.highest_speed - low)
    ends = (torque * low, torque * fall * case.highest_speed)
    found = torque_between(case, speed)
    assert found * speed == pytest.approx(ends[0] + share * (ends[1] - ends[0]), rel=1e-9)
    assert found <= torque * (1 + share * (fall - 1)) * (1 + 1e-9)
