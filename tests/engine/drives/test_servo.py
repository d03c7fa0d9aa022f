"""One servo drive on one load against hand calculations."""

from dataclasses import replace
from math import sqrt

import numpy as np
import pytest

from app.engine.drives.rules import ServoRules
from app.engine.drives.servo import ServoResult, check_servo
from app.engine.environment import Environment
from app.engine.mechanisms.load import Load
from app.engine.products import ServoDrive, ServoGearUnit, ServoMotor
from app.engine.sheet import Check, Sheet, Verdict
from tests.engine.drives.cases import RPM, cycle, gear, load, motor

# Direct drive: 0.002 kg m2 and 1 N m of friction, up to 100 rad/s in 0.1 s. Load alone 3, 1, -1 N m; with a rotor of
# the same 0.002 kg m2 (1000 rad/s2: 2 N m) 5, 1, -3 N m.
DIRECT = load(
    cycle(
        (0.1, 0, 100, 3, False),
        (0.3, 100, 100, 1, False),
        (0.1, 100, 0, -1, False),
        (0.5, 0, 0, 0, True),
        inertia=0.002,
    )
)
# Behind a gear unit (i = 5): 0.05 kg m2 and 5 N m, up to 20 rad/s in 0.1 s: 15, 5, -5 N m at the output.
GEARED = load(
    cycle(
        (0.1, 0, 20, 15, False), (0.3, 20, 20, 5, False), (0.1, 20, 0, -5, False), (0.5, 0, 0, 0, False), inertia=0.05
    )
)
NO_BRAKE = ServoRules.si(brake="no")


def checked(
    of: Load = DIRECT,
    by: ServoMotor | None = None,
    through: ServoGearUnit | None = None,
    drive: ServoDrive | None = None,
    rules: ServoRules = NO_BRAKE,
    environment: Environment | None = None,
) -> tuple[ServoResult, Sheet]:
    sheet = Sheet()
    return check_servo(of, by, through, drive, rules, environment or Environment(), sheet), sheet


def check(result: ServoResult, key: str) -> Check:
    return next(one for one in result.checks if one.key == key)


def test_rotor_belongs_to_peak_and_effective_torque():
    result, sheet = checked(by=motor())
    assert result.peak_torque == pytest.approx(5)  # without the rotor it would be 3
    assert result.effective_torque == pytest.approx(sqrt(25 * 0.1 + 1 * 0.3 + 9 * 0.1))  # without: sqrt(1.3)
    assert sheet.value("peak_torque") == pytest.approx(5)
    assert sheet.value("peak_load_torque_on_motor") == pytest.approx(3)
    assert sheet.value("steady_load_torque_on_motor") == pytest.approx(1)
    assert sheet.value("inertia_ratio") == pytest.approx(1)
    assert sheet.value("total_inertia") == pytest.approx(0.004)
    assert result.cycle.torque is not None
    np.testing.assert_allclose(result.cycle.torque, [5, 1, -3, 0])
    np.testing.assert_allclose(result.cycle.time, [0, 0.1, 0.4, 0.5, 1.0])


def test_usual_checks_compare_with_the_limits_of_the_motor():
    result, sheet = checked(by=motor())
    assert check(result, "peak_torque").utilisation == pytest.approx(5 / 30)
    # mean speed (50 * 0.1 + 100 * 0.3 + 50 * 0.1) rad / 1 s = 40 rad/s; S1 there 10 - 2 * 40 / 300
    assert sheet.value("mean_speed") == pytest.approx(40)
    assert check(result, "effective_torque").permitted == pytest.approx(10 - 2 * 40 / 300)
    assert check(result, "speed").permitted == pytest.approx(270)  # 0.9 * 300
    assert check(result, "inertia_ratio").utilisation == pytest.approx(0.1)
    assert sheet.value("required_motor_speed") == pytest.approx(100 / 0.9)
    assert sheet.value("required_motor_inertia") == pytest.approx(0.0002)
    assert sheet.value("ratio_for_inertia_limit") == pytest.approx(sqrt(0.002 / 0.02))
    assert sheet.value("ratio_for_speed") == pytest.approx(2.7)
    assert result.verdict == Verdict.OK


def test_power_at_the_motor_with_and_without_rotor():
    _, sheet = checked(by=motor())
    assert sheet.value("load_power_peak") == pytest.approx(300)  # 3 N m at 100 rad/s
    assert sheet.value("motor_power_peak") == pytest.approx(500)
    assert sheet.value("motor_power_steady") == pytest.approx(100)


def test_speed_limit_can_be_the_highest_speed():
    rules = ServoRules.si(brake="no", speed_limit="maximum", speed_share=0.5)
    result, _ = checked(by=motor(), rules=rules)
    assert check(result, "speed").permitted == pytest.approx(200)  # 0.5 * 400


@pytest.mark.parametrize(("model", "braking"), [("eta", -5 * 0.8 / 5), ("sew", -5 * 0.75 / 5)])
def test_gear_unit_divides_while_driving_and_multiplies_while_returning(model: str, braking: float):
    result, sheet = checked(GEARED, motor(), gear(inertia=0.001), environment=Environment.si(regeneration=model))
    assert result.cycle.torque is not None
    # rotor and gear unit: 0.003 kg m2 * 5 * 200 rad/s2 = 3 N m, never through the efficiency
    np.testing.assert_allclose(result.cycle.torque, [15 / 4 + 3, 5 / 4, braking - 3, 0])
    assert sheet.value("peak_torque") == pytest.approx(6.75)
    assert sheet.value("load_inertia_on_motor") == pytest.approx(0.002)
    assert sheet.value("external_inertia_on_motor") == pytest.approx(0.003)
    assert sheet.value("motor_angular_acceleration") == pytest.approx(1000)


def test_more_loss_in_the_gear_unit_returns_less():
    returned = []
    for eta in (0.95, 0.7, 0.4):
        result, _ = checked(GEARED, None, gear(efficiency=eta))
        assert result.cycle.torque is not None
        returned.append(-float(result.cycle.torque[2]))
    assert returned == pytest.approx([0.95, 0.7, 0.4])
    assert max(returned) < 1.0


def test_gear_unit_is_checked_at_its_output_and_its_input():
    result, sheet = checked(GEARED, motor(), gear())
    assert check(result, "gear_acceleration_torque").utilisation == pytest.approx(15 / 80)
    # cubic mean over 1 + 6 + 1 rad: (3375 * 1 + 125 * 6 + 125 * 1) / 8
    assert sheet.value("gear_output_mean") == pytest.approx((4250 / 8) ** (1 / 3))
    assert check(result, "gear_nominal_torque").permitted == 50
    assert check(result, "gear_mean_input_speed").demanded == pytest.approx(40)  # 5 * 8 rad / 1 s
    assert check(result, "gear_max_input_speed").demanded == pytest.approx(100)
    assert check(result, "gear_emergency_torque").verdict == Verdict.NOT_CHECKED


def test_emergency_torque_is_the_larger_of_brake_and_factor():
    by_factor, _ = checked(GEARED, motor(), gear(), rules=ServoRules.si(brake="no", emergency_stop_factor=2.0))
    assert check(by_factor, "gear_emergency_torque").demanded == pytest.approx(30)
    by_brake, _ = checked(
        GEARED, motor(brake_torque=7.0), gear(), rules=ServoRules.si(brake="yes", emergency_stop_factor=2.0)
    )
    assert check(by_brake, "gear_emergency_torque").demanded == pytest.approx(35)


def test_a_brake_in_the_pause_relieves_the_motor_of_holding():
    held = load(cycle((1, 0, 10, 4, False), (1, 0, 0, 3, False)), holding=3.0)
    braked = load(cycle((1, 0, 10, 4, False), (1, 0, 0, 0, True)), holding=3.0)
    weightless = motor(rotor_inertia=1e-12)
    assert checked(held, weightless)[0].effective_torque == pytest.approx(sqrt((16 + 9) / 2))
    assert checked(braked, weightless)[0].effective_torque == pytest.approx(sqrt(16 / 2))


def test_an_axis_that_needs_a_brake_and_gets_none_in_the_motor_is_told_apart():
    braked = load(cycle((1, 0, 10, 4, False), (1, 0, 0, 0, True)), holding=3.0)
    falling = load(cycle((1, 0, 10, 4, False), (1, 0, 0, 3, False)), holding=3.0)
    resting = load(cycle((1, 0, 10, 4, False), (1, 0, 0, 0, False)))
    said = [{decision.text for decision in checked(one, motor(), rules=NO_BRAKE)[1].decisions}
            for one in (braked, falling, resting)]  # fmt: skip
    outside, nothing = "A brake outside the motor holds the axis", "Nothing but the motor holds the axis"
    assert [sorted(texts & {outside, nothing}) for texts in said] == [[outside], [nothing], []]


def test_brake_is_needed_where_the_axis_does_not_rest():
    at_rest = load(cycle((1, 0, 10, 4, False)), friction=4.0)
    hanging = load(cycle((1, 0, 10, 4, False)), friction=1.0, holding=-3.0)
    automatic = ServoRules()
    assert not checked(at_rest, motor(), rules=automatic)[0].brake_needed
    result, sheet = checked(hanging, motor(brake_torque=6.0, rotor_inertia_with_brake=0.0025), gear(), rules=automatic)
    assert result.brake_needed
    assert result.rotor == 0.0025
    assert check(result, "holding_brake").utilisation == pytest.approx(3 / 5 / 6)
    assert sheet.value("holding_torque_on_motor") == pytest.approx(0.6)
    without, _ = checked(hanging, motor(), rules=automatic)
    assert check(without, "holding_brake").missing == "brake torque of the motor"


def test_continuous_torque_counts_at_the_mean_speed():
    steep = motor(stall_torque=10.0, rated_torque=2.0)
    steady = load(cycle((1, 250, 250, 5, False)))
    result, _ = checked(steady, steep)
    # S1 at 250 rad/s: 10 - 8 * 250 / 300 = 3.33 N m, although 5 N m are below the stall torque
    assert check(result, "effective_torque").permitted == pytest.approx(10 - 8 * 250 / 300)
    assert check(result, "effective_torque").verdict == Verdict.FAILS


def test_opposite_direction_counts_for_the_peak_only():
    up = cycle((0.1, 0, 10, 20, False), (0.9, 10, 10, 0, False))
    down = cycle((0.1, 0, -10, 2, False), (0.9, -10, -10, 0, False))
    result, _ = checked(load(down, opposite=up), motor(rotor_inertia=1e-12))
    assert result.peak_torque == pytest.approx(20)
    assert result.effective_torque == pytest.approx(sqrt(4 * 0.1))
    assert result.opposite is not None


def test_peak_curve_decides_at_the_end_where_it_is_used_most():
    # 20 N m at the start (speed 0, 40 N m available), 12 N m at 300 rad/s where only 15 N m are left
    curved = motor(rotor_inertia=1e-12, peak_curve=((0.0, 40.0), (200.0, 40.0), (400.0, 0.0)), peak_torque=40.0)
    result, sheet = checked(load(cycle((0.1, 0, 100, 20, False), (1, 300, 300, 12, False))), curved)
    assert check(result, "peak_torque").demanded == pytest.approx(12)
    assert check(result, "peak_torque").permitted == pytest.approx(20)  # 40 - 40 * 100 / 200
    assert sheet.value("peak_torque") == pytest.approx(20)
    assert sheet.value("peak_torque_at_that_speed") == pytest.approx(20)


def test_reserve_and_coupling_raise_the_demand():
    rules = ServoRules.si(brake="no", peak_reserve=1.5, coupling_inertia=0.001)
    result, _ = checked(by=motor(), rules=rules)
    assert result.peak_torque == pytest.approx(6)  # 3 + (0.002 + 0.001) * 1000
    assert check(result, "peak_torque").demanded == pytest.approx(9)
    assert check(result, "inertia_ratio").demanded == pytest.approx(1.5)


def test_without_a_motor_the_demand_is_still_there():
    result, sheet = checked(GEARED, None, gear())
    assert sheet.value("peak_torque") == pytest.approx(3.75)
    assert sheet.value("required_motor_inertia") == pytest.approx(0.0002)
    assert {one.key for one in result.checks} >= {"gear_acceleration_torque"}
    assert "peak_torque" not in {one.key for one in result.checks}
    assert any(one.key == "drive.motor" for one in sheet.assumptions)


@pytest.mark.parametrize(
    ("lacking", "not_checked", "named"),
    [
        ({"rotor_inertia": None}, {"peak_torque", "effective_torque", "inertia_ratio"}, "rotor inertia"),
        ({"peak_torque": None}, {"peak_torque"}, "peak torque"),
        ({"rated_torque": None}, {"effective_torque"}, "rated torque"),
        ({"rated_speed": None}, {"effective_torque", "speed"}, "rated speed"),
    ],
)
def test_missing_motor_data_are_named_and_not_guessed(lacking: dict[str, None], not_checked: set[str], named: str):
    result, _ = checked(by=motor(**lacking))
    assert {one.key for one in result.not_checked} == not_checked
    assert all(named in one.missing for one in result.not_checked)


def test_missing_gear_data_leave_its_own_limits_checked():
    result, _ = checked(
        GEARED, motor(), gear(efficiency=None), rules=ServoRules.si(brake="no", emergency_stop_factor=1.0)
    )
    assert {one.key for one in result.not_checked} == {"peak_torque", "effective_torque", "inertia_ratio"}
    assert all("efficiency of the gear unit" in one.missing for one in result.not_checked)
    assert result.cycle.torque is None


def test_a_motor_without_data_checks_nothing_and_raises_nothing():
    bare = ServoMotor(id="m", manufacturer="", series="", model="", source="")
    result, _ = checked(GEARED, bare, gear(ratio=3.0))
    assert {one.verdict for one in result.checks if not one.key.startswith("gear_")} == {Verdict.NOT_CHECKED}


def test_currents_follow_from_the_data_sheet():
    drive = ServoDrive(
        id="d", manufacturer="", series="", model="", source="", continuous_current=2.0, peak_current=4.0
    )
    result, sheet = checked(by=motor(stall_current=5.0), drive=drive)
    # 10 N m at 5 A: 2 N m/A
    assert sheet.value("effective_current") == pytest.approx(sqrt(3.7) / 2)
    assert check(result, "drive_peak_current").utilisation == pytest.approx(2.5 / 4)
    assert check(result, "drive_continuous_current").utilisation == pytest.approx(sqrt(3.7) / 4)
    unknown, _ = checked(by=motor(), drive=replace(drive, peak_current=None))
    assert check(unknown, "drive_peak_current").missing.startswith("torque constant")


def test_long_cycles_keep_the_sheet_short():
    segments = [(0.1, 5.0, 5.0, float(n), False) for n in range(1, 41)]
    _, sheet = checked(load(cycle(*segments, inertia=0.1)), motor())
    assert sheet.has("phase_12_torque")
    assert not sheet.has("phase_13_torque")
    assert sheet.value("peak_torque") == pytest.approx(40)
    assert any("first phases" in decision.text for decision in sheet.decisions)


def test_speeds_are_shown_in_turns_per_minute():
    _, sheet = checked(by=motor())
    shown = {step.key: step.shown_value for step in sheet.steps if step.unit == "rpm"}
    assert shown["motor_speed_max"] == pytest.approx(100 / RPM)
