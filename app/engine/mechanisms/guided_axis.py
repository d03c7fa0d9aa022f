"""What every guided linear axis has, whatever moves it: masses, weight, counterweight, friction of the guides."""

from collections.abc import Iterator
from dataclasses import replace
from typing import Annotated, Any, Literal, Self

import numpy as np
from pydantic import Field, ValidationError, model_validator
from pydantic_core import InitErrorDetails, PydanticCustomError

from app.engine.environment import Environment
from app.engine.formulas.resistance import (
    acceleration_force,
    guide_friction,
    specific_guide_friction,
    sum_of_forces,
    viscous_friction,
    weight_along_axis,
    weight_share_friction,
)
from app.engine.motion.profile import FloatArray, MotionProfile
from app.engine.quantity import Declaration, Declared, Option, Quantity
from app.engine.sheet import Sheet

MASSES = "Moving masses"
FORCES = "Forces"
FRICTION = "Friction of the guides"

VISCOUS_STEPS = 256
"""Steps from standstill to highest speed where friction grows with speed: twice as many move the torque by < 0.1 %."""

FrictionModel = Literal["normal_force", "share_of_weight", "per_mass", "none"]


def refused(model: Declared, attribute: str, message: str) -> ValidationError:
    """Error at one field of ``model``, for a rule that relates several fields."""
    wrong = PydanticCustomError("related_fields", "{reason}", {"reason": message})
    details = InitErrorDetails(type=wrong, loc=(model.border_name(attribute),), input=None)
    return ValidationError.from_exception_data(type(model).__name__, [details])


class MovingMass(Declared):
    """A body that moves with the slide: a cable chain, a slide cover, a hydraulic piston."""

    title = "Further moving mass"

    mass: Annotated[float, Quantity("kg", symbol="m_f", gt=0, le=1e6, about="mass that moves with the slide")]
    weight_acts: Annotated[
        bool,
        Option(
            default=True, about="its weight acts on the drive where the axis is inclined",
            source="on the safe side: a weight forgotten on a slope is the worse mistake",
        ),
    ]  # fmt: skip
    guided: Annotated[
        bool,
        Option(default=False, about="it rests on the guides and adds to their friction", source="off: guided apart"),
    ]


class GuidedAxis(Declared):
    """Masses and forces of a guided slide; positive direction is up."""

    slide_mass: Annotated[
        float,
        Quantity("kg", symbol="m", gt=0, le=1e6, group=MASSES, about="mass of the slide with all it carries always"),
    ]
    inclination: Annotated[
        float,
        Quantity(
            "deg", symbol="alpha", ge=0, le=np.pi / 2, default=0.0, source="horizontal axis", group=MASSES,
            about="inclination of the axis: 0 horizontal, 90 vertical",
        ),
    ]  # fmt: skip
    further_masses: Annotated[
        tuple[MovingMass, ...],
        Field(max_length=20),
        Option(default=(), group=MASSES, about="further masses that move with the slide"),
    ]
    counterweight_mass: Annotated[
        float | None,
        Quantity(
            "kg", symbol="m_c", ge=0, le=1e6, default=None, group=MASSES,
            about="counterweight that hangs from a rope or chain and pulls the slide uphill",
        ),
    ]  # fmt: skip
    counterweight_guided: Annotated[
        bool,
        Option(
            default=True, source="friction counts per guided body", group=MASSES, about="the counterweight has a guide"
        ),
    ]
    counterbalance_force: Annotated[
        float,
        Quantity(
            "N", symbol="F_v", ge=0, le=1e7, default=0.0, source="no counterbalance", group=FORCES,
            about="counterbalance by cylinder or spring: constant force uphill",
        ),
    ]  # fmt: skip
    external_force: Annotated[
        float,
        Quantity(
            "N", symbol="F_e", ge=-1e7, le=1e7, default=0.0, source="no external force", group=FORCES,
            about="constant external force, positive downhill (against the positive direction), whatever the motion",
        ),
    ]  # fmt: skip
    friction_model: Annotated[
        FrictionModel,
        Option(
            default="normal_force", source="Coulomb friction", group=FRICTION,
            about="how the friction of the guides is described",
            labels={
                "normal_force": "coefficient on the normal force", "share_of_weight": "coefficient on the whole weight",
                "per_mass": "force per guided mass", "none": "constant force only",
            },
        ),
    ]  # fmt: skip
    friction_coefficient: Annotated[
        float,
        Quantity(
            "1", symbol="mu", ge=0, le=2, default=0.05, group=FRICTION, about="friction coefficient of the guides",
            source="Lachman, Mendricky 2015: rolling guides 0.5 N/kg",
        ),
    ]  # fmt: skip
    specific_friction: Annotated[
        float,
        Quantity(
            "N/kg", symbol="k_t", ge=0, le=20, default=0.5, group=FRICTION,
            about="friction force per guided mass: 0 hydrostatic, 0.5 rolling, 1 to 2 other guides",
            source="Lachman, Mendricky 2015: rolling guides",
        ),
    ]  # fmt: skip
    friction_force: Annotated[
        float,
        Quantity(
            "N", symbol="F_c", ge=0, le=1e7, default=0.0, source="none given", group=FRICTION,
            about="constant friction besides: wipers, covers, preload of the guides",
        ),
    ]  # fmt: skip
    viscous_coefficient: Annotated[
        float,
        Quantity(
            "N s/m", symbol="k_v", ge=0, le=1e7, default=0.0, source="none given", group=FRICTION,
            about="viscous friction: force per speed",
        ),
    ]  # fmt: skip

    @model_validator(mode="after")
    def _counterweight_needs_a_slope(self) -> Self:
        if self.counterweight_mass and self.inclination == 0:
            raise refused(self, "counterweight_mass", "a horizontal axis has no counterweight; give the inclination")
        return self

    def defaults_taken(self) -> Iterator[tuple[str, Declaration, Any]]:
        """As in the base, without those that do not count here: of other friction models, of no counterweight."""
        idle = {"further_masses", "friction_coefficient", "specific_friction", "counterweight_guided"}
        if self.friction_model in ("normal_force", "share_of_weight"):
            idle.discard("friction_coefficient")
        if self.friction_model == "per_mass":
            idle.discard("specific_friction")
        if self.counterweight_mass:
            idle.discard("counterweight_guided")
        yield from (found for found in super().defaults_taken() if found[0] not in idle)

    @property
    def inclined(self) -> bool:
        """Whether up and down are two different things."""
        return bool(self.inclination > 0 or self.external_force or self.counterbalance_force)

    def slide_side_mass(self, payload: Any) -> Any:
        """Mass on the slide's side [kg]: slide, payload, further masses; what swings on the stiffness of the drive."""
        return self.slide_mass + payload + sum(body.mass for body in self.further_masses)

    def moved_mass(self, payload: Any) -> Any:
        """All mass that is accelerated [kg], the counterweight included."""
        return self.slide_side_mass(payload) + (self.counterweight_mass or 0.0)

    def weight_mass(self, payload: Any) -> Any:
        """Mass whose weight acts along the axis, without the counterweight [kg]."""
        return self.slide_mass + payload + sum(body.mass for body in self.further_masses if body.weight_acts)

    def guided_mass(self, payload: Any) -> Any:
        """Mass that rests on the slide's guides [kg]."""
        return self.slide_mass + payload + sum(body.mass for body in self.further_masses if body.guided)

    @property
    def _guided_counterweight(self) -> float:
        return (self.counterweight_mass or 0.0) if self.counterweight_guided else 0.0

    def constant_force(self, payload: Any, gravity: float) -> Any:
        """Force downhill whatever the motion [N]: weight less counterweight and counterbalance, external force."""
        weight = weight_along_axis(self.weight_mass(payload), gravity, self.inclination)
        return weight - (self.counterweight_mass or 0.0) * gravity - self.counterbalance_force + self.external_force

    def friction(self, payload: Any, gravity: float) -> Any:
        """Friction of all guided bodies without the viscous part [N], unsigned."""
        guided = self.guided_mass(payload)
        match self.friction_model:
            case "normal_force":  # a counterweight hangs and has no normal force
                found = guide_friction(self.friction_coefficient, guided, gravity, self.inclination)
            case "share_of_weight":
                bodies = guided + self._guided_counterweight
                found = weight_share_friction(self.friction_coefficient, bodies, gravity)
            case "per_mass":
                found = specific_guide_friction(self.specific_friction, guided + self._guided_counterweight)
            case "none":
                found = 0.0 * guided
        return found + self.friction_force

    def force(self, motion: MotionProfile, gravity: float) -> FloatArray:
        """Force that moves the slide in each segment [N], positive uphill, shape (n,); standing without friction."""
        moving = np.sign(motion.mean_speed)
        found: FloatArray = (
            acceleration_force(self.moved_mass(motion.payload), motion.acceleration)
            + self.constant_force(motion.payload, gravity)
            + self.friction(motion.payload, gravity) * moving
            + viscous_friction(self.viscous_coefficient, motion.mean_speed)
            + motion.process_force * motion.direction
        )
        return found

    def refined(self, motion: MotionProfile) -> MotionProfile:
        """The same motion, with ramps in small steps where the friction grows with speed."""
        if not self.viscous_coefficient or motion.max_speed == 0:
            return motion
        change = np.abs(motion.speed_end - motion.speed_start) / motion.max_speed
        parts = np.maximum(np.ceil(change * VISCOUS_STEPS), 1).astype(int)
        return split(motion, parts)

    def record_forces(self, sheet: Sheet, payload: float, environment: Environment) -> tuple[float, float]:
        """Record weight and friction with one payload; returns (constant force downhill, friction) [N]."""
        g = environment.gravity
        weight = sheet(weight_along_axis, m=self.weight_mass(payload), g=g, alpha=self.inclination)
        parts = [weight, -self.counterbalance_force, self.external_force]
        if self.counterweight_mass:
            hanging = sheet(
                weight_along_axis, key="counterweight_force", symbol="F_gc", label="Pull of the counterweight",
                m=self.counterweight_mass, g=g, alpha=np.pi / 2,
            )  # fmt: skip
            parts.append(-hanging)
        constant = sheet(
            sum_of_forces, key="gravity_force", symbol="F_g", F_k=without_zeros(parts),
            label="Constant force downhill: weight less counterweight and counterbalance, external force",
        )  # fmt: skip
        return constant, self._record_friction(sheet, payload, g)

    def _record_friction(self, sheet: Sheet, payload: float, g: float) -> float:
        guided, hanging = self.guided_mass(payload), self._guided_counterweight
        parts = [self.friction_force]
        match self.friction_model:
            case "normal_force":
                parts.insert(
                    0, sheet(guide_friction, mu=self.friction_coefficient, m=guided, g=g, alpha=self.inclination)
                )
            case "share_of_weight":
                parts.insert(0, sheet(weight_share_friction, mu=self.friction_coefficient, m=guided + hanging, g=g))
            case "per_mass":
                parts.insert(0, sheet(specific_guide_friction, k_t=self.specific_friction, m=guided + hanging))
        label = "Friction of all guided bodies, without the viscous part"
        return sheet(sum_of_forces, key="friction_force", symbol="F_T", label=label, F_k=without_zeros(parts))


def without_zeros(parts: list[float]) -> list[float]:
    """The terms of a sum as the sheet shows them: those that are zero are left out, one at least stays."""
    return [part for part in parts if part] or [0.0]


def split(motion: MotionProfile, parts: np.ndarray[Any, np.dtype[np.int_]]) -> MotionProfile:
    """The same motion with segment k cut into ``parts[k]`` equal pieces; ``parts`` has shape (n,), each >= 1."""
    of = np.repeat(np.arange(len(parts)), parts)
    piece = np.arange(len(of)) - np.repeat(np.cumsum(parts) - parts, parts)
    count = parts[of]
    start, end = motion.speed_start[of], motion.speed_end[of]
    return replace(
        motion,
        duration=motion.duration[of] / count,
        speed_start=start + (end - start) * piece / count,
        speed_end=np.where(piece + 1 == count, end, start + (end - start) * (piece + 1) / count),
        payload=motion.payload[of],
        process_force=motion.process_force[of],
        direction=motion.direction[of],
        braked=motion.braked[of],
        label=tuple(motion.label[k] for k in of),
    )
