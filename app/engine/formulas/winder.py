"""Winders: diameter of the reel, tension of the web, inertia that grows with what is wound."""

from app.engine.formula import formula, maximum, pi, sqrt
from app.engine.units import KilogramMetre2, KilogramPerMetre3, Metre, Newton, One


@formula(symbol="D", unit="mm", source="derived: area of the side of the reel is length times thickness of the web")
def reel_diameter(D_0: Metre, h: Metre, s: Metre, D_K: Metre) -> Metre:
    """Diameter of a reel after a length of web has been wound, never below its core.

    ``D_0`` diameter before, ``h`` thickness of the web, ``s`` wound length, negative where it is unwound, ``D_K``
    diameter of the core.

    >>> round(reel_diameter(0.1, 0.001, 100.0, 0.1), 6)  # sqrt(0.01 + 0.4 / pi)
    0.370572
    """
    return sqrt(maximum(D_0**2 + 4 * h * s / pi, D_K**2))


@formula(symbol="s", unit="m", source="derived: area of the side of the reel is length times thickness of the web")
def reel_length(D: Metre, D_K: Metre, h: Metre) -> Metre:
    """Length of web on a reel.

    ``D`` diameter, ``D_K`` diameter of the core, ``h`` thickness of the web.

    >>> round(reel_length(0.3705722, 0.1, 0.001), 3)
    100.0
    """
    return pi * (D**2 - D_K**2) / (4 * h)


@formula(symbol="J", unit="kg m2", source="derived: hollow cylinder of the wound web")
def reel_inertia(D: Metre, D_K: Metre, b: Metre, rho: KilogramPerMetre3) -> KilogramMetre2:
    """Inertia of the wound web about the axis of the reel.

    ``D`` diameter, ``D_K`` diameter of the core, ``b`` width of the web, ``rho`` its density, wound.

    >>> round(reel_inertia(1.0, 0.0, 1.0, 1000.0), 4)  # pi / 32 * 1000
    98.1748
    """
    return pi * rho * b * (D**4 - D_K**4) / 32


@formula(symbol="F_t", unit="N", source="derived: tension that falls with the diameter, by a taper")
def tapered_tension(F_W: Newton, k_W: One, D_K: Metre, D: Metre) -> Newton:
    """Tension of the web at a diameter.

    ``F_W`` tension on the core, ``k_W`` taper: share by which the tension falls towards an endless reel, ``D_K``
    diameter of the core, ``D`` diameter.

    >>> tapered_tension(100.0, 0.5, 0.1, 0.2)
    75.0
    """
    return F_W * (1 - k_W * (1 - D_K / D))
