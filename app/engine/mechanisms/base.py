"""What a mechanism is: a declared model that turns a motion into a load cycle and writes every step to the sheet.

A new mechanism is one new file in this package. It derives from :class:`Mechanism`, sets ``kind`` (a Literal with
default), the class variables below, and implements :meth:`Mechanism.load`.
"""

from abc import abstractmethod
from dataclasses import dataclass, field
from typing import ClassVar, Literal

from app.engine.cycle import LoadCycle
from app.engine.environment import Environment
from app.engine.motion.profile import MotionProfile
from app.engine.quantity import Declared
from app.engine.sheet import Sheet


@dataclass(frozen=True)
class Statics:
    """Torques at the drive's output shaft without acceleration [N m], unsigned unless said; what rule sets ask for."""

    friction: float
    """All passive resistances of the moving axis."""
    forward: float
    """Steady motion in positive direction (up): signed torque the drive must give, no process force."""
    backward: float
    """Steady motion in negative direction (down): signed in positive direction, so gravity alone is positive."""
    holding: float
    """Standstill, without the help of friction; signed in positive direction."""
    working: float
    """Largest steady torque with the process force, in the direction in which it occurs."""
    rapid_speed: float
    """Highest speed of the cycle [rad/s]."""
    working_speed: float
    """Highest speed of the segments with a process force; rapid_speed where there is none [rad/s]."""


@dataclass(frozen=True)
class Load:
    """What a mechanism asks of the drive."""

    cycle: LoadCycle
    statics: Statics
    opposite: LoadCycle | None = None
    """The same motion in the opposite direction, for inclined and vertical axes: judged for peak and holding too."""
    results: dict[str, float] = field(default_factory=dict)
    """Headline results by sheet key, shown beside the drive's own."""


class Mechanism(Declared):
    """Base of all mechanisms."""

    kind: str
    title: ClassVar[str]
    """Name for the reader, e.g. ``"Ball or lead screw axis"``."""
    summary: ClassVar[str]
    """One sentence: what it is for."""
    drawing: ClassVar[str]
    """File in ``static/drawings/``: an SVG that carries the symbols of the fields."""
    motion_kind: ClassVar[Literal["linear", "rotary"]]

    @abstractmethod
    def load(self, motion: MotionProfile, environment: Environment, sheet: Sheet) -> Load:
        """Compute the load cycle at the drive's output shaft, with every step on ``sheet``."""
