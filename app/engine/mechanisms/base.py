"""What a mechanism is: a declared model that turns a motion into a load cycle and writes every step to the sheet.

A new mechanism is one new file in this package. It derives from :class:`Mechanism`, sets ``kind`` (a Literal with
default), the class variables below, and implements :meth:`Mechanism.load_at_shaft`. A stage and further turning bodies
between its shaft and the drive come with the base.
"""

from abc import abstractmethod
from collections.abc import Iterator
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field

from app.engine.environment import Environment
from app.engine.formulas.inertia import sum_of_inertias
from app.engine.mechanisms.bodies import AnyBody
from app.engine.mechanisms.load import Load
from app.engine.mechanisms.stage import STAGE, Stage, assume_usual_efficiency
from app.engine.motion.profile import MotionProfile
from app.engine.quantity import Declaration, Declared, Option, Quantity
from app.engine.sheet import Sheet

FURTHER = "Further turning bodies"


class Mechanism(Declared):
    """Base of all mechanisms. The drive's output shaft is the mechanism's own, or the input of the stage before it."""

    kind: str
    title: ClassVar[str]
    """Name for the reader, e.g. ``"Ball or lead screw axis"``."""
    summary: ClassVar[str]
    """One sentence: what it is for."""
    drawing: ClassVar[str]
    """File in ``static/drawings/``: an SVG that carries the symbols of the fields."""
    motion_kind: ClassVar[Literal["linear", "rotary"]]
    follows_course: ClassVar[bool] = False
    """Whether the torque of a segment depends on angle or course of the speed: then segments are cut finely."""
    one_way: ClassVar[bool] = False
    """Whether only the motion as described is meant: running it backward from the same start is another task."""
    shown_last: ClassVar[frozenset[str]] = frozenset(
        {"stage_ratio", "stage_efficiency", "stage_inertia", "further_bodies"}
    )

    stage_ratio: Annotated[
        float,
        Quantity(
            "1", symbol="i_2", gt=0, le=1e4, default=1.0, group=STAGE, source="no stage",
            about="ratio of a stage before the mechanism: chain, belt or open gear wheels",
        ),
    ]  # fmt: skip
    stage_efficiency: Annotated[
        float | None,
        Quantity("1", symbol="eta_2", gt=0, le=1, default=None, group=STAGE, about="efficiency of that stage"),
    ]
    stage_inertia: Annotated[
        float,
        Quantity(
            "kg cm2", symbol="J_1", ge=0, le=1e4, default=0.0, group=STAGE, source="left out until given",
            about="inertia of what sits on the input shaft of that stage",
        ),
    ]  # fmt: skip
    further_bodies: Annotated[
        tuple[AnyBody, ...],
        Field(max_length=20),
        Option(
            default=(), group=FURTHER,
            about="further bodies that turn with the drive's output shaft: couplings, brake discs, gear wheels",
        ),
    ]  # fmt: skip

    def defaults_taken(self) -> Iterator[tuple[str, Declaration, Any]]:
        """As for every input model; what sits on the shaft of a stage is no question where there is none."""
        idle = {"stage_inertia"} if self.stage_ratio == 1 else set()
        yield from (found for found in super().defaults_taken() if found[0] not in idle)

    def load(self, motion: MotionProfile, environment: Environment, sheet: Sheet) -> Load:
        """Compute the load cycle at the drive's output shaft, with every step on ``sheet``."""
        found = self.load_at_shaft(motion, environment, sheet)
        stage = self._stage(sheet)
        if stage is None:
            return found
        stage.record(sheet, found.cycle, environment.regeneration)
        return stage.load(found, environment.regeneration)

    @property
    def has_stage(self) -> bool:
        """Whether anything stands between the mechanism's own shaft and the drive's output shaft."""
        return bool(
            self.stage_ratio != 1 or self.stage_efficiency is not None or self.stage_inertia or self.further_bodies
        )

    def _stage(self, sheet: Sheet) -> Stage | None:
        """What stands between the mechanism's own shaft and the drive's output shaft; None: nothing."""
        if not self.has_stage:
            return None
        efficiency = self.stage_efficiency
        if efficiency is None:
            efficiency = 1.0 if self.stage_ratio == 1 else assume_usual_efficiency(sheet)
        return Stage(self.stage_ratio, efficiency, self._record_further(sheet))

    def _record_further(self, sheet: Sheet) -> float:
        """Inertia of everything on the drive's output shaft that is no part of the mechanism [kg m2]."""
        if not self.further_bodies:
            return self.stage_inertia
        with sheet.section(FURTHER):
            parts = [
                body.record_inertia(sheet, f"further_body_{number}_inertia", f"Inertia of further body {number}")
                for number, body in enumerate(self.further_bodies, start=1)
            ]
            label = "Inertia of what else turns with the drive's output shaft"
            parts = [part for part in (*parts, self.stage_inertia) if part]
            return sheet(sum_of_inertias, key="further_inertia", symbol="J_1", label=label, J_k=parts)

    @abstractmethod
    def load_at_shaft(self, motion: MotionProfile, environment: Environment, sheet: Sheet) -> Load:
        """Compute the load cycle at the mechanism's own shaft, with every step on ``sheet``."""
