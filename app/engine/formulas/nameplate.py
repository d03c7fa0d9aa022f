"""Electrical side of an induction motor: slip, power, tolerances, winding temperature."""

from app.engine.formula import formula, sqrt
from app.engine.units import Ampere, Kelvin, Ohm, One, RadPerSecond, Volt, Watt


@formula(symbol="S", unit="%", source="SEW 2001, 2.1: slip")
def slip(n_S: RadPerSecond, n_N: RadPerSecond) -> One:
    """Slip of an induction motor.

    ``n_S`` synchronous and ``n_N`` rated speed.

    >>> slip(1500.0, 1440.0)
    0.04
    """
    return (n_S - n_N) / n_S


@formula(symbol="P_app", unit="W", source="SEW 2001, 2.1: apparent power with line voltage and line current")
def apparent_power(U_1: Volt, I: Ampere) -> Watt:
    """Apparent power of a three-phase motor.

    ``U_1`` line voltage, ``I`` line current.

    >>> round(apparent_power(400.0, 10.0), 1)
    6928.2
    """
    return sqrt(3) * U_1 * I


@formula(symbol="P_1", unit="W", source="SEW 2001, 2.1: active power")
def active_power(P_app: Watt, cos_phi: One) -> Watt:
    """Electrical power that a motor takes.

    ``P_app`` apparent power, ``cos_phi`` power factor.

    >>> active_power(1000.0, 0.8)
    800.0
    """
    return P_app * cos_phi


@formula(symbol="P_N", unit="W", source="SEW 2001, 2.1: power at the shaft")
def power_at_shaft(P_1: Watt, eta: One) -> Watt:
    """Power at the shaft of a motor.

    ``P_1`` electrical power, ``eta`` efficiency of the motor.

    >>> power_at_shaft(1000.0, 0.85)
    850.0
    """
    return P_1 * eta


@formula(symbol="eta", unit="1", source="derived: shaft power over electrical power")
def motor_efficiency(P_N: Watt, P_1: Watt) -> One:
    """Efficiency of a motor from its name plate.

    ``P_N`` rated power, ``P_1`` electrical power.

    >>> motor_efficiency(850.0, 1000.0)
    0.85
    """
    return P_N / P_1


@formula(symbol="d_eta", unit="1", source="IEC 60034-1: tolerance of the efficiency")
def efficiency_tolerance(k_tol: One, eta: One) -> One:
    """Permitted deviation of the efficiency.

    ``k_tol`` 0.15 up to 50 kW (150 kW in later editions), 0.1 above, ``eta`` rated efficiency.

    >>> round(efficiency_tolerance(0.15, 0.85), 4)
    -0.0225
    """
    return -k_tol * (1 - eta)


@formula(symbol="d_cos", unit="1", source="IEC 60034-1: tolerance of the power factor")
def power_factor_tolerance(cos_phi: One) -> One:
    """Permitted deviation of the power factor.

    ``cos_phi`` rated power factor.

    >>> round(power_factor_tolerance(0.82), 4)
    -0.03
    """
    return -(1 - cos_phi) / 6


@formula(symbol="theta_2", unit="degC", source="IEC 60034-1: resistance method, copper")
def winding_temperature(R_1: Ohm, R_2: Ohm, theta_1: Kelvin) -> Kelvin:
    """Temperature of a winding from its resistance.

    ``R_1`` resistance when cold, ``R_2`` when warm, ``theta_1`` temperature when cold. The constant is 235 K above
    0 degrees Celsius, 38.15 K as an absolute temperature.

    >>> round(winding_temperature(10.0, 13.5, 293.15) - 273.15, 2)
    109.25
    """
    return (R_2 - R_1) / R_1 * (theta_1 - 38.15) + theta_1


@formula(symbol="d_theta", unit="1", source="IEC 60034-1: rise over the coolant at the end of the test")
def winding_temperature_rise(theta_2: Kelvin, theta_a2: Kelvin) -> One:
    """Temperature rise of a winding in kelvin.

    ``theta_2`` temperature of the winding, ``theta_a2`` of the coolant at the end of the test.

    >>> round(winding_temperature_rise(382.4, 298.15), 2)
    84.25
    """
    return theta_2 - theta_a2
