"""Braking energy and braking resistors."""

from app.engine.formula import formula, log, total
from app.engine.units import Joule, One, Second, Watt


@formula(symbol="W", unit="J", source="derived: power runs straight through a segment of constant torque")
def braking_energy(P_1: Watt, P_2: Watt, t: Second) -> Joule:
    """Energy that a segment returns.

    ``P_1`` and ``P_2`` returned power at its ends, unsigned, ``t`` its duration.

    >>> braking_energy(0.0, 100.0, 2.0)
    100.0
    """
    return (P_1 + P_2) / 2 * t


@formula(symbol="W_c", unit="J", source="SEW 2001, 9.2: every segment that returns power")
def braking_energy_of_cycle(W_k: Joule) -> Joule:
    """Energy that a whole cycle returns.

    ``W_k`` energy of each segment that returns power.

    >>> braking_energy_of_cycle([100.0, 50.0])
    150.0
    """
    return total(W_k)


@formula(symbol="P_B", unit="W", source="SEW 2001, 9.2: mean over the time of braking")
def mean_braking_power(W_c: Joule, t_on: Second) -> Watt:
    """Mean braking power while power is returned, or over another time.

    ``W_c`` energy returned in a cycle, ``t_on`` time in which it is returned.

    >>> mean_braking_power(3400.0, 6.8)
    500.0
    """
    return W_c / t_on


@formula(symbol="P_perm", unit="W", source="derived: straight line between two ratings in double logarithmic scales")
def interpolated_rating(P_1: Watt, P_2: Watt, ED_1: One, ED_2: One, ED: One) -> Watt:
    """Permitted power of a resistor between two listed duties.

    ``P_1`` rating at the lower duty ``ED_1``, ``P_2`` at the higher duty ``ED_2``, ``ED`` duty between them.

    >>> round(interpolated_rating(1200.0, 600.0, 0.12, 0.25, 0.25), 6)
    600.0
    """
    return P_1 * (P_2 / P_1) ** (log(ED / ED_1) / log(ED_2 / ED_1))


@formula(symbol="P_max", unit="W", source="SEW 2001, 9.2: largest braking power of all states")
def peak_braking_power(P: Watt) -> Watt:
    """Largest power that is returned, unsigned.

    ``P`` power in the state that decides, negative where it is returned.

    >>> peak_braking_power(-300.0)
    300.0
    """
    return abs(P)


@formula(symbol="P_sum", unit="W", source="SEW 2001, 16.5: mean powers of all ramps added up")
def sum_of_powers(P_k: Watt) -> Watt:
    """Sum of several powers: the mean powers of all braking ramps, as if they came at once.

    ``P_k`` powers.

    >>> sum_of_powers([100.0, 200.0])
    300.0
    """
    return total(P_k)
