"""Rotary loads: unbalance and bearing friction."""

from app.engine.formula import cos, formula, sin
from app.engine.units import Kilogram, Metre, MetrePerSecond2, NewtonMetre, One, Rad


@formula(symbol="M_u", unit="N m", source="derived: moment of the weight about a tilted axis")
def unbalance_amplitude(m_u: Kilogram, g: MetrePerSecond2, r_u: Metre, delta: Rad) -> NewtonMetre:
    """Largest torque of an eccentric mass: its arm lies level.

    ``m_u`` eccentric mass, ``g`` gravity, ``r_u`` its distance from the axis, ``delta`` tilt of the axis of rotation
    against the vertical: 0 for a vertical axis (no torque), pi/2 for a horizontal one.

    >>> round(unbalance_amplitude(10.0, 9.81, 0.2, 1.5707963267948966), 6)
    19.62
    """
    return m_u * g * r_u * sin(delta)


@formula(symbol="M_u", unit="N m", source="derived: moment of the weight about a tilted axis")
def unbalance_torque(M_u0: NewtonMetre, phi: Rad) -> NewtonMetre:
    """Torque of an eccentric mass at an angle, positive when the drive must lift it in positive direction.

    ``M_u0`` amplitude, ``phi`` angle of the arm from level, rising in the positive direction of rotation.

    >>> unbalance_torque(19.62, 0.0)
    19.62
    """
    return M_u0 * cos(phi)


@formula(symbol="M_r", unit="N m", source="SEW 2001, 7.4, bearing friction: mu_L*F*d/2")
def bearing_friction_torque(mu_L: One, m: Kilogram, g: MetrePerSecond2, d_L: Metre) -> NewtonMetre:
    """Friction torque of the bearings that carry a weight; unsigned, it opposes the rotation.

    ``mu_L`` coefficient of bearing friction, ``m`` carried mass, ``g`` gravity, ``d_L`` mean bearing diameter.

    >>> round(bearing_friction_torque(0.005, 100.0, 9.81, 0.2), 4)  # 0.005 * 981 N * 0.1 m
    0.4905
    """
    return mu_L * m * g * d_L / 2
