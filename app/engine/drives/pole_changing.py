"""Pole-changing motor on the mains: runs at the high speed, changes over to the low one, stops from there."""

from collections.abc import Collection, Sequence
from typing import Annotated, ClassVar, Literal

from app.engine.diagram import Diagram
from app.engine.drives.base import DriveModel, DriveResult, Given
from app.engine.drives.line_fed import LineFed, MotorData, motor_data
from app.engine.drives.mains import record_brake_duty, record_emergency_stop
from app.engine.drives.mains_charts import run_up_diagram
from app.engine.drives.mains_heating import check_cycles, record_state
from app.engine.drives.mains_motion import (
    Brake,
    Stop,
    check_slip,
    record_brake_limit,
    record_least_flywheel,
    record_start,
    record_stop,
)
from app.engine.drives.mains_rules import LineFedRules
from app.engine.drives.mains_shaft import MotorSide
from app.engine.drives.parts import InductionMotorChoice, IndustrialGearUnitChoice, MotorBrakeChoice
from app.engine.errors import EngineError
from app.engine.formulas import induction as run
from app.engine.formulas import pole_changing as change
from app.engine.formulas.conversion import linear_speed
from app.engine.quantity import Option, Quantity
from app.engine.sheet import Sheet

HEADLINES = ("run_up_torque_high", "change_over_torque", "permissible_cycles", "brake_life")
_GROUP = "Changing over"
NO_SOFT_CHANGE = "SEW 2001, 8.3: no soft change on hoists, the load would run away"


class PoleChangingDrive(LineFedRules, DriveModel):
    """A motor with two windings on the mains, its gear unit and brake."""

    title: ClassVar[str] = "Pole-changing motor"
    summary: ClassVar[str] = "Two speeds on the mains: change-over, creep speed, stopping accuracy."
    own_ramps: ClassVar[bool] = True

    kind: Literal["pole_changing"] = "pole_changing"
    soft_change: Annotated[
        bool,
        Option(default=False, source="three phases", about="soft change-over on two phases, half the torque",
               group=_GROUP),
    ]  # fmt: skip
    change_factor: Annotated[
        float,
        Quantity("1", symbol="k_U", gt=0, le=10, default=2.5, source="SEW 2001, 7.9", group=_GROUP,
                 about="change-over torque over run-up torque of the low-speed winding"),
    ]  # fmt: skip
    heating_factor: Annotated[
        float,
        Quantity("1", symbol="k_th", gt=0, le=1, default=0.7, source="SEW 2001, 8.3: heating by the change-over",
                 group=_GROUP, about="share of the starting frequency that remains"),
    ]  # fmt: skip
    start_winding: Annotated[
        Literal["high", "low"],
        Option(default="high", source="one contactor less", about="winding that starts the load", group=_GROUP,
               labels={"high": "high speed", "low": "low speed, then changed up"}),
    ]  # fmt: skip
    low_start_gain: Annotated[
        float,
        Quantity("1", symbol="k_low", ge=1, le=2, default=1.25, source="SEW 2001, 8.3: about 25 % more", group=_GROUP,
                 about="gain of the starting frequency by starting on the low-speed winding"),
    ]  # fmt: skip
    motor: InductionMotorChoice | None = None
    gear_unit: IndustrialGearUnitChoice | None = None
    brake: MotorBrakeChoice | None = None

    def check(self, given: Given, sheet: Sheet) -> DriveResult:
        """Check motor, brake and gear unit in every state of the load."""
        line = LineFed.of(self, given, sheet)
        first, sides = len(sheet.checks), line.sides()
        low = high = None
        if line.motor is not None:
            if len(line.motor.windings) != 2:
                raise EngineError("a pole-changing motor has two windings", field="motor")
            star = {self.start_winding} if self.starting == "star_delta" else set()
            low = motor_data(line, line.motor.windings[0], sheet, "_low", star="low" in star)
            high = motor_data(line, line.motor.windings[1], sheet, "_high", star="high" in star)
        sides = [_record_load(line, low, high, side, sheet) for side in sides]
        line.check_power(high, sheet, low=None if high is None else low)
        diagrams: tuple[Diagram, ...] = ()
        if low and high and None not in (low.run_up, high.run_up, line.motor_inertia):
            line.record_gear_unit(high, sides, sheet)
            _record(self, line, low, high, sides, sheet)
            diagrams = (run_up_diagram(high, sides, (low,)),)
        line.check_holding(sheet)
        return DriveResult(ratio=line.ratio, checks=tuple(sheet.checks[first:]), headlines=HEADLINES, diagrams=diagrams)


def _record_load(
    line: LineFed, low: MotorData | None, high: MotorData | None, side: MotorSide, sheet: Sheet
) -> MotorSide:  # fmt: skip
    """Write one state of the load on the motor shaft; returns it at the high speed of the motor.

    On the low-speed winding the load is that of creeping: without a process that acts at full speed only.
    """
    with sheet.section(f"Load on the motor shaft: {side.state.label}"):
        side.record(sheet)
        line.record_static(side, high, sheet)
        for data, name in ((low, "_low"), (high, "")):
            if data is not None:
                speed = data.synchronous_speed if side.driven_by_load else data.rated_speed
                own = line.record_running(side.without_process if name else side, data, speed, sheet, name)
                side = side if name else own
        side.record_curve(sheet)
    return side


def _speeds(low: MotorData, high: MotorData, side: MotorSide) -> tuple[float, float]:
    """Low and high speed of the motor in steady running: synchronous where the load drives [rad/s]."""
    if side.driven_by_load:
        return low.synchronous_speed, high.synchronous_speed
    return low.rated_speed, high.rated_speed


def _record(
    rules: PoleChangingDrive, line: LineFed, low: MotorData, high: MotorData, sides: Sequence[MotorSide], sheet: Sheet
) -> None:
    started = [side.state.key for side in sides if _record_run_up(rules, low, high, side, sheet)]
    _record_changes(rules, line, low, high, sides, sheet)
    _record_heating(rules, line, high, sides, started, sheet)
    if line.brake is not None:
        _record_stops(line, low, high, line.brake, sides, sheet)


def _record_run_up(rules: PoleChangingDrive, low: MotorData, high: MotorData, side: MotorSide, sheet: Sheet) -> bool:
    """Write the run-up of one state on the high-speed winding, and on the low-speed one where that starts the load.

    Returns whether the motor starts the load.
    """
    assert high.run_up is not None
    assert low.run_up is not None
    n_1, n_2 = _speeds(low, high, side)
    with sheet.section(f"Run-up: {side.state.label}"):
        found = record_start(sheet, side, high.run_up, n_2, delta=high.full_run_up if high.star else None)
        if found is not None:
            check_slip(sheet, side, found.acceleration, "slip_starting")
            record_least_flywheel(sheet, side, high.run_up, n_2)
    if rules.start_winding == "high":
        return found is not None
    with sheet.section(f"Run-up on the low-speed winding: {side.state.label}"):
        words, part = ", low-speed winding", side.between(0.0, n_1 / n_2)
        first = record_start(sheet, part, low.run_up, n_1, "_low", words, delta=low.full_run_up if low.star else None)
        if first is not None:
            check_slip(sheet, side, first.acceleration, "slip_starting", "_low", words)
    return found is not None and first is not None


def _record_changes(
    rules: PoleChangingDrive, line: LineFed, low: MotorData, high: MotorData, sides: Sequence[MotorSide], sheet: Sheet
) -> None:
    """Change-over in every state."""
    with sheet.section("Changing over"):
        soft = 0.5 if rules.soft_change else 1.0
        M_U = sheet(change.change_over_torque, k_U=rules.change_factor, k_s=soft, M_H=low.full_run_up)
        if rules.soft_change and line.hangs:
            sheet.check("soft_change", "Soft change-over of a hoist", 1.0, 0.0, "1", NO_SOFT_CHANGE)
    for side in sides:
        with sheet.section(f"Changing over: {side.state.label}"):
            key, turning = side.state.key, side.state.travel is None
            n_1, n_2 = _speeds(low, high, side)
            part = side.between(n_1 / n_2, 1.0).averaged
            burden = part.record_burden(sheet, -M_U, "change", "Changing over")
            if M_U + burden.torque <= 0:
                sheet.check(f"change_over_{key}", f"Change-over torque: {side.state.label}", -burden.torque, M_U, "N m",
                            "motor: run-up torque of the low-speed winding")  # fmt: skip
                continue
            time = sheet(change.change_over_time, key=f"{key}_change_over_time", J_tot=burden.inertia, n_2=n_2,
                         n_1=n_1, M_U=M_U, M_L=burden.torque)  # fmt: skip
            v = sheet(linear_speed, key=f"{key}_high_speed", label="High speed of the load", omega=n_2, A=side.travel)
            v_1 = sheet(linear_speed, key=f"{key}_low_speed", symbol="v_1", label="Low speed of the load", omega=n_1,
                        A=side.travel)  # fmt: skip
            rate = sheet(change.change_over_deceleration, key=f"{key}_change_over_deceleration",
                         unit="rad/s2" if turning else "", v=v, v_1=v_1, t_U=time)  # fmt: skip
            sheet(change.change_over_distance, key=f"{key}_change_over_distance", unit="rad" if turning else "", v=v,
                  v_1=v_1, t_U=time)  # fmt: skip
            check_slip(sheet, side, rate, "slip_changing")
            if side.state.permissible_acceleration:
                bare = part.with_added(0.0).burden(-M_U)
                sheet(change.least_flywheel_for_change, key=f"{key}_least_flywheel_for_change", M_U=M_U,
                      M_L=bare.torque, v=v, v_1=v_1, a_p=side.state.permissible_acceleration, n_2=n_2, n_1=n_1,
                      J_tot=bare.inertia)  # fmt: skip


def _record_heating(
    rules: PoleChangingDrive, line: LineFed, high: MotorData, sides: Sequence[MotorSide], starts: Collection[str],
    sheet: Sheet,
) -> None:  # fmt: skip
    """Permissible starts of every state in ``starts`` (keys), with the heating of the change-over."""
    assert high.run_up is not None
    plain: dict[str, float] = {}
    found: dict[str, float | None] = {}
    for side in (side for side in sides if side.state.key in starts):
        with sheet.section(f"Starting frequency: {side.state.label}"):
            rate, key = record_state(line, high, high.run_up, side, sheet), side.state.key
            if rate is None:
                found[key] = None
                continue
            plain[key], factor = rate, rules.heating_factor
            rate = sheet(change.starting_frequency_with_change, key=f"{key}_starting_frequency_with_change", Z=rate,
                         k_th=factor)  # fmt: skip
            if rules.start_winding == "low":
                label = "Permissible starting frequency when started on the low-speed winding"
                rate = sheet(change.starting_frequency_with_change, key=f"{key}_starting_frequency_low_start",
                             label=label, Z=rate, k_th=rules.low_start_gain)  # fmt: skip
            found[key] = rate
    started = [side.state for side in sides if side.state.starts > 0]
    if started and all(state.key in plain for state in started):
        with sheet.section("Starting frequency of the cycle"):
            label = "Cycles that the motor bears without the heating of the change-over"
            sheet(run.permissible_cycles, key="permissible_cycles_before_change", label=label,
                  z_k=[state.starts for state in started], Z_k=[plain[state.key] for state in started])  # fmt: skip
    check_cycles(line, found, sides, sheet)


def _record_stops(
    line: LineFed, low: MotorData, high: MotorData, brake: Brake, sides: Sequence[MotorSide], sheet: Sheet
) -> None:
    """Stops from the low speed, and from the high one where the mains fail."""
    stops: dict[str, Stop] = {}
    failures: list[Stop | None] = []
    for side in sides:
        n_1, n_2 = _speeds(low, high, side)
        with sheet.section(f"Braking from the low speed: {side.state.label}"):
            part = side.between(0.0, n_1 / n_2)
            found = record_stop(sheet, part, brake, n_1, gravity=line.gravity)
            if found is not None:
                stops[side.state.key] = found
                check_slip(sheet, side, found.deceleration, "slip_braking")
                record_brake_limit(sheet, part, brake, n_1)
        failures.append(record_emergency_stop(line, high, brake, side, sheet))
    record_brake_duty(line, stops, failures, sides, sheet)
