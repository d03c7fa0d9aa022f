"""States of load: which steady runs a motion consists of, for drives that make their own ramps."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import groupby

import numpy as np

from app.engine.motion.profile import BoolArray, MotionProfile

Words = tuple[str, str]
"""What motion in positive and in negative direction is called, e.g. ``("lifting", "lowering")``."""
TRAVELLING: Words = ("forward", "backward")


@dataclass(frozen=True)
class SteadyRun:
    """One distinct combination of load, process force and direction, with how often and how long it runs per cycle."""

    payload: float
    process_force: float
    """Resists the motion; negative helps."""
    direction: float
    speed: float
    """Highest unsigned speed [m/s or rad/s]"""
    starts: float
    duration: float
    """[s]"""
    at_speed_only: bool = False
    """Whether the process force does not act while starting and stopping."""
    key: str = ""
    label: str = ""


def steady_runs(
    motion: MotionProfile,
    *,
    both_directions: bool = False,
    also_unladen: bool = False,
    words: Words = TRAVELLING,
    unit: str = "kg",
) -> tuple[SteadyRun, ...]:
    """The distinct steady runs of a motion, those of the largest payload first.

    ``both_directions`` adds the opposite of each, ``also_unladen`` the run without payload: states that the axis can
    come into although the motion does not show them, with no starts. Every departure from standstill is a start, also
    between two runs without a pause and where the motion turns round; a motion that never stands has none.
    """
    found: dict[tuple[float, float, float], SteadyRun] = {}
    for run in _runs(motion):
        key = (run.payload, run.process_force, run.direction)
        known = found.get(key)
        found[key] = run if known is None else replace(
            known, speed=max(known.speed, run.speed), starts=known.starts + run.starts,
            duration=known.duration + run.duration,
        )  # fmt: skip
    runs = list(found.values())
    if also_unladen and runs and all(run.payload > 0 for run in runs):
        ways = {run.direction: run for run in runs}
        runs += [replace(run, payload=0.0, process_force=0.0, starts=0.0, duration=0.0) for run in ways.values()]
    if both_directions:
        known_ways = {(run.payload, run.direction) for run in runs}
        runs += [
            replace(run, direction=-run.direction, starts=0.0, duration=0.0)
            for run in runs
            if (run.payload, -run.direction) not in known_ways
        ]
    runs.sort(key=lambda run: (-run.payload, -run.direction))
    return tuple(_named(runs, words, unit))


def _runs(motion: MotionProfile) -> Iterator[SteadyRun]:
    """Every run of the cycle by itself: from one departure to the next, or to a standstill."""
    moving = motion.mean_speed != 0
    departs = np.ones(len(moving), dtype=bool) if motion.own_ramps else departures(motion)
    number = np.cumsum(departs & moving)

    def group(k: int) -> tuple[bool, float, int]:
        return bool(moving[k]), float(np.sign(motion.mean_speed[k])), int(number[k])

    for (moves, direction, _), members in groupby(range(len(motion.duration)), key=group):
        if not moves:
            continue
        chosen = list(members)
        steady = [k for k in chosen if motion.acceleration[k] == 0] or chosen
        worst = max(steady, key=lambda k: abs(motion.process_force[k]))
        ends = np.maximum(np.abs(motion.speed_start[chosen]), np.abs(motion.speed_end[chosen]))
        yield SteadyRun(
            payload=float(motion.payload[worst]),
            process_force=float(motion.process_force[worst]),
            direction=direction,
            speed=float(ends.max()),
            starts=float(departs[chosen[0]]),
            duration=float(motion.duration[chosen].sum()),
            at_speed_only=_only_at_speed(motion, chosen, worst),
        )


def departures(motion: MotionProfile) -> BoolArray:
    """Which segments leave a standstill, shape (n,): speed 0 at the border before them, or another direction.

    The cycle repeats: before its first segment comes its last one. A motion that only runs on has no departure.
    """
    tiny = 1e-9 * motion.max_speed
    before = np.roll(motion.speed_end, 1)
    direction = np.sign(motion.mean_speed)
    stood = (np.abs(motion.speed_start) <= tiny) | (np.abs(before) <= tiny)
    turned = np.roll(direction, 1) * direction < 0
    found: BoolArray = (stood | turned) & (direction != 0)
    return found


def _only_at_speed(motion: MotionProfile, chosen: Sequence[int], worst: int) -> bool:
    """Whether the process force of a run is missing while it starts."""
    if motion.at_speed_only is not None:
        return bool(motion.at_speed_only[worst])
    ramps = [k for k in chosen if motion.acceleration[k] != 0]
    return bool(ramps) and motion.process_force[worst] != 0 and all(motion.process_force[k] == 0 for k in ramps)


def _named(runs: Sequence[SteadyRun], words: Words, unit: str) -> Iterator[SteadyRun]:
    """Give each run a unique key and a label that says what tells it from the others."""
    payloads = sorted({run.payload for run in runs})
    ways = {run.direction for run in runs}
    used: set[str] = set()
    for run in runs:
        load = _load_word(run.payload, payloads, unit)
        way = words[0] if run.direction > 0 else words[1]
        key = base = f"{load[0]}_{way.replace(' ', '_')}"
        number = 2
        while key in used:
            key, number = f"{base}_{number}", number + 1
        used.add(key)
        label = f"{load[1]}, {way}" if len(ways) > 1 or words != TRAVELLING else load[1]
        if run.process_force and key != base:
            label = f"{label}, other process force"
        yield replace(run, key=key, label=label)


def _load_word(payload: float, payloads: Sequence[float], unit: str) -> tuple[str, str]:
    """Part of the key and of the label."""
    if payload == payloads[0] and (payload == 0 or len(payloads) > 1):
        return "unladen", "unladen" if payload == 0 else f"lightest load ({payload:g} {unit})"
    if payload == payloads[-1]:
        return "laden", "laden"
    place = payloads.index(payload)
    return f"load_{place}", f"with {payload:g} {unit}"
