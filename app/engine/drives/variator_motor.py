"""The line-fed motor before a variable-speed gear: its power, and its run-up at the highest speed."""

from app.engine.drives.base import Given
from app.engine.drives.mains_motion import check_slip, record_start
from app.engine.drives.mains_rules import CHECK_NAMES
from app.engine.drives.mains_shaft import MotorSide
from app.engine.drives.variator_range import Demand
from app.engine.formulas import induction as run
from app.engine.formulas.conversion import torque_before_ratio
from app.engine.formulas.gear import ratio_for_speed
from app.engine.formulas.variator import variator_input_power
from app.engine.products import InductionMotor, Winding
from app.engine.sheet import Sheet

SOURCE = "motor: data sheet"


def record_motor(given: Given, demand: Demand, efficiency: float | None, sheet: Sheet) -> float:
    """Write and check the motor at the highest speed of the machine; returns the ratio set there, 1 without motor.

    The gear is set to its highest speed for the run-up: the external inertia on the motor shaft is largest there.
    """
    if given.load.statics.holding and abs(given.load.statics.holding) > 1e-9 * abs(given.load.statics.forward):
        sheet.check("brake_holding", CHECK_NAMES["brake_holding"], None, None, "N m", "brake: data sheet",
                    missing="a brake, which is not part of this drive")  # fmt: skip
    motor: InductionMotor | None = given.product("motor")
    if motor is None:
        return 1.0
    with sheet.section("Motor"):
        power = None
        if efficiency is not None:
            power = sheet(variator_input_power, key="motor_power", P_a=demand.power, eta_V=efficiency)
        winding = motor.windings[-1]
        lacking = "" if power is not None else "efficiency of the variable-speed gear"
        sheet.check("static_power", CHECK_NAMES["static_power"], power, winding.rated_power, "kW", SOURCE,
                    formula="variator_input_power", missing=lacking)  # fmt: skip
        if winding.rated_speed is None:
            return 1.0
        ratio = sheet(ratio_for_speed, key="ratio_at_highest_speed", label="Ratio of motor to output at that speed",
                      omega_max=winding.rated_speed, omega_L=demand.highest_speed)  # fmt: skip
        sheet(torque_before_ratio, key="static_torque_without_gear", symbol="M_S", M=demand.highest_speed_torque,
              i=ratio, label="Torque of the load on the motor shaft, losses of the gears left out")  # fmt: skip
        M_H = _run_up_torque(winding, winding.rated_speed, sheet)
    inertia = motor.rotor_inertia_with_brake if motor.rotor_inertia_with_brake is not None else motor.rotor_inertia
    _record_starts(given, demand, (M_H, inertia, efficiency), winding.rated_speed, sheet)
    return ratio


def _run_up_torque(winding: Winding, rated_speed: float, sheet: Sheet) -> float | None:
    """Mean run-up torque [N m], None where the source gives none."""
    M_N = sheet(run.rated_torque, P_N=winding.rated_power, n_N=rated_speed)
    if winding.run_up_torque is not None:
        return winding.run_up_torque
    if winding.run_up_torque_ratio is None:
        return None
    return sheet(run.run_up_torque, r_H=winding.run_up_torque_ratio, M_N=M_N)


def _record_starts(
    given: Given, demand: Demand, known: tuple[float | None, float | None, float | None], speed: float, sheet: Sheet
) -> None:
    """Run-up in every state; ``known``: run-up torque and inertia of the motor, efficiency of the gears."""
    M_H, inertia, efficiency = known
    if M_H is None or inertia is None or efficiency is None:
        words = ("run-up torque of the motor", "inertia of the motor", "efficiency of the variable-speed gear")
        lacking = ", ".join(word for word, value in zip(words, known, strict=True) if value is None)
        sheet.check("run_up_torque", CHECK_NAMES["run_up_torque"], None, None, "N m", SOURCE, missing=lacking)
        return
    for state in demand.states:
        side = MotorSide(state=state, ratio=speed / demand.highest_speed, gear_efficiency=efficiency,
                         motor_inertia=inertia, model=given.environment.regeneration)  # fmt: skip
        with sheet.section(f"Run-up: {state.label}"):
            side.record(sheet)
            started = record_start(sheet, side, M_H, speed)
            if started is not None:
                check_slip(sheet, side, started.acceleration, "slip_starting")
