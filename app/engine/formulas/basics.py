"""Everyday formulas of drive engineering that belong to no single mechanism."""

from app.engine.formula import cos, formula
from app.engine.units import (
    Kilogram,
    Metre,
    MetrePerRad,
    MetrePerSecond,
    MetrePerSecond2,
    Newton,
    One,
    Rad,
    RadPerSecond,
    Second,
    Watt,
)


@formula(symbol="v", unit="m/s", source="derived: constant acceleration from standstill")
def speed_after(a: MetrePerSecond2, t: Second) -> MetrePerSecond:
    """Speed after a time of constant acceleration from standstill.

    ``a`` acceleration, ``t`` time.

    >>> speed_after(0.5, 2.0)
    1.0
    """
    return a * t


@formula(symbol="phi", unit="deg", source="derived: way over travel per radian")
def angle_of_way(s: Metre, A: MetrePerRad) -> Rad:
    """Angle of a shaft that moves a load by a way.

    ``s`` way, ``A`` travel of the load per radian: half the diameter of a wheel, the lead of a screw over 2 pi.

    >>> angle_of_way(0.5, 0.125)
    4.0
    """
    return s / A


@formula(symbol="A", unit="mm/rad", source="derived: speed of the load over speed of the shaft")
def travel_of_speeds(v: MetrePerSecond, omega: RadPerSecond) -> MetrePerRad:
    """Travel of a load per radian of a shaft, from their speeds at the same time.

    ``v`` speed of the load, ``omega`` speed of the shaft.

    >>> travel_of_speeds(0.5, 250.0)
    0.002
    """
    return v / omega


@formula(symbol="P/P_T", unit="%", source="derived: share of a power")
def power_share(P: Watt, P_T: Watt) -> One:
    """Share of one power in another.

    ``P`` the part, ``P_T`` the whole.

    >>> power_share(90.0, 100.0)
    0.9
    """
    return P / P_T


@formula(symbol="F_R", unit="N", source="SEW 2001, 7.4: sliding friction")
def sliding_friction(mu: One, F_N: Newton) -> Newton:
    """Friction of a sliding body.

    ``mu`` friction coefficient, ``F_N`` force normal to the surface.

    >>> sliding_friction(0.2, 9800.0)
    1960.0
    """
    return mu * F_N


@formula(symbol="F_N", unit="N", source="SEW 2001, 7.4: part of the weight normal to the plane")
def normal_force(m: Kilogram, g: MetrePerSecond2, alpha: Rad) -> Newton:
    """Force of a body normal to the plane it rests on.

    ``m`` mass, ``g`` gravity, ``alpha`` inclination of the plane.

    >>> normal_force(100.0, 9.81, 0.0)
    981.0
    """
    return m * g * cos(alpha)
