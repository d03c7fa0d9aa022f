"""Currents of a motor and the servo drives that carry them."""

import pytest

from app.engine.inverter import Currents, record_currents, suggest_drives
from app.engine.products import ServoDrive
from app.engine.sheet import Sheet
from tests.engine.drives.cases import motor


def drive(name: str, continuous: float | None, peak: float | None) -> ServoDrive:
    return ServoDrive(
        id=name, manufacturer="", series="", model=name, source="", continuous_current=continuous, peak_current=peak
    )


def test_torque_constant_of_the_data_sheet_comes_first():
    found = record_currents(motor(torque_constant=2.0, stall_current=1.0), 6.0, 3.0, Sheet())
    assert (found.peak, found.effective) == (3.0, 1.5)


@pytest.mark.parametrize(("given", "constant"), [({"stall_current": 5.0}, 2.0), ({"rated_current": 2.0}, 4.0)])
def test_torque_per_current_of_a_continuous_point(given: dict[str, float], constant: float):
    # 10 N m at standstill, 8 N m at rated speed
    assert record_currents(motor(**given), 8.0, 4.0, Sheet()).effective == pytest.approx(4.0 / constant)


def test_saturation_raises_the_peak_current():
    # 10 N m at 5 A, 30 N m at 25 A: 20 N m lie half way, 15 A; proportional would be 10 A
    saturating = motor(stall_current=5.0, peak_current=25.0)
    assert record_currents(saturating, 20.0, 4.0, Sheet()).peak == pytest.approx(15.0)
    assert record_currents(saturating, 8.0, 4.0, Sheet()).peak == pytest.approx(4.0)


def test_without_any_current_nothing_is_guessed():
    found = record_currents(motor(), 8.0, 4.0, Sheet())
    assert (found.peak, found.effective) == (None, None)
    assert "torque constant" in found.missing


def test_drives_that_carry_both_currents_closest_fit_first():
    drives = [
        drive("large", 20, 60),
        drive("short", 20, 9),
        drive("weak", 2, 60),
        drive("fits", 5, 20),
        drive("half", 9, None),
    ]
    found = suggest_drives(Currents(peak=10.0, effective=3.0), drives)
    assert [one.drive.model for one in found] == ["fits", "large", "half"]
    assert found[0].utilisation == pytest.approx(0.6)  # 3 A of 5 A; 10 A of 20 A
    assert found[2].not_checked == ("drive_peak_current",)
