"""Own data sheets and rules at the border."""

import pytest
from pydantic import ValidationError

from app.engine.drives.limits import ServoLimits
from app.engine.drives.own import OwnGearUnit, OwnServoMotor
from app.engine.drives.rules import ServoRules
from app.engine.sheet import Sheet
from tests.engine.drives.cases import RPM


def test_a_typed_motor_becomes_a_product_in_si():
    typed = {"name": "spare", "rated_speed_rpm": 3000, "rotor_inertia_kgcm2": 2.5, "peak_torque_nm": "12 N m"}
    product = OwnServoMotor.model_validate(typed).product()
    assert product.name == "spare"
    assert product.rated_speed == pytest.approx(3000 * RPM)
    assert product.rotor_inertia == pytest.approx(2.5e-4)
    assert product.peak_torque == 12
    assert product.stall_torque is None


def test_curve_points_are_put_in_order():
    points = [{"speed_rpm": 3000, "torque_nm": 4}, {"speed_rpm": 0, "torque_nm": 9}]
    product = OwnServoMotor.model_validate({"peak_curve": points}).product()
    assert product.peak_curve == ((0.0, 9.0), (pytest.approx(3000 * RPM), 4.0))


def test_two_points_at_one_speed_are_refused():
    points = [{"speed_rpm": 100, "torque_nm": 4}, {"speed_rpm": 100, "torque_nm": 9}]
    with pytest.raises(ValidationError, match="speed"):
        OwnServoMotor.model_validate({"peak_curve": points})


@pytest.mark.parametrize("field", ["rotor_inertia_kgcm2", "rated_torque_nm", "mass_kg"])
def test_zero_is_no_data_sheet_value(field: str):
    with pytest.raises(ValidationError):
        OwnServoMotor.model_validate({field: 0})


def test_efficiency_of_an_own_gear_unit_is_an_assumption_until_given():
    sheet = Sheet()
    sheet.assume_defaults(OwnGearUnit.model_validate({"ratio": 5}), "drive.gear_unit.own.")
    assert {one.key.rsplit(".", 1)[-1] for one in sheet.assumptions} == {"efficiency", "inertia_kgcm2"}


@pytest.mark.parametrize(("rule_set", "absent"), [("usual", "friction_share"), ("lachman", "inertia_ratio_limit")])
def test_only_the_rules_in_use_are_assumptions(rule_set: str, absent: str):
    taken = {name for name, _, _ in ServoRules.model_validate({"rule_set": rule_set}).defaults_taken()}
    assert absent not in taken
    assert "holding_reserve" in taken


def test_an_asynchronous_motor_weakens_its_field():
    """30 N m up to 2000 rpm, then by constant power: 15 N m at 4000 rpm, 10 N m at 6000 rpm."""
    data = {"rated_speed_rpm": 2000, "max_speed_rpm": 6000, "peak_torque_nm": 30}
    limits = ServoLimits(OwnServoMotor.model_validate(data | {"kind": "async"}).product())
    for rpm, torque in ((1500, 30), (2000, 30), (4000, 15), (6000, 10)):
        assert limits.peak(rpm * RPM) == pytest.approx(torque, rel=1e-3)
    assert OwnServoMotor.model_validate(data).product().peak_curve == ()
    typed = data | {"kind": "async", "peak_curve": [{"speed_rpm": 0, "torque_nm": 25}]}
    assert OwnServoMotor.model_validate(typed).product().peak_curve == ((0.0, 25.0),)
