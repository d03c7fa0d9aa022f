"""From a moving body to the shaft that moves it, and from shaft to shaft: force to torque, speed to speed.

``A`` is always the transmission constant: travel per radian of the shaft. It is the pitch radius of a pulley, wheel or
pinion, and lead / 2 pi of a screw.
"""

from app.engine.formula import formula, total
from app.engine.units import (
    Kilogram,
    KilogramMetre2,
    Metre,
    MetrePerRad,
    MetrePerSecond,
    MetrePerSecond2,
    Newton,
    NewtonMetre,
    One,
    Rad,
    RadPerSecond,
    RadPerSecond2,
    Watt,
)


@formula(symbol="M", unit="N m", source="derived: power balance F*v = M*omega without loss")
def torque_of_force(F: Newton, A: MetrePerRad) -> NewtonMetre:
    """Torque on a shaft that balances a force on what it moves, without loss; signed as the force.

    ``F`` force, ``A`` transmission constant: travel per radian, equal to the radius where the body moves on a radius.

    >>> torque_of_force(400.0, 0.05)
    20.0
    """
    return F * A


@formula(symbol="omega", unit="rpm", source="derived: v = A*omega")
def shaft_speed(v: MetrePerSecond, A: MetrePerRad) -> RadPerSecond:
    """Angular speed of the shaft that moves a body at a speed; signed as the speed.

    ``v`` speed, ``A`` transmission constant: travel per radian, equal to the radius where the body moves on a radius.

    >>> shaft_speed(0.5, 0.05)
    10.0
    """
    return v / A


@formula(symbol="v", unit="m/s", source="derived: travel per radian times angular speed")
def linear_speed(omega: RadPerSecond, A: MetrePerRad) -> MetrePerSecond:
    """Speed of a load from the speed of a shaft.

    ``omega`` angular speed of the shaft, ``A`` travel of the load per radian of that shaft.

    >>> linear_speed(100.0, 0.005)
    0.5
    """
    return omega * A


@formula(symbol="alpha_s", unit="rad/s2", source="derived: a = A*d(omega)/dt")
def shaft_acceleration(a: MetrePerSecond2, A: MetrePerRad) -> RadPerSecond2:
    """Angular acceleration of the shaft that accelerates a body; signed as the acceleration.

    ``a`` acceleration, ``A`` transmission constant: travel per radian.

    >>> shaft_acceleration(5.0, 0.05)
    100.0
    """
    return a / A


@formula(symbol="M", unit="N m", source="derived: Newton's second law of rotation")
def acceleration_torque(J: KilogramMetre2, alpha_s: RadPerSecond2) -> NewtonMetre:
    """Torque that accelerates an inertia, signed as the angular acceleration.

    ``J`` inertia on the shaft, ``alpha_s`` angular acceleration of the shaft.

    >>> acceleration_torque(0.0125, 800.0)
    10.0
    """
    return J * alpha_s


@formula(symbol="M", unit="N m", source="derived: torques on one shaft add up with their signs")
def sum_of_torques(M_k: NewtonMetre) -> NewtonMetre:
    """Sum of the torques on one shaft.

    ``M_k`` signed torques, shape (n,).

    >>> sum_of_torques([12.0, -2.0])
    10.0
    """
    return total(M_k)


@formula(symbol="M_1", unit="N m", source="derived: power balance of a stage without loss")
def torque_before_ratio(M: NewtonMetre, i: One) -> NewtonMetre:
    """Torque on the fast shaft of a stage without loss; the loss comes from the efficiency rule.

    ``M`` torque on the slow shaft, ``i`` ratio fast / slow speed.

    >>> torque_before_ratio(50.0, 10.0)
    5.0
    """
    return M / i


@formula(symbol="omega_1", unit="rpm", source="derived: definition of the ratio")
def speed_before_ratio(omega: RadPerSecond, i: One) -> RadPerSecond:
    """Angular speed of the fast shaft of a stage.

    ``omega`` angular speed of the slow shaft, ``i`` ratio fast / slow speed.

    >>> speed_before_ratio(10.0, 5.0)
    50.0
    """
    return omega * i


@formula(symbol="P", unit="W", source="derived: force times speed")
def mechanical_power(F: Newton, v: MetrePerSecond) -> Watt:
    """Mechanical power of a force on a body that moves; positive where the force drives the body.

    ``F`` force in the direction of positive speed, ``v`` speed.

    >>> mechanical_power(400.0, 0.5)
    200.0
    """
    return F * v


@formula(symbol="M", unit="N m", source="derived: power over speed")
def torque_of_power(P: Watt, omega: RadPerSecond) -> NewtonMetre:
    """Torque of a shaft that carries a power.

    ``P`` power, ``omega`` speed, greater than zero.

    >>> torque_of_power(8000.0, 100.0)
    80.0
    """
    return P / omega


@formula(symbol="P_D", unit="W", source="SEW 2001, 8.1: power that accelerates a load")
def dynamic_power(m: Kilogram, a: MetrePerSecond2, v: MetrePerSecond, eta: One) -> Watt:
    """Power at the motor shaft that accelerates a load, at the end of the acceleration.

    ``m`` mass, ``a`` acceleration, ``v`` speed reached, ``eta`` efficiency between motor and load.

    >>> dynamic_power(1000.0, 0.5, 1.0, 0.8)
    625.0
    """
    return m * a * v / eta


@formula(symbol="A_1", unit="mm/rad", source="derived: definition of the ratio")
def travel_before_ratio(A: MetrePerRad, i: One) -> MetrePerRad:
    """Way of the load per radian of the fast side of a stage.

    ``A`` way of the load per radian of its slow side, ``i`` ratio.

    >>> travel_before_ratio(0.125, 100.0)
    0.00125
    """
    return A / i


@formula(symbol="s", unit="mm", source="derived: travel per radian times angle")
def linear_way(phi: Rad, A: MetrePerRad) -> Metre:
    """Way of a load from the angle of a shaft.

    ``phi`` angle of the shaft, ``A`` travel of the load per radian of that shaft.

    >>> linear_way(2.0, 0.5)
    1.0
    """
    return phi * A


@formula(symbol="P_D", unit="W", source="SEW 2001, 12.1: power with the losses of everything between motor and load")
def dynamic_power_of_torque(P: Watt, eta: One) -> Watt:
    """Power at the motor shaft that drives a load.

    ``P`` power at the load, ``eta`` efficiency between motor and load.

    >>> dynamic_power_of_torque(90.0, 0.9)
    100.0
    """
    return P / eta
