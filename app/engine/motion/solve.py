"""Solves one move from any sufficient subset of distance, time, speed and acceleration.

==========================  ==================================================================================
given                       found
==========================  ==================================================================================
distance, speed, accel.     time; a triangle where the speed is not reached
distance, time, accel.      speed: the smaller root (which is also the least speed)
distance, time, speed       acceleration
time, speed, accel.         distance
distance, time              speed and acceleration, by the choice of what shall be least
distance, accel.            speed and time, by the choice "least time"
all four                    nothing: they are held against each other
==========================  ==================================================================================

All values are unsigned SI. A move that cannot be raises MotionError at the field it belongs to, in numbers.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal, NoReturn

from app.engine.errors import MotionError
from app.engine.formula import Formula
from app.engine.formulas import motion as formulas
from app.engine.motion.rotary import SHOWN, SYMBOLS, rotary
from app.engine.motion.shape import NO_SMOOTHING, MoveShape, Smoothing, minimum_of, root
from app.engine.quantity import from_si
from app.engine.sheet import Sheet

Optimise = Literal["least_acceleration", "least_effective_acceleration", "least_speed", "least_time"]

OPTIMISE_LABELS: dict[Any, str] = {
    None: "nothing: the move is fully described",
    "least_acceleration": "least acceleration (triangle) for distance and time",
    "least_effective_acceleration": "least effective acceleration (thirds) for distance and time",
    "least_speed": "least speed for distance, time and acceleration",
    "least_time": "least time for distance and acceleration",
}

AGREEMENT = 5e-3
"""Relative deviation at which four given values still agree: figures typed with three digits."""
_EXACT = 1e-12


@dataclass(frozen=True, kw_only=True)
class Given:
    """What is known of a move (None: not given), unsigned SI; ``time`` without settling."""

    distance: float | None = None
    time: float | None = None
    speed: float | None = None
    acceleration: float | None = None
    deceleration: float | None = None
    ratio: float | None = None
    """Deceleration / acceleration, where no deceleration is given; None: equal."""
    smoothing: Smoothing = NO_SMOOTHING
    settling: float = 0.0
    optimise: Optimise | None = None


@dataclass(frozen=True)
class Notes:
    """Writes the steps of one move to a sheet, and its refusals in the reader's units at the reader's fields."""

    sheet: Sheet
    prefix: str = "move_1_"
    kind: Literal["linear", "rotary"] = "linear"
    fields: Mapping[str, str] | None = None
    """Attribute of ``Given`` -> name at the border."""

    def __call__(self, formula: Formula[..., Any], key: str, symbol: str = "", **values: Any) -> float:
        """Evaluate and record under the move's own key; returns the value. ``symbol`` replaces that of the formula."""
        key = self.prefix + key
        if self.kind == "linear":
            return self.sheet(formula, key=key, symbol=symbol, **values)
        named = {SYMBOLS.get(name, name): value for name, value in values.items()}
        return self.sheet(rotary(formula), key=key, symbol=SYMBOLS.get(symbol, symbol), **named)

    def decide(self, text: str, reason: str) -> None:
        """Record the branch taken and why."""
        self.sheet.decide(text, reason)

    def shown(self, value: float, unit: str) -> str:
        """A value with its unit; ``unit`` is the one of straight motion, e.g. m/s."""
        unit = unit if self.kind == "linear" else SHOWN.get(unit, unit)
        return f"{from_si(value, unit):.6g} {unit}"

    def refusal(self, field: str, message: str) -> MotionError:
        """The error of a field of the move."""
        return MotionError(message, field=((self.fields or {}).get(field, field),))

    def refuse(self, field: str, message: str) -> NoReturn:
        """Raise the error of a field of the move."""
        raise self.refusal(field, message)


def solve_move(given: Given, notes: Notes) -> MoveShape:
    """Find what is missing and record how; see the module for which subsets suffice.

    Raises MotionError with the reason where the move cannot be, is not determined, or contradicts itself.
    """
    return _Solver(given, notes).solve()


@dataclass(frozen=True)
class _Solver:
    given: Given
    notes: Notes

    def solve(self) -> MoveShape:
        g = self.given
        self._refuse_unfit_choice()
        match (g.distance, g.time, g.speed, g.acceleration):
            case (float() as s, time, float() as v, float() as a):
                shape = self._shape(s, self._reached_speed(s, v, a, self._deceleration(a)), a, self._deceleration(a))
                self._compare(shape, time)
                return shape
            case (float() as s, float() as t, None, float() as a):
                return self._shape(s, self._speed_in_time(s, t, a), a, self._deceleration(a))
            case (float() as s, float() as t, v, None) if v is not None or g.optimise is not None:
                v = self._best_speed(s, t) if g.optimise else v
                assert v is not None
                return self._shape(s, v, *self._rates(s, v, t))
            case (None, float() as t, float() as v, float() as a):
                return self._shape(*self._distance(t, v, a), a, self._deceleration(a))
            case (float() as s, None, None, float() as a) if g.optimise == "least_time":
                return self._shape(s, self._triangle(s, a, self._deceleration(a)), a, self._deceleration(a))
        raise self._underdetermined()

    # What is given, and whether it suffices

    def _refuse_unfit_choice(self) -> None:
        g = self.given
        fits = {
            "least_acceleration": g.distance and g.time and not g.acceleration,
            "least_effective_acceleration": g.distance and g.time and not g.acceleration,
            "least_speed": g.distance and g.time and g.acceleration and not g.speed,
            "least_time": g.distance and g.acceleration and not g.time,
        }
        needs = {
            "least_acceleration": "a distance and a time, and no acceleration (a speed counts as its limit)",
            "least_effective_acceleration": "a distance and a time, and no acceleration (a speed counts as its limit)",
            "least_speed": "a distance, a time and an acceleration, and no speed",
            "least_time": "a distance and an acceleration, and no time (a speed counts as its limit)",
        }
        if g.optimise and not fits[g.optimise]:
            words = g.optimise.replace("_", " ")
            self.notes.refuse("optimise", f"{words} is sought from {needs[g.optimise]}; given: {self._named()}")

    def _named(self) -> str:
        values = {name: getattr(self.given, name) for name in ("distance", "time", "speed", "acceleration")}
        names = [name for name, value in values.items() if value is not None]
        return " and ".join([", ".join(names[:-1]), names[-1]]) if len(names) > 1 else "".join(names) or "none of them"

    def _underdetermined(self) -> MotionError:
        g = self.given
        options = {
            (True, True, False, False): ("optimise", "a speed or an acceleration, or choose what shall be least: "
                                         "the acceleration or the effective acceleration"),
            (True, False, False, True): ("speed", "a speed or a time, or choose the least time"),
            (True, False, True, False): ("acceleration", "an acceleration or a time"),
            (False, True, True, False): ("acceleration", "an acceleration or a distance"),
            (False, True, False, True): ("distance", "a distance or a speed"),
            (False, False, True, True): ("distance", "a distance or a time"),
        }  # fmt: skip
        known = (g.distance is not None, g.time is not None, g.speed is not None, g.acceleration is not None)
        default = ("distance" if g.distance is None else "time", "three of distance, time, speed and acceleration")
        field, needed = options.get(known, default)
        verb = "alone does not" if sum(known) == 1 else "do not"
        return self.notes.refusal(field, f"{self._named()} {verb} determine the move: give {needed}")

    def _deceleration(self, acceleration: float) -> float:
        g = self.given
        return g.deceleration if g.deceleration is not None else acceleration * (g.ratio or 1.0)

    # Speed

    def _ramps(self, v: float, a: float, d: float) -> tuple[float, float]:
        smoothing = self.given.smoothing
        return smoothing.ramp_time(v, a), smoothing.ramp_time(v, d)

    def _reached_speed(self, s: float, v: float, a: float, d: float) -> float:
        """The given speed, or that of the triangle where the distance is too short for it."""
        if v * sum(self._ramps(v, a, d)) / 2 <= s * (1 + _EXACT):
            return v
        reached = self._triangle(s, a, d)
        self.notes.decide(
            f"Triangle: {self.notes.shown(v, 'm/s')} is not reached",
            f"over {self.notes.shown(s, 'm')} only {self.notes.shown(reached, 'm/s')} is reached before braking",
        )
        return reached

    def _triangle(self, s: float, a: float, d: float) -> float:
        """Highest speed over a distance."""
        smoothing, notes = self.given.smoothing, self.notes
        if smoothing.jerk is None:
            return notes(formulas.triangle_speed, "speed", s=s, a=smoothing.mean(a), a_d=smoothing.mean(d))
        # A ramp takes at least v/a and 2*sqrt(v/j), and at most their sum: that brackets the speed.
        high = min(float(formulas.triangle_speed(s, a, d)), (s * s * smoothing.jerk / 4) ** (1 / 3))
        v = root(lambda v: v * sum(self._ramps(v, a, d)) / 2 - s, high / 2, high)
        t_A, t_D = self._ramps(v, a, d)
        self._by_iteration("Peak speed")
        return notes(formulas.least_acceleration_speed, "speed", s=s, t=t_A + t_D)

    def _triangle_in_time(self, t: float, a: float, d: float) -> float:
        """Highest speed within a time."""
        smoothing = self.given.smoothing
        if smoothing.jerk is None:
            return float(formulas.triangle_speed_in_time(t, smoothing.mean(a), smoothing.mean(d)))
        high = min(float(formulas.triangle_speed_in_time(t, a, d)), t * t * smoothing.jerk / 16)
        return root(lambda v: sum(self._ramps(v, a, d)) - t, high / 4, high)

    def _speed_in_time(self, s: float, t: float, a: float) -> float:
        """Speed that covers the distance in the time: the smaller root."""
        d, notes, smoothing = self._deceleration(a), self.notes, self.given.smoothing
        peak = self._triangle_in_time(t, a, d)
        longest = peak * t / 2
        if s > longest * (1 + _EXACT):
            notes.refuse("distance", self._too_far(s, t, a, d, longest))
        notes.decide(
            "Of the two speeds that give this distance in this time, the smaller one is taken",
            f"the larger one would exceed {notes.shown(peak, 'm/s')}, the most that {notes.shown(t, 's')} allow",
        )
        if smoothing.jerk is None:
            return notes(formulas.least_speed, "speed", s=s, t=t, a=smoothing.mean(a), a_d=smoothing.mean(d))
        v = root(lambda v: s / v + sum(self._ramps(v, a, d)) / 2 - t, s / t, peak)
        t_A, t_D = self._ramps(v, a, d)
        self._by_iteration("Peak speed")
        return notes(formulas.speed_between_ramps, "speed", s=s, t=t, t_A=t_A, t_D=t_D)

    def _too_far(self, s: float, t: float, a: float, d: float, longest: float) -> str:
        shown, jerk = self.notes.shown, self.given.smoothing.jerk
        braking = "" if d == a else f" and braking with {shown(d, 'm/s2')}"
        jerking = "" if jerk is None else f", limited to {shown(jerk, 'm/s3')},"
        settled = f" (settling of {shown(self.given.settling, 's')} taken off)" if self.given.settling else ""
        return (
            f"{shown(a, 'm/s2')}{braking}{jerking} for {shown(t, 's')}{settled} covers at most {shown(longest, 'm')}, "
            f"not {shown(s, 'm')}"
        )

    def _distance(self, t: float, v: float, a: float) -> tuple[float, float]:
        """Distance, and the speed that is really reached."""
        d, notes = self._deceleration(a), self.notes
        t_A, t_D = self._ramps(v, a, d)
        if t_A + t_D <= t * (1 + _EXACT):
            return notes(formulas.move_distance, "distance", v=v, t=t, t_A=t_A, t_D=t_D), v
        reached = self._triangle_in_time(t, a, d)
        notes.decide(
            f"Triangle: {notes.shown(v, 'm/s')} is not reached",
            f"within {notes.shown(t, 's')} only {notes.shown(reached, 'm/s')} is reached before braking",
        )
        t_A, t_D = self._ramps(reached, a, d)
        return notes(formulas.move_distance, "distance", v=reached, t=t, t_A=t_A, t_D=t_D), reached

    # Acceleration

    def _best_speed(self, s: float, t: float) -> float:
        """Peak speed by the choice of what shall be least; a given speed is the limit."""
        g, notes = self.given, self.notes
        if g.optimise == "least_acceleration":
            best = notes(formulas.least_acceleration_speed, "speed", s=s, t=t)
        elif g.smoothing.jerk is None and g.deceleration is None:
            best = notes(formulas.least_effective_speed, "speed", s=s, t=t)
        else:
            best = minimum_of(lambda v: self._effective_square(s, v, t), s / t, min(2 * s / t, g.speed or 2 * s / t))
            self._by_iteration("Peak speed of the least effective acceleration")
        if g.speed is None or best <= g.speed:
            return best
        notes.decide(
            f"Speed limited to {notes.shown(g.speed, 'm/s')}",
            f"without this limit the best peak speed would be {notes.shown(best, 'm/s')}",
        )
        return g.speed

    def _effective_square(self, s: float, v: float, t: float) -> float:
        """Integral of the squared acceleration over the move, infinite where the move cannot be."""
        try:
            a, d = _Solver(self.given, Notes(Sheet(), fields=self.notes.fields))._rates(s, v, t)
        except MotionError:
            return float("inf")
        ramps = (self.given.smoothing.ramp(v, a), self.given.smoothing.ramp(v, d))
        return sum(ramp.acceleration**2 * (ramp.time - 4 / 3 * ramp.jerk_time) for ramp in ramps)

    def _rates(self, s: float, v: float, t: float) -> tuple[float, float]:
        """Acceleration and deceleration that cover the distance in the time at this peak speed."""
        g, notes = self.given, self.notes
        if t * v <= s * (1 + _EXACT):
            notes.refuse("time", f"{notes.shown(s, 'm')} at {notes.shown(v, 'm/s')} takes more than "
                         f"{notes.shown(s / v, 's')} even without accelerating, "
                         f"not {notes.shown(t, 's')}")  # fmt: skip
        if t * v > 2 * s * (1 + _EXACT):
            notes.refuse("speed", f"{notes.shown(s, 'm')} in {notes.shown(t, 's')} needs at most "
                         f"{notes.shown(2 * s / t, 'm/s')}, the peak of a triangle, not {notes.shown(v, 'm/s')}; "
                         f"choose the least acceleration to take the speed as a limit")  # fmt: skip
        if g.deceleration is None:
            a = self._acceleration_by_ratio(s, v, t, g.ratio or 1.0)
            return a, a * (g.ratio or 1.0)
        t_D = g.smoothing.ramp_time(v, g.deceleration)
        if t_D >= 2 * (t - s / v):
            notes.refuse("deceleration", f"braking from {notes.shown(v, 'm/s')} with "
                         f"{notes.shown(g.deceleration, 'm/s2')} leaves no time to accelerate")  # fmt: skip
        t_A = notes(formulas.ramp_time_left, "acceleration_time", s=s, v=v, t=t, t_D=t_D)
        self._refuse_jerk_below(v, t_A)
        return self._acceleration(v, t_A), g.deceleration

    def _acceleration_by_ratio(self, s: float, v: float, t: float, ratio: float) -> float:
        g, notes = self.given, self.notes
        smoothing, jerk = g.smoothing, g.smoothing.jerk
        if jerk is not None and ratio != 1.0:
            both = 2 * (t - s / v)
            self._refuse_jerk_below(v, both / 2)
            low, high = v * (1 + 1 / ratio) / both, (v * jerk) ** 0.5 * max(1.0, 1 / ratio)
            a = root(lambda a: sum(self._ramps(v, a, a * ratio)) - both, low, high)
            self._by_iteration("Acceleration")
            return self._acceleration(v, smoothing.ramp_time(v, a)) if a * a < v * jerk else a
        if smoothing == NO_SMOOTHING and g.optimise == "least_acceleration" and v * t >= 2 * s * (1 - _EXACT):
            return notes(formulas.least_acceleration, "acceleration", s=s, t=t, r_a=ratio)
        t_A = notes(formulas.ramp_time_by_ratio, "acceleration_time", s=s, v=v, t=t, r_a=ratio)
        self._refuse_jerk_below(v, t_A)
        return self._acceleration(v, t_A)

    def _acceleration(self, v: float, t_A: float) -> float:
        smoothing, notes = self.given.smoothing, self.notes
        if smoothing.jerk is not None:
            return notes(formulas.s_curve_acceleration, "acceleration", v=v, t_A=t_A, j=smoothing.jerk)
        if smoothing.share:
            return notes(formulas.share_acceleration, "acceleration", v=v, t_A=t_A, lambda_j=smoothing.share)
        return notes(formulas.ramp_acceleration, "acceleration", v=v, t_A=t_A)

    def _refuse_jerk_below(self, v: float, t_A: float) -> None:
        jerk, notes = self.given.smoothing.jerk, self.notes
        if jerk is not None and t_A**2 * jerk < 4 * v * (1 - _EXACT):
            notes.refuse("jerk", f"{notes.shown(v, 'm/s')} within {notes.shown(t_A, 's')} needs a jerk of at least "
                         f"{notes.shown(4 * v / t_A**2, 'm/s3')}, not {notes.shown(jerk, 'm/s3')}")  # fmt: skip

    # Result

    def _by_iteration(self, what: str) -> None:
        self.notes.decide(
            f"{what} found by iteration", "the jerk limit leaves no closed form; the steps below prove it"
        )

    def _compare(self, shape: MoveShape, time: float | None) -> None:
        if time is None:
            return
        g, notes, right = self.given, self.notes, shape.motion_time
        if abs(right - time) > AGREEMENT * right:
            move = [notes.shown(shape.distance, "m"), notes.shown(g.speed or 0.0, "m/s")]
            move.append(notes.shown(g.acceleration or 0.0, "m/s2"))
            needed, wanted = notes.shown(right + g.settling, "s"), notes.shown(time + g.settling, "s")
            notes.refuse("time", f"{move[0]} with {move[1]} and {move[2]} takes {needed}, not {wanted}")
        notes.decide(
            "Distance, time, speed and acceleration are all given and agree",
            f"distance, speed and acceleration are taken; they give {notes.shown(right, 's')}",
        )

    def _shape(self, s: float, v: float, a: float, d: float) -> MoveShape:
        """Build the move, and record its times."""
        smoothing, notes = self.given.smoothing, self.notes
        up, down = smoothing.ramp(v, a), smoothing.ramp(v, d)
        self._record_ramp(v, a, "acceleration", ("a", "t_A", "s_A"))
        self._record_ramp(v, d, "deceleration", ("a_d", "t_D", "s_D"))
        values: dict[str, Any] = {"s": s, "v": v, "t_A": up.time, "t_D": down.time}
        constant = float(formulas.constant_speed_time(**values))
        if constant > _EXACT * (up.time + down.time):
            notes(formulas.constant_speed_time, "constant_time", **values)
        else:
            constant = 0.0
        time = notes(formulas.move_time, "motion_time" if self.given.settling else "time", **values)
        if self.given.settling:
            notes(formulas.positioning_time, "time", t=time, t_set=self.given.settling)
        notes(formulas.mean_speed_of_move, "mean_speed", s=s, t=time)
        return MoveShape(s, v, up, down, constant, self.given.settling)

    def _record_ramp(self, v: float, a: float, name: str, symbols: tuple[str, str, str]) -> None:
        smoothing, notes = self.given.smoothing, self.notes
        rate, time, distance = symbols
        key = f"{name}_time"
        if notes.sheet.has(notes.prefix + key):
            t_A = notes.sheet.value(notes.prefix + key)
        elif smoothing.jerk is not None:
            t_A = notes(formulas.s_curve_ramp_time, key, time, v=v, a=a, j=smoothing.jerk)
        elif smoothing.share:
            mean = notes(formulas.mean_ramp_acceleration, f"mean_{name}", a=a, lambda_j=smoothing.share)
            t_A = notes(formulas.ramp_time, key, time, v=v, a=mean)
        else:
            t_A = notes(formulas.ramp_time, key, time, v=v, a=a)
        notes(formulas.ramp_distance, f"{name}_distance", distance, v=v, t_A=t_A)
        if smoothing.jerk is not None:
            reached = notes(formulas.s_curve_peak_acceleration, f"peak_{name}", rate, v=v, a=a, j=smoothing.jerk)
            notes(formulas.jerk_time, f"{name}_jerk_time", a=reached, j=smoothing.jerk)
        elif smoothing.share:
            notes(formulas.share_jerk, f"{name}_jerk", a=a, t_A=t_A, lambda_j=smoothing.share)
