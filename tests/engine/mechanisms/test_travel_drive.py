"""Travel drive: the handbook's trolleys, slip of the wheels, and what must hold for every vehicle."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from app.engine.mechanisms import mechanisms
from app.engine.mechanisms.travel_drive import TravelDrive
from app.engine.motion.profile import MotionProfile
from app.engine.sheet import Verdict
from tests.engine.mechanisms import laws
from tests.engine.mechanisms.laws import FEW, loaded, written
from tests.engine.mechanisms.screw_cases import run

TROLLEY: dict[str, Any] = {
    "vehicle_mass_kg": 1500, "wheel_diameter_mm": 250, "journal_diameter_mm": 60, "stage_ratio": 27 / 17,
    "stage_efficiency": 0.9,
}  # fmt: skip
HEAVY: dict[str, Any] = {**TROLLEY, "vehicle_mass_kg": 500, "wheel_diameter_mm": 315}


def there_laden_back_unladen(a: float, payload: float = 1500.0) -> MotionProfile:
    motion = run((2, 0.5, 0), (-2, 0.5, 0), a=a)
    return replace(motion, payload=np.repeat([payload, 0.0], 3))


@pytest.mark.parametrize(
    ("row", "axis", "payload", "expected"),
    [
        ("8.1 rolling_resistance_laden", TROLLEY, 1500, 241.326),
        ("8.1 rolling_resistance_unladen", TROLLEY, 0, 120.663),
        ("8.4 rolling_resistance_laden", HEAVY, 5000, 384.5364286),
    ],
)
def test_rolling_resistance_of_the_handbook(row: str, axis: dict[str, Any], payload: float, expected: float):
    sheet = written(TravelDrive.model_validate(axis), run((10, 0.5, 0), a=0.5, m=payload))
    assert sheet.value("rolling_resistance") == pytest.approx(expected, rel=1e-3), row


def test_permissible_acceleration_of_the_handbook():
    # SEW 8.1, row permissible_acceleration: 0.5 * 9.81 * 0.15
    sheet = written(TravelDrive.model_validate(TROLLEY), there_laden_back_unladen(0.5))
    assert sheet.value("permissible_acceleration") == pytest.approx(0.73575)


def test_speed_before_the_chain_stage_of_the_handbook():
    # SEW 8.4, row chain_output_speed: 74.32 rpm at 0.77182 m/s
    cycle = loaded(TravelDrive.model_validate(HEAVY), run((10, 0.7718219474, 0), a=0.5, m=5000.0)).cycle
    assert cycle.max_speed * 30 / math.pi == pytest.approx(74.32292457, rel=1e-3)


def test_torque_behind_and_before_the_stage_by_hand():
    # 3000 kg at 0.5 m/s2: 1500 N and 241.326 N at a radius of 0.125 m; braking 1258.674 N comes back through the chain
    found = loaded(TravelDrive.model_validate(TROLLEY), run((2, 0.5, 0), a=0.5, m=1500.0)).cycle
    ratio = 27 / 17
    expected = [1741.326 * 0.125 / 0.9 / ratio, 241.326 * 0.125 / 0.9 / ratio, -1258.674 * 0.125 * 0.9 / ratio]
    assert found.torque == pytest.approx(expected)


@pytest.mark.parametrize(("a", "start", "brake"), [(0.69, "tight", "tight"), (0.70, "fails", "tight"),
                                                   (0.74, "fails", "fails")])  # fmt: skip
def test_driven_wheels_slip_beyond_the_permissible_acceleration(a: float, start: str, brake: str):
    # SEW 8.1: at the start the trailing wheels take 60.33 N of 1103.6 N unladen, so 0.69553 m/s2; braking 0.73575
    checks = {check.key: check for check in written(TravelDrive.si(**SI), there_laden_back_unladen(a)).checks}
    assert set(checks) == {
        f"wheel_slip_{phase}_{state}" for phase in ("start", "brake") for state in ("laden", "unladen")
    }
    for state in ("laden", "unladen"):
        assert checks[f"wheel_slip_start_{state}"].verdict == Verdict(start)
        assert checks[f"wheel_slip_brake_{state}"].verdict == Verdict(brake)
    assert checks["wheel_slip_start_unladen"].demanded == pytest.approx(1500 * a + 120.663 / 2)
    assert checks["wheel_slip_start_unladen"].permitted == pytest.approx(1103.625)


SI: dict[str, Any] = {"vehicle_mass": 1500.0, "wheel_diameter": 0.25, "journal_diameter": 0.06}


def test_wind_slips_the_unladen_vehicle_first():
    # 700 N of wind against 0.3 m/s2: laden 900 + 700 + 120.7 of 2207 N, unladen 450 + 700 + 60.3 of 1103.6 N
    checks = {c.key: c for c in written(TravelDrive.si(**SI, wind_force=700.0), there_laden_back_unladen(0.3)).checks}
    assert checks["wheel_slip_start_laden"].verdict is not Verdict.FAILS
    assert checks["wheel_slip_start_unladen"].verdict is Verdict.FAILS
    assert checks["wheel_slip_start_unladen"].demanded == pytest.approx(450 + 700 + 60.3315)


def test_the_rails_turn_the_wheels_that_are_not_driven():
    """Half of 4 kg m2 at a radius of 0.125 m: 128 kg more for the driven wheels to accelerate at 0.3 m/s2."""
    vehicle = TravelDrive.si(**SI, wheel_inertia=4.0, driven_share=0.5)
    checks = {c.key: c for c in written(vehicle, there_laden_back_unladen(0.3)).checks}
    assert checks["wheel_slip_start_unladen"].demanded == pytest.approx(450 + 128 * 0.3 + 60.3315)


def test_a_slope_is_climbed_and_held():
    vehicle = TravelDrive.si(**SI, slope=0.05)
    found = loaded(vehicle, run((2, 0.5, 0), a=0.5))
    weight, rolling = 1500 * 9.81 * math.sin(0.05), 1500 * 9.81 * math.cos(0.05) * 0.0082
    assert found.cycle.torque[1] == pytest.approx((weight + rolling) * 0.125)
    assert found.statics.holding == pytest.approx(weight * 0.125)
    assert found.opposite is not None


def test_a_journal_thicker_than_its_wheel_is_refused_there():
    with pytest.raises(ValidationError) as caught:
        TravelDrive.model_validate({**TROLLEY, "journal_diameter_mm": 250})
    assert [error["loc"] for error in caught.value.errors()] == [("journal_diameter_mm",)]


VEHICLES = st.fixed_dictionaries(
    {
        "vehicle_mass": st.floats(10, 5000), "slope": st.floats(0, 0.3), "wind_force": st.floats(-500, 500),
        "friction_force": st.floats(0, 100), "wheel_diameter": st.floats(0.1, 1),
        "journal_diameter": st.floats(0, 0.09),
        "wheel_inertia": st.floats(0, 1), "stage_ratio": st.floats(0.5, 5), "stage_efficiency": st.floats(0.3, 1),
        "stage_inertia": st.floats(0, 0.1),
    }
).map(lambda values: {**values, "journal_diameter": values["journal_diameter"] + 1e-3})  # fmt: skip
MOVES = st.lists(st.tuples(st.floats(0.5, 2), st.floats(0.05, 1), st.floats(-100, 500)), min_size=1, max_size=3).map(
    lambda moves: run(*moves, *[(-s, v, force) for s, v, force in moves], m=50.0)
)


@FEW
@given(VEHICLES, MOVES, st.sampled_from(["eta", "sew"]))
def test_power_balances(values: dict[str, Any], motion: MotionProfile, model: str):
    found = loaded(TravelDrive.si(**values), motion, regeneration=model).cycle
    m, r, way = values["vehicle_mass"] + 50, values["wheel_diameter"] / 2, np.sign(motion.mean_speed)
    arm = 0.005 * values["journal_diameter"] / 2 + 0.0005
    rolling = m * 9.81 * math.cos(values["slope"]) * (arm / r + 0.003)
    force = m * 9.81 * math.sin(values["slope"]) + values["wind_force"] + (rolling + values["friction_force"]) * way
    force = force + motion.process_force * motion.direction + (m + values["wheel_inertia"] / r**2) * motion.acceleration
    power, eta = force * motion.mean_speed, values["stage_efficiency"]
    power = np.where(power > 0, power / eta, power * (eta if model == "eta" else max(2 - 1 / eta, 0)))
    own = values["stage_inertia"] * (values["stage_ratio"] / r) ** 2 * motion.acceleration * motion.mean_speed
    np.testing.assert_allclose(found.torque * found.mean_speed, power + own, rtol=1e-9, atol=1e-6)


@FEW
@given(VEHICLES, MOVES, st.integers(2, 5))
def test_mirror_and_split(values: dict[str, Any], motion: MotionProfile, pieces: int):
    level = TravelDrive.si(**{**values, "slope": 0.0, "wind_force": 0.0})
    laws.mirrored_motion_mirrors_the_torques(level, motion, "eta")
    laws.splitting_changes_nothing(TravelDrive.si(**values), motion, pieces)


def test_the_drawing_carries_symbols_of_fields():
    laws.drawing_shows_fields(
        [TravelDrive], TravelDrive.drawing, {"m_0", "alpha", "D", "d_j", "f", "mu_0", "i_2", "F_w"}
    )


def test_it_is_found_by_its_kind():
    assert mechanisms()["travel_drive"] is TravelDrive
