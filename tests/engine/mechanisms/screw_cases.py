"""Ball screw axes and motions that several tests calculate."""

import math
from typing import Any

import numpy as np

from app.engine.environment import Environment
from app.engine.mechanisms.ball_screw import BallScrew
from app.engine.mechanisms.load import Load
from app.engine.motion.profile import MotionProfile
from app.engine.sheet import Sheet

RPM = 2 * math.pi / 60

PLAIN: dict[str, Any] = {
    "slide_mass_kg": 400,
    "nominal_diameter_mm": 50,
    "lead_mm": 20,
    "length_mm": 1000,
    "efficiency": 1,
    "friction_model": "none",
}
LACHMAN: dict[str, Any] = {
    **PLAIN,
    "inclination_deg": 60,
    "friction_model": "per_mass",
    "specific_friction_n_kg": 1,
    "screw_friction": "diameter_rule",
    "mounting": "supported_supported",
    "bearing_stiffness_n_um": 1000,
    "loaded_turns": 3.5,
    "stressed_length_mm": 540,
    "dn_limit_mmrpm": 120000,
}


def run(move: tuple[float, float, float], *more: tuple[float, float, float], a: float = 5.0, m: float = 0.0) -> Any:
    """Moves (signed distance [m], speed [m/s], process force [N]) one after the other, each from rest to rest."""
    rows = []
    for number, (distance, speed, force) in enumerate((move, *more), start=1):
        way, t = math.copysign(1, distance), speed / a
        level = (abs(distance) - speed * t) / speed
        rows += [(t, 0, way * speed, force, way, f"move {number}: accelerating")]
        rows += [(level, way * speed, way * speed, force, way, f"move {number}: constant speed")]
        rows += [(t, way * speed, 0, force, way, f"move {number}: decelerating")]
    return profile(rows, m)


def profile(rows: list[tuple[Any, ...]], payload: float = 0.0) -> MotionProfile:
    duration, start, end, force, way, label = zip(*rows, strict=True)
    numbers = [np.array(column, dtype=float) for column in (duration, start, end)]
    return MotionProfile(
        "linear", *numbers, payload=np.full(len(rows), payload), process_force=np.array(force, dtype=float),
        direction=np.array(way, dtype=float), braked=np.zeros(len(rows), dtype=bool), label=label,
    )  # fmt: skip


def load(axis: dict[str, Any], motion: MotionProfile, **environment: Any) -> tuple[Load, Sheet]:
    sheet = Sheet()
    return BallScrew.model_validate(axis).load(motion, Environment.model_validate(environment), sheet), sheet


ROUND_TRIP = run((0.18, 0.5, 0), (-0.18, 0.5, 0), (0.18, 0.2, 1e4), (-0.18, 0.2, 1e4))
