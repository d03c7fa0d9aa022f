"""Limit curves of a servo motor from what the data sheet says."""

import numpy as np
import pytest

from app.engine.drives.limits import ContinuousLimits, ServoLimits
from app.engine.sheet import Sheet
from tests.engine.drives.cases import motor


def assumed(limits: ServoLimits) -> set[str]:
    sheet = Sheet()
    limits.assume(sheet)
    return {one.key.rsplit(".", 1)[-1] for one in sheet.assumptions}


def test_straight_line_up_to_rated_speed():
    limits = ServoLimits(motor())  # 10 N m, 8 N m at 300 rad/s
    assert limits.continuous(0.0) == pytest.approx(10)
    assert limits.continuous(150.0) == pytest.approx(9)
    assert limits.continuous(300.0) == pytest.approx(8)
    assert "continuous_curve" in assumed(limits)


def test_above_rated_speed_the_lower_of_line_and_constant_power_counts():
    flat = ServoLimits(motor(stall_torque=8.2))  # line at 400: 8.2 - 0.2 * 4 / 3 = 7.93; power: 8 * 300 / 400 = 6
    assert flat.continuous(400.0) == pytest.approx(6)
    steep = ServoLimits(motor(stall_torque=20.0))  # line at 400: 20 - 12 * 4 / 3 = 4
    assert steep.continuous(400.0) == pytest.approx(4)
    assert "field_weakening" in assumed(steep)


def test_beyond_the_highest_speed_the_last_value_stays():
    assert ServoLimits(motor()).continuous(900.0) == ServoLimits(motor()).continuous(400.0)
    short = ServoLimits(motor(max_speed=None))
    assert short.continuous(900.0) == pytest.approx(8)
    assert "max_speed" in assumed(short)


def test_without_stall_torque_the_rated_torque_holds_from_standstill():
    limits = ServoLimits(motor(stall_torque=None))
    assert limits.continuous(0.0) == 8
    assert "stall_torque" in assumed(limits)


def test_what_is_missing_is_said():
    assert ServoLimits(motor(rated_torque=None)).continuous_missing == "rated torque and rated speed of the motor"
    assert ServoLimits(motor(peak_torque=None)).peak_missing == "peak torque of the motor"
    with pytest.raises(ValueError, match="rated torque"):
        ServoLimits(motor(rated_torque=None)).continuous(10.0)
    with pytest.raises(ValueError, match="peak torque"):
        ServoLimits(motor(peak_torque=None)).peak(10.0)


def test_given_curves_are_read_between_their_points():
    curved = ServoLimits(
        motor(continuous_curve=((0.0, 10.0), (100.0, 6.0)), peak_curve=((50.0, 30.0), (150.0, 20.0)), max_speed=None)
    )
    assert curved.continuous(25.0) == pytest.approx(9)
    assert curved.peak(100.0) == pytest.approx(25)
    assert curved.peak(0.0) == 30  # flat before the first point
    sheet = Sheet()
    assert curved.record_continuous(sheet, 25.0, key="s1", label="S1") == pytest.approx(9)
    assert curved.record_continuous(sheet, 500.0, key="end", label="S1") == pytest.approx(6)
    assert assumed(curved).isdisjoint({"continuous_curve", "peak_curve"})


def test_many_motors_equal_one_at_a_time():
    motors = [
        motor(),
        motor(stall_torque=None),
        motor(rated_torque=None),
        motor(max_speed=None),
        motor(continuous_curve=((0.0, 10.0), (100.0, 6.0))),
    ]
    limits = [ServoLimits(one) for one in motors]
    speeds = np.array([0.0, 100.0, 300.0, 350.0, 1000.0])
    table = ContinuousLimits.of(limits).table(speeds)
    for row, limit in enumerate(limits):
        for column, speed in enumerate(speeds):
            if limit.continuous_missing:
                assert np.isnan(table[row, column]) == (speed > 0)  # at standstill the stall torque is known
            else:
                assert table[row, column] == limit.continuous(float(speed))


def test_chart_lines_end_at_the_highest_speed():
    limits = ServoLimits(motor())
    line = limits.continuous_points()
    assert line[0] == (0.0, 10.0)
    assert line[-1] == pytest.approx((400.0, 6.0))
    assert limits.peak_points() == ((0.0, 30.0), (400.0, 30.0))
    assert ServoLimits(motor(rated_torque=None)).continuous_points() == ()
