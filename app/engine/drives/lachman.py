"""The criteria of Lachman and Mendricky for feed axes: inertia, three continuous torques, speed and dynamic torque.

M. Lachman, R. Mendricky: Dimenzovani pohonu, course Electric Drives and Servomechanisms, 2015, parts 6 and 7.
"""

from app.engine.drives.case import ServoCase
from app.engine.drives.rules import permitted_speed
from app.engine.formulas.conversion import speed_before_ratio, torque_before_ratio
from app.engine.formulas.servo import (
    inertia_ratio,
    lachman_dynamic_torque,
    lachman_friction_torque,
    lachman_motor_inertia,
    lachman_motor_speed,
    lachman_peak_torque,
    motor_acceleration,
    torque_with_reserve,
)
from app.engine.sheet import Sheet

_PART_6 = "Lachman, Mendricky 2015, part 6"


def check_lachman(case: ServoCase, sheet: Sheet) -> None:
    """Record the criteria on the sheet and, where a motor is chosen, check it."""
    _check_speed(case, sheet)
    _check_inertia(case, sheet)
    held = float(torque_before_ratio(abs(case.load.statics.holding), case.shaft.transmission.ratio))
    case.check_holding(sheet, held * case.rules.holding_reserve)
    _check_continuous(case, sheet)
    _check_dynamic(case, sheet)


def _check_speed(case: ServoCase, sheet: Sheet) -> None:
    demanded = sheet(lachman_motor_speed, key="required_motor_speed", n=case.shaft.max_speed)
    if case.motor is not None:
        limit = (permitted_speed(case.motor, case.rules), "highest speed of the motor")
        case.check(sheet, "motor_speed", (demanded, ""), limit, "rpm", _PART_6)


def _check_inertia(case: ServoCase, sheet: Sheet) -> None:
    demanded = None
    missing = case.shaft.transmission.missing
    if not missing:
        external = case.shaft.external_inertia
        demanded = sheet(lachman_motor_inertia, key="required_motor_inertia", J_ext=external)
        if case.motor is not None and case.rotor:
            sheet(inertia_ratio, J_ext=external, J_M=case.rotor)
    if case.motor is not None:
        case.check(
            sheet, "motor_inertia", (demanded, missing), (case.rotor, "rotor inertia of the motor"), "kg m2", _PART_6
        )


def _check_continuous(case: ServoCase, sheet: Sheet) -> None:
    """M_1 at standstill, M_2 at rapid speed, M_3 at working speed, each with the tolerance."""
    statics, ratio = case.load.statics, case.shaft.transmission.ratio
    rows = (
        ("friction_torque", "continuous_torque_at_standstill", 0.0, "Continuous torque at standstill"),
        ("rest_torque", "continuous_torque_at_rapid_speed", statics.rapid_speed, "Continuous torque at rapid speed"),
        (
            "working_torque",
            "continuous_torque_at_working_speed",
            statics.working_speed,
            "Continuous torque at working speed",
        ),
    )
    demands = _demands(case, sheet)
    if case.limits is None:
        return
    for key, limit_key, speed, label in rows:
        motor_speed = float(speed_before_ratio(speed, ratio))
        limit = case.limits.record_continuous(sheet, motor_speed, key=limit_key, label=label)
        if limit is not None:
            limit = sheet(torque_with_reserve, key=f"permitted_{limit_key}", symbol="M_perm", M=limit,
                          k_M=1 + case.rules.continuous_tolerance, label="Permitted, tolerance included")  # fmt: skip
        demand = (demands.get(key), case.shaft.transmission.missing)
        case.check(sheet, key, demand, (limit, case.limits.continuous_missing), "N m", _PART_6)


def _demands(case: ServoCase, sheet: Sheet) -> dict[str, float]:
    """M_1, M_2 and M_3 by the check they belong to; empty where the gear unit's data do not suffice."""
    transmission, statics = case.shaft.transmission, case.load.statics
    if transmission.missing:
        return {}
    friction = transmission.record(sheet, statics.friction, 1.0, key="friction_torque_on_motor", symbol="M_T",
                                   label="Torque of all passive resistances on the motor shaft")  # fmt: skip
    steady = ((statics.forward, 1.0), (statics.backward, -1.0))
    torque, direction = max(steady, key=lambda item: abs(transmission.one_torque(*item)))
    sign = 1.0 if torque >= 0 else -1.0
    m_1 = sheet(lachman_friction_torque, key="continuous_torque_for_friction",
                M_T=friction, c_T=case.rules.friction_share)  # fmt: skip
    m_2 = transmission.record(sheet, abs(torque), direction * sign, key="continuous_torque_at_rest", symbol="M_2",
                              label="Largest steady torque without process force on the motor shaft")  # fmt: skip
    m_3 = transmission.record(sheet, abs(statics.working), 1.0, key="continuous_torque_working", symbol="M_3",
                              label="Largest steady torque with process force on the motor shaft")  # fmt: skip
    return {"friction_torque": m_1, "rest_torque": m_2, "working_torque": m_3}


def _check_dynamic(case: ServoCase, sheet: Sheet) -> None:
    demanded = None
    transmission = case.shaft.transmission
    if not transmission.missing:
        total = case.shaft.rotor + case.shaft.external_inertia
        epsilon = float(motor_acceleration(case.shaft.hull.max_acceleration, transmission.ratio))
        working = transmission.one_torque(abs(case.load.statics.working), 1.0)
        dynamic = sheet(lachman_dynamic_torque, key="dynamic_torque", J_tot=total, epsilon=epsilon, M_P=working)
        demanded = sheet(lachman_peak_torque, key="required_peak_torque", M_dm=dynamic)
    if case.motor is None or case.limits is None:
        return
    limit = None if case.limits.peak_missing else float(case.limits.peak(case.shaft.max_speed))
    if case.torque_missing:
        demanded = None
    case.check(sheet, "dynamic_peak_torque", (demanded, case.torque_missing), (limit, case.limits.peak_missing), "N m",
               "Lachman, Mendricky 2015, part 7")  # fmt: skip
