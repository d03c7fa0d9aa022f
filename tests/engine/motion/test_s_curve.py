"""The jerk-limited S-curve: that it is one, that it is sampled finely enough, and that it is no trapezoid."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from app.engine.motion.profile import MotionProfile
from app.engine.motion.segments import JERK_STEPS, Burden, Segments
from app.engine.motion.shape import MoveShape, Ramp, Smoothing
from app.engine.motion.solve import Given, Notes, solve_move
from app.engine.sheet import Sheet


def solved(s: float, v: float, a: float, smoothing: Smoothing, d: float | None = None) -> MoveShape:
    move = Given(distance=s, speed=v, acceleration=a, deceleration=d, smoothing=smoothing)
    return solve_move(move, Notes(Sheet()))


def profile(shape: MoveShape, steps: int = JERK_STEPS) -> MotionProfile:
    segments = Segments("linear", steps)
    segments.move(shape, 1.0, Burden(), "move 1")
    return segments.profile()


def exact_acceleration(shape: MoveShape, time: NDArray[np.float64]) -> NDArray[np.float64]:
    """Acceleration over time from the corner points of the seven phases."""
    corners, rates, start = [0.0], [0.0], 0.0
    for ramp, sign in ((shape.up, 1.0), (shape.down, -1.0)):
        end = start + ramp.time
        corners += [start + ramp.jerk_time, end - ramp.jerk_time, end]
        rates += [sign * ramp.acceleration, sign * ramp.acceleration, 0.0]
        start = end + shape.constant_time
        corners.append(start)
        rates.append(0.0)
    return np.interp(time, corners, rates)


# v, a, j = 2, 2, 4: jerk phases of 0.5 s, 0.5 s at 2 m/s2, ramps of 1.5 s and 1.5 m
FULL = {"s": 5.0, "v": 2.0, "a": 2.0}


def test_seven_phases_equal_the_hand_calculation():
    shape = solved(**FULL, smoothing=Smoothing(jerk=4.0))
    assert (shape.up.time, shape.up.jerk_time, shape.up.acceleration) == pytest.approx((1.5, 0.5, 2.0))
    assert shape.constant_time == pytest.approx((5.0 - 2 * 1.5) / 2.0)
    assert shape.time == pytest.approx(4.0)


def test_without_constant_acceleration_the_peak_is_lower():
    # v = 0.25 < a^2/j = 1: a = sqrt(v j) = 1 m/s2, ramps of 2 * 0.25 s and 0.0625 m
    shape = solved(1.0, 0.25, 2.0, Smoothing(jerk=4.0))
    assert (shape.up.time, shape.up.jerk_time, shape.up.acceleration) == pytest.approx((0.5, 0.25, 1.0))
    assert shape.constant_time == pytest.approx((1.0 - 0.125) / 0.25)


def test_without_constant_speed_the_acceleration_limit_is_reached():
    # 3 m with a = 2, j = 4: v/a + a/j = 1.5 s at v = 2; s = 2 * 1.5 = 3 m
    shape = solved(3.0, 9.0, 2.0, Smoothing(jerk=4.0))
    assert (shape.speed, shape.up.time, shape.constant_time) == pytest.approx((2.0, 1.5, 0.0))


def test_without_constant_acceleration_and_constant_speed():
    # s = 2 v sqrt(v/j) with v = 0.25, j = 4: 0.125 m; four phases of 0.25 s
    shape = solved(0.125, 9.0, 2.0, Smoothing(jerk=4.0))
    assert (shape.speed, shape.up.acceleration, shape.time) == pytest.approx((0.25, 1.0, 1.0))


def test_unequal_ramps_without_constant_speed():
    # v = 1, j = 4: up with a = 1 in 1 + 0.25 = 1.25 s; down with 4 -> reached sqrt(4) = 2 in 2 * 0.5 = 1 s; s = 1.125 m
    shape = solved(1.125, 9.0, 1.0, Smoothing(jerk=4.0), d=4.0)
    assert (shape.speed, shape.up.time, shape.down.time) == pytest.approx((1.0, 1.25, 1.0))
    assert shape.down.acceleration == pytest.approx(2.0)


def test_a_share_of_the_ramp_is_a_jerk():
    # half of the ramp in jerk phases: mean 0.75 a, t = 2 / 1.5 = 4/3 s, j = a / (t/4) = 6 m/s3
    shape = solved(**FULL, smoothing=Smoothing(share=0.5))
    assert (shape.up.time, shape.up.jerk_time) == pytest.approx((4 / 3, 1 / 3))
    by_jerk = solved(**FULL, smoothing=Smoothing(jerk=6.0))
    assert (by_jerk.time, by_jerk.up.jerk_time) == pytest.approx((shape.time, shape.up.jerk_time))


def test_an_s_curve_is_no_trapezoid():
    # In the same time over the same distance an S-curve needs a higher peak, at a given peak more time.
    trapezoid = solved(**FULL, smoothing=Smoothing())
    rounded = solved(**FULL, smoothing=Smoothing(jerk=4.0))
    assert rounded.time == pytest.approx(trapezoid.time + 0.5)  # a/j more for both ramps together, half of it each
    in_time = Given(distance=5.0, speed=2.0, time=trapezoid.time, smoothing=Smoothing(jerk=16.0))
    hurried = solve_move(in_time, Notes(Sheet()))
    assert hurried.time == pytest.approx(trapezoid.time)
    # t = 1 s: a^2/16 - a + 2 = 0 has a = 8 - sqrt(32) = 2.343 m/s2
    assert hurried.up.acceleration == pytest.approx(8 - 32**0.5)
    assert effective(profile(hurried)) > 1.02 * effective(profile(trapezoid))


def test_a_high_jerk_gives_the_trapezoid():
    trapezoid, rounded = solved(**FULL, smoothing=Smoothing()), solved(**FULL, smoothing=Smoothing(jerk=1e8))
    assert rounded.time == pytest.approx(trapezoid.time, rel=1e-6)
    assert effective(profile(rounded)) == pytest.approx(effective(profile(trapezoid)), rel=1e-6)


def effective(of: MotionProfile, inertia: float = 1.0, load: float = 0.0) -> float:
    """Effective value of inertia * acceleration + load."""
    force = inertia * of.acceleration + load
    return float(np.sqrt((force**2 * of.duration).sum() / of.cycle_time))


CASES = {
    "seven phases": (5.0, 2.0, 2.0),
    "no constant acceleration": (1.0, 0.25, 2.0),
    "no constant speed": (3.0, 9.0, 2.0),
    "neither": (0.125, 9.0, 2.0),
}


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
@pytest.mark.parametrize("load", [0.0, 1.0, -3.0])
def test_halving_the_step_changes_nothing(case: tuple[float, float, float], load: float):
    shape = solved(*case, Smoothing(jerk=4.0))
    coarse, fine = profile(shape), profile(shape, 2 * JERK_STEPS)
    assert effective(coarse, load=load) == pytest.approx(effective(fine, load=load), rel=1e-3)
    assert np.abs(coarse.acceleration + load).max() == pytest.approx(np.abs(fine.acceleration + load).max(), rel=1e-9)


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_the_sampled_s_curve_keeps_the_exact_effective_acceleration(case: tuple[float, float, float]):
    shape = solved(*case, Smoothing(jerk=4.0))
    # Integral of a squared trapezoid of the height a over t with ramps t_j: a^2 (t - 4/3 t_j)
    exact = sum(r.acceleration**2 * (r.time - 4 / 3 * r.jerk_time) for r in (shape.up, shape.down))
    assert effective(profile(shape)) == pytest.approx((exact / shape.time) ** 0.5, rel=5e-4)


def test_constant_phases_stay_single_segments():
    labels = profile(solved(**FULL, smoothing=Smoothing(jerk=4.0))).label
    assert labels.count("move 1: constant speed") == 1
    assert len(labels) == 2 * (2 * JERK_STEPS + 1) + 1
    assert len(profile(solved(**FULL, smoothing=Smoothing())).label) == 3


def test_steps_follow_the_exact_acceleration_in_their_middle():
    steps = profile(solved(0.125, 9.0, 2.0, Smoothing(jerk=4.0)))
    assert steps.acceleration.max() == pytest.approx(1.0, rel=1e-9)
    assert (steps.acceleration[:JERK_STEPS] > 0).all()


distances, rates = st.floats(0.01, 100.0), st.floats(0.05, 50.0)
smoothings = st.one_of(
    st.floats(0.05, 1.0).map(lambda share: Smoothing(share=share)),
    st.floats(0.1, 1e4).map(lambda jerk: Smoothing(jerk=jerk)),
)


@given(distances, rates, rates, rates, smoothings)
@settings(max_examples=50, deadline=None)
def test_the_course_keeps_every_limit(s: float, v: float, a: float, d: float, smoothing: Smoothing):
    shape = solved(s, v, a, smoothing, d)
    course = profile(shape)
    assert course.position[-1] == pytest.approx(s, rel=1e-9)
    assert course.cycle_time == pytest.approx(shape.time, rel=1e-9)
    assert course.speed_start[0] == course.speed_end[-1] == 0
    assert (course.speed_start[1:] == course.speed_end[:-1]).all()
    assert course.max_speed <= v * (1 + 1e-9)
    assert course.acceleration.max() == pytest.approx(shape.up.acceleration, rel=1e-6)
    assert course.acceleration.min() == pytest.approx(-shape.down.acceleration, rel=1e-6)
    assert shape.up.acceleration <= a * (1 + 1e-9)
    assert shape.down.acceleration <= d * (1 + 1e-9)
    # The exact course: continuous acceleration, whose slope is the jerk.
    for ramp in (shape.up, shape.down):
        assert 2 * ramp.jerk_time <= ramp.time * (1 + 1e-9)
        assert ramp.acceleration * (ramp.time - ramp.jerk_time) == pytest.approx(shape.speed, rel=1e-9)
        if smoothing.jerk is not None:
            assert ramp.acceleration / ramp.jerk_time <= smoothing.jerk * (1 + 1e-9)
        else:
            assert 2 * ramp.jerk_time == pytest.approx((smoothing.share or 0.0) * ramp.time)
    # The steps stay within half a step of the exact course, so they cannot jump like a trapezoid.
    middle = np.cumsum(course.duration) - course.duration / 2
    step = max(r.acceleration for r in (shape.up, shape.down)) / (JERK_STEPS + 0.5)
    assert np.abs(course.acceleration - exact_acceleration(shape, middle)).max() <= 0.6 * step


@given(distances, rates, rates, smoothings)
@settings(max_examples=50, deadline=None)
def test_an_s_curve_takes_longer_than_its_trapezoid(s: float, v: float, a: float, smoothing: Smoothing):
    rounded, trapezoid = solved(s, v, a, smoothing), solved(s, v, a, Smoothing())
    assert rounded.time > trapezoid.time


def test_a_ramp_without_jerk_is_one_step():
    segments = Segments("linear")
    segments.ramp(Ramp(2.0, 1.5), 0.0, 3.0, -1.0, Burden(), "run-up")
    found = segments.profile()
    assert (found.speed_start.tolist(), found.speed_end.tolist()) == ([-0.0], [-3.0])


def test_a_very_weak_jerk_still_gives_the_right_time():
    # jerk 1e-6: no limit is reached, four phases of 0.5 s, v = j t^2 / 16
    shape = solve_move(Given(time=2.0, speed=1.0, acceleration=1e5, smoothing=Smoothing(jerk=1e-6)), Notes(Sheet()))
    assert (shape.time, shape.speed) == pytest.approx((2.0, 0.25e-6))


def test_a_very_sharp_jerk_is_not_blurred_by_rounding():
    course = profile(solved(1204.0, 2.0, 1e-5, Smoothing(jerk=1e6)))
    assert course.acceleration.max() == pytest.approx(1e-5, rel=1e-6)
