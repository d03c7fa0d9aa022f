"""The feed axis of Lachman and Mendricky (2015): ten motors against the criteria, numbers recomputed independently."""

from math import pi, sin

import pytest

from app.engine.candidates import GearArrays, MotorArrays
from app.engine.cycle import LoadCycle
from app.engine.drives.own import OwnServoMotor
from app.engine.drives.rules import ServoRules
from app.engine.drives.servo import ServoResult, check_servo
from app.engine.environment import Environment
from app.engine.mechanisms.load import Load
from app.engine.selection import DIRECT, select
from app.engine.sheet import Sheet, Verdict
from tests.engine.drives.cases import cycle, gear, load

LACHMAN = ServoRules.si(rule_set="lachman")
LEAD = 0.02 / (2 * pi)
INERTIA = pi * 0.05**4 * 1.0 * 7850 / 32 + 400 * LEAD**2
FRICTION = 5 + 400 * LEAD
WEIGHT = 400 * 9.81 * sin(pi / 3) * LEAD
WORKING = WEIGHT + FRICTION + 10_000 * LEAD
RAPID, FEED, EPSILON = 0.5 / LEAD, 0.2 / LEAD, 5 / LEAD

# motor, M_0 and M_N (100 K) [N m], J_M [kg cm2]; then: inertia, M_1, M_2, M_3, M_3 with 5 %, S1 at working speed,
# required peak torque, passes
MOTORS = [
    ("1FT5 062", 2.6, 2.4, 4.7, False, False, False, False, 2.54, 76.3102, False),
    ("1FT5 064", 5.5, 4.7, 8.3, False, False, False, False, 5.26, 76.9888, False),
    ("1FT5 066", 8.0, 6.7, 11.8, False, False, False, False, 7.61, 77.6485, False),
    ("1FT5 072", 12.0, 9.5, 22.8, False, False, False, False, 11.25, 79.722, False),
    ("1FT5 074", 18.0, 14.0, 36.7, False, False, False, False, 16.8, 82.3421, False),
    ("1FT5 076", 22.0, 18.5, 50.9, False, False, True, False, 20.95, 85.0187, False),
    ("1FT5 102", 33.0, 28.0, 136.0, True, True, True, False, 31.5, 101.06, False),
    ("1FT5 104", 45.0, 35.0, 185.0, True, True, True, False, 42.0, 110.296, False),
    ("1FT5 106", 55.0, 39.0, 239.0, True, True, True, True, 50.2, 120.475, True),
    ("1FT5 108", 68.0, 42.5, 291.0, True, True, True, True, 60.35, 130.276, True),
]


def axis() -> Load:
    """Rapid move up, weight held at the end."""
    up, ramp = WEIGHT + FRICTION, INERTIA * EPSILON
    move: LoadCycle = cycle(
        (0.1, 0, RAPID, up + ramp, False), (0.26, RAPID, RAPID, up, False), (0.1, RAPID, 0, up - ramp, False),
        (0.5, 0, 0, WEIGHT, False), inertia=INERTIA,
    )  # fmt: skip
    return load(
        move, friction=FRICTION, forward=up, backward=WEIGHT - FRICTION, holding=WEIGHT, working=WORKING,
        rapid_speed=RAPID, working_speed=FEED,
    )  # fmt: skip


def table_motor(name: str, stall: float, rated: float, inertia: float) -> OwnServoMotor:
    return OwnServoMotor.model_validate(
        {"name": name, "rated_speed_rpm": 2000, "stall_torque_nm": stall, "rated_torque_nm": rated,
         "rotor_inertia_kgcm2": inertia}
    )  # fmt: skip


def checked(row: int, rules: ServoRules = LACHMAN) -> tuple[ServoResult, Sheet]:
    sheet = Sheet()
    product = table_motor(*MOTORS[row][:4]).product()
    return check_servo(axis(), product, None, None, rules, Environment(), sheet), sheet


@pytest.mark.parametrize("row", range(10), ids=[str(entry[0]) for entry in MOTORS])
def test_each_motor_of_the_table(row: int):
    _, _, _, _, inertia, friction, rest, working, at_working_speed, peak, passes = MOTORS[row]
    result, sheet = checked(row)
    holds = {one.key: one.verdict not in (Verdict.FAILS, Verdict.NOT_CHECKED) for one in result.checks}
    assert holds["motor_inertia"] == inertia
    assert holds["friction_torque"] == friction
    assert holds["rest_torque"] == rest
    assert holds["working_torque"] == working  # the table's verdict is the same with 5 % tolerance
    assert holds["motor_speed"]
    assert (result.verdict != Verdict.FAILS) == passes
    assert sheet.value("continuous_torque_at_working_speed") == pytest.approx(at_working_speed, rel=1e-4)
    assert sheet.value("required_peak_torque") == pytest.approx(peak, rel=1e-5)
    assert next(one for one in result.checks if one.key == "dynamic_peak_torque").verdict == Verdict.NOT_CHECKED


def test_demands_on_the_motor_shaft():
    _, sheet = checked(8)
    exact = {
        "continuous_torque_for_friction": 31.36619772, "continuous_torque_at_rest": 17.09031247,
        "continuous_torque_working": 48.92130109, "motor_angular_acceleration": 1570.796327,
        "total_inertia": 0.03276954702, "dynamic_torque": 100.3955852, "required_motor_inertia": 0.007095637616,
        "inertia_ratio": 0.371110754,
    }  # fmt: skip
    for key, value in exact.items():
        assert sheet.value(key) == pytest.approx(value, rel=1e-8), key
    assert next(step for step in sheet.steps if step.key == "required_motor_speed").shown_value == pytest.approx(1800)


def test_relaxed_friction_rule():
    _, sheet = checked(8, ServoRules.si(rule_set="lachman", friction_share=0.4))
    assert sheet.value("continuous_torque_for_friction") == pytest.approx(15.68309886, rel=1e-8)


def test_1ft5_104_fails_only_by_working_torque():
    result, _ = checked(7)
    failing = [one for one in result.checks if one.verdict == Verdict.FAILS]
    assert [one.key for one in failing] == ["working_torque"]
    assert failing[0].utilisation == pytest.approx(48.92130109 / (42 * 1.05))


def test_selection_finds_106_and_108_alone():
    motors = MotorArrays.from_records(table_motor(*entry[:4]).product() for entry in MOTORS)
    found = select(axis(), motors, GearArrays.from_records([]), LACHMAN, Environment(), ranking="rated_torque")
    assert [(one.motor, one.gear) for one in found.candidates] == [(8, DIRECT), (9, DIRECT)]
    assert found.rejected == {"motor_inertia": 6, "working_torque": 2}
    assert "dynamic_peak_torque" in found.candidates[0].not_checked


def test_a_gear_unit_squares_the_ratio_in_the_inertia():
    sheet = Sheet()
    product = table_motor(*MOTORS[8][:4]).product()
    check_servo(axis(), product, gear(ratio=2.0, efficiency=1.0), None, LACHMAN, Environment(), sheet)
    assert sheet.value("required_motor_inertia") == pytest.approx(0.8 * INERTIA / 4)
    assert sheet.value("continuous_torque_working") == pytest.approx(WORKING / 2)
