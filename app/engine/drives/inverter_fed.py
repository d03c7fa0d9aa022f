"""Induction motor on an inverter: torque, field weakening, cooling, currents, braking resistor."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Annotated, ClassVar, Literal

import numpy as np

from app.engine.cycle import LoadCycle
from app.engine.drives.base import DriveModel, DriveResult, Given, ShaftPoints
from app.engine.drives.inverter_limits import (
    ROTOR_MISSING,
    InverterCase,
    check_currents,
    check_frequency,
    check_torque,
    record_powers,
    refuse_knee,
)
from app.engine.drives.line_fed import LineFed, motor_data
from app.engine.drives.mains import record_brake_duty
from app.engine.drives.mains_motion import Stop, check_slip, record_brake_limit, record_stop
from app.engine.drives.mains_rules import CHECK_NAMES, MotorRules
from app.engine.drives.parts import (
    BrakingResistorChoice,
    InductionMotorChoice,
    IndustrialGearUnitChoice,
    InverterChoice,
    MotorBrakeChoice,
)
from app.engine.drives.shaft import MotorShaft, power_segments, record_inertias, record_speeds, record_torques
from app.engine.formulas.conversion import speed_before_ratio
from app.engine.gear import Transmission
from app.engine.motion.profile import MotionProfile
from app.engine.quantity import Option, Quantity
from app.engine.resistor import check_chopper, check_resistor, record_braking
from app.engine.sheet import Check, Sheet

HEADLINES = ("motor_speed_max", "peak_torque", "effective_torque", "torque_ratio", "highest_frequency",
             "mean_braking_power", "peak_braking_power")  # fmt: skip
_GROUP, _INVERTER = "Inverter operation", "Inverter"


class InverterFedDrive(MotorRules, DriveModel):
    """A cage motor on a frequency inverter, with gear unit, brake and braking resistor."""

    title: ClassVar[str] = "Inverter-fed motor"
    summary: ClassVar[str] = "Cage motor on a frequency inverter: ramps, field weakening, cooling, braking resistor."

    kind: Literal["inverter_fed"] = "inverter_fed"
    torque_limit: Annotated[
        float | None,
        Quantity("%", symbol="k_H", gt=0, le=4, default=None, group=_GROUP,
                 about="torque that the inverter lets the motor give, over rated torque; empty: 150 %, and 130 % "
                 "below a quarter of rated speed"),
    ]  # fmt: skip
    knee_frequency: Annotated[
        float | None,
        Quantity("Hz", symbol="f_k", gt=0, le=1000, default=None, group=_GROUP,
                 about="frequency up to which the flux stays constant (87 Hz in delta); empty: rated frequency"),
    ]  # fmt: skip
    max_frequency: Annotated[
        float | None,
        Quantity("Hz", symbol="f_max", gt=0, le=1000, default=None, group=_GROUP,
                 about="highest permitted frequency; empty: 70 Hz for hoists, else no limit"),
    ]  # fmt: skip
    breakdown_reserve: Annotated[
        float,
        Quantity("1", symbol="k_K", ge=1, le=5, default=1.25, source="SEW 2001, 3.4", group=_GROUP,
                 about="breakdown torque over torque demanded in field weakening"),
    ]  # fmt: skip
    cooling: Annotated[
        Literal["self", "forced"],
        Option(default="self", source="usual", about="cooling of the motor", group=_GROUP,
               labels={"self": "own fan", "forced": "forced fan"}),
    ]  # fmt: skip
    reduced_power: Annotated[
        float | None,
        Quantity("kW", symbol="P_C", gt=0, le=5e7, default=None, group=_GROUP,
                 about="rating of the next smaller motor, which a motor with own fan may give over a speed range"),
    ]  # fmt: skip
    motors_per_inverter: Annotated[
        int, Option(default=1, ge=1, le=100, symbol="n_M", source="one motor", group=_INVERTER,
                    about="motors of this kind on one inverter"),
    ]  # fmt: skip
    chopper_limit: Annotated[
        float | None,
        Quantity("kW", symbol="P_BRC", gt=0, le=1e7, default=None, group=_INVERTER,
                 about="peak power of the braking chopper"),
    ]  # fmt: skip
    motor: InductionMotorChoice | None = None
    gear_unit: IndustrialGearUnitChoice | None = None
    brake: MotorBrakeChoice | None = None
    inverter: InverterChoice | None = None
    braking_resistor: BrakingResistorChoice | None = None

    def check(self, given: Given, sheet: Sheet) -> DriveResult:
        """Check motor, gear unit, inverter, brake and braking resistor over the cycle."""
        line = LineFed.of(self, given, sheet)
        first, sides = len(sheet.checks), line.sides()
        data = motor_data(line, line.motor.windings[-1], sheet, starts=False) if line.motor is not None else None
        for side in sides:
            with sheet.section(f"Load on the motor shaft: {side.state.label}"):
                side.record(sheet)
                side.record_curve(sheet)
                line.record_static(side, data, sheet)
        shaft = MotorShaft(given.load, _transmission(self, line), line.motor_inertia or 0.0)
        with sheet.section("Speed of the motor"):
            record_speeds(shaft, sheet)
        with sheet.section("Inertia on the motor shaft"):
            record_inertias(shaft, sheet)
        with sheet.section("Torque on the motor shaft"):
            record_torques(shaft, sheet)
        with sheet.section("Power on the motor shaft"):
            record_powers(shaft, given.load.cycle, sheet)
        case = InverterCase(
            rules=self, line=line, shaft=shaft, data=data, inverter=given.product("inverter"),
            steady_phases=_steady_phases(given.profile),
        )  # fmt: skip
        refuse_knee(case)
        if line.motor is not None and case.torque_missing:
            sheet.assume("drive.motor.rotor_inertia", "the rotor inertia is not known and left out of what is shown",
                         value=0.0, unit="kg m2", symbol="J_M", source=line.motor.source)  # fmt: skip
        if data is not None:
            line.record_gear_unit(data, sides, sheet, highest_speed=shaft.max_speed)
            check_torque(case, sheet)
            check_frequency(case, sheet)
            check_currents(case, sheet)
        self._record_stops(line, shaft, given.load.cycle, sheet)
        line.check_holding(sheet)
        self._check_resistor(given, case, sheet)
        return _result(case, sheet.checks[first:])

    def _check_resistor(self, given: Given, case: InverterCase, sheet: Sheet) -> None:
        cycle, resistor, shaft = given.load.cycle, given.product("braking_resistor"), case.shaft
        with sheet.section("Braking resistor"):
            braking = record_braking(sheet, power_segments(shaft, cycle), cycle.cycle_time)
            if braking is None:
                return
            lacking = case.torque_missing
            if resistor is None:
                sheet.decide("No braking resistor is checked", "none is chosen")
            if resistor is None or lacking:
                check_chopper(sheet, None if lacking else braking.peak, self.chopper_limit, lacking)
            if resistor is None:
                return
            if lacking:
                sheet.check("resistor_mean_power", "Braking resistor: mean power while braking", None, None, "kW",
                            "braking resistor: data sheet", missing=lacking)  # fmt: skip
                return
            check_resistor(sheet, braking, resistor, cycle_time=cycle.cycle_time, chopper_limit=self.chopper_limit)

    def _record_stops(self, line: LineFed, shaft: MotorShaft, cycle: LoadCycle, sheet: Sheet) -> None:
        """Stops by the brake out of creep speed, and out of full speed when the mains fail, in every state."""
        if line.brake is None:
            return
        if line.motor is not None and line.motor_inertia is None:
            sheet.check("brake_stops", CHECK_NAMES["brake_stops"], None, None, "N m", "brake: data sheet",
                        missing=ROTOR_MISSING)  # fmt: skip
            return
        if line.motor is None:
            sheet.assume("drive.motor.rotor_inertia", "no motor is chosen: its rotor is left out of every stop",
                         value=0.0, unit="kg m2", symbol="J_M", source="none: no motor is chosen")  # fmt: skip
        creep = _creep_speed(shaft, cycle)
        if creep:
            with sheet.section("Creep speed"):
                ratio = shaft.transmission.ratio
                sheet(speed_before_ratio, key="creep_motor_speed", label="Creep speed of the motor",
                      omega=creep / ratio, i=ratio)  # fmt: skip
        stops: dict[str, Stop] = {}
        failures: list[Stop | None] = []
        for side in line.sides():
            full = side.state.speed * side.ratio
            if creep:
                with sheet.section(f"Braking from creep speed: {side.state.label}"):
                    part = side.between(0.0, min(creep / full, 1.0))
                    found = record_stop(sheet, part, line.brake, creep, gravity=line.gravity)
                    if found is not None:
                        stops[side.state.key] = found
                        check_slip(sheet, side, found.deceleration, "slip_braking")
                        record_brake_limit(sheet, part, line.brake, creep)
            with sheet.section(f"Mains failure: {side.state.label}"):
                failures.append(record_stop(sheet, side, line.brake, full, gravity=line.gravity, name="_emergency"))
        record_brake_duty(line, stops, failures, line.sides(), sheet)


def _steady_phases(motion: MotionProfile) -> frozenset[str]:
    """Names of the phases that the motion runs through at constant speed."""
    change = np.abs(motion.speed_end - motion.speed_start)
    steady = (change <= 1e-6 * motion.max_speed) & (motion.mean_speed != 0)
    return frozenset(motion.label[k] for k in np.flatnonzero(steady)) - frozenset(
        motion.label[k] for k in np.flatnonzero(~steady)
    )


def _transmission(rules: InverterFedDrive, line: LineFed) -> Transmission:
    gear = line.gear
    if gear is not None:
        gear = replace(gear, efficiency=line.gear_efficiency, inertia=gear.inertia or 0.0)
    return Transmission(gear, rules.flywheel_inertia, line.environment.regeneration)


def _result(case: InverterCase, checks: Sequence[Check]) -> DriveResult:
    shaft, load, known = case.shaft, case.shaft.load, not case.torque_missing
    return DriveResult(
        ratio=case.line.ratio, checks=tuple(checks), headlines=HEADLINES, cycle=_points(case, load.cycle),
        opposite=None if load.opposite is None else _points(case, load.opposite), limits=case.limits,
        mean_speed=shaft.mean_speed, effective_torque=shaft.effective_torque if known else None,
        peak_torque=shaft.peak_torque if known else None,
    )  # fmt: skip


def _points(case: InverterCase, cycle: LoadCycle) -> ShaftPoints:
    shaft, ratio = case.shaft, case.shaft.transmission.ratio
    return ShaftPoints(
        time=np.concatenate(([0.0], np.cumsum(cycle.duration))), speed_start=cycle.speed_start * ratio,
        speed_end=cycle.speed_end * ratio, torque=None if case.torque_missing else shaft.torque(cycle),
        label=cycle.label,
    )  # fmt: skip


def _creep_speed(shaft: MotorShaft, cycle: LoadCycle) -> float:
    """Highest speed of the motor out of which the axis is put to standstill at once: by the brake; 0 where none is."""
    ends, starts = np.abs(cycle.speed_end), np.abs(np.roll(cycle.speed_start, -1))
    jumps = ends[(ends > 1e-9) & (starts == 0.0)]
    return float(jumps.max()) * shaft.transmission.ratio if jumps.size else 0.0
