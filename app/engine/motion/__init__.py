"""How a cycle is described and solved."""

from collections.abc import Mapping
from typing import Annotated, Literal, TypeAlias

from pydantic import Field

from app.engine.motion.base import MotionModel
from app.engine.motion.constant import ConstantMotion, ConstantRotation
from app.engine.motion.csv_profile import CsvProfile
from app.engine.motion.flying_saw import FlyingSaw
from app.engine.motion.move import LinearMove, RotaryMove
from app.engine.motion.moves import Moves, Turns
from app.engine.motion.profile import MotionProfile
from app.engine.motion.trips import Rotations, Trips

Motion: TypeAlias = Annotated[
    Moves | Turns | ConstantMotion | ConstantRotation | Trips | Rotations | FlyingSaw | CsvProfile,
    Field(discriminator="kind"),
]
"""Any description of a cycle, told apart by ``kind``."""

_MODELS: tuple[type[MotionModel], ...] = (
    Moves, Turns, ConstantMotion, ConstantRotation, Trips, Rotations, FlyingSaw, CsvProfile,
)  # fmt: skip


def motions(kind: Literal["linear", "rotary"] | None = None) -> Mapping[str, type[MotionModel]]:
    """Every way to describe a cycle by its kind; with ``kind`` those that can drive such a mechanism.

    >>> list(motions("rotary"))
    ['turns', 'constant_rotation', 'rotations', 'csv']
    """
    return {
        model.model_fields["kind"].default: model
        for model in _MODELS
        if kind is None or model.motion_kind in (kind, "either")
    }


__all__ = [
    "ConstantMotion",
    "ConstantRotation",
    "CsvProfile",
    "FlyingSaw",
    "LinearMove",
    "Motion",
    "MotionModel",
    "MotionProfile",
    "Moves",
    "RotaryMove",
    "Rotations",
    "Trips",
    "Turns",
    "motions",
]
