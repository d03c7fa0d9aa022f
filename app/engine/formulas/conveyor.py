"""Conveyors: chains on slideways, driven rollers, belts to DIN 22101."""

from app.engine.formula import cos, formula, pi, sin, total
from app.engine.units import (
    CubicMetre,
    Kilogram,
    KilogramPerMetre,
    KilogramPerMetre3,
    KilogramPerSecond,
    Metre,
    MetrePerSecond,
    MetrePerSecond2,
    Newton,
    One,
    Rad,
    SquareMetre,
)


@formula(symbol="F_S1", unit="N", source="SEW 2001, 10.1: sliding on an incline, carrying strand lifted, too")
def sliding_conveyor_resistance(m: Kilogram, m_K: Kilogram, mu: One, g: MetrePerSecond2, alpha: Rad) -> Newton:
    """Force that pulls goods and the carrying strand of a chain up an incline.

    ``m`` goods, ``m_K`` chain of the carrying strand, ``mu`` friction on the slideway, ``g`` gravity, ``alpha``
    inclination.

    >>> round(sliding_conveyor_resistance(2000.0, 150.0, 0.2, 9.81, 0.0872664626), 2)
    6040.49
    """
    return (m + m_K) * g * (sin(alpha) + mu * cos(alpha))


@formula(symbol="F_S1", unit="N", source="derived: the weights of both strands of a closed loop cancel")
def balanced_conveyor_resistance(m: Kilogram, m_K: Kilogram, mu: One, g: MetrePerSecond2, alpha: Rad) -> Newton:
    """The same where the return strand hangs back down: its weight balances that of the carrying strand.

    ``m`` goods, ``m_K`` chain of the carrying strand, ``mu`` friction on the slideway, ``g`` gravity, ``alpha``
    inclination.

    >>> round(balanced_conveyor_resistance(2000.0, 150.0, 0.2, 9.81, 0.0872664626), 2)
    5912.24
    """
    return m * g * sin(alpha) + mu * (m + m_K) * g * cos(alpha)


@formula(symbol="F_S2", unit="N", source="SEW 2001, 10.1: goods held at a stop while the chain runs on")
def blocked_goods_resistance(m_b: Kilogram, mu_b: One, g: MetrePerSecond2, alpha: Rad) -> Newton:
    """Additional force while goods are held at a stop: friction on the chain instead of their own weight.

    ``m_b`` goods that are held, ``mu_b`` friction between goods and chain, ``g`` gravity, ``alpha`` inclination.

    >>> round(blocked_goods_resistance(500.0, 0.7, 9.81, 0.0872664626), 2)
    2992.94
    """
    return m_b * g * (mu_b * cos(alpha) - sin(alpha))


@formula(symbol="eta_2", unit="1", source="SEW 2001, 11.1: every full wrap of a chain costs its efficiency")
def wraps_efficiency(eta: One, x_w: One) -> One:
    """Efficiency of chains one after another; a bound, since it puts the whole load at the end.

    ``eta`` efficiency of one wrap, ``x_w`` number of full wraps.

    >>> round(wraps_efficiency(0.9, 7), 6)
    0.478297
    """
    return eta**x_w


@formula(symbol="eta_2", unit="1", source="derived: roller k is reached through k wraps, each takes its share")
def distributed_wraps_efficiency(n_R: One, eta_k: One) -> One:
    """Efficiency of a row of rollers with a chain from each to the next, the load spread over all rollers.

    ``n_R`` number of rollers, ``eta_k`` efficiency between the drive and each of them, 1 for the first.

    >>> round(distributed_wraps_efficiency(3, [1.0, 0.9, 0.81]), 6)
    0.896679
    """
    return n_R / total(1 / eta_k)


@formula(symbol="V", unit="mm3", source="derived: volume of a tube")
def tube_volume(D: Metre, D_i: Metre, l: Metre) -> CubicMetre:
    """Volume of a tube or, with an inner diameter of zero, of a bar.

    ``D`` outer and ``D_i`` inner diameter, ``l`` length.

    >>> round(tube_volume(0.089, 0.04, 1.5) * 1e9)
    7446753
    """
    return pi / 4 * (D**2 - D_i**2) * l


@formula(symbol="m", unit="kg", source="derived: volume times density")
def mass_of_volume(V: CubicMetre, rho: KilogramPerMetre3) -> Kilogram:
    """Mass of a body.

    ``V`` volume, ``rho`` density.

    >>> round(mass_of_volume(0.3, 7900.0), 6)
    2370.0
    """
    return V * rho


@formula(symbol="F_R", unit="N", source="SEW 2001, 7.4: bearing friction of the rollers' own weight")
def roller_weight_friction(n_R: One, m_R: Kilogram, g: MetrePerSecond2, mu_L: One, d_j: Metre, D: Metre) -> Newton:
    """Resistance that the weight of the rollers makes in their bearings.

    ``n_R`` rollers of mass ``m_R``, ``g`` gravity, ``mu_L`` bearing friction, ``d_j`` journal and ``D`` roller
    diameter.

    >>> round(roller_weight_friction(8, 58.82935, 9.81, 0.005, 0.02, 0.089), 3)
    5.188
    """
    return n_R * m_R * g * mu_L * d_j / D


@formula(symbol="m_L'", unit="kg/m", source="DIN 22101: load per length from the mass flow")
def load_per_length(m_dot: KilogramPerSecond, v: MetrePerSecond) -> KilogramPerMetre:
    """Mass of the goods on a metre of the belt.

    ``m_dot`` mass flow, ``v`` speed of the belt.

    >>> round(load_per_length(650 / 3.6, 0.6), 4)
    300.9259
    """
    return m_dot / v


@formula(symbol="F_H", unit="N", source="DIN 22101: main resistance of both strands")
def main_resistance(
    L: Metre, f_c: One, g: MetrePerSecond2, m_R: Kilogram, m_G: KilogramPerMetre, m_l: KilogramPerMetre, alpha: Rad
) -> Newton:
    """Main resistance of a belt conveyor: rolling of belt and idlers.

    ``L`` length of the conveyor, ``f_c`` friction factor, ``g`` gravity, ``m_R`` turning mass of all idlers, ``m_G``
    belt and ``m_l`` goods per length, ``alpha`` inclination.

    >>> round(main_resistance(30.0, 0.02, 9.81, 500.0, 20.0, 300.92593, 0.0), 2)
    2104.79
    """
    return L * f_c * g * (m_R / L + (2 * m_G + m_l) * cos(alpha))


@formula(symbol="F_N", unit="N", source="DIN 22101: secondary resistances by the factor C")
def secondary_resistance(C: One, F_H: Newton) -> Newton:
    """Secondary resistances of a belt conveyor: loading, bending, scrapers, drums.

    ``C`` factor of the total resistance by length, ``F_H`` main resistance.

    >>> round(secondary_resistance(2.4, 2100.0), 6)
    2940.0
    """
    return (C - 1) * F_H


@formula(symbol="F_St", unit="N", source="DIN 22101: slope resistance")
def slope_resistance(m_l: KilogramPerMetre, L: Metre, g: MetrePerSecond2, alpha: Rad) -> Newton:
    """Weight of the goods along a belt that climbs; the strands of the belt balance each other.

    ``m_l`` goods per length, ``L`` length of the conveyor, ``g`` gravity, ``alpha`` inclination.

    >>> slope_resistance(300.0, 30.0, 9.81, 0.0)
    0.0
    """
    return m_l * L * g * sin(alpha)


@formula(symbol="m_Req", unit="kg", source="derived: 2 E_kin / v^2 of the idlers, which roll with the belt")
def idlers_equivalent_mass(m_R: Kilogram, D: Metre, D_i: Metre) -> Kilogram:
    """Mass that has the kinetic energy of the idlers at the speed of the belt.

    ``m_R`` turning mass of all idlers, ``D`` outer and ``D_i`` inner diameter.

    >>> round(idlers_equivalent_mass(500.0, 0.108, 0.1), 3)
    464.335
    """
    return m_R / 2 * (1 + (D_i / D) ** 2)


@formula(symbol="A_m", unit="m2", source="derived: goods per length over bulk density")
def cross_section_of_load(m_l: KilogramPerMetre, rho: KilogramPerMetre3) -> SquareMetre:
    """Cross-section of the goods on a belt: whether they find room on it.

    ``m_l`` goods per length, ``rho`` bulk density.

    >>> cross_section_of_load(300.0, 1500.0)
    0.2
    """
    return m_l / rho


@formula(symbol="C", unit="1", source="DIN 22101: factor of the total resistance")
def total_factor(F_H: Newton, F_N: Newton) -> One:
    """Main and secondary resistance over the main resistance.

    ``F_H`` main resistance, ``F_N`` secondary resistances.

    >>> total_factor(2000.0, 1000.0)
    1.5
    """
    return (F_H + F_N) / F_H
