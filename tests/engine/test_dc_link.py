"""Several axes on one DC link: sums on a common time axis, time of returning, and the worst phase between them."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.engine.dc_link import (
    AxisPower,
    common_cycles,
    net_segments,
    power_diagram,
    returning_time,
    worst_phase,
)


def axis(*rows: tuple[float, float, float], name: str = "axis", shift: float = 0.0) -> AxisPower:
    """Segments as (duration, power at start, power at end)."""
    width, start, end = (np.array(column, dtype=float) for column in zip(*rows, strict=True))
    time = np.concatenate(([0.0], np.cumsum(width)))
    ramp = tuple(bool(one < 0) for one in end)
    return AxisPower(name, time, start, end, ("phase",) * len(rows), ramp, shift)


def peak(axes: list[AxisPower]) -> float:
    """Largest power of all axes as they are."""
    return max(max(one.start, one.end) for one in net_segments(axes))


def energy(axes: list[AxisPower]) -> float:
    """Net energy of a cycle."""
    return sum((one.start + one.end) / 2 * one.duration for one in net_segments(axes))


TRAVEL = axis((1, 0, 900), (2, 300, 300), (1, -400, 0), (4, 0, 0), name="travel")
"""8 s: accelerating to 900 W, 300 W at speed, 400 W returned while braking."""


@st.composite
def axes_of_8_s(draw: st.DrawFn, least: int = 2, most: int = 3, *, falling: bool = False) -> list[AxisPower]:
    """Axes as drives make them: in each segment power of one sign, driving it rises or stays unless ``falling``."""
    found = []
    for number in range(draw(st.integers(least, most))):
        widths = draw(st.lists(st.integers(1, 20), min_size=2, max_size=6))
        rows = []
        for width in widths:
            low, high = sorted(draw(st.tuples(st.integers(0, 2000), st.integers(0, 2000))))
            kinds = [(low, high), (high, high), (-high, -low), (0, 0), *([(high, low)] if falling else [])]
            rows.append((8 * width / sum(widths), *draw(st.sampled_from(kinds))))
        shift = draw(st.integers(0, 799)) / 100
        found.append(axis(*rows, name=f"axis {number}", shift=shift))
    return found


# --- sums -------------------------------------------------------------------------------------------------------------


def test_what_one_axis_returns_the_other_takes():
    """The second starts 3 s later: while the first returns 400 W falling, it takes 900 W rising."""
    net = net_segments([TRAVEL, replace(TRAVEL, shift=3.0)])
    shown = [(one.duration, one.start, one.end) for one in net]
    expected = [(1, 0, 900), (2, 300, 300), (1, -400, 900), (2, 300, 300), (1, -400, 0), (1, 0, 0)]
    assert np.array(shown) == pytest.approx(np.array(expected), abs=1e-2)


def test_a_shift_beyond_the_cycle_comes_round():
    here, there = (net_segments([TRAVEL, replace(TRAVEL, shift=shift)]) for shift in (3.0, 11.0))
    assert [(one.duration, one.start, one.end) for one in here] == [
        pytest.approx((one.duration, one.start, one.end)) for one in there
    ]


def test_power_at_a_moment_follows_the_shift():
    """900 W * 0.25 a quarter of a second after the start; the standstill before it."""
    late = replace(TRAVEL, shift=3.0)
    assert late.at(np.array([3.25, 2.5, 6.5])) == pytest.approx([225, 0, -200])
    assert TRAVEL.at(np.array([0.25, 8.25])) == pytest.approx([225, 225])


@given(axes=axes_of_8_s(falling=True))
def test_phases_change_the_power_but_not_the_energy(axes: list[AxisPower]):
    alone = sum((one.start + one.end) / 2 * one.duration for each in axes for one in each.segments())
    scale = max(1.0, *(float(np.abs(np.concatenate([each.start, each.end])).max()) for each in axes)) * 8 * len(axes)
    assert energy(axes) == pytest.approx(alone, abs=1e-5 * scale)
    assert sum(one.duration for one in net_segments(axes)) == pytest.approx(8)


def test_segments_carry_their_axis():
    (first, *_, last) = TRAVEL.segments()
    assert (first.label, first.duration, first.start, first.end, first.ramp) == ("travel: phase", 1, 0, 900, False)
    assert last.duration == 4
    assert [one.ramp for one in axis((1, 0, 1), (1, -2, -1)).segments()] == [False, True]


# --- time axis --------------------------------------------------------------------------------------------------------


def test_shorter_cycles_are_repeated_over_the_longest():
    short, medium, long = axis((1, 0, 100), (1, 0, 0)), axis((3, 50, 50)), axis((12, 10, 10), name="long")
    found = common_cycles([short, medium, long])
    assert found is not None
    assert [one.cycle_time for one in found] == pytest.approx([12, 12, 12])
    assert [len(one.start) for one in found] == [12, 4, 1]
    assert found[0].at(np.array([0.5, 2.5, 10.5, 11.5])) == pytest.approx([50, 50, 50, 0])
    assert found[2] is long


@pytest.mark.parametrize("cycle_time", [7.0, 5.0, 7.9, 3.0])
def test_cycles_that_never_meet_have_no_common_one(cycle_time: float):
    assert common_cycles([TRAVEL, axis((cycle_time, 100, 100))]) is None


def test_a_rounded_cycle_time_is_still_a_whole_part():
    """8 s and three times 2.666667 s."""
    found = common_cycles([TRAVEL, axis((2.666667, 100, 100))])
    assert found is not None
    assert len(found[1].start) == 3


def test_a_repeated_axis_keeps_its_shift():
    found = common_cycles([axis((16, 0, 0)), replace(TRAVEL, shift=3.0)])
    assert found is not None
    assert found[1].at(np.array([3.5, 11.5])) == pytest.approx([450, 450])


# --- returning --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("shift", "time"), [(0.0, 1.0), (0.5, 1.5), (1.0, 2.0), (4.0, 2.0), (7.25, 1.75)])
def test_time_in_which_both_return_counts_once(shift: float, time: float):
    """Each returns for 1 s, from 3 to 4 s after its start."""
    assert returning_time([TRAVEL, replace(TRAVEL, shift=shift)]) == pytest.approx(time)


def test_without_returning_there_is_no_time():
    assert returning_time([axis((8, 0, 100)), axis((8, 0, 0))]) == 0


@given(axes=axes_of_8_s())
def test_time_of_returning_lies_between_the_longest_and_the_sum(axes: list[AxisPower]):
    alone = [sum(one.duration for one in each.segments() if min(one.start, one.end) < 0) for each in axes]
    found = returning_time(axes)
    assert max(alone) - 1e-9 <= found <= min(sum(alone), 8) + 1e-9


# --- the worst phase --------------------------------------------------------------------------------------------------


def test_in_the_worst_phase_all_peaks_meet():
    """900 W after 1 s and 700 W after 5.317 s: the second 4.317 s earlier, or 3.683 s later."""
    other = axis((5, 0, 0), (0.317, 0, 700), (2.683, 0, 0), name="hoist")
    placed, found = worst_phase([TRAVEL, other])
    assert found == pytest.approx(1600, rel=1e-5)
    assert placed[0] is TRAVEL
    assert placed[1].shift == pytest.approx(3.683)
    assert peak([TRAVEL, other]) == pytest.approx(900, rel=1e-5)


def test_the_first_axis_stays_where_it_is():
    late = replace(TRAVEL, shift=2.0)
    placed, _ = worst_phase([late, TRAVEL])
    assert [one.shift for one in placed] == pytest.approx([2, 2])


@given(axes=axes_of_8_s(most=6, falling=True))
def test_in_the_worst_phase_the_peaks_of_all_axes_meet(axes: list[AxisPower]):
    """Axes that can start at any time meet with all their peaks at once, and never with more; the shifts show it."""
    placed, found = worst_phase(axes)
    most = sum(max(float(one.start.max()), float(one.end.max())) for one in axes)
    assert found == pytest.approx(most, rel=1e-9, abs=1e-6)
    assert found >= peak(axes) - 1e-6 * 2000 * len(axes)
    assert peak(placed) == pytest.approx(found, rel=1e-4, abs=0.1)


@settings(max_examples=20)
@given(axes=axes_of_8_s(most=2, falling=True), shift=st.floats(0, 8))
def test_no_other_phase_of_two_axes_takes_more(axes: list[AxisPower], shift: float):
    _, found = worst_phase(axes)
    assert peak([axes[0], replace(axes[1], shift=shift)]) <= found + 1e-3


def test_short_peaks_that_fall_at_once_meet_too():
    """Both have 1000 W for a moment, 1.01 s after 600 W in one and 3.03 s in the other; as given they meet: 2000 W."""
    here = axis((1, 600, 600), (1, 0, 0), (0.01, 1000, 500), (7.99, 0, 0))
    there = axis((1, 600, 600), (3.02, 0, 0), (0.01, 1000, 500), (5.97, 0, 0), shift=7.98)
    assert peak([here, there]) == pytest.approx(2000, rel=1e-3)
    placed, found = worst_phase([here, there])
    assert found == pytest.approx(2000)
    assert [one.shift for one in placed] == [0, 7.98]  # the given phase is the worst


def test_a_peak_that_falls_meets_one_that_rises():
    """1000 W at once, gone after 10 ms, and 500 W reached after 5 s: both together only in the limit."""
    falling, rising = axis((0.01, 1000, 0), (7.99, 0, 0)), axis((5, 0, 500), (3, 0, 0))
    for axes in ([falling, rising], [rising, falling]):
        placed, found = worst_phase(axes)
        assert found == pytest.approx(1500)
        assert peak(placed) == pytest.approx(1500, rel=1e-3)


def test_twenty_axes_of_fifty_segments_meet():
    """Cosines at 50 points, each with one highest moment of 1000 W."""
    steps = np.cos(np.linspace(0, 2 * np.pi, 51)) * 1000
    rows = [(0.16, float(one), float(other)) for one, other in pairwise(steps)]
    axes = [axis(*rows, name=f"axis {number}", shift=0.37 * number) for number in range(20)]
    placed, found = worst_phase(axes)
    assert found == pytest.approx(20_000)
    assert peak(placed) == pytest.approx(20_000, rel=1e-4)


# --- diagram ----------------------------------------------------------------------------------------------------------


def test_the_diagram_shows_each_axis_and_their_sum():
    late = replace(TRAVEL, name="late", shift=3.0)
    shown = {one.name: one for one in power_diagram([TRAVEL, late]).series}
    assert set(shown) == {"travel", "late", "all axes"}
    assert max(shown["all axes"].y) == pytest.approx(900, rel=1e-3)
    summed = np.array(shown["travel"].y) + np.array(shown["late"].y)
    assert np.array(shown["all axes"].y) == pytest.approx(summed)
    assert len(power_diagram([TRAVEL]).series) == 1
