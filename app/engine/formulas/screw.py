"""Ball and lead screws: travel per radian, efficiency of the thread, speed limits and buckling."""

from app.engine.formula import arctan, formula, pi, sqrt, tan
from app.engine.units import (
    KilogramPerMetre3,
    Metre,
    MetrePerRad,
    MetreRadPerSecond,
    Newton,
    NewtonMetre,
    One,
    Pascal,
    Rad,
    RadPerSecond,
)


@formula(
    symbol="k_s", unit="mm/rad", source="Lachman, Mendricky 2015, part 3; derived: one turn moves the nut by the lead"
)
def screw_constant(h: Metre) -> MetrePerRad:
    """Travel of the nut per radian of the screw.

    ``h`` lead: travel per revolution, pitch times number of starts.

    >>> round(screw_constant(0.02), 9)  # 20 mm / 6.283185
    0.003183099
    """
    return h / (2 * pi)


@formula(symbol="phi_h", unit="deg", source="derived: one turn of the helix unrolled")
def lead_angle(h: Metre, D: Metre) -> Rad:
    """Lead angle of a thread.

    ``h`` lead, ``D`` diameter at which the thread carries: pitch diameter, or nearly the nominal one.

    >>> round(lead_angle(3.141592653589793, 1.0), 6)  # the helix rises as fast as it turns: 45 degrees
    0.785398
    """
    return arctan(h / (pi * D))


@formula(symbol="eta", unit="1", source="derived: forces on an inclined plane with friction")
def thread_efficiency(phi_h: Rad, mu_th: One) -> One:
    """Efficiency of a screw that drives its nut, from lead angle and thread friction.

    ``phi_h`` lead angle, ``mu_th`` friction coefficient in the thread (for a trapezoidal thread of 30 degrees the
    coefficient of the material pair divided by cos 15 degrees). A screw with tan(phi_h) <= mu_th is self-locking.

    >>> round(thread_efficiency(0.1, 0.1), 4)  # tan(0.1) / tan(0.1 + 0.09967) = 0.100335 / 0.202363
    0.4958
    """
    return tan(phi_h) / tan(phi_h + arctan(mu_th))


@formula(symbol="M_Ts", unit="N m", source="Lachman, Mendricky 2015, part 3: M_Ts [N m] about D [cm]")
def screw_friction_by_diameter(D: Metre) -> NewtonMetre:
    """Friction torque of a preloaded ball screw with its bearings, by experience.

    ``D`` nominal diameter. As many newton metres as the diameter has centimetres: 100 N times the diameter. A rough
    rule for machine-tool feed screws; a figure of the maker is better.

    >>> screw_friction_by_diameter(0.05)
    5.0
    """
    return 100 * D


@formula(symbol="DN", unit="mm rpm", source="Lachman, Mendricky 2015, part 3; usual speed figure of ball screws")
def dn_factor(D: Metre, omega: RadPerSecond) -> MetreRadPerSecond:
    """Speed figure of a ball screw: nominal diameter times speed, a measure of how fast the balls run.

    ``D`` nominal diameter, ``omega`` highest speed of the screw.

    >>> round(dn_factor(0.05, 100.0), 6)
    5.0
    """
    return D * omega


@formula(
    symbol="omega_c", unit="rpm", source="derived: first bending frequency of a uniform round bar (Euler, Bernoulli)"
)
def critical_screw_speed(lambda_b: One, d_r: Metre, l_b: Metre, E: Pascal, rho: KilogramPerMetre3) -> RadPerSecond:
    """Critical speed of a screw: it turns as fast as it would swing sideways.

    ``lambda_b`` first eigenvalue of the beam by mounting (4.730 fixed-fixed, 3.927 fixed-supported, pi
    supported-supported, 1.875 fixed-free), ``d_r`` root diameter, ``l_b`` free length between the bearings, ``E``
    modulus of elasticity, ``rho`` density. From lambda_b^2 / l_b^2 * sqrt(E * I / (rho * S)) with I / S = d_r^2 / 16.

    >>> round(critical_screw_speed(3.141592653589793, 0.04, 2.0, 2.0e11, 8.0e3), 3)  # 9.8696 * 0.01 / 4 * 5000
    123.37
    """
    return lambda_b**2 * d_r / (4 * l_b**2) * sqrt(E / rho)


@formula(symbol="omega_p", unit="rpm", source="usual practice: stay clear of the critical speed")
def permissible_screw_speed(k_c: One, omega_c: RadPerSecond) -> RadPerSecond:
    """Permissible speed of a screw as a share of its critical speed.

    ``k_c`` permitted share, usually 0.8; ``omega_c`` critical speed.

    >>> permissible_screw_speed(0.8, 500.0)
    400.0
    """
    return k_c * omega_c


@formula(symbol="F_B", unit="N", source="derived: Euler's buckling load with I = pi*d_r^4/64")
def buckling_force(k_b: One, E: Pascal, d_r: Metre, l_x: Metre) -> Newton:
    """Axial force at which a slender screw buckles (Euler).

    ``k_b`` factor by mounting (4 fixed-fixed, 2 fixed-supported, 1 supported-supported, 0.25 fixed-free), ``E`` modulus
    of elasticity, ``d_r`` root diameter, ``l_x`` longest part of the screw under compression. Holds for slender
    screws; a short one yields before it buckles.

    >>> round(buckling_force(1.0, 2.1e11, 0.02, 1.0), 0)  # 9.8696 * 2.1e11 * 7.85398e-9
    16278.0
    """
    return k_b * pi**3 * E * d_r**4 / (64 * l_x**2)


@formula(symbol="F_p", unit="N", source="usual practice: safety against buckling")
def permissible_axial_force(F_B: Newton, nu: One) -> Newton:
    """Permissible compression of a screw with a safety against buckling.

    ``F_B`` buckling force, ``nu`` safety factor > 1, usually 2.

    >>> permissible_axial_force(16000.0, 2.0)
    8000.0
    """
    return F_B / nu
