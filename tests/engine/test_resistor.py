"""Braking resistors: energy of every segment that returns power, and the row of the rating that counts."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.engine.dc_link import AxisPower, returned_segments
from app.engine.products import BrakingResistor
from app.engine.resistor import Braking, PowerSegment, check_resistor, record_braking
from app.engine.sheet import Check, Sheet, Verdict

BW100_002 = ((0.06, 1900.0), (0.12, 1200.0), (0.25, 600.0), (0.5, 400.0), (1.0, 200.0))
"""SEW 2001, 9.2: duty and permitted power."""

powers = st.floats(-5000, 5000)
segments = st.lists(
    st.builds(PowerSegment, st.just("phase"), st.floats(0.01, 10), powers, powers), min_size=1, max_size=12
)


def resistor(ratings: tuple[tuple[float, float], ...] = BW100_002, **values: float) -> BrakingResistor:
    return BrakingResistor(id="r", manufacturer="", series="", model="", source="test", ratings=ratings, **values)


def check(
    braking: Braking, of: BrakingResistor, cycle_time: float, chopper: float | None = None
) -> tuple[Sheet, dict[str, Check]]:
    sheet = Sheet()
    check_resistor(sheet, braking, of, cycle_time=cycle_time, chopper_limit=chopper)
    return sheet, {one.key: one for one in sheet.checks}


def braking(on_time: float, cycle_time: float, mean: float = 500.0, peak: float = 1500.0) -> Braking:
    return Braking(mean * on_time, on_time, on_time / cycle_time, mean, peak)


# --- energy -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("start", "end", "expected"),
    [
        (-100, -300, (4.0, 100, 300)),
        (100, -300, (3.0, 0, 300)),  # crosses zero after 100 of 400 W: 3 of 4 s
        (-300, 100, (3.0, 300, 0)),
        (0, -100, (4.0, 0, 100)),
        (-100, 0, (4.0, 100, 0)),
    ],
)
def test_only_the_part_below_zero_is_returned(start: float, end: float, expected: tuple[float, float, float]):
    part = PowerSegment("down", 4.0, start, end, ramp=True).returned()
    assert part is not None
    assert (part.duration, part.start, part.end) == pytest.approx(expected)
    assert (part.label, part.ramp) == ("down", True)


@pytest.mark.parametrize(("start", "end"), [(0, 0), (100, 0), (0, 100), (50, 100)])
def test_what_is_taken_is_not_returned(start: float, end: float):
    assert PowerSegment("up", 4.0, start, end).returned() is None


def test_energy_duty_mean_and_peak_of_a_cycle():
    """1200 W for 1 s, 1500 W falling to 150 W in 0.9 s, then driving: 1200 + 742.5 J in 1.9 of 10 s."""
    sheet = Sheet()
    cycle = [
        PowerSegment("steady", 1.0, -1200, -1200),
        PowerSegment("ramp", 0.9, -1500, -150, ramp=True),
        PowerSegment("up", 8.1, 2000, 2000),
    ]
    found = record_braking(sheet, cycle, 10.0)
    assert found is not None
    assert (found.energy, found.on_time, found.duty) == pytest.approx((1942.5, 1.9, 0.19))
    assert (found.mean, found.peak) == pytest.approx((1942.5 / 1.9, 1500))
    assert sheet.value("braking_energy_1") == pytest.approx(1200)
    assert sheet.value("braking_energy_2") == pytest.approx(742.5)
    assert sheet.value("braking_power_over_cycle") == pytest.approx(194.25)
    assert sheet.value("braking_power_sum_of_ramps") == pytest.approx(825)
    assert not sheet.has("braking_energy_3")


def test_a_cycle_that_returns_nothing_needs_no_resistor():
    sheet = Sheet()
    assert record_braking(sheet, [PowerSegment("up", 1.0, 0, 100)], 1.0) is None
    assert sheet.steps == []
    assert [decision.text for decision in sheet.decisions] == ["No braking resistor is needed"]


def test_all_segments_count_although_not_all_are_written_out():
    """30 phases of 10 J."""
    sheet = Sheet()
    found = record_braking(sheet, [PowerSegment(f"phase {k}", 1.0, -10, -10) for k in range(30)], 60.0)
    assert found is not None
    assert found.energy == pytest.approx(300)
    assert sum(step.key.startswith("braking_energy_") for step in sheet.steps) == 24 + 1
    assert any("24 of 30" in decision.text for decision in sheet.decisions)


def test_a_ramp_in_many_pieces_is_one_phase():
    """From 100 W to nothing in 2 s: 100 J and 50 W, in one piece or in eight."""
    borders = np.linspace(-100, 0, 9)
    pieces = [PowerSegment("down", 0.25, float(a), float(b), ramp=True) for a, b in pairwise(borders)]
    for cut in ([PowerSegment("down", 2.0, -100, 0, ramp=True)], pieces):
        sheet = Sheet()
        assert record_braking(sheet, [PowerSegment("up", 1.0, 0, 80), *cut, PowerSegment("rest", 1.0, 0, 0)], 4.0)
        assert sheet.value("braking_energy_1") == pytest.approx(100)
        assert not sheet.has("braking_energy_2")
        assert sheet.value("braking_power_sum_of_ramps") == pytest.approx(50)


@given(of=segments)
def test_energy_is_the_integral_of_what_is_below_zero(of: list[PowerSegment]):
    """Against a sum over 20 000 strips of each segment."""
    middles = (np.arange(20_000) + 0.5) / 20_000
    strips = [np.minimum(one.start + (one.end - one.start) * middles, 0.0) for one in of]
    integral = -sum(float(strip.mean()) * one.duration for strip, one in zip(strips, of, strict=True))
    found = record_braking(Sheet(), of, 1000.0)
    energy, peak = (found.energy, found.peak) if found else (0.0, 0.0)
    assert energy == pytest.approx(integral, rel=1e-3, abs=1e-3)
    assert peak == pytest.approx(max(0.0, *(-min(one.start, one.end) for one in of)))


@given(of=segments, share=st.floats(0.01, 0.99))
def test_cutting_a_segment_changes_nothing(of: list[PowerSegment], share: float):
    pieces = []
    for one in of:
        middle = one.start + (one.end - one.start) * share
        pieces += [PowerSegment("a", one.duration * share, one.start, middle),
                   PowerSegment("b", one.duration * (1 - share), middle, one.end)]  # fmt: skip
    whole, cut = record_braking(Sheet(), of, 1000.0), record_braking(Sheet(), pieces, 1000.0)
    assert (whole is None) == (cut is None)
    if whole and cut:
        assert (cut.energy, cut.on_time, cut.peak) == pytest.approx((whole.energy, whole.on_time, whole.peak))


# --- rating -----------------------------------------------------------------------------------------------------------


def test_the_resistor_of_the_handbook():
    """SEW 2001, 9.2, recomputed: 512.6 W in 22.67 % of the time, peak 1504 W; listed are 600 W at 25 %, 1900 W at 6 %;
    a straight line in logarithms gives 658.2 W."""
    sheet, checks = check(Braking(3485.54, 6.8, 6.8 / 30, 512.5792003, 1504.216363), resistor(), 30.0)
    mean, peak = checks["resistor_mean_power"], checks["resistor_peak_power"]
    assert (mean.demanded, mean.permitted) == (512.5792003, 600)
    assert (peak.demanded, peak.permitted) == (1504.216363, 1900)
    assert mean.verdict == Verdict.TIGHT
    assert sheet.value("interpolated_rating") == pytest.approx(658.1682359)


@pytest.mark.parametrize(
    ("on_time", "row"),
    [(0.1, 1900), (0.6, 1900), (0.61, 1200), (1.2, 1200), (2.5, 600), (2.51, 400), (5.0, 400), (5.01, 200), (10, 200)],
)
def test_the_next_listed_duty_counts(on_time: float, row: float):
    """Seconds of braking in a cycle of 10 s; a listed duty itself is its own row."""
    assert check(braking(on_time, 10.0), resistor(), 10.0)[1]["resistor_mean_power"].permitted == row


def test_rounding_of_a_sum_of_times_does_not_reach_the_next_row():
    """0.1 s + 0.2 s of 1.2 s is 25 %, although floating-point numbers make it a little more."""
    parts = [PowerSegment("a", 0.1, -100, -100), PowerSegment("b", 0.2, -100, -100)]
    found = record_braking(Sheet(), parts, 1.2)
    assert found is not None
    assert found.duty > 0.25
    assert check(found, resistor(), 1.2)[1]["resistor_mean_power"].permitted == 600


def test_a_duty_beyond_the_list_is_not_checked():
    checks = check(braking(6.0, 10.0), resistor(BW100_002[:4]), 10.0)[1]
    assert checks["resistor_mean_power"].verdict == Verdict.NOT_CHECKED
    assert checks["resistor_mean_power"].missing == "rating at this duty"
    assert checks["resistor_peak_power"].permitted == 1900


@pytest.mark.parametrize(
    ("on_time", "cycle_time", "base", "row"),
    [
        (30, 240, None, 600),  # 12.5 % of the cycle, but 30 s of the worst 120 s
        (30, 240, 60.0, 400),  # of the worst 60 s
        (130, 1000, None, 200),  # longer than the time that ratings refer to: all the time
        (30, 120, None, 600),
        (3, 12, 60.0, 600),  # short cycles: 25 % in any time
    ],
)
def test_a_long_cycle_is_judged_in_its_worst_time(
    on_time: float, cycle_time: float, base: float | None, row: float
):  # fmt: skip
    of = resistor() if base is None else resistor(duty_cycle_time=base)
    assert check(braking(on_time, cycle_time), of, cycle_time)[1]["resistor_mean_power"].permitted == row


def test_a_peak_that_the_data_sheet_gives_goes_before_the_first_row():
    checks = check(braking(1.0, 10.0), resistor(peak_power=1400.0), 10.0)[1]
    assert (checks["resistor_peak_power"].permitted, checks["resistor_peak_power"].verdict) == (1400, Verdict.FAILS)


def test_without_any_rating_nothing_is_judged():
    checks = check(braking(1.0, 10.0), resistor(()), 10.0)[1]
    assert {one.verdict for one in checks.values()} == {Verdict.NOT_CHECKED}
    assert checks["resistor_peak_power"].missing == "peak power of the resistor"


def test_the_chopper_bears_the_peak_too():
    checks = check(braking(1.0, 10.0), resistor(), 10.0, chopper=1499.0)[1]
    assert (checks["chopper_power"].demanded, checks["chopper_power"].verdict) == (1500, Verdict.FAILS)
    assert "chopper_power" not in check(braking(1.0, 10.0), resistor(), 10.0)[1]


@given(on_time=st.floats(0.01, 10), longer=st.floats(1, 10))
def test_more_braking_never_permits_more(on_time: float, longer: float):
    permitted = [
        check(braking(min(time, 10.0), 10.0), resistor(), 10.0)[1]["resistor_mean_power"].permitted
        for time in (on_time, on_time * longer)
    ]
    assert permitted[0] is not None
    assert permitted[1] is not None
    assert permitted[0] >= permitted[1]


# --- strong braking beside weak braking -------------------------------------------------------------------------------

KILOWATTS = ((0.06, 20_000.0), (0.12, 12_000.0), (0.25, 6000.0), (0.5, 4000.0), (1.0, 2000.0))


def braked(*parts: tuple[float, float], cycle_time: float, label: str = "down") -> Braking:
    """Braking of these (time, power), one after the other, then nothing."""
    rest = cycle_time - sum(time for time, _ in parts)
    cycle = [PowerSegment(label, time, -power, -power) for time, power in parts]
    found = record_braking(Sheet(), [*cycle, PowerSegment("rest", rest, 0, 0)], cycle_time)
    assert found is not None
    return found


@pytest.mark.parametrize(
    ("parts", "cycle_time"),
    [
        ([(31, 5100)], 120),
        ([(31, 5100), (88, 50)], 120),
        ([(88, 50), (31, 5100)], 120),
        ([(31, 5100), (90, 50)], 125),
        ([(31, 5100), (90, 50)], 3600),
        ([(10, 5100), (30, 50), (21, 5100), (60, 50)], 1000),
    ],
)
def test_weak_braking_does_not_relieve_a_resistor(parts: list[tuple[float, float]], cycle_time: float):
    """31 of 120 s are 25.8 %: 4 kW; the mean with 90 s of 50 W is 1.36 kW."""
    _, checks = check(braked(*parts, cycle_time=cycle_time), resistor(KILOWATTS), cycle_time)
    found = checks["resistor_mean_power"]
    assert found.verdict == Verdict.FAILS
    assert found.utilisation is not None
    assert found.utilisation >= 5100 / 4000 - 1e-9


def test_the_strongest_part_alone_is_written_out():
    """20 s of 5 kW are 16.7 % of 120 s: 5000 of 6000 W; with 60 s of 100 W 1.325 kW of 2 kW."""
    sheet, checks = check(braked((20, 5000), (60, 100), cycle_time=120), resistor(KILOWATTS), 120)
    assert sheet.value("resistor_duty") == pytest.approx(20 / 120)
    assert sheet.value("resistor_power") == pytest.approx(5000)
    assert (checks["resistor_mean_power"].demanded, checks["resistor_mean_power"].permitted) == (
        pytest.approx(5000), 6000)  # fmt: skip


def test_braking_far_apart_is_not_added_up():
    """Six times 20 s of 5 kW in an hour: never more than one in 120 s, 16.7 %; all together would be 100 %."""
    apart: list[PowerSegment] = []
    for _ in range(6):
        apart += [PowerSegment("down", 20, -5000, -5000), PowerSegment("rest", 580, 0, 0)]
    found = record_braking(Sheet(), apart, 3600)
    assert found is not None
    sheet, checks = check(found, resistor(KILOWATTS), 3600)
    assert checks["resistor_mean_power"].permitted == 6000
    assert checks["resistor_mean_power"].demanded == pytest.approx(5000)
    assert sheet.value("resistor_duty") == pytest.approx(1 / 6)


def test_parts_of_like_power_are_judged_between_the_listed_duties():
    """15 s of 5 kW beside 15 s of 2 kW in 100 s: 3.5 of 4 kW at 30 %; the strong one alone at 15 % has
    12 * (6 / 12)^(ln(15 / 12) / ln(25 / 12)) = 9.7 kW. With 10 kW the strong one decides: 10 of 9.7 kW."""
    one = check(braked((15, 5000), (15, 2000), cycle_time=100), resistor(KILOWATTS), 100)[1]["resistor_mean_power"]
    assert (one.demanded, one.permitted) == (pytest.approx(3500), 4000)
    strong = resistor(((0.12, 12_000.0), (0.25, 6000.0), (0.5, 6000.0)))
    one = check(braked((15, 10_000), (15, 1500), cycle_time=100), strong, 100)[1]["resistor_mean_power"]
    rating = 12_000 * 0.5 ** (np.log(15 / 12) / np.log(25 / 12))
    assert (one.demanded, one.permitted) == (pytest.approx(10_000), pytest.approx(rating))


def test_a_window_reaches_over_the_end_of_the_cycle():
    """16 s at the end and 16 s at the beginning of 300 s are 32 s at once: 26.7 %."""
    cycle = [PowerSegment("down", 16, -5000, -5000), PowerSegment("rest", 268, 0, 0),
             PowerSegment("down", 16, -5000, -5000)]  # fmt: skip
    found = record_braking(Sheet(), cycle, 300)
    assert found is not None
    assert check(found, resistor(KILOWATTS), 300)[1]["resistor_mean_power"].permitted == 4000


@pytest.mark.parametrize("pieces", [1, 7, 200])
def test_the_sampling_of_a_ramp_does_not_matter(pieces: int):
    """4 kW falling to nothing in 3 s of 10 s, a course below 6 s: 2 kW at 30 %, not the peak at its own duty."""
    borders = np.linspace(-4000, 0, pieces + 1)
    cut = [PowerSegment("down", 3 / pieces, float(a), float(b), ramp=True) for a, b in pairwise(borders)]
    found = record_braking(Sheet(), [*cut, PowerSegment("rest", 7, 0, 0)], 10)
    assert found is not None
    one = check(found, resistor(KILOWATTS), 10)[1]["resistor_mean_power"]
    assert (one.demanded, one.permitted) == (pytest.approx(2000), 4000)


def test_a_part_that_fails_is_not_excused_by_a_duty_that_is_not_listed():
    """The list ends at 50 %; 31 s of 5.1 kW fail whatever 88 s of 50 W are rated."""
    one = check(braked((31, 5100), (88, 50), cycle_time=120), resistor(KILOWATTS[:4]), 120)[1]["resistor_mean_power"]
    assert one.verdict == Verdict.FAILS
    one = check(braked((31, 2100), (88, 50), cycle_time=120), resistor(KILOWATTS[:4]), 120)[1]["resistor_mean_power"]
    assert (one.verdict, one.missing) == (Verdict.NOT_CHECKED, "rating at this duty")


@given(
    of=st.lists(st.tuples(st.floats(0.5, 10), st.floats(1000, 5000)), min_size=1, max_size=8),
    weak=st.floats(1, 99), time=st.floats(0.5, 99),
)  # fmt: skip
def test_more_braking_never_relieves(of: list[tuple[float, float]], weak: float, time: float):
    """Something below a tenth of all the rest, in place of a pause."""
    length = sum(one for one, _ in of) + 100
    used = [
        check(braked(*of, *end, cycle_time=length), resistor(KILOWATTS), length)[1]["resistor_mean_power"].utilisation
        for end in ([], [(time, weak)])
    ]
    assert used[0] is not None
    assert used[1] is not None
    assert used[1] >= used[0] * (1 - 1e-6)


def test_very_many_pieces_do_not_take_long():
    """20 000 pieces of 0.5 s, every third one of 1 kW; one place with 40 s of 3 kW in a row: 33 %."""
    cycle = [PowerSegment("x", 0.5, 0 if k % 3 else -1000, 0 if k % 3 else -1000) for k in range(20_000)]
    cycle[9000:9080] = [PowerSegment("x", 0.5, -3000, -3000)] * 80
    found = record_braking(Sheet(), cycle, 10_000)
    assert found is not None
    one = check(found, resistor(KILOWATTS), 10_000)[1]["resistor_mean_power"]
    assert one.utilisation is not None
    assert one.utilisation >= 3000 / 4000 - 1e-9


def test_what_several_axes_return_at_once_is_added_up():
    """The first returns 100 W in 2 of 4 s, the second falls from 100 W to -100 W in 4 s: it returns in the last 2 s.
    100 W for 2 s, then 0 to 100 W in 2 s: 200 J and 100 J, although the second one takes as much before."""
    first = AxisPower("a", np.array([0.0, 2, 4]), np.array([-100.0, 0]), np.array([-100.0, 0]), ("", ""), (True, False))
    second = AxisPower("b", np.array([0.0, 4]), np.array([100.0]), np.array([-100.0]), ("",), (True,))
    found = returned_segments([first, second])
    energies = [-(one.start + one.end) / 2 * one.duration for one in found]
    assert [one.duration for one in found] == pytest.approx([2, 2])
    assert energies == pytest.approx([200, 100])
