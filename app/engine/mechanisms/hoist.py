"""Hoist: a load carried by chain, rope or belt that a sprocket or drum winds up, with reeving and counterweight."""

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from app.engine.environment import Environment
from app.engine.formulas.hoist import hoisted_weight, hoisting_transmission
from app.engine.formulas.resistance import sum_of_forces
from app.engine.mechanisms.base import Mechanism
from app.engine.mechanisms.guided_axis import without_zeros
from app.engine.mechanisms.linear_axis import AxisWords, LinearAxis, force_on, record_axis
from app.engine.mechanisms.load import Load
from app.engine.motion.profile import FloatArray, MotionProfile
from app.engine.quantity import Option, Quantity
from app.engine.sheet import Sheet

CARRIED = "What is lifted"
DRUM = "Sprocket or drum"
LIFTING = ("lifting", "lowering")


@dataclass(frozen=True)
class _Carried:
    """Cage and counterweight, moved up and down; the payload comes with the motion."""

    mass: float
    counterweight: float
    friction_force: float
    viscous_coefficient: float = 0.0
    inclined: bool = True

    def moved_mass(self, payload: Any) -> Any:
        """Everything that is accelerated, the counterweight too [kg]."""
        return self.mass + self.counterweight + payload

    def constant_force(self, payload: Any, gravity: float) -> Any:
        """Weight that is not balanced [N]."""
        return hoisted_weight(self.mass + payload, self.counterweight, gravity)

    def friction(self, payload: Any, gravity: float) -> Any:
        """Friction of the guides [N], whatever the payload."""
        return self.friction_force + 0.0 * np.asarray(payload)

    def force(self, motion: MotionProfile, gravity: float) -> FloatArray:
        """Force that moves cage, payload and counterweight in each segment [N]."""
        return force_on(self, motion, gravity)

    def record_forces(self, sheet: Sheet, payload: float, environment: Environment) -> tuple[float, float]:
        """Record the unbalanced weight and the friction with one payload."""
        weight = sheet(hoisted_weight, key="weight_force", m=self.mass + payload, m_c=self.counterweight,
                       g=environment.gravity)  # fmt: skip
        friction = sheet(sum_of_forces, key="friction_force", symbol="F_f", label="Friction of the guides",
                         F_k=without_zeros([self.friction_force]))  # fmt: skip
        return weight, friction


class Hoist(Mechanism):
    """A hoist or lift. The drive's output shaft is the shaft of sprocket or drum, or the input of a stage before it."""

    title: ClassVar[str] = "Hoist"
    summary: ClassVar[str] = "Lift, hoist or lifting axis with chain, rope or belt, reeving and counterweight."
    drawing: ClassVar[str] = "hoist.svg"
    motion_kind: ClassVar[Literal["linear", "rotary"]] = "linear"

    kind: Literal["hoist"] = "hoist"
    cage_mass: Annotated[
        float,
        Quantity("kg", symbol="m_0", ge=0, le=1e7, group=CARRIED,
                 about="mass of cage, platform or hook; the load is the payload of each move"),
    ]  # fmt: skip
    counterweight_mass: Annotated[
        float,
        Quantity("kg", symbol="m_c", ge=0, le=1e7, default=0.0, source="none", group=CARRIED,
                 about="mass of the counterweight, moved as fast as the load"),
    ]  # fmt: skip
    friction_force: Annotated[
        float,
        Quantity("N", symbol="F_f", ge=0, le=1e7, default=0.0, source="in the efficiency", group=CARRIED,
                 about="friction of the guides"),
    ]  # fmt: skip
    permissible_acceleration: Annotated[
        float | None,
        Quantity("m/s2", symbol="a_p", gt=0, le=50, default=None, group=CARRIED,
                 about="acceleration that the load or the chain bears; empty: no limit"),
    ]  # fmt: skip
    drum_diameter: Annotated[
        float,
        Quantity("mm", symbol="D", gt=0, le=10, group=DRUM, about="pitch diameter of sprocket or drum, rope included"),
    ]
    falls: Annotated[
        int, Option(default=1, ge=1, le=32, symbol="n_r", source="no reeving", group=DRUM,
                    about="falls of rope that carry the load"),
    ]  # fmt: skip
    efficiency: Annotated[
        float,
        Quantity("1", symbol="eta_L", gt=0, le=1, default=0.9, source="SEW 2001, 17.1: chain, lower value",
                 group=DRUM, about="efficiency of chain or rope with all its sheaves"),
    ]  # fmt: skip
    drum_inertia: Annotated[
        float,
        Quantity("kg m2", symbol="J_D", ge=0, le=1e5, default=0.0, source="left out until given", group=DRUM,
                 about="inertia of sprocket or drum on its shaft"),
    ]  # fmt: skip

    def load_at_shaft(self, motion: MotionProfile, environment: Environment, sheet: Sheet) -> Load:
        """Load cycle at the drum shaft or the input of the stage before it."""
        with sheet.section("Sprocket or drum"):
            radius = sheet(hoisting_transmission, key="transmission_constant", D=self.drum_diameter, n_r=self.falls)
        body = _Carried(self.cage_mass, self.counterweight_mass, self.friction_force)
        words = AxisWords("hoisting_force", "Force that lifts the load, at the load", "drum")
        axis = LinearAxis(body=body, words=words, constant=radius, efficiency=self.efficiency,
                          front_inertia=self.drum_inertia)  # fmt: skip
        cycle = axis.cycle(motion, environment)
        record_axis(axis, sheet, motion, cycle, environment)
        self._check_slack(sheet, motion, environment.gravity)
        return Load(
            cycle=cycle,
            statics=axis.statics(motion, environment),
            opposite=axis.opposite(motion, environment),
            results={"drum_speed": cycle.max_speed, "load_inertia_at_drum": cycle.inertia},
            states=axis.states(motion, environment, permissible_acceleration=self.permissible_acceleration,
                               also_unladen=True, words=LIFTING),
        )  # fmt: skip

    def _check_slack(self, sheet: Sheet, motion: MotionProfile, gravity: float) -> None:
        """A rope only pulls: a cage cannot be sent down faster than it falls, nor a counterweight."""
        if motion.own_ramps or not motion.acceleration.any() or not gravity:
            return
        both = self.counterweight_mass > 0
        downward = float(np.abs(motion.acceleration).max()) if both else float((-motion.acceleration).max())
        sheet.check("rope_slack", "Acceleration downward: the rope stays taut", max(downward, 0.0), gravity, "m/s2",
                    "derived: free fall")  # fmt: skip
