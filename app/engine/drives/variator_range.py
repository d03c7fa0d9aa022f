"""What a machine asks of a variable-speed gear over its speed range, and what the gear may give."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from app.engine.drives.mains_shaft import MotorSide
from app.engine.formulas import variator as formulas
from app.engine.formulas.conversion import linear_speed, torque_of_power
from app.engine.formulas.efficiency import RegenerationModel, driving_stage_torque, returning_stage_torque
from app.engine.formulas.servo import shaft_power
from app.engine.mechanisms.load import LoadState
from app.engine.sheet import Sheet

Law = Literal["constant_torque", "constant_power", "both"]
SOURCE = "variable-speed gear: list"
CHECK_NAMES = {
    "variator_speed_high": "Highest speed",
    "variator_speed_low": "Lowest speed",
    "variator_torque_high": "Torque at the highest speed",
    "variator_power_high": "Power at the highest speed",
    "variator_torque_corner": "Torque where constant torque and power meet",
    "variator_torque_low": "Torque at the lowest speed",
    "variator_shocks": "Load class: friction discs bear uniform loads only",
}


@dataclass(frozen=True)
class RangeRules:
    """How the machine is run over its speed range."""

    law: Law
    speed_range: float
    """Highest over lowest speed"""
    corner_speed: float | None
    """Output speed between constant torque and constant power, where both occur [rad/s]"""
    regeneration: RegenerationModel = "eta"


@dataclass(frozen=True, kw_only=True)
class Demand:
    """What the machine asks at the output over its speed range, losses of the mechanism included."""

    states: tuple[LoadState, ...]
    law: Law
    lowest_speed: float
    highest_speed: float
    corner_speed: float | None
    highest_speed_torque: float
    lowest_speed_torque: float
    power: float
    """At the highest speed [W]"""

    def torque(self, speed: float) -> float:
        """Torque that is asked at a speed of the range [N m]."""
        if self.law == "constant_torque":
            return self.highest_speed_torque
        return self.power / max(speed, self.corner_speed or 0.0)


@dataclass(frozen=True, kw_only=True)
class VariatorCase:
    """A variable-speed gear with the two ends that its list gives, all at the output."""

    lowest_speed: float
    highest_speed: float
    lowest_torque: float
    highest_torque: float
    highest_power: float | None
    uniform_only: bool


def torque_between(case: VariatorCase, speed: float) -> float:
    """Permitted torque at a speed between the listed ends [N m]."""
    return float(formulas.variator_torque_between(
        n_a=speed, n_a1=case.lowest_speed, n_a2=case.highest_speed, M_a1=case.lowest_torque, M_a2=case.highest_torque,
    ))  # fmt: skip


def demand_of(states: Sequence[LoadState], rules: RangeRules, sheet: Sheet) -> Demand:
    """Write what the heaviest state of the load asks at both ends of the range."""
    law, corner = rules.law, rules.corner_speed
    sides = [
        MotorSide(state=state, ratio=1.0, gear_efficiency=1.0, motor_inertia=0.0, model=rules.regeneration)
        for state in states
    ]
    side = max(sides, key=lambda one: abs(one.load_torque) * one.factor(driving=not one.driven_by_load))
    worst = side.state
    highest = max(state.speed for state in states)
    label = "Torque at the output at the highest speed"
    if worst.torque >= 0:
        torque = sheet(driving_stage_torque, key="output_torque", symbol="M_a", label=label, T=worst.torque,
                       eta=worst.efficiency)  # fmt: skip
    else:
        torque = sheet(returning_stage_torque, key="output_torque", symbol="M_a", label=label, T=-worst.torque,
                       eta_r=side.factor(driving=False))  # fmt: skip
    power = sheet(shaft_power, key="output_power", symbol="P_a", unit="kW", M=torque, omega=highest,
                  label="Power at the output at the highest speed")  # fmt: skip
    lowest = sheet(formulas.lowest_output_speed, n_amax=highest, R_n=rules.speed_range)
    key = "lowest_output_power"
    match law:
        case "constant_torque":
            small = sheet(formulas.lowest_power_constant_torque, key=key, P_amax=power, R_n=rules.speed_range)
        case "constant_power":
            small = power
            sheet(formulas.extra_torque_constant_power, key="extra_torque", R_n=rules.speed_range)
        case "both":
            small = sheet(formulas.lowest_power_both, key=key, n_amin=lowest, n_c=corner, P_amax=power)
    low = sheet(torque_of_power, key="lowest_speed_torque", P=small, omega=lowest,
                label="Torque at the output at the lowest speed")  # fmt: skip
    return Demand(states=tuple(states), law=law, lowest_speed=lowest, highest_speed=highest, corner_speed=corner,
                  highest_speed_torque=torque, lowest_speed_torque=low, power=power)  # fmt: skip


def record_range(case: VariatorCase, demand: Demand, factor: float | None, load_class: int, sheet: Sheet) -> None:
    """Write and check speeds, torques and power at both ends; ``factor`` is the service factor, None if not known."""
    sheet(shaft_power, key="listed_power_from_torque", symbol="P_a2", unit="kW", M=case.highest_torque,
          omega=case.highest_speed, label="Power of the listed torque at the highest listed speed")  # fmt: skip
    travel = next((state.travel for state in demand.states if state.travel is not None), None)
    if travel is not None:
        sheet(linear_speed, key="load_speed_at_listed_maximum", label="Speed of the load at the highest listed speed",
              omega=case.highest_speed, A=travel)  # fmt: skip
    _check(sheet, "variator_speed_high", demand.highest_speed, case.highest_speed, "rpm")
    _check(sheet, "variator_speed_low", case.lowest_speed, demand.lowest_speed, "rpm")
    if case.uniform_only:
        _check(sheet, "variator_shocks", float(load_class), 1.0, "1")
    sheet.decide("The listed torque of the highest speed holds for the highest speed of the machine",
                 "the gear may give no less where it turns slower")  # fmt: skip
    _check_torque(sheet, "high", demand.highest_speed_torque, case.highest_torque, factor)
    if case.highest_power is not None:
        label = "Power at the highest speed with the service factor"
        asked = None
        if factor is not None:
            asked = sheet(formulas.power_with_service_factor, key="design_power_high", label=label, P_a=demand.power,
                          f_B=factor)  # fmt: skip
        _check(sheet, "variator_power_high", asked, case.highest_power, "kW", "power_with_service_factor")
    for place, speed in (("corner", demand.corner_speed), ("low", demand.lowest_speed)):
        if speed is None:
            continue
        permitted = None
        if case.lowest_speed <= speed <= case.highest_speed:
            permitted = sheet(
                formulas.variator_torque_between, key=f"permitted_torque_{place}", n_a=speed, n_a1=case.lowest_speed,
                n_a2=case.highest_speed, M_a1=case.lowest_torque, M_a2=case.highest_torque,
            )  # fmt: skip
        _check_torque(sheet, place, demand.torque(speed), permitted, factor)


def _check_torque(sheet: Sheet, place: str, torque: float, permitted: float | None, factor: float | None) -> None:
    asked = None
    if factor is not None:
        label = f"{CHECK_NAMES[f'variator_torque_{place}']}, with the service factor"
        asked = sheet(formulas.torque_with_service_factor, key=f"design_torque_{place}", label=label, M_a=torque,
                      f_B=factor)  # fmt: skip
    _check(sheet, f"variator_torque_{place}", asked, permitted, "N m", "torque_with_service_factor")


def _check(
    sheet: Sheet, key: str, demanded: float | None, permitted: float | None, unit: str, formula: str = ""
) -> None:
    lacking = [
        words for known, words in (
            (demanded, "factor of the ambient temperature on the service factor"),
            (permitted, "torque at a speed outside the list"),
        ) if known is None
    ]  # fmt: skip
    sheet.check(key, CHECK_NAMES[key], demanded, permitted, unit, SOURCE, formula=formula, missing=", ".join(lacking))
