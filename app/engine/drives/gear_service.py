"""Whether an industrial gear unit bears its load: service factor, overhung load, self-locking, backlash."""

from dataclasses import dataclass
from typing import Annotated, Literal

from app.engine.formulas import gear_service as formulas
from app.engine.formulas.efficiency import retrograde_efficiency
from app.engine.mechanisms.load import Load
from app.engine.products import GearUnit
from app.engine.quantity import Declared, Option, Quantity
from app.engine.sheet import Sheet

_GROUP = "Gear unit"
SOURCE = "gear unit: data sheet"
CLASSES = ((0.2, 1), (3.0, 2), (10.0, 3))
"""Largest factor of inertia of load class I, II and III: SEW 2001, 6.2."""
BACKLASH_FACTOR = 20.0
"""Factor of inertia above which backlash does harm: SEW 2001, 8.2."""
CLASS_NAMES = {1: "I (uniform)", 2: "II (moderate shocks)", 3: "III (heavy shocks)"}
HOUR = 3600.0

CHECK_NAMES = {
    "service_factor": "Gear unit: service factor",
    "overhung_load": "Gear unit: overhung load",
    "gear_input_speed": "Gear unit: highest input speed",
    "break_away": "Gear unit: motor starts the load at the efficiency of the start",
    "backlash": "Backlash on the machine",
    "load_speed": "Speed that the chosen ratio gives",
    "direct_speed": "Speed that the motor gives without a gear unit",
}


class GearService(Declared):
    """What is asked about an industrial gear unit."""

    hours_per_day: Annotated[
        float,
        Quantity("h", symbol="t_d", gt=0, le=24 * 3600, default=8 * 3600, source="one shift", group=_GROUP,
                 about="operating hours per day"),
    ]  # fmt: skip
    load_changes_per_hour: Annotated[
        float | None,
        Quantity("1", symbol="Z_L", gt=0, le=1e5, default=None, group=_GROUP,
                 about="starts, brakings and speed changes per hour; empty: from the starts of the motion"),
    ]  # fmt: skip
    load_changes_per_start: Annotated[
        float,
        Quantity("1", symbol="n_L", ge=1, le=20, default=2.0, source="a start and a braking", group=_GROUP,
                 about="load changes of each start; 3 with a change to creep speed"),
    ]  # fmt: skip
    service_factor: Annotated[
        float | None,
        Quantity("1", symbol="f_B", gt=0, le=10, default=None, group=_GROUP,
                 about="service factor demanded; empty: from the tabulated chart"),
    ]  # fmt: skip
    ambient_factor: Annotated[
        float | None,
        Quantity("1", symbol="f_B1", gt=0, le=5, default=None, group=_GROUP,
                 about="factor of the ambient temperature, worm gear units only"),
    ]  # fmt: skip
    duty_factor: Annotated[
        float | None,
        Quantity("1", symbol="f_B2", gt=0, le=5, default=None, group=_GROUP,
                 about="factor of the duty, worm gear units only"),
    ]  # fmt: skip
    output_element: Annotated[
        Literal["none", "sprocket", "gear", "v_belt", "flat_belt", "timing_belt"],
        Option(default="none", source="coupling, no radial force", about="element on the output shaft", group=_GROUP,
               labels={"none": "coupling", "sprocket": "sprocket", "gear": "gear wheel or pinion",
                       "v_belt": "V-belt pulley", "flat_belt": "flat belt pulley",
                       "timing_belt": "timing belt pulley"}),
    ]  # fmt: skip
    output_element_diameter: Annotated[
        float | None,
        Quantity("mm", symbol="d_0", gt=0, le=20, default=None, group=_GROUP,
                 about="pitch diameter of the element on the gear shaft itself"),
    ]  # fmt: skip
    output_element_teeth: Annotated[
        int | None, Option(default=None, ge=4, le=1000, symbol="z", about="its number of teeth", group=_GROUP)
    ]
    overhung_factor: Annotated[
        float | None,
        Quantity("1", symbol="f_Z", ge=1, le=5, default=None, group=_GROUP,
                 about="overhung load factor; empty: from the table"),
    ]  # fmt: skip
    start_up_efficiency: Annotated[
        float | None,
        Quantity("1", symbol="eta_A", gt=0, le=1, default=None, group=_GROUP,
                 about="efficiency at the start or while new, lower than in running for worm gear units"),
    ]  # fmt: skip
    speed_tolerance: Annotated[
        float,
        Quantity("%", symbol="dn_p", gt=0, le=1, default=0.05, source="usual between neighbouring ratios", group=_GROUP,
                 about="how far the speed of the chosen ratio may be from the demanded one"),
    ]  # fmt: skip
    permitted_backlash: Annotated[
        float | None,
        Quantity("mm", symbol="ds_p", gt=0, le=1, default=None, group=_GROUP,
                 about="permitted lost motion of the load by the backlash"),
    ]  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class GearCase:
    """A gear unit behind a motor."""

    gear: GearUnit
    service: GearService
    load: Load
    motor_speed: float
    """Rated speed of the motor [rad/s]"""
    rated_torque: float
    """Rated torque of the motor [N m]"""
    external_inertia: float | None
    """Largest external inertia on the motor shaft, without losses [kg m2]"""
    motor_inertia: float | None
    """Motor, brake and flywheel [kg m2]"""
    efficiency: float
    ambient: float
    """[K]"""
    duty: float
    """0 to 1"""
    run_up_torque: float | None = None
    """Mean run-up torque of the motor [N m]; None where it is not known"""
    highest_speed: float | None = None
    """Highest speed of the motor where an inverter sets it; None where the mains do [rad/s]"""


def record_gear_service(case: GearCase, sheet: Sheet) -> None:
    """Write output speed and torque, service factor, overhung load and backlash, with their checks."""
    with sheet.section("Gear unit"):
        gear = case.gear
        speed = sheet(formulas.output_speed, key="gear_output_speed", omega=case.motor_speed, i=gear.ratio)
        torque = sheet(formulas.output_torque, key="gear_output_torque", M_N=case.rated_torque, i=gear.ratio)
        _check_input_speed(case, sheet)
        if case.highest_speed is None:
            check_load_speed(case.load, case.service, speed, sheet)
        _check_service_factor(case, torque, sheet)
        _check_overhung(case, torque, sheet)
        if case.efficiency <= 0.5 or is_worm(gear):
            back = sheet(retrograde_efficiency, key="gear_retrograde_efficiency", eta=case.efficiency)
            holds = "holds the load by itself" if back == 0 else "does not hold the load by itself"
            sheet.decide(f"The gear unit {holds}", "efficiency of 0.5 or less is self-locking at standstill")
        _check_break_away(case, sheet)
        _check_backlash(case, sheet)


def load_changes(case: GearCase, sheet: Sheet) -> float:
    """Starts, brakings and speed changes per hour."""
    if case.service.load_changes_per_hour is not None:
        return case.service.load_changes_per_hour
    starts, time = sum(state.starts for state in case.load.states), case.load.cycle.cycle_time
    if starts == 0:
        return 0.0
    sheet(formulas.starting_rate, z_c=starts, t_cyc=time)
    return sheet(formulas.load_changes, n_L=case.service.load_changes_per_start, z_c=starts, t_cyc=time) * HOUR


def is_worm(gear: GearUnit) -> bool:
    """Whether a gear unit has a worm stage, alone or behind a helical one."""
    return "worm" in (gear.kind or "")


def check_load_speed(
    load: Load, service: GearService, speed: float, sheet: Sheet, *, direct: bool = False
) -> None:  # fmt: skip
    """Compare the speed at the output [rad/s] with the one that the motion demands; ``direct``: without gear unit."""
    demanded = max((state.speed for state in load.states), default=0.0)
    if demanded == 0:
        return
    found = sheet(formulas.speed_deviation, key="gear_speed_deviation", n_a=speed, omega=demanded)
    sheet.check("load_speed", CHECK_NAMES["direct_speed" if direct else "load_speed"], abs(found),
                service.speed_tolerance, "%", "own demand", formula="speed_deviation")  # fmt: skip


def _check_break_away(case: GearCase, sheet: Sheet) -> None:
    """Whether the motor sets the load in motion although the gear unit is less efficient at standstill."""
    eta_A = case.service.start_up_efficiency
    if eta_A is None or not case.load.states:
        return
    load = max(max(state.torque, 0.0) / state.efficiency for state in case.load.states)
    torque = sheet(formulas.break_away_torque, T=load, i=case.gear.ratio, eta_A=eta_A)
    lacking = "" if case.run_up_torque is not None else "run-up torque of the motor"
    sheet.check("break_away", CHECK_NAMES["break_away"], torque, case.run_up_torque, "N m", "motor: data sheet",
                formula="break_away_torque", missing=lacking)  # fmt: skip


def _check_input_speed(case: GearCase, sheet: Sheet) -> None:
    if case.gear.max_input_speed is not None:
        speed = case.highest_speed if case.highest_speed is not None else case.motor_speed
        sheet.check("gear_input_speed", CHECK_NAMES["gear_input_speed"], speed, case.gear.max_input_speed, "rpm",
                    SOURCE)  # fmt: skip


def _check_service_factor(case: GearCase, torque: float, sheet: Sheet) -> None:
    demanded, lacking = _demanded_factor(case, sheet)
    actual: float | None = case.gear.service_factor if case.gear.max_output_torque is None else None
    if case.gear.max_output_torque is not None:
        actual = sheet(formulas.actual_service_factor, M_amax=case.gear.max_output_torque, M_a=torque)
    if demanded is not None:
        sheet(formulas.required_gear_torque, M_a=torque, f_B=demanded)
    if actual is None:
        lacking = ", ".join(filter(None, [lacking, "permitted output torque of the gear unit"]))
    sheet.check("service_factor", CHECK_NAMES["service_factor"], demanded, actual, "1", SOURCE,
                formula="actual_service_factor", missing=lacking)  # fmt: skip


def _demanded_factor(case: GearCase, sheet: Sheet) -> tuple[float | None, str]:
    """Service factor that the load demands, None with what lacks."""
    service, changes = case.service, load_changes(case, sheet)
    if case.external_inertia is None or not case.motor_inertia:
        if service.service_factor is None:
            return None, "inertia of motor and load"
        return service.service_factor, ""
    f_a = sheet(formulas.inertia_factor_of_load, J_ext=case.external_inertia, J_M=case.motor_inertia)
    if f_a > BACKLASH_FACTOR:
        sheet.decide("Keep the backlash small", "the factor of inertia is above 20: SEW 2001, 8.2")
    number = next((number for limit, number in CLASSES if f_a <= limit), None)
    if number is None:
        sheet.decide("No load class", "the factor of inertia is above 10: ask the maker")
        if service.service_factor is None:
            return None, "service factor of the maker: the factor of inertia is above 10"
        return service.service_factor, ""
    sheet.decide(f"Load class {CLASS_NAMES[number]}", "by the factor of inertia: 0.2, 3 and 10 are the limits")
    f_B = sheet.look_up(f"service_factor_f_b_class_{number}", "service factor by load class and load changes",
                        symbol="f_B", x=changes, family=service.hours_per_day / HOUR,
                        given=service.service_factor)  # fmt: skip
    if f_B is None:
        return None, "service factor for these load changes and hours per day"
    f_B1 = f_B2 = 1.0
    if is_worm(case.gear):
        found_1 = sheet.look_up("worm_f_b1", "factor of the ambient temperature on the service factor", symbol="f_B1",
                                x=case.ambient - 273.15, given=service.ambient_factor)  # fmt: skip
        found_2 = sheet.look_up("worm_f_b2", "factor of the duty on the service factor", symbol="f_B2", x=case.duty,
                                given=service.duty_factor)  # fmt: skip
        if found_1 is None or found_2 is None:
            return None, "factors f_B1 and f_B2 of the worm gear unit"
        f_B1, f_B2 = found_1, found_2
    return sheet(formulas.total_service_factor, f_B=f_B, f_B1=f_B1, f_B2=f_B2), ""


def _check_overhung(case: GearCase, torque: float, sheet: Sheet) -> None:
    service = case.service
    if service.output_element == "none":
        return
    f_Z = sheet.look_up(f"overhung_f_z_{service.output_element}", "overhung load factor of the element", symbol="f_Z",
                        x=float(service.output_element_teeth or 0), given=service.overhung_factor)  # fmt: skip
    permitted = case.gear.permissible_overhung_load
    lacking = [
        words for known, words in (
            (service.output_element_diameter, "pitch diameter of the element on the output shaft"),
            (f_Z, "overhung load factor, or number of teeth"),
            (permitted, "permitted overhung load of the gear unit"),
        ) if known is None
    ]  # fmt: skip
    force = None
    if service.output_element_diameter is not None and f_Z is not None:
        force = sheet(formulas.overhung_load, M_a=torque, d_0=service.output_element_diameter, f_Z=f_Z)
    sheet.check("overhung_load", CHECK_NAMES["overhung_load"], force, permitted, "N", SOURCE, formula="overhung_load",
                missing=", ".join(lacking))  # fmt: skip


def _check_backlash(case: GearCase, sheet: Sheet) -> None:
    travel = next((state.travel for state in case.load.states if state.travel is not None), None)
    if case.gear.backlash is None or travel is None:
        return
    lost = sheet(formulas.backlash_on_load, phi_G=case.gear.backlash, A=travel)
    if case.service.permitted_backlash is not None:
        sheet.check("backlash", CHECK_NAMES["backlash"], lost, case.service.permitted_backlash, "mm", "own demand",
                    formula="backlash_on_load")  # fmt: skip
