import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.reports.numbers import in_unit, number, percent, rounded, show, superscript, unit_text


@pytest.mark.parametrize(
    ("value", "shown"),
    [
        (0.0, "0"), (-0.0, "0"), (9.81, "9.81"), (163.84049, "163.84"), (1388.6172, "1388.6"), (12345.6, "12346"),
        (423612.7, "423613"), (999999.4, "999999"), (999999.7, "1000000"), (1e6, "1·10⁶"), (2.1e11, "2.1·10¹¹"),
        (0.00012345678, "0.00012346"), (0.0000999994, "9.9999·10⁻⁵"), (9.999999, "10"), (1 / 3, "0.33333"),
        (-78.5, "−78.5"), (99999.96, "100000"),
        (-1.5e-9, "−1.5·10⁻⁹"), (math.inf, "∞"), (-math.inf, "−∞"), (math.nan, "–"), (7, "7"),
        (5e-324, "4.9407·10⁻³²⁴"),
    ],
)  # fmt: skip
def test_a_number_keeps_five_significant_digits(value: float, shown: str) -> None:
    assert number(value) == shown


@given(st.floats(allow_nan=False, allow_infinity=False).filter(lambda v: v == 0 or 1e-300 < abs(v) < 1e300))
def test_a_shown_number_differs_by_rounding_only(value: float) -> None:
    made = rounded(value)
    back = float(made.mantissa.replace("−", "-")) * 10.0 ** (made.exponent or 0)
    assert back == pytest.approx(value, rel=0.5001e-4)


@pytest.mark.parametrize(
    ("unit", "shown"),
    [
        ("kg m2", "kg·m²"), ("kg cm2", "kg·cm²"), ("m/s2", "m/s²"), ("N/um", "N/µm"), ("N m/rad", "N·m/rad"), ("1", ""),
        ("%", "%"), ("deg", "°"), ("degC", "°C"), ("1/s", "1/s"), ("s-1", "s⁻¹"), ("N s/m", "N·s/m"), ("mm", "mm"),
        ("m rad/s", "m·rad/s"), ("kg/m3", "kg/m³"), ("ohm", "Ω"), ("arcmin", "arcmin"), ("°C", "°C"), ("µm", "µm"),
    ],
)  # fmt: skip
def test_a_unit_is_typeset(unit: str, shown: str) -> None:
    assert unit_text(unit) == shown


@pytest.mark.parametrize(
    ("si", "unit", "shown"),
    [
        (163.8, "Hz", "163.8 Hz"),
        (4.236e8, "N/um", "423.6 N/µm"),
        (157.07963267949, "rpm", "1500 rpm"),
        (math.pi / 6, "deg", "30°"),
        (0.00125, "kg cm2", "12.5 kg·cm²"),
        (0.92, "%", "92 %"),
        (0.8, "1", "0.8"),
        (None, "N m", "–"),
        ([0.001, 0.25], "mm", "[1; 250] mm"),
    ],
)
def test_a_quantity_is_shown_in_its_unit(si: object, unit: str, shown: str) -> None:
    assert show(si, unit) == shown


def test_lists_are_converted_item_by_item() -> None:
    assert in_unit([0.001, 0.002], "mm") == [1.0, 2.0]


@pytest.mark.parametrize(
    ("share", "shown"),
    [
        (0.0, "0 %"), (0.5, "50 %"), (0.8374, "83.7 %"), (1.0, "100 %"), (1 + 1e-10, "100 %"), (1.00001, "100.1 %"),
        (0.99999, "99.9 %"), (1.05, "105 %"), (12.0, "1200 %"), (math.inf, "∞"), (None, "–"),
    ],
)  # fmt: skip
def test_a_utilisation_is_never_rounded_across_its_limit(share: float | None, shown: str) -> None:
    assert percent(share) == shown


def test_raised_digits() -> None:
    assert superscript(-1234567890) == "⁻¹²³⁴⁵⁶⁷⁸⁹⁰"
