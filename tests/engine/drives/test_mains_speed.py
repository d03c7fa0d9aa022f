"""Line-fed motor: the speed at which it runs by itself, and what depends on it, calculated by hand."""

import math

import pytest

from app.engine.sheet import Verdict
from tests.line_fed_requests import HOIST, TABLE, calculated, example, motor, refused, size

ONE, DOWN = "unladen_forward", "unladen_lowering"
SYNCHRONOUS = 50 * math.pi
TROLLEY = example("sew-08-1-travel-drive-two-pole")


@pytest.mark.parametrize(("speed", "frequency", "accepted"), [(1750, 50, False), (1500, 50, False), (1499, 50, True),
                                                              (1750, 60, True), (1800, 60, False)])  # fmt: skip
def test_a_motor_is_slower_than_its_field(speed: float, frequency: float, accepted: bool):
    """4 poles: 1500 rpm at 50 Hz, 1800 rpm at 60 Hz."""
    drive = {"motor": motor({"rated_speed_rpm": speed, "frequency_hz": frequency})}
    if accepted:
        assert size(TABLE, drive=drive).sheet.has("rated_torque")
        return
    ((name, message),) = refused(TABLE, drive=drive)
    assert name == "drive.motor.own.windings.0.rated_speed_rpm"
    assert f"{30 * frequency} rpm" in message


def test_wheels_without_weight_slip_and_are_not_refused():
    """No gravity, no permissible acceleration, no flywheel that keeps it."""
    sizing, checks = calculated(TROLLEY, environment={"gravity_m_s2": 0})
    assert checks["slip_starting_unladen_forward"].permitted == 0
    assert checks["slip_starting_unladen_forward"].verdict == Verdict.FAILS
    assert not sizing.sheet.has("unladen_forward_least_flywheel")


def test_the_power_is_that_at_the_speed_of_the_motor():
    """i = 10.5 gives 14.29 of 15 rad/s: 40 N m / 10.5 / 0.8 * 150 rad/s = 714.3 W, 750 W at the speed wished.

    Lowering runs at synchronous speed: 10 N m * 0.8 * 157.08 rad/s, 1200 W at the speed wished.
    """
    sizing, checks = calculated(TABLE, drive={"gear_unit": {"own": {"ratio": 10.5, "efficiency": 0.8}}})
    assert sizing.sheet.value(f"{ONE}_static_power") == pytest.approx(750)
    assert checks["static_power"].demanded == pytest.approx(40 / 10.5 / 0.8 * 150)
    sheet = size(HOIST).sheet
    assert sheet.value(f"{DOWN}_static_power") == pytest.approx(1200)
    assert sheet.value(f"{DOWN}_running_power") == pytest.approx(8 * SYNCHRONOUS)


def test_a_motor_without_gear_unit_must_have_the_speed_of_the_load():
    """150 of 15 rad/s."""
    check = calculated(TABLE, drive={"gear_unit": None})[1]["load_speed"]
    assert (check.demanded, check.verdict) == (pytest.approx(9), Verdict.FAILS)
    assert "without a gear unit" in check.name
