"""A small calculation with everything a sheet can hold, and formulas of its own that no real calculation uses."""

from typing import Any

from app.engine.formula import Formula, formula, pi, sqrt, total, where
from app.engine.sheet import Sheet
from app.engine.units import (
    Hertz,
    Kilogram,
    KilogramMetre2,
    Metre,
    MetrePerSecond2,
    Newton,
    NewtonMetre,
    NewtonMetrePerRad,
    One,
    Second,
)


@formula(symbol="F_F", unit="N", source="test: rolling, bearing and rim friction")
def sample_rolling_resistance(
    m: Kilogram, g: MetrePerSecond2, D: Metre, mu_L: One, d: Metre, f: Metre, c: One
) -> Newton:
    """Resistance of a wheeled load.

    ``m`` mass, ``D`` wheel, ``d`` bearing; holds on <dry> rails & small ``slip_angle``.

    Raises RangeError never.

    >>> 1 + 1
    2
    """
    return m * g * (2 / D * (mu_L * d / 2 + f) + c)


@formula(symbol="M_eff", unit="N m", source="test")
def sample_effective_torque(M_k: NewtonMetre, t_k: Second) -> NewtonMetre:
    """Effective torque of a cycle."""
    t_c = total(t_k)
    return sqrt(total(M_k**2 * t_k) / t_c)


@formula(symbol="f_0", unit="Hz", source="test")
def sample_natural_frequency(c_T: NewtonMetrePerRad, J: KilogramMetre2, zeta: One = 0.0) -> Hertz:
    """Natural frequency of one inertia on a spring."""
    omega_0 = sqrt(c_T / J)
    return omega_0 * sqrt(1 - zeta**2) / (2 * pi)


@formula(symbol="M_1", unit="N cm", source="test")
def sample_through_stage(M: NewtonMetre, eta: One) -> NewtonMetre:
    """Torque before a stage, by direction of power."""
    return where(M > 0, M / eta, M * eta)


def inputs_of(formula: Formula[..., Any]) -> dict[str, Any]:
    """Numbers without a pattern, all different; lists where the name tells that there are several."""
    return {
        name: [0.71 / (n + 1), 0.37, 0.11 * (n + 2)] if name.endswith("_k") else 0.9173 / (n + 1) ** 0.5
        for n, name in enumerate(formula.parameters)
    }


ROLLING = {"m": 400.0, "g": 9.81, "D": 0.25, "mu_L": 0.005, "d": 0.06, "f": 0.0005, "c": 0.003}
# 400 * 9.81 * (8 * (0.005 * 0.03 + 0.0005) + 0.003) = 3924 * 0.0082 = 32.1768 N


def sample_sheet() -> Sheet:
    """Steps in two sections, a decision between steps, assumptions of every kind, a check of every verdict."""
    sheet = Sheet()
    with sheet.section("Resistance"):
        sheet(sample_rolling_resistance, **ROLLING)
        sheet.decide("Rolling friction only", "the rail is level & <dry>")
        sheet(sample_through_stage, M=-2.0, eta=0.9, key="back", symbol="M_b", label="Torque going back", unit="N m")
    with sheet.section("Cycle"):
        sheet(sample_effective_torque, M_k=[4.0, -2.0, 0.0], t_k=[1.0, 1.0, 2.0])
        sheet(sample_natural_frequency, c_T=5000.0, J=0.0031)
    sheet.assume("friction", "rim friction", value=0.003, symbol="c", source="test")
    sheet.assume("mount", "mounting", value="fixed_free")
    sheet.assume("horizontal", "level rail", value=True)
    sheet.assume("wheel", "wheel diameter", value=0.25, unit="mm", symbol="D")
    source = "data sheet <p. 3>"
    sheet.check("torque", "Effective torque", 2.236, 5.0, "N m", source, formula="sample_effective_torque")
    sheet.check("peak", "Peak torque", 4.5, 5.0, "N m", source)
    sheet.check("speed", "Speed", 314.159265358979, 157.07963267949, "rpm", source)
    sheet.check("shaft", "Radial force", 100.0, None, "N", "", missing="permitted radial force")
    return sheet
