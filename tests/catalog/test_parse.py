"""Cells and headers of CSV files, whatever they hold."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.catalog.parse import CellError, read_cell, read_rows
from app.catalog.report import LoadReport
from app.catalog.schema import TABLES, HeaderCell, HeaderError

SERVO = TABLES["servo_motor"]
PEAK_TORQUE = SERVO.column("peak_torque_nm")


@given(st.floats(min_value=0.001, max_value=300_000))
def test_a_written_number_is_read_back_exactly(value: float):
    assert read_cell(repr(value), PEAK_TORQUE) == value


@given(st.text(max_size=12))
def test_a_cell_is_a_plausible_number_or_refused(text: str):
    try:
        value = read_cell(text.strip(), PEAK_TORQUE)
    except CellError:
        return
    assert value is None or 0.001 <= value <= 300_000


@given(st.binary(max_size=300))
def test_any_bytes_give_rows_or_findings(content: bytes):
    report = LoadReport()
    rows = read_rows(content, SERVO, "servo_motor.csv", report)
    assert rows == [] or report.ok
    assert rows or report.errors


@given(st.lists(st.sampled_from(["manufacturer,model,kind", "M,A,sync", ",,", '"', "M,A", "M,,sync"]), max_size=6))
def test_any_lines_give_rows_or_findings_with_their_line(lines: list[str]):
    report = LoadReport()
    read_rows("\n".join(lines).encode(), SERVO, "servo_motor.csv", report)
    for line in report.lines:
        assert 1 <= line.line <= max(1, len(lines) + 1)


@pytest.mark.parametrize(
    ("header", "column", "value", "expected"),
    [
        ("peak_torque_nm", "peak_torque_nm", "3.5", 3.5),
        ("peak_torque_ncm", "peak_torque_nm", "350", 3.5),
        ("peak_torque_knm", "peak_torque_nm", "0.0035", 3.5),
        ("peak_torque_lbfft", "peak_torque_nm", "2", 2.71163589666),  # 4.4482216152605 N * 0.3048 m, twice
        ("rated_power_w", "rated_power_kw", "750", 0.75),
        ("rated_power_hp", "rated_power_kw", "1", 0.745699871582),  # 550 ft lbf/s
        ("rotor_inertia_kgm2", "rotor_inertia_kgcm2", "0.0185", 185),
        ("rotor_inertia_gcm2", "rotor_inertia_kgcm2", "54", 0.054),
        ("rotor_inertia_with_brake_kgm2", "rotor_inertia_with_brake_kgcm2", "0.0185", 185),
        ("max_speed_rad_s", "max_speed_rpm", "314.159265358979", 3000),
        ("flange_size_in", "flange_size_mm", "2.25", 57.15),
        ("mass_g", "mass_kg", "54", 0.054),
    ],
)
def test_a_header_in_another_unit_converts(header: str, column: str, value: str, expected: float):
    cell = SERVO.column(header)
    assert cell.spec.name == column
    assert read_cell(value, cell) == pytest.approx(expected, rel=1e-11)


@pytest.mark.parametrize(
    "header",
    ["peak_torque_kg", "peak_torque_j", "mass_n", "max_speed_m_min", "rated_power_kva", "", "Model", "slug", "id"],
)
def test_a_header_that_means_nothing_is_refused(header: str):
    with pytest.raises(HeaderError):
        SERVO.column(header)


def test_a_choice_of_spelling_is_not_guessed():
    with pytest.raises(CellError, match="none of sync, async"):
        read_cell("Sync", SERVO.column("kind"))


def test_zero_backlash_is_a_value_and_an_empty_cell_is_none():
    backlash = TABLES["servo_gear_unit"].column("backlash_arcmin")
    assert read_cell("0", backlash) == 0
    assert read_cell("", backlash) is None
    assert isinstance(backlash, HeaderCell)
