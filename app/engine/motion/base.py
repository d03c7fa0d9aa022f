"""What a motion is: a declared model that is solved into a motion profile."""

from abc import abstractmethod
from typing import ClassVar, Literal

from app.engine.motion.profile import MotionProfile
from app.engine.quantity import Declared
from app.engine.sheet import Sheet


class MotionModel(Declared):
    """Base of all ways to describe a cycle."""

    kind: str
    title: ClassVar[str]
    """Name for the reader."""
    summary: ClassVar[str]
    """One sentence: when to use it."""
    motion_kind: ClassVar[Literal["linear", "rotary", "either"]]
    """Which mechanisms it can drive; ``either``: the data decide, see ``MotionProfile.kind``."""

    @abstractmethod
    def solve(self, sheet: Sheet) -> MotionProfile:
        """Solve into consecutive segments, with every step on ``sheet``.

        Raises MotionError at the field that makes the motion impossible, path relative to this model.
        """
