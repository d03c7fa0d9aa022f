"""Hoists: weight, counterweight and reeving."""

from app.engine.formula import formula
from app.engine.units import Kilogram, Metre, MetrePerRad, MetrePerSecond2, Newton, One


@formula(symbol="F_g", unit="N", source="SEW 2001, 9.1: weight of the load; a counterweight takes its part")
def hoisted_weight(m: Kilogram, m_c: Kilogram, g: MetrePerSecond2) -> Newton:
    """Weight that pulls a hoist down; negative where the counterweight is heavier.

    ``m`` cage and payload, ``m_c`` counterweight, ``g`` gravity.

    >>> hoisted_weight(500.0, 0.0, 9.81)
    4905.0
    """
    return (m - m_c) * g


@formula(symbol="A", unit="mm/rad", source="derived: n_r falls of rope lift the load by 1/n_r of what is wound up")
def hoisting_transmission(D: Metre, n_r: One) -> MetrePerRad:
    """Way of the load per radian of the drum.

    ``D`` diameter of the drum or sprocket, ``n_r`` falls of rope that carry the load.

    >>> hoisting_transmission(0.25, 2)
    0.0625
    """
    return D / (2 * n_r)
