"""Runs at one speed whose ramps are the drive's own: what a line-fed motor is asked for.

A contactor starts the motor and a brake stops it, so the motion says only how fast, with what load, which way, how long
and how often. The profile holds each run at full speed; the ramps follow from the motor.
"""

from abc import abstractmethod
from collections.abc import Sequence
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field, model_validator
from pydantic_core import PydanticCustomError

from app.engine.errors import MotionError
from app.engine.formulas import motion as formulas
from app.engine.formulas.duty import duty_share
from app.engine.motion.base import MotionModel
from app.engine.motion.move import HOLD_LABELS
from app.engine.motion.profile import MotionProfile
from app.engine.motion.segments import Burden, Hold, Segments
from app.engine.quantity import Declared, Option, Quantity
from app.engine.sheet import Sheet

HOUR = 3600.0
"""[s]"""
MAX_RUNS = 50
_NONE: dict[str, Any] = {"default": None}


class Run(Declared):
    """What one run carries and how long it takes. Subclasses declare the load and the way."""

    label: Annotated[Annotated[str, Field(max_length=80)], Option(default="", about="name of the run, e.g. laden")]
    direction: Annotated[
        Literal["forward", "backward"],
        Option(default="forward", source="first run", about="direction; forward is up",
               labels={"forward": "forward (up)", "backward": "backward (down)"}),
    ]  # fmt: skip
    duration: Annotated[
        float | None, Quantity("s", symbol="t_r", gt=0, le=1e6, about="time of the run, instead of a way", **_NONE)
    ]

    process_during: Annotated[
        Literal["motion", "constant_speed"],
        Option(default="motion", source="usual for friction", about="when the process acts",
               labels={"motion": "while the axis moves", "constant_speed": "at full speed only, not while starting"}),
    ]  # fmt: skip

    @property
    @abstractmethod
    def burden(self) -> Burden:
        """What is moved and worked against."""

    @property
    @abstractmethod
    def way(self) -> float | None:
        """Unsigned distance or angle."""

    @property
    def sign(self) -> float:
        """+1 or -1"""
        return 1.0 if self.direction == "forward" else -1.0

    @model_validator(mode="after")
    def _time_or_way(self) -> "Run":
        if (self.duration is None) == (self.way is None):
            raise PydanticCustomError("run", "give either the way of this run or its time")
        return self


class LinearRun(Run):
    """One straight run."""

    distance: Annotated[float | None, Quantity("m", symbol="s", gt=0, le=1e5, about="way of the run", **_NONE)]
    payload: Annotated[
        float, Quantity("kg", symbol="m_p", ge=0, le=1e7, default=0.0, source="empty", about="mass carried")
    ]
    process_force: Annotated[
        float,
        Quantity("N", symbol="F_p", ge=-1e8, le=1e8, default=0.0, source="none given",
                 about="force of the process against the motion; negative: it helps"),
    ]  # fmt: skip

    @property
    def burden(self) -> Burden:
        """Mass carried and force of the process."""
        return Burden(self.payload, self.process_force)

    @property
    def way(self) -> float | None:
        """Distance [m]."""
        return self.distance


class RotaryRun(Run):
    """One rotation."""

    angle: Annotated[float | None, Quantity("deg", symbol="phi", gt=0, le=1e8, about="angle of the run", **_NONE)]
    payload_inertia: Annotated[
        float,
        Quantity("kg m2", symbol="J_p", ge=0, le=1e8, default=0.0, source="empty", about="inertia carried"),
    ]  # fmt: skip
    process_torque: Annotated[
        float,
        Quantity("N m", symbol="M_p", ge=-1e8, le=1e8, default=0.0, source="none given",
                 about="torque of the process against the motion; negative: it helps"),
    ]  # fmt: skip

    @property
    def burden(self) -> Burden:
        """Inertia carried and torque of the process."""
        return Burden(self.payload_inertia, self.process_torque)

    @property
    def way(self) -> float | None:
        """Angle [rad]."""
        return self.angle


class _Runs(MotionModel):
    """What straight and rotary runs share."""

    speed: float
    cycles_per_hour: Annotated[
        float | None,
        Quantity("1", symbol="Z_c", gt=0, le=36000, group="Cycle",
                 about="How often all runs together are repeated per hour", **_NONE),
    ]  # fmt: skip
    pause: Annotated[
        float | None,
        Quantity("s", symbol="t_0", ge=0, le=1e6, about="Pause after each run, instead of cycles per hour",
                 group="Cycle", **_NONE),
    ]  # fmt: skip
    hold: Annotated[
        Hold,
        Option(default="brake", source="usual for line-fed brake motors", about="What holds between the runs",
               labels=HOLD_LABELS, group="Cycle"),
    ]  # fmt: skip

    motion_kind: ClassVar[Literal["linear", "rotary"]]

    @property
    @abstractmethod
    def sequence(self) -> Sequence[Run]:
        """The runs in order."""

    def solve(self, sheet: Sheet) -> MotionProfile:
        """Put the runs one after another at full speed, pauses between them; see :class:`MotionModel`."""
        if self.cycles_per_hour is not None and self.pause is not None:
            raise MotionError("give either cycles per hour or a pause", field=("pause_s",))
        segments, times = Segments(self.motion_kind), [self._time(run) for run in self.sequence]
        with sheet.section("Motion"):
            running = sheet(formulas.sum_of_times, key="running_time", symbol="t_on", label="Time in motion per cycle",
                            t_k=times)  # fmt: skip
            pause = self._pause(running)
            for number, (run, time) in enumerate(zip(self.sequence, times, strict=True), start=1):
                name = run.label or f"run {number}"
                speed, burden = run.sign * self.speed, run.burden
                segments.add(time, speed, speed, burden, burden.force("constant"), run.sign, name)
                segments.standstill(pause, run.sign, burden, self.hold, f"{name}: pause")
            total = sheet(formulas.sum_of_times, key="cycle_time", t_k=[running, *([pause] * len(times))])
            sheet(duty_share, t_on=running, t_cyc=total)
            sheet.decide("The ramps are those of the drive", "each run is described at full speed")
        only = [run.process_during == "constant_speed" for run in self.sequence for _ in range(2 if pause > 0 else 1)]
        return segments.profile(own_ramps=True, at_speed_only=only)

    def _time(self, run: Run) -> float:
        if run.duration is not None:
            return run.duration
        assert run.way is not None
        return float(formulas.constant_speed_time(s=run.way, v=self.speed, t_A=0.0, t_D=0.0))

    def _pause(self, running: float) -> float:
        """Pause after each run [s]."""
        if self.cycles_per_hour is None:
            return self.pause or 0.0
        cycle = HOUR / self.cycles_per_hour
        left = cycle - running
        if left < -1e-9 * running:
            raise MotionError(
                f"the runs take {running:.6g} s, longer than the cycle of {cycle:.6g} s",
                field=("cycles_per_hour",),
            )
        return max(left, 0.0) / len(self.sequence)


class Trips(_Runs):
    """Straight runs at one speed."""

    kind: Literal["trips"] = "trips"
    title: ClassVar[str] = "Runs, ramps by the motor"
    summary: ClassVar[str] = "For line-fed motors: runs at one speed; run-up and braking follow from the motor."
    motion_kind: ClassVar[Literal["linear", "rotary"]] = "linear"

    speed: Annotated[float, Quantity("m/s", symbol="v", gt=0, le=1e3, about="Speed of the runs", group="Runs")]
    runs: Annotated[list[LinearRun], Field(min_length=1, max_length=MAX_RUNS), Option(about="Runs in time order")]

    @property
    def sequence(self) -> Sequence[Run]:
        """The runs in order."""
        return self.runs


class Rotations(_Runs):
    """Rotations at one speed."""

    kind: Literal["rotations"] = "rotations"
    title: ClassVar[str] = "Rotations, ramps by the motor"
    summary: ClassVar[str] = "For line-fed motors: rotations at one speed; run-up and braking follow from the motor."
    motion_kind: ClassVar[Literal["linear", "rotary"]] = "rotary"

    speed: Annotated[float, Quantity("rpm", symbol="n", gt=0, le=3e4, about="Speed of the rotations", group="Runs")]
    runs: Annotated[list[RotaryRun], Field(min_length=1, max_length=MAX_RUNS), Option(about="Rotations in time order")]

    @property
    def sequence(self) -> Sequence[Run]:
        """The rotations in order."""
        return self.runs
