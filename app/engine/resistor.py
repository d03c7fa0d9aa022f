"""Braking resistors: the energy of every segment that returns power, and whether a resistor bears it.

A segment of constant torque has a power that runs straight from one end to the other; only its part below zero is
returned. The rating of a resistor holds for a share of its duty cycle time, usually 120 s.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from app.engine.formulas import resistor as formulas
from app.engine.formulas.duty import duty_share
from app.engine.formulas.motion import sum_of_times
from app.engine.products import BrakingResistor
from app.engine.sheet import Sheet

SHOWN_SEGMENTS = 24
SOURCE = "braking resistor: data sheet"
DUTY_CYCLE_TIME = 120.0
"""Time that ratings refer to where the source does not say: SEW 2001, 9.2 [s]"""


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
    return Braking(energy, on_time, duty, mean, peak)


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


def check_resistor(
    sheet: Sheet, braking: Braking, resistor: BrakingResistor, *, cycle_time: float, chopper_limit: float | None = None
) -> None:
    """Check a resistor by its row of the next listed duty, by its peak, and against the chopper."""
    base = resistor.duty_cycle_time or DUTY_CYCLE_TIME
    duty = braking.duty
    if cycle_time > base:
        duty = sheet(duty_share, key="resistor_duty", label="Duty in the worst time that ratings refer to",
                     t_on=min(braking.on_time, base), t_cyc=base)  # fmt: skip
    rows = resistor.ratings
    row = next(((listed, power) for listed, power in rows if listed >= duty - 1e-9), None)
    if row is not None:
        sheet.decide(f"The rating at {row[0]:.0%} duty counts", f"the next listed one above {duty:.1%}")
        below = [one for one in rows if one[0] < duty]
        if below:
            sheet(formulas.interpolated_rating, key="interpolated_rating", P_1=below[-1][1], P_2=row[1],
                  ED_1=below[-1][0], ED_2=row[0], ED=duty)  # fmt: skip
    sheet.check("resistor_mean_power", "Braking resistor: mean power while braking", braking.mean,
                None if row is None else row[1], "kW", SOURCE, formula="mean_braking_power",
                missing="" if row is not None else "rating at this duty")  # fmt: skip
    peak = resistor.peak_power if resistor.peak_power is not None else (rows[0][1] if rows else None)
    lacking = "" if peak is not None else "peak power of the resistor"
    sheet.check("resistor_peak_power", "Braking resistor: peak power", braking.peak, peak, "kW", SOURCE,
                formula="peak_braking_power", missing=lacking)  # fmt: skip
    if chopper_limit is not None:
        sheet.check("chopper_power", "Braking chopper: peak power", braking.peak, chopper_limit, "kW",
                    "inverter: data sheet", formula="peak_braking_power")  # fmt: skip
