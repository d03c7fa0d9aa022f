"""Pole-changing motors: changing over to the low-speed winding, and what it does to the starting frequency."""

from app.engine.formula import formula
from app.engine.units import (
    KilogramMetre2,
    Metre,
    MetrePerSecond,
    MetrePerSecond2,
    NewtonMetre,
    One,
    PerSecond,
    RadPerSecond,
    Second,
    Watt,
)


@formula(symbol="M_U", unit="N m", source="SEW 2001, 8.3: torque while changing over to the low-speed winding")
def change_over_torque(k_U: One, k_s: One, M_H: NewtonMetre) -> NewtonMetre:
    """Mean braking torque of the motor while it changes over to its low-speed winding.

    ``k_U`` change-over torque over run-up torque of the low-speed winding, about 2.5, ``k_s`` 1 with three phases, 0.5
    with a soft change (two phases), ``M_H`` mean run-up torque of the low-speed winding.

    >>> change_over_torque(2.5, 0.5, 1.2)
    1.5
    """
    return k_U * k_s * M_H


@formula(symbol="t_U", unit="s", source="SEW 2001, 7.9: change-over time")
def change_over_time(
    J_tot: KilogramMetre2, n_2: RadPerSecond, n_1: RadPerSecond, M_U: NewtonMetre, M_L: NewtonMetre
) -> Second:
    """Time from the high to the low speed.

    ``J_tot`` all inertia on the motor shaft, ``n_2`` high and ``n_1`` low speed of the motor, ``M_U`` change-over
    torque, ``M_L`` torque of the load on the motor shaft, losses included, negative where the load drives.

    >>> round(change_over_time(0.0086, 279.6, 70.7, 2.971, 0.369), 3)
    0.538
    """
    return J_tot * (n_2 - n_1) / (M_U + M_L)


@formula(symbol="a_U", unit="m/s2", source="SEW 2001, 7.9: change-over deceleration")
def change_over_deceleration(v: MetrePerSecond, v_1: MetrePerSecond, t_U: Second) -> MetrePerSecond2:
    """Mean deceleration of the load while the motor changes over.

    ``v`` high and ``v_1`` low speed of the load, ``t_U`` change-over time.

    >>> change_over_deceleration(0.5, 0.125, 0.5)
    0.75
    """
    return (v - v_1) / t_U


@formula(symbol="s_U", unit="mm", source="SEW 2001, 7.9: change-over distance")
def change_over_distance(v: MetrePerSecond, v_1: MetrePerSecond, t_U: Second) -> Metre:
    """Path of the load while the motor changes over.

    ``v`` high and ``v_1`` low speed of the load, ``t_U`` change-over time.

    >>> change_over_distance(0.5, 0.125, 0.5)
    0.15625
    """
    return (v + v_1) / 2 * t_U


@formula(symbol="Z", unit="1/h", source="SEW 2001, 8.3: changing over heats the motor besides")
def starting_frequency_with_change(Z: PerSecond, k_th: One) -> PerSecond:
    """Permissible starting frequency of a motor that also changes over before it stops.

    ``Z`` permissible starting frequency without change-over, ``k_th`` factor of the heating, about 0.7; 1.25 where the
    motor is started on its low-speed winding.

    >>> starting_frequency_with_change(200.0, 0.5)
    100.0
    """
    return Z * k_th


@formula(symbol="J_Z", unit="kg m2", source="derived: change-over time of the permissible deceleration")
def least_flywheel_for_change(
    M_U: NewtonMetre, M_L: NewtonMetre, v: MetrePerSecond, v_1: MetrePerSecond, a_p: MetrePerSecond2, n_2: RadPerSecond,
    n_1: RadPerSecond, J_tot: KilogramMetre2,
) -> KilogramMetre2:  # fmt: skip
    """Least additional inertia on the motor shaft with which the change-over stays within the permissible deceleration.

    ``M_U`` change-over torque, ``M_L`` torque of the load on the motor shaft, losses included, ``v`` high and
    ``v_1`` low speed of the load, ``a_p`` its permissible deceleration, ``n_2`` and ``n_1`` the speeds of the motor,
    ``J_tot`` all other inertia on the motor shaft. Negative where none is needed.

    >>> round(least_flywheel_for_change(3.0, 0.2, 0.5, 0.125, 0.75, 280.0, 70.0, 0.0046), 6)
    0.003019
    """
    return (M_U + M_L) * (v - v_1) / (a_p * (n_2 - n_1)) - J_tot


@formula(symbol="M_U/M_N", unit="1", source="SEW 2001, 8.3: estimate before the motor is known")
def change_over_estimate(k_U: One, r_H: One) -> One:
    """Change-over torque over rated torque of the low-speed winding, before the motor is known.

    ``k_U`` change-over torque over run-up torque, ``r_H`` usual run-up torque over rated torque.

    >>> change_over_estimate(2.5, 1.7)
    4.25
    """
    return k_U * r_H


@formula(symbol="P_TU", unit="W", source="SEW 2001, 8.3: power above which the wheels slip while changing over")
def selection_power(P_T: Watt, k_U: One, r_H: One) -> Watt:
    """Largest rated power at the high speed with which the change-over keeps the permissible deceleration.

    ``P_T`` power at the permissible acceleration, ``k_U`` change-over torque over run-up torque, ``r_H`` run-up torque
    over rated torque of the low-speed winding.

    >>> selection_power(850.0, 2.5, 1.7)
    200.0
    """
    return P_T / (k_U * r_H)


@formula(symbol="P_TU", unit="W", source="derived: the same torque at the low speed")
def power_at_low_speed(P: Watt, n_1: RadPerSecond, n_2: RadPerSecond) -> Watt:
    """The power that the torque of the high speed gives at the low speed.

    ``P`` power at the high speed, ``n_1`` low and ``n_2`` high speed of the motor.

    >>> power_at_low_speed(340.0, 70.0, 280.0)
    85.0
    """
    return P * n_1 / n_2


@formula(symbol="z_0", unit="1", source="SEW 2001, 8.3: starts counted in starts without load")
def starting_equivalents(Z_0: PerSecond, Z: PerSecond) -> One:
    """So many starts without load heat the motor as much as one start of this kind.

    ``Z_0`` permitted starts without load, ``Z`` permissible starts of this kind alone.

    >>> starting_equivalents(1200.0, 400.0)
    3.0
    """
    return Z_0 / Z
