"""Wheels on rails: rolling resistance and what they can transmit before they slip."""

from app.engine.formula import cos, formula
from app.engine.units import Kilogram, Metre, MetrePerSecond2, Newton, One, Rad


@formula(symbol="F_F", unit="N", source="SEW 2001, 7.4: resistance to vehicular motion")
def rolling_resistance(
    m: Kilogram, g: MetrePerSecond2, alpha: Rad, D: Metre, mu_L: One, d_j: Metre, f: Metre, c: One
) -> Newton:
    """Resistance of a wheeled load: bearing, rolling and rim friction; unsigned, it opposes the motion.

    ``m`` mass on the wheels, ``g`` gravity, ``alpha`` slope, ``D`` wheel diameter, ``mu_L`` coefficient of bearing
    friction, ``d_j`` journal diameter, ``f`` lever arm of rolling friction, ``c`` share of rim and flange friction.
    Independent of the number of wheels.

    >>> round(rolling_resistance(3000.0, 9.81, 0.0, 0.25, 0.005, 0.06, 0.0005, 0.003), 3)  # 29430 * 0.0082
    241.326
    """
    return m * g * cos(alpha) * (2 / D * (mu_L * d_j / 2 + f) + c)


@formula(symbol="F_R", unit="N", source="SEW 2001, 8.1: static friction of the driven wheels")
def adhesion_force(mu_0: One, k_d: One, m: Kilogram, g: MetrePerSecond2, alpha: Rad) -> Newton:
    """Largest force that the driven wheels transmit before they slip.

    ``mu_0`` static friction between wheel and rail, ``k_d`` share of the weight on driven wheels, 0 to 1, ``m`` mass on
    all wheels, ``g`` gravity, ``alpha`` slope.

    >>> round(adhesion_force(0.15, 0.5, 1500.0, 9.81, 0.0), 3)
    1103.625
    """
    return mu_0 * k_d * m * g * cos(alpha)


@formula(symbol="a_p", unit="m/s2", source="SEW 2001, 8.1: permissible acceleration")
def slip_acceleration(mu_0: One, k_d: One, g: MetrePerSecond2, alpha: Rad) -> MetrePerSecond2:
    """Acceleration at which the driven wheels slip, other forces than inertia left out.

    ``mu_0`` static friction between wheel and rail, ``k_d`` share of the weight on driven wheels, ``g`` gravity,
    ``alpha`` slope. It does not depend on the mass.

    >>> round(slip_acceleration(0.15, 0.5, 9.81, 0.0), 5)
    0.73575
    """
    return mu_0 * k_d * g * cos(alpha)


@formula(symbol="a_p", unit="m/s2", source="derived: the driven wheels also pull the others while starting")
def starting_slip_acceleration(F_R: Newton, F_T: Newton, m: Kilogram) -> MetrePerSecond2:
    """Acceleration at which the driven wheels slip while starting, with the resistance of the other wheels.

    ``F_R`` force that the driven wheels transmit, ``F_T`` resistance of the wheels that are not driven, ``m`` mass on
    all wheels.

    >>> round(starting_slip_acceleration(2207.25, 120.663, 3000.0), 6)
    0.695529
    """
    return (F_R - F_T) / m


@formula(symbol="a_p", unit="m/s2", source="derived: the other wheels help to brake")
def braking_slip_deceleration(F_R: Newton, F_T: Newton, m: Kilogram) -> MetrePerSecond2:
    """Deceleration at which the driven wheels slip while braking, with the resistance of the other wheels.

    ``F_R`` force that the driven wheels transmit, ``F_T`` resistance of the wheels that are not driven, ``m`` mass on
    all wheels.

    >>> round(braking_slip_deceleration(2207.25, 120.663, 3000.0), 6)
    0.775971
    """
    return (F_R + F_T) / m


@formula(symbol="F_T", unit="N", source="derived: the driven wheels overcome their own resistance at their bearings")
def trailing_resistance(F_F: Newton, k_d: One) -> Newton:
    """Resistance of the wheels that are not driven, which the driven ones must transmit to the rail.

    ``F_F`` resistance of all wheels, ``k_d`` share of the weight on driven wheels.

    >>> trailing_resistance(120.0, 0.5)
    60.0
    """
    return F_F * (1 - k_d)
