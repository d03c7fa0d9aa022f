"""Induction motors on the mains: rated torque, run-up, permissible starting frequency.

Efficiency is not spelled here: external inertia and load torque come in as they act on the motor shaft, losses
included by the direction of power (``app.engine.formulas.efficiency``).
"""

from app.engine.formula import formula, pi, total
from app.engine.units import (
    Hertz,
    KilogramMetre2,
    MetrePerSecond,
    MetrePerSecond2,
    NewtonMetre,
    One,
    PerSecond,
    RadPerSecond,
    Second,
    Watt,
)


@formula(symbol="M_N", unit="N m", source="SEW 2001, 7.1: torque from power and speed")
def rated_torque(P_N: Watt, n_N: RadPerSecond) -> NewtonMetre:
    """Rated torque of a motor.

    ``P_N`` rated power, ``n_N`` rated speed.

    >>> round(rated_torque(550.0, 2700 * 3.141592653589793 / 30), 4)
    1.9452
    """
    return P_N / n_N


@formula(symbol="n_S", unit="rpm", source="IEC 60034-1: synchronous speed")
def synchronous_speed(f_1: Hertz, z_p: One) -> RadPerSecond:
    """Speed of the rotating field.

    ``f_1`` frequency of the mains, ``z_p`` number of poles.

    >>> round(synchronous_speed(50.0, 2) * 30 / 3.141592653589793, 6)
    3000.0
    """
    return 4 * pi * f_1 / z_p


@formula(symbol="M_H", unit="N m", source="SEW 2001, 7.9: mean run-up torque")
def run_up_torque(r_H: One, M_N: NewtonMetre) -> NewtonMetre:
    """Mean torque of the motor over its run-up.

    ``r_H`` mean run-up torque over rated torque, ``M_N`` rated torque.

    >>> round(run_up_torque(1.9, 1.9452), 4)
    3.6959
    """
    return r_H * M_N


@formula(symbol="M_H", unit="N m", source="IEC 60034-12: star connection gives a third of the torque")
def star_run_up_torque(M_H: NewtonMetre) -> NewtonMetre:
    """Mean run-up torque while the winding is connected in star.

    ``M_H`` mean run-up torque in delta.

    >>> star_run_up_torque(30.0)
    10.0
    """
    return M_H / 3


@formula(symbol="M_m", unit="N m", source="derived: mean over the speed, straight between the points of the curve")
def mean_torque_over_speed(M_a: NewtonMetre, M_b: NewtonMetre, n_a: RadPerSecond, n_b: RadPerSecond) -> NewtonMetre:
    """Mean torque of a load whose torque depends on the speed, over a range of speed.

    Step by step along its curve: ``M_a`` torque at the lower speed ``n_a`` and ``M_b`` at the higher speed ``n_b`` of
    each step, shape (n,).

    >>> mean_torque_over_speed([0.0, 2.0], [2.0, 8.0], [0.0, 50.0], [50.0, 100.0])
    3.0
    """
    return total((M_a + M_b) / 2 * (n_b - n_a)) / total(n_b - n_a)


@formula(symbol="eta_T", unit="1", source="SEW 2001, 8.1: efficiencies of load and gear unit multiply")
def total_efficiency(eta_L: One, eta_G: One) -> One:
    """Efficiency between motor shaft and load.

    ``eta_L`` efficiency of the mechanism, ``eta_G`` efficiency of the gear unit.

    >>> round(total_efficiency(0.9, 0.95), 3)
    0.855
    """
    return eta_L * eta_G


@formula(symbol="t_A", unit="s", source="SEW 2001, 7.9: run-up time")
def run_up_time(J_tot: KilogramMetre2, omega: RadPerSecond, M_H: NewtonMetre, M_L: NewtonMetre) -> Second:
    """Time in which a line-fed motor runs up.

    ``J_tot`` all inertia on the motor shaft, ``omega`` speed reached, ``M_H`` mean run-up torque, ``M_L`` torque of the
    load on the motor shaft, losses included, negative where it helps.

    >>> round(run_up_time(0.0137, 282.74, 3.6959, 0.4991), 3)
    1.212
    """
    return J_tot * omega / (M_H - M_L)


@formula(symbol="t_A", unit="s", source="derived: torque balance at the motor shaft, step by step over the speed")
def run_up_time_over_speed(
    J_tot: KilogramMetre2, M_H: NewtonMetre, M_L: NewtonMetre, n_a: RadPerSecond, n_b: RadPerSecond
) -> Second:
    """Time of the run-up against a torque that depends on the speed.

    ``J_tot`` all inertia on the motor shaft, ``M_H`` mean run-up torque, ``M_L`` torque of the load on the motor shaft
    in the middle of each step of the speed from ``n_a`` to ``n_b``, losses included, shape (n,).

    >>> run_up_time_over_speed(2.0, 10.0, [0.0, 6.0], [0.0, 50.0], [50.0, 100.0])
    35.0
    """
    return total(J_tot * (n_b - n_a) / (M_H - M_L))


@formula(symbol="M_Le", unit="N m", source="derived: the constant torque with the same run-up time")
def equivalent_load_torque(M_H: NewtonMetre, J_tot: KilogramMetre2, omega: RadPerSecond, t_A: Second) -> NewtonMetre:
    """Constant torque of the load with which the run-up would take as long.

    ``M_H`` mean run-up torque, ``J_tot`` all inertia on the motor shaft, ``omega`` motor speed reached, ``t_A`` run-up
    time.

    >>> round(equivalent_load_torque(10.0, 2.0, 100.0, 35.0), 4)
    4.2857
    """
    return M_H - J_tot * omega / t_A


@formula(symbol="n", unit="rpm", source="derived: straight between two points of the curve of the load")
def speed_at_torque(
    M_H: NewtonMetre, M_a: NewtonMetre, M_b: NewtonMetre, n_a: RadPerSecond, n_b: RadPerSecond
) -> RadPerSecond:
    """Speed at which the load takes all of the run-up torque, so that the motor becomes no faster.

    ``M_H`` mean run-up torque, ``M_a`` and ``M_b`` torque of the load with losses at the speeds ``n_a`` and ``n_b``
    before and behind it.

    >>> speed_at_torque(33.0, 30.0, 40.0, 90.0, 100.0)
    93.0
    """
    return n_a + (n_b - n_a) * (M_H - M_a) / (M_b - M_a)


@formula(symbol="M_L", unit="N m", source="derived: a constant part and one with the square of the speed")
def torque_at_speed(
    M_a: NewtonMetre, M_b: NewtonMetre, n_a: RadPerSecond, n_b: RadPerSecond, n: RadPerSecond
) -> NewtonMetre:
    """Torque of a load at a speed beside two points of its curve: M = A + B n^2 through both, as fans and pumps have.

    ``M_a`` and ``M_b`` torque at the speeds ``n_a`` and ``n_b``, ``n`` the speed.

    >>> torque_at_speed(13.0, 28.0, 1.0, 2.0, 3.0)
    53.0
    """
    return M_a + (M_b - M_a) * (n**2 - n_a**2) / (n_b**2 - n_a**2)


@formula(symbol="J_Z", unit="kg m2", source="derived: run-up time of the permissible acceleration")
def least_flywheel(
    M_H: NewtonMetre, M_L: NewtonMetre, omega: RadPerSecond, v: MetrePerSecond, a_p: MetrePerSecond2,
    J_tot: KilogramMetre2,
) -> KilogramMetre2:  # fmt: skip
    """Least additional inertia on the motor shaft with which the run-up stays within the permissible acceleration.

    ``M_H`` mean run-up torque, ``M_L`` torque of the load on the motor shaft, losses included, ``omega`` motor speed
    reached, ``v`` speed of the load, ``a_p`` its permissible acceleration, ``J_tot`` all other inertia on the motor
    shaft. Negative where none is needed.

    >>> round(least_flywheel(3.695931, 0.2495662, 282.7433, 0.5, 0.73575, 0.000551 + 0.0054863), 6)
    0.002246
    """
    return (M_H - M_L) * v / (a_p * omega) - J_tot


@formula(symbol="K_J", unit="1", source="SEW 2001, 7.9: inertia factor of the starting frequency")
def inertia_factor(J_M: KilogramMetre2, J_tot: KilogramMetre2) -> One:
    """Share of the starting frequency that remains because of the inertia to be started.

    ``J_M`` inertia of the motor with its brake, ``J_tot`` all inertia on the motor shaft.

    >>> inertia_factor(0.01, 0.04)
    0.25
    """
    return J_M / J_tot


@formula(symbol="K_M", unit="1", source="SEW 2001, 7.9: torque factor of the starting frequency")
def load_torque_factor(M_L: NewtonMetre, M_H: NewtonMetre) -> One:
    """Share of the starting frequency that remains because of the load torque.

    ``M_L`` torque of the load on the motor shaft, losses included; a load that helps is counted as if it opposed the
    start, which is on the safe side. ``M_H`` mean run-up torque.

    >>> load_torque_factor(-1.0, 4.0)
    0.75
    """
    return 1 - abs(M_L) / M_H


@formula(symbol="K_M", unit="1", source="derived: losses of the run-up fall with its time")
def physical_load_torque_factor(M_L: NewtonMetre, M_H: NewtonMetre) -> One:
    """Torque factor that counts the help of a load that drives: above 1.

    ``M_L`` torque of the load on the motor shaft, losses included, negative where it helps, ``M_H`` mean run-up torque.

    >>> physical_load_torque_factor(-1.0, 4.0)
    1.25
    """
    return 1 - M_L / M_H


@formula(symbol="Z", unit="1/h", source="SEW 2001, 7.9: permissible starting frequency")
def permissible_starting_frequency(Z_0: PerSecond, K_J: One, K_M: One, K_P: One) -> PerSecond:
    """Starts that a line-fed motor bears, by its heating.

    ``Z_0`` permitted starts without load, ``K_J`` inertia factor, ``K_M`` torque factor, ``K_P`` factor of static power
    and duty.

    >>> round(permissible_starting_frequency(4600.0, 0.05, 0.9, 0.7), 6)
    144.9
    """
    return Z_0 * K_J * K_M * K_P


@formula(symbol="Z_c", unit="1/h", source="SEW 2001, 8.3: mixed duty; heating of the starts adds up")
def permissible_cycles(z_k: One, Z_k: PerSecond) -> PerSecond:
    """Cycles of several starts that the motor bears: 1 / sum(1 / Z) over all starts of a cycle.

    ``z_k`` starts of each kind in a cycle, ``Z_k`` permissible frequency of starts of this kind alone.

    >>> round(permissible_cycles([1.0, 1.0], [120.0, 240.0]), 6)
    80.0
    """
    return 1 / total(z_k / Z_k)


@formula(symbol="n", unit="rpm", source="derived: straight characteristic between synchronous and rated speed")
def oversynchronous_speed(n_S: RadPerSecond, n_N: RadPerSecond, M_L: NewtonMetre, M_N: NewtonMetre) -> RadPerSecond:
    """Speed of a motor that its load drives.

    ``n_S`` synchronous speed, ``n_N`` rated speed, ``M_L`` torque of the load on the motor shaft, negative where it
    drives, ``M_N`` rated torque.

    >>> oversynchronous_speed(157.0, 147.0, -5.0, 10.0)
    162.0
    """
    return n_S - (n_S - n_N) * M_L / M_N


@formula(symbol="P_S/P_N", unit="1", source="SEW 2001, 7.9: relative static power")
def relative_static_power(P_S: Watt, P_N: Watt) -> One:
    """Static power over rated power, losses included.

    ``P_S`` power in steady running, ``P_N`` rated power of the motor.

    >>> relative_static_power(142.0, 568.0)
    0.25
    """
    return P_S / P_N


@formula(symbol="P_zul", unit="kW", source="SEW 2001, 2.2: derating by temperature and altitude, increase by duty")
def permitted_power(P_N: Watt, f_T: One, f_H: One, K: One) -> Watt:
    """Power that the motor may give all the time in its surroundings and duty.

    ``P_N`` rated power, ``f_T`` factor of the ambient temperature, ``f_H`` factor of the altitude, ``K`` power increase
    factor of the duty type.

    >>> round(permitted_power(1000.0, 0.92, 0.97, 1.0), 3)
    892.4
    """
    return P_N * f_T * f_H * K


@formula(symbol="Z", unit="1/h", source="derived: heating of two starts adds up")
def least_partner_frequency(Z: PerSecond, Z_k: PerSecond) -> PerSecond:
    """Least permissible frequency of one start beside another, so that a number of cycles is reached.

    ``Z`` cycles demanded, ``Z_k`` permissible frequency of the other start.

    >>> round(least_partner_frequency(100.0, 200.0), 6)
    200.0
    """
    return Z * Z_k / (Z_k - Z)


@formula(symbol="K_P", unit="1", source="derived: the starting frequency is proportional to the factor")
def required_factor(K_P: One, Z: PerSecond, Z_k: PerSecond) -> One:
    """Factor of static power and duty at which a starting frequency is reached.

    ``K_P`` factor with which ``Z_k`` was calculated, ``Z`` frequency that is needed.

    >>> required_factor(0.8, 100.0, 200.0)
    0.4
    """
    return K_P * Z / Z_k
