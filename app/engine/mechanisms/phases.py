"""Which moments of a cycle stand on the sheet: the one with the largest torque, and one for each phase.

A cycle may have thousands of segments; the sheet shows one representative of each phase, the segment with the largest
torque in it, and of many phases only the first :data:`SHOWN_PHASES`.
"""

from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray

from app.engine.motion.profile import MotionProfile, Phase
from app.engine.sheet import Sheet

SHOWN_PHASES = 12

Recorder = Callable[[int, str], object]
"""Writes the steps of one segment: (index of the segment, prefix of the step keys)."""


def largest(torque: NDArray[np.float64], start: int = 0, stop: int | None = None) -> int:
    """Index of the segment with the largest unsigned torque among ``start`` to ``stop`` (exclusive)."""
    return start + int(np.abs(torque[start:stop]).argmax())


def record_phases(sheet: Sheet, motion: MotionProfile, torque: NDArray[np.float64], record: Recorder) -> None:
    """Call ``record`` for the moment of the largest torque (keys without prefix), then once for each other phase.

    Keys of phase n begin with ``phase_n_``. Phases with closed brake and repetitions of an earlier phase are left
    out.
    """
    worst = largest(torque)
    with sheet.section(f"Largest torque: {motion.label[worst]}"):
        record(worst, "")
    left_out = 0
    shown = 0
    for number, phase, index in _distinct(motion, torque):
        if phase.start <= worst < phase.stop:
            continue
        if shown == SHOWN_PHASES:
            left_out += 1
            continue
        shown += 1
        with sheet.section(phase.label):
            record(index, f"phase_{number}_")
    if left_out:
        sheet.decide(
            f"{left_out} more phases are not written out",
            "the sheet shows the phase with the largest torque and the first others; all of them are computed",
        )


def _distinct(motion: MotionProfile, torque: NDArray[np.float64]) -> Iterator[tuple[int, Phase, int]]:
    """Yield (number from 1, phase, representative segment) of each phase that differs from all before it."""
    seen = set()
    for number, phase in enumerate(motion.phases, start=1):
        index = largest(torque, phase.start, phase.stop)
        if motion.braked[index]:
            continue
        values = (torque[index], motion.acceleration[index], np.sign(motion.mean_speed[index]), motion.payload[index])
        signature = tuple(float(f"{value:.9g}") for value in values)
        if signature not in seen:
            seen.add(signature)
            yield number, phase, index
