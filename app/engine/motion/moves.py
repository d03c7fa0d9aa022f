"""A cycle as a sequence of moves between standstills."""

from abc import abstractmethod
from collections.abc import Iterator, Sequence
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field

from app.engine.errors import MotionError
from app.engine.formulas import motion as formulas
from app.engine.motion.base import MotionModel
from app.engine.motion.move import HOLD_LABELS, LinearMove, Move, RotaryMove
from app.engine.motion.profile import MotionProfile
from app.engine.motion.segments import Burden, Hold, Segments
from app.engine.motion.shape import MoveShape
from app.engine.quantity import Declaration, Option, Quantity
from app.engine.sheet import Sheet

MAX_MOVES = 200
MOVES_ON_SHEET = 6
"""Up to so many moves are written to the sheet one by one, of more only the extreme ones."""


class MoveSequence(MotionModel):
    """What sequences of linear moves and of turns share."""

    cycle_time: Annotated[
        float | None,
        Quantity("s", symbol="t_cyc", gt=0, le=1e8, default=None, group="Cycle",
                 about="Time of the whole cycle; what the moves leave of it is a pause at the end"),
    ]  # fmt: skip
    pause: Annotated[
        float | None,
        Quantity("s", symbol="t_0", ge=0, le=1e8, default=None, about="Pause after the last move", group="Cycle"),
    ]
    pause_hold: Annotated[
        Hold,
        Option(default="motor", source="usual for short pauses", about="What holds during the pause",
               labels=HOLD_LABELS, group="Cycle"),
    ]  # fmt: skip

    motion_kind: ClassVar[Literal["linear", "rotary"]]

    @property
    @abstractmethod
    def sequence(self) -> Sequence[Move]:
        """The moves in order."""

    def defaults_taken(self) -> Iterator[tuple[str, Declaration, Any]]:
        """As usual, but who holds is no question without a pause."""
        asked = self.pause or self.cycle_time
        return (item for item in super().defaults_taken() if item[0] != "pause_hold" or asked)

    def solve(self, sheet: Sheet) -> MotionProfile:
        """Solve every move and put them one after another; see :class:`MotionModel`."""
        if self.pause is not None and self.cycle_time is not None:
            raise MotionError("give either a pause or the time of the whole cycle", field=("pause_s",))
        with sheet.section("Motion"):
            shapes = self._shapes(sheet)
            segments = Segments(self.motion_kind)
            for index, (move, shape) in enumerate(zip(self.sequence, shapes, strict=True)):
                name = move.label or f"move {index + 1}"
                segments.move(shape, move.direction, move.burden, name)
                segments.standstill(move.dwell or 0.0, move.direction, move.burden, move.hold, f"{name}: dwell")
            self._end(segments, shapes, sheet)
            return segments.profile()

    def _shapes(self, sheet: Sheet) -> list[MoveShape]:
        scratch = [self._solve(index, Sheet()) for index in range(len(self.sequence))]
        chosen = self._on_sheet(scratch)
        if len(chosen) < len(scratch):
            sheet.decide(
                f"{len(chosen)} of {len(scratch)} moves are written out",
                "those with the highest acceleration, the highest speed and the longest distance",
            )
        for index in chosen:
            with sheet.section(f"Motion: {self.sequence[index].label or f'move {index + 1}'}"):
                self._solve(index, sheet)
        if any(move.deceleration is None and move.deceleration_ratio is None for move in self.sequence):
            sheet.assume(
                "motion.deceleration", "Deceleration / acceleration where no deceleration is given",
                value=1.0, symbol="r_a", source="usual: braking as hard as accelerating",
            )  # fmt: skip
        return scratch

    def _solve(self, index: int, sheet: Sheet) -> MoveShape:
        try:
            return self.sequence[index].solve(sheet, f"move_{index + 1}_")
        except MotionError as error:
            raise error.at("moves", index) from error

    def _on_sheet(self, shapes: Sequence[MoveShape]) -> list[int]:
        """Indices of the moves that the sheet shows."""
        every = range(len(shapes))
        if len(shapes) <= MOVES_ON_SHEET:
            return list(every)
        extremes = {
            max(every, key=lambda k: max(shapes[k].up.acceleration, shapes[k].down.acceleration)),
            max(every, key=lambda k: shapes[k].speed),
            max(every, key=lambda k: shapes[k].distance),
        }
        return sorted(extremes)

    def _end(self, segments: Segments, shapes: Sequence[MoveShape], sheet: Sheet) -> None:
        """Add the pause at the end, record the cycle time, and say where the cycle ends."""
        last = self.sequence[-1]
        busy = segments.duration
        pause = self.pause or 0.0
        if self.cycle_time is not None:
            pause = self.cycle_time - busy
            if pause < -1e-9 * busy:
                raise MotionError(
                    f"the moves and their dwells take {busy:.6g} s, longer than the cycle of {self.cycle_time:.6g} s",
                    field=("cycle_time_s",),
                )
        weight = Burden(payload=last.burden.payload)
        if pause > 1e-9 * busy:
            segments.standstill(pause, last.direction, weight, self.pause_hold, "pause")
        parts = [shape.time + (move.dwell or 0.0) for move, shape in zip(self.sequence, shapes, strict=True)]
        sheet(formulas.sum_of_times, key="cycle_time", t_k=[*parts, max(pause, 0.0)])
        end = segments.travel
        if self.motion_kind == "linear" and abs(end) > 1e-6 * max(shape.distance for shape in shapes):
            sheet.decide(
                f"The cycle ends {end:.6g} m from its start",
                "the moves do not add up to zero: the way back is not part of this calculation",
            )


class Moves(MoveSequence):
    """A sequence of straight moves."""

    kind: Literal["moves"] = "moves"
    moves: Annotated[list[LinearMove], Field(min_length=1, max_length=MAX_MOVES), Option(about="Moves in time order")]

    title: ClassVar[str] = "Moves"
    summary: ClassVar[str] = "Positioning: a sequence of straight moves with dwells between them."
    motion_kind: ClassVar[Literal["linear", "rotary"]] = "linear"

    @property
    def sequence(self) -> Sequence[Move]:
        """The moves in order."""
        return self.moves


class Turns(MoveSequence):
    """A sequence of turns."""

    kind: Literal["turns"] = "turns"
    moves: Annotated[list[RotaryMove], Field(min_length=1, max_length=MAX_MOVES), Option(about="Turns in time order")]

    title: ClassVar[str] = "Turns"
    summary: ClassVar[str] = "Indexing: a sequence of turns with dwells between them."
    motion_kind: ClassVar[Literal["linear", "rotary"]] = "rotary"

    @property
    def sequence(self) -> Sequence[Move]:
        """The turns in order."""
        return self.moves
