"""The lead, diameter and ratio with which a motor accelerates a load fastest (Jakab), as a result of its own.

One size is optimised for the other as it stands: lead or diameter for the present ratio, ratio for the present lead or
diameter. Both together have an optimum only inside bounds, and it lies on one of them; the bound on the acceleration
that no choice can exceed is shown beside it.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Annotated, Literal, Self

from pydantic import model_validator

from app.engine.environment import Environment
from app.engine.formulas.inertia import linear_mass_inertia, sum_of_inertias
from app.engine.formulas.optimum import (
    accelerating_torque_needed,
    acceleration_bound,
    inertia_beside_load,
    inertia_match,
    load_acceleration,
    motor_side_inertia,
    optimum_diameter,
    optimum_lead,
    optimum_ratio,
    optimum_solid_pulley_diameter,
    optimum_transmission,
    solid_pulleys_inertia,
    speed_reduction,
)
from app.engine.mechanisms.base import Mechanism
from app.engine.mechanisms.guided_axis import refused
from app.engine.mechanisms.load import Load
from app.engine.motion.profile import MotionProfile
from app.engine.quantity import Declared, Option, Quantity
from app.engine.sheet import Sheet
from app.engine.transmission import HasTransmission, LinearTransmission

TORQUE = "Motor torque"
BOUNDS = "Bounds"


class OptimumInput(Declared):
    """With which torque the optimum is sought, and inside which bounds."""

    title = "Optimum for acceleration"

    accelerating_torque: Annotated[
        float | None,
        Quantity(
            "N m", symbol="M", gt=0, le=1e6, default=None, group=TORQUE,
            about="motor torque while accelerating; without it the peak torque of the motor",
        ),
    ]  # fmt: skip
    resistances: Annotated[
        Literal["left_out", "subtracted"],
        Option(
            default="left_out", group=TORQUE, source="Jakab: torque free for accelerating",
            about="friction, weight and losses while accelerating",
            labels={
                "left_out": "left out: the torque is free for accelerating",
                "subtracted": "come off the torque: it is the whole torque of the motor",
            },
        ),
    ]  # fmt: skip
    size_min: Annotated[
        float | None,
        Quantity("mm", symbol="h_min", gt=0, le=10, default=None, group=BOUNDS, about="smallest lead or diameter"),
    ]
    size_max: Annotated[
        float | None,
        Quantity("mm", symbol="h_max", gt=0, le=10, default=None, group=BOUNDS, about="largest lead or diameter"),
    ]
    ratio_min: Annotated[
        float, Quantity("1", symbol="i_min", gt=0, le=1e4, default=1.0, source="direct drive", group=BOUNDS,
                        about="smallest ratio")
    ]  # fmt: skip
    ratio_max: Annotated[
        float | None, Quantity("1", symbol="i_max", gt=0, le=1e4, default=None, group=BOUNDS, about="largest ratio")
    ]

    @model_validator(mode="after")
    def _bounds_in_order(self) -> Self:
        if self.size_min is not None and self.size_max is not None and self.size_min > self.size_max:
            raise refused(self, "size_max", "must not be smaller than the smallest lead or diameter")
        if self.ratio_max is not None and self.ratio_min > self.ratio_max:
            raise refused(self, "ratio_max", "must not be smaller than the smallest ratio")
        return self


@dataclass(frozen=True)
class JointOptimum:
    """Best lead or diameter and ratio together, inside bounds."""

    size: float
    """Lead or diameter [m]"""
    ratio: float
    acceleration: float
    """[m/s2]"""
    bounds: tuple[str, ...]
    """Bounds on which it lies: ``"smallest ratio"``, ``"largest diameter"`` ..."""


@dataclass(frozen=True)
class OptimumResult:
    """What was found, in SI. None where the mechanism has no lead or diameter to choose."""

    ratio: float
    """Best ratio for the mechanism as it stands"""
    acceleration_at_ratio: float | None = None
    size_name: str = ""
    """``"lead"`` or ``"diameter"``"""
    size: float | None = None
    """Best lead or diameter for the present ratio"""
    acceleration: float | None = None
    """Acceleration of the load as it stands"""
    acceleration_at_size: float | None = None
    match: float | None = None
    """Inertia of the moved mass over all other at the best size"""
    bound: float | None = None
    """Acceleration that no lead or diameter and ratio can exceed"""
    joint: JointOptimum | None = None


@dataclass(frozen=True)
class _Case:
    """One motor on one linear transmission: masses and inertias as they count at the motor."""

    torque: float
    force: float
    drive_inertia: float
    shaft_inertia: float
    mass: float
    pulley_coefficient: float

    def inertia_on_shaft(self, A: float) -> float:
        """Inertia on the mechanism's shaft beside the moved mass, with pulleys that grow with the diameter."""
        return self.shaft_inertia + float(solid_pulleys_inertia(self.pulley_coefficient, 2 * A))

    def acceleration(self, A: float, i: float) -> float:
        """Acceleration of the load [m/s2]: the full model that every optimum is judged by."""
        J_red = motor_side_inertia(self.drive_inertia, self.inertia_on_shaft(A), self.mass, A, i)
        return float(load_acceleration(self.torque, self.force, A, i, J_red))

    def best_constant(self, i: float) -> float:
        """Best A for one ratio, without bounds."""
        J_f = inertia_beside_load(self.drive_inertia, self.shaft_inertia, i)
        if self.pulley_coefficient == 0:
            return float(optimum_transmission(self.torque, self.force, i, J_f, self.mass))
        if self.force == 0:
            return float(optimum_solid_pulley_diameter(J_f, self.mass, self.pulley_coefficient)) / 2
        largest = float(optimum_transmission(self.torque, min(self.force, 0.0), i, J_f, self.mass))
        return _maximum(lambda A: self.acceleration(A, i), 0.0, largest)

    def best_ratio(self, A: float) -> float:
        """Best ratio for one A, without bounds."""
        J_L = self.inertia_on_shaft(A) + linear_mass_inertia(self.mass, A)
        return float(optimum_ratio(self.torque, self.force * A, self.drive_inertia, J_L))


def optimum(
    mechanism: Mechanism,
    load: Load,
    motion: MotionProfile,
    environment: Environment,
    options: OptimumInput,
    sheet: Sheet,
    *,
    drive_inertia: float,
    ratio: float = 1.0,
    gear_efficiency: float = 1.0,
    peak_torque: float | None = None,
) -> OptimumResult | None:
    """Find the best lead or diameter and the best ratio for acceleration, with every step on ``sheet``.

    ``load`` is what ``mechanism`` made of ``motion``. ``drive_inertia`` all on the motor shaft [kg m2]: rotor and
    gear unit; ``ratio`` of the gear unit as it stands; ``peak_torque`` of the motor [N m], used when ``options`` gives
    none. None, with the reason as a decision, when there is no torque or no inertia on the motor shaft.
    """
    torque = options.accelerating_torque if options.accelerating_torque is not None else peak_torque
    if torque is None or drive_inertia <= 0:
        lacking = "no torque is given, and no motor with a known peak torque is chosen"
        sheet.decide("No optimum is sought", lacking if torque is None else "the inertia of the motor is not known")
        return None
    subtracted = options.resistances == "subtracted"
    _decide_torque(sheet, subtracted, options.accelerating_torque is not None)
    if isinstance(mechanism, HasTransmission) and mechanism.has_stage:
        sheet.decide("Only the ratio is sought", "a stage or further bodies stand between the mechanism and the drive")
    if not isinstance(mechanism, HasTransmission) or mechanism.has_stage:
        opposing = load.statics.forward / gear_efficiency if subtracted else 0.0
        inertia = load.cycle.inertia / (gear_efficiency if subtracted else 1.0)
        return _ratio_only(sheet, torque, opposing, drive_inertia, inertia)
    found = mechanism.transmission(float(motion.payload.max()), environment)
    case = _case(found, torque, drive_inertia, gear_efficiency, subtracted)
    if case.torque * ratio <= case.force * found.constant:
        sheet.decide("As it stands the axis does not accelerate", "the torque does not overcome the resistances")
    return _linear(sheet, case, found, ratio, options, motion)


def _decide_torque(sheet: Sheet, subtracted: bool, given: bool) -> None:
    whose = "The given torque" if given else "The peak torque of the motor"
    if subtracted:
        sheet.decide(f"{whose} also overcomes friction, weight and losses", "chosen: resistances are subtracted")
    else:
        sheet.decide(f"{whose} is free for accelerating", "chosen: friction, weight and losses are left out")


def _case(
    found: LinearTransmission, torque: float, drive_inertia: float, gear_efficiency: float, subtracted: bool
) -> _Case:
    """Collect the case; what lies behind a loss weighs on the motor by 1 / efficiency while it accelerates."""
    gear = gear_efficiency if subtracted else 1.0
    whole = gear * found.efficiency if subtracted else 1.0
    return _Case(
        torque=torque,
        force=found.resisting_force / whole if subtracted else 0.0,
        drive_inertia=drive_inertia,
        shaft_inertia=found.front_inertia / gear + found.rear_inertia / whole,
        mass=found.mass / whole,
        pulley_coefficient=found.front_pulleys / gear + found.rear_pulleys / whole,
    )


def _ratio_only(sheet: Sheet, torque: float, opposing: float, drive_inertia: float, inertia: float) -> OptimumResult:
    i = sheet(optimum_ratio, M=torque, T=opposing, J_d=drive_inertia, J_L=inertia)
    sheet(speed_reduction, key="optimum_reduction", i_opt=i)
    return OptimumResult(ratio=i)


def _linear(
    sheet: Sheet, case: _Case, found: LinearTransmission, ratio: float, options: OptimumInput, motion: MotionProfile
) -> OptimumResult:
    now = _record_now(sheet, case, found, ratio, motion)
    size, at_size, match = _record_size(sheet, case, found, ratio)
    i, at_ratio = _record_ratio(sheet, case, found)
    bound = sheet(acceleration_bound, M=case.torque, F=case.force, J_d=case.drive_inertia, m=case.mass)
    joint = _joint(case, found, options)
    if joint is None:
        sheet.decide(
            "Lead or diameter and ratio together have no optimum without bounds",
            "the larger the ratio, the closer to the bound on the acceleration; give bounds to choose inside them",
        )
    else:
        _record_joint(sheet, case, found, joint)
    return OptimumResult(
        ratio=i, acceleration_at_ratio=at_ratio, size_name=found.size, size=size, acceleration=now,
        acceleration_at_size=at_size, match=match, bound=bound, joint=joint,
    )  # fmt: skip


def _record_now(sheet: Sheet, case: _Case, found: LinearTransmission, i: float, motion: MotionProfile) -> float:
    """Record inertia and acceleration as the axis stands."""
    A = found.constant
    shaft = case.inertia_on_shaft(A)
    label = "Moved mass as inertia of the mechanism's shaft"
    sheet(linear_mass_inertia, key="slide_inertia", symbol="J_m", label=label, m=case.mass, A=A)
    J_red = sheet(motor_side_inertia, J_d=case.drive_inertia, J_s=shaft, m=case.mass, A=A, i=i)
    peak = float(abs(motion.acceleration).max())
    if peak:
        sheet(accelerating_torque_needed, J_red=J_red, a=peak, A=A, i=i)
    M, F, label = case.torque, case.force, "Acceleration with lead, diameter and ratio as they are"
    return sheet(load_acceleration, key="acceleration_now", label=label, M=M, F=F, A=A, i=i, J_red=J_red)


def _record_size(sheet: Sheet, case: _Case, found: LinearTransmission, i: float) -> tuple[float, float, float]:
    """Record the best lead or diameter for the present ratio: (size, acceleration, inertia match)."""
    J_f = sheet(inertia_beside_load, J_d=case.drive_inertia, J_s=case.shaft_inertia, i=i)
    if case.pulley_coefficient and case.force:
        sheet.decide("The best diameter is searched on the whole model", "solid pulleys with an opposing force")
        A = case.best_constant(i)
        size = sheet(optimum_diameter, key="optimum_diameter", A_opt=A)
    elif case.pulley_coefficient:
        size = sheet(
            optimum_solid_pulley_diameter, key="optimum_diameter", J_f=J_f, m=case.mass, c_t=case.pulley_coefficient
        )
        A = size / 2
    else:
        A = sheet(optimum_transmission, M=case.torque, F=case.force, i=i, J_f=J_f, m=case.mass)
        size = sheet(optimum_lead if found.size == "lead" else optimum_diameter, A_opt=A)
    shaft = case.inertia_on_shaft(A)
    match = sheet(inertia_match, m=case.mass, A=A, J_f=inertia_beside_load(case.drive_inertia, shaft, i))
    return size, _record_acceleration(sheet, case, A, i, "acceleration_at_optimum_size", f"best {found.size}"), match


def _record_ratio(sheet: Sheet, case: _Case, found: LinearTransmission) -> tuple[float, float]:
    """Record the best ratio for the present lead or diameter: (ratio, acceleration)."""
    A = found.constant
    parts = [case.inertia_on_shaft(A), linear_mass_inertia(case.mass, A)]
    label = "Load inertia on the mechanism's shaft"
    J_L = sheet(sum_of_inertias, key="optimum_load_inertia", symbol="J_L", label=label, J_k=parts)
    i = sheet(optimum_ratio, M=case.torque, T=case.force * A, J_d=case.drive_inertia, J_L=J_L)
    sheet(speed_reduction, key="optimum_reduction", i_opt=i)
    return i, _record_acceleration(sheet, case, A, i, "acceleration_at_optimum_ratio", "best ratio")


def _record_acceleration(sheet: Sheet, case: _Case, A: float, i: float, key: str, name: str) -> float:
    J_red = sheet(motor_side_inertia, key=f"{key}_inertia", label=f"Inertia of the axis at the motor with the {name}",
                  J_d=case.drive_inertia, J_s=case.inertia_on_shaft(A), m=case.mass, A=A, i=i)  # fmt: skip
    return sheet(load_acceleration, key=key, label=f"Acceleration with the {name}", M=case.torque, F=case.force, A=A,
                 i=i, J_red=J_red)  # fmt: skip


def _joint(case: _Case, found: LinearTransmission, options: OptimumInput) -> JointOptimum | None:
    """Best pair inside the bounds, None where a bound is missing.

    For a given A the acceleration has one maximum over the ratio, and for a given ratio one over A; inside there is
    none for both. So the best pair has A or the ratio on a bound, and the other at its own optimum or on a bound too.
    """
    if options.size_min is None or options.size_max is None or options.ratio_max is None:
        return None
    factor = found.size_per_constant
    low, high = options.size_min / factor, options.size_max / factor
    i_low, i_high = options.ratio_min, options.ratio_max
    pairs = [(_clamp(case.best_constant(i), low, high), i) for i in (i_low, i_high)]
    pairs += [(A, _clamp(case.best_ratio(A), i_low, i_high)) for A in (low, high)]
    A, i = max(pairs, key=lambda pair: case.acceleration(*pair))
    names = [(f"smallest {found.size}", low == A), (f"largest {found.size}", high == A)]
    names += [("smallest ratio", i == i_low), ("largest ratio", i == i_high)]
    return JointOptimum(A * factor, i, case.acceleration(A, i), tuple(name for name, holds in names if holds))


def _record_joint(sheet: Sheet, case: _Case, found: LinearTransmission, joint: JointOptimum) -> None:
    A = joint.size / found.size_per_constant
    _record_acceleration(sheet, case, A, joint.ratio, "acceleration_at_joint_optimum", "best pair inside the bounds")
    shown = f"{found.size} {joint.size * 1000:.4g} mm with ratio {joint.ratio:.4g}"
    sheet.decide(f"Best pair inside the bounds: {shown}", f"it lies on: {', '.join(joint.bounds)}")


def _clamp(value: float, low: float, high: float) -> float:
    return min(max(value, low), high)


def _maximum(function: Callable[[float], float], low: float, high: float) -> float:
    """Where a function with one maximum has it, by golden section; exact to 1e-9 of the interval."""
    golden = (5**0.5 - 1) / 2
    left, right = low, high
    while right - left > 1e-9 * (high - low):
        first, second = right - golden * (right - left), left + golden * (right - left)
        if function(first) < function(second):
            left = first
        else:
            right = second
    return (left + right) / 2
