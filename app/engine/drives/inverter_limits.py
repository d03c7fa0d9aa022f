"""What an induction motor may give on an inverter, and every check of it."""

from dataclasses import dataclass
from functools import cached_property
from itertools import groupby
from typing import TYPE_CHECKING

import numpy as np

from app.engine.cycle import FloatArray, LoadCycle
from app.engine.drives.base import Points
from app.engine.drives.line_fed import LineFed, MotorData
from app.engine.drives.shaft import MotorShaft
from app.engine.errors import EngineError
from app.engine.formulas import inverter_fed as formulas
from app.engine.formulas.servo import motor_current, shaft_power, signed_power, torque_constant
from app.engine.products import Inverter
from app.engine.sheet import Sheet

if TYPE_CHECKING:
    from app.engine.drives.inverter_fed import InverterFedDrive

TORQUE_LIMIT = 1.5
STARTING_LIMIT = 1.3
STARTING_RANGE = 0.25
"""Share of rated speed below which the torque limit of starting holds."""
LIMIT_SOURCE = "SEW 2001, 8.4: 150 % current"
STARTING_SOURCE = "SEW 2001, 8.4: while starting, 150 % current gives 130 % torque"
ROTOR_MISSING = "rotor inertia of the motor"
HOIST_FREQUENCY = 70.0
HOIST_SOURCE = "SEW 2001, 9.2: hoists reach their speed at 70 Hz"
OVERLOAD = 1.5
SELF_COOLED_RANGE = 5.0
COOLING_SOURCE = "SEW 2001, 3.4: own fan up to 1:5 at the next smaller rating, forced fan from there on"
FULL_TORQUE_RANGE = 2.0
"""Rated over steady speed up to which a motor that runs at one speed gives rated torque with its own fan: common
practice, derating charts of makers begin near half of the rated frequency."""
MAX_POWERS = 24


@dataclass(frozen=True)
class InverterLimits:
    """Torque of one motor over its speed."""

    rated_torque: float
    rated_speed: float
    """At the knee [rad/s]"""
    peak: float
    """Torque limit over rated torque."""
    breakdown: float | None
    """Breakdown torque at the knee divided by the reserve that must remain [N m]"""
    max_speed: float | None
    starting_peak: float | None = None
    """Torque limit over rated torque below ``starting_speed``; None: none of its own."""
    starting_speed: float = 0.0
    """[rad/s]"""

    def continuous(self, speed: FloatArray) -> FloatArray:
        """Rated torque at a speed: constant, above the knee with 1/f."""
        found: FloatArray = self.rated_torque * np.minimum(1.0, self.rated_speed / np.maximum(np.abs(speed), 1e-9))
        return found

    def largest(self, speed: FloatArray) -> FloatArray:
        """Torque limit at a speed, above the knee no more than the breakdown torque leaves."""
        found = self.peak * self.continuous(speed)
        if self.breakdown is not None:
            weak = np.maximum(np.abs(speed) / self.rated_speed, 1.0)
            found = np.where(weak > 1.0, np.minimum(found, self.breakdown / weak**2), found)
        if self.starting_peak is not None:
            slow = np.abs(speed) < self.starting_speed * (1 - 1e-9)
            found = np.where(slow, self.starting_peak * self.continuous(speed), found)
        return np.asarray(found, dtype=float)

    def peak_points(self) -> Points:
        """Torque limit for the chart."""
        speeds = self._speeds()
        return tuple(zip(speeds.tolist(), self.largest(speeds).tolist(), strict=True))

    def continuous_points(self) -> Points:
        """Rated torque for the chart."""
        speeds = self._speeds()
        return tuple(zip(speeds.tolist(), self.continuous(speeds).tolist(), strict=True))

    def _speeds(self) -> FloatArray:
        top = max(self.max_speed or 0.0, 1.5 * self.rated_speed)
        corner = [] if self.starting_peak is None else [self.starting_speed * (1 - 1e-6), self.starting_speed]
        return np.concatenate(([0.0], corner, np.linspace(self.rated_speed, top, 24)))


@dataclass(frozen=True, kw_only=True)
class InverterCase:
    """One inverter-fed drive on one load."""

    rules: "InverterFedDrive"
    line: LineFed
    shaft: MotorShaft
    data: MotorData | None
    inverter: Inverter | None
    steady_phases: frozenset[str] = frozenset()
    """Names of the phases in which the load moves at constant speed, whatever the shaft does (winders, cranks)."""

    @property
    def sustained_speeds(self) -> FloatArray:
        """Unsigned speeds that the motor keeps: segments of constant speed and those of steady phases [rad/s]."""
        cycle = self.shaft.load.cycle
        change = np.abs(cycle.speed_end - cycle.speed_start)
        named = np.array([label in self.steady_phases for label in cycle.label])
        kept = (named | (change <= 1e-6 * cycle.max_speed)) & (cycle.mean_speed != 0)
        found: FloatArray = np.abs(cycle.mean_speed[kept]) * self.shaft.transmission.ratio
        return found

    @property
    def knee(self) -> float:
        """Frequency up to which the flux stays constant [Hz]."""
        assert self.data is not None
        return self.rules.knee_frequency or self.data.winding.frequency

    @property
    def knee_speed(self) -> float:
        """Speed of the motor at the knee: the rated slip stays [rad/s]."""
        assert self.data is not None
        slip = self.data.synchronous_speed - self.data.rated_speed
        return self.data.synchronous_speed * self.knee / self.data.winding.frequency - slip

    @cached_property
    def limits(self) -> InverterLimits | None:
        """Torque over speed; None without a motor."""
        if self.data is None:
            return None
        ratio, own = self.data.winding.breakdown_torque_ratio, self.rules.torque_limit
        return InverterLimits(
            rated_torque=self.data.rated_torque, rated_speed=self.knee_speed, peak=TORQUE_LIMIT if own is None else own,
            breakdown=None if ratio is None else ratio * self.data.rated_torque / self.rules.breakdown_reserve,
            max_speed=self.shaft.max_speed, starting_peak=STARTING_LIMIT if own is None else None,
            starting_speed=STARTING_RANGE * self.data.rated_speed,
        )  # fmt: skip

    @property
    def torque_missing(self) -> str:
        """What lacks for torques of a motor that accelerates; empty when nothing does, or no motor is chosen."""
        if self.line.motor is None or self.line.motor_inertia is not None:
            return ""
        return ROTOR_MISSING if self.shaft.hull.max_acceleration > 0 else ""


def refuse_knee(case: InverterCase) -> None:
    """Refuse a knee frequency at which the rated slip leaves no speed."""
    if case.data is not None and case.knee_speed <= 0:
        data = case.data
        slip = data.winding.frequency * (1 - data.rated_speed / data.synchronous_speed)
        raise EngineError(f"must be above the slip frequency of the motor, {slip:.4g} Hz", field="knee_frequency_hz")


def record_powers(shaft: MotorShaft, cycle: LoadCycle, sheet: Sheet) -> None:
    """Write the power of every moving phase at its faster end, signed: negative where it is returned.

    Of a phase with many segments the one with the largest power stands for it.
    """
    ratio, torque = shaft.transmission.ratio, shaft.torque(cycle)
    fast = np.where(np.abs(cycle.speed_start) > np.abs(cycle.speed_end), cycle.speed_start, cycle.speed_end)
    phases = [list(run) for _, run in groupby(range(len(cycle.duration)), key=lambda k: cycle.label[k])]
    moving = [
        max(chosen, key=lambda k: abs(torque[k] * fast[k]))
        for run in phases
        if (chosen := [k for k in run if cycle.mean_speed[k] != 0 and not cycle.braked[k]])
    ]
    for number, k in enumerate(moving[:MAX_POWERS], start=1):
        sheet(signed_power, key=f"segment_{number}_power", label=f"Power of the motor: {cycle.label[k]}",
              M=float(torque[k]), omega=float(fast[k]) * ratio)  # fmt: skip
    if len(moving) > MAX_POWERS:
        sheet.decide(f"The powers of {MAX_POWERS} of {len(moving)} phases are written out", "all are counted")


def check_torque(case: InverterCase, sheet: Sheet) -> None:
    """Peak torque against the torque limit at every speed, effective torque against rated torque at mean speed."""
    assert case.limits is not None
    assert case.data is not None
    lacking = case.torque_missing
    with sheet.section("Motor"):
        if case.rules.torque_limit is None:
            _assume_limits(sheet)
        sheet(formulas.torque_ratio, M=case.shaft.peak_torque, M_N=case.data.rated_torque)
        demanded, permitted = (None, None) if lacking else _worst_torque(case, case.limits)
        sheet.check("torque_limit", "Torque of the motor on the inverter", demanded, permitted, "N m",
                    "SEW 2001, 3.4 and 8.4: torque limit, breakdown reserve in field weakening",
                    missing=lacking)  # fmt: skip
        effective, mean = case.shaft.effective_torque, np.array(case.shaft.mean_speed)
        sheet.check("effective_torque", "Effective torque at mean speed", None if lacking else effective,
                    float(case.limits.continuous(mean)), "N m", "motor: rated torque, above the knee with 1/f",
                    formula="effective_torque", missing=lacking)  # fmt: skip
        _check_cooling(case, sheet)


def _assume_limits(sheet: Sheet) -> None:
    """Say which torque limits count where the user gives none."""
    text = "torque that the inverter lets the motor give, over rated torque"
    for key, where, value, source in (
        ("torque_limit_percent", "from a quarter of rated speed on", TORQUE_LIMIT, LIMIT_SOURCE),
        ("torque_limit_percent.starting", "below a quarter of rated speed", STARTING_LIMIT, STARTING_SOURCE),
    ):
        sheet.assume(f"drive.{key}", f"{text}, {where}", value=value, unit="%", symbol="k_H", source=source)


def _worst_torque(case: InverterCase, limits: InverterLimits) -> tuple[float, float]:
    """Torque and its limit at that end of a segment where most of the limit is used [N m]."""
    worst, found = 0.0, (case.shaft.peak_torque, limits.peak * limits.rated_torque)
    for cycle in case.shaft.cycles:
        torque = np.abs(case.shaft.torque(cycle))
        turns = cycle.speed_start * cycle.speed_end < 0
        # a segment that turns round passes standstill, where the limit may be lower than at both ends
        for speeds in (cycle.speed_start, cycle.speed_end, np.where(turns, 0.0, cycle.speed_start)):
            allowed = limits.largest(speeds * case.shaft.transmission.ratio)
            k = int(np.argmax(torque / allowed))
            if torque[k] / allowed[k] > worst:
                worst, found = float(torque[k] / allowed[k]), (float(torque[k]), float(allowed[k]))
    return found


def _check_cooling(case: InverterCase, sheet: Sheet) -> None:
    """What a motor with own fan may give at the lowest speed that it keeps, against its rated speed and its highest."""
    assert case.data is not None
    steady = case.sustained_speeds
    if steady.size == 0:
        return
    low, high, rated = float(steady.min()), float(steady.max()), case.data.rated_speed
    several = high > 1.0001 * low
    R = sheet(formulas.speed_range, n_2=high, n_1=low) if several else 1.0
    if low < rated and high < rated * (1 - 1e-9):
        label = "Rated speed, at which the own fan is sufficient, over the lowest steady speed"
        R = sheet(formulas.speed_range, key="cooling_range", label=label, n_2=rated, n_1=low)
    if R <= 1.0001:
        return
    if case.rules.cooling == "forced":
        sheet.decide("The motor may give its rating over the whole speed range", "it has a forced fan")
        return
    sheet.check("speed_range", "Speed range with own fan", R, SELF_COOLED_RANGE, "1", COOLING_SOURCE,
                formula="speed_range")  # fmt: skip
    if several or R > FULL_TORQUE_RANGE:
        _check_reduced_power(case, high, sheet)


def _check_reduced_power(case: InverterCase, high: float, sheet: Sheet) -> None:
    """Compare the effective torque with that of the next smaller motor; ``high`` is the highest steady speed [rad/s].

    Below rated speed a rating stands for its torque, so that the powers are compared at rated speed.
    """
    assert case.data is not None
    torque, rated = case.shaft.effective_torque, case.data.rated_speed
    power = sheet(shaft_power, key="effective_power", label="Effective torque at the highest steady speed", unit="kW",
                  M=torque, omega=high)  # fmt: skip
    if high < rated * (1 - 1e-9):
        power = sheet(shaft_power, key="effective_power_at_rated_speed", label="Effective torque at rated speed",
                      unit="kW", M=torque, omega=rated)  # fmt: skip
    limit = case.rules.reduced_power
    lacking = [case.torque_missing, "" if limit is not None else "rating of the next smaller motor"]
    demanded = None if case.torque_missing else power
    sheet.check("reduced_power", "Power with own fan over the speed range", demanded, limit, "kW", COOLING_SOURCE,
                formula="shaft_power", missing=", ".join(filter(None, lacking)))  # fmt: skip


def check_frequency(case: InverterCase, sheet: Sheet) -> None:
    """Highest frequency, and torque that is left in field weakening."""
    data, rules = case.data, case.rules
    assert data is not None
    with sheet.section("Frequency"):
        torque = sheet.value("steady_load_torque_on_motor") if sheet.has("steady_load_torque_on_motor") else 0.0
        highest = sheet(formulas.frequency_at_speed, key="highest_frequency", label="Frequency at the highest speed",
                        omega=case.shaft.max_speed, z_p=data.winding.poles, n_S=data.synchronous_speed,
                        n_N=data.rated_speed, r_M=abs(torque) / data.rated_torque)  # fmt: skip
        limit = rules.max_frequency
        source = "own limit"
        if limit is None and case.line.hangs:
            limit, source = HOIST_FREQUENCY, HOIST_SOURCE
            sheet.assume("drive.max_frequency", "highest frequency of a hoist", value=limit, unit="Hz",
                         symbol="f_max", source=source)  # fmt: skip
        if limit is not None:
            sheet.check("highest_frequency", "Highest frequency", highest, limit, "Hz", source,
                        formula="frequency_at_speed")  # fmt: skip
        if case.shaft.max_speed > case.knee_speed * (1 + 1e-9):
            _record_weakening(case, highest, sheet)


def _record_weakening(case: InverterCase, highest: float, sheet: Sheet) -> None:
    """What is left of rated and breakdown torque at the highest frequency."""
    data = case.data
    assert data is not None
    sheet.decide("The motor runs in field weakening", "its highest speed is above that of the base frequency")
    f_2 = max(case.knee, highest, case.rules.max_frequency or 0.0)
    sheet(formulas.weakened_rated_torque, M_N=data.rated_torque, f_1=case.knee, f_2=f_2)
    ratio = data.winding.breakdown_torque_ratio
    if ratio is None:
        sheet.check("breakdown_reserve", "Reserve of the breakdown torque", case.rules.breakdown_reserve, None, "1",
                    "SEW 2001, 3.4", missing="breakdown torque of the motor")  # fmt: skip
        return
    M_K = sheet(formulas.weakened_breakdown_torque, M_K=ratio * data.rated_torque, f_1=case.knee, f_2=f_2)
    torque = _largest_torque_above(case)
    if torque > 0:
        found = sheet(formulas.breakdown_reserve, M_K=M_K, M=torque)
        lacking = case.torque_missing
        sheet.check("breakdown_reserve", "Reserve of the breakdown torque", case.rules.breakdown_reserve,
                    None if lacking else found, "1", "SEW 2001, 3.4", formula="breakdown_reserve",
                    missing=lacking)  # fmt: skip


def _largest_torque_above(case: InverterCase) -> float:
    """Largest unsigned torque while the motor is faster than the knee [N m]."""
    found = 0.0
    for cycle in case.shaft.cycles:
        top = np.maximum(np.abs(cycle.speed_start), np.abs(cycle.speed_end)) * case.shaft.transmission.ratio
        torque = np.abs(case.shaft.torque(cycle))[top > case.knee_speed * (1 + 1e-6)]
        found = max(found, float(torque.max(initial=0.0)))
    return found


def check_currents(case: InverterCase, sheet: Sheet) -> None:
    """Currents of all motors on the inverter, and its power."""
    if case.inverter is None:
        return
    data, inverter, number = case.data, case.inverter, case.rules.motors_per_inverter
    assert data is not None
    source = "inverter: data sheet"
    with sheet.section("Inverter"):
        I_N = data.winding.rated_current
        if inverter.motor_power is not None:
            sheet.check("inverter_power", "Inverter: power of the motors", number * data.winding.rated_power,
                        inverter.motor_power, "kW", source)  # fmt: skip
        total = None if I_N is None else sheet(formulas.group_current, n_M=number, I_N=I_N)
        missing = "" if I_N is not None else "rated current of the motor"
        if inverter.rated_current is None:
            missing = ", ".join(filter(None, (missing, "rated current of the inverter")))
        sheet.check("inverter_current", "Inverter: rated current of the motors", total, inverter.rated_current, "A",
                    source, formula="group_current", missing=missing)  # fmt: skip
        if I_N is None or inverter.rated_current is None:
            return
        peak = inverter.overload_current
        if peak is None:
            peak = OVERLOAD * inverter.rated_current
            sheet.assume("drive.inverter.overload_current", "overload current of the inverter", value=peak, unit="A",
                         symbol="I_max", source="SEW 2001, 8.4: 150 %")  # fmt: skip
        k_T = sheet(torque_constant, M=data.rated_torque, I=I_N)
        current = sheet(motor_current, key="peak_current", symbol="I_peak", label="Current of one motor at peak torque",
                        M=case.shaft.peak_torque, k_T=k_T)  # fmt: skip
        lacking = case.torque_missing
        sheet.check("inverter_peak_current", "Inverter: peak current", None if lacking else number * current, peak,
                    "A", source, formula="motor_current", missing=lacking)  # fmt: skip
