"""Induction motors on an inverter: torque over frequency, slip, 87 Hz characteristic, group drives."""

from app.engine.formula import formula, pi, sqrt
from app.engine.units import Ampere, Hertz, MetrePerSecond, NewtonMetre, One, RadPerSecond, Volt


@formula(symbol="M_N(f)", unit="N m", source="SEW 2001, 3.4: constant power above the base frequency")
def weakened_rated_torque(M_N: NewtonMetre, f_1: Hertz, f_2: Hertz) -> NewtonMetre:
    """Rated torque in field weakening.

    ``M_N`` rated torque at the base frequency, ``f_1`` base frequency, ``f_2`` frequency above it.

    >>> weakened_rated_torque(15.0, 50.0, 100.0)
    7.5
    """
    return M_N * f_1 / f_2


@formula(symbol="M_K(f)", unit="N m", source="SEW 2001, 3.4: breakdown torque falls with the square of the frequency")
def weakened_breakdown_torque(M_K: NewtonMetre, f_1: Hertz, f_2: Hertz) -> NewtonMetre:
    """Breakdown torque in field weakening.

    ``M_K`` breakdown torque at the base frequency, ``f_1`` base frequency, ``f_2`` frequency above it.

    >>> weakened_breakdown_torque(35.0, 50.0, 100.0)
    8.75
    """
    return M_K * (f_1 / f_2) ** 2


@formula(symbol="M_K(f)/M", unit="1", source="SEW 2001, 3.4: at least 1.25")
def breakdown_reserve(M_K: NewtonMetre, M: NewtonMetre) -> One:
    """How often the breakdown torque has the torque that is demanded.

    ``M_K`` breakdown torque at this frequency, ``M`` torque demanded at it.

    >>> breakdown_reserve(8.75, 3.5)
    2.5
    """
    return M_K / M


@formula(symbol="f_max", unit="Hz", source="SEW 2001, 3.4: rated power up to a reserve of the breakdown torque")
def highest_frequency_of_rated_power(f_1: Hertz, r_K: One, k_K: One) -> Hertz:
    """Frequency up to which a motor may give its rated power.

    ``f_1`` base frequency, ``r_K`` breakdown torque over rated torque, ``k_K`` reserve that must remain, 1 for none.

    >>> highest_frequency_of_rated_power(50.0, 2.5, 1.25)
    100.0
    """
    return f_1 * r_K / k_K


@formula(symbol="n", unit="rpm", source="derived: the slip depends on the torque alone at constant flux")
def speed_at_frequency(f_2: Hertz, z_p: One, n_S: RadPerSecond, n_N: RadPerSecond, r_M: One) -> RadPerSecond:
    """Speed of a motor at a frequency below the base frequency.

    ``f_2`` frequency, ``z_p`` number of poles, ``n_S`` synchronous and ``n_N`` rated speed at the base frequency,
    ``r_M`` torque over rated torque.

    >>> round(speed_at_frequency(87.0, 4, 157.0796, 146.6077, 1.0) * 30 / 3.14159265, 1)
    2510.0
    """
    return 4 * pi * f_2 / z_p - (n_S - n_N) * r_M


@formula(symbol="n", unit="rpm", source="derived: the slip grows with the square of the frequency in field weakening")
def weakened_speed(f_2: Hertz, f_1: Hertz, z_p: One, n_S: RadPerSecond, n_N: RadPerSecond, r_M: One) -> RadPerSecond:
    """Speed of a motor in field weakening.

    ``f_2`` frequency above the base frequency ``f_1``, ``z_p`` number of poles, ``n_S`` synchronous and ``n_N`` rated
    speed at the base frequency, ``r_M`` torque over the rated torque of the base frequency.

    >>> round(weakened_speed(70.0, 50.0, 4, 157.0796, 146.6077, 50 / 70) * 30 / 3.14159265, 1)
    1960.0
    """
    return 4 * pi * f_2 / z_p - (n_S - n_N) * r_M * (f_2 / f_1) ** 2


@formula(symbol="f", unit="Hz", source="derived: speed and slip of a motor at constant flux")
def frequency_at_speed(omega: RadPerSecond, z_p: One, n_S: RadPerSecond, n_N: RadPerSecond, r_M: One) -> Hertz:
    """Frequency at which a motor runs at a speed.

    ``omega`` speed, ``z_p`` number of poles, ``n_S`` synchronous and ``n_N`` rated speed, ``r_M`` torque over rated
    torque.

    >>> round(frequency_at_speed(146.6077, 4, 157.0796, 146.6077, 1.0), 3)
    50.0
    """
    return (omega + (n_S - n_N) * r_M) * z_p / (4 * pi)


@formula(symbol="f_k", unit="Hz", source="SEW 2001, 3.3: a 230 V winding in delta on an inverter of 400 V")
def corner_frequency(f_1: Hertz, U_1: Volt, U_N: Volt) -> Hertz:
    """Frequency up to which the flux stays constant.

    ``f_1`` rated frequency, ``U_1`` voltage of the inverter, ``U_N`` rated voltage of the winding as connected.

    >>> round(corner_frequency(50.0, 400.0, 230.0), 2)
    86.96
    """
    return f_1 * U_1 / U_N


@formula(symbol="P'/P_N", unit="1", source="SEW 2001, 3.3: power grows with the frequency at constant torque")
def power_gain(f_2: Hertz, f_1: Hertz) -> One:
    """Power at a higher base frequency over rated power, at the same torque.

    ``f_2`` new base frequency, ``f_1`` rated frequency.

    >>> power_gain(87.5, 50.0)
    1.75
    """
    return f_2 / f_1


@formula(symbol="P'/P_N", unit="1", source="SEW 2001, 3.3: delta on the voltage of the star connection")
def power_gain_by_voltage(z_ph: One) -> One:
    """Power of a motor in delta at the voltage of its star connection over rated power.

    ``z_ph`` number of phases, 3.

    >>> round(power_gain_by_voltage(3), 4)
    1.7321
    """
    return sqrt(z_ph)


@formula(symbol="M/M_N", unit="%", source="SEW 2001, 8.4: 150 % current gives 130 % torque")
def torque_ratio(M: NewtonMetre, M_N: NewtonMetre) -> One:
    """Torque over rated torque.

    ``M`` torque demanded, ``M_N`` rated torque of the motor.

    >>> torque_ratio(13.0, 10.0)
    1.3
    """
    return M / M_N


@formula(symbol="R", unit="1", source="SEW 2001, 3.4: speed range")
def speed_range(n_2: RadPerSecond, n_1: RadPerSecond) -> One:
    """Highest over lowest speed.

    ``n_2`` highest and ``n_1`` lowest speed in steady running.

    >>> speed_range(150.0, 15.0)
    10.0
    """
    return n_2 / n_1


@formula(symbol="I", unit="A", source="SEW 2001, 11.1: currents of a group drive add up")
def group_current(n_M: One, I_N: Ampere) -> Ampere:
    """Current of several motors on one inverter.

    ``n_M`` number of motors, ``I_N`` rated current of one.

    >>> round(group_current(3, 4.9), 3)
    14.7
    """
    return n_M * I_N


@formula(symbol="f", unit="Hz", source="SEW 2001, 8.4: frequency in proportion to the speed, slip left out")
def frequency_in_proportion(f_1: Hertz, v: MetrePerSecond, v_1: MetrePerSecond) -> Hertz:
    """Frequency for another speed of the same drive, as if its slip grew with the speed.

    ``f_1`` frequency at the speed ``v_1``, ``v`` the other speed.

    >>> frequency_in_proportion(30.0, 0.5, 0.2)
    75.0
    """
    return f_1 * v / v_1


@formula(symbol="f_S", unit="Hz", source="derived: one turn of the rotating field per pair of poles")
def synchronous_frequency(omega: RadPerSecond, z_p: One) -> Hertz:
    """Frequency at which the rotating field turns at a speed.

    ``omega`` speed, ``z_p`` number of poles.

    >>> round(synchronous_frequency(157.07963267948966, 4), 9)  # 1500 rpm
    50.0
    """
    return omega * z_p / (4 * pi)
