"""What must hold for every mechanism there is: inputs are drawn from the declarations, motions are drawn too.

A new mechanism is tested here without a line of its own. Where a drawn set of inputs does not fit together, the field
that the refusal names is given or left out until it does.
"""

import math
from dataclasses import replace
from typing import Any, get_args

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from pydantic import BaseModel, ValidationError

from app.engine.cycle import LoadCycle
from app.engine.environment import Environment
from app.engine.mechanisms import mechanisms
from app.engine.mechanisms.base import Mechanism
from app.engine.mechanisms.guided_axis import split
from app.engine.motion.profile import MotionProfile
from app.engine.quantity import Declared, Option, Quantity, declaration
from app.engine.sheet import Sheet
from tests.engine.mechanisms import laws
from tests.engine.mechanisms.laws import AnyTable, loaded

KINDS = sorted(mechanisms())
EVERY = pytest.mark.parametrize("kind", KINDS)
SEGMENTWISE = pytest.mark.parametrize("kind", [kind for kind in KINDS if not mechanisms()[kind].follows_course])
"""Each segment stands for itself; the others are sampled, so halving the step replaces cutting a segment."""
FOLLOWING = pytest.mark.parametrize("kind", [kind for kind in KINDS if mechanisms()[kind].follows_course])
MODELS = st.sampled_from(["eta", "sew"])
HARD = settings(
    max_examples=20, deadline=None, suppress_health_check=[HealthCheck.filter_too_much, HealthCheck.too_slow]
)
WORST = {"unbalance_follows": "worst_case"}
"""Needs no course of the angle: each segment stands for itself."""
BY_ANGLE = {"unbalance_follows": "angle", "process_force_n": 0, "density_kg_m3": 1e-3}
"""An unbalance that is always against the motor is no course of a real motion; a process that helps gives energy, and
so does a heavy web that comes fast and goes slowly."""


# --- inputs out of the declarations -----------------------------------------------------------------------------------


@st.composite
def numbers(draw: st.DrawFn, found: Quantity) -> float:
    """A plausible SI value: a range of a few units is drawn evenly, a wide one in its lower half by powers of ten."""
    low = next((bound for bound in (found.gt, found.ge) if bound is not None), -1.0)
    high = next((bound for bound in (found.lt, found.le) if bound is not None), 1e3)
    if high <= 10:
        low, high = max(low, -high), high
        return draw(st.floats(low + 0.02 * (high - low), high, allow_subnormal=False))
    size = float(10 ** draw(st.floats(0.3 * math.log10(high) - 2, 0.6 * math.log10(high))))
    return -size if low < 0 and draw(st.booleans()) else size


@st.composite
def objects(draw: st.DrawFn, model: type[BaseModel]) -> dict[str, Any]:
    """One further object of a list, such as a body or a moving mass: everything it must have."""
    found = {name: info.default for name, info in model.model_fields.items() if name in ("kind", "shape")}
    return found | {
        info.alias or name: draw(border_values(info))
        for name, info in model.model_fields.items()
        if declaration(info) is not None and info.is_required()
    }


@st.composite
def border_values(draw: st.DrawFn, info: Any) -> Any:
    """A value of one field as it is typed."""
    found = declaration(info)
    if isinstance(found, Quantity):
        return found.from_si(draw(numbers(found)))
    assert isinstance(found, Option)
    if found.labels:
        return draw(st.sampled_from(sorted(found.labels, key=str)))
    if found.ge is not None:
        return draw(st.integers(found.ge, min(found.le or 10**6, found.ge + 60)))
    if "bool" in str(info.annotation):
        return draw(st.booleans())
    return [draw(objects(draw(st.sampled_from(members(info.annotation))))) for _ in range(draw(st.integers(1, 2)))]


def members(annotation: Any) -> list[type[Declared]]:
    """The models that an entry of a list may be."""
    if isinstance(annotation, type) and issubclass(annotation, Declared):
        return [annotation]
    return [model for inner in get_args(annotation) for model in members(inner)]


@st.composite
def drawn(draw: st.DrawFn, kind: str, pinned: dict[str, Any], most: int = 6) -> Mechanism:
    """A mechanism with what it must have and up to ``most`` of what it may have."""
    model = mechanisms()[kind]
    fields = {info.alias or name: info for name, info in model.model_fields.items() if declaration(info) is not None}
    optional = sorted(name for name, info in fields.items() if not info.is_required())
    chosen = draw(st.lists(st.sampled_from(optional), max_size=most, unique=True)) if most else []
    values = {name: draw(border_values(fields[name])) for name in fields if fields[name].is_required()}
    values |= {name: draw(border_values(fields[name])) for name in chosen}
    values |= {name: value for name, value in pinned.items() if name in fields}
    for _ in range(8):
        try:
            return model.model_validate(values)
        except ValidationError as error:
            name = str(error.errors()[0]["loc"][0])
            if name in values and not fields[name].is_required():
                del values[name]
            else:
                values[name] = draw(border_values(fields[name]))
    assume(False)
    raise AssertionError


def changed(mechanism: Mechanism, factor: float) -> Mechanism:
    """The same mechanism with every efficiency set to ``factor`` of itself, or to one where that is 0."""
    values = mechanism.model_dump(by_alias=True, exclude_unset=True)
    for name, info in type(mechanism).model_fields.items():
        found = declaration(info)
        if isinstance(found, Quantity) and found.symbol.split("_")[0] == "eta":
            present = getattr(mechanism, name)
            values[info.alias or name] = 1.0 if factor == 0 or present is None else present * factor
    if getattr(mechanism, "thread_friction", None) is not None:  # stands in place of an efficiency
        del values["thread_friction"]
    return type(mechanism).model_validate(values)


# --- motions ----------------------------------------------------------------------------------------------------------


@st.composite
def motions(
    draw: st.DrawFn, kind: str, *, closed: bool = False, process: bool = True, payloads: bool = True
) -> MotionProfile:
    """Moves from rest to rest with standstills between them; ``closed``: back to the start with the same payload."""
    rows: list[tuple[float, ...]] = []
    size = st.floats(0.1, 10.0)
    for number in range(draw(st.integers(1, 3)) * (2 if closed else 1)):
        way = (-1.0) ** number if closed else draw(st.sampled_from([1.0, -1.0]))
        if not closed or number % 2 == 0:
            travel = draw(size)
        v, up, down = (draw(st.floats(0.1, 3.0)) for _ in range(3))
        ramps = v * (up + down) / 2
        level = max(travel - ramps, 0.0) / v
        v = min(v, 2 * travel / (up + down)) if level == 0 else v
        m = draw(st.floats(0.0, 50.0)) if payloads else 0.0
        F = draw(st.floats(-100.0, 500.0)) if process else 0.0
        rows += [
            (up, 0, way * v, m, F, way, 0),
            (level, way * v, way * v, m, F, way, 0),
            (down, way * v, 0, m, F, way, 0),
        ]
        standing = F if draw(st.booleans()) else 0.0
        rows += [(draw(size), 0, 0, m, standing, way, draw(st.booleans()))]
    duration, start, end, m_p, force, direction, braked = np.array([row for row in rows if row[0] > 0], dtype=float).T
    what = ["standing" if not s and not e else "moving" for s, e in zip(start, end, strict=True)]
    return MotionProfile(
        mechanisms()[kind].motion_kind, duration, start, end, m_p, force, direction, braked.astype(bool), tuple(what)
    )


# --- laws -------------------------------------------------------------------------------------------------------------


@SEGMENTWISE
@HARD
@given(data=st.data())
def test_splitting_a_segment_changes_nothing(kind: str, data: st.DataObject):
    mechanism = data.draw(drawn(kind, {**WORST, "viscous_coefficient_ns_m": 0.0}))
    laws.splitting_changes_nothing(mechanism, data.draw(motions(kind)), data.draw(st.integers(2, 5)))


@SEGMENTWISE
@HARD
@given(data=st.data())
def test_arrays_equal_a_loop(kind: str, data: st.DataObject):
    mechanism = data.draw(drawn(kind, {**WORST, "viscous_coefficient_ns_m": 0.0}))
    laws.arrays_equal_a_loop(mechanism, data.draw(motions(kind)))


@FOLLOWING
@HARD
@given(data=st.data(), model=MODELS)
def test_cutting_a_sampled_course_once_more_changes_little(kind: str, data: st.DataObject, model: str):
    mechanism, motion = data.draw(drawn(kind, WORST)), data.draw(motions(kind))
    cut = np.full(len(motion.duration), 2)
    whole, finer = (loaded(mechanism, run, regeneration=model).cycle for run in (motion, split(motion, cut)))
    squares = [float((one.torque**2 * one.duration).sum()) for one in (whole, finer)]
    assert squares[1] == pytest.approx(squares[0], rel=2e-3)
    assert np.abs(finer.torque).max() == pytest.approx(np.abs(whole.torque).max(), rel=1e-3)


@FOLLOWING
@HARD
@given(data=st.data())
def test_without_losses_the_kinetic_energy_is_the_work_of_the_drive(kind: str, data: st.DataObject):
    """The inertia at the shaft changes with angle or reel, but never exceeds what the cycle says."""
    mechanism = changed(data.draw(drawn(kind, WORST | {"tension_n": 0}, most=0)), 0)
    motion = data.draw(motions(kind, process=False, payloads=False))
    cycle = loaded(mechanism, motion).cycle
    work = np.cumsum(cycle.torque * cycle.mean_speed * cycle.duration)
    most = cycle.inertia * cycle.max_speed**2 / 2
    lost = np.cumsum(np.abs(loaded(mechanism, motion).statics.friction * cycle.mean_speed * cycle.duration))
    assert (work <= most + lost + 1e-3 * turnover_of(cycle)).all()


def turnover_of(cycle: LoadCycle) -> float:
    return float(np.abs(cycle.torque * cycle.mean_speed * cycle.duration).sum())


@EVERY
@HARD
@given(data=st.data(), model=MODELS)
def test_a_mechanism_in_its_simplest_form_is_the_same_in_both_directions(kind: str, data: st.DataObject, model: str):
    mechanism, motion = data.draw(drawn(kind, WORST, most=0)), data.draw(motions(kind, process=False))
    if (
        loaded(mechanism, motion).opposite is None and not mechanism.one_way
    ):  # a hoist differs in its simplest form, too
        laws.mirrored_motion_mirrors_the_torques(mechanism, motion, model)


@EVERY
@HARD
@given(data=st.data(), model=MODELS)
def test_the_opposite_cycle_is_that_of_the_mirrored_motion(kind: str, data: st.DataObject, model: str):
    mechanism, motion = data.draw(drawn(kind, WORST)), data.draw(motions(kind))
    there, back = (loaded(mechanism, run, regeneration=model) for run in (motion, motion.mirrored()))
    if there.opposite is not None:
        scale = float(np.abs(back.cycle.torque).max())
        np.testing.assert_allclose(there.opposite.torque, back.cycle.torque, rtol=1e-9, atol=1e-9 * scale)
        np.testing.assert_allclose(there.opposite.speed_start, back.cycle.speed_start)


@SEGMENTWISE
@HARD
@given(data=st.data())
def test_without_losses_torque_per_acceleration_is_the_inertia(kind: str, data: st.DataObject):
    """2 * E_kin / omega^2: the same speed with and without acceleration differs by J * alpha and nothing else."""
    mechanism = changed(data.draw(drawn(kind, WORST | {"unbalance_mass_kg": 0, "unbalance_radius_mm": 0})), 0)
    dv, t, m = data.draw(st.floats(0.01, 1.0)), data.draw(st.floats(0.01, 10.0)), data.draw(st.floats(0, 50))
    # one segment speeds up about a mean of 1, the other runs at 1
    pair = np.array([t, t]), np.array([1 - dv, 1.0]), np.array([1 + dv, 1.0])
    motion = MotionProfile(
        mechanisms()[kind].motion_kind, *pair, np.full(2, m), np.zeros(2), np.ones(2), np.zeros(2, bool), ("a", "b")
    )
    cycle = loaded(mechanism, motion).cycle
    steady, ends = float(cycle.torque[cycle.acceleration == 0][0]), cycle.acceleration != 0
    gained = float((cycle.torque[ends] * cycle.duration[ends]).sum()) - steady * t
    change = float(cycle.speed_end[ends][-1] - cycle.speed_start[0])
    scale = abs(steady) * t + abs(gained)
    assert gained == pytest.approx(cycle.inertia * change, rel=1e-7, abs=1e-9 * scale)


@EVERY
@HARD
@given(data=st.data(), model=MODELS)
def test_a_closed_cycle_never_yields_energy(kind: str, data: st.DataObject, model: str):
    mechanism = data.draw(drawn(kind, BY_ANGLE))
    found = loaded(mechanism, data.draw(motions(kind, closed=True, process=False, payloads=False)), regeneration=model)
    assert laws.work(found) >= -1e-3 * laws.turnover(found)


@EVERY
@HARD
@given(data=st.data(), model=MODELS, share=st.floats(0.3, 0.99))
def test_a_lower_efficiency_never_helps(kind: str, data: st.DataObject, model: str, share: float):
    """Segment by segment more goes in and less comes back: dividing while regenerating would do the opposite."""
    mechanism, motion = data.draw(drawn(kind, WORST)), data.draw(motions(kind))
    better = changed(mechanism, 1.0)
    laws.losses_never_help(better, changed(better, share), motion, model)


@EVERY
@HARD
@given(data=st.data(), model=MODELS)
def test_the_brake_takes_the_whole_torque(kind: str, data: st.DataObject, model: str):
    motion = data.draw(motions(kind))
    cycle = loaded(data.draw(drawn(kind, WORST)), motion, regeneration=model).cycle
    assert not cycle.torque[cycle.braked].any()
    assert float(cycle.duration[cycle.braked].sum()) == pytest.approx(float(motion.duration[motion.braked].sum()))


@EVERY
@HARD
@given(data=st.data(), model=MODELS)
def test_the_holding_torque_covers_every_standstill(kind: str, data: st.DataObject, model: str):
    """With whatever payload, and with the process force where the brake must bear it: the brake is chosen by it."""
    mechanism, motion = data.draw(drawn(kind, WORST)), data.draw(motions(kind))
    borne = replace(
        motion, braked=np.zeros_like(motion.braked), process_force=np.where(motion.braked, motion.process_force, 0.0)
    )
    cycle, statics = loaded(mechanism, borne, regeneration=model).cycle, loaded(mechanism, motion).statics
    standing = cycle.mean_speed == 0
    assert float(np.abs(cycle.torque[standing]).max(initial=0.0)) <= abs(statics.holding) * (1 + 1e-9) + 1e-12


@EVERY
@HARD
@given(data=st.data(), model=MODELS)
def test_steady_torques_cover_every_steady_segment(kind: str, data: st.DataObject, model: str):
    mechanism, motion = data.draw(drawn(kind, WORST)), data.draw(motions(kind, process=False))
    found = loaded(mechanism, motion, regeneration=model)
    steady = (found.cycle.acceleration == 0) & (found.cycle.mean_speed != 0)
    largest = max(abs(found.statics.forward), abs(found.statics.backward))
    assert float(np.abs(found.cycle.torque[steady]).max(initial=0.0)) <= largest * (1 + 1e-9) + 1e-12


@EVERY
@HARD
@given(data=st.data(), model=MODELS)
def test_every_number_on_the_sheet_is_finite_and_the_extreme_stands_there(kind: str, data: st.DataObject, model: str):
    mechanism, motion, sheet = data.draw(drawn(kind, WORST)), data.draw(motions(kind)), Sheet(tables=AnyTable())
    load = mechanism.load(motion, Environment.si(regeneration=model), sheet)
    assert all(math.isfinite(step.value) for step in sheet.steps)
    top = float(np.abs(load.cycle.torque).max())
    nearest = min(abs(abs(step.value) - top) for step in sheet.steps)
    assert nearest <= 1e-9 * top
    assert load.cycle.inertia >= 0
