"""A cycle that runs at constant speed: conveyors, fans, spindles; with starts where they matter."""

from abc import abstractmethod
from collections.abc import Iterator
from typing import Annotated, Any, ClassVar, Literal, NoReturn

from app.engine.errors import MotionError
from app.engine.formulas import motion as formulas
from app.engine.motion.base import MotionModel
from app.engine.motion.move import HOLD_LABELS
from app.engine.motion.profile import MotionProfile
from app.engine.motion.segments import Burden, Hold, Segments
from app.engine.motion.shape import Ramp
from app.engine.motion.solve import Notes
from app.engine.quantity import Declaration, Option, Quantity
from app.engine.sheet import Sheet

NOMINAL_DURATION = 1.0
"""Length of a cycle of steady running alone [s]; what depends on it takes a length of its own, see ``endless``."""
NOMINAL_STARTS = 1.0
"""Starts per hour where none are given: so rare that they count for the peak, not for the effective value."""
HOUR = 3600.0
"""[s]"""

_OPTIONAL: dict[str, Any] = {"default": None}


class SteadyRunning(MotionModel):
    """What constant motion and constant rotation share. Fields without a declaration here get theirs below."""

    speed: float
    duration: Annotated[
        float | None,
        Quantity("s", symbol="t_r", ge=1e-3, le=1e8, about="Time at constant speed per start; empty: all the time "
                 "between the starts", group="Running", **_OPTIONAL),
    ]  # fmt: skip
    acceleration: float | None = None
    run_up_time: Annotated[
        float | None,
        Quantity("s", symbol="t_A", ge=1e-4, le=1e5, about="Run-up time, instead of an acceleration", group="Starting",
                 **_OPTIONAL),
    ]  # fmt: skip
    deceleration: float | None = None
    starts_per_hour: Annotated[
        float | None,
        Quantity("1", symbol="Z", gt=0, le=36000, about="Starts per hour", group="Starting", **_OPTIONAL),
    ]
    hold: Annotated[
        Hold,
        Option(default="motor", source="usual for short pauses", about="What holds between stop and start",
               labels=HOLD_LABELS, group="Starting"),
    ]  # fmt: skip

    motion_kind: ClassVar[Literal["linear", "rotary"]]

    @property
    @abstractmethod
    def burden(self) -> Burden:
        """What is moved and worked against."""

    def defaults_taken(self) -> Iterator[tuple[str, Declaration, Any]]:
        """As usual, but who holds is no question without a standstill."""
        stands = self.duration is not None and self.starts_per_hour is not None
        return (item for item in super().defaults_taken() if item[0] != "hold" or stands)

    def solve(self, sheet: Sheet) -> MotionProfile:
        """Run up, run, run down and stand still; see :class:`MotionModel`."""
        if self.speed == 0:
            self._refuse("speed", "a steady motion needs a speed other than zero")
        segments = Segments(self.motion_kind)
        with sheet.section("Motion"):
            ramps = self._ramps(sheet)
            if ramps is None:
                self._run(segments, self.duration or NOMINAL_DURATION)
                sheet.decide("Steady running only", "without a run-up nothing but the steady load is judged")
                return segments.profile(endless=self.duration is None)
            up, down = ramps
            running, rest = self._running_and_rest(up.time + down.time, sheet)
            size, direction = abs(self.speed), self._direction
            segments.ramp(up, 0.0, size, direction, self.burden, "run-up: accelerating")
            self._run(segments, running)
            segments.ramp(down, size, 0.0, direction, self.burden, "run-down: decelerating")
            segments.standstill(rest, direction, self.burden, self.hold, "pause")
            sheet(formulas.sum_of_times, key="cycle_time", t_k=[up.time, running, down.time, rest])
            return segments.profile()

    @property
    def _direction(self) -> float:
        return -1.0 if self.speed < 0 else 1.0

    def _refuse(self, field: str, message: str) -> NoReturn:
        raise MotionError(message, field=(self.border_name(field),))

    def _run(self, segments: Segments, duration: float) -> None:
        force = self.burden.force("constant")
        segments.add(duration, self.speed, self.speed, self.burden, force, self._direction, "constant speed")

    def _ramps(self, sheet: Sheet) -> tuple[Ramp, Ramp] | None:
        """Run-up and run-down; None where no run-up is described."""
        if self.acceleration is not None and self.run_up_time is not None:
            self._refuse("run_up_time", "give either a run-up time or an acceleration")
        v, time, notes = abs(self.speed), self.run_up_time, Notes(sheet, "run_up_", self.motion_kind)
        if time is not None:
            rate = notes(formulas.ramp_acceleration, "acceleration", v=v, t_A=time)
        elif self.acceleration is not None:
            rate = self.acceleration
            time = notes(formulas.ramp_time, "time", v=v, a=rate)
        else:
            for field in ("deceleration", "starts_per_hour"):
                if getattr(self, field) is not None:
                    self._refuse("acceleration", "starts need an acceleration or a run-up time")
            return None
        notes = Notes(sheet, "run_down_", self.motion_kind)
        down = self.deceleration
        if down is None:
            down = rate
            sheet.assume("motion.deceleration", "Deceleration / acceleration where no deceleration is given",
                         value=1.0, symbol="r_a", source="usual: braking as hard as accelerating")  # fmt: skip
        return Ramp(time, rate), Ramp(notes(formulas.ramp_time, "time", "t_D", v=v, a=down), down)

    def _running_and_rest(self, ramps: float, sheet: Sheet) -> tuple[float, float]:
        """Time at constant speed and time at standstill of one start."""
        starts = self.starts_per_hour
        if starts is None:
            if self.duration is not None:
                return self.duration, 0.0
            starts = NOMINAL_STARTS
            sheet.assume("motion.starts_per_hour", "Starts per hour: so rare that they count for the peak only",
                         value=starts, symbol="Z", source="nominal, for a motion that runs on")  # fmt: skip
        cycle = HOUR / starts
        running = cycle - ramps if self.duration is None else self.duration
        rest = cycle - ramps - running
        if running <= 0 or rest < -1e-9 * cycle:
            needed = ramps + (self.duration or 0.0)
            self._refuse("starts_per_hour", f"a start every {cycle:.6g} s is too often: running up, running and "
                         f"running down take {needed:.6g} s")  # fmt: skip
        return running, max(rest, 0.0) if rest > 1e-9 * cycle else 0.0


class ConstantMotion(SteadyRunning):
    """A straight motion at constant speed."""

    kind: Literal["constant"] = "constant"
    title: ClassVar[str] = "Constant speed"
    summary: ClassVar[str] = (
        "Running on at one speed, as a conveyor does; with run-up and starts per hour where they matter."
    )
    motion_kind: ClassVar[Literal["linear", "rotary"]] = "linear"

    speed: Annotated[
        float, Quantity("m/s", symbol="v", ge=-1e3, le=1e3, about="Speed; negative: backward (down)", group="Running")
    ]
    acceleration: Annotated[
        float | None,
        Quantity("m/s2", symbol="a", ge=1e-6, le=1e5, about="Run-up acceleration", group="Starting", **_OPTIONAL),
    ]
    deceleration: Annotated[
        float | None,
        Quantity("m/s2", symbol="a_d", ge=1e-6, le=1e5, about="Run-down deceleration; empty: equal to the acceleration",
                 group="Starting", **_OPTIONAL),
    ]  # fmt: skip
    payload: Annotated[
        float | None,
        Quantity("kg", symbol="m_p", ge=0, le=1e7, about="Mass carried beside the mechanism's own", group="Load",
                 **_OPTIONAL),
    ]  # fmt: skip
    process_force: Annotated[
        float | None,
        Quantity("N", symbol="F_p", ge=-1e8, le=1e8, about="Force of the process against the motion; negative: it "
                 "helps", group="Load", **_OPTIONAL),
    ]  # fmt: skip

    @property
    def burden(self) -> Burden:
        """Mass carried and force of the process."""
        return Burden(self.payload or 0.0, self.process_force or 0.0)


class ConstantRotation(SteadyRunning):
    """A rotation at constant speed."""

    kind: Literal["constant_rotation"] = "constant_rotation"
    title: ClassVar[str] = "Constant rotation"
    summary: ClassVar[str] = "Turning on at one speed; with run-up and starts per hour where they matter."
    motion_kind: ClassVar[Literal["linear", "rotary"]] = "rotary"

    speed: Annotated[
        float, Quantity("rpm", symbol="n", ge=-3e4, le=3e4, about="Speed; negative: backward", group="Running")
    ]
    acceleration: Annotated[
        float | None,
        Quantity(
            "rad/s2", symbol="alpha_s", ge=1e-6, le=1e7, about="Run-up acceleration", group="Starting", **_OPTIONAL
        ),
    ]
    deceleration: Annotated[
        float | None,
        Quantity("rad/s2", symbol="alpha_d", ge=1e-6, le=1e7, about="Run-down deceleration; empty: equal to the "
                 "acceleration", group="Starting", **_OPTIONAL),
    ]  # fmt: skip
    payload_inertia: Annotated[
        float | None,
        Quantity("kg m2", symbol="J_p", ge=0, le=1e8, about="Inertia carried beside the mechanism's own", group="Load",
                 **_OPTIONAL),
    ]  # fmt: skip
    process_torque: Annotated[
        float | None,
        Quantity("N m", symbol="M_p", ge=-1e8, le=1e8, about="Torque of the process against the motion; negative: it "
                 "helps", group="Load", **_OPTIONAL),
    ]  # fmt: skip

    @property
    def burden(self) -> Burden:
        """Inertia carried and torque of the process."""
        return Burden(self.payload_inertia or 0.0, self.process_torque or 0.0)
