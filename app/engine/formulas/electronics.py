"""Electronics of several axes: currents, losses, heat sink, DC link."""

from app.engine.formula import formula, total
from app.engine.units import (
    Ampere,
    Joule,
    Kelvin,
    KelvinPerWatt,
    NewtonMetre,
    NewtonMetrePerAmpere,
    One,
    Second,
    Watt,
    WattPerAmpere,
)


@formula(symbol="I_mean", unit="A", source="SEW 2001, 16.5: mean current of an axis module")
def mean_current(M_mean: NewtonMetre, k_T: NewtonMetrePerAmpere) -> Ampere:
    """Mean of the unsigned current of a servomotor over its cycle.

    ``M_mean`` mean of the unsigned torque, ``k_T`` torque constant.

    >>> mean_current(2.0, 4.0)
    0.5
    """
    return M_mean / k_T


@formula(symbol="I_sum", unit="A", source="SEW 2001, 16.5: all axes at the same time, on the safe side")
def sum_of_currents(I_k: Ampere) -> Ampere:
    """Sum of the currents of several axes.

    ``I_k`` current of each axis.

    >>> sum_of_currents([1.0, 2.0])
    3.0
    """
    return total(I_k)


@formula(symbol="P_V", unit="W", source="SEW 2001, 16.5: losses by the effective current")
def module_losses(k_V: WattPerAmpere, I: Ampere) -> Watt:
    """Losses of an axis module or a supply module.

    ``k_V`` losses per ampere, ``I`` effective current; of a supply module that of all its axes.

    >>> module_losses(14.0, 1.5)
    21.0
    """
    return k_V * I


@formula(symbol="P_V(S)", unit="W", source="SEW 2001, 16.5: switched-mode supply of all modules")
def switch_mode_losses(P_1: Watt, P_2: Watt, n_M: One) -> Watt:
    """Losses of the switched-mode power supply.

    ``P_1`` losses without axes, ``P_2`` losses of each axis, ``n_M`` number of axes.

    >>> switch_mode_losses(12.0, 13.0, 2)
    38.0
    """
    return P_1 + P_2 * n_M


@formula(symbol="P_KK", unit="W", source="SEW 2001, 16.5: half of the switched-mode losses reach the heat sink")
def heat_sink_losses(P_k: Watt, P_1: Watt, k_s: One) -> Watt:
    """Losses that a heat sink must carry away.

    ``P_k`` losses of supply and axis modules, ``P_1`` losses of the switched-mode supply, ``k_s`` share of those that
    reaches the heat sink.

    >>> heat_sink_losses([6.0, 21.0, 15.0], 38.0, 0.5)
    61.0
    """
    return total(P_k) + k_s * P_1


@formula(symbol="d_theta", unit="1", source="SEW 2001, 16.5: temperature rise of the heat sink in kelvin")
def heat_sink_rise(P: Watt, R_th: KelvinPerWatt) -> One:
    """Temperature rise of a heat sink over the ambient air, in kelvin.

    ``P`` losses, ``R_th`` thermal resistance.

    >>> heat_sink_rise(60.0, 0.4)
    24.0
    """
    return P * R_th


@formula(symbol="theta_amb", unit="degC", source="SEW 2001, 16.5: hottest ambient air of a heat sink")
def permitted_ambient(theta_2: Kelvin, d_theta: One) -> Kelvin:
    """Hottest ambient air.

    ``theta_2`` permitted temperature of the heat sink, ``d_theta`` its rise in kelvin.

    >>> permitted_ambient(353.15, 20.0)
    333.15
    """
    return theta_2 - d_theta


@formula(symbol="TE", unit="1", source="SEW 2001, 16.5: width of all modules in units of the rack")
def module_width(n_k: One) -> One:
    """Width of all modules together.

    ``n_k`` width of each module, supply module included.

    >>> module_width([3.0, 2.0, 2.0])
    7.0
    """
    return total(n_k)


@formula(symbol="P_mean", unit="W", source="derived: energy that all axes take over the time of a cycle")
def mean_motoring_power(W_k: Joule, t_cyc: Second) -> Watt:
    """Mean power that the supply gives while axes drive, nothing exchanged between them.

    ``W_k`` energy that each axis takes in a cycle, ``t_cyc`` length of the cycle.

    >>> mean_motoring_power([600.0, 400.0], 4.0)
    250.0
    """
    return total(W_k) / t_cyc
