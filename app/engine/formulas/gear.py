"""Gear unit of a servo drive: bounds of its ratio, and the torque of an emergency stop."""

from app.engine.formula import formula, sqrt
from app.engine.units import Kilogram, KilogramMetre2, NewtonMetre, One, RadPerSecond


@formula(symbol="i_J", unit="1", source="derived: J_L / i^2 <= lambda * J_M")
def ratio_for_inertia_limit(J_L: KilogramMetre2, lambda_J: One, J_M: KilogramMetre2) -> One:
    """Least ratio that keeps the limit of the inertia ratio, without inertia of the gear unit; a bound to round up.

    ``J_L`` inertia of the load at the output shaft, ``lambda_J`` permitted ratio of load to motor inertia, ``J_M``
    inertia of the motor.

    >>> ratio_for_inertia_limit(0.09, 10.0, 0.001)  # sqrt(0.09 / 0.01)
    3.0
    """
    return sqrt(J_L / (lambda_J * J_M))


@formula(symbol="i_n", unit="1", source="derived: i * omega_L <= permitted motor speed")
def ratio_for_speed(omega_max: RadPerSecond, omega_L: RadPerSecond) -> One:
    """Largest ratio that keeps the permitted motor speed; a bound to round down.

    ``omega_max`` permitted speed of the motor, ``omega_L`` highest speed of the output shaft, > 0.

    >>> ratio_for_speed(300.0, 20.0)
    15.0
    """
    return omega_max / omega_L


@formula(symbol="n_L,max", unit="rpm", source="derived: definition of the ratio")
def highest_load_speed(omega_max: RadPerSecond, i: One) -> RadPerSecond:
    """Highest speed of the output shaft at the permitted motor speed.

    ``omega_max`` permitted speed of the motor, ``i`` ratio motor / output shaft.

    >>> highest_load_speed(300.0, 15.0)
    20.0
    """
    return omega_max / i


@formula(symbol="T_em", unit="N m", source="derived: brake torque through the ratio, no loss taken")
def emergency_torque_of_brake(M_B: NewtonMetre, i: One) -> NewtonMetre:
    """Torque at the output of a gear unit when the motor brake closes while the axis moves.

    ``M_B`` torque of the brake on the motor shaft, ``i`` ratio. On the safe side: the part that brakes the rotor itself
    is not taken off.

    >>> emergency_torque_of_brake(3.0, 10.0)
    30.0
    """
    return M_B * i


@formula(symbol="T_em", unit="N m", source="derived: largest torque in operation times a given factor")
def emergency_torque_by_factor(T_max: NewtonMetre, k_em: One) -> NewtonMetre:
    """Torque at the output of a gear unit in an emergency stop, as a multiple of the largest torque in operation.

    ``T_max`` largest torque at the output in operation, ``k_em`` how many times more the stop asks for.

    >>> emergency_torque_by_factor(40.0, 2.0)
    80.0
    """
    return T_max * k_em


@formula(symbol="T_2max", unit="N m", source="derived: largest magnitude over the cycle")
def peak_output_torque(T_2: NewtonMetre) -> NewtonMetre:
    """Largest torque at the output of the gear unit, both directions of motion, unsigned.

    ``T_2`` torque at the output in the segment that decides, signed.

    >>> peak_output_torque(-40.0)
    40.0
    """
    return abs(T_2)


@formula(symbol="m_M/m_G", unit="1", source="SEW 2001, 6.3: support of the motor")
def motor_mass_ratio(m_M: Kilogram, m_gu: Kilogram) -> One:
    """Mass of the motor over that of the gear unit which carries it.

    ``m_M`` mass of the motor, ``m_gu`` mass of the gear unit.

    >>> motor_mass_ratio(30.0, 10.0)
    3.0
    """
    return m_M / m_gu
