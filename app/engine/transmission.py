"""A shaft that moves a mass in a straight line, as the search for the best transmission sees it."""

import math
from dataclasses import dataclass
from typing import Literal, Protocol, runtime_checkable

from app.engine.environment import Environment


@dataclass(frozen=True, kw_only=True)
class LinearTransmission:
    """What stays the same and what changes when the lead or diameter of a mechanism is chosen anew."""

    size: Literal["lead", "diameter"]
    """What the reader chooses: the lead of a screw (2 pi A), or the pitch diameter of a pulley or pinion (2 A)."""
    constant: float
    """A as it is now: travel per radian of the mechanism's shaft [m/rad]"""
    mass: float
    """All mass moved in a straight line, payload included [kg]"""
    front_inertia: float = 0.0
    """On the mechanism's shaft before its losses, independent of A [kg m2]"""
    rear_inertia: float = 0.0
    """On the mechanism's shaft behind its losses, independent of A [kg m2]"""
    front_pulleys: float = 0.0
    """Inertia of solid pulleys before the losses, divided by diameter^4 [kg/m2]: it grows with A"""
    rear_pulleys: float = 0.0
    """The same of those behind the losses [kg/m2]"""
    resisting_force: float = 0.0
    """Friction, weight and external force that oppose motion in positive direction [N]"""
    efficiency: float = 1.0
    """Of the mechanism, while it drives"""

    @property
    def size_per_constant(self) -> float:
        """Lead or diameter over A."""
        return 2 * math.pi if self.size == "lead" else 2.0


@runtime_checkable
class HasTransmission(Protocol):
    """A mechanism whose lead or diameter can be optimised."""

    def transmission(self, payload: float, environment: Environment) -> LinearTransmission:
        """Describe the mechanism with a payload [kg]."""
        ...
