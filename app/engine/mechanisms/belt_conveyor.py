"""Belt conveyor: a belt with its load slides or rolls over a bed, moved by a drum, with a stage before the drum."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal, Self

import numpy as np
from pydantic import model_validator

from app.engine.environment import Environment
from app.engine.formulas.belt import drum_grip, pulley_transmission
from app.engine.formulas.resistance import acceleration_force, guide_friction, sum_of_forces, weight_along_axis
from app.engine.mechanisms.base import Mechanism
from app.engine.mechanisms.guided_axis import refused
from app.engine.mechanisms.linear_axis import AxisWords, LinearAxis, record_axis
from app.engine.mechanisms.load import Load
from app.engine.motion.profile import FloatArray, MotionProfile
from app.engine.quantity import Declaration, Option, Quantity
from app.engine.sheet import Sheet

BELT = "Belt and load"
DRUMS = "Drums and rollers"
GRIP = "Grip of the drum"


@dataclass(frozen=True)
class _CarriedLoad:
    """The load on the belt with the carrying strand under it, as a body that is moved in a straight line."""

    load: float
    strand: float
    """Mass of the carrying strand: it rubs on the bed, its weight is balanced by the returning one [kg]"""
    inclination: float
    friction_coefficient: float
    friction_force: float
    inclined: bool
    viscous_coefficient: float = 0.0

    def moved_mass(self, payload: Any) -> Any:
        """The load; belt and rollers are added by the axis [kg]."""
        return self.load + payload

    def constant_force(self, payload: Any, gravity: float) -> Any:
        """Weight of the load downhill [N]."""
        return weight_along_axis(self.load + payload, gravity, self.inclination)

    def friction(self, payload: Any, gravity: float) -> Any:
        """Friction of load and carrying strand on the bed [N]."""
        carried = self.load + payload + self.strand
        return guide_friction(self.friction_coefficient, carried, gravity, self.inclination) + self.friction_force

    def force(self, motion: MotionProfile, gravity: float) -> FloatArray:
        """Force of the belt on the load in each segment [N]."""
        found: FloatArray = (
            acceleration_force(self.moved_mass(motion.payload), motion.acceleration)
            + self.constant_force(motion.payload, gravity)
            + self.friction(motion.payload, gravity) * np.sign(motion.mean_speed)
            + motion.process_force * motion.direction
        )
        return found

    def record_forces(self, sheet: Sheet, payload: float, environment: Environment) -> tuple[float, float]:
        """Record weight and friction with one payload."""
        g, alpha = environment.gravity, self.inclination
        weight = 0.0
        if alpha:
            weight = sheet(weight_along_axis, key="weight_force", symbol="F_g", m=self.load + payload, g=g, alpha=alpha)
        carried = self.load + payload + self.strand
        bed = sheet(guide_friction, key="bed_friction", symbol="F_f", label="Friction on the bed",
                    mu=self.friction_coefficient, m=carried, g=g, alpha=alpha)  # fmt: skip
        label = "Friction of the conveyor"
        return weight, sheet(
            sum_of_forces, key="friction_force", symbol="F_f", label=label, F_k=[bed, self.friction_force]
        )


class BeltConveyor(Mechanism):
    """A belt conveyor. The drive's output shaft is the input of the stage before the drum, or the drum itself."""

    title: ClassVar[str] = "Belt conveyor"
    summary: ClassVar[str] = "Belt conveyor, level or inclined, with a chain or belt stage between gear unit and drum."
    drawing: ClassVar[str] = "belt_conveyor.svg"
    motion_kind: ClassVar[Literal["linear", "rotary"]] = "linear"

    kind: Literal["belt_conveyor"] = "belt_conveyor"
    load_mass: Annotated[
        float, Quantity("kg", symbol="m_L", ge=0, le=1e6, group=BELT, about="mass on the belt, always carried")
    ]
    belt_mass: Annotated[
        float,
        Quantity(
            "kg", symbol="m_b", ge=0, le=1e6, default=0.0, source="left out until given", group=BELT,
            about="mass of the whole belt, both strands",
        ),
    ]  # fmt: skip
    inclination: Annotated[
        float,
        Quantity(
            "deg", symbol="alpha", ge=0, le=np.pi / 3, default=0.0, source="level", group=BELT,
            about="inclination of the conveyor; positive motion is uphill",
        ),
    ]  # fmt: skip
    reversing: Annotated[
        bool,
        Option(
            default=False, group=BELT, about="both directions occur: judge the opposite motion too",
            source="a conveyor runs one way",
        ),
    ]  # fmt: skip
    friction_coefficient: Annotated[
        float,
        Quantity(
            "1", symbol="mu", ge=0, le=2, group=BELT,
            about="friction coefficient of the carrying strand on its bed or rollers",
        ),
    ]  # fmt: skip
    friction_force: Annotated[
        float,
        Quantity(
            "N", symbol="F_c", ge=0, le=1e7, default=0.0, source="none given", group=BELT,
            about="constant friction besides: scrapers, skirts, return rollers",
        ),
    ]  # fmt: skip
    drum_diameter: Annotated[
        float, Quantity("mm", symbol="D", gt=0, le=10, group=DRUMS, about="diameter of the drive drum")
    ]
    drum_inertia: Annotated[
        float,
        Quantity(
            "kg cm2", symbol="J_d", ge=0, le=1e4, default=0.0, source="left out until given", group=DRUMS,
            about="inertia of all drums, referred to the drive drum",
        ),
    ]  # fmt: skip
    roller_mass: Annotated[
        float,
        Quantity(
            "kg", symbol="m_r", ge=0, le=1e6, default=0.0, source="left out until given", group=DRUMS,
            about="mass of drums and rollers as thin tubes, whose whole mass moves with the belt",
        ),
    ]  # fmt: skip
    efficiency: Annotated[
        float,
        Quantity(
            "1", symbol="eta", gt=0, le=1, default=0.81, group=DRUMS, about="efficiency of belt and drums",
            source="SEW 2001, 17.1: flat belt with drums on rolling bearings, lower value",
        ),
    ]  # fmt: skip
    slack_tension: Annotated[
        float | None,
        Quantity("N", symbol="F_2", ge=0, le=1e7, default=None, group=GRIP, about="tension of the slack strand"),
    ]
    drum_friction: Annotated[
        float | None,
        Quantity("1", symbol="mu_d", ge=0, le=2, default=None, group=GRIP, about="friction between belt and drum"),
    ]
    wrap_angle: Annotated[
        float,
        Quantity(
            "deg", symbol="phi", gt=0, le=4 * np.pi, default=np.pi, source="half a turn", group=GRIP,
            about="angle over which the belt wraps the drive drum",
        ),
    ]  # fmt: skip

    @model_validator(mode="after")
    def _something_moves(self) -> Self:
        if self.load_mass + self.belt_mass + self.roller_mass == 0:
            raise refused(self, "load_mass", "nothing moves: give the mass of the load or of the belt")
        return self

    def defaults_taken(self) -> Iterator[tuple[str, Declaration, Any]]:
        """As in the base, without those that do not count here."""
        idle = {"wrap_angle"} if self.slack_tension is None or self.drum_friction is None else set()
        yield from (found for found in super().defaults_taken() if found[0] not in idle)

    def load_at_shaft(self, motion: MotionProfile, environment: Environment, sheet: Sheet) -> Load:
        """Load cycle at the input of the stage before the drum; check of the grip."""
        with sheet.section("Drive drum"):
            label = "Travel of the belt per radian of the drive drum"
            radius = sheet(pulley_transmission, key="transmission_constant", label=label, d=self.drum_diameter)
        axis = self._axis(radius)
        cycle = axis.cycle(motion, environment)
        record_axis(axis, sheet, motion, cycle, environment)
        self._check_grip(sheet, axis.largest_force(motion, environment))
        return Load(
            cycle=cycle,
            statics=axis.statics(motion, environment),
            opposite=axis.opposite(motion, environment),
            states=axis.states(motion, environment),
            results={"drum_speed": cycle.max_speed, "load_inertia_at_drum": cycle.inertia},
        )

    def _axis(self, radius: float) -> LinearAxis:
        body = _CarriedLoad(
            load=self.load_mass,
            strand=self.belt_mass / 2,
            inclination=self.inclination,
            friction_coefficient=self.friction_coefficient,
            friction_force=self.friction_force,
            inclined=self.reversing,
        )
        return LinearAxis(
            body=body,
            words=AxisWords("peripheral_force", "Peripheral force at the drive drum", "drum"),
            constant=radius,
            efficiency=self.efficiency,
            added_mass=self.belt_mass + self.roller_mass,
            rear_inertia=self.drum_inertia,
        )

    def _check_grip(self, sheet: Sheet, force: float) -> None:
        with sheet.section(GRIP):
            given = (("tension of the slack strand", self.slack_tension), ("drum friction", self.drum_friction))
            grip = None
            if self.slack_tension is not None and self.drum_friction is not None:
                grip = sheet(drum_grip, F_2=self.slack_tension, mu_d=self.drum_friction, phi=self.wrap_angle)
            sheet.check(
                "drum_grip", "Grip of the belt on the drive drum", force, grip, "N", "rope friction (Euler, Eytelwein)",
                formula="" if grip is None else "drum_grip",
                missing=", ".join(name for name, value in given if value is None),
            )  # fmt: skip
