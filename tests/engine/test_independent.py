"""Axes run a second time by a small time-stepping simulation with equations of its own, for random inputs.

The simulation (see ``simulation.py``) walks through time in equal steps of each phase. The axes below write Newton's
law for every single body (slide, counterweight, idler, screw, drum ...) and pass power, not torque, through the stages:
what a stage loses is counted in joules as it goes. Nothing of the formulas of the engine is used. Held against it are
torque over time, peak and effective torque, mean speed, and energy: over a closed cycle the motor puts in what was lost
and what the process took.
"""

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.engine.drives.rules import ServoRules
from app.engine.drives.servo import ServoResult, check_servo
from app.engine.environment import Environment
from app.engine.mechanisms import mechanisms
from app.engine.motion.moves import Moves, Turns
from app.engine.products import ServoGearUnit, ServoMotor
from app.engine.sheet import Sheet
from tests.engine.mechanisms.screw_cases import profile
from tests.engine.simulation import STEPS, Books, Drive, G, Moment, Run, Stage, opposed, rod_inertia, trapezoids

SOME = settings(max_examples=50, deadline=None)


# --- what is compared -------------------------------------------------------------------------------------------------


def engine(kind: str, values: dict[str, Any], moves: list[dict[str, float]], drive: Drive, model: str) -> ServoResult:
    """The same axis by the engine."""
    rotary = mechanisms()[kind].motion_kind == "rotary"
    names = ("distance", "speed", "acceleration", "payload_inertia" if rotary else "payload",
             "process_torque" if rotary else "process_force")  # fmt: skip
    fields = {"s": names[0], "v": names[1], "a": names[2], "payload": names[3], "force": names[4], "dwell": "dwell"}
    rows = [
        {fields[key]: value for key, value in move.items() if key != "brake"}
        | {"hold": "brake" if move["brake"] > 0 else "motor"}
        for move in moves
    ]  # fmt: skip
    sheet = Sheet()
    motion = (Turns if rotary else Moves).model_validate(
        {"moves": [_border(Turns if rotary else Moves, row) for row in rows]}
    )
    profile = motion.solve(sheet)
    environment = Environment.si(regeneration=model, gravity=G)
    load = mechanisms()[kind].si(**values).load(profile, environment, sheet)
    motor = ServoMotor(
        id="own", manufacturer="", series="", model="", source="", rotor_inertia=drive.rotor, rated_speed=1e5,
        stall_torque=10.0, rated_torque=8.0, peak_torque=30.0,
    )  # fmt: skip
    gear = ServoGearUnit(
        id="own", manufacturer="", series="", model="", source="", ratio=drive.ratio, efficiency=drive.eta,
        inertia=drive.gear_inertia,
    )  # fmt: skip
    return check_servo(load, motor, gear, None, ServoRules.model_validate({}), environment, sheet)


def _border(motion: Any, row: dict[str, Any]) -> dict[str, Any]:
    move = motion.model_fields["moves"].annotation.__args__[0]
    return dict(move.si(**row).model_dump(by_alias=True, exclude_unset=True))


def agree(found: ServoResult, there: Run, back: Run | None, rel: float = 1e-8) -> None:
    """Torque over time, peak, effective torque and its check at mean speed, and the energy of a closed cycle."""
    assert found.cycle.torque is not None
    largest = max(abs(M) for M in there.torque)
    segment = np.searchsorted(found.cycle.time, there.time, side="right") - 1
    np.testing.assert_allclose(found.cycle.torque[segment], there.torque, rtol=rel, atol=rel * largest)
    assert found.effective_torque == pytest.approx(there.effective, rel=rel)
    assert found.mean_speed == pytest.approx(there.mean_speed, rel=1e-9)
    peak = max(largest, max((abs(M) for M in back.torque), default=0.0) if back else 0.0)
    assert found.peak_torque == pytest.approx(peak, rel=rel)
    checks = {check.key: check for check in found.checks}
    assert checks["effective_torque"].demanded == pytest.approx(there.effective, rel=rel)
    assert checks["effective_torque"].permitted == pytest.approx(10 - 2 * there.mean_speed / 1e5, rel=1e-9)
    mean = (found.cycle.speed_start + found.cycle.speed_end) / 2
    put_in = float((found.cycle.torque * mean * np.diff(found.cycle.time)).sum())
    turned_over = sum(abs(M * n) * dt for M, n, dt in zip(there.torque, there.speed, there.width, strict=True))
    assert put_in == pytest.approx(there.books.lost + there.books.process, abs=rel * turned_over)


@st.composite
def round_trips(draw: st.DrawFn, s: tuple[float, float], v: float, a: float) -> list[dict[str, float]]:
    """One or two trips there and back, each with its own speed, process force and standstill."""
    found = []
    for _ in range(draw(st.integers(1, 2))):
        length, payload = draw(st.floats(*s)), draw(st.floats(0.0, 40.0))
        for way in (1.0, -1.0):
            found.append({
                "s": way * length, "v": draw(st.floats(0.1, 1.0)) * v, "a": draw(st.floats(0.1, 1.0)) * a,
                "payload": payload, "force": draw(st.sampled_from([0.0, 150.0, -80.0])),
                "dwell": draw(st.floats(0.1, 2.0)), "brake": draw(st.sampled_from([0.0, 1.0])),
            })  # fmt: skip
    return found


@st.composite
def drives(draw: st.DrawFn) -> Drive:
    return Drive(
        draw(st.sampled_from([1.0, 3.0, 10.0, 40.0])), draw(st.floats(0.6, 1.0)), draw(st.booleans()),
        draw(st.floats(0.0, 1e-3)), draw(st.floats(1e-5, 2e-2)),
    )  # fmt: skip


def compare(
    kind: str,
    values: dict[str, Any],
    moves: list[dict[str, float]],
    drive: Drive,
    axis: Callable[[Moment, Books], tuple[float, float, float]],
    *,
    both_ways: bool,
    steps: int = STEPS,
    rel: float = 1e-8,
) -> None:
    found = engine(kind, values, moves, drive, "sew" if drive.sew else "eta")
    there = drive.simulate(axis, trapezoids(moves, steps))
    mirrored = [move | {"s": -move["s"]} for move in moves]
    back = drive.simulate(axis, trapezoids(mirrored, steps)) if both_ways else None
    agree(found, there, back, rel)


# --- the axes ---------------------------------------------------------------------------------------------------------


@SOME
@given(
    moves=round_trips((0.2, 2.0), 2.0, 8.0), drive=drives(), slide=st.floats(5, 60), counter=st.floats(1, 80),
    d=st.floats(0.04, 0.2), k_t=st.floats(0, 2), guided=st.booleans(), eta=st.floats(0.7, 1.0),
    J_t=st.floats(0, 3e-3), J_u=st.floats(0, 3e-3),
)  # fmt: skip
def test_vertical_belt_with_counterweight(
    moves: list[dict[str, float]], drive: Drive, slide: float, counter: float, d: float, k_t: float, guided: bool,
    eta: float, J_t: float, J_u: float,
):  # fmt: skip
    """Two strands over the drive pulley, each with the body that hangs on it; both bodies are accelerated."""
    r, q, length, stage = d / 2, 0.3, 5.0, Stage(eta, drive.sew)

    def axis(now: Moment, books: Books) -> tuple[float, float, float]:
        m, omega, alpha = slide + now.payload, now.v / r, now.a / r
        rub_slide, rub_counter = opposed(k_t * m, now.v), opposed(k_t * counter * guided, now.v)
        # slide, upward positive: S1 - m g - friction - process = m a; counterweight, downward positive with the slide
        S1 = m * (G + now.a) + rub_slide + now.process * now.way
        S2 = counter * (G - now.a) - rub_counter
        pulley = (S1 - S2) * r + J_u * alpha + q * length * now.a * r
        books.lost += (rub_slide + rub_counter) * now.v * now.dt
        if omega == 0:
            return pulley, 0.0, 0.0
        return stage.power_in(pulley * omega, now.dt, books) / omega + J_t * alpha, omega, alpha

    values = {
        "slide_mass": slide,
        "counterweight_mass": counter,
        "counterweight_guided": guided,
        "inclination": math.pi / 2,
        "friction_model": "per_mass",
        "specific_friction": k_t,
        "pulley_diameter": d,
        "efficiency": eta,
        "drive_pulley_inertia": J_t,
        "idler_inertia": J_u,
        "belt_mass_per_length": q,
        "belt_length": length,
    }
    compare("timing_belt", values, moves, drive, axis, both_ways=True)


@SOME
@given(
    moves=round_trips((0.1, 0.8), 0.6, 5.0), drive=drives(), slide=st.floats(20, 500), lead=st.floats(0.004, 0.05),
    D=st.floats(0.016, 0.08), tilt=st.floats(0.1, 1.4), mu=st.floats(0, 0.2), eta=st.floats(0.3, 0.98),
    drag=st.floats(0, 3), balance=st.floats(0, 800),
)  # fmt: skip
def test_inclined_screw_that_loses_and_regenerates(
    moves: list[dict[str, float]], drive: Drive, slide: float, lead: float, D: float, tilt: float, mu: float,
    eta: float, drag: float, balance: float,
):  # fmt: skip
    """The nut loses by the direction of its power; bearings and the screw itself sit before it."""
    J_s, stage = rod_inertia(D, 1.0, 7850.0), Stage(eta, drive.sew)

    def axis(now: Moment, books: Books) -> tuple[float, float, float]:
        m = slide + now.payload
        omega, alpha = now.v / lead * 2 * math.pi, now.a / lead * 2 * math.pi
        rub = opposed(mu * m * G * math.cos(tilt), now.v)
        force = m * now.a + m * G * math.sin(tilt) - balance + rub + now.process * now.way
        books.lost += rub * now.v * now.dt
        if omega == 0:
            return force * lead / (2 * math.pi), 0.0, 0.0
        nut = stage.power_in(force * now.v, now.dt, books) / omega
        books.lost += drag * abs(omega) * now.dt
        return nut + J_s * alpha + opposed(drag, omega), omega, alpha

    values = {
        "slide_mass": slide,
        "inclination": tilt,
        "counterbalance_force": balance,
        "friction_coefficient": mu,
        "lead": lead,
        "nominal_diameter": D,
        "length": 1.0,
        "efficiency": eta,
        "preload_torque": drag / 3,
        "screw_friction_torque": drag * 2 / 3,
    }
    compare("ball_screw", values, moves, drive, axis, both_ways=True, rel=1e-6)  # the screw is summed from 4000 tubes


@SOME
@given(
    moves=round_trips((0.3, 6.0), 2.0, 4.0), drive=drives(), slide=st.floats(50, 2000), z=st.integers(15, 60),
    module=st.sampled_from([0.002, 0.003, 0.005]), beta=st.floats(0, 0.5), mu=st.floats(0, 0.1),
    viscous=st.sampled_from([0.0, 50.0, 800.0]), eta=st.floats(0.8, 1.0), J_p=st.floats(0, 0.01),
)  # fmt: skip
def test_level_rack_with_a_helical_pinion_and_viscous_friction(
    moves: list[dict[str, float]], drive: Drive, slide: float, z: int, module: float, beta: float, mu: float,
    viscous: float, eta: float, J_p: float,
):  # fmt: skip
    """The motor travels along; its travel per revolution is z transverse pitches."""
    travel, stage, motor_mass = z * math.pi * module / math.cos(beta), Stage(eta, drive.sew), 30.0

    def axis(now: Moment, books: Books) -> tuple[float, float, float]:
        m = slide + motor_mass + now.payload
        omega, alpha = now.v / travel * 2 * math.pi, now.a / travel * 2 * math.pi
        rub = opposed(mu * m * G, now.v) + viscous * now.v
        force = m * now.a + rub + now.process * now.way
        books.lost += rub * now.v * now.dt
        if omega == 0:
            return force * travel / (2 * math.pi), 0.0, 0.0
        return stage.power_in(force * now.v, now.dt, books) / omega + J_p * alpha, omega, alpha

    values = {
        "slide_mass": slide,
        "drive_mass": motor_mass,
        "module": module,
        "teeth": z,
        "helix_angle": beta,
        "friction_coefficient": mu,
        "viscous_coefficient": viscous,
        "efficiency": eta,
        "pinion_inertia": J_p,
    }
    fine = (
        {"steps": 200, "rel": 1e-2} if viscous else {}
    )  # a torque that changes along the ramp is met by both in steps
    compare("rack_pinion", values, moves, drive, axis, both_ways=False, **fine)  # type: ignore[arg-type]


@SOME
@given(
    moves=round_trips((0.5, 20.0), 20.0, 60.0), drive=drives(), m=st.floats(5, 200), D=st.floats(0.2, 1.5),
    arm=st.floats(0.1, 0.8), friction=st.floats(0, 20), external=st.floats(-30, 30), ratio=st.floats(1.5, 8),
    eta=st.floats(0.7, 1.0), J_1=st.floats(0, 0.05),
)  # fmt: skip
def test_rotary_load_behind_a_stage(
    moves: list[dict[str, float]], drive: Drive, m: float, D: float, arm: float, friction: float, external: float,
    ratio: float, eta: float, J_1: float,
):  # fmt: skip
    """A disc, and a square plate beside the axis whose inertia is summed up point by point."""
    edge, plate, n = 0.2, 3.0, 60
    grid = [((k + 0.5) / n - 0.5) * edge for k in range(n)]
    beside = sum(((arm + x) ** 2 + y * y) for x in grid for y in grid) * plate / n**2
    J, stage = rod_inertia(D, 1.0, 4 * m / (math.pi * D * D)) + beside, Stage(eta, drive.sew)

    def axis(now: Moment, books: Books) -> tuple[float, float, float]:
        rub = opposed(friction, now.v)
        torque = (J + now.payload) * now.a + rub + external + now.process * now.way
        books.lost += rub * now.v * now.dt
        if now.v == 0:
            return torque / ratio, 0.0, 0.0
        fast = stage.power_in(torque * now.v, now.dt, books) / (now.v * ratio)
        return fast + J_1 * now.a * ratio, now.v * ratio, now.a * ratio

    bodies = [
        {"shape": "cylinder", "mass_kg": m, "diameter_mm": D * 1e3},
        {"shape": "cuboid", "mass_kg": plate, "width_mm": 200, "length_mm": 200, "offset_mm": 1e3 * arm},
    ]
    disc = mechanisms()["rotary_load"].model_validate({"kind": "rotary_load", "bodies": bodies})
    values = {
        "bodies": disc.bodies,
        "friction_torque": friction,
        "external_torque": external,
        "stage_ratio": ratio,
        "stage_efficiency": eta,
        "stage_inertia": J_1,
    }
    compare("rotary_load", values, moves, drive, axis, both_ways=external != 0, rel=1e-3)  # sums of grid and tubes


@SOME
@given(
    moves=round_trips((1.0, 10.0), 1.5, 2.0), drive=drives(), m=st.floats(5, 300), belt=st.floats(0, 40),
    tilt=st.floats(0, 0.6), mu=st.floats(0.05, 0.5), D=st.floats(0.08, 0.4), J_d=st.floats(0, 0.1),
    eta=st.floats(0.6, 1.0), ratio=st.floats(1.0, 5), eta_2=st.floats(0.8, 1.0), J_1=st.floats(0, 0.01),
)  # fmt: skip
def test_conveyor_with_two_stages(
    moves: list[dict[str, float]], drive: Drive, m: float, belt: float, tilt: float, mu: float, D: float, J_d: float,
    eta: float, ratio: float, eta_2: float, J_1: float,
):  # fmt: skip
    """Drum, chain and gear unit one after the other: power goes through all three, each with its own direction."""
    first, second = Stage(eta, drive.sew), Stage(eta_2, drive.sew)

    def axis(now: Moment, books: Books) -> tuple[float, float, float]:
        carried, omega, alpha = m + now.payload, 2 * now.v / D, 2 * now.a / D
        rub = opposed(mu * (carried + belt / 2) * G * math.cos(tilt), now.v)
        force = (carried + belt) * now.a + carried * G * math.sin(tilt) + rub + now.process * now.way
        drum = force * D / 2 + J_d * alpha
        books.lost += rub * now.v * now.dt
        if omega == 0:
            return drum / ratio, 0.0, 0.0
        power = second.power_in(first.power_in(drum * omega, now.dt, books), now.dt, books)
        return power / (omega * ratio) + J_1 * alpha * ratio, omega * ratio, alpha * ratio

    values = {
        "load_mass": m,
        "belt_mass": belt,
        "inclination": tilt,
        "friction_coefficient": mu,
        "drum_diameter": D,
        "drum_inertia": J_d,
        "efficiency": eta,
        "stage_ratio": ratio,
        "stage_efficiency": eta_2,
        "stage_inertia": J_1,
        "reversing": True,
    }
    compare("belt_conveyor", values, moves, drive, axis, both_ways=True)


# --- at standstill, by hand -------------------------------------------------------------------------------------------


def test_a_brake_holds_the_process_force_too():
    """200 kg upright on a screw of 20 mm lead, 1500 N downward after the move up: (1962 + 1500) N * 20 mm / 2 pi."""
    upright = {"slide_mass": 200.0, "inclination": math.pi / 2, "nominal_diameter": 0.04, "lead": 0.02, "length": 1.0}
    assert _held("ball_screw", upright, 0.0, 1500.0) == pytest.approx(3462 * 0.02 / (2 * math.pi))
    # helped by the process after the move up, the same standstill after a move down is the harder one
    assert _held("ball_screw", upright, 0.0, -1500.0) == pytest.approx(3462 * 0.02 / (2 * math.pi))
    rack = {"slide_mass": 200.0, "module": 0.004, "teeth": 25}
    assert _held("rack_pinion", rack, 0.0, 1500.0) == pytest.approx(1500 * 0.05)  # level: pitch radius 50 mm


@pytest.mark.parametrize(("payload", "held"), [(0.0, -30 * 9.81), (40.0, 10 * 9.81), (100.0, 70 * 9.81)])
def test_an_empty_slide_may_be_harder_to_hold_than_a_laden_one(payload: float, held: float):
    """20 kg against a counterweight of 50 kg, radius 50 mm: empty it is pulled up with 294 N, whatever is carried."""
    hoist = {"slide_mass": 20.0, "counterweight_mass": 50.0, "inclination": math.pi / 2, "pulley_diameter": 0.1}
    worst = max((held, -30 * 9.81), key=abs)
    assert _held("timing_belt", hoist, payload, 0.0) == pytest.approx(worst * 0.05)


def test_the_belt_turns_its_idlers_and_carries_what_the_brake_holds():
    """Level, 10 kg and 4 kg cm2 of idlers on r = 20 mm (as heavy as 1 kg), a = 5 m/s2, 20 N of friction: 75 N; then
    400 N at standstill with closed brake."""
    axis = {"slide_mass": 10.0, "pulley_diameter": 0.04, "idler_inertia": 4e-4, "friction_model": "none",
            "friction_force": 20.0, "permitted_peripheral_force": 100.0}  # fmt: skip
    for force, demanded in ((0.0, 75.0), (400.0, 400.0)):
        rows = [(0.2, 0, 1, 0, 1, "up"), (0.2, 1, 0, 0, 1, "down"), (1, 0, 0, force, 1, "brake holds")]
        motion, sheet = replace(profile(rows), braked=np.array([False, False, True])), Sheet()
        mechanisms()["timing_belt"].si(**axis).load(motion, Environment.model_validate({}), sheet)
        checks = {check.key: check.demanded for check in sheet.checks}
        assert checks["peripheral_force"] == pytest.approx(demanded)


def _held(kind: str, values: dict[str, Any], payload: float, force: float) -> float:
    """Torque that must be held at standstill: empty, then with a payload and a process force, the brake closed."""
    move = {"distance_mm": 500, "speed_m_s": 0.5, "acceleration_m_s2": 2}
    laden = {"payload_kg": payload, "process_force_n": force, "process_during": "motion_and_standstill", "dwell_s": 1}
    motion = Moves.model_validate({"moves": [move, {**move, **laden, "hold": "brake"}]}).solve(Sheet())
    return mechanisms()[kind].si(**values).load(motion, Environment.model_validate({}), Sheet()).statics.holding
