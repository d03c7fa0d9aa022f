"""Selection against the check of single drives, over random loads, motors and gear units."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.engine.candidates import GearArrays, MotorArrays
from app.engine.cycle import LoadCycle
from app.engine.drives import servo_terms
from app.engine.drives.rules import CHECK_NAMES, ServoRules
from app.engine.environment import Environment
from app.engine.mechanisms.load import Load
from app.engine.products import ServoGearUnit, ServoMotor
from app.engine.selection import DIRECT, NOT_CHECKED, Candidate, Ranking, Selection, select
from app.engine.sheet import Verdict
from tests.engine.drives.cases import cycle, cycles, gear, load, motor

BOUNDED = settings(max_examples=40, deadline=None)
USUAL = ServoRules.si(brake="no")
ANY_INERTIA = ServoRules.si(brake="no", inertia_ratio_limit=100.0)
"""Admits the direct drive too: 0.05 kg m2 on 0.002 kg m2."""
SIMPLE = load(
    cycle(
        (0.1, 0, 20, 15, False), (0.3, 20, 20, 5, False), (0.1, 20, 0, -5, False), (0.5, 0, 0, 0, False), inertia=0.05
    )
)


def maybe(low: float, high: float) -> st.SearchStrategy[float | None]:
    """A datum of a data sheet, now and then missing."""
    return st.one_of(st.floats(low, high), st.floats(low, high), st.none())


@st.composite
def motors(draw: st.DrawFn) -> ServoMotor:
    values: dict[str, Any] = {
        "rated_speed": draw(maybe(100, 600)), "max_speed": draw(maybe(600, 900)), "stall_torque": draw(maybe(10, 20)),
        "rated_torque": draw(maybe(2, 10)), "peak_torque": draw(maybe(20, 80)),
        "rotor_inertia": draw(maybe(1e-5, 1e-2)),
        "rotor_inertia_with_brake": draw(maybe(1e-2, 2e-2)), "brake_torque": draw(maybe(1, 20)),
        "mass": draw(maybe(1, 50)),
    }  # fmt: skip
    if draw(st.booleans()):
        levels = sorted((draw(st.floats(5, 80)) for _ in range(3)), reverse=True)
        speeds = [draw(st.sampled_from([0.0, 50.0])), 200.0, 500.0]
        values["peak_curve"] = tuple(zip(speeds, levels, strict=True))
    if draw(st.booleans()):
        values["continuous_curve"] = ((0.0, draw(st.floats(5, 20))), (400.0, draw(st.floats(1, 5))))
    return motor(**values)


@st.composite
def gears(draw: st.DrawFn) -> ServoGearUnit:
    return gear(
        ratio=draw(st.floats(1, 60)), efficiency=draw(maybe(0.3, 1)), inertia=draw(maybe(0, 1e-2)),
        nominal_torque=draw(maybe(10, 90)), acceleration_torque=draw(maybe(10, 90)),
        emergency_torque=draw(maybe(20, 200)), nominal_input_speed=draw(maybe(100, 500)),
        max_input_speed=draw(maybe(200, 900)), mass=draw(maybe(1, 50)),
    )  # fmt: skip


@st.composite
def loads(draw: st.DrawFn) -> Load:
    one = draw(cycles())
    torque = st.floats(-40, 40).map(lambda value: round(value, 3))
    statics = {name: draw(torque) for name in ("forward", "backward", "holding", "working")}
    speeds = {"rapid_speed": one.max_speed, "working_speed": one.max_speed / 2}
    opposite = draw(st.one_of(st.none(), cycles()))
    return load(one, opposite, friction=abs(draw(torque)), **statics, **speeds)


@st.composite
def rule_sets(draw: st.DrawFn) -> ServoRules:
    return ServoRules.si(
        rule_set=draw(st.sampled_from(["usual", "lachman"])),
        speed_limit=draw(st.sampled_from(["rated", "maximum"])),
        brake=draw(st.sampled_from(["auto", "yes", "no"])),
        peak_reserve=draw(st.floats(1, 2)),
        holding_reserve=draw(st.floats(1, 2)),
        coupling_inertia=draw(st.sampled_from([0.0, 1e-3])),
        emergency_stop_factor=draw(st.sampled_from([None, 1.5])),
    )


def every_pair(found: Selection) -> list[tuple[int, int]]:
    return [(row, column) for row in range(len(found.terms.motors)) for column in range(DIRECT, len(found.terms.gears))]


def run(
    of: Load, rows: list[ServoMotor], columns: list[ServoGearUnit], rules: ServoRules = USUAL, **how: Any
) -> Selection:
    environment = how.pop("environment", Environment())
    return select(of, MotorArrays.from_records(rows), GearArrays.from_records(columns), rules, environment, **how)


@BOUNDED
@given(
    loads(), st.lists(motors(), min_size=1, max_size=3), st.lists(gears(), max_size=3), rule_sets(),
    st.sampled_from(["eta", "sew"]),
)  # fmt: skip
def test_every_candidate_has_the_numbers_of_its_own_check(
    of: Load, rows: list[ServoMotor], columns: list[ServoGearUnit], rules: ServoRules, model: str
):
    found = run(of, rows, columns, rules, environment=Environment.si(regeneration=model), limit=100)
    admitted = {(one.motor, one.gear): one for one in found.candidates}
    for pair in every_pair(found):
        checks = found.explain(*pair)
        used = found.utilisations(*pair)
        assert set(used) == {one.key for one in checks}
        for one in checks:
            expected = one.utilisation
            assert (used[one.key] is None) == (expected is None), one.key
            if expected is not None:
                assert used[one.key] == pytest.approx(expected, rel=1e-9, abs=1e-9), one.key
        fails = any(one.verdict == Verdict.FAILS for one in checks)
        assert (pair in admitted) == (not fails)
        if pair in admitted:
            missing = {one.key for one in checks if one.verdict == Verdict.NOT_CHECKED}
            assert set(admitted[pair].not_checked) == missing
    assert found.evaluated == len(rows) * (len(columns) + 1)
    assert found.admitted + sum(found.rejected.values()) == found.evaluated


def test_rejected_are_counted_by_the_first_check_that_fails():
    slow = motor(rated_speed=50.0)  # 100 rad/s behind the gear unit; its torque would not do either
    found = run(SIMPLE, [motor(), slow], [gear(), gear(acceleration_torque=10.0)])
    assert found.rejected["gear_acceleration_torque"] == 2  # 15 N m at the output, both motors
    assert found.rejected["speed"] == 1  # direct: 20 rad/s are slow enough
    for pair in every_pair(found):
        failing = [one.key for one in found.explain(*pair) if one.verdict == Verdict.FAILS]
        assert bool(failing) == (pair not in {(one.motor, one.gear) for one in found.candidates})


def test_the_rotor_decides_between_two_motors_of_the_same_torque():
    # 5 * 200 rad/s2 on the motor: 0.02 kg m2 take 20 N m on top of 3.75 N m, more than the 20 N m peak
    light, heavy = motor(peak_torque=20.0), motor(peak_torque=20.0, rotor_inertia=0.02)
    found = run(SIMPLE, [light, heavy], [gear()], include_direct=False)
    assert [one.motor for one in found.candidates] == [0]
    assert found.rejected == {"peak_torque": 1}
    assert found.utilisations(1, 0)["peak_torque"] == pytest.approx(23.75 / 20)


def brute_key(found: Selection, one: Candidate, ranking: Ranking) -> float:
    mass = found.terms.motors.records[one.motor].mass
    geared = 0.0 if one.gear == DIRECT else found.terms.gears.records[one.gear].mass
    if ranking == "mass":
        return np.inf if mass is None or geared is None else mass + geared
    if ranking == "rated_torque":
        return found.terms.motors.records[one.motor].rated_torque or np.inf
    if ranking == "inertia_match":
        ratio = one.inertia_ratio
        return np.inf if ratio is None else max(ratio, 1 / ratio)
    return -max(one.utilisations.values())


@pytest.mark.parametrize("ranking", ["utilisation", "mass", "rated_torque", "inertia_match"])
def test_ranking_equals_sorting_everything(ranking: Ranking, monkeypatch: pytest.MonkeyPatch):
    random = np.random.default_rng(4)
    rows = [
        motor(
            rotor_inertia=random.uniform(1e-4, 1e-2), rated_torque=float(random.integers(2, 9)),
            mass=random.uniform(2, 9), peak_torque=None if number % 7 == 0 else random.uniform(5, 60),
        )
        for number in range(40)
    ]  # fmt: skip
    columns = [gear(ratio=random.uniform(1, 12), mass=random.uniform(1, 5)) for _ in range(60)]
    rules = ServoRules.si(brake="no", emergency_stop_factor=1.0)
    monkeypatch.setattr("app.engine.selection._BLOCK", 256)
    monkeypatch.setattr("app.engine.selection._BLOCK_COLUMNS", 32)
    whole = run(SIMPLE, rows, columns, rules, ranking=ranking, limit=10_000)
    assert len(whole.candidates) == whole.admitted > 900
    keys = [(bool(one.not_checked), brute_key(whole, one, ranking)) for one in whole.candidates]
    assert keys == sorted(keys)
    pages = [run(SIMPLE, rows, columns, rules, ranking=ranking, limit=7, offset=start) for start in range(0, 70, 7)]
    assert [one for page in pages for one in page.candidates] == list(whole.candidates[:70])


def test_candidates_with_missing_data_come_last_or_not_at_all():
    rows = [motor(peak_torque=None, mass=1.0), motor(mass=20.0)]
    found = run(SIMPLE, rows, [], ANY_INERTIA, ranking="mass")
    assert [(one.motor, one.not_checked) for one in found.candidates] == [(1, ()), (0, ("peak_torque",))]
    strict = run(SIMPLE, rows, [], ANY_INERTIA, ranking="mass", require_all=True)
    assert [one.motor for one in strict.candidates] == [1]
    assert strict.rejected == {NOT_CHECKED: 1}


def test_an_input_that_only_the_user_can_give_rejects_nothing():
    found = run(SIMPLE, [motor()], [gear()], ANY_INERTIA, require_all=True)
    assert found.without_input == ("gear_emergency_torque",)
    assert found.admitted == 2
    assert {one.gear: one.not_checked for one in found.candidates} == {DIRECT: (), 0: ("gear_emergency_torque",)}


def test_an_empty_catalogue_gives_an_empty_selection():
    found = run(SIMPLE, [], [gear()])
    assert (found.evaluated, found.admitted, found.candidates, found.rejected) == (0, 0, (), {})


def test_one_motor_without_gear_units():
    found = run(SIMPLE, [motor(peak_torque=17.0)], [], ANY_INERTIA)
    # 15 N m and 0.002 kg m2 * 200 rad/s2 against 17 N m
    assert [(one.motor, one.gear, one.deciding) for one in found.candidates] == [(0, DIRECT, "peak_torque")]
    assert found.candidates[0].utilisation == pytest.approx(15.4 / 17)
    assert run(SIMPLE, [motor()], [], include_direct=False).evaluated == 0


def test_no_candidates_are_written_out_when_none_are_asked_for():
    assert run(SIMPLE, [motor()], [gear()], limit=0).candidates == ()


def crank(segments: int) -> Load:
    """Torque and acceleration along a smooth closed curve: every point is a corner of the hull."""
    border = np.linspace(0, 2 * np.pi, segments + 1)
    speed = 8 + 6 * np.sin(border)
    duration = np.full(segments, 2.0 / segments)
    torque = 5 + 20 * np.cos((border[:-1] + border[1:]) / 2 + 0.4)
    whole = LoadCycle(
        duration=duration, speed_start=speed[:-1], speed_end=speed[1:], torque=torque,
        braked=np.zeros(segments, dtype=bool), label=("turning",) * segments, inertia=0.05,
    )  # fmt: skip
    return load(whole)


def test_an_envelope_of_many_lines_is_looked_up_with_the_same_result():
    of = crank(600)
    assert of.cycle.hull.envelopes[1].torque.size > servo_terms.MANY_LINES
    rows = [motor(rotor_inertia=inertia) for inertia in (1e-5, 1e-3, 3e-2)]
    found = run(of, rows, [gear(ratio=ratio) for ratio in (1.5, 6.0, 40.0)])
    for pair in every_pair(found):
        peak = next(one for one in found.explain(*pair) if one.key == "peak_torque")
        assert found.utilisations(*pair)["peak_torque"] == pytest.approx(peak.utilisation, rel=1e-9)


def test_order_of_segments_and_their_splitting_change_nothing():
    one = SIMPLE.cycle
    order = np.array([2, 0, 3, 1])
    turned = replace(
        one, duration=one.duration[order], speed_start=one.speed_start[order], speed_end=one.speed_end[order],
        torque=one.torque[order], braked=one.braked[order],
    )  # fmt: skip
    first = run(SIMPLE, [motor()], [gear()]).utilisations(0, 0)
    second = run(load(turned), [motor()], [gear()]).utilisations(0, 0)
    assert second == pytest.approx(first)


def test_every_check_has_a_name():
    found = run(SIMPLE, [motor()], [gear()], ServoRules.si(rule_set="lachman", brake="yes", emergency_stop_factor=2.0))
    assert set(found.utilisations(0, 0)) <= set(CHECK_NAMES)
