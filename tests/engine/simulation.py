"""A drive axis simulated in small steps of time, with equations of its own and power instead of torque at each stage.

Nothing of the formulas of the engine is used here: tests hold the engine against it.
"""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

G = 9.81
STEPS = 8
"""Steps of a phase of constant acceleration; torque is constant in it unless friction grows with speed."""


@dataclass
class Moment:
    """One step of time: motion of the axis in its middle, what it carries and works against."""

    t: float
    dt: float
    v: float
    a: float
    way: float
    payload: float
    process: float
    braked: bool = False


@dataclass
class Books:
    """Energy as it goes [J]."""

    lost: float = 0.0
    process: float = 0.0
    put_in: float = 0.0


@dataclass
class Run:
    """A simulated cycle on the motor shaft."""

    time: list[float] = field(default_factory=list)
    width: list[float] = field(default_factory=list)
    torque: list[float] = field(default_factory=list)
    speed: list[float] = field(default_factory=list)
    books: Books = field(default_factory=Books)

    @property
    def effective(self) -> float:
        return math.sqrt(sum(M * M * dt for M, dt in zip(self.torque, self.width, strict=True)) / sum(self.width))

    @property
    def mean_speed(self) -> float:
        return sum(abs(n) * dt for n, dt in zip(self.speed, self.width, strict=True)) / sum(self.width)


@dataclass(frozen=True)
class Stage:
    """A stage with a loss: by the same share both ways, or by the same loss both ways (SEW)."""

    eta: float
    sew: bool = False

    def power_in(self, power: float, dt: float, books: Books) -> float:
        """Power on the driving side from that on the driven side."""
        if power >= 0:
            needed = power / self.eta
        elif self.sew:
            # driving, a power P costs P/eta - P; the same share of what comes back is lost
            needed = min(power - power * (1 / self.eta - 1), 0.0)
        else:
            needed = power * self.eta
        books.lost += (needed - power) * dt
        return needed


def trapezoids(moves: list[dict[str, float]], steps: int) -> Iterator[Moment]:
    """Walk through all moves: speed up, go on, slow down, stand."""
    t = 0.0
    for move in moves:
        way, length, v, a = math.copysign(1.0, move["s"]), abs(move["s"]), move["v"], move["a"]
        if v * v / a > length:
            v = math.sqrt(length * a)
        ramp = v / a
        phases = [(ramp, a, 0.0), ((length - v * ramp) / v, 0.0, v), (ramp, -a, v), (move["dwell"], 0.0, 0.0)]
        for number, (duration, rate, speed) in enumerate(phases):
            dt = duration / steps
            if duration < 1e-9:
                continue
            for _ in range(steps):
                half = speed + rate * dt / 2
                stands = number == 3
                yield Moment(
                    t + dt / 2, dt, way * half, way * rate, way, move["payload"],
                    0.0 if stands else move["force"], stands and move["brake"] > 0,
                )  # fmt: skip
                speed += rate * dt
                t += dt


@dataclass(frozen=True)
class Drive:
    """Gear unit and motor."""

    ratio: float
    eta: float
    sew: bool
    gear_inertia: float
    rotor: float

    def simulate(self, axis: Callable[[Moment, Books], tuple[float, float, float]], walk: Iterator[Moment]) -> Run:
        """``axis`` gives torque, speed and acceleration of the shaft behind the gear unit at one moment."""
        run, stage = Run(), Stage(self.eta, self.sew)
        for now in walk:
            torque, omega, alpha = axis(now, run.books)
            if now.braked:
                M = 0.0
            elif omega == 0:
                M = torque / self.ratio
            else:
                power = stage.power_in(torque * omega, now.dt, run.books)
                M = power / (omega * self.ratio) + (self.rotor + self.gear_inertia) * alpha * self.ratio
            run.time.append(now.t)
            run.width.append(now.dt)
            run.torque.append(M)
            run.speed.append(omega * self.ratio)
            run.books.put_in += M * omega * self.ratio * now.dt
            run.books.process += now.process * abs(now.v) * now.dt
        return run


def opposed(friction: float, v: float) -> float:
    """Friction against the motion, none at standstill."""
    return friction * (v > 0) - friction * (v < 0)


def rod_inertia(diameter: float, length: float, density: float) -> float:
    """Inertia of a round bar summed up over thin tubes."""
    n = 4000
    width = diameter / 2 / n
    return sum(2 * math.pi * r * width * length * density * r * r for r in ((k + 0.5) * width for k in range(n)))
