"""Line-fed induction motor: one speed, started by a contactor, stopped by a brake."""

from collections.abc import Iterable, Sequence
from typing import Any, ClassVar, Literal

from app.engine.drives.base import DriveModel, DriveResult, Given
from app.engine.drives.line_fed import LineFed, MotorData, motor_data
from app.engine.drives.mains_charts import run_up_diagram
from app.engine.drives.mains_heating import record_heating
from app.engine.drives.mains_motion import (
    Brake,
    Stop,
    check_slip,
    record_brake_limit,
    record_least_flywheel,
    record_start,
    record_stop,
)
from app.engine.drives.mains_rules import CHECK_NAMES, LineFedRules
from app.engine.drives.mains_shaft import MotorSide
from app.engine.drives.parts import InductionMotorChoice, IndustrialGearUnitChoice, MotorBrakeChoice
from app.engine.formulas import braking as stop_formulas
from app.engine.formulas import induction as run
from app.engine.formulas.conversion import linear_speed
from app.engine.sheet import Sheet

HEADLINES = ("rated_torque", "run_up_torque", "star_run_up_torque", "permissible_cycles", "brake_life")


class MainsDrive(LineFedRules, DriveModel):
    """A cage motor on the mains with its gear unit and brake."""

    title: ClassVar[str] = "Line-fed motor"
    summary: ClassVar[str] = "Cage motor on the mains at one speed: run-up, starting frequency, braking."
    own_ramps: ClassVar[bool] = True

    kind: Literal["mains"] = "mains"
    motor: InductionMotorChoice | None = None
    gear_unit: IndustrialGearUnitChoice | None = None
    brake: MotorBrakeChoice | None = None

    def check(self, given: Given, sheet: Sheet) -> DriveResult:
        """Check motor, brake and gear unit in every state of the load."""
        line = LineFed.of(self, given, sheet)
        first = len(sheet.checks)
        winding = None if line.motor is None else line.motor.windings[-1]
        star = self.starting == "star_delta"
        data = motor_data(line, winding, sheet, star=star) if winding is not None else None
        sides = [_record_load(line, data, side, sheet) for side in line.sides()]
        line.check_power(data, sheet)
        if data is not None:
            line.record_gear_unit(data, sides, sheet)
        diagrams: tuple[Any, ...] = ()
        if data is not None and data.run_up is not None and line.motor_inertia is not None:
            starts = _record_starts(line, data, data.run_up, sides, sheet)
            record_heating(line, data, data.run_up, sides, starts, sheet)
            if line.brake is not None:
                _record_stops(line, data, line.brake, sides, sheet)
            diagrams = (run_up_diagram(data, sides),)
        line.check_holding(sheet)
        return DriveResult(ratio=line.ratio, checks=tuple(sheet.checks[first:]), headlines=HEADLINES, diagrams=diagrams)


def _record_load(line: LineFed, data: MotorData | None, side: MotorSide, sheet: Sheet) -> MotorSide:
    """Write one state of the load on the motor shaft; returns it at the speed at which the motor runs."""
    with sheet.section(f"Load on the motor shaft: {side.state.label}"):
        side.record(sheet)
        line.record_static(side, data, sheet)
        if data is not None:
            side = line.record_running(side, data, running_speed(data, side), sheet)
        side.record_curve(sheet)
    return side


def running_speed(data: MotorData, side: MotorSide) -> float:
    """Speed of the motor in steady running: rated speed, synchronous speed where the load drives it [rad/s]."""
    return data.synchronous_speed if side.driven_by_load else data.rated_speed


def _record_starts(line: LineFed, data: MotorData, M_H: float, sides: Sequence[MotorSide], sheet: Sheet) -> set[str]:
    """Run-up in every state; returns the keys of those that start."""
    started = set()
    for side in sides:
        with sheet.section(f"Run-up: {side.state.label}"):
            speed = running_speed(data, side)
            found = record_start(sheet, side, M_H, speed, delta=data.full_run_up if data.star else None)
            if found is not None:
                started.add(side.state.key)
                check_slip(sheet, side, found.acceleration, "slip_starting")
                record_least_flywheel(sheet, side, M_H, speed)
    return started


def _record_stops(line: LineFed, data: MotorData, brake: Brake, sides: Sequence[MotorSide], sheet: Sheet) -> None:
    """Stopping in every state, then brake work and life over the cycle."""
    stops: dict[str, Stop] = {}
    failures: list[Stop | None] = []
    for side in sides:
        with sheet.section(f"Braking: {side.state.label}"):
            found = record_stop(sheet, side, brake, running_speed(data, side), gravity=line.gravity)
            if found is None:
                continue
            stops[side.state.key] = found
            check_slip(sheet, side, found.deceleration, "slip_braking")
            record_brake_limit(sheet, side, brake, running_speed(data, side))
        if side.driven_by_load:
            failures.append(record_emergency_stop(line, data, brake, side, sheet))
    record_brake_duty(line, stops, failures, sides, sheet)


def record_emergency_stop(line: LineFed, data: MotorData, brake: Brake, side: MotorSide, sheet: Sheet) -> Stop | None:
    """A stop out of full speed, when the mains fail: where the load drives, above the synchronous speed."""
    with sheet.section(f"Mains failure: {side.state.label}"):
        if not side.driven_by_load:
            return record_stop(sheet, side, brake, data.rated_speed, gravity=line.gravity, name="_emergency")
        losses = side.factor(driving=False)
        speed = sheet(
            run.oversynchronous_speed, key=f"{side.state.key}_oversynchronous_speed", n_S=data.synchronous_speed,
            n_N=data.rated_speed, M_L=side.load_torque * losses, M_N=data.rated_torque,
        )  # fmt: skip
        label = "Speed of the load when it drives the motor"
        sheet(linear_speed, key=f"{side.state.key}_oversynchronous_load_speed", label=label, omega=speed, A=side.travel)
        return record_stop(sheet, side, brake, speed, gravity=line.gravity, name="_emergency")


def record_brake_duty(
    line: LineFed, stops: dict[str, Stop], failures: Iterable[Stop | None], sides: Sequence[MotorSide], sheet: Sheet
) -> None:
    """Work and life of the brake, and stopping accuracy.

    ``stops`` by state are those of every cycle; ``failures`` are stops after a failure of the mains, which wear out
    little but must be borne.
    """
    assert line.brake is not None
    with sheet.section("Brake"):
        source = "brake: data sheet"
        for side in sides:
            found = stops.get(side.state.key)
            if found is not None and line.rules.accuracy is not None and side.state.travel is not None:
                sheet.check(f"stopping_accuracy_{side.state.key}", f"{CHECK_NAMES['stopping_accuracy']}: "
                            f"{side.state.label}", found.distance * line.brake.tolerance, line.rules.accuracy, "mm",
                            "own demand", formula="stopping_accuracy")  # fmt: skip
        works = [one.work for one in (*stops.values(), *failures) if one is not None]
        if works:
            largest = max(works)
            limit = line.brake_product.max_work_per_operation
            sheet.check("brake_work", CHECK_NAMES["brake_work"], largest, limit, "J", source, formula="braking_work",
                        missing="" if limit is not None else "permitted work of the brake in one stop")  # fmt: skip
        started = [side for side in sides if side.state.starts > 0 and side.state.key in stops]
        if not started:
            return
        counts = [side.state.starts for side in started]
        work = sheet(stop_formulas.braking_work_of_cycle, z_k=counts, W_k=[stops[s.state.key].work for s in started])
        mean = sheet(stop_formulas.mean_braking_work, W_c=work, z_c=sum(counts))
        life = line.brake_product.work_until_adjustment
        if life is not None and mean > 0:
            time = sheet(stop_formulas.brake_life, W_N=life, W_B=mean, Z_B=sum(counts) / line.cycle_time)
            sheet(stop_formulas.brake_life_in_days, key="brake_life_days", L_B=time, t_d=line.rules.hours_per_day)
