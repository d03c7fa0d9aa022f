"""Travel drive: a trolley, crane or transfer car on rails, driven by some of its wheels."""

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import model_validator

from app.engine.environment import Environment
from app.engine.formulas.belt import pulley_transmission
from app.engine.formulas.rail import (
    adhesion_force,
    braking_slip_deceleration,
    rolling_resistance,
    slip_acceleration,
    starting_slip_acceleration,
    trailing_resistance,
)
from app.engine.formulas.resistance import acceleration_force, sum_of_forces, weight_along_axis
from app.engine.mechanisms.base import Mechanism
from app.engine.mechanisms.guided_axis import refused, without_zeros
from app.engine.mechanisms.linear_axis import AxisWords, LinearAxis, force_on, record_axis
from app.engine.mechanisms.load import Load
from app.engine.motion.profile import FloatArray, MotionProfile
from app.engine.quantity import Quantity
from app.engine.sheet import Sheet

VEHICLE = "Vehicle"
WHEELS = "Wheels and rails"
SLIP = "Slip of the wheels"


@dataclass(frozen=True)
class _Vehicle:
    """The vehicle without its payload, as a body that is moved in a straight line."""

    mass: float
    slope: float
    external_force: float
    wheel_diameter: float
    bearing_friction: float
    journal_diameter: float
    rolling_arm: float
    rim_friction: float
    friction_force: float
    viscous_coefficient: float = 0.0

    @property
    def inclined(self) -> bool:
        """Whether the two directions differ."""
        return bool(self.slope or self.external_force)

    def moved_mass(self, payload: Any) -> Any:
        """Vehicle and payload [kg]."""
        return self.mass + payload

    def constant_force(self, payload: Any, gravity: float) -> Any:
        """Weight downhill and wind [N]."""
        return weight_along_axis(self.mass + payload, gravity, self.slope) + self.external_force

    def rolling(self, payload: Any, gravity: float) -> Any:
        """Rolling resistance of all wheels [N]."""
        return rolling_resistance(self.mass + payload, gravity, self.slope, self.wheel_diameter, self.bearing_friction,
                                  self.journal_diameter, self.rolling_arm, self.rim_friction)  # fmt: skip

    def friction(self, payload: Any, gravity: float) -> Any:
        """Rolling resistance and constant friction [N]."""
        return self.rolling(payload, gravity) + self.friction_force

    def force(self, motion: MotionProfile, gravity: float) -> FloatArray:
        """Force of the wheels on the vehicle in each segment [N]."""
        return force_on(self, motion, gravity)

    def record_forces(self, sheet: Sheet, payload: float, environment: Environment) -> tuple[float, float]:
        """Record weight, wind and rolling resistance with one payload."""
        m, g, constant = self.mass + payload, environment.gravity, self.external_force
        if self.slope:
            weight = sheet(weight_along_axis, key="weight_force", symbol="F_g", m=m, g=g, alpha=self.slope)
            label = "Constant force against the positive direction"
            parts = without_zeros([weight, self.external_force])
            constant = sheet(sum_of_forces, key="gravity_force", symbol="F_g", label=label, F_k=parts)
        rolling = sheet(rolling_resistance, key="rolling_resistance", m=m, g=g, alpha=self.slope, D=self.wheel_diameter,
                        mu_L=self.bearing_friction, d_j=self.journal_diameter, f=self.rolling_arm,
                        c=self.rim_friction)  # fmt: skip
        parts = without_zeros([rolling, self.friction_force])
        label = "All resistances of the vehicle"
        return constant, sheet(sum_of_forces, key="friction_force", symbol="F_f", label=label, F_k=parts)


class TravelDrive(Mechanism):
    """A vehicle on rails. The drive's output shaft is the wheel shaft, or the input of a stage before it."""

    title: ClassVar[str] = "Travel drive"
    summary: ClassVar[str] = "Trolley, crane or transfer car on rails, checked for slipping wheels laden and unladen."
    drawing: ClassVar[str] = "travel_drive.svg"
    motion_kind: ClassVar[Literal["linear", "rotary"]] = "linear"

    kind: Literal["travel_drive"] = "travel_drive"
    vehicle_mass: Annotated[
        float,
        Quantity(
            "kg", symbol="m_0", gt=0, le=1e7, group=VEHICLE,
            about="mass of the unladen vehicle; the load is the payload of each move",
        ),
    ]  # fmt: skip
    slope: Annotated[
        float,
        Quantity(
            "deg", symbol="alpha", ge=0, le=np.pi / 4, default=0.0, source="level", group=VEHICLE,
            about="slope of the track; positive motion is uphill",
        ),
    ]  # fmt: skip
    wind_force: Annotated[
        float,
        Quantity(
            "N", symbol="F_w", ge=-1e7, le=1e7, default=0.0, source="indoors", group=VEHICLE,
            about="wind or other constant force against the positive direction, whatever the motion",
        ),
    ]  # fmt: skip
    friction_force: Annotated[
        float,
        Quantity(
            "N", symbol="F_c", ge=0, le=1e7, default=0.0, source="none given", group=VEHICLE,
            about="constant friction besides: current collectors, cable chain",
        ),
    ]  # fmt: skip
    wheel_diameter: Annotated[
        float, Quantity("mm", symbol="D", gt=0, le=5, group=WHEELS, about="diameter of the wheels")
    ]
    journal_diameter: Annotated[
        float,
        Quantity("mm", symbol="d_j", gt=0, le=5, group=WHEELS, about="diameter of the journals in their bearings"),
    ]
    rolling_arm: Annotated[
        float,
        Quantity(
            "mm", symbol="f", ge=0, le=0.05, default=0.0005, group=WHEELS, source="SEW 2001, 17.1: steel on steel",
            about="lever arm of rolling friction",
        ),
    ]  # fmt: skip
    bearing_friction: Annotated[
        float,
        Quantity(
            "1", symbol="mu_L", ge=0, le=1, default=0.005, group=WHEELS, source="SEW 2001, 17.1: rolling bearing",
            about="coefficient of bearing friction",
        ),
    ]  # fmt: skip
    rim_friction: Annotated[
        float,
        Quantity(
            "1", symbol="c", ge=0, le=0.1, default=0.003, group=WHEELS,
            source="SEW 2001, 17.1: wheels on rolling bearings", about="rim and flange friction as a share of weight",
        ),
    ]  # fmt: skip
    wheel_inertia: Annotated[
        float,
        Quantity(
            "kg cm2", symbol="J_w", ge=0, le=1e4, default=0.0, group=WHEELS, source="left out until given",
            about="inertia of all wheels together",
        ),
    ]  # fmt: skip
    driven_share: Annotated[
        float,
        Quantity(
            "1", symbol="k_d", gt=0, le=1, default=0.5, group=SLIP, source="two of four wheels",
            about="share of the weight that rests on driven wheels",
        ),
    ]  # fmt: skip
    static_friction: Annotated[
        float,
        Quantity(
            "1", symbol="mu_0", gt=0, le=2, default=0.15, group=SLIP, source="SEW 2001, 8.1: steel on steel",
            about="coefficient of static friction between wheel and rail",
        ),
    ]  # fmt: skip

    @model_validator(mode="after")
    def _journals_fit_into_wheels(self) -> Self:
        if self.journal_diameter >= self.wheel_diameter:
            raise refused(self, "journal_diameter", "the journal must be thinner than the wheel")
        return self

    def load_at_shaft(self, motion: MotionProfile, environment: Environment, sheet: Sheet) -> Load:
        """Load cycle at the wheel shaft or the input of the stage before it; checks of slip."""
        with sheet.section("Wheel"):
            label = "Travel of the vehicle per radian of the wheel"
            radius = sheet(pulley_transmission, key="transmission_constant", label=label, d=self.wheel_diameter)
        vehicle = self._vehicle()
        words = AxisWords("wheel_force", "Force at the rim of all driven wheels", "wheel")
        axis = LinearAxis(body=vehicle, words=words, constant=radius, efficiency=1.0, rear_inertia=self.wheel_inertia)
        cycle = axis.cycle(motion, environment)
        record_axis(axis, sheet, motion, cycle, environment)
        permissible = self._check_slip(sheet, vehicle, motion, environment)
        return Load(
            cycle=cycle,
            statics=axis.statics(motion, environment),
            opposite=axis.opposite(motion, environment),
            results={
                "wheel_speed": cycle.max_speed,
                "load_inertia_at_wheel": cycle.inertia,
                "permissible_acceleration": permissible,
            },
            states=axis.states(motion, environment, permissible_acceleration=permissible, also_unladen=True),
        )

    def _vehicle(self) -> _Vehicle:
        return _Vehicle(
            mass=self.vehicle_mass,
            slope=self.slope,
            external_force=self.wind_force,
            wheel_diameter=self.wheel_diameter,
            bearing_friction=self.bearing_friction,
            journal_diameter=self.journal_diameter,
            rolling_arm=self.rolling_arm,
            rim_friction=self.rim_friction,
            friction_force=self.friction_force,
        )

    def _check_slip(self, sheet: Sheet, vehicle: _Vehicle, motion: MotionProfile, environment: Environment) -> float:
        mu_0, k_d, g, alpha = self.static_friction, self.driven_share, environment.gravity, self.slope
        with sheet.section(SLIP):
            permissible = sheet(slip_acceleration, key="permissible_acceleration", mu_0=mu_0, k_d=k_d, g=g, alpha=alpha)
            if not alpha:
                self._record_strict_limits(sheet, vehicle, float(motion.payload.max()), g)
        runs = [motion, motion.mirrored()] if vehicle.inclined else [motion]
        payload = np.tile(motion.payload, len(runs))
        slowing = np.concatenate([_slowing(run) for run in runs])
        rim = np.concatenate([self._rim_force(vehicle, run, environment.gravity) for run in runs])
        used = np.abs(rim) / vehicle.moved_mass(payload)  # adhesion grows with the mass, so the worst of it decides
        unladen = payload == payload.min()
        states = [("unladen", unladen), ("laden", ~unladen)] if not unladen.all() else [("throughout", unladen)]
        for state, chosen in states:
            for phase, where in (("start", chosen & ~slowing), ("brake", chosen & slowing)):
                if where.any():
                    k = int(np.argmax(np.where(where, used, -1.0)))
                    self._record_slip(sheet, environment, f"{phase}_{state}", float(payload[k]), float(abs(rim[k])))
        return permissible

    def _record_strict_limits(self, sheet: Sheet, vehicle: _Vehicle, payload: float, gravity: float) -> None:
        """Write the limits with the resistance of the other wheels; they do not depend on the payload."""
        m = float(vehicle.moved_mass(payload))
        grip = sheet(adhesion_force, mu_0=self.static_friction, k_d=self.driven_share, m=m, g=gravity, alpha=self.slope)
        trailing = sheet(trailing_resistance, F_F=float(vehicle.rolling(payload, gravity)), k_d=self.driven_share)
        sheet(starting_slip_acceleration, F_R=grip, F_T=trailing, m=m)
        sheet(braking_slip_deceleration, F_R=grip, F_T=trailing, m=m)

    def _rim_force(self, vehicle: _Vehicle, motion: MotionProfile, gravity: float) -> FloatArray:
        """Force between driven wheels and rails in each segment, shape (n,) [N]."""
        helping, resisting = np.minimum(motion.process_force, 0.0), np.maximum(motion.process_force, 0.0)
        trailing = trailing_resistance(vehicle.rolling(motion.payload, gravity), self.driven_share)
        against = (trailing + self.friction_force) * np.sign(np.abs(motion.mean_speed)) + resisting
        # what resists helps to brake and to hold: left out there, on the safe side
        against = np.where(_slowing(motion), 0.0, against) + helping
        # the rails turn the wheels that are not driven: their share of the weight stands for their share of the inertia
        turned = (1 - self.driven_share) * self.wheel_inertia / (self.wheel_diameter / 2) ** 2
        found: FloatArray = (
            acceleration_force(vehicle.moved_mass(motion.payload) + turned, motion.acceleration)
            + vehicle.constant_force(motion.payload, gravity)
            + against * motion.direction
        )
        return np.where(motion.braked, vehicle.constant_force(motion.payload, gravity), found)

    def _record_slip(self, sheet: Sheet, environment: Environment, case: str, payload: float, force: float) -> None:
        phase, state = case.split("_")
        doing = "accelerating or at speed" if phase == "start" else "braking or standing"
        with sheet.section(f"{SLIP}: {state}, {doing}"):
            adhesion = sheet(adhesion_force, key=f"adhesion_{case}", mu_0=self.static_friction, k_d=self.driven_share,
                             m=self.vehicle_mass + payload, g=environment.gravity, alpha=self.slope)  # fmt: skip
            sheet.check(
                f"wheel_slip_{case}", f"Slip of the driven wheels: {state}, {doing}", force, adhesion, "N",
                "SEW 2001, 8.1: static friction of the driven wheels", formula="adhesion_force",
            )  # fmt: skip


def _slowing(motion: MotionProfile) -> NDArray[np.bool_]:
    """Segments in which the vehicle is slowed down or held, shape (n,)."""
    found: NDArray[np.bool_] = (motion.mean_speed == 0) | (motion.acceleration * motion.mean_speed < 0)
    return found
