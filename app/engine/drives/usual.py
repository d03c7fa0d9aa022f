"""The usual criteria of a servo motor: speed, inertia ratio, holding brake, peak and effective torque."""

import numpy as np

from app.engine.drives.case import ServoCase
from app.engine.drives.rules import permitted_speed
from app.engine.formulas.conversion import torque_before_ratio
from app.engine.formulas.servo import inertia_ratio, least_motor_inertia, speed_with_reserve, torque_with_reserve
from app.engine.sheet import Sheet


def check_usual(case: ServoCase, sheet: Sheet) -> None:
    """Record the criteria on the sheet and, where a motor is chosen, check it."""
    _check_speed(case, sheet)
    _check_inertia(case, sheet)
    _check_holding(case, sheet)
    if case.motor is not None:
        _check_peak(case, sheet)
        _check_effective(case, sheet)


def _check_speed(case: ServoCase, sheet: Sheet) -> None:
    top = case.shaft.max_speed
    sheet(speed_with_reserve, key="required_motor_speed", n=top, r_n=case.rules.speed_share)
    if case.motor is None:
        return
    rated = case.rules.speed_limit == "rated"
    limit = (
        permitted_speed(case.motor, case.rules),
        "rated speed of the motor" if rated else "highest speed of the motor",
    )
    source = "motor: rated speed and control reserve" if rated else "motor: highest speed and control reserve"
    case.check(sheet, "speed", (top, ""), limit, "rpm", source)


def _check_inertia(case: ServoCase, sheet: Sheet) -> None:
    limit = case.rules.inertia_ratio_limit
    ratio = None
    if not case.shaft.transmission.missing:
        external = case.shaft.external_inertia
        sheet(least_motor_inertia, key="required_motor_inertia", J_ext=external, lambda_J=limit)
        if case.motor is not None and case.rotor:
            ratio = sheet(inertia_ratio, J_ext=external, J_M=case.rotor)
    if case.motor is not None:
        case.check(sheet, "inertia_ratio", (ratio, case.torque_missing), (limit, ""), "1", "rules of the drive")


def _check_holding(case: ServoCase, sheet: Sheet) -> None:
    held = float(torque_before_ratio(abs(case.load.statics.holding), case.shaft.transmission.ratio))
    if case.needs_brake:
        demanded = sheet(torque_with_reserve, key="required_brake_torque", symbol="M_B,req",
                         M=held,
                         label="Torque that the holding brake must have", k_M=case.rules.holding_reserve)  # fmt: skip
        case.check_holding(sheet, demanded)


def _check_peak(case: ServoCase, sheet: Sheet) -> None:
    """The segment end with the largest share of the peak curve decides."""
    assert case.limits is not None
    limit = (None if case.limits.peak_missing else float(case.limits.peak(0.0)), case.limits.peak_missing)
    demanded = None
    if not case.torque_missing:
        torque = case.shaft.peak_torque
        if case.limits.motor.peak_curve:
            torque, speed = _deciding_end(case)
            limit = (float(case.limits.peak(speed)), "")
            case.limits.record_peak(sheet, speed, key="peak_torque_at_that_speed", label="Peak torque where it decides")
        demanded = sheet(torque_with_reserve, key="required_peak_torque", symbol="M_max,req", M=torque,
                         label="Peak torque that the motor must have", k_M=case.rules.peak_reserve)  # fmt: skip
    case.check(sheet, "peak_torque", (demanded, case.torque_missing), limit, "N m", "motor: data sheet, peak torque")


def _deciding_end(case: ServoCase) -> tuple[float, float]:
    """Unsigned torque [N m] and speed [rad/s] of the motor where the peak curve is used most."""
    assert case.limits is not None
    found = []
    for cycle in case.shaft.cycles:
        torque = np.abs(case.shaft.torque(cycle))
        for speed in (cycle.speed_start, cycle.speed_end):
            motor_speed = np.abs(speed) * case.shaft.transmission.ratio
            available = case.limits.peak(motor_speed)
            with np.errstate(divide="ignore", invalid="ignore"):
                used = np.where(torque > 0, torque / available, 0.0)
            worst = int(used.argmax())
            found.append((float(used[worst]), float(torque[worst]), float(motor_speed[worst])))
    _, torque_found, speed_found = max(found)
    return torque_found, speed_found


def _check_effective(case: ServoCase, sheet: Sheet) -> None:
    assert case.limits is not None
    permitted = case.limits.record_continuous(
        sheet, case.shaft.mean_speed, key="continuous_torque_at_mean_speed", label="Continuous torque at mean speed"
    )
    demanded = None if case.torque_missing else case.shaft.effective_torque
    limit = (permitted, case.limits.continuous_missing)
    case.check(sheet, "effective_torque", (demanded, case.torque_missing), limit, "N m", "motor: data sheet, S1 torque")
