"""Servo motors: torque on the motor shaft, limits over the speed, criteria of the choice, currents."""

from app.engine.formula import formula, maximum, minimum, where
from app.engine.units import (
    Ampere,
    KilogramMetre2,
    NewtonMetre,
    NewtonMetrePerAmpere,
    One,
    RadPerSecond,
    RadPerSecond2,
    Watt,
)


@formula(symbol="M", unit="N m", source="derived: Newton's second law on the motor shaft")
def motor_torque(M_L: NewtonMetre, J_M: KilogramMetre2, J_x: KilogramMetre2, alpha_M: RadPerSecond2) -> NewtonMetre:
    """Torque that the motor must give: load, its own rotor and what is mounted on its shaft.

    ``M_L`` torque of the load on the motor shaft, signed; ``J_M`` rotor inertia, ``J_x`` inertia of gear unit and
    coupling on the motor shaft, ``alpha_M`` angular acceleration of the motor shaft, signed.

    >>> motor_torque(3.0, 0.002, 0.001, 1000.0)
    6.0
    """
    return M_L + (J_M + J_x) * alpha_M


@formula(symbol="alpha_M", unit="rad/s2", source="derived: the ratio holds for speeds and their changes")
def motor_acceleration(alpha_L: RadPerSecond2, i: One) -> RadPerSecond2:
    """Angular acceleration of the motor shaft.

    ``alpha_L`` angular acceleration of the output shaft, ``i`` ratio of motor to output speed.

    >>> motor_acceleration(50.0, 10.0)
    500.0
    """
    return alpha_L * i


@formula(symbol="M_peak", unit="N m", source="derived: Newton's second law on the motor shaft, largest magnitude")
def peak_torque(M_L: NewtonMetre, J_M: KilogramMetre2, J_x: KilogramMetre2, alpha_M: RadPerSecond2) -> NewtonMetre:
    """Largest torque that the motor must give, unsigned, in the segment that decides.

    ``M_L`` torque of the load on the motor shaft, signed; ``J_M`` rotor inertia, ``J_x`` inertia of gear unit and
    coupling on the motor shaft, ``alpha_M`` angular acceleration of the motor shaft, signed.

    >>> peak_torque(-1.0, 0.002, 0.001, -1000.0)
    4.0
    """
    return abs(M_L + (J_M + J_x) * alpha_M)


@formula(symbol="P_M", unit="W", source="derived: torque times angular speed")
def shaft_power(M: NewtonMetre, omega: RadPerSecond) -> Watt:
    """Power on a shaft, unsigned.

    ``M`` torque and ``omega`` angular speed, either sign.

    >>> shaft_power(-3.0, 100.0)
    300.0
    """
    return abs(M * omega)


@formula(symbol="P", unit="W", source="derived: torque times speed, with their signs")
def signed_power(M: NewtonMetre, omega: RadPerSecond) -> Watt:
    """Power of a shaft: positive where the motor drives, negative where power is returned.

    ``M`` torque and ``omega`` speed, signed in the same direction.

    >>> signed_power(-2.0, 100.0)
    -200.0
    """
    return M * omega


@formula(symbol="M_S1", unit="N m", source="derived: straight S1 line, constant power above rated speed")
def continuous_torque(M_0: NewtonMetre, M_N: NewtonMetre, n_N: RadPerSecond, n: RadPerSecond) -> NewtonMetre:
    """Continuous (S1) torque of a servo motor at a speed, from stall and rated point.

    ``M_0`` stall torque, ``M_N`` torque at rated speed ``n_N``, ``n`` unsigned speed. Straight line up to rated speed;
    above it the lower of that line prolonged and constant power.

    >>> continuous_torque(45.0, 35.0, 200.0, 60.0)  # 45 - 10 * 0.3
    42.0
    >>> continuous_torque(10.0, 10.0, 200.0, 400.0)
    5.0
    """
    line = maximum(M_0 + (M_N - M_0) * n / n_N, 0)
    return where(n <= n_N, line, minimum(line, M_N * n_N / maximum(n, n_N)))


@formula(symbol="lambda_J", unit="1", source="derived: external inertia on the motor shaft over rotor inertia")
def inertia_ratio(J_ext: KilogramMetre2, J_M: KilogramMetre2) -> One:
    """Ratio of the external inertia, referred to the motor shaft, to the inertia of the motor.

    ``J_ext`` load, gear unit and coupling referred to the motor shaft; ``J_M`` inertia of the motor.

    >>> inertia_ratio(0.006, 0.002)
    3.0
    """
    return J_ext / J_M


@formula(symbol="J_M,min", unit="kg cm2", source="derived: J_ext / J_M <= lambda")
def least_motor_inertia(J_ext: KilogramMetre2, lambda_J: One) -> KilogramMetre2:
    """Least motor inertia that keeps the limit of the inertia ratio.

    ``J_ext`` external inertia referred to the motor shaft, ``lambda_J`` permitted ratio.

    >>> least_motor_inertia(0.0065, 10.0)
    0.00065
    """
    return J_ext / lambda_J


@formula(symbol="n_req", unit="rpm", source="derived: the highest speed is a given share of the permitted speed")
def speed_with_reserve(n: RadPerSecond, r_n: One) -> RadPerSecond:
    """Speed that the motor must have so that its highest speed is only a share of it.

    ``n`` highest motor speed, ``r_n`` share that may be used, 0 < r_n <= 1.

    >>> speed_with_reserve(270.0, 0.9)
    300.0
    """
    return n / r_n


@formula(symbol="n_mmax", unit="rpm", source="Lachman, Mendricky 2015, part 6: 1.2 * rapid speed")
def lachman_motor_speed(n: RadPerSecond) -> RadPerSecond:
    """Highest speed that the motor must have: 1.2 times the rapid speed.

    ``n`` motor speed at rapid traverse.

    >>> lachman_motor_speed(100.0)
    120.0
    """
    return 1.2 * n


@formula(symbol="J_M,min", unit="kg m2", source="Lachman, Mendricky 2015, part 6: J_M >= 0.8 * J_red * k^2")
def lachman_motor_inertia(J_ext: KilogramMetre2) -> KilogramMetre2:
    """Least motor inertia: 0.8 of the external inertia referred to the motor shaft.

    ``J_ext`` external inertia; the ratio enters it squared.

    >>> lachman_motor_inertia(0.01)
    0.008
    """
    return 0.8 * J_ext


@formula(symbol="M_1", unit="N m", source="Lachman, Mendricky 2015, part 6, condition a")
def lachman_friction_torque(M_T: NewtonMetre, c_T: One) -> NewtonMetre:
    """Continuous torque at standstill below which the passive resistances take too large a share of it.

    ``M_T`` torque of all passive resistances on the motor shaft, ``c_T`` share they may take: 0.2, relaxed 0.4.

    >>> lachman_friction_torque(6.0, 0.2)
    30.0
    """
    return M_T / c_T


@formula(symbol="M_dm", unit="N m", source="Lachman, Mendricky 2015, part 7")
def lachman_dynamic_torque(J_tot: KilogramMetre2, epsilon: RadPerSecond2, M_P: NewtonMetre) -> NewtonMetre:
    """Dynamic torque: acceleration of everything that turns and the largest working torque at once.

    ``J_tot`` rotor and external inertia on the motor shaft, ``epsilon`` angular acceleration of the motor, ``M_P``
    largest steady torque on the motor shaft, the process force included (on the safe side).

    >>> lachman_dynamic_torque(0.03, 1500.0, 50.0)
    95.0
    """
    return J_tot * epsilon + M_P


@formula(symbol="M_max", unit="N m", source="Lachman, Mendricky 2015, part 7: 1.2 * M_dm")
def lachman_peak_torque(M_dm: NewtonMetre) -> NewtonMetre:
    """Peak torque that the motor must have: 1.2 times the dynamic torque.

    ``M_dm`` dynamic torque on the motor shaft.

    >>> lachman_peak_torque(100.0)
    120.0
    """
    return 1.2 * M_dm


@formula(symbol="M_req", unit="N m", source="derived: demand times a given reserve")
def torque_with_reserve(M: NewtonMetre, k_M: One) -> NewtonMetre:
    """Torque that must be available so that a reserve remains.

    ``M`` torque in demand, ``k_M`` factor of the reserve, >= 1.

    >>> torque_with_reserve(10.0, 1.2)
    12.0
    """
    return M * k_M


@formula(symbol="k_T", unit="N m/A", source="derived: torque per current in one operating point")
def torque_constant(M: NewtonMetre, I: Ampere) -> NewtonMetrePerAmpere:
    """Torque constant of a motor from torque and current of one operating point.

    ``M`` torque, ``I`` current (rms) in that point, > 0.

    >>> torque_constant(12.0, 8.0)
    1.5
    """
    return M / I


@formula(symbol="I", unit="A", source="derived: torque proportional to current")
def motor_current(M: NewtonMetre, k_T: NewtonMetrePerAmpere) -> Ampere:
    """Motor current (rms) for a torque, without saturation.

    ``M`` torque, ``k_T`` torque constant.

    >>> motor_current(12.0, 1.5)
    8.0
    """
    return M / k_T


@formula(symbol="I", unit="A", source="derived: straight line between rated and peak point of the data sheet")
def saturated_motor_current(M: NewtonMetre, M_a: NewtonMetre, I_a: Ampere, M_max: NewtonMetre, I_max: Ampere) -> Ampere:
    """Motor current (rms) for a torque above the continuous one, where the iron saturates.

    ``M`` torque, ``M_a`` and ``I_a`` torque and current of the continuous point, ``M_max`` and ``I_max`` of the peak
    point.

    >>> saturated_motor_current(20.0, 10.0, 5.0, 30.0, 25.0)
    15.0
    """
    return I_a + (M - M_a) * (I_max - I_a) / (M_max - M_a)


@formula(symbol="M", unit="N m", source="derived: straight line between two points of a curve")
def torque_between_points(
    n: RadPerSecond, n_a: RadPerSecond, M_a: NewtonMetre, n_b: RadPerSecond, M_b: NewtonMetre
) -> NewtonMetre:
    """Torque of a limit curve at a speed, between the two points of the data sheet beside it.

    ``n`` speed, ``n_a <= n <= n_b``; ``M_a`` and ``M_b`` torque at the two points, ``n_b > n_a``.

    >>> torque_between_points(150.0, 100.0, 10.0, 200.0, 6.0)
    8.0
    """
    return M_a + (M_b - M_a) * (n - n_a) / (n_b - n_a)


@formula(symbol="M_0", unit="N m", source="SEW 2001, 16.3: a servomotor gives about three times its standstill torque")
def torque_share(M: NewtonMetre, n_M: One) -> NewtonMetre:
    """Least standstill torque of a servomotor, from the peak torque that is demanded.

    ``M`` peak torque, ``n_M`` how often the motor can give its standstill torque for a short time, or the number of
    motors that share a torque.

    >>> torque_share(6.0, 3.0)
    2.0
    """
    return M / n_M
