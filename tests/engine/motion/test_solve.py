"""One move from every sufficient subset, the choices of what shall be least, and what is refused."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.engine.errors import MotionError
from app.engine.motion.shape import MoveShape, Smoothing, minimum_of, root
from app.engine.motion.solve import Given, Notes, solve_move
from app.engine.sheet import Sheet


def solved(**values: object) -> MoveShape:
    return solve_move(Given(**values), Notes(Sheet()))  # type: ignore[arg-type]


def refused(**values: object) -> tuple[str, str]:
    with pytest.raises(MotionError) as caught:
        solved(**values)
    return caught.value.field, caught.value.message


# By hand: 0.5 s to reach 0.5 m/s with 1 m/s2 (0.125 m), the same to brake, 0.75 m at 0.5 m/s in 1.5 s; 2.5 s in all.
FULL = {"distance": 1.0, "time": 2.5, "speed": 0.5, "acceleration": 1.0}


@pytest.mark.parametrize("missing", [None, "distance", "time", "speed", "acceleration"])
def test_any_three_of_four_give_the_move(missing: str | None):
    shape = solved(**{name: value for name, value in FULL.items() if name != missing})
    assert shape.distance == pytest.approx(1.0, rel=1e-12)
    assert shape.speed == pytest.approx(0.5, rel=1e-12)
    assert shape.time == pytest.approx(2.5, rel=1e-12)
    assert shape.constant_time == pytest.approx(1.5, rel=1e-12)
    assert (shape.up.acceleration, shape.down.acceleration) == pytest.approx((1.0, 1.0), rel=1e-12)


# By hand: up 1 m/s in 1 s (0.5 m), down with 2 m/s2 in 0.5 s (0.25 m), 1.25 m at 1 m/s in 1.25 s; 2 m in 2.75 s.
UNEQUAL = {"distance": 2.0, "time": 2.75, "speed": 1.0, "acceleration": 1.0}


@pytest.mark.parametrize("braking", [{"deceleration": 2.0}, {"ratio": 2.0}], ids=["deceleration", "ratio"])
@pytest.mark.parametrize("missing", ["distance", "time", "speed", "acceleration"])
def test_braking_may_differ_from_accelerating(missing: str, braking: dict[str, float]):
    shape = solved(**{name: value for name, value in UNEQUAL.items() if name != missing}, **braking)
    assert shape.distance == pytest.approx(2.0, rel=1e-12)
    assert shape.speed == pytest.approx(1.0, rel=1e-12)
    assert (shape.up.time, shape.constant_time, shape.down.time) == pytest.approx((1.0, 1.25, 0.5), rel=1e-12)
    assert (shape.up.acceleration, shape.down.acceleration) == pytest.approx((1.0, 2.0), rel=1e-12)


def test_the_speed_of_the_handbook_move_is_the_smaller_root():
    # SEW 2001, 8.4: 10 m in 14.5 s with 0.5 m/s2; (7.25 - sqrt(7.25**2 - 20)) / 2 = 0.77182 m/s, ramps of 1.54 s
    shape = solved(distance=10.0, time=14.5, acceleration=0.5, optimise="least_speed")
    assert shape.speed == pytest.approx((7.25 - 32.5625**0.5) / 2, rel=1e-12)
    assert shape.up.time == pytest.approx(1.5436, rel=1e-4)


def test_a_speed_that_is_not_reached_gives_a_triangle_and_says_so():
    # 2 m with 2 m/s2: sqrt(2 * 2) = 2 m/s after 1 m, 2 s in all
    sheet = Sheet()
    shape = solve_move(Given(distance=2.0, speed=5.0, acceleration=2.0), Notes(sheet))
    assert (shape.speed, shape.constant_time, shape.time) == pytest.approx((2.0, 0.0, 2.0))
    assert sheet.value("move_1_speed") == pytest.approx(2.0)
    assert sheet.decisions[0].text == "Triangle: 5 m/s is not reached"


def test_a_time_too_short_for_the_speed_gives_a_triangle():
    # 2 s with 2 m/s2: 1 s up to 2 m/s, 1 s down; 2 m
    shape = solved(time=2.0, speed=5.0, acceleration=2.0)
    assert (shape.distance, shape.speed, shape.constant_time) == pytest.approx((2.0, 2.0, 0.0))


def test_least_acceleration_is_a_triangle():
    # a = 4 s / t^2 = 4 * 1 / 4 = 1 m/s2, v = 2 s / t = 1 m/s
    shape = solved(distance=1.0, time=2.0, optimise="least_acceleration")
    assert (shape.speed, shape.up.acceleration, shape.constant_time) == pytest.approx((1.0, 1.0, 0.0))


def test_least_acceleration_under_a_speed_limit_keeps_the_limit():
    # 1 m in 2 s at 0.75 m/s: t - s/v = 2/3 s per ramp, a = 0.75 / (2/3) = 1.125 m/s2
    shape = solved(distance=1.0, time=2.0, speed=0.75, optimise="least_acceleration")
    assert (shape.speed, shape.up.acceleration) == pytest.approx((0.75, 1.125))
    assert solved(distance=1.0, time=2.0, speed=3.0, optimise="least_acceleration").speed == pytest.approx(1.0)


def test_least_effective_acceleration_is_thirds():
    # v = 1.5 s / t = 0.5 m/s for 1 m in 3 s; one second each
    shape = solved(distance=1.0, time=3.0, optimise="least_effective_acceleration")
    assert (shape.up.time, shape.constant_time, shape.down.time) == pytest.approx((1.0, 1.0, 1.0))


def test_least_time_is_a_triangle():
    shape = solved(distance=2.0, acceleration=2.0, optimise="least_time")
    assert (shape.speed, shape.time) == pytest.approx((2.0, 2.0))


SMOOTHINGS = {"trapezoid": Smoothing(), "share": Smoothing(share=0.6), "jerk": Smoothing(jerk=30.0)}


def effective_square(shape: MoveShape, smoothing: Smoothing) -> float:
    """Integral of the squared acceleration by sampling, not by the engine's formula."""
    total, steps = 0.0, 2000
    for ramp in (shape.up, shape.down):
        for k in range(steps):
            t = (k + 0.5) / steps * ramp.time
            near = min(t, ramp.time - t)
            share = 1.0 if near >= ramp.jerk_time else near / ramp.jerk_time
            total += (ramp.acceleration * share) ** 2 * ramp.time / steps
    return total


@pytest.mark.parametrize("smoothing", SMOOTHINGS.values(), ids=SMOOTHINGS)
@pytest.mark.parametrize("braking", [{}, {"ratio": 0.5}, {"deceleration": 4.0}], ids=["equal", "ratio", "given"])
@pytest.mark.parametrize("choice", ["least_acceleration", "least_effective_acceleration"])
def test_no_other_speed_is_better(choice: str, braking: dict[str, float], smoothing: Smoothing):
    known = {"distance": 1.0, "time": 2.0, "smoothing": smoothing, **braking}
    best = solved(**known, optimise=choice)
    assert best.time == pytest.approx(2.0, rel=1e-9)
    assert best.speed * (best.up.time / 2 + best.constant_time + best.down.time / 2) == pytest.approx(1.0, rel=1e-9)

    def cost(shape: MoveShape) -> float:
        return shape.up.acceleration if choice == "least_acceleration" else effective_square(shape, smoothing)

    tried = 0
    for k in range(1, 100):  # brute force over the possible peak speeds s/t ... 2 s/t
        try:
            other = solved(**known, speed=0.5 + k * 0.005)
        except MotionError:
            continue
        tried += 1
        assert cost(other) >= cost(best) * (1 - 1e-5)
    assert tried > 20


@pytest.mark.parametrize("smoothing", SMOOTHINGS.values(), ids=SMOOTHINGS)
def test_no_lower_speed_is_possible(smoothing: Smoothing):
    best = solved(distance=1.0, time=2.0, acceleration=4.0, smoothing=smoothing, optimise="least_speed")
    assert best.time == pytest.approx(2.0)
    for share in (0.3, 0.6, 0.9, 0.99, 0.9999):
        slower = solved(distance=1.0, speed=best.speed * share, acceleration=4.0, smoothing=smoothing)
        assert slower.time > 2.0


REFUSED = [
    (
        {"distance": 3.0, "time": 4.0, "acceleration": 0.5},
        ("distance", "0.5 m/s2 for 4 s covers at most 2 m, not 3 m"),
    ),
    (
        {"distance": 3.0, "time": 4.0, "acceleration": 0.5, "deceleration": 1.0},
        ("distance", "0.5 m/s2 and braking with 1 m/s2 for 4 s covers at most 2.66667 m, not 3 m"),
    ),
    (
        {"distance": 3.0, "time": 4.0, "acceleration": 0.5, "settling": 0.5},
        ("distance", "0.5 m/s2 for 4 s (settling of 0.5 s taken off) covers at most 2 m, not 3 m"),
    ),
    (  # jerk 0.5: 0.5 m/s after 2 s without constant acceleration, triangle of 4 s and 0.5 m/s
        {"distance": 3.0, "time": 4.0, "acceleration": 0.5, "smoothing": Smoothing(jerk=0.5)},
        ("distance", "0.5 m/s2, limited to 0.5 m/s3, for 4 s covers at most 1 m, not 3 m"),
    ),
    (
        {"distance": 1.0, "time": 1.5, "speed": 0.5},
        ("time", "1 m at 0.5 m/s takes more than 2 s even without accelerating, not 1.5 s"),
    ),
    (
        {"distance": 1.0, "time": 5.0, "speed": 0.5},
        ("speed", "1 m in 5 s needs at most 0.4 m/s, the peak of a triangle, not 0.5 m/s; "
         "choose the least acceleration to take the speed as a limit"),
    ),
    (
        {"distance": 1.0, "time": 2.5, "speed": 0.5, "deceleration": 0.4},
        ("deceleration", "braking from 0.5 m/s with 0.4 m/s2 leaves no time to accelerate"),
    ),
    (  # 0.5 s per ramp: 4 v / t^2 = 8 m/s3
        {"distance": 1.0, "time": 2.5, "speed": 0.5, "smoothing": Smoothing(jerk=5.0)},
        ("jerk", "0.5 m/s within 0.5 s needs a jerk of at least 8 m/s3, not 5 m/s3"),
    ),
    (
        {"distance": 1.0, "time": 3.0, "speed": 0.5, "acceleration": 1.0},
        ("time", "1 m with 0.5 m/s and 1 m/s2 takes 2.5 s, not 3 s"),
    ),
    (
        {"distance": 1.0, "time": 2.0},
        ("optimise", "distance and time do not determine the move: give a speed or an acceleration, or choose what "
         "shall be least: the acceleration or the effective acceleration"),
    ),
    (
        {"distance": 1.0, "acceleration": 2.0},
        ("speed", "distance and acceleration do not determine the move: give a speed or a time, or choose the "
         "least time"),
    ),
    (
        {"distance": 1.0},
        ("time", "distance alone does not determine the move: give three of distance, time, speed and acceleration"),
    ),
    (
        {},
        ("distance", "none of them do not determine the move: give three of distance, time, speed and acceleration"),
    ),
    (
        {"distance": 1.0, "time": 2.0, "optimise": "least_speed"},
        ("optimise", "least speed is sought from a distance, a time and an acceleration, and no speed; given: distance "
         "and time"),
    ),
    (
        {**FULL, "optimise": "least_acceleration"},
        ("optimise", "least acceleration is sought from a distance and a time, and no acceleration (a speed counts as "
         "its limit); given: distance, time, speed and acceleration"),
    ),
]  # fmt: skip


@pytest.mark.parametrize(("values", "expected"), REFUSED)
def test_a_move_that_cannot_be_is_refused_with_the_reason(values: dict[str, object], expected: tuple[str, str]):
    assert refused(**values) == expected


def test_a_rotary_move_is_refused_in_rotary_units():
    # 2 pi rad in 1 s with 1 rad/s2: at most 0.25 rad = 14.3239 deg
    with pytest.raises(MotionError) as caught:
        solve_move(Given(distance=6.283185307179586, time=1.0, acceleration=1.0), Notes(Sheet(), kind="rotary"))
    assert caught.value.message == "1 rad/s2 for 1 s covers at most 14.3239 deg, not 360 deg"


def test_four_values_typed_with_three_digits_agree():
    assert solved(distance=10.0, time=14.5, speed=0.772, acceleration=0.5).speed == 0.772


values = st.floats(0.01, 100.0)
smoothings = st.one_of(
    st.just(Smoothing()),
    st.floats(0.01, 1.0).map(lambda share: Smoothing(share=share)),
    st.floats(0.1, 1e4).map(lambda jerk: Smoothing(jerk=jerk)),
)


@given(values, values, values, values, smoothings)
@settings(max_examples=50, deadline=None)
def test_what_is_found_gives_the_same_move_when_given(s: float, v: float, a: float, d: float, smoothing: Smoothing):
    shape = solved(distance=s, speed=v, acceleration=a, deceleration=d, smoothing=smoothing)
    assert shape.speed <= v * (1 + 1e-9)
    assert shape.up.acceleration <= a * (1 + 1e-9)
    assert shape.down.acceleration <= d * (1 + 1e-9)
    covered = shape.speed * (shape.up.time / 2 + shape.constant_time + shape.down.time / 2)
    assert covered == pytest.approx(s, rel=1e-9)
    # A hair longer, so that rounding does not turn the shortest possible time into an impossible one.
    again = solved(distance=s, time=shape.motion_time * (1 + 1e-9), acceleration=a, deceleration=d, smoothing=smoothing)
    assert again.speed == pytest.approx(shape.speed, rel=1e-3)
    assert again.motion_time == pytest.approx(shape.motion_time, rel=1e-8)
    by_time = solved(time=shape.motion_time, speed=shape.speed, acceleration=a, deceleration=d, smoothing=smoothing)
    assert by_time.distance == pytest.approx(s, rel=1e-9)


def test_the_root_is_found_to_rounding():
    assert root(lambda x: x**3 - 2, 0.0, 2.0) == pytest.approx(2 ** (1 / 3), rel=1e-14)
    assert root(lambda x: 1 / x - 4, 1e-9, 1e3) == pytest.approx(0.25, rel=1e-13)
    assert root(lambda x: x - 1, 1.0, 2.0) == 1.0


def test_the_minimum_is_found_beside_infinite_values():
    found = minimum_of(lambda x: (x - 0.3) ** 2 if x > 0.2 else float("inf"), 0.0, 1.0)
    assert found == pytest.approx(0.3, abs=1e-6)
