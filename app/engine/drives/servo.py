"""Servo drive: motor, gear unit and amplifier against one load, every step and check on the sheet."""

from dataclasses import dataclass
from typing import ClassVar, Literal

import numpy as np

from app.engine.cycle import LoadCycle
from app.engine.drives.base import DriveModel, DriveResult, Given, ShaftPoints
from app.engine.drives.case import ServoCase
from app.engine.drives.lachman import check_lachman
from app.engine.drives.limits import ServoLimits
from app.engine.drives.parts import GearUnitChoice, MotorChoice, ServoDriveChoice
from app.engine.drives.rules import (
    CHECK_NAMES,
    LACHMAN_INERTIA_LIMIT,
    ServoRules,
    brake_needed,
    permitted_speed,
    rotor_inertia,
)
from app.engine.drives.shaft import MotorShaft, power_segments, record_inertias, record_speeds, record_torques
from app.engine.drives.usual import check_usual
from app.engine.environment import Environment
from app.engine.formulas.gear import highest_load_speed, ratio_for_inertia_limit, ratio_for_speed
from app.engine.formulas.gear_service import positioning_accuracy
from app.engine.gear import Transmission, check_gear_unit
from app.engine.inverter import Currents, check_drive, record_currents
from app.engine.mechanisms.load import Load
from app.engine.products import ServoDrive, ServoGearUnit, ServoMotor
from app.engine.resistor import record_braking
from app.engine.sheet import Check, Sheet

HEADLINES = (
    "motor_speed_max", "mean_speed", "motor_angular_acceleration", "load_inertia_on_motor", "external_inertia_on_motor",
    "total_inertia", "inertia_ratio", "required_motor_inertia", "required_motor_speed", "peak_load_torque_on_motor",
    "steady_load_torque_on_motor", "peak_torque", "effective_torque", "holding_torque_on_motor", "load_power_peak",
    "motor_power_peak", "motor_power_steady", "gear_output_peak", "gear_output_mean", "peak_current",
    "effective_current", "ratio_for_inertia_limit", "ratio_for_speed",
)  # fmt: skip
"""Sheet keys of the numbers that a result carries itself."""

SHOWN_FIRST = ("motor_speed_max", "peak_torque", "effective_torque", "mean_speed", "inertia_ratio")
"""Sheet keys of the numbers shown before all others."""


@dataclass(frozen=True, kw_only=True)
class ServoResult(DriveResult):
    """What a servo drive does on one load: points for charts, headline numbers and checks."""

    motor: ServoMotor | None
    gear: ServoGearUnit | None
    drive: ServoDrive | None
    rotor: float | None
    """Rotor inertia that was used [kg m2]; None where it is not known, 0 without a motor."""
    brake_needed: bool
    currents: Currents


class ServoDriveModel(ServoRules, DriveModel):
    """A servo drive: the rules it is judged by, and its parts as far as they are chosen.

    Without a motor the result is the demand at the motor shaft, with a rotor inertia of zero.
    """

    title: ClassVar[str] = "Servo drive"
    summary: ClassVar[str] = "Servomotor with low-backlash gear unit and amplifier, for positioning."

    kind: Literal["servo"] = "servo"
    motor: MotorChoice | None = None
    gear_unit: GearUnitChoice | None = None
    servo_drive: ServoDriveChoice | None = None

    def check(self, given: Given, sheet: Sheet) -> ServoResult:
        """Check motor, gear unit and servo drive against the load."""
        return check_servo(
            given.load, given.product("motor"), given.product("gear_unit"), given.product("servo_drive"), self,
            given.environment, sheet,
        )  # fmt: skip


def check_servo(
    load: Load,
    motor: ServoMotor | None,
    gear: ServoGearUnit | None,
    drive: ServoDrive | None,
    rules: ServoRules,
    environment: Environment,
    sheet: Sheet,
) -> ServoResult:
    """Check motor, gear unit and servo drive against a load; without a motor, compute what it must be able to do.

    Data that a product lacks give a check that is not made, never an error. The peak is judged in both directions of
    motion, the effective torque over the cycle as given.
    """
    first_check, first_step = len(sheet.checks), len(sheet.steps)
    case = _case(load, motor, gear, rules, environment, sheet)
    with sheet.section("Speed of the motor"):
        record_speeds(case.shaft, sheet)
    if gear is not None:
        with sheet.section("Gear unit"):
            check_gear_unit(load, gear, motor, rules, case.needs_brake, sheet)
    if not case.shaft.transmission.missing:
        with sheet.section("Inertia on the motor shaft"):
            record_inertias(case.shaft, sheet)
            _record_ratio_bounds(case, sheet)
        with sheet.section("Torque on the motor shaft"):
            record_torques(case.shaft, sheet)
    with sheet.section("Motor"):
        (check_lachman if rules.rule_set == "lachman" else check_usual)(case, sheet)
    currents = _currents(case, sheet)
    if not case.shaft.transmission.missing:
        with sheet.section("Braking energy"):
            cycle = load.cycle
            record_braking(sheet, power_segments(case.shaft, cycle), cycle.cycle_time)
        _record_accuracy(case, gear, sheet)
    if drive is not None:
        with sheet.section("Servo drive"):
            check_drive(drive, currents, sheet)
    numbers = {step.key: step.value for step in sheet.steps[first_step:] if step.key in HEADLINES}
    return _result(case, gear, drive, currents, tuple(sheet.checks[first_check:]), numbers)


def _case(
    load: Load,
    motor: ServoMotor | None,
    gear: ServoGearUnit | None,
    rules: ServoRules,
    environment: Environment,
    sheet: Sheet,
) -> ServoCase:
    """Join load, transmission and rotor, and put on the sheet what had to be assumed for it."""
    needs_brake = brake_needed(load, rules)
    rotor = 0.0 if motor is None else rotor_inertia(motor, needs_brake)
    transmission = Transmission.of(gear, rules, environment)
    missing = transmission.missing
    if motor is None:
        sheet.assume("drive.motor", "no motor is chosen: its rotor inertia is taken as zero", value=0.0, unit="kg cm2",
                     symbol="J_M")  # fmt: skip
    elif rotor is None:
        missing = ", ".join(filter(None, ("rotor inertia of the motor", missing)))
        sheet.assume("drive.motor.rotor_inertia", "the rotor inertia is not known and left out of what is shown",
                     value=0.0, unit="kg cm2", symbol="J_M", source=motor.source)  # fmt: skip
    elif needs_brake and motor.rotor_inertia_with_brake is None:
        sheet.assume("drive.motor.rotor_inertia_with_brake", "the inertia of the holding brake is unknown, left out",
                     value=rotor, unit="kg cm2", symbol="J_M", source=motor.source)  # fmt: skip
    limits = None if motor is None else ServoLimits(motor)
    if limits is not None:
        limits.assume(sheet)
    if gear is None:
        sheet.decide("The motor drives the load directly", "no gear unit is given")
    _decide_brake(load, rules, sheet)
    return ServoCase(
        load, motor, rules, MotorShaft(load, transmission, rotor or 0.0), rotor, missing, limits, needs_brake
    )


def _decide_brake(load: Load, rules: ServoRules, sheet: Sheet) -> None:
    """Say what a motor without brake leaves to others, where the axis would need one."""
    if rules.brake != "no" or not brake_needed(load, rules.model_copy(update={"brake": "auto"})):
        return
    if bool(load.cycle.braked.any()):
        sheet.decide("A brake outside the motor holds the axis", "none is wanted in the motor: it is not judged here")
    else:
        sheet.decide("Nothing but the motor holds the axis", "it does not rest by itself and no brake is wanted")


def _record_ratio_bounds(case: ServoCase, sheet: Sheet) -> None:
    """Between which ratios a gear unit keeps inertia limit and speed of this motor."""
    if case.motor is None:
        return
    limit = case.rules.inertia_ratio_limit if case.rules.rule_set == "usual" else LACHMAN_INERTIA_LIMIT
    inertia = max(cycle.inertia for cycle in case.shaft.cycles)
    if case.rotor:
        sheet(ratio_for_inertia_limit, J_L=inertia, lambda_J=limit, J_M=case.rotor)
    speed = permitted_speed(case.motor, case.rules)
    if speed is not None and case.shaft.hull.max_speed > 0:
        sheet(ratio_for_speed, omega_max=speed, omega_L=case.shaft.hull.max_speed)
        sheet(highest_load_speed, omega_max=speed, i=case.shaft.transmission.ratio)


def _record_accuracy(case: ServoCase, gear: ServoGearUnit | None, sheet: Sheet) -> None:
    """Positioning accuracy from backlash and encoder; a load that always pulls one way takes no backlash."""
    travel = next((state.travel for state in case.load.states if state.travel is not None), None)
    increments = case.rules.encoder_increments
    if increments is None or travel is None:
        return
    with sheet.section("Positioning accuracy"):
        backlash = 0.0 if gear is None else gear.backlash
        if abs(case.load.statics.holding) > 1e-9 * max(abs(case.load.statics.forward), 1e-12):
            sheet.decide("The backlash does not count", "gravity presses on the same flank of the teeth all the time")
            backlash = 0.0
        found = None
        if backlash is not None:
            found = sheet(positioning_accuracy, phi_G=backlash, A=travel, n_inc=increments,
                          i=case.shaft.transmission.ratio)  # fmt: skip
        if case.rules.accuracy is not None:
            missing = "" if found is not None else "backlash of the gear unit"
            sheet.check("positioning_accuracy", CHECK_NAMES["positioning_accuracy"], found, case.rules.accuracy, "mm",
                        "own demand", formula="positioning_accuracy", missing=missing)  # fmt: skip


def _currents(case: ServoCase, sheet: Sheet) -> Currents:
    if case.motor is None:
        return Currents(missing="motor")
    if case.torque_missing:
        return Currents(missing=case.torque_missing)
    with sheet.section("Currents of the motor"):
        return record_currents(case.motor, case.shaft.peak_torque, case.shaft.effective_torque, sheet)


def _points(shaft: MotorShaft, cycle: LoadCycle) -> ShaftPoints:
    ratio = shaft.transmission.ratio
    return ShaftPoints(
        time=np.concatenate(([0.0], np.cumsum(cycle.duration))),
        speed_start=cycle.speed_start * ratio,
        speed_end=cycle.speed_end * ratio,
        torque=None if shaft.transmission.missing else shaft.torque(cycle),
        label=cycle.label,
    )


def _result(
    case: ServoCase,
    gear: ServoGearUnit | None,
    drive: ServoDrive | None,
    currents: Currents,
    checks: tuple[Check, ...],
    numbers: dict[str, float],
) -> ServoResult:
    shaft = case.shaft
    known = not case.torque_missing
    return ServoResult(
        headlines=SHOWN_FIRST,
        motor=case.motor,
        gear=gear,
        drive=drive,
        ratio=shaft.transmission.ratio,
        rotor=case.rotor,
        brake_needed=case.needs_brake,
        cycle=_points(shaft, case.load.cycle),
        opposite=None if case.load.opposite is None else _points(shaft, case.load.opposite),
        limits=case.limits,
        mean_speed=shaft.mean_speed,
        effective_torque=shaft.effective_torque if known else None,
        peak_torque=shaft.peak_torque if known else None,
        currents=currents,
        checks=checks,
        numbers=numbers,
    )
