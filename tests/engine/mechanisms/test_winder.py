"""Winder: the reel by geometry, the torque by hand, the energy of the web."""

import math
from typing import Any

import numpy as np
import pytest
from pydantic import ValidationError

from app.engine.mechanisms.winder import Winder
from app.engine.motion.constant import ConstantMotion
from app.engine.motion.moves import Moves
from app.engine.motion.profile import MotionProfile
from app.engine.sheet import Sheet
from tests.engine.mechanisms.laws import drawing_shows_fields, loaded, work, written

PAPER = {"core_diameter_mm": 100, "full_diameter_mm": 1000, "tension_n": 300, "thickness_mm": 0.1, "width_mm": 1200,
         "density_kg_m3": 900}  # fmt: skip


def winder(**other: Any) -> Winder:
    return Winder.model_validate(PAPER | other)


def running(metres: float = 7775.4418, speed: float = 5.0, ramp: float = 0.5) -> MotionProfile:
    """The web from standstill to standstill; the default length fills the reel: pi (1 - 0.01) / (4 * 1e-4)."""
    move = {"distance_mm": metres * 1000, "speed_m_s": speed, "acceleration_m_s2": ramp}
    return Moves.model_validate({"moves": [move]}).solve(Sheet())


def test_the_reel_is_full_when_its_length_is_wound():
    sheet = written(winder(), running())
    assert sheet.value("full_reel_length") == pytest.approx(7775.4418, rel=1e-6)
    assert sheet.value("largest_diameter") == pytest.approx(1.0, rel=1e-6)
    # pi * 900 * 1.2 * (1 - 1e-4) / 32
    assert sheet.value("largest_reel_inertia") == pytest.approx(106.0181, abs=1e-3)


def test_torque_grows_and_speed_falls_with_the_diameter():
    """300 N at sqrt(0.01 + 1e-4 * 100 / pi) / 2 m after a ramp of 25 m: 17.22 N m; at 500 mm 150 N m at 10 rad/s; the
    power stays 1.5 kW."""
    cycle = loaded(winder(), running()).cycle
    steady = np.array(["constant" in label for label in cycle.label])
    assert cycle.torque[steady][0] == pytest.approx(17.22, rel=0.01)
    assert cycle.torque[steady][-1] == pytest.approx(150, rel=0.01)
    assert cycle.speed_start[steady][-1] == pytest.approx(10, rel=0.01)
    np.testing.assert_allclose((cycle.torque * cycle.mean_speed)[steady], 1500, rtol=0.01)


def test_the_work_is_that_of_the_tension():
    """What the inertia takes while starting it gives back while stopping, but for the reel that has grown meanwhile."""
    light = winder(density_kg_m3=1e-9)
    assert work(loaded(light, running())) == pytest.approx(300 * 7775.4418, rel=1e-4)


def test_unwinding_returns_the_work():
    cycle = loaded(winder(task="unwind", density_kg_m3=1e-9), running())
    assert work(cycle) == pytest.approx(-300 * 7775.4418, rel=1e-4)
    assert cycle.statics.holding == pytest.approx(-150, rel=1e-6)


def test_acceleration_of_a_full_reel_by_hand():
    """106.018 kg m2 * 0.5 / 0.5 rad/s2 more than the tension asks; unwinding from the full reel."""
    cycle = loaded(winder(task="unwind"), running(20)).cycle
    assert cycle.torque[0] == pytest.approx(106.018 - 150, rel=1e-3)


def test_taper_lowers_the_tension_of_a_full_reel():
    """300 * (1 - 0.4 * 0.9) = 192 N at 0.5 m"""
    assert loaded(winder(taper_percent=40, task="unwind"), running(20)).statics.holding == pytest.approx(-96, rel=1e-2)


def test_too_much_web_fails_its_check():
    assert written(winder(), running()).checks == []
    checks = {check.key: check for check in written(winder(), running(9000)).checks}
    assert checks["reel_diameter"].verdict == "fails"
    checks = {check.key: check for check in written(winder(task="unwind"), running(9000)).checks}
    assert checks["reel_length"].verdict == "fails"
    assert "reel_length" not in {check.key for check in written(winder(task="unwind"), running(7000)).checks}


def test_friction_takes_power_in_both_directions():
    free, held = (loaded(winder(friction_torque_nm=M, tension_n=0), running(50)) for M in (0, 4))
    angle = float((free.cycle.mean_speed * free.cycle.duration).sum())
    assert work(held) - work(free) == pytest.approx(4 * angle)
    assert angle == pytest.approx(2 * math.pi * (written(winder(), running(50)).value("largest_diameter") - 0.1) / 2e-4,
                                  rel=1e-3)  # fmt: skip


def test_a_web_that_runs_on_fills_the_reel():
    """pi (1 - 0.01) / 4e-4 m at 5 m/s, then 300 N at 0.5 m; 5 m/s on a core of 0.1 m are 100 rad/s."""
    motion = ConstantMotion.model_validate({"speed_m_s": 5}).solve(Sheet())
    found = loaded(winder(), motion)
    assert found.cycle.cycle_time == pytest.approx(7775.4418 / 5, rel=1e-6)
    assert found.cycle.torque.max() == pytest.approx(150, rel=5e-3)  # the growing reel slows down
    assert loaded(winder(task="unwind"), motion).cycle.speed_end[-1] == pytest.approx(100, rel=1e-3)
    timed = ConstantMotion.model_validate({"speed_m_s": 5, "duration_s": 10}).solve(Sheet())
    assert loaded(winder(), timed).cycle.cycle_time == pytest.approx(10)


def test_running_backward_from_the_same_start_is_another_task():
    assert loaded(winder(task="unwind"), running()).opposite is None


def test_what_does_not_fit_together():
    with pytest.raises(ValidationError, match="larger than the core"):
        winder(full_diameter_mm=90)
    with pytest.raises(ValidationError, match="between the core and the full reel"):
        winder(start_diameter_mm=50)


def test_drawing():
    drawing_shows_fields([Winder], "winder.svg", {"D_K", "D_max", "F_W", "h", "b", "rho"})
