"""Forces along an axis: weight, friction of the guides, inertia."""

from app.engine.formula import cos, formula, sin, total
from app.engine.units import (
    Kilogram,
    MetrePerSecond,
    MetrePerSecond2,
    Newton,
    NewtonPerKilogram,
    NewtonSecondPerMetre,
    One,
    Rad,
)


@formula(symbol="F_g", unit="N", source="derived: component of the weight along an inclined axis")
def weight_along_axis(m: Kilogram, g: MetrePerSecond2, alpha: Rad) -> Newton:
    """Component of the weight along the axis, positive when it pulls downhill.

    ``m`` mass whose weight acts (a counterweight is taken off), ``g`` gravity, ``alpha`` inclination: 0 horizontal,
    pi/2 vertical.

    >>> round(weight_along_axis(400.0, 9.81, 3.141592653589793 / 3), 2)  # 400 * 9.81 * 0.866025
    3398.28
    """
    return m * g * sin(alpha)


@formula(symbol="F_T", unit="N", source="derived: Coulomb friction on the normal component of the weight")
def guide_friction(mu: One, m: Kilogram, g: MetrePerSecond2, alpha: Rad) -> Newton:
    """Friction of a guide that carries the normal component of a weight; unsigned, it opposes the motion.

    ``mu`` friction coefficient, ``m`` guided mass, ``g`` gravity, ``alpha`` inclination. Zero on a vertical axis, where
    the preload of the guide remains: give that as a constant friction force.

    >>> round(guide_friction(0.2, 200.0, 9.8, 0.0), 6)
    392.0
    """
    return mu * m * g * cos(alpha)


@formula(symbol="F_T", unit="N", source="derived: friction coefficient applied to the whole weight")
def weight_share_friction(mu: One, m: Kilogram, g: MetrePerSecond2) -> Newton:
    """Friction taken as a share of the whole weight, whatever the inclination; unsigned, it opposes the motion.

    ``mu`` share of the weight, ``m`` guided mass, ``g`` gravity. A practical figure for guides with preload or seals.

    >>> round(weight_share_friction(0.1, 65.0, 9.81), 3)
    63.765
    """
    return mu * m * g


@formula(symbol="F_T", unit="N", source="Lachman, Mendricky 2015, part 1")
def specific_guide_friction(k_t: NewtonPerKilogram, m: Kilogram) -> Newton:
    """Friction of a guide by experience, in proportion to the guided mass; unsigned, it opposes the motion.

    ``k_t`` friction per mass: 0 hydrostatic, 0.5 rolling, 1 to 2 N/kg other guides; ``m`` guided mass. The whole mass
    counts, whatever the inclination.

    >>> specific_guide_friction(1.0, 400.0)
    400.0
    """
    return k_t * m


@formula(symbol="F_Tv", unit="N", source="derived: linear viscous friction")
def viscous_friction(k_v: NewtonSecondPerMetre, v: MetrePerSecond) -> Newton:
    """Friction that grows with speed; signed as the speed.

    ``k_v`` viscous friction coefficient, ``v`` speed.

    >>> viscous_friction(100.0, -0.5)
    -50.0
    """
    return k_v * v


@formula(symbol="F_a", unit="N", source="derived: Newton's second law")
def acceleration_force(m: Kilogram, a: MetrePerSecond2) -> Newton:
    """Force that accelerates a mass, signed as the acceleration.

    ``m`` all mass that moves (a counterweight is added), ``a`` acceleration.

    >>> acceleration_force(200.0, 2.5)
    500.0
    """
    return m * a


@formula(symbol="F", unit="N", source="derived: forces on one body add up with their signs")
def sum_of_forces(F_k: Newton) -> Newton:
    """Sum of the forces on one body.

    ``F_k`` signed forces along one axis, shape (n,).

    >>> sum_of_forces([500.0, -200.0])
    300.0
    """
    return total(F_k)
