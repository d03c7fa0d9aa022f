"""Slider-crank: exact kinematics, and the sums of two harmonics that handbooks use in their place.

The angle is zero in the dead centre where the slide is farthest from the crank shaft; the way is counted from there.
"""

from app.engine.formula import arctan, cos, formula, sin, sqrt
from app.engine.units import (
    Kilogram,
    KilogramMetre,
    KilogramMetre2,
    Metre,
    MetrePerRad,
    MetrePerSecond,
    MetrePerSecond2,
    NewtonMetre,
    One,
    Rad,
    RadPerSecond,
    RadPerSecond2,
)


@formula(symbol="lambda_c", unit="1", source="SEW 2001, 14.1: crank ratio")
def crank_ratio(r: Metre, l: Metre) -> One:
    """Crank radius over length of the rod.

    ``r`` crank radius, ``l`` length of the rod, longer than ``r``.

    >>> crank_ratio(0.5, 2.0)
    0.25
    """
    return r / l


@formula(symbol="s_0", unit="mm", source="derived: distance between the dead centres of a central slider-crank")
def crank_stroke(r: Metre) -> Metre:
    """Stroke of the slide.

    ``r`` crank radius.

    >>> crank_stroke(0.5)
    1.0
    """
    return 2 * r


@formula(symbol="s", unit="mm", source="derived: projection of crank and rod on the way of the slide")
def crank_way(phi: Rad, r: Metre, l: Metre) -> Metre:
    """Way of the slide from the outer dead centre, exact.

    ``phi`` angle of the crank, ``r`` crank radius, ``l`` length of the rod.

    >>> round(crank_way(1.5707963267948966, 0.5, 2.0), 6)  # 0.5 + 2 - sqrt(2^2 - 0.5^2)
    0.563508
    """
    return r * (1 - cos(phi)) + l - sqrt(l**2 - (r * sin(phi)) ** 2)


@formula(symbol="A", unit="mm/rad", source="derived: derivative of the way by the angle")
def crank_transmission(phi: Rad, r: Metre, l: Metre) -> MetrePerRad:
    """Travel of the slide per radian of the crank, exact; positive while it moves inward.

    ``phi`` angle of the crank, ``r`` crank radius, ``l`` length of the rod. By it force becomes torque and angular
    speed becomes speed.

    >>> crank_transmission(1.5707963267948966, 0.5, 2.0)
    0.5
    """
    return r * sin(phi) * (1 + r * cos(phi) / sqrt(l**2 - (r * sin(phi)) ** 2))


@formula(symbol="a", unit="m/s2", source="derived: second derivative of the way by time")
def crank_slide_acceleration(
    phi: Rad, omega: RadPerSecond, alpha_s: RadPerSecond2, A: MetrePerRad, r: Metre, l: Metre
) -> MetrePerSecond2:
    """Acceleration of the slide, exact; positive inward.

    ``phi`` angle, ``omega`` speed and ``alpha_s`` acceleration of the crank, ``A`` travel per radian at that angle,
    ``r`` crank radius, ``l`` length of the rod.

    >>> round(crank_slide_acceleration(0.0, 2.0, 0.0, 0.0, 0.5, 2.0), 6)  # omega^2 * r * (1 + r/l)
    2.5
    """
    p = l**2 - (r * sin(phi)) ** 2
    return omega**2 * (r * cos(phi) + r**2 * cos(2 * phi) / sqrt(p) + r**4 * sin(2 * phi) ** 2 / (4 * p * sqrt(p))) + (
        alpha_s * A
    )


@formula(symbol="m_o", unit="kg", source="derived: rod replaced by two masses with the same centre of mass")
def rod_mass_with_slide(m_P: Kilogram, x_P: One) -> Kilogram:
    """Part of the rod that moves with the slide.

    ``m_P`` mass of the rod, ``x_P`` distance of its centre of mass from the crank pin as a share of its length.

    >>> rod_mass_with_slide(12.0, 0.25)
    3.0
    """
    return m_P * x_P


@formula(symbol="J_P", unit="kg m2", source="derived: rod replaced by two masses with the same centre of mass")
def rod_inertia_with_crank(m_P: Kilogram, x_P: One, r: Metre) -> KilogramMetre2:
    """Inertia of the part of the rod that turns with the crank pin.

    ``m_P`` mass of the rod, ``x_P`` distance of its centre of mass from the crank pin as a share of its length,
    ``r`` crank radius.

    >>> rod_inertia_with_crank(12.0, 0.25, 0.5)
    2.25
    """
    return m_P * (1 - x_P) * r**2


@formula(symbol="U", unit="kg m", source="derived: rod replaced by two masses with the same centre of mass")
def crank_unbalance(U_K: KilogramMetre, m_P: Kilogram, x_P: One, r: Metre) -> KilogramMetre:
    """Unbalance of crank and rod about the crank shaft, towards the crank pin.

    ``U_K`` that of the crank, negative for a counterweight, ``m_P`` mass of the rod, ``x_P`` distance of its centre of
    mass from the crank pin as a share of its length, ``r`` crank radius.

    >>> crank_unbalance(-1.0, 12.0, 0.25, 0.5)
    3.5
    """
    return U_K + m_P * (1 - x_P) * r


@formula(symbol="M_U", unit="N m", source="derived: weight times arm; the pin rises from the outer dead centre")
def crank_weight_torque(U_K: KilogramMetre, g: MetrePerSecond2, phi: Rad, delta: Rad) -> NewtonMetre:
    """Torque that lifts the unbalance of crank and rod; negative where its weight drives.

    ``U_K`` unbalance towards the crank pin, ``g`` gravity, ``phi`` angle of the crank, ``delta`` slope of the slideway.

    >>> crank_weight_torque(2.0, 10.0, 0.0, 0.0)
    20.0
    """
    return U_K * g * cos(phi - delta)


@formula(symbol="v", unit="m/s", source="SEW 2001, 14.1: two harmonics in place of the exact speed")
def crank_speed_approximate(omega: RadPerSecond, phi: Rad, r: Metre, lambda_c: One) -> MetrePerSecond:
    """Speed of the slide by the handbook's approximation.

    ``omega`` speed of the crank, ``phi`` its angle, ``r`` crank radius, ``lambda_c`` crank ratio.

    >>> crank_speed_approximate(2.0, 1.5707963267948966, 0.5, 0.25)
    1.0
    """
    return omega * r * sin(phi) * (1 + lambda_c * cos(phi))


@formula(symbol="a", unit="m/s2", source="SEW 2001, 14.1: two harmonics in place of the exact acceleration")
def crank_acceleration_approximate(omega: RadPerSecond, phi: Rad, r: Metre, lambda_c: One) -> MetrePerSecond2:
    """Acceleration of the slide at constant speed of the crank by the handbook's approximation.

    ``omega`` speed of the crank, ``phi`` its angle, ``r`` crank radius, ``lambda_c`` crank ratio.

    >>> crank_acceleration_approximate(2.0, 0.0, 0.5, 0.25)
    2.5
    """
    return omega**2 * r * (cos(phi) + lambda_c * cos(2 * phi))


@formula(symbol="phi_S", unit="deg", source="SEW 2001, 14.1: crank and rod at a right angle")
def crank_fast_angle(r: Metre, l: Metre) -> Rad:
    """Angle near which the slide is fastest: crank and rod at a right angle. A rule of thumb.

    ``r`` crank radius, ``l`` length of the rod.

    >>> round(crank_fast_angle(0.5, 2.0), 6)
    1.325818
    """
    return arctan(l / r)


@formula(
    symbol="phi_D", unit="deg", source="SEW 2001, 14.1: root of the derivative of v*a; one step of Newton's method"
)
def crank_power_angle(phi: Rad, lambda_c: One) -> Rad:
    """Angle at which the approximate dynamic power is largest; at the root the step leads to the root itself.

    ``phi`` angle to start from, near the root, ``lambda_c`` crank ratio.

    >>> round(crank_power_angle(0.78539816, 0.0), 6)  # a rod without end: 45 degrees
    0.785398
    """
    derivative = 4 * lambda_c**2 * cos(4 * phi) + 9 * lambda_c * cos(3 * phi) + 4 * cos(2 * phi) - lambda_c * cos(phi)
    slope = lambda_c * sin(phi) - 16 * lambda_c**2 * sin(4 * phi) - 27 * lambda_c * sin(3 * phi) - 8 * sin(2 * phi)
    return phi - derivative / slope
