"""One move between standstills: a straight move of a slide or a turn of a table."""

from abc import abstractmethod
from collections.abc import Iterator
from dataclasses import replace
from typing import Annotated, Any, ClassVar, Literal

from pydantic import StringConstraints

from app.engine.formulas import motion as formulas
from app.engine.motion.segments import Burden, Hold
from app.engine.motion.shape import MoveShape, Ramp, Smoothing
from app.engine.motion.solve import OPTIMISE_LABELS, Given, Notes, Optimise, solve_move
from app.engine.quantity import Declaration, Declared, Option, Quantity
from app.engine.sheet import Sheet

HOLD_LABELS: dict[Any, str] = {"motor": "motor holds", "brake": "brake holds"}
_OPTIONAL: dict[str, Any] = {"default": None}


class Move(Declared):
    """What linear moves and turns share. Fields without a declaration here get theirs, with its unit, below."""

    label: Annotated[
        str,
        StringConstraints(strip_whitespace=True, max_length=60),
        Option(default="", about="Name of the move", group="Move"),
    ]
    distance: float | None = None
    time: Annotated[
        float | None,
        Quantity("s", symbol="t_p", ge=1e-4, le=1e6, about="Time, settling included", group="Move", **_OPTIONAL),
    ]
    speed: float | None = None
    acceleration: float | None = None
    deceleration: float | None = None
    deceleration_ratio: Annotated[
        float | None,
        Quantity("1", symbol="r_a", ge=0.01, le=100, about="Deceleration / acceleration, where no deceleration is "
                 "given", group="Move", **_OPTIONAL),
    ]  # fmt: skip
    backward: Annotated[
        bool | None,
        Option(about="Moves in negative direction (as a negative distance does)", group="Move", **_OPTIONAL),
    ]
    optimise: Annotated[
        Optimise | None, Option(about="What shall be least", labels=OPTIMISE_LABELS, group="Move", **_OPTIONAL)
    ]
    profile: Annotated[
        Literal["trapezoid", "s_curve"],
        Option(
            default="trapezoid",
            source="usual profile of positioning drives",
            about="Course of the speed",
            labels={"trapezoid": "trapezoid: constant acceleration", "s_curve": "S-curve: limited jerk"},
            group="Move",
        ),
    ]
    jerk: float | None = None
    jerk_share: Annotated[
        float | None,
        Quantity("%", symbol="lambda_j", gt=0, le=1, about="Share of accelerating and of braking in which the "
                 "acceleration changes, instead of a jerk", group="Move", **_OPTIONAL),
    ]  # fmt: skip
    settling_time: Annotated[
        float | None,
        Quantity("s", symbol="t_set", ge=0, le=1e5, about="Settling after the move, held by the motor", group="Move",
                 **_OPTIONAL),
    ]  # fmt: skip
    creep_share: Annotated[
        float | None,
        Quantity("1", symbol="r_P", gt=0, lt=1, about="Creep speed / peak speed, before a brake stops the axis",
                 group="Move", **_OPTIONAL),
    ]  # fmt: skip
    creep_time: Annotated[
        float | None,
        Quantity("s", symbol="t_P", gt=0, le=1e4, about="Time at creep speed", group="Move", **_OPTIONAL),
    ]
    process_during: Annotated[
        Literal["motion", "constant_speed", "motion_and_standstill"],
        Option(
            default="motion",
            source="usual for machining and friction",
            about="When the process acts",
            labels={
                "motion": "while the axis moves",
                "constant_speed": "at constant speed only",
                "motion_and_standstill": "while the axis moves and while it stands after the move",
            },
            group="Load",
        ),
    ]
    dwell: Annotated[
        float | None,
        Quantity("s", symbol="t_dw", ge=0, le=1e6, about="Dwell after the move", group="Dwell", **_OPTIONAL),
    ]
    hold: Annotated[
        Hold,
        Option(default="motor", source="usual for short dwells", about="What holds during the dwell",
               labels=HOLD_LABELS, group="Dwell"),
    ]  # fmt: skip

    motion_kind: ClassVar[Literal["linear", "rotary"]]

    def defaults_taken(self) -> Iterator[tuple[str, Declaration, Any]]:
        """As usual, but without the choices that this move does not come to."""
        idle = {"label", "" if self.dwell else "hold", "" if self.burden.process_force else "process_during"}
        return (item for item in super().defaults_taken() if item[0] not in idle)

    @property
    def direction(self) -> float:
        """+1 or -1."""
        return -1.0 if self.backward or (self.distance or 0.0) < 0 else 1.0

    @property
    @abstractmethod
    def burden(self) -> Burden:
        """What the move carries and works against."""

    def notes(self, sheet: Sheet, prefix: str) -> Notes:
        """Where this move writes its steps and refusals."""
        names = {name: self.border_name(name) for name in type(self).model_fields}
        return Notes(sheet, prefix, self.motion_kind, names)

    def solve(self, sheet: Sheet, prefix: str = "move_1_") -> MoveShape:
        """Shape of the move; MotionError at the field where it cannot be."""
        notes = self.notes(sheet, prefix)
        shape = solve_move(self._given(notes), notes)
        return self._with_creep(shape, notes) if self.creep_share is not None else shape

    def _with_creep(self, shape: MoveShape, notes: Notes) -> MoveShape:
        """The same move that slows down to creep speed only, from which a brake stops it; less time at full speed."""
        assert self.creep_share is not None
        if self.creep_time is None:
            notes.refuse("creep_time", "is needed beside a creep speed")
        if self.profile != "trapezoid":
            notes.refuse("creep_share", "is for trapezoids only")
        v, a, t_P = shape.speed, shape.down.acceleration, self.creep_time
        v_P = notes(formulas.creep_speed, "creep_speed", v=v, r_P=self.creep_share)
        t_U = notes(formulas.slowing_time, "slowing_time", v=v, v_P=v_P, a=a)
        s_A = notes(formulas.ramp_distance, "run_up_distance", v=v, t_A=shape.up.time)
        s_U = notes(formulas.slowing_distance, "slowing_distance", v=v, v_P=v_P, t_U=t_U)
        s_P = notes(formulas.distance_at_speed, "creep_distance", v=v_P, t=t_P)
        s_F = notes(formulas.distance_left, "constant_distance", s=shape.distance, s_k=[s_A, s_U, s_P])
        if s_F < 0:
            notes.refuse("creep_time", "accelerating, slowing down and creeping take more than the whole distance")
        t_F = notes(formulas.time_for_distance, "constant_speed_time_with_creep", s=s_F, v=v)
        notes(formulas.sum_of_times, "time_with_creep", t_k=[shape.up.time, t_F, t_U, t_P])
        return replace(shape, down=Ramp(t_U, a), constant_time=t_F, creep_speed=v_P, creep_time=t_P)

    def _given(self, notes: Notes) -> Given:
        settling = self.settling_time or 0.0
        if self.distance == 0:
            notes.refuse("distance", "a move of no distance is a dwell: give a distance, or a dwell to another move")
        if self.time is not None and self.time <= settling + (self.creep_time or 0.0):
            notes.refuse(
                "settling_time", f"settling of {settling:.6g} s leaves nothing of the {self.time:.6g} s for motion"
            )
        if self.creep_time is not None and self.creep_share is None:
            notes.refuse("creep_share", "is needed beside a creep time")
        if self.deceleration is not None and self.deceleration_ratio is not None:
            notes.refuse("deceleration_ratio", "give either a deceleration or its ratio to the acceleration")
        return Given(
            distance=None if self.distance is None else abs(self.distance),
            time=None if self.time is None else self.time - settling - (self.creep_time or 0.0),
            speed=self.speed, acceleration=self.acceleration, deceleration=self.deceleration,
            ratio=self.deceleration_ratio, smoothing=self._smoothing(notes), settling=settling, optimise=self.optimise,
        )  # fmt: skip

    def _smoothing(self, notes: Notes) -> Smoothing:
        if self.profile == "trapezoid":
            for name in ("jerk", "jerk_share"):
                if getattr(self, name) is not None:
                    notes.refuse(name, "a trapezoid has no jerk limit: choose the S-curve, or leave this out")
            return Smoothing()
        if (self.jerk is None) == (self.jerk_share is None):
            notes.refuse("jerk", "an S-curve needs either a jerk or a share of the acceleration time")
        return Smoothing(self.jerk, self.jerk_share)


class LinearMove(Move):
    """One straight move from standstill to standstill. Any sufficient subset of its values determines it."""

    motion_kind: ClassVar[Literal["linear", "rotary"]] = "linear"

    distance: Annotated[
        float | None,
        Quantity(
            "mm", symbol="s", ge=-1e5, le=1e5, about="Distance; negative: backward (down)", group="Move", **_OPTIONAL
        ),
    ]
    speed: Annotated[
        float | None, Quantity("m/s", symbol="v", ge=1e-6, le=1e3, about="Peak speed", group="Move", **_OPTIONAL)
    ]
    acceleration: Annotated[
        float | None,
        Quantity("m/s2", symbol="a", ge=1e-6, le=1e5, about="Acceleration", group="Move", **_OPTIONAL),
    ]
    deceleration: Annotated[
        float | None,
        Quantity("m/s2", symbol="a_d", ge=1e-6, le=1e5, about="Deceleration; empty: equal to the acceleration",
                 group="Move", **_OPTIONAL),
    ]  # fmt: skip
    jerk: Annotated[
        float | None,
        Quantity("m/s3", symbol="j", ge=1e-6, le=1e9, about="Jerk limit of the S-curve", group="Move", **_OPTIONAL),
    ]
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
        return Burden(self.payload or 0.0, self.process_force or 0.0, self.process_during)


class RotaryMove(Move):
    """One turn from standstill to standstill. Any sufficient subset of its values determines it."""

    motion_kind: ClassVar[Literal["linear", "rotary"]] = "rotary"

    distance: Annotated[
        float | None,
        Quantity("deg", symbol="phi", ge=-1e8, le=1e8, about="Angle; negative: backward (270 deg, 2 rev)", group="Move",
                 **_OPTIONAL),
    ]  # fmt: skip
    speed: Annotated[
        float | None, Quantity("rpm", symbol="n", ge=1e-6, le=3e4, about="Peak speed", group="Move", **_OPTIONAL)
    ]
    acceleration: Annotated[
        float | None,
        Quantity("rad/s2", symbol="alpha_s", ge=1e-6, le=1e7, about="Angular acceleration", group="Move", **_OPTIONAL),
    ]
    deceleration: Annotated[
        float | None,
        Quantity("rad/s2", symbol="alpha_d", ge=1e-6, le=1e7, about="Angular deceleration; empty: equal to the "
                 "acceleration", group="Move", **_OPTIONAL),
    ]  # fmt: skip
    jerk: Annotated[
        float | None,
        Quantity(
            "rad/s3", symbol="j_phi", ge=1e-6, le=1e11, about="Jerk limit of the S-curve", group="Move", **_OPTIONAL
        ),
    ]
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
        return Burden(self.payload_inertia or 0.0, self.process_torque or 0.0, self.process_during)
