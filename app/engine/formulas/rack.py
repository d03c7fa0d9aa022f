"""Rack and pinion: pitch circle and travel, straight and helical teeth."""

from app.engine.formula import cos, formula, pi
from app.engine.units import Metre, MetrePerRad, One, Rad


@formula(symbol="R", unit="mm", source="derived: z transverse pitches pi*m_n/cos(beta) make the pitch circle")
def pinion_pitch_radius(z: One, m_n: Metre, beta: Rad) -> MetrePerRad:
    """Pitch radius of a pinion: where the force acts, and the travel of the rack per radian.

    ``z`` number of teeth, ``m_n`` normal module, ``beta`` helix angle, 0 for straight teeth. Profile shift moves the
    tip circle, not this radius.

    >>> round(pinion_pitch_radius(25.0, 0.003, 0.0), 6)  # 25 * 3 mm / 2
    0.0375
    """
    return z * m_n / (2 * cos(beta))


@formula(symbol="S", unit="mm", source="derived: circumference of the pitch circle")
def travel_per_revolution(R: MetrePerRad) -> Metre:
    """Travel per revolution of a pinion, pulley or drum.

    ``R`` pitch radius, that is the travel per radian.

    >>> round(travel_per_revolution(0.0375), 6)  # 75 mm * pi
    0.235619
    """
    return 2 * pi * R
