"""What must hold for every mechanism with a constant transmission, whatever it is made of."""

from collections.abc import Iterable
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from hypothesis import settings

from app.engine.environment import Environment
from app.engine.mechanisms.base import Mechanism
from app.engine.mechanisms.guided_axis import split
from app.engine.mechanisms.load import Load
from app.engine.motion.profile import MotionProfile
from app.engine.quantity import Declared
from app.engine.sheet import Sheet
from app.engine.tables import Table

DRAWINGS = Path(__file__).resolve().parents[3] / "static/drawings"
FEW = settings(max_examples=25, deadline=None)


class AnyTable(dict[str, Table]):
    """A table for every key: 2 throughout. The laws hold whatever a chart says."""

    def get(self, key: str, default: object = None) -> Table:  # type: ignore[override]
        return Table(key, key, "test", ((0.0, ((-1e12, 2.0), (1e12, 2.0))),))


def loaded(mechanism: Mechanism, motion: MotionProfile, **environment: Any) -> Load:
    return mechanism.load(motion, Environment.si(**environment), Sheet(tables=AnyTable()))


def written(mechanism: Mechanism, motion: MotionProfile, **environment: Any) -> Sheet:
    sheet = Sheet(tables=AnyTable())
    mechanism.load(motion, Environment.si(**environment), sheet)
    return sheet


def work(found: Load) -> float:
    """Work of the drive over the cycle [J]."""
    cycle = found.cycle
    return float((cycle.torque * cycle.mean_speed * cycle.duration).sum())


def turnover(found: Load) -> float:
    """Work of the cycle without regard to its sign [J]: the scale of rounding errors."""
    cycle = found.cycle
    return float(np.abs(cycle.torque * cycle.mean_speed * cycle.duration).sum())


def splitting_changes_nothing(mechanism: Mechanism, motion: MotionProfile, pieces: int) -> None:
    parts = np.ones(len(motion.duration), dtype=int)
    parts[::2] = pieces
    whole, pieced = loaded(mechanism, motion), loaded(mechanism, split(motion, parts))
    np.testing.assert_allclose(pieced.cycle.torque, np.repeat(whole.cycle.torque, parts), rtol=1e-9, atol=1e-9)
    assert vars(pieced.statics) == pytest.approx(vars(whole.statics), rel=1e-9, abs=1e-9)


def mirrored_motion_mirrors_the_torques(mechanism: Mechanism, motion: MotionProfile, model: str) -> None:
    there, back = (loaded(mechanism, run, regeneration=model).cycle for run in (motion, motion.mirrored()))
    np.testing.assert_allclose(back.torque, -there.torque, rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(back.speed_start, -there.speed_start)


def losses_never_help(mechanism: Mechanism, lossier: Mechanism, motion: MotionProfile, model: str) -> None:
    """Segment by segment a drive with lower efficiency gives more and gets back less."""
    better, worse = (loaded(one, motion, regeneration=model).cycle for one in (mechanism, lossier))
    assert (worse.torque * worse.mean_speed >= better.torque * better.mean_speed - 1e-9 * turnover_scale(better)).all()


def turnover_scale(cycle: Any) -> float:
    return float(np.abs(cycle.torque * cycle.mean_speed).max()) or 1.0


def arrays_equal_a_loop(mechanism: Mechanism, motion: MotionProfile) -> None:
    whole = loaded(mechanism, motion).cycle.torque
    for k in range(len(motion.duration)):
        one = MotionProfile(
            motion.kind, *(getattr(motion, name)[k : k + 1] for name in NAMES), label=motion.label[k : k + 1]
        )
        assert loaded(mechanism, one).cycle.torque[0] == pytest.approx(whole[k], rel=1e-12, abs=1e-12)


NAMES = ("duration", "speed_start", "speed_end", "payload", "process_force", "direction", "braked")


def drawing_shows_fields(models: Iterable[type[Declared]], drawing: str, at_least: set[str]) -> None:
    root = ElementTree.parse(DRAWINGS / drawing).getroot()
    texts = root.iter("{http://www.w3.org/2000/svg}text")
    drawn = {symbol for item in texts if (symbol := item.get("data-symbol"))}
    assert at_least <= drawn <= {found.symbol for model in models for _, _, found in model.declarations()}
    assert root.find("{http://www.w3.org/2000/svg}title") is not None
