"""A flying saw or shear: its carriage runs with the material while it cuts, stops, returns and catches up."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal, NoReturn

from app.engine.errors import MotionError
from app.engine.formulas import flying_saw as formulas
from app.engine.formulas import motion as moves
from app.engine.motion.base import MotionModel
from app.engine.motion.move import HOLD_LABELS
from app.engine.motion.profile import MotionProfile
from app.engine.motion.segments import Burden, Hold, Segments
from app.engine.motion.shape import Ramp
from app.engine.quantity import Declaration, Option, Quantity
from app.engine.sheet import Sheet

CUT, RETURN, LOAD = "Material and cut", "Carriage", "Load"
_NONE: dict[str, Any] = {"default": None}


@dataclass(frozen=True)
class _Return:
    """The way back: from standstill behind the cut to standstill at the start."""

    speed: float
    ramp: float
    """[s]"""
    constant: float
    """[s]"""

    @property
    def time(self) -> float:
        """[s]"""
        return 2 * self.ramp + self.constant


@dataclass(frozen=True)
class _CatchUp:
    """The way to the mark: wait at the start, accelerate, run faster than the material, slow down to it."""

    wait: float
    """[s]"""
    speed: float
    constant: float
    """Time at that speed [s]"""
    synchronous: float
    """Time with the material [s]"""


class FlyingSaw(MotionModel):
    """Cycle of a flying saw; its length follows from feed and cut length."""

    kind: Literal["flying_saw"] = "flying_saw"
    title: ClassVar[str] = "Flying saw"
    summary: ClassVar[str] = (
        "Running with the material while it is cut, stop, return, and catching up with the next mark."
    )
    motion_kind: ClassVar[Literal["linear", "rotary"]] = "linear"

    feed_speed: Annotated[float, Quantity("m/s", symbol="v_F", gt=0, le=100, group=CUT, about="Speed of the material")]
    cut_length: Annotated[
        float, Quantity("mm", symbol="L", gt=0, le=1000, group=CUT, about="Length of the pieces: one cycle each")
    ]
    cutting_time: Annotated[float, Quantity("s", symbol="t_c", gt=0, le=1e4, group=CUT, about="Time the cut takes")]
    stroke: Annotated[
        float | None,
        Quantity("mm", symbol="s", gt=0, le=1000, group=RETURN, about="Way from the start to the end of the cut; "
                 "empty: as short as the cut allows, without catching up", **_NONE),
    ]  # fmt: skip
    acceleration: Annotated[
        float,
        Quantity(
            "m/s2", symbol="a", ge=1e-4, le=1e4, group=RETURN, about="Acceleration and deceleration of the carriage"
        ),
    ]
    return_time: Annotated[
        float | None,
        Quantity(
            "s", symbol="t_R", gt=0, le=1e5, group=RETURN, about="Time of the return, instead of its speed", **_NONE
        ),
    ]
    return_speed: Annotated[
        float | None,
        Quantity("m/s", symbol="v_R", gt=0, le=1e3, group=RETURN, about="Highest speed of the return", **_NONE),
    ]
    catch_up_speed: Annotated[
        float | None,
        Quantity("m/s", symbol="v_g", gt=0, le=1e3, group=RETURN, about="Highest speed while it catches up with the "
                 "mark; empty: that of the return", **_NONE),
    ]  # fmt: skip
    payload: Annotated[
        float | None,
        Quantity(
            "kg", symbol="m_p", ge=0, le=1e7, group=LOAD, about="Mass carried beside the mechanism's own", **_NONE
        ),
    ]
    process_force: Annotated[
        float | None,
        Quantity(
            "N", symbol="F_p", ge=-1e8, le=1e8, group=LOAD, about="Force against the motion while it cuts", **_NONE
        ),
    ]
    hold: Annotated[
        Hold,
        Option(default="motor", source="usual for short pauses", about="What holds while the carriage waits",
               labels=HOLD_LABELS, group=LOAD),
    ]  # fmt: skip

    def defaults_taken(self) -> Iterator[tuple[str, Declaration, Any]]:
        """As usual, but who holds is known only when the cycle is solved: no question where the saw catches up."""
        return (item for item in super().defaults_taken() if item[0] != "hold" or self.stroke is None)

    def solve(self, sheet: Sheet) -> MotionProfile:
        """Return, catch up, run with the material, stop; see :class:`MotionModel`."""
        v, a = self.feed_speed, self.acceleration
        with sheet.section("Motion: flying saw"):
            cycle = sheet(moves.time_for_distance, key="cycle_time", symbol="t_cyc", label="Time from cut to cut",
                          s=self.cut_length, v=v)  # fmt: skip
            stop = sheet(moves.ramp_time, key="stop_time", label="Time to stop after the cut", v=v, a=a)
            over = sheet(moves.ramp_distance, key="stop_distance", label="Way to stop after the cut", v=v, t_A=stop)
            stroke = self.stroke
            if stroke is None:
                stroke = over + v * self.cutting_time
            back = self._return(sheet, stroke + over)
            ahead = sheet(formulas.mark_ahead, v_F=v, t=stop + back.time, s=stroke, L=self.cut_length)
            if ahead <= -over * (1 + 1e-9):
                found = self._waiting(sheet, stroke, over, cycle - stop - back.time)
            else:
                found = self._catching_up(sheet, stroke, ahead, back.speed)
            if found.synchronous < self.cutting_time * (1 - 1e-9):
                self._refuse("cutting_time", f"the saw runs with the material for {found.synchronous:.4g} s only, the "
                             "cut takes longer: lengthen the stroke, or shorten return or ramps")  # fmt: skip
        return self._segments(back, found)

    def _refuse(self, field: str, message: str) -> NoReturn:
        raise MotionError(message, field=(self.border_name(field),))

    def _return(self, sheet: Sheet, way: float) -> _Return:
        """Solve the return over the whole way [m]."""
        if (self.return_time is None) == (self.return_speed is None):
            self._refuse("return_time", "give either the time or the speed of the return")
        a = self.acceleration
        highest = float(moves.triangle_speed(way, a, a))
        if self.return_time is not None:
            if (a * self.return_time) ** 2 < 4 * a * way:
                least = 2 * (way / a) ** 0.5
                self._refuse(
                    "return_time", f"too short for {1000 * way:.4g} mm: at this acceleration at least {least:.4g} s"
                )
            speed = sheet(moves.least_speed, key="return_speed", label="Speed of the return", s=way, t=self.return_time,
                          a=a, a_d=a)  # fmt: skip
        else:
            speed = self.return_speed or 0.0
            if speed > highest:
                sheet.decide("The return never reaches its speed", "its ramps meet before")
                speed = highest
        ramp = sheet(moves.ramp_time, key="return_ramp_time", label="Ramps of the return", v=speed, a=a)
        constant = sheet(moves.constant_speed_time, key="return_constant_time", label="Return at constant speed", s=way,
                         v=speed, t_A=ramp, t_D=ramp)  # fmt: skip
        return _Return(speed, ramp, max(constant, 0.0))

    def _waiting(self, sheet: Sheet, stroke: float, over: float, left: float) -> _CatchUp:
        """The mark has yet to come: the saw waits, then needs nothing but its ramp."""
        v = self.feed_speed
        sheet.decide("The saw waits for its mark", "it is back before the mark arrives")
        together = sheet(formulas.synchronous_time, s=stroke, s_y=over, v_F=v)
        ramp = v / self.acceleration
        wait = sheet(moves.sum_of_times, key="waiting_time", symbol="t_w", label="Waiting at the start",
                     t_k=[left, -ramp, -together])  # fmt: skip
        return _CatchUp(max(wait, 0.0), v, 0.0, together)

    def _catching_up(self, sheet: Sheet, stroke: float, ahead: float, usual: float) -> _CatchUp:
        """The mark is ahead: the saw runs faster than the material until it has reached it."""
        v, a = self.feed_speed, self.acceleration
        if self.stroke is None:
            self._refuse("stroke", "the saw must catch up with its mark; give the stroke that it has for this")
        fastest = self.catch_up_speed or usual
        if fastest <= v:
            field = "catch_up_speed" if self.catch_up_speed else "return_time" if self.return_time else "return_speed"
            self._refuse(field, f"the saw must be faster than the material ({v:g} m/s) to catch up with its mark")
        gain = sheet(formulas.catch_up_gain, v=fastest, v_F=v, a=a)
        if gain > ahead:
            fastest = sheet(formulas.catch_up_speed, x_m=ahead, v_F=v, a=a)
            gain = sheet(formulas.catch_up_gain, v=fastest, v_F=v, a=a)
        time = sheet(formulas.catch_up_time, v=fastest, v_F=v, a=a, x_m=ahead, x_g=gain)
        begin = sheet(formulas.synchronous_start, x_m=ahead, v_F=v, t_g=time)
        if begin >= stroke:
            self._refuse(
                "stroke", f"the saw reaches its mark after {1000 * begin:.4g} mm only, behind the end of the stroke"
            )
        together = sheet(formulas.synchronous_time, s=stroke, s_y=begin, v_F=v)
        return _CatchUp(0.0, fastest, max(time - (2 * fastest - v) / a, 0.0), together)

    def _segments(self, back: _Return, found: _CatchUp) -> MotionProfile:
        v, a = self.feed_speed, self.acceleration
        empty, cutting = Burden(self.payload or 0.0), Burden(self.payload or 0.0, self.process_force or 0.0)
        segments = Segments("linear")
        segments.standstill(found.wait, -1.0, empty, self.hold, "waiting for the mark")
        segments.ramp(Ramp(found.speed / a, a), 0.0, found.speed, 1.0, empty, "catching up: accelerating")
        segments.add(found.constant, found.speed, found.speed, empty, 0.0, 1.0, "catching up: constant speed")
        if found.speed > v:
            segments.ramp(
                Ramp((found.speed - v) / a, a), found.speed, v, 1.0, empty, "catching up: slowing to the material"
            )
        segments.add(self.cutting_time, v, v, cutting, cutting.process_force, 1.0, "cutting")
        segments.add(found.synchronous - self.cutting_time, v, v, empty, 0.0, 1.0, "with the material")
        segments.ramp(Ramp(v / a, a), v, 0.0, 1.0, empty, "stopping")
        segments.ramp(Ramp(back.ramp, a), 0.0, back.speed, -1.0, empty, "return: accelerating")
        segments.add(back.constant, -back.speed, -back.speed, empty, 0.0, -1.0, "return: constant speed")
        segments.ramp(Ramp(back.ramp, a), back.speed, 0.0, -1.0, empty, "return: decelerating")
        return segments.profile()
