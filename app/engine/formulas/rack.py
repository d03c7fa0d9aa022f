"""Rack and pinion: pitch circle and travel, straight and helical teeth."""

from app.engine.formula import cos, formula, pi, tan
from app.engine.units import Metre, MetrePerRad, Newton, One, Rad


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


@formula(symbol="F_r", unit="N", source="derived: normal force of a tooth, split along and across the pitch line")
def pinion_radial_force(F_t: Newton, alpha_n: Rad, beta: Rad) -> Newton:
    """Force that pushes pinion and rack apart; the shaft of the drive must bear it beside the tangential force.

    ``F_t`` tangential force, ``alpha_n`` normal pressure angle, ``beta`` helix angle.

    >>> round(pinion_radial_force(1000.0, 0.3490658503988659, 0.0), 2)  # 1000 N * tan(20 deg)
    363.97
    """
    return F_t * tan(alpha_n) / cos(beta)


@formula(symbol="F_x", unit="N", source="derived: component of the tooth force along the shaft")
def pinion_axial_force(F_t: Newton, beta: Rad) -> Newton:
    """Force along the pinion's shaft with helical teeth.

    ``F_t`` tangential force, ``beta`` helix angle.

    >>> round(pinion_axial_force(1000.0, 0.3490658503988659), 2)  # 1000 N * tan(20 deg)
    363.97
    """
    return F_t * tan(beta)
