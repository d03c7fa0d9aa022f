"""Braking resistors: the energy of every segment that returns power, and whether a resistor bears it.

A segment of constant torque has a power that runs straight from one end to the other; only its part below zero is
returned. The rating of a resistor holds for a share of its duty cycle time, usually 120 s.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from app.engine.cycle import FloatArray
from app.engine.formulas import resistor as formulas
from app.engine.formulas.duty import duty_share
from app.engine.formulas.motion import sum_of_times
from app.engine.products import BrakingResistor
from app.engine.sheet import Sheet

SHOWN_SEGMENTS = 24
SOURCE = "braking resistor: data sheet"
DUTY_CYCLE_TIME = 120.0
"""Time that ratings refer to where the source does not say: SEW 2001, 9.2 [s]"""
LONGEST_PART = 0.05
"""Share of that time up to which one smooth course is averaged: below the smallest duty that is usually listed."""
SMOOTH = 0.05
"""Jump of the power, over the largest one, up to which a course counts as smooth."""
WEAK = 0.1
"""Braking below this share of the mean of all stronger braking relieves nothing: it is left out."""
MOST_WINDOWS = 400


@dataclass(frozen=True)
class PowerSegment:
    """Power of one segment, negative where it is returned."""

    label: str
    duration: float
    """[s]"""
    start: float
    """[W]"""
    end: float
    """[W]"""
    ramp: bool = False
    """Whether the speed changes in it."""

    def returned(self) -> "PowerSegment | None":
        """The part that returns power, its powers unsigned; None without one."""
        low, high = min(self.start, self.end), max(self.start, self.end)
        if low >= 0:
            return None
        if high <= 0:
            return PowerSegment(self.label, self.duration, -self.start, -self.end, self.ramp)
        share = -low / (high - low)
        ends = (-low, 0.0) if self.start < 0 else (0.0, -low)
        return PowerSegment(self.label, self.duration * share, *ends, self.ramp)


@dataclass(frozen=True)
class Braking:
    """What a cycle returns."""

    energy: float
    """[J]"""
    on_time: float
    """Time in which power is returned in one cycle [s]"""
    duty: float
    """Share of the time, 0 to 1"""
    mean: float
    """Mean over the time of braking [W]"""
    peak: float
    """[W]"""
    segments: tuple[PowerSegment, ...] = ()
    """The cycle in time order, negative where it returns power; empty: all at once and with the mean power"""


def record_braking(sheet: Sheet, segments: Sequence[PowerSegment], cycle_time: float) -> Braking | None:
    """Write energy, duty, mean and peak power of what a cycle returns; None where it returns nothing."""
    runs = returning_runs(segments)
    if not runs:
        sheet.decide("No braking resistor is needed", "no segment returns power")
        return None
    found = [part for run in runs for part in run]
    for number, run in enumerate(runs[:SHOWN_SEGMENTS], start=1):
        _record_run(sheet, run, f"braking_energy_{number}")
    if len(runs) > SHOWN_SEGMENTS:
        sheet.decide(f"{SHOWN_SEGMENTS} of {len(runs)} phases that return power are written out", "all are counted")
    energies = [run_energy(run) for run in runs]
    energy = sheet(formulas.braking_energy_of_cycle, W_k=energies)
    on_time = sheet(sum_of_times, key="braking_on_time", symbol="t_on", label="Time of braking in a cycle",
                    t_k=[part.duration for part in found])  # fmt: skip
    duty = sheet(duty_share, key="braking_duty", label="Duty of the braking resistor", t_on=on_time, t_cyc=cycle_time)
    mean = sheet(formulas.mean_braking_power, W_c=energy, t_on=on_time)
    sheet(formulas.mean_braking_power, key="braking_power_over_cycle", label="Mean braking power over the whole cycle",
          W_c=energy, t_on=cycle_time)  # fmt: skip
    peak = max(max(part.start, part.end) for part in found)
    sheet(formulas.peak_braking_power, P=-peak)
    ramps = [run_energy(run) / sum(part.duration for part in run) for run in runs if any(part.ramp for part in run)]
    if ramps:
        sheet(formulas.sum_of_powers, key="braking_power_sum_of_ramps", P_k=ramps)
    return Braking(energy, on_time, duty, mean, peak, tuple(segments))


def returning_runs(segments: Sequence[PowerSegment]) -> list[list[PowerSegment]]:
    """The parts that return power, those of one phase together: a smooth ramp or a crank has many in a row."""
    runs: list[list[PowerSegment]] = []
    before = -1
    for index, segment in enumerate(segments):
        part = segment.returned()
        if part is None or part.duration <= 0:
            continue
        if runs and index == before + 1 and runs[-1][-1].label == part.label:
            runs[-1].append(part)
        else:
            runs.append([part])
        before = index
    return runs


def run_energy(run: Sequence[PowerSegment]) -> float:
    """Energy that one phase returns [J]."""
    return sum(float(formulas.braking_energy(part.start, part.end, part.duration)) for part in run)


def _record_run(sheet: Sheet, run: Sequence[PowerSegment], key: str) -> None:
    label = f"Energy returned: {run[0].label}"
    if len(run) == 1:
        sheet(formulas.braking_energy, key=key, label=label, P_1=run[0].start, P_2=run[0].end, t=run[0].duration)
        return
    pieces = [float(formulas.braking_energy(part.start, part.end, part.duration)) for part in run]
    sheet(formulas.braking_energy_of_cycle, key=key, label=label, W_k=pieces)


@dataclass(frozen=True)
class Demand:
    """A part of the braking that a rating is held against."""

    energy: float
    """[J]"""
    time: float
    """[s]"""
    period: float
    """Time that the duty refers to [s]"""
    whole: bool
    """Whether it is all that is returned in a cycle"""
    permitted: float | None
    """The rating that counts [W]; None where none is listed for this duty"""
    between: bool = False
    """Whether it lies between two listed ones"""

    @property
    def utilisation(self) -> float:
        """Of the rating; 0 without one."""
        return 0.0 if not self.permitted else self.energy / self.time / self.permitted


def worst_demand(
    braking: Braking, ratings: Sequence[tuple[float, float]], base: float, cycle_time: float
) -> tuple[Demand, bool]:
    """The part of the braking that uses most of its rating, and whether every part has a rating.

    Weak braking beside strong one lowers the mean and raises the duty without relieving the resistor. So not only all
    braking is judged, but also its strongest parts alone, each against the rating of its own duty; in a cycle longer
    than the time that ratings refer to, within every window of that time. All braking, by the next listed duty, counts
    where no part is worse.
    """
    parts = _parts(braking, base, cycle_time)
    if cycle_time > base:
        found = [_strongest(own, ratings, base) for own in _windows(parts, base, cycle_time)]
    else:
        permitted = float(_permitted(ratings, np.array([braking.duty]))[0])
        whole = Demand(braking.energy, braking.on_time, cycle_time, True, None if np.isnan(permitted) else permitted)
        one, _ = _strongest(parts, ratings, cycle_time)
        found = [(whole if one.utilisation <= whole.utilisation * (1 + 1e-9) else one, whole.permitted is not None)]
    worst = max((one for one, _ in found), key=lambda one: (one.utilisation, one.energy))
    return worst, all(listed for _, listed in found)


def _strongest(parts: FloatArray, ratings: Sequence[tuple[float, float]], period: float) -> tuple[Demand, bool]:
    """Of the strongest one, two, three ... parts together those that use most of their rating.

    Where only weak braking is left beside them, the next listed duty counts as if there were none; else the rating
    between the listed duties, as their own duty is no duty of the drive. Also whether all together have a rating.
    """
    _, duration, power = parts[:, np.argsort(-parts[2], kind="stable")]
    time, energy = np.cumsum(duration), np.cumsum(duration * power)
    listed = _permitted(ratings, time / period)
    if np.isnan(listed).all():
        return Demand(float(energy[-1]), float(time[-1]), period, False, None), False
    strong = np.append(power[1:], 0.0) >= WEAK * energy / time
    permitted = np.where(strong, _interpolated(ratings, time / period), listed)
    k = int(np.argmax(np.where(np.isnan(permitted), -1.0, energy / time / permitted)))
    between = bool(permitted[k] > listed[k] * (1 + 1e-9))
    one = Demand(float(energy[k]), float(time[k]), period, False, float(permitted[k]), between)
    return one, not bool(np.isnan(listed[-1]))


def _permitted(ratings: Sequence[tuple[float, float]], duty: FloatArray) -> FloatArray:
    """Power of the next listed duty [W], NaN where none is listed."""
    powers = np.array([power for _, power in ratings] + [np.nan])
    found: FloatArray = powers[np.searchsorted([listed for listed, _ in ratings], duty - 1e-9)]
    return found


def _interpolated(ratings: Sequence[tuple[float, float]], duty: FloatArray) -> FloatArray:
    """Power between the listed duties, straight in double logarithmic scales [W]; NaN beyond the last one."""
    listed, powers = np.log(np.array(ratings)).T
    found: FloatArray = np.exp(np.interp(np.log(duty), listed, powers))
    return np.where(np.isnan(_permitted(ratings, duty)), np.nan, found)


def _parts(braking: Braking, base: float, cycle_time: float) -> FloatArray:
    """Start [s], duration [s] and mean power [W] of what is returned in pieces, in time order, shape (3, n).

    A smooth course that changes stays together up to ``LONGEST_PART`` of the time that ratings refer to, so that its
    sampling does not matter.
    """
    longest, jump = LONGEST_PART * base, SMOOTH * braking.peak
    courses: list[list[tuple[float, PowerSegment]]] = []
    moment = 0.0
    for segment in braking.segments:
        part, begin = segment.returned(), moment
        moment += segment.duration
        if part is None or part.duration <= 1e-12 * cycle_time:
            continue
        begin = moment - part.duration if segment.start >= 0 else begin
        if courses and _continues(courses[-1][-1], begin, part, jump, 1e-9 * cycle_time):
            courses[-1].append((begin, part))
        else:
            courses.append([(begin, part)])
    if not courses:
        return np.array([[0.0], [braking.on_time], [braking.mean]])
    return np.concatenate([_cut(course, longest, jump) for course in courses], axis=1)


def _continues(
    last: tuple[float, PowerSegment], begin: float, part: PowerSegment, jump: float, gap: float
) -> bool:  # fmt: skip
    """Whether a part goes on where the last one ends."""
    before, known = last
    return (
        abs(before + known.duration - begin) <= gap
        and known.label == part.label
        and abs(known.end - part.start) <= jump
    )


def _cut(course: Sequence[tuple[float, PowerSegment]], longest: float, jump: float) -> FloatArray:
    """A smooth course in equal pieces no longer than ``longest`` [s]: start, duration and mean power, shape (3, n).

    One whose power changes by no more than ``jump`` [W] is one piece: a share of it can be no worse than all of it.
    """
    times = np.array([course[0][0], *(begin + part.duration for begin, part in course)])
    start, end = np.array([(part.start, part.end) for _, part in course]).T
    width = np.diff(times)
    energies = np.concatenate(([0.0], np.cumsum((start + end) / 2 * width)))
    varies = max(start.max(), end.max()) - min(start.min(), end.min()) > jump
    number = max(int(np.ceil((times[-1] - times[0]) / longest - 1e-9)), 1) if varies else 1
    borders = np.linspace(times[0], times[-1], number + 1)
    k = np.clip(np.searchsorted(times, borders, side="right") - 1, 0, len(course) - 1)
    inside = borders - times[k]
    reached = energies[k] + (start[k] + (end - start)[k] / width[k] * inside / 2) * inside
    found: FloatArray = np.array([borders[:-1], np.diff(borders), np.diff(reached) / np.diff(borders)])
    return found


def _windows(parts: FloatArray, base: float, cycle_time: float) -> Iterator[FloatArray]:
    """The parts in windows of the time that ratings refer to, each beginning or ending with a part.

    The cycle repeats. Of very many windows those with most energy and those with most of its strong parts are tried.
    """
    around = np.concatenate([parts + np.array([[shift], [0], [0]]) for shift in (-cycle_time, 0, cycle_time)], axis=1)
    start, duration, power = around
    end = start + duration
    edges = np.unique(np.concatenate((parts[0], parts[0] + parts[1] - base)))
    if len(edges) > MOST_WINDOWS:
        times = np.concatenate(([start[0]], end))
        chosen = set()
        for weight in (power, power**2):
            reached = np.concatenate(([0.0], np.cumsum(weight * duration)))
            inside = np.interp(edges + base, times, reached) - np.interp(edges, times, reached)
            chosen |= set(np.argsort(-inside)[: MOST_WINDOWS // 2].tolist())
        edges = edges[sorted(chosen)]
    for edge in edges:
        time = np.minimum(end, edge + base) - np.maximum(start, edge)
        kept = time > 1e-9 * base
        if kept.any():
            yield np.array([start[kept], time[kept], power[kept]])


def check_resistor(
    sheet: Sheet, braking: Braking, resistor: BrakingResistor, *, cycle_time: float, chopper_limit: float | None = None
) -> None:
    """Check a resistor by its row of the next listed duty, by its peak, and against the chopper."""
    base = resistor.duty_cycle_time or DUTY_CYCLE_TIME
    rows = resistor.ratings
    found, complete = worst_demand(braking, rows, base, cycle_time)
    duty, mean = braking.duty, braking.mean
    if cycle_time <= base:
        _record_interpolated(sheet, rows, duty)
    if not found.whole:
        what = "the strongest braking" + (" in the worst time that ratings refer to" if cycle_time > base else "")
        duty = sheet(duty_share, key="resistor_duty", label=f"Duty of {what}", t_on=found.time, t_cyc=found.period)
        mean = sheet(formulas.mean_braking_power, key="resistor_power", label=f"Mean power of {what}",
                     W_c=found.energy, t_on=found.time)  # fmt: skip
        _record_interpolated(sheet, rows, duty)
    row = next(((listed, power) for listed, power in rows if listed >= duty - 1e-9), None)
    if found.between:
        sheet.decide("The rating between the listed duties counts", f"the strongest braking has a duty of {duty:.1%}")
    elif row is not None:
        sheet.decide(f"The rating at {row[0]:.0%} duty counts", f"the next listed one above {duty:.1%}")
    permitted = found.permitted if complete or found.utilisation > 1 else None
    sheet.check("resistor_mean_power", "Braking resistor: mean power while braking", mean, permitted, "kW", SOURCE,
                formula="mean_braking_power", missing="" if permitted else "rating at this duty")  # fmt: skip
    peak = resistor.peak_power if resistor.peak_power is not None else (rows[0][1] if rows else None)
    lacking = "" if peak is not None else "peak power of the resistor"
    sheet.check("resistor_peak_power", "Braking resistor: peak power", braking.peak, peak, "kW", SOURCE,
                formula="peak_braking_power", missing=lacking)  # fmt: skip
    check_chopper(sheet, braking.peak, chopper_limit)


def _record_interpolated(sheet: Sheet, rows: Sequence[tuple[float, float]], duty: float) -> None:
    """Write the rating between the listed duties below and above."""
    below = [one for one in rows if one[0] < duty]
    above = next(((listed, power) for listed, power in rows if listed >= duty - 1e-9), None)
    if below and above is not None:
        sheet(formulas.interpolated_rating, key="interpolated_rating", P_1=below[-1][1], P_2=above[1],
              ED_1=below[-1][0], ED_2=above[0], ED=duty)  # fmt: skip


def check_chopper(sheet: Sheet, peak: float | None, limit: float | None, missing: str = "") -> None:
    """Check the largest power that is returned [W] against the braking chopper, where its limit is known.

    The chopper must pass it whatever resistor is behind it. ``peak`` is None where ``missing`` lacks.
    """
    if limit is not None:
        sheet.check("chopper_power", "Braking chopper: peak power", peak, limit, "kW", "inverter: data sheet",
                    formula="peak_braking_power", missing=missing)  # fmt: skip
