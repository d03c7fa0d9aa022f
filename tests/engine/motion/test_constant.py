"""Steady running, with and without starts."""

import pytest

from app.engine.errors import MotionError
from app.engine.motion import ConstantMotion, ConstantRotation, MotionProfile
from app.engine.sheet import Sheet


def solve(**values: object) -> tuple[MotionProfile, Sheet]:
    sheet = Sheet()
    return ConstantMotion.model_validate(values).solve(sheet), sheet


def refused(**values: object) -> tuple[str, str]:
    with pytest.raises(MotionError) as caught:
        solve(**values)
    return caught.value.field, caught.value.message


def test_steady_running_alone_is_one_segment():
    found, _ = solve(speed_m_s=-0.5, payload_kg=50, process_force_n=10)
    assert (found.speed_start[0], found.speed_end[0], found.duration[0]) == (-0.5, -0.5, 1.0)
    assert (found.payload[0], found.process_force[0], found.direction[0]) == (50, 10, -1)
    assert found.label == ("constant speed",)


def test_a_run_up_without_starts_counts_for_the_peak_only():
    # 30 m/min in 0.2 s: 2.5 m/s2
    found, sheet = solve(speed_m_s="30 m/min", run_up_time_s=0.2)
    assert found.acceleration == pytest.approx([2.5, 0.0, -2.5])
    assert found.cycle_time == pytest.approx(3600.0)
    assert sheet.value("run_up_acceleration") == pytest.approx(2.5)
    assert [item.key for item in sheet.assumptions] == ["motion.deceleration", "motion.starts_per_hour"]


def test_starts_per_hour_set_the_cycle():
    # every 60 s: 1 s up, 0.5 s down
    found, _ = solve(speed_m_s=1, acceleration_m_s2=1, deceleration_m_s2=2, starts_per_hour=60)
    assert found.duration == pytest.approx([1.0, 58.5, 0.5])
    assert found.speed_end[-1] == 0
    found, sheet = solve(speed_m_s=1, acceleration_m_s2=1, duration_s=10, starts_per_hour=60, hold="brake")
    assert found.duration == pytest.approx([1.0, 10.0, 1.0, 48.0])
    assert found.braked.tolist() == [False, False, False, True]
    assert sheet.value("cycle_time") == pytest.approx(60.0)


def test_a_running_time_without_starts_is_the_whole_cycle():
    found, _ = solve(speed_m_s=1, acceleration_m_s2=1, duration_s=10)
    assert found.duration == pytest.approx([1.0, 10.0, 1.0])


def test_rotation_is_in_rpm():
    # 60 rpm = 2 pi rad/s
    motion = ConstantRotation.model_validate({"speed_rpm": 60, "payload_inertia_kgm2": 2, "process_torque_nm": 5})
    found = motion.solve(Sheet())
    assert (found.kind, found.speed_start[0]) == ("rotary", pytest.approx(6.283185307179586))
    assert (found.payload[0], found.process_force[0]) == (2, 5)


@pytest.mark.parametrize(
    ("values", "expected"),
    [
        ({"speed_m_s": 0}, ("speed_m_s", "a steady motion needs a speed other than zero")),
        (
            {"speed_m_s": 1, "acceleration_m_s2": 1, "run_up_time_s": 1},
            ("run_up_time_s", "give either a run-up time or an acceleration"),
        ),
        (
            {"speed_m_s": 1, "starts_per_hour": 1},
            ("acceleration_m_s2", "starts need an acceleration or a run-up time"),
        ),
        (
            {"speed_m_s": 1, "acceleration_m_s2": 1, "starts_per_hour": 1800},
            ("starts_per_hour", "a start every 2 s is too often: running up, running and running down take 2 s"),
        ),
        (
            {"speed_m_s": 1, "acceleration_m_s2": 1, "duration_s": 59, "starts_per_hour": 60},
            ("starts_per_hour", "a start every 60 s is too often: running up, running and running down take 61 s"),
        ),
    ],
)
def test_what_cannot_be_is_refused(values: dict[str, object], expected: tuple[str, str]):
    assert refused(**values) == expected
