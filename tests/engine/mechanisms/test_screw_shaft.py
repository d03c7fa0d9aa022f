"""Screw and bearings: checks of stiffness, speed and buckling, self-locking, refusals."""

import math
from typing import Any

import pytest
from pydantic import ValidationError

from app.engine.mechanisms.ball_screw import BallScrew
from app.engine.sheet import Check, Sheet, Verdict
from tests.engine.mechanisms.screw_cases import LACHMAN, PLAIN, ROUND_TRIP, RPM, load


def check(sheet: Sheet, key: str) -> Check:
    return next(item for item in sheet.checks if item.key == key)


def test_missing_data_leave_a_check_open_and_are_named():
    _, sheet = load(PLAIN, ROUND_TRIP)
    missing = {item.key: item.missing for item in sheet.checks if item.verdict is Verdict.NOT_CHECKED}
    assert missing.keys() == {
        *("dn_factor", "screw_speed", "critical_speed", "buckling", "natural_frequency", "lost_motion"),
    }
    assert "root diameter" in missing["critical_speed"]
    for part in ("loaded turns", "thrust bearing", "largest length under load"):
        assert part in missing["natural_frequency"]


@pytest.mark.parametrize(
    ("change", "key", "verdict"),
    [
        ({"lead_mm": 10}, "dn_factor", Verdict.FAILS),  # 50 mm * 3000 rpm = 150000 > 120000
        ({"lead_mm": 20}, "dn_factor", Verdict.OK),
        ({"permitted_speed_rpm": 1600}, "screw_speed", Verdict.TIGHT),
        ({"natural_frequency_limit_hz": 170}, "natural_frequency", Verdict.FAILS),  # 163.8 Hz
        ({"lost_motion_limit_um": 1.8}, "lost_motion", Verdict.FAILS),  # 1.888 um
        ({"root_diameter_mm": 44, "nut_stiffness_n_um": 800}, "natural_frequency", Verdict.OK),
    ],
)
def test_limits(change: dict[str, Any], key: str, verdict: Verdict):
    assert check(load({**LACHMAN, **change}, ROUND_TRIP)[1], key).verdict is verdict


def test_critical_speed_and_buckling_by_mounting():
    slim = {**PLAIN, "root_diameter_mm": 20, "length_mm": 2500, "stressed_length_mm": 2000}
    _, sheet = load({**slim, "mounting": "fixed_free"}, ROUND_TRIP)
    # 1.875^2 * 0.02 / (4 * 6.25) * sqrt(2.1e11 / 7850) = 14.547 rad/s, of which 0.8 = 111.1 rpm
    assert check(sheet, "critical_speed").permitted == pytest.approx(111.1 * RPM, rel=1e-3)
    # 0.25 * pi^3 * 2.1e11 * 1.6e-7 / (64 * 4) = 1017.4 N, half of it is permitted; demanded 400 * 5 + 10000 N
    assert check(sheet, "buckling").permitted == pytest.approx(508.7, rel=1e-3)
    assert check(sheet, "buckling").demanded == pytest.approx(12000)
    assert check(sheet, "buckling").verdict is Verdict.FAILS
    _, sheet = load({**slim, "mounting": "fixed_fixed"}, ROUND_TRIP)
    assert check(sheet, "buckling").permitted == pytest.approx(16 * 508.7, rel=1e-3)


@pytest.mark.parametrize(
    ("mounting", "bearings", "shaft"),
    [  # 4 E S / l with thrust at both ends, E S / x with thrust at one end: N/um
        ("fixed_fixed", 2000, 1649.336143),
        ("supported_supported", 2000, 1649.336143),
        ("fixed_supported", 1000, 763.5815477),
        ("fixed_free", 1000, 763.5815477),
    ],
)
def test_thrust_at_one_or_both_ends_by_mounting(mounting: str, bearings: float, shaft: float):
    _, sheet = load({**LACHMAN, "mounting": mounting}, ROUND_TRIP)
    assert sheet.value("bearing_stiffness_total") == pytest.approx(bearings * 1e6)
    assert sheet.value("screw_tension_stiffness") == pytest.approx(shaft * 1e6)


@pytest.mark.parametrize(
    ("change", "environment", "said"),
    [
        ({"efficiency": 0.45}, {"regeneration": "sew"}, {"The screw is self-locking"}),
        ({"efficiency": 0.55}, {"regeneration": "sew"}, set()),
        ({"efficiency": 0.45}, {"regeneration": "eta"}, set()),
        ({"efficiency": 0.9, "friction_force_n": 4000}, {}, {"Friction alone holds the axis"}),
    ],
)
def test_self_locking(change: dict[str, Any], environment: dict[str, Any], said: set[str]):
    axis = {**PLAIN, "inclination_deg": 90, **change}
    _, sheet = load(axis, ROUND_TRIP, **environment)
    assert {item.text for item in sheet.decisions if "lock" in item.text or "holds" in item.text} == said


def test_a_steep_lead_is_not_self_locking_and_a_flat_one_is():
    # tan(phi) = h / (pi D): 2 mm on 50 mm gives 0.0127, 20 mm gives 0.127; thread friction 0.1
    axis = {key: value for key, value in PLAIN.items() if key != "efficiency"}
    for lead, locked in ((2, True), (20, False)):
        _, sheet = load({**axis, "lead_mm": lead, "inclination_deg": 90, "thread_friction": 0.1}, ROUND_TRIP)
        assert ("The screw is self-locking" in {item.text for item in sheet.decisions}) is locked
        tangent = lead / (math.pi * 50)
        assert sheet.value("efficiency") == pytest.approx(tangent * (1 - 0.1 * tangent) / (tangent + 0.1))


@pytest.mark.parametrize(
    ("change", "field"),
    [
        ({"length_mm": None}, "length_mm"),
        ({"root_diameter_mm": 51}, "root_diameter_mm"),
        ({"stressed_length_mm": 1001}, "stressed_length_mm"),
        ({"counterweight_mass_kg": 100}, "counterweight_mass_kg"),
        ({"thread_friction": 0.1}, "thread_friction"),
        ({"screw_friction": "diameter_rule", "screw_friction_torque_nm": 2}, "screw_friction_torque_nm"),
        ({"slide_mass_kg": -1}, "slide_mass_kg"),
        ({"lead_mm": 0}, "lead_mm"),
        ({"efficiency": 1.2}, "efficiency"),
        ({"inclination_deg": 91}, "inclination_deg"),
    ],
)
def test_an_impossible_axis_is_refused_at_its_field(change: dict[str, Any], field: str):
    with pytest.raises(ValidationError) as caught:
        BallScrew.model_validate({**PLAIN, **change})
    assert [error["loc"] for error in caught.value.errors()] == [(field,)]


def test_only_defaults_that_count_are_assumed():
    taken = {name for name, _, _ in BallScrew.model_validate(PLAIN).defaults_taken()}
    assert "shear_modulus" not in taken  # no stiffness is computed
    assert "friction_coefficient" not in taken  # there is no such friction
    assert "density" in taken
    assert "friction_coefficient" in {
        name for name, _, _ in BallScrew.model_validate({**PLAIN, "friction_model": "normal_force"}).defaults_taken()
    }
