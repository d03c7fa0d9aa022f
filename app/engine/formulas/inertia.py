"""Moments of inertia of simple bodies, and what a shaft sees of a moving mass or of another shaft."""

from app.engine.formula import formula, pi, total
from app.engine.units import Kilogram, KilogramMetre2, KilogramPerMetre3, Metre, MetrePerRad, One


@formula(symbol="m", unit="kg", source="derived: volume of a cylinder times its density")
def cylinder_mass(D: Metre, l: Metre, rho: KilogramPerMetre3) -> Kilogram:
    """Mass of a solid round bar.

    ``D`` diameter, ``l`` length, ``rho`` density of the material; all > 0.

    >>> round(cylinder_mass(0.05, 1.0, 7850.0), 3)  # pi / 4 * 0.0025 m2 * 1 m * 7850 kg/m3
    15.413
    """
    return pi / 4 * D**2 * l * rho


@formula(symbol="J", unit="kg cm2", source="derived: m*r^2, all mass at one radius")
def point_mass_inertia(m: Kilogram, r: Metre) -> KilogramMetre2:
    """Inertia of a mass at a radius: a body small against that radius, a thin ring, or what hangs on a pulley.

    ``m`` mass, ``r`` distance of the mass from the axis.

    >>> round(point_mass_inertia(65.0, 0.05), 6)  # 65 kg * 0.0025 m2
    0.1625
    """
    return m * r**2


@formula(symbol="J", unit="kg cm2", source="derived: kinetic energy m*v^2/2 = J*omega^2/2 with v = A*omega")
def linear_mass_inertia(m: Kilogram, A: MetrePerRad) -> KilogramMetre2:
    """Inertia that a shaft sees of a mass moved in a straight line.

    ``m`` moved mass (a counterweight counts too), ``A`` transmission constant: travel per radian of the shaft, that is
    lead / 2 pi of a screw or the pitch radius of a pulley or pinion.

    >>> round(linear_mass_inertia(200.0, 0.002), 6)  # 200 kg * 4e-6 m2
    0.0008
    """
    return m * A**2


@formula(symbol="J", unit="kg cm2", source="derived: m*r^2/2 with r = D/2")
def solid_cylinder_inertia(m: Kilogram, D: Metre) -> KilogramMetre2:
    """Inertia of a solid cylinder or disc about its own axis.

    ``m`` mass, ``D`` diameter; the length does not matter.

    >>> round(solid_cylinder_inertia(40.0, 0.05), 6)  # 40 kg * 0.0025 m2 / 8
    0.0125
    """
    return m * D**2 / 8


@formula(symbol="J", unit="kg cm2", source="derived: difference of two solid cylinders of the same density")
def hollow_cylinder_inertia(m: Kilogram, D: Metre, D_i: Metre) -> KilogramMetre2:
    """Inertia of a hollow cylinder about its own axis.

    ``m`` mass, ``D`` outer and ``D_i`` inner diameter, 0 <= D_i < D.

    >>> hollow_cylinder_inertia(8.0, 0.5, 0.5)  # a thin ring: 8 kg * (0.25 m)^2
    0.5
    """
    return m * (D**2 + D_i**2) / 8


@formula(symbol="J", unit="kg cm2", source="derived: integral of r^2 over a cuboid")
def cuboid_inertia(m: Kilogram, b: Metre, l: Metre) -> KilogramMetre2:
    """Inertia of a cuboid about the axis through its centre, at right angles to its width and length.

    ``m`` mass, ``b`` width and ``l`` length in the plane of rotation; the height along the axis does not matter.

    >>> cuboid_inertia(12.0, 0.3, 0.4)  # 12 kg / 12 * (0.09 + 0.16) m2
    0.25
    """
    return m * (b**2 + l**2) / 12


@formula(symbol="J", unit="kg cm2", source="derived: parallel axis (Steiner's) theorem")
def parallel_axis_inertia(J_c: KilogramMetre2, m: Kilogram, r: Metre) -> KilogramMetre2:
    """Inertia of a body about an axis beside its centre of gravity (Steiner).

    ``J_c`` inertia about the parallel axis through the centre of gravity, ``m`` mass, ``r`` distance of the two axes.

    >>> parallel_axis_inertia(0.25, 12.0, 0.5)  # 0.25 + 12 * 0.25
    3.25
    """
    return J_c + m * r**2


@formula(symbol="J_x", unit="kg cm2", source="SEW 2001, 7.2; derived: J*omega^2/2 is the same on both shafts")
def referred_inertia(J: KilogramMetre2, i: One) -> KilogramMetre2:
    """Inertia referred through a ratio to the faster shaft.

    ``J`` inertia on the slow shaft, ``i`` ratio fast / slow speed over all stages in between.

    >>> referred_inertia(0.5, 10.0)
    0.005
    """
    return J / i**2


@formula(symbol="J", unit="kg cm2", source="derived: bodies on one shaft share its speed")
def sum_of_inertias(J_k: KilogramMetre2) -> KilogramMetre2:
    """Inertia of all bodies on one shaft together.

    ``J_k`` inertia of each body referred to that shaft, shape (n,).

    >>> sum_of_inertias([0.25, 0.5])
    0.75
    """
    return total(J_k)


@formula(symbol="J", unit="kg m2", source="SEW 2001, 7.2: thin disc about a diameter")
def disc_about_diameter_inertia(m: Kilogram, D: Metre) -> KilogramMetre2:
    """Inertia of a thin disc about an axis in its plane.

    ``m`` mass, ``D`` diameter.

    >>> round(disc_about_diameter_inertia(12.0, 0.4), 6)
    0.12
    """
    return m * D**2 / 16


@formula(symbol="J", unit="kg m2", source="SEW 2001, 7.2: sphere")
def sphere_inertia(m: Kilogram, D: Metre) -> KilogramMetre2:
    """Inertia of a solid sphere about its centre.

    ``m`` mass, ``D`` diameter.

    >>> round(sphere_inertia(12.0, 0.4), 6)
    0.192
    """
    return m * D**2 / 10


@formula(symbol="J", unit="kg m2", source="SEW 2001, 7.2: spherical shell")
def spherical_shell_inertia(m: Kilogram, D: Metre) -> KilogramMetre2:
    """Inertia of a thin hollow sphere about its centre.

    ``m`` mass, ``D`` diameter.

    >>> round(spherical_shell_inertia(12.0, 0.4), 6)
    0.32
    """
    return m * D**2 / 6


@formula(symbol="J", unit="kg m2", source="SEW 2001, 7.2: thin rod")
def rod_inertia(m: Kilogram, l: Metre) -> KilogramMetre2:
    """Inertia of a thin rod about its middle, axis across.

    ``m`` mass, ``l`` length.

    >>> round(rod_inertia(12.0, 0.6), 6)
    0.36
    """
    return m * l**2 / 12
