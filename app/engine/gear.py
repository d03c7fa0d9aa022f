"""The gear unit between motor and load: what it does to torque, speed and inertia, and whether it bears the load.

The torque at the output of a gear unit is the torque of the load cycle itself, so its own checks depend on no motor
except for the torque that a motor brake can cause.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from app.engine.cycle import CycleHull, FloatArray, LoadCycle
from app.engine.drives.rules import CHECK_NAMES, ServoRules
from app.engine.environment import Environment
from app.engine.formulas.conversion import speed_before_ratio, torque_before_ratio
from app.engine.formulas.duty import equivalent_output_torque, mean_speed
from app.engine.formulas.efficiency import RegenerationModel, record_stage, through_stage
from app.engine.formulas.gear import (
    emergency_torque_by_factor,
    emergency_torque_of_brake,
    motor_mass_ratio,
    peak_output_torque,
)
from app.engine.mechanisms.load import Load
from app.engine.products import GearUnit, ServoGearUnit, ServoMotor
from app.engine.sheet import Sheet

GEAR_SOURCE = "gear unit: data sheet"
MOST_MOTOR_MASS = {1: 4.0, 2: 2.5}
"""Mass of motor over planetary gear unit, by its stages, beyond which the motor needs a support (SEW 2001, 6.3)."""


@dataclass(frozen=True)
class Transmission:
    """What stands between motor shaft and load: a gear unit, or nothing. Inertias are those on the motor shaft."""

    gear: ServoGearUnit | GearUnit | None
    coupling_inertia: float
    """[kg m2]"""
    regeneration: RegenerationModel

    @classmethod
    def of(cls, gear: ServoGearUnit | None, rules: ServoRules, environment: Environment) -> "Transmission":
        """The transmission of one drive."""
        return cls(gear, rules.coupling_inertia, environment.regeneration)

    @property
    def ratio(self) -> float:
        """i = n_motor / n_load; 1 where the motor drives directly."""
        return 1.0 if self.gear is None else self.gear.ratio

    @property
    def missing(self) -> str:
        """What lacks of the gear unit for torques on the motor shaft, empty when nothing does."""
        if self.gear is None:
            return ""
        lacking = {"efficiency": self.gear.efficiency, "inertia": self.gear.inertia}
        names = [name for name, value in lacking.items() if value is None]
        return f"{' and '.join(names)} of the gear unit" if names else ""

    @cached_property
    def efficiency(self) -> float:
        """1 where the motor drives directly; raises ValueError where the source gives none."""
        found = 1.0 if self.gear is None else self.gear.efficiency
        if found is None:
            raise ValueError(self.missing)
        return found

    @cached_property
    def inertia(self) -> float:
        """J_x: gear unit and coupling on the motor shaft; raises ValueError where the source gives none."""
        own = 0.0 if self.gear is None else self.gear.inertia
        if own is None:
            raise ValueError(self.missing)
        return own + self.coupling_inertia

    def load_torque(self, cycle: LoadCycle) -> FloatArray:
        """Torque of the load on the motor shaft in every segment, shape (n,) [N m]; the rotor is not in it."""
        torque = through_stage(cycle.held[0], cycle.mean_speed, self.efficiency, self.regeneration)
        found: FloatArray = np.asarray(torque_before_ratio(torque, self.ratio))
        return found

    def one_torque(self, torque: float, speed: float) -> float:
        """The same for one torque at one signed speed of the output shaft."""
        return float(torque_before_ratio(through_stage(torque, speed, self.efficiency, self.regeneration), self.ratio))

    def record(self, sheet: Sheet, torque: float, speed: float, *, key: str, symbol: str, label: str) -> float:
        """Put the way of one torque through the gear unit on the sheet; the last step carries ``key``."""
        passed = torque
        if self.gear is not None:
            passed = record_stage(
                sheet,
                torque,
                speed,
                self.efficiency,
                self.regeneration,
                key=f"{key}_before_ratio",
                symbol="M_G",
                label=label,
            )
        return sheet(torque_before_ratio, key=key, symbol=symbol, label=label, M=passed, i=self.ratio)


def check_gear_unit(
    load: Load, gear: ServoGearUnit, motor: ServoMotor | None, rules: ServoRules, with_brake: bool, sheet: Sheet
) -> None:
    """Check one gear unit: acceleration, nominal and emergency torque at its output, mean and highest input speed."""
    hull = CycleHull((load.cycle,) if load.opposite is None else (load.cycle, load.opposite))
    peak = sheet(peak_output_torque, key="gear_output_peak", T_2=hull.extreme_torque)
    _check(sheet, "gear_acceleration_torque", peak, gear.acceleration_torque, "N m", "permitted acceleration torque")
    cycle = load.cycle
    mean = 0.0
    if cycle.sums.angle > 0:
        mean = sheet(
            equivalent_output_torque, key="gear_output_mean",
            T_k=cycle.held[0], omega_k=cycle.mean_speed, t_k=cycle.duration,
        )  # fmt: skip
    _check(sheet, "gear_nominal_torque", mean, gear.nominal_torque, "N m", "nominal torque")
    _check_emergency(sheet, gear, motor, rules, with_brake, peak)
    slow = sheet(mean_speed, key="gear_output_mean_speed", symbol="n_2m", label="Mean speed of the output shaft",
                 omega_k=cycle.mean_speed, t_k=cycle.duration)  # fmt: skip
    fast = sheet(speed_before_ratio, key="gear_mean_input_speed", symbol="n_1m", label="Mean input speed",
                 omega=slow, i=gear.ratio)  # fmt: skip
    _check(sheet, "gear_mean_input_speed", fast, gear.nominal_input_speed, "rpm", "permitted mean input speed")
    top = sheet(speed_before_ratio, key="gear_max_input_speed", symbol="n_1max", label="Highest input speed",
                omega=hull.max_speed, i=gear.ratio)  # fmt: skip
    _check(sheet, "gear_max_input_speed", top, gear.max_input_speed, "rpm", "highest permitted input speed")
    _decide_support(sheet, gear, motor)


def _decide_support(sheet: Sheet, gear: ServoGearUnit, motor: ServoMotor | None) -> None:
    """Say whether a heavy motor needs a support of its own, where the masses are known."""
    limit = MOST_MOTOR_MASS.get(gear.stages or 0)
    if motor is None or motor.mass is None or gear.mass is None or limit is None:
        return
    share = sheet(motor_mass_ratio, m_M=motor.mass, m_gu=gear.mass)
    if share > limit:
        sheet.decide(
            "The motor needs a support of its own", f"it has more than {limit:g} times the mass of the gear unit"
        )


def _check_emergency(
    sheet: Sheet, gear: ServoGearUnit, motor: ServoMotor | None, rules: ServoRules, with_brake: bool, peak: float
) -> None:
    demands = []
    if rules.emergency_stop_factor is not None:
        demands.append(sheet(emergency_torque_by_factor, key="gear_output_emergency_stop",
                             T_max=peak, k_em=rules.emergency_stop_factor))  # fmt: skip
    if with_brake and motor is not None and motor.brake_torque is not None:
        demands.append(sheet(emergency_torque_of_brake, key="gear_output_emergency_brake",
                             M_B=motor.brake_torque, i=gear.ratio))  # fmt: skip
    missing = "emergency stop factor, or brake torque of the motor"
    _check(sheet, "gear_emergency_torque", max(demands, default=None), gear.emergency_torque, "N m",
           "permitted emergency torque", missing)  # fmt: skip


def _check(
    sheet: Sheet, key: str, demanded: float | None, permitted: float | None, unit: str, limit: str, missing: str = ""
) -> None:
    lacking = [missing] if demanded is None else []
    if permitted is None:
        lacking.append(f"{limit} of the gear unit")
    sheet.check(key, CHECK_NAMES[key], demanded, permitted, unit, GEAR_SOURCE, missing=", ".join(lacking))
