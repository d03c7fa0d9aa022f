"""Fans and centrifugal pumps: power of a flow, and the laws of affinity."""

from app.engine.formula import formula, maximum, sqrt
from app.engine.units import (
    CubicMetrePerSecond,
    KilogramPerMetre3,
    Metre,
    MetrePerSecond2,
    NewtonMetre,
    One,
    Pascal,
    RadPerSecond,
    Watt,
)


@formula(symbol="P_W", unit="kW", source="derived: pressure times volume flow over efficiency")
def fan_power(Q: CubicMetrePerSecond, p_t: Pascal, eta_F: One) -> Watt:
    """Power at the shaft of a fan.

    ``Q`` volume flow, ``p_t`` total pressure, ``eta_F`` efficiency of the fan.

    >>> fan_power(5.0, 1200.0, 0.75)
    8000.0
    """
    return Q * p_t / eta_F


@formula(symbol="P_W", unit="kW", source="derived: weight lifted per time over efficiency")
def pump_power(Q: CubicMetrePerSecond, H: Metre, rho: KilogramPerMetre3, g: MetrePerSecond2, eta_P: One) -> Watt:
    """Power at the shaft of a pump.

    ``Q`` volume flow, ``H`` head, ``rho`` density, ``g`` gravity, ``eta_P`` efficiency of the pump.

    >>> round(pump_power(0.02, 30.0, 1000.0, 9.81, 0.75), 6)
    7848.0
    """
    return rho * g * Q * H / eta_P


@formula(symbol="M(n)", unit="N m", source="law of affinity: torque with the square of the speed, bearings apart")
def affine_torque(M_N: NewtonMetre, M_f: NewtonMetre, n: RadPerSecond, n_W: RadPerSecond) -> NewtonMetre:
    """Torque of a fan or of a pump without static head at another speed, unsigned.

    ``M_N`` torque at the speed ``n_W``, friction included, ``M_f`` friction of bearings and seals, ``n`` speed.

    >>> affine_torque(80.0, 2.0, 50.0, 100.0)
    21.5
    """
    return M_f + (M_N - M_f) * (n / n_W) ** 2


@formula(symbol="Q(n)", unit="m3/h", source="derived: law of affinity of the pump meets the curve of the system")
def flow_at_speed(
    Q: CubicMetrePerSecond, H_0: Metre, H_st: Metre, n: RadPerSecond, n_W: RadPerSecond
) -> CubicMetrePerSecond:
    """Flow of a pump at another speed; zero where its head does not reach the static head.

    ``Q`` flow at the speed ``n_W``, ``H_0`` head against a closed valve at that speed, ``H_st`` static head, ``n``
    speed.

    >>> round(flow_at_speed(0.02, 40.0, 0.0, 50.0, 100.0), 6)  # without static head in proportion
    0.01
    """
    return Q * sqrt(maximum(H_0 * (n / n_W) ** 2 - H_st, 0) / (H_0 - H_st))


@formula(symbol="H(n)", unit="m", source="derived: static head, and losses with the square of the flow")
def head_of_system(H_st: Metre, H: Metre, Q: CubicMetrePerSecond, Q_r: CubicMetrePerSecond) -> Metre:
    """Head that a system takes at a flow.

    ``H_st`` static head, ``H`` head at the flow ``Q_r``, ``Q`` flow.

    >>> head_of_system(10.0, 30.0, 0.01, 0.02)
    15.0
    """
    return H_st + (H - H_st) * (Q / Q_r) ** 2


@formula(symbol="M(n)", unit="N m", source="law of affinity; torque straight over the flow, as radial pumps have it")
def pump_torque(
    M_N: NewtonMetre, M_f: NewtonMetre, k_0: One, Q: CubicMetrePerSecond, Q_r: CubicMetrePerSecond, n: RadPerSecond,
    n_W: RadPerSecond,
) -> NewtonMetre:  # fmt: skip
    """Torque of a radial pump at another speed and flow, unsigned.

    ``M_N`` torque at the speed ``n_W`` and the flow ``Q_r``, friction included, ``M_f`` friction of bearings and seals,
    ``k_0`` torque against a closed valve over rated torque, ``Q`` flow, ``n`` speed.

    >>> round(pump_torque(100.0, 0.0, 0.4, 0.01, 0.02, 50.0, 100.0), 6)  # without static head: by the square
    25.0
    """
    return M_f + (M_N - M_f) * (k_0 * (n / n_W) ** 2 + (1 - k_0) * n / n_W * Q / Q_r)
