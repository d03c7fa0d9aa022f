"""How often a line-fed motor may start: heating by the starts of every state of load, added up over the cycle."""

from collections.abc import Collection, Sequence
from dataclasses import replace

from app.engine.drives.line_fed import LineFed, MotorData
from app.engine.drives.mains_rules import CHECK_NAMES, LineFedRules
from app.engine.drives.mains_shaft import MotorSide
from app.engine.errors import EngineError
from app.engine.formulas import induction as run
from app.engine.sheet import Sheet

SOURCE = "motor: permitted starts without load, and SEW 2001, 7.9"
KEY = "starting_frequency"


def starting_factor(line: LineFed, side: MotorSide, sheet: Sheet) -> float | None:
    """K_P of one state: the user's own, else read from the tabulated chart. Raises EngineError for an unknown state."""
    known = {state.key for state in line.load.states}
    rows = line.rules.starting_factors if isinstance(line.rules, LineFedRules) else ()
    for index, row in enumerate(rows):
        if row.state not in known:
            names = ", ".join(sorted(known))
            raise EngineError(
                f"is no state of this load; there are {names}", field=("starting_factors", index, "state")
            )
    given = next((row.factor for row in rows if row.state == side.state.key), None)
    share = sheet.value(f"{side.state.key}_relative_running_power")
    text = f"factor of static power and duty on the starting frequency: {side.state.label}"
    return sheet.look_up("starting_frequency_k_p", text, symbol="K_P", x=share, family=line.duty, given=given)


def record_state(line: LineFed, data: MotorData, M_H: float, side: MotorSide, sheet: Sheet) -> float | None:
    """Write how often the motor may start in one state alone [1/s]; None where data lack."""
    Z_0, K_P = data.winding.no_load_starting_frequency, starting_factor(line, side, sheet)
    if Z_0 is None or K_P is None or line.motor_inertia is None:
        return None
    key, burden = side.state.key, side.changing.burden(M_H)
    known = f"{key}_equivalent_load_torque"
    if side.state.curve and sheet.has(known):
        burden = replace(burden, torque=sheet.value(known))
    K_J = sheet(run.inertia_factor, key=f"{key}_inertia_factor", J_M=line.motor_inertia, J_tot=burden.inertia)
    K_M = sheet(run.load_torque_factor, key=f"{key}_load_torque_factor", M_L=burden.torque, M_H=M_H)
    if burden.torque < 0:
        physical = sheet(run.physical_load_torque_factor, key=f"{key}_physical_load_torque_factor", M_L=burden.torque,
                         M_H=M_H)  # fmt: skip
        for name, value in (("physical", physical), ("capped", 1.0)):
            sheet(run.permissible_starting_frequency, key=f"{key}_{name}_{KEY}", Z_0=Z_0, K_J=K_J, K_M=value, K_P=K_P)
    return sheet(run.permissible_starting_frequency, key=f"{key}_{KEY}", Z_0=Z_0, K_J=K_J, K_M=max(K_M, 0.0), K_P=K_P)


def record_heating(
    line: LineFed, data: MotorData, M_H: float, sides: Sequence[MotorSide], started: Collection[str], sheet: Sheet
) -> None:
    """Write the permissible starts of every state in ``started`` (keys) and check the cycles per hour."""
    found: dict[str, float | None] = {}
    for side in (side for side in sides if side.state.key in started):
        with sheet.section(f"Starting frequency: {side.state.label}"):
            found[side.state.key] = record_state(line, data, M_H, side, sheet)
    check_cycles(line, found, sides, sheet)


def check_cycles(line: LineFed, found: dict[str, float | None], sides: Sequence[MotorSide], sheet: Sheet) -> None:
    """Add up the starts of a cycle and check how often it is repeated.

    ``found`` has the permissible starts of every state that the motor starts, None where data lack. A state of the
    cycle that is not in it cannot be started: then there is no number of cycles to judge.
    """
    started = [side.state for side in sides if side.state.starts > 0]
    if not started:
        return
    stuck = ", ".join(state.label for state in started if state.key not in found)
    rates = [rate for state in started if (rate := found.get(state.key)) is not None]
    demanded = 1 / line.cycle_time
    with sheet.section("Starting frequency of the cycle"):
        permitted, missing = None, "no-load starting frequency of the motor, or factor K_P of a state"
        if stuck:
            missing = f"run-up torque for a start in every state ({stuck})"
        elif len(rates) == len(started):
            if min(rates) <= 0:
                sheet.decide("No start is permitted", "in one state the load takes all of the run-up torque")
            permitted = sheet(run.permissible_cycles, z_k=[state.starts for state in started], Z_k=rates)
            missing = ""
        sheet.check(KEY, CHECK_NAMES[KEY], demanded, permitted, "1/h", SOURCE, formula="permissible_cycles",
                    missing=missing)  # fmt: skip
