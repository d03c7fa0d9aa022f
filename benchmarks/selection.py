"""Speed and memory of the servo selection, as ratios measured in one run on one machine.

    python benchmarks/selection.py [--rule-set usual|lachman]

Prints JSON: every figure with its target and whether it is met. The candidates are all servo motors with all servo gear
units of the shipped catalogue; everything is measured on one core.
"""

import os

for _name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[_name] = "1"

import argparse  # noqa: E402  (the number of threads must be set before numpy is loaded)
import json  # noqa: E402
import tempfile  # noqa: E402
import time  # noqa: E402
import tracemalloc  # noqa: E402
from collections.abc import Callable  # noqa: E402
from pathlib import Path  # noqa: E402

import numpy as np  # noqa: E402

from app.catalog.load import load_catalog  # noqa: E402
from app.catalog.repository import CatalogRepository  # noqa: E402
from app.db.migrate import upgrade  # noqa: E402
from app.db.session import make_engine, session_factory  # noqa: E402
from app.engine.candidates import GearArrays, MotorArrays  # noqa: E402
from app.engine.cycle import LoadCycle  # noqa: E402
from app.engine.drives.rules import ServoRules  # noqa: E402
from app.engine.environment import Environment  # noqa: E402
from app.engine.formulas.efficiency import through_stage  # noqa: E402
from app.engine.mechanisms.load import Load, Statics  # noqa: E402
from app.engine.selection import select  # noqa: E402

ROOT = Path(__file__).resolve().parent.parent
REPEATS = 8
SAMPLE = 1500
"""Candidates of the loop that looks at one after the other; its time is scaled up to all of them."""
INERTIA = 0.3
FRICTION = 5.0


def catalogue() -> tuple[MotorArrays, GearArrays]:
    """All servo motors and gear units of the shipped catalogue."""
    with tempfile.TemporaryDirectory() as folder:
        url = f"sqlite:///{folder}/catalogue.db"
        upgrade(url)
        engine = make_engine(url)
        load_catalog(engine, ROOT / "catalog_data")
        with session_factory(engine)() as session:
            repository = CatalogRepository(session)
            found = repository.servo_motors(), repository.servo_gear_units()
        engine.dispose()
    return MotorArrays.from_records(found[0]), GearArrays.from_records(found[1])


def rough_load(segments: int) -> Load:
    """A cam-like cycle with an irregular process torque: every segment differs from every other."""
    random = np.random.default_rng(segments)
    speed = 6 * np.abs(np.sin(np.linspace(0, 2 * np.pi, segments, endpoint=False))) * random.uniform(0.5, 1, segments)
    duration = random.uniform(0.05, 0.2, segments)
    after = np.roll(speed, -1)
    torque = random.uniform(-4, 14, segments) + INERTIA * (after - speed) / duration
    return _load(duration, speed, after, torque)


def smooth_load(segments: int) -> Load:
    """A crank-like cycle: torque and acceleration run along a smooth closed curve."""
    border = np.linspace(0, 2 * np.pi, segments + 1)
    speed = 3 + 2 * np.sin(border)
    duration = np.full(segments, 2.0 / segments)
    middle = (border[:-1] + border[1:]) / 2
    torque = FRICTION + 8 * np.cos(middle + 0.4) + INERTIA * np.diff(speed) / duration
    return _load(duration, speed[:-1], speed[1:], torque)


def _load(duration: np.ndarray, start: np.ndarray, end: np.ndarray, torque: np.ndarray) -> Load:
    segments = duration.size
    cycle = LoadCycle(
        duration=duration,
        speed_start=start,
        speed_end=end,
        torque=torque,
        braked=np.zeros(segments, dtype=bool),
        label=("running",) * segments,
        inertia=INERTIA,
    )
    top = cycle.max_speed
    statics = Statics(
        friction=FRICTION, forward=9.0, backward=-3.0, holding=4.0, working=14.0, rapid_speed=top, working_speed=top / 2
    )
    return Load(cycle=cycle, statics=statics)


def again(load: Load) -> Load:
    """The same load without anything computed before."""
    cycle = load.cycle
    names = ("duration", "speed_start", "speed_end", "torque", "braked", "label", "inertia")
    return Load(cycle=LoadCycle(**{name: getattr(cycle, name) for name in names}), statics=load.statics)


def fastest(*works: Callable[[], object]) -> list[float]:
    """Shortest time of each work [s]; they take turns, so that a busy moment of the machine hits all alike.

    In each turn a work runs three times in a row: the first run finds the memory cold.
    """
    found = [np.inf] * len(works)
    for _ in range(REPEATS):
        for number, work in enumerate(works):
            for _ in range(3):
                start = time.perf_counter()
                work()
                found[number] = min(found[number], time.perf_counter() - start)
    return found


def one_by_one(load: Load, motors: MotorArrays, gears: GearArrays, rules: ServoRules) -> None:
    """Judge a sample of candidates one after the other, each with numpy over the segments of the cycle."""
    random = np.random.default_rng(1)
    cycle = load.cycle
    for row, column in zip(
        random.integers(0, len(motors), SAMPLE), random.integers(1, len(gears) + 1, SAMPLE), strict=True
    ):
        ratio = gears.ratio[column]
        inertia = motors.rotor[row] + gears.inertia[column]
        passed = through_stage(cycle.torque, cycle.mean_speed, gears.efficiency[column], "eta")
        torque = passed / ratio + inertia * ratio * cycle.acceleration
        peak = np.abs(torque).max()
        effective = np.sqrt((torque**2 * cycle.duration).sum() / cycle.duration.sum())
        mean = ratio * (np.abs(cycle.mean_speed) * cycle.duration).sum() / cycle.duration.sum()
        stall, rated, rated_speed = motors.continuous.points[:3, row]
        limit = np.interp(mean, [0, rated_speed], [stall, rated])
        top = ratio * cycle.max_speed
        load_inertia = cycle.inertia / ratio**2 + gears.inertia[column]
        _ = (
            peak <= motors.flat_peak[row]
            and effective <= limit
            and top <= 0.9 * rated_speed
            and load_inertia <= rules.inertia_ratio_limit * motors.rotor[row]
            and np.abs(cycle.torque).max() <= gears.acceleration_torque[column]
            and top <= gears.max_input_speed[column]
        )


def memory(load: Load, motors: MotorArrays, gears: GearArrays, rules: ServoRules) -> tuple[int, float]:
    """Candidates of a selection over at least a million of them, and what it takes above the idle process [MB]."""
    wanted = -(-1_000_000 // (len(gears) + 1))
    more = MotorArrays.from_records(motors.records * -(-wanted // len(motors)))
    tracemalloc.start()
    before, _ = tracemalloc.get_traced_memory()
    found = select(load, more, gears, rules, Environment())
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    return found.evaluated, (peak - before) / 1e6


def figure(value: float, target: float, at_least: bool = False) -> dict[str, float | bool]:
    """One figure with its target."""
    met = value >= target if at_least else value <= target
    return {"value": round(value, 2), "target": target, "met": bool(met)}


def measure(rule_set: str) -> dict[str, object]:
    """All figures for one rule set."""
    motors, gears = catalogue()
    rules = ServoRules.si(rule_set=rule_set)
    few, many, smooth_few, smooth_many = rough_load(10), rough_load(10_000), smooth_load(10), smooth_load(10_000)
    count = len(motors) * (len(gears) + 1)
    random = np.random.default_rng(0)
    x, y = random.random(count), random.random(count)

    def run(load: Load) -> Callable[[], object]:
        return lambda: select(again(load), motors, gears, rules, Environment())

    reference, short, long, smooth_short, smooth_long, loop = fastest(
        lambda: 1.3 * x + 2.1 * y,
        run(few),
        run(many),
        run(smooth_few),
        run(smooth_many),
        lambda: one_by_one(few, motors, gears, rules),
    )
    selection = select(few, motors, gears, rules, Environment())
    million, megabytes = memory(many, motors, gears, rules)
    return {
        "rule_set": rule_set,
        "motors": len(motors),
        "gear_units": len(gears),
        "candidates": selection.evaluated,
        "admitted": selection.admitted,
        "milliseconds": {
            "one numpy pass a*x + b*y": round(reference * 1e3, 2),
            "selection, 10 segments": round(short * 1e3, 2),
            "selection, 10 000 segments": round(long * 1e3, 2),
            "selection, 10 segments, smooth": round(smooth_short * 1e3, 2),
            "selection, 10 000 segments, smooth": round(smooth_long * 1e3, 2),
            "loop over all candidates, scaled up": round(loop / SAMPLE * count * 1e3),
        },
        "selection / numpy pass": figure(short / reference, 10),
        "loop / selection": figure(loop / SAMPLE * count / short, 500, at_least=True),
        "10 000 / 10 segments": figure(long / short, 1.5),
        "10 000 / 10 segments, smooth": figure(smooth_long / smooth_short, 1.5),
        "memory over a million candidates [MB]": {"candidates": million, **figure(megabytes, 200)},
    }


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rule-set", choices=("usual", "lachman"), default="usual")
    print(json.dumps(measure(parser.parse_args().rule_set), indent=2))
