"""Stopping a line-fed drive by its brake: delay, time, path, work, life.

Speeds and torques stand at the motor shaft; efficiency is not spelled here (``app.engine.formulas.efficiency``).
"""

from app.engine.formula import formula, total
from app.engine.units import (
    Joule,
    KilogramMetre2,
    Metre,
    MetrePerSecond,
    MetrePerSecond2,
    NewtonMetre,
    One,
    PerSecond,
    RadPerSecond,
    Second,
)


@formula(symbol="dn", unit="rpm", source="SEW 2001, 9.1: speed change until the brake applies")
def speed_change_in_delay(M_L: NewtonMetre, J_tot: KilogramMetre2, t_2: Second) -> RadPerSecond:
    """Change of the motor speed between cut-off and braking: negative while lifting, positive while lowering.

    ``M_L`` torque of the load on the motor shaft, losses included, positive against the rotation, ``J_tot`` all inertia
    on the motor shaft, ``t_2`` application time of the brake.

    >>> speed_change_in_delay(-4.0, 0.008, 0.015)
    7.5
    """
    return -M_L * t_2 / J_tot


@formula(symbol="t_c", unit="s", source="derived: torque balance at the motor shaft without motor and brake")
def coasting_time(J_tot: KilogramMetre2, omega: RadPerSecond, M_L: NewtonMetre) -> Second:
    """Time in which a load that is cut off comes to rest by itself.

    ``J_tot`` all inertia on the motor shaft, ``omega`` speed at cut-off, ``M_L`` torque of the load on the motor shaft,
    losses included, positive against the rotation.

    >>> round(coasting_time(0.0225, 150.0, 12.5), 9)
    0.27
    """
    return J_tot * omega / M_L


@formula(symbol="t_B", unit="s", source="SEW 2001, 7.9: braking time")
def braking_time(J_tot: KilogramMetre2, omega: RadPerSecond, M_B: NewtonMetre, M_L: NewtonMetre) -> Second:
    """Time from the application of the brake to standstill.

    ``J_tot`` all inertia on the motor shaft, ``omega`` speed at which the brake applies, ``M_B`` braking torque,
    ``M_L`` torque of the load on the motor shaft, losses included, negative where the load drives.

    >>> round(braking_time(0.0106, 282.74, 2.5, 0.365), 3)
    1.046
    """
    return J_tot * omega / (M_B + M_L)


@formula(symbol="a_B", unit="m/s2", source="SEW 2001, 7.9: braking deceleration")
def braking_deceleration(v: MetrePerSecond, t_B: Second) -> MetrePerSecond2:
    """Mean deceleration while the brake acts.

    ``v`` speed of the load at which the brake applies, ``t_B`` braking time.

    >>> braking_deceleration(0.5, 1.0)
    0.5
    """
    return v / t_B


@formula(symbol="s_B", unit="mm", source="SEW 2001, 7.9: stopping distance")
def stopping_distance(v: MetrePerSecond, v_0: MetrePerSecond, t_2: Second, t_B: Second) -> Metre:
    """Path from cut-off to standstill.

    ``v`` mean speed until the brake applies, ``v_0`` speed at which it applies, ``t_2`` application time, ``t_B``
    braking time.

    >>> stopping_distance(0.5, 0.5, 0.005, 1.0)
    0.2525
    """
    return v * t_2 + v_0 * t_B / 2


@formula(symbol="X_B", unit="mm", source="SEW 2001, 7.9: braking tolerance of about 12 %")
def stopping_accuracy(k_X: One, s_B: Metre) -> Metre:
    """Deviation of the stopping point to either side.

    ``k_X`` tolerance of the stopping distance, ``s_B`` stopping distance.

    >>> round(stopping_accuracy(0.12, 0.2525), 5)
    0.0303
    """
    return k_X * s_B


@formula(symbol="W_B", unit="J", source="SEW 2001, 7.9: braking work")
def braking_work(M_B: NewtonMetre, omega: RadPerSecond, t_B: Second) -> Joule:
    """Work that the brake turns into heat in one stop.

    ``M_B`` braking torque, ``omega`` speed at which the brake applies, ``t_B`` braking time.

    >>> braking_work(2.5, 280.0, 1.0)
    350.0
    """
    return M_B * omega * t_B / 2


@formula(symbol="W_B", unit="J", source="SEW 2001, 8.1: mean braking work of a mixed duty")
def mean_braking_work(W_c: Joule, z_c: One) -> Joule:
    """Work of one braking on average.

    ``W_c`` braking work of a whole cycle, ``z_c`` brakings in a cycle.

    >>> mean_braking_work(612.0, 2.0)
    306.0
    """
    return W_c / z_c


@formula(symbol="L_B", unit="h", source="SEW 2001, 7.9: brake life until readjustment")
def brake_life(W_N: Joule, W_B: Joule, Z_B: PerSecond) -> Second:
    """Operating time until the brake must be readjusted.

    ``W_N`` braking work until readjustment, ``W_B`` mean work of one braking, ``Z_B`` brakings per time.

    >>> round(brake_life(120e6, 306.0, 150 / 3600) / 3600, 1)
    2614.4
    """
    return W_N / (W_B * Z_B)


@formula(symbol="M_Bmax", unit="N m", source="derived: deceleration at which the wheels slip or the goods topple")
def braking_torque_of_deceleration(
    J_tot: KilogramMetre2, a_p: MetrePerSecond2, omega: RadPerSecond, v: MetrePerSecond, M_L: NewtonMetre
) -> NewtonMetre:
    """Braking torque that gives a deceleration.

    ``J_tot`` all inertia on the motor shaft, ``a_p`` deceleration of the load, ``omega`` motor speed and ``v`` speed of
    the load at the same time, ``M_L`` torque of the load on the motor shaft, losses included.

    >>> round(braking_torque_of_deceleration(0.00656173, 0.73575, 282.7433, 0.5, 0.1824391), 3)
    2.548
    """
    return J_tot * a_p * omega / v - M_L


@formula(symbol="W_B", unit="J", source="derived: work of all brakings of a cycle")
def braking_work_of_cycle(z_k: One, W_k: Joule) -> Joule:
    """Braking work of all stops of a cycle.

    ``z_k`` brakings of each kind in a cycle, ``W_k`` work of one of them.

    >>> braking_work_of_cycle([1.0, 2.0], [100.0, 50.0])
    200.0
    """
    return total(z_k * W_k)


@formula(symbol="M_B/M_L", unit="1", source="SEW 2001, 9.1: hoists take about twice the load torque")
def brake_torque_ratio(M_B: NewtonMetre, M_L: NewtonMetre) -> One:
    """How often the brake holds the load.

    ``M_B`` braking torque, ``M_L`` torque of the load on the motor shaft.

    >>> brake_torque_ratio(20.0, -5.0)
    4.0
    """
    return M_B / abs(M_L)


@formula(symbol="L_B", unit="1", source="SEW 2001, 8.1: days between two readjustments")
def brake_life_in_days(L_B: Second, t_d: Second) -> One:
    """Working days until the brake must be readjusted.

    ``L_B`` operating time until readjustment, ``t_d`` operating time per day.

    >>> brake_life_in_days(2600 * 3600.0, 8 * 3600.0)
    325.0
    """
    return L_B / t_d


@formula(symbol="z_B", unit="1", source="SEW 2001, 9.2: braking strokes in the time that a rating refers to")
def brakings_in_time(z_c: One, t: Second, t_cyc: Second) -> One:
    """How often is braked in a time.

    ``z_c`` brakings in a cycle, ``t`` time, ``t_cyc`` length of a cycle.

    >>> brakings_in_time(2.0, 120.0, 30.0)
    8.0
    """
    return z_c * t / t_cyc
