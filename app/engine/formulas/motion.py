"""Kinematics of one move: from standstill to a speed, on at that speed, and back to standstill.

All lengths, speeds and accelerations are unsigned here; the direction of a move is no matter of its shape. A rotary
move obeys the same formulas with angle, angular speed and angular acceleration (:mod:`app.engine.motion.rotary`).

Symbols: ``s`` distance, ``t`` time of the motion without settling, ``v`` peak speed, ``a`` acceleration and ``a_d``
deceleration (peak values), ``t_A`` and ``t_D`` time of accelerating and of braking, ``j`` jerk, ``r_a`` deceleration /
acceleration, ``lambda_j`` share of an accelerating or braking phase in which the acceleration changes.
"""

from app.engine.formula import formula, maximum, minimum, sqrt, total
from app.engine.units import Metre, MetrePerSecond, MetrePerSecond2, MetrePerSecond3, One, Second


@formula(symbol="t_A", unit="s", source="SEW 2001, 7.1")
def ramp_time(v: MetrePerSecond, a: MetrePerSecond2) -> Second:
    """Time from standstill to a speed, or back, at constant acceleration.

    ``v`` speed, ``a`` acceleration > 0.

    >>> ramp_time(0.77, 0.5)
    1.54
    """
    return v / a


@formula(
    symbol="s_A", unit="m", source="SEW 2001, 7.1; derived: the mean speed of a symmetric ramp is half its end speed"
)
def ramp_distance(v: MetrePerSecond, t_A: Second) -> Metre:
    """Distance from standstill to a speed, or back; holds for constant acceleration and for a symmetric S-curve.

    ``v`` speed, ``t_A`` time of the ramp. At constant acceleration ``a`` it is v**2 / (2 * a).

    >>> ramp_distance(2.0, 1.5)
    1.5
    """
    return v * t_A / 2


@formula(symbol="a", unit="m/s2", source="SEW 2001, 7.1")
def ramp_acceleration(v: MetrePerSecond, t_A: Second) -> MetrePerSecond2:
    """Constant acceleration that reaches a speed in a time.

    ``v`` speed, ``t_A`` time of the ramp > 0.

    >>> ramp_acceleration(0.5, 0.2)
    2.5
    """
    return v / t_A


@formula(symbol="t", unit="s", source="derived: both ramps pass at half the peak speed on average")
def move_time(s: Metre, v: MetrePerSecond, t_A: Second, t_D: Second) -> Second:
    """Time of a move from its peak speed and the times of its ramps.

    ``s`` distance >= v * (t_A + t_D) / 2, ``v`` peak speed > 0, ``t_A`` and ``t_D`` time of accelerating and braking.

    >>> move_time(1.0, 0.5, 0.5, 0.5)
    2.5
    """
    return s / v + (t_A + t_D) / 2


@formula(symbol="s", unit="m", source="derived: area under the speed")
def move_distance(v: MetrePerSecond, t: Second, t_A: Second, t_D: Second) -> Metre:
    """Distance of a move from its peak speed, its time and the times of its ramps.

    ``v`` peak speed, ``t`` time >= t_A + t_D, ``t_A`` and ``t_D`` time of accelerating and braking.

    >>> move_distance(0.5, 2.5, 0.5, 0.5)
    1.0
    """
    return v * (t - (t_A + t_D) / 2)


@formula(symbol="v", unit="m/s", source="derived: area under the speed")
def speed_between_ramps(s: Metre, t: Second, t_A: Second, t_D: Second) -> MetrePerSecond:
    """Peak speed of a move from its distance, its time and the times of its ramps.

    ``s`` distance, ``t`` time >= t_A + t_D, ``t_A`` and ``t_D`` time of accelerating and braking.

    >>> speed_between_ramps(1.0, 2.5, 0.5, 0.5)
    0.5
    """
    return s / (t - (t_A + t_D) / 2)


@formula(symbol="t_c", unit="s", source="derived: what the ramps leave")
def constant_speed_time(s: Metre, v: MetrePerSecond, t_A: Second, t_D: Second) -> Second:
    """Time at constant speed between the ramps; zero for a triangle.

    ``s`` distance, ``v`` peak speed > 0, ``t_A`` and ``t_D`` time of accelerating and braking.

    >>> constant_speed_time(1.0, 0.5, 0.5, 0.5)
    1.5
    """
    return maximum(s / v - (t_A + t_D) / 2, 0)


@formula(symbol="v_m", unit="m/s", source="SEW 2001, 7.1")
def mean_speed_of_move(s: Metre, t: Second) -> MetrePerSecond:
    """Mean speed of a move.

    ``s`` distance, ``t`` time > 0.

    >>> mean_speed_of_move(1.0, 2.5)
    0.4
    """
    return s / t


@formula(symbol="v", unit="m/s", source="derived: v**2/(2 a) + v**2/(2 a_d) = s")
def triangle_speed(s: Metre, a: MetrePerSecond2, a_d: MetrePerSecond2) -> MetrePerSecond:
    """Highest speed over a distance that is only accelerated and braked; sqrt(a * s) where both are equal.

    ``s`` distance, ``a`` acceleration > 0, ``a_d`` deceleration > 0.

    >>> triangle_speed(2.0, 2.0, 2.0)
    2.0
    """
    return sqrt(2 * s * a * a_d / (a + a_d))


@formula(symbol="v", unit="m/s", source="derived: v/a + v/a_d = t")
def triangle_speed_in_time(t: Second, a: MetrePerSecond2, a_d: MetrePerSecond2) -> MetrePerSecond:
    """Highest speed within a time that is only accelerated and braked.

    ``t`` time, ``a`` acceleration > 0, ``a_d`` deceleration > 0.

    >>> triangle_speed_in_time(4.0, 0.5, 0.5)
    1.0
    """
    return t * a * a_d / (a + a_d)


@formula(symbol="s_max", unit="m", source="derived: triangle of the height t/(1/a + 1/a_d) over the time t")
def longest_distance(t: Second, a: MetrePerSecond2, a_d: MetrePerSecond2) -> Metre:
    """Longest distance from standstill to standstill within a time: a triangle, no speed limit.

    ``t`` time, ``a`` acceleration > 0, ``a_d`` deceleration > 0.

    >>> longest_distance(4.0, 0.5, 0.5)
    2.0
    """
    return t**2 * a * a_d / (2 * (a + a_d))


@formula(symbol="v", unit="m/s", source="SEW 2001, 8.4: optimisation by speed at a given acceleration")
def least_speed(s: Metre, t: Second, a: MetrePerSecond2, a_d: MetrePerSecond2) -> MetrePerSecond:
    """Lowest peak speed that covers a distance in a time at given acceleration.

    ``s`` distance, ``t`` time with t**2 >= 2 * s * kappa, ``a`` acceleration > 0, ``a_d`` deceleration > 0. It is the
    smaller root of s/v + v*kappa/2 = t, written with the square root in the denominator, which loses no digits where
    ``s`` is short; with a = a_d it equals (a*t - sqrt((a*t)**2 - 4*a*s)) / 2.

    >>> round(least_speed(10.0, 14.5, 0.5, 0.5), 4)  # (7.25 - sqrt(7.25**2 - 20)) / 2
    0.7718
    """
    kappa = 1 / a + 1 / a_d
    return 2 * s / (t + sqrt(maximum(t**2 - 2 * s * kappa, 0)))


@formula(symbol="v", unit="m/s", source="SEW 2001, 8.4: optimisation by acceleration")
def least_acceleration_speed(s: Metre, t: Second) -> MetrePerSecond:
    """Peak speed of the move of least acceleration over a distance in a time: a triangle of twice the mean speed.

    ``s`` distance, ``t`` time > 0.

    >>> least_acceleration_speed(1.0, 2.0)
    1.0
    """
    return 2 * s / t


@formula(symbol="a", unit="m/s2", source="SEW 2001, 8.4: optimisation by acceleration; derived for r_a other than 1")
def least_acceleration(s: Metre, t: Second, r_a: One) -> MetrePerSecond2:
    """Least acceleration that covers a distance in a time: a triangle; 4*s/t**2 where braking equals accelerating.

    ``s`` distance, ``t`` time > 0, ``r_a`` deceleration / acceleration > 0.

    >>> least_acceleration(1.0, 2.0, 1.0)
    1.0
    """
    return 2 * s * (1 + 1 / r_a) / t**2


@formula(symbol="v", unit="m/s", source="derived: minimum of a**2*(t_A + t_D), that is of v**2/(t - s/v)")
def least_effective_speed(s: Metre, t: Second) -> MetrePerSecond:
    """Peak speed of the move with the least effective (rms) acceleration over a distance in a time.

    With equal ramps: one third each for accelerating, constant speed and braking. ``s`` distance, ``t`` time > 0.

    >>> least_effective_speed(1.0, 3.0)
    0.5
    """
    return 3 * s / (2 * t)


@formula(symbol="t_A", unit="s", source="derived: both ramps together last 2*(t - s/v)")
def ramp_time_by_ratio(s: Metre, v: MetrePerSecond, t: Second, r_a: One) -> Second:
    """Time of accelerating in a move of given distance, speed and time whose ramps stand in a given ratio.

    ``s`` distance, ``v`` peak speed, ``t`` time with s/v < t <= 2*s/v, ``r_a`` deceleration / acceleration > 0.

    >>> ramp_time_by_ratio(1.0, 0.5, 2.5, 1.0)
    0.5
    """
    return 2 * (t - s / v) * r_a / (1 + r_a)


@formula(symbol="t_A", unit="s", source="derived: both ramps together last 2*(t - s/v)")
def ramp_time_left(s: Metre, v: MetrePerSecond, t: Second, t_D: Second) -> Second:
    """Time left for accelerating in a move of given distance, speed, time and braking time.

    ``s`` distance, ``v`` peak speed, ``t`` time with s/v < t <= 2*s/v, ``t_D`` braking time.

    >>> ramp_time_left(1.0, 0.5, 2.5, 0.25)
    0.75
    """
    return 2 * (t - s / v) - t_D


@formula(symbol="t_A", unit="s", source="derived: integral of a jerk-limited acceleration")
def s_curve_ramp_time(v: MetrePerSecond, a: MetrePerSecond2, j: MetrePerSecond3) -> Second:
    """Time from standstill to a speed, or back, with limited jerk.

    ``v`` speed > 0, ``a`` acceleration limit > 0, ``j`` jerk > 0, ``a_r`` acceleration reached. Below v = a**2/j the
    limit is not reached: the jerk phases meet and there is no phase of constant acceleration.

    >>> s_curve_ramp_time(2.0, 2.0, 4.0)
    1.5
    >>> s_curve_ramp_time(0.25, 2.0, 4.0)
    0.5
    """
    a_r = minimum(a, sqrt(v * j))
    return v / a_r + a_r / j


@formula(symbol="a", unit="m/s2", source="derived: without constant acceleration, v = a**2/j")
def s_curve_peak_acceleration(v: MetrePerSecond, a: MetrePerSecond2, j: MetrePerSecond3) -> MetrePerSecond2:
    """Acceleration that a jerk-limited ramp really reaches.

    ``v`` end speed, ``a`` acceleration limit, ``j`` jerk > 0.

    >>> s_curve_peak_acceleration(0.25, 2.0, 4.0)
    1.0
    """
    return minimum(a, sqrt(v * j))


@formula(symbol="a", unit="m/s2", source="derived: smaller root of v/a + a/j = t_A")
def s_curve_acceleration(v: MetrePerSecond, t_A: Second, j: MetrePerSecond3) -> MetrePerSecond2:
    """Least acceleration limit with which a jerk-limited ramp reaches a speed in a time.

    ``v`` speed, ``t_A`` time >= 2*sqrt(v/j), ``j`` jerk > 0.

    >>> s_curve_acceleration(2.0, 1.5, 4.0)
    2.0
    """
    return 2 * v / (t_A + sqrt(maximum(t_A**2 - 4 * v / j, 0)))


@formula(symbol="t_j", unit="s", source="derived: the acceleration rises by the jerk per time")
def jerk_time(a: MetrePerSecond2, j: MetrePerSecond3) -> Second:
    """Time in which the acceleration rises to its peak, or falls from it.

    ``a`` peak acceleration, ``j`` jerk > 0.

    >>> jerk_time(2.0, 4.0)
    0.5
    """
    return a / j


@formula(symbol="a_m", unit="m/s2", source="derived: the acceleration is half its peak on average while it changes")
def mean_ramp_acceleration(a: MetrePerSecond2, lambda_j: One) -> MetrePerSecond2:
    """Mean acceleration of a ramp that is smoothed over a share of its time.

    ``a`` peak acceleration, ``lambda_j`` share of the ramp in which the acceleration changes, 0 to 1.

    >>> mean_ramp_acceleration(2.0, 0.5)
    1.5
    """
    return a * (1 - lambda_j / 2)


@formula(symbol="a", unit="m/s2", source="derived: the acceleration is half its peak on average while it changes")
def share_acceleration(v: MetrePerSecond, t_A: Second, lambda_j: One) -> MetrePerSecond2:
    """Peak acceleration of a ramp that is smoothed over a share of its time.

    ``v`` end speed, ``t_A`` time of the ramp > 0, ``lambda_j`` share in which the acceleration changes, 0 to 1.

    >>> share_acceleration(1.5, 1.0, 0.5)
    2.0
    """
    return v / (t_A * (1 - lambda_j / 2))


@formula(symbol="j", unit="m/s3", source="derived: half of the share to rise, half of it to fall")
def share_jerk(a: MetrePerSecond2, t_A: Second, lambda_j: One) -> MetrePerSecond3:
    """Jerk of a ramp that is smoothed over a share of its time.

    ``a`` peak acceleration, ``t_A`` time of the ramp > 0, ``lambda_j`` share in which the acceleration changes, > 0.

    >>> share_jerk(2.0, 1.0, 0.5)
    8.0
    """
    return 2 * a / (lambda_j * t_A)


@formula(symbol="t_p", unit="s", source="derived: settling follows the motion")
def positioning_time(t: Second, t_set: Second) -> Second:
    """Time from the start of a move until the axis has settled.

    ``t`` time of the motion, ``t_set`` settling time.

    >>> positioning_time(2.5, 0.5)
    3.0
    """
    return t + t_set


@formula(symbol="t_cyc", unit="s", source="derived: sum of what follows on one another")
def sum_of_times(t_k: Second) -> Second:
    """Time of a cycle from the times of its parts, pauses included.

    ``t_k`` times, shape (n,).

    >>> sum_of_times([2.5, 0.5])
    3.0
    """
    return total(t_k)


@formula(symbol="v_P", unit="m/s", source="SEW 2001, 8.4: positioning at creep speed")
def creep_speed(v: MetrePerSecond, r_P: One) -> MetrePerSecond:
    """Creep speed, from which a brake stops the axis.

    ``v`` peak speed, ``r_P`` creep speed over peak speed.

    >>> round(creep_speed(0.77, 0.1), 6)
    0.077
    """
    return v * r_P


@formula(symbol="t_U", unit="s", source="SEW 2001, 8.4: time of slowing down to creep speed")
def slowing_time(v: MetrePerSecond, v_P: MetrePerSecond, a: MetrePerSecond2) -> Second:
    """Time from peak to creep speed.

    ``v`` peak speed, ``v_P`` creep speed, ``a`` deceleration.

    >>> slowing_time(1.0, 0.5, 0.25)
    2.0
    """
    return (v - v_P) / a


@formula(symbol="s_U", unit="m", source="SEW 2001, 8.4: distance of slowing down to creep speed")
def slowing_distance(v: MetrePerSecond, v_P: MetrePerSecond, t_U: Second) -> Metre:
    """Distance from peak to creep speed.

    ``v`` peak speed, ``v_P`` creep speed, ``t_U`` time of slowing down.

    >>> slowing_distance(1.0, 0.5, 2.0)
    1.5
    """
    return (v + v_P) / 2 * t_U


@formula(symbol="s", unit="m", source="derived: speed times time")
def distance_at_speed(v: MetrePerSecond, t: Second) -> Metre:
    """Distance at constant speed.

    ``v`` speed, ``t`` time.

    >>> distance_at_speed(0.5, 4.0)
    2.0
    """
    return v * t


@formula(symbol="s_F", unit="m", source="derived: what the other phases leave")
def distance_left(s: Metre, s_k: Metre) -> Metre:
    """Distance that remains at constant speed.

    ``s`` whole distance, ``s_k`` distances of the other phases.

    >>> distance_left(10.0, [1.0, 2.0])
    7.0
    """
    return s - total(s_k)


@formula(symbol="t_F", unit="s", source="derived: distance over speed")
def time_for_distance(s: Metre, v: MetrePerSecond) -> Second:
    """Time at constant speed.

    ``s`` distance, ``v`` speed.

    >>> time_for_distance(2.0, 0.5)
    4.0
    """
    return s / v
