"""What a mechanism asks of the drive: load cycle, static torques, states of load."""

from dataclasses import dataclass, field

from app.engine.cycle import LoadCycle
from app.engine.diagram import Diagram


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


@dataclass(frozen=True, kw_only=True)
class LoadState:
    """The axis in one state of load at steady speed, before any loss: what a drive asks that makes its own ramps.

    All values stand at the drive's output shaft. Line-fed and pole-changing motors start and stop by themselves: run-up
    time, braking distance and starting frequency follow from these states, not from the ramps of a motion.
    """

    key: str
    """Prefix of step keys, unique in the load: ``"laden_forward"``."""
    label: str
    """For the reader: ``"laden, forward"``."""
    direction: float
    """+1 or -1"""
    torque: float
    """Steady torque without losses [N m]; positive opposes the motion, negative drives it."""
    inertia: float
    """Inertia that is reached through the losses [kg m2]"""
    front_inertia: float = 0.0
    """Inertia on the output shaft itself, before the losses [kg m2]"""
    speed: float
    """Steady speed, unsigned [rad/s]"""
    efficiency: float = 1.0
    """Product of all efficiencies of the mechanism behind this shaft."""
    travel: float | None = None
    """Path of the load per radian of this shaft [m/rad]; None where the load turns."""
    permissible_acceleration: float | None = None
    """Of the load before wheels slip or goods topple: [m/s2], or [rad/s2] of this shaft where ``travel`` is None."""
    process_torque: float = 0.0
    """Part of ``torque`` that acts at full speed only, not while starting and stopping [N m]"""
    starts: float = 1.0
    """Starts in this state in each cycle."""
    duration: float = 0.0
    """Time in this state in each cycle [s]"""
    curve: tuple[tuple[float, float], ...] = ()
    """Points (speed [rad/s], torque [N m]) where the torque depends on the speed (fan, pump); else empty."""


@dataclass(frozen=True)
class Load:
    """What a mechanism asks of the drive."""

    cycle: LoadCycle
    statics: Statics
    opposite: LoadCycle | None = None
    """The same motion in the opposite direction, for inclined and vertical axes: judged for peak and holding too."""
    results: dict[str, float] = field(default_factory=dict)
    """Headline results by sheet key, shown beside the drive's own."""
    states: tuple[LoadState, ...] = ()
    """States of load for drives that make their own ramps; empty where the mechanism has no steady running."""
    diagrams: tuple[Diagram, ...] = ()
    """What the mechanism itself wants shown."""
