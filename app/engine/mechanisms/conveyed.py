"""What conveyors share: goods that are moved by a force, whatever the surface that moves them."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from app.engine.environment import Environment
from app.engine.formulas.resistance import sum_of_forces
from app.engine.mechanisms.linear_axis import force_on
from app.engine.motion.profile import FloatArray, MotionProfile
from app.engine.sheet import Sheet

Force = Callable[[Any, float], Any]
"""Force [N] by payload [kg] and gravity [m/s2]."""


@dataclass(frozen=True)
class Conveyed:
    """Goods on a conveyor, as a body that is moved in a straight line."""

    mass: float
    """Everything that moves beside the payload [kg]"""
    weight: Force
    """Force against the positive direction whatever the motion"""
    resistance: Force
    """Unsigned resistance"""
    inclined: bool
    viscous_coefficient: float = 0.0

    def moved_mass(self, payload: Any) -> Any:
        """All mass that is accelerated [kg]."""
        return self.mass + payload

    def constant_force(self, payload: Any, gravity: float) -> Any:
        """Force against the positive direction whatever the motion [N]."""
        return self.weight(payload, gravity) + 0.0 * np.asarray(payload)

    def friction(self, payload: Any, gravity: float) -> Any:
        """Unsigned resistance [N]."""
        return self.resistance(payload, gravity) + 0.0 * np.asarray(payload)

    def force(self, motion: MotionProfile, gravity: float) -> FloatArray:
        """Force that moves everything in each segment [N]."""
        return force_on(self, motion, gravity)

    def record_forces(self, sheet: Sheet, payload: float, environment: Environment) -> tuple[float, float]:
        """Record weight and resistance with one payload, as the sums that the mechanism has written out before."""
        g = environment.gravity
        weight, friction = float(self.constant_force(payload, g)), float(self.friction(payload, g))
        label = "Weight of the goods along the conveyor"
        sheet(sum_of_forces, key="gravity_force", symbol="F_g", label=label, F_k=[weight])
        label = "All resistances of the conveyor"
        sheet(sum_of_forces, key="resistance", symbol="F_W", label=label, F_k=[friction])
        return weight, friction
