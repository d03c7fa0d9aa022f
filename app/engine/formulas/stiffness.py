"""Stiffness of a feed axis: its members, all of them in series, and what follows for the position loop."""

from app.engine.formula import formula, pi, sqrt, total
from app.engine.units import (
    Hertz,
    Kilogram,
    Metre,
    Newton,
    NewtonPerMetre,
    NewtonSecondPerMetre,
    One,
    Pascal,
    SquareMetre,
)


@formula(symbol="S", unit="mm2", source="derived: area of a circle")
def round_cross_section(D: Metre) -> SquareMetre:
    """Cross-section of a round bar.

    ``D`` diameter.

    >>> round(round_cross_section(0.05), 9)
    0.001963495
    """
    return pi * D**2 / 4


@formula(symbol="k_st", unit="N/um", source="Lachman, Mendricky 2015, part 3: k_st [N/um] = z * 5 * D [mm]")
def ball_contact_stiffness(z_t: One, D: Metre) -> NewtonPerMetre:
    """Stiffness of the contact between balls and raceways of a ball screw, by experience.

    ``z_t`` number of loaded turns, ``D`` nominal diameter. Really it grows with load and preload too: a figure of the
    maker is better.

    >>> ball_contact_stiffness(3.5, 0.05)  # 3.5 * 5 * 50 = 875 N/um
    875000000.0
    """
    return 5e9 * z_t * D


@formula(symbol="k_b", unit="N/um", source="derived: springs side by side share the force")
def parallel_stiffness(k_k: NewtonPerMetre) -> NewtonPerMetre:
    """Stiffness of springs in parallel, such as the bearings at both ends of a screw.

    ``k_k`` stiffness of each spring, shape (n,).

    >>> parallel_stiffness([1.0e9, 1.0e9])
    2000000000.0
    """
    return total(k_k)


@formula(
    symbol="k_ax", unit="N/um", source="Lachman, Mendricky 2015, part 3; derived: E*S/x + E*S/(l-x) is least at x = l/2"
)
def stiffness_held_at_both_ends(E: Pascal, S: SquareMetre, l: Metre) -> NewtonPerMetre:
    """Axial stiffness of a screw that takes thrust at both ends, with the nut in mid-length: the worst place.

    ``E`` modulus of elasticity, ``S`` cross-section, ``l`` length between the bearings.

    >>> round(stiffness_held_at_both_ends(2.0e11, 0.002, 1.6))
    1000000000
    """
    return 4 * E * S / l


@formula(symbol="k_ax", unit="N/um", source="Lachman, Mendricky 2015, part 3; derived: Hooke's law")
def stiffness_held_at_one_end(E: Pascal, S: SquareMetre, x: Metre) -> NewtonPerMetre:
    """Axial stiffness of a screw that takes thrust at one end only.

    ``E`` modulus of elasticity, ``S`` cross-section, ``x`` largest distance of the nut from that end.

    >>> round(stiffness_held_at_one_end(2.0e11, 0.002, 0.4))
    1000000000
    """
    return E * S / x


@formula(
    symbol="k_tor", unit="N/um", source="Lachman, Mendricky 2015, part 3; derived: G*J_k/(k_s^2*x), J_k = pi*D^4/32"
)
def torsion_stiffness_at_nut(G: Pascal, D: Metre, h: Metre, x: Metre) -> NewtonPerMetre:
    """Torsional stiffness of a screw as the nut feels it along the axis.

    ``G`` shear modulus, ``D`` diameter that carries the torsion, ``h`` lead, ``x`` largest twisted length: from the
    driven end to the nut in its worst position.

    >>> round(torsion_stiffness_at_nut(8.0e10, 0.05, 0.02, 0.54) / 1e6, 1)  # 31.00628 * 5e5 / 1.728e-3 = 8971.7 N/um
    8971.7
    """
    return pi**3 * G * D**4 / (8 * h**2 * x)


@formula(symbol="k", unit="N/um", source="derived: springs in a row add their compliances")
def series_stiffness(k_k: NewtonPerMetre) -> NewtonPerMetre:
    """Stiffness of springs in series: below that of the softest.

    ``k_k`` stiffness of each member, shape (n,), all > 0.

    >>> series_stiffness([2.0e8, 2.0e8])
    100000000.0
    """
    return 1 / total(1 / k_k)


@formula(symbol="f_0", unit="Hz", source="derived: undamped oscillator of one mass; Lachman, Mendricky 2015, part 3")
def natural_frequency(k: NewtonPerMetre, m: Kilogram) -> Hertz:
    """Natural frequency of a mass on a spring, undamped.

    ``k`` stiffness, ``m`` mass that swings.

    >>> round(natural_frequency(4.0e6, 1.0), 2)  # 2000 rad/s / 2 pi
    318.31
    """
    return sqrt(k / m) / (2 * pi)


@formula(symbol="b", unit="N s/m", source="derived: definition of the damping ratio; Lachman, Mendricky 2015, part 3")
def damping_coefficient(xi: One, k: NewtonPerMetre, m: Kilogram) -> NewtonSecondPerMetre:
    """Damping of a mass on a spring from its damping ratio.

    ``xi`` damping ratio (1 = aperiodic limit), ``k`` stiffness, ``m`` mass that swings.

    >>> damping_coefficient(0.1, 4.0e8, 400.0)  # 0.2 * sqrt(1.6e11)
    80000.0
    """
    return 2 * xi * sqrt(k * m)


@formula(symbol="Delta_x", unit="um", source="Lachman, Mendricky 2015, part 3")
def friction_lost_motion(F_T: Newton, k: NewtonPerMetre) -> Metre:
    """Lost motion of the slide through friction when the position is measured on the motor.

    ``F_T`` friction force at the slide, ``k`` stiffness between motor and slide. The spring is wound up by F_T in one
    direction and has to be wound up the other way after a reversal: hence twice.

    >>> round(friction_lost_motion(400.0, 4.0e8) * 1e6, 6)
    2.0
    """
    return 2 * F_T / k
