"""What a kind of drive is: a declared model (rules and parts) that checks itself against a load.

A new kind is one new module in this package: a model that derives from :class:`DriveModel`, sets ``kind`` (a Literal
with default) and the class variables below, and implements :meth:`DriveModel.check`.
"""

from abc import abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, ClassVar, Protocol

from app.engine.cycle import FloatArray
from app.engine.diagram import Diagram
from app.engine.environment import Environment
from app.engine.mechanisms.load import Load
from app.engine.motion.profile import MotionProfile
from app.engine.products import Product
from app.engine.quantity import Declared
from app.engine.sheet import Check, Sheet, Verdict, verdict

Points = tuple[tuple[float, float], ...]


class Limits(Protocol):
    """What a motor may give over its speed: points (speed [rad/s], torque [N m]) by rising speed, for the chart."""

    @property
    def max_speed(self) -> float | None:
        """Speed at which the curves end [rad/s]."""

    def peak_points(self) -> Points:
        """The peak curve; empty where it is not known."""

    def continuous_points(self) -> Points:
        """The continuous (S1) curve; empty where it is not known."""


@dataclass(frozen=True)
class ShaftPoints:
    """One cycle as the motor sees it; all arrays of shape (n,) unless said."""

    time: FloatArray
    """Segment borders from 0, shape (n + 1,) [s]"""
    speed_start: FloatArray
    """Motor speed at the start of each segment, signed [rad/s]"""
    speed_end: FloatArray
    torque: FloatArray | None
    """Motor torque in each segment, signed [N m]; None where the gear unit's data do not suffice."""
    label: tuple[str, ...]


@dataclass(frozen=True)
class Given:
    """What a drive is checked against."""

    load: Load
    profile: MotionProfile
    products: Mapping[str, Product]
    """Chosen products by role, the name of the model's field; a role that is not chosen is not there."""
    environment: Environment

    def product(self, role: str) -> Any:
        """The product of a role, None where none is chosen."""
        return self.products.get(role)


@dataclass(frozen=True, kw_only=True)
class DriveResult:
    """What a drive does on one load: points for charts, headline numbers and checks."""

    ratio: float = 1.0
    checks: tuple[Check, ...] = ()
    headlines: tuple[str, ...] = ()
    """Step keys of the numbers shown before all others, in order; those that were not recorded are left out."""
    cycle: ShaftPoints | None = None
    """None where the drive makes its own ramps, so that the cycle of the load is not its own."""
    opposite: ShaftPoints | None = None
    limits: Limits | None = None
    mean_speed: float | None = None
    """[rad/s]"""
    effective_torque: float | None = None
    """[N m]"""
    peak_torque: float | None = None
    """[N m]"""
    diagrams: tuple[Diagram, ...] = ()
    numbers: dict[str, float] = field(default_factory=dict)
    """Headline numbers by sheet key, SI."""

    @property
    def utilisation(self) -> float | None:
        """Largest utilisation of all checks that could be made; None without any."""
        return max((used for check in self.checks if (used := check.utilisation) is not None), default=None)

    @property
    def verdict(self) -> Verdict:
        """Verdict on the largest utilisation."""
        return verdict(self.utilisation)

    @property
    def not_checked(self) -> tuple[Check, ...]:
        """Checks that could not be made."""
        return tuple(check for check in self.checks if check.verdict == Verdict.NOT_CHECKED)


class DriveModel(Declared):
    """Base of all kinds of drive: rules and parts, as far as they are chosen."""

    kind: str
    title: ClassVar[str]
    """Name for the reader, e.g. ``"Servo drive"``."""
    summary: ClassVar[str]
    """One sentence: when to use it."""
    own_ramps: ClassVar[bool] = False
    """Whether the motor makes its own ramps (line-fed), so that those of the motion are not used."""

    @abstractmethod
    def check(self, given: Given, sheet: Sheet) -> DriveResult:
        """Check the drive against a load, with every step, decision and check on ``sheet``.

        Without parts: what they must be able to do. Data that a product lacks give a check that is not made.
        """
