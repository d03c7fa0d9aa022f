"""The line-fed motor before a variable-speed gear: its power, its run-up and its stop at the highest speed."""

from dataclasses import dataclass

from app.engine.drives.base import Given
from app.engine.drives.line_fed import MotorData, brake_of, motor_inertia_of, record_rated_torque
from app.engine.drives.mains import running_speed
from app.engine.drives.mains_motion import Brake, check_slip, record_brake_limit, record_start, record_stop
from app.engine.drives.mains_rules import CHECK_NAMES, BrakingRules
from app.engine.drives.mains_shaft import Gravity, MotorSide
from app.engine.drives.variator_range import Demand
from app.engine.formulas import induction as run
from app.engine.formulas.conversion import torque_before_ratio
from app.engine.formulas.gear import ratio_for_speed
from app.engine.formulas.variator import variator_input_power
from app.engine.products import InductionMotor, MotorBrake, Winding
from app.engine.sheet import Sheet

SOURCE = "motor: data sheet"
BRAKE_SOURCE = "brake: data sheet"


@dataclass(frozen=True, kw_only=True)
class VariatorLine:
    """What the motor is checked against. The gear is set to the highest speed: the motor feels most of the load there.

    ``efficiency`` is that of variable-speed gear and gear unit together, None where it is not known.
    """

    given: Given
    rules: BrakingRules
    demand: Demand
    efficiency: float | None

    @property
    def hangs(self) -> bool:
        """Whether gravity moves the axis when nothing holds it."""
        statics = self.given.load.statics
        return abs(statics.holding) > 1e-9 * max(abs(statics.forward), abs(statics.backward), 1e-12)

    @property
    def gravity(self) -> Gravity | None:
        """What pulls at the load while nothing holds it; None where nothing does."""
        return Gravity(tuple(self.demand.states), self.given.load.statics) if self.hangs else None

    def sides(self, speed: float, inertia: float, efficiency: float) -> list[MotorSide]:
        """Every state of the load on the shaft of a motor of that rated speed and inertia."""
        return [
            MotorSide(state=state, ratio=speed / self.demand.highest_speed, gear_efficiency=efficiency,
                      motor_inertia=inertia, model=self.given.environment.regeneration)
            for state in self.demand.states
        ]  # fmt: skip


def record_motor(line: VariatorLine, sheet: Sheet) -> float:
    """Write and check the motor and its brake; returns the ratio at the highest speed, 1 without motor."""
    motor: InductionMotor | None = line.given.product("motor")
    winding = None if motor is None else motor.windings[-1]
    if motor is None or winding is None or winding.rated_speed is None:
        if motor is not None:
            sheet.check("static_power", CHECK_NAMES["static_power"], None, None, "kW", SOURCE,
                        missing="rated speed of the motor")  # fmt: skip
        _check_holding(line, None, sheet)
        return 1.0
    with sheet.section("Motor"):
        _check_power(line, winding, sheet)
        ratio = sheet(ratio_for_speed, key="ratio_at_highest_speed", label="Ratio of motor to output at that speed",
                      omega_max=winding.rated_speed, omega_L=line.demand.highest_speed)  # fmt: skip
        sheet(torque_before_ratio, key="static_torque_without_gear", symbol="M_S", M=line.demand.highest_speed_torque,
              i=ratio, label="Torque of the load on the motor shaft, losses of the gears left out")  # fmt: skip
        data = _motor_data(winding, winding.rated_speed, sheet)
        brake: MotorBrake | None = line.given.product("brake")
        inertia, setting = motor_inertia_of(motor, brake, sheet), brake_of(line.rules, brake, sheet)
    known = (data.run_up, inertia, line.efficiency)
    if data.run_up is None or inertia is None or line.efficiency is None:
        words = ("run-up torque of the motor", "inertia of the motor", "efficiency of the variable-speed gear")
        lacking = ", ".join(word for word, value in zip(words, known, strict=True) if value is None)
        sheet.check("run_up_torque", CHECK_NAMES["run_up_torque"], None, None, "N m", SOURCE, missing=lacking)
    else:
        sides = line.sides(winding.rated_speed, inertia, line.efficiency)
        _record_starts(data, data.run_up, sides, sheet)
        if setting is not None:
            _record_stops(line, data, setting, sides, sheet)
    _check_holding(line, ratio, sheet)
    return ratio


def _check_power(line: VariatorLine, winding: Winding, sheet: Sheet) -> None:
    power = None
    if line.efficiency is not None:
        power = sheet(variator_input_power, key="motor_power", P_a=line.demand.power, eta_V=line.efficiency)
    lacking = "" if power is not None else "efficiency of the variable-speed gear"
    sheet.check("static_power", CHECK_NAMES["static_power"], power, winding.rated_power, "kW", SOURCE,
                formula="variator_input_power", missing=lacking)  # fmt: skip


def _motor_data(winding: Winding, rated_speed: float, sheet: Sheet) -> MotorData:
    sync = sheet(run.synchronous_speed, f_1=winding.frequency, z_p=winding.poles)
    M_N = record_rated_torque(winding, rated_speed, sheet)
    M_H = winding.run_up_torque
    if M_H is None and winding.run_up_torque_ratio is not None:
        M_H = sheet(run.run_up_torque, r_H=winding.run_up_torque_ratio, M_N=M_N)
    return MotorData(winding, rated_speed, sync, M_N, M_H, M_H)


def _record_starts(data: MotorData, M_H: float, sides: list[MotorSide], sheet: Sheet) -> None:
    """Run-up in every state of the load."""
    for side in sides:
        with sheet.section(f"Run-up: {side.state.label}"):
            side.record(sheet)
            started = record_start(sheet, side, M_H, running_speed(data, side))
            if started is not None:
                check_slip(sheet, side, started.acceleration, "slip_starting")


def _record_stops(line: VariatorLine, data: MotorData, brake: Brake, sides: list[MotorSide], sheet: Sheet) -> None:
    """Stop in every state of the load."""
    for side in sides:
        with sheet.section(f"Braking: {side.state.label}"):
            speed = running_speed(data, side)
            found = record_stop(sheet, side, brake, speed, gravity=line.gravity)
            if found is None:
                continue
            check_slip(sheet, side, found.deceleration, "slip_braking")
            record_brake_limit(sheet, side, brake, speed)
            if line.rules.accuracy is not None and side.state.travel is not None:
                sheet.check(f"stopping_accuracy_{side.state.key}", f"{CHECK_NAMES['stopping_accuracy']}: "
                            f"{side.state.label}", found.distance * brake.tolerance, line.rules.accuracy, "mm",
                            "own demand", formula="stopping_accuracy")  # fmt: skip


def _check_holding(line: VariatorLine, ratio: float | None, sheet: Sheet) -> None:
    """Check the brake against the torque that holds the load, where gravity pulls."""
    if not line.hangs:
        return
    brake: MotorBrake | None = line.given.product("brake")
    if ratio is None or brake is None or brake.torque is None:
        sheet.check("brake_holding", CHECK_NAMES["brake_holding"], None, None, "N m", BRAKE_SOURCE,
                    missing="brake with its torque, and speed of the motor")  # fmt: skip
        return
    with sheet.section("Brake"):
        label = "Torque that holds the load, on the motor shaft"
        torque = sheet(torque_before_ratio, key="holding_torque_on_motor", symbol="M_hold", label=label, i=ratio,
                       M=line.given.load.statics.holding)  # fmt: skip
        sheet.check("brake_holding", CHECK_NAMES["brake_holding"], abs(torque) * line.rules.holding_reserve,
                    brake.torque, "N m", BRAKE_SOURCE, formula="torque_before_ratio")  # fmt: skip
