"""Timing belts and belt conveyors: pulleys, belt mass, forces in the strands."""

from app.engine.formula import exp, formula, maximum, pi
from app.engine.units import (
    Kilogram,
    KilogramMetre2,
    KilogramPerMetre,
    KilogramPerMetre3,
    Metre,
    MetrePerRad,
    Newton,
    One,
    Rad,
)


@formula(symbol="d", unit="mm", source="derived: z teeth of pitch p around the pitch circle")
def pulley_pitch_diameter(z: One, p: Metre) -> Metre:
    """Pitch diameter of a toothed pulley.

    ``z`` number of teeth, ``p`` pitch of the belt. Larger than the outer diameter of the pulley: the tension members
    of the belt lie on it.

    >>> round(pulley_pitch_diameter(40.0, 0.005), 6)  # 40 * 5 mm / pi
    0.063662
    """
    return z * p / pi


@formula(symbol="A", unit="mm/rad", source="derived: the belt moves with the pitch circle")
def pulley_transmission(d: Metre) -> MetrePerRad:
    """Travel of the belt per radian of its pulley or drum: the pitch radius.

    ``d`` pitch diameter.

    >>> pulley_transmission(0.1)
    0.05
    """
    return d / 2


@formula(symbol="m_b", unit="kg", source="derived: mass per length times length")
def belt_mass(q: KilogramPerMetre, L: Metre) -> Kilogram:
    """Mass of the whole belt; both strands move at the speed of the belt.

    ``q`` mass per length in the width used, ``L`` length of the whole belt, not the distance of the pulleys.

    >>> belt_mass(0.25, 6.0)
    1.5
    """
    return q * L


@formula(symbol="J_t", unit="kg cm2", source="derived: m*d^2/8 with m = pi/4*d^2*b*rho")
def solid_pulley_inertia(d: Metre, b: Metre, rho: KilogramPerMetre3) -> KilogramMetre2:
    """Inertia of a pulley taken as a solid disc of its pitch diameter; it grows with the fourth power of the diameter.

    ``d`` pitch diameter, ``b`` width, ``rho`` density of the material.

    >>> round(solid_pulley_inertia(0.1, 0.03, 2700.0), 8)  # pi * 2700 * 0.03 * 1e-4 / 32
    0.00079522
    """
    return pi * rho * b * d**4 / 32


@formula(symbol="F_s", unit="N", source="derived: pretension plus what hangs on the strand")
def largest_strand_force(F_V: Newton, F_C: Newton, F_Z: Newton) -> Newton:
    """Largest force in a strand of the belt.

    ``F_V`` pretension of each strand, ``F_C`` pull of the belt on the carriage, ``F_Z`` pull on the counterweight (both
    signed). A strand between the drive pulley and a carriage close to it takes the whole pull, so no share of it is
    passed to the other strand.

    >>> largest_strand_force(200.0, 480.0, -195.0)
    680.0
    """
    return F_V + maximum(abs(F_C), abs(F_Z))


@formula(symbol="F_slip", unit="N", source="derived: rope friction of Euler and Eytelwein")
def drum_grip(F_2: Newton, mu_d: One, phi: Rad) -> Newton:
    """Largest peripheral force that a drum passes to a flat belt before it slips.

    ``F_2`` tension of the slack strand, ``mu_d`` friction coefficient between belt and drum, ``phi`` wrap angle.

    >>> round(drum_grip(1000.0, 0.3, 3.141592653589793), 1)  # 1000 N * (e^0.942 - 1)
    1566.3
    """
    return F_2 * (exp(mu_d * phi) - 1)
