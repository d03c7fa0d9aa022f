"""Sums and hull of a load cycle against plain loops over its segments."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.engine.cycle import CycleHull, LoadCycle, hull_vertices, upper_envelope
from tests.engine.drives.cases import cycle, cycles

BOUNDED = settings(max_examples=50, deadline=None)


def split(whole: LoadCycle, at: float) -> LoadCycle:
    """Every segment cut in two at the share ``at`` of its duration."""
    middle = whole.speed_start + at * (whole.speed_end - whole.speed_start)

    def twice(first: np.ndarray, second: np.ndarray) -> np.ndarray:
        return np.column_stack((first, second)).ravel()

    return replace(
        whole,
        duration=twice(at * whole.duration, (1 - at) * whole.duration),
        speed_start=twice(whole.speed_start, middle),
        speed_end=twice(middle, whole.speed_end),
        torque=np.repeat(whole.torque, 2),
        braked=np.repeat(whole.braked, 2),
        label=tuple(label for label in whole.label for _ in range(2)),
    )


def test_sums_equal_a_hand_calculation():
    # driving: T = 4, alpha = 2 for 3 s; returning: T = -1, alpha = -3 for 2 s; held: T = 5 for 1 s; braked 4 s
    sums = cycle((3, 0, 6, 4, False), (2, 6, 0, -1, False), (1, 0, 0, 5, False), (4, 0, 0, 0, True)).sums
    assert sums.driving_torque2 == pytest.approx(48)  # 16 * 3
    assert sums.returning_torque2 == pytest.approx(2)  # 1 * 2
    assert sums.holding_torque2 == pytest.approx(25)
    assert sums.driving_torque_alpha == pytest.approx(24)  # 4 * 2 * 3
    assert sums.returning_torque_alpha == pytest.approx(6)  # -1 * -3 * 2
    assert sums.alpha2 == pytest.approx(30)  # 4 * 3 + 9 * 2
    assert sums.angle == pytest.approx(15)  # 9 rad + 6 rad
    assert sums.torque3_angle == pytest.approx(582)  # 64 * 9 + 1 * 6
    assert sums.time == pytest.approx(10)


def test_a_closed_brake_leaves_no_torque_in_the_sums():
    braked = cycle((1, 0, 0, 7, True))  # a torque in a braked segment is carried by the brake
    assert braked.sums.holding_torque2 == 0
    assert braked.hull.max_torque == 0


@BOUNDED
@given(cycles(), st.floats(0.1, 0.9))
def test_splitting_a_segment_changes_nothing(whole: LoadCycle, at: float):
    one, two = whole.sums, split(whole, at).sums
    for name in one.__dataclass_fields__:
        assert getattr(two, name) == pytest.approx(getattr(one, name), rel=1e-9, abs=1e-9), name


@BOUNDED
@given(cycles(), st.floats(0.5, 100), st.floats(0.1, 1), st.floats(0.1, 1), st.floats(0, 0.1))
def test_effective_torque_of_any_drive_follows_from_the_sums(
    whole: LoadCycle, ratio: float, eta: float, back: float, inertia: float
):
    scalar = 0.0
    for k in range(whole.duration.size):
        if whole.braked[k]:
            continue
        power = whole.torque[k] * (whole.speed_start[k] + whole.speed_end[k])
        factor = 1 / eta if power > 0 else back if power < 0 else 1.0
        alpha = (whole.speed_end[k] - whole.speed_start[k]) / whole.duration[k]
        scalar += (whole.torque[k] / ratio * factor + inertia * ratio * alpha) ** 2 * whole.duration[k]
    sums, q = whole.sums, inertia * ratio
    p = {1: 1 / (eta * ratio), -1: back / ratio, 0: 1 / ratio}
    from_sums = (
        p[1] ** 2 * sums.driving_torque2 + p[-1] ** 2 * sums.returning_torque2 + p[0] ** 2 * sums.holding_torque2
        + 2 * q * (p[1] * sums.driving_torque_alpha + p[-1] * sums.returning_torque_alpha) + q**2 * sums.alpha2
    )  # fmt: skip
    scale = max(p.values()) ** 2 * 2500 * whole.cycle_time + q**2 * sums.alpha2
    assert from_sums == pytest.approx(scalar, rel=1e-9, abs=1e-12 * scale)


@BOUNDED
@given(cycles(), cycles(), st.floats(0.5, 100), st.floats(0.1, 1), st.floats(0, 1), st.floats(0, 0.1))
def test_envelopes_equal_a_search_over_all_segments(
    first: LoadCycle, second: LoadCycle, ratio: float, eta: float, back: float, inertia: float
):
    p = {1: 1 / (eta * ratio), -1: back / ratio, 0: 1 / ratio}
    q = inertia * ratio
    largest = 0.0
    for whole in (first, second):
        for k in np.flatnonzero(~whole.braked):
            factor = p[int(whole.power_direction[k])]
            largest = max(largest, abs(factor * whole.torque[k] + q * whole.acceleration[k]))
    envelopes = CycleHull((first, second)).envelopes
    assert max(float(envelopes[s].peak(p[s], q)) for s in p) == pytest.approx(largest, rel=1e-9, abs=1e-12)


@pytest.mark.parametrize("shape", ["cloud", "ellipse", "line", "one direction"])
def test_envelope_of_many_points_equals_the_points(shape: str):
    random = np.random.default_rng(5)
    angle = np.linspace(0, 2 * np.pi, 3000)
    x, y = {
        "cloud": (random.normal(size=3000), random.normal(size=3000)),
        "ellipse": (3 * np.cos(angle) + 1, np.sin(angle)),
        "line": (2 * np.cos(angle) + 1, np.cos(angle)),
        "one direction": (np.full(3000, -2.0), angle),
    }[shape]
    envelope = upper_envelope(x, y)
    p, q = random.uniform(0, 1, 40), random.uniform(0, 1, 40)
    brute = np.abs(p[:, None] * x + q[:, None] * y).max(axis=1)
    np.testing.assert_allclose(envelope.peak(p, q), brute, rtol=1e-12)
    assert shape != "cloud" or envelope.torque.size < 30
    assert shape != "line" or envelope.torque.size <= 2


@BOUNDED
@given(
    st.lists(st.tuples(*[st.floats(-9, 9).map(lambda v: round(v, 2))] * 3), min_size=1, max_size=30),
    st.sampled_from(["solid", "plane", "line"]),
)
def test_hull_corners_are_enough_for_every_direction(points: list[tuple[float, float, float]], shape: str):
    cloud = np.array(points)
    if shape == "plane":
        cloud[:, 2] = 2 * cloud[:, 0] - cloud[:, 1]
    if shape == "line":
        cloud = cloud[:, :1] * np.array([[1.0, -2.0, 0.5]])
    corners = cloud[hull_vertices(cloud)]
    directions = np.random.default_rng(2).normal(size=(60, 3))
    np.testing.assert_allclose(
        (corners @ directions.T).max(axis=0), (cloud @ directions.T).max(axis=0), rtol=1e-9, atol=1e-9
    )


def test_hull_of_a_large_cloud_is_small():
    cloud = np.random.default_rng(3).uniform(-1, 1, (4000, 3))
    assert hull_vertices(cloud).size < 400


def test_points_carry_both_ends_of_a_segment():
    hull = cycle((1, 2, 6, 3, False), (1, 6, 2, -3, False)).hull
    assert hull.points[1].tolist() == [[3, 4, 2], [3, 4, 6]]
    assert hull.points[-1].tolist() == [[-3, -4, 2], [-3, -4, 6]]
    assert hull.max_speed == 6
    assert hull.max_acceleration == 4
