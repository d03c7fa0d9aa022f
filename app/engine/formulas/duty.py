"""What a whole cycle means for a motor and a gear unit: effective torque, mean speed, equivalent torque."""

from app.engine.formula import formula, sqrt, total
from app.engine.units import NewtonMetre, One, RadPerSecond, Second


@formula(symbol="M_eff", unit="N m", source="IEC 60034-1, duty types; SEW 2001, 16.4")
def effective_torque(M_k: NewtonMetre, t_k: Second) -> NewtonMetre:
    """Effective (root mean square) torque of one cycle: the steady torque with the same copper loss.

    ``M_k`` motor torque, constant within each segment, either sign, shape (n,); ``t_k`` length of each segment, shape
    (n,): a standstill is a segment too. Holds for a cycle that is short against the thermal time constant of the motor.

    >>> effective_torque([4.0, -2.0, 0.0], [1.0, 1.0, 2.0])  # sqrt((16 + 4) / 4)
    2.23606797749979
    """
    return sqrt(total(M_k**2 * t_k) / total(t_k))


@formula(symbol="n_mean", unit="rpm", source="derived: angle turned in one cycle over its time")
def mean_speed(omega_k: RadPerSecond, t_k: Second) -> RadPerSecond:
    """Mean speed of one cycle: time average of the unsigned speed.

    ``omega_k`` mean speed of each segment, either sign, shape (n,); ``t_k`` length of each segment, shape (n,). No
    segment changes its direction of rotation inside.

    >>> mean_speed([5.0, -10.0, 0.0], [1.0, 2.0, 2.0])  # (5 + 20) / 5
    5.0
    """
    return total(abs(omega_k) * t_k) / total(t_k)


@formula(symbol="T_2m", unit="N m", source="ISO 281 exponent 3; practice of makers of planetary gear units")
def equivalent_output_torque(T_k: NewtonMetre, omega_k: RadPerSecond, t_k: Second) -> NewtonMetre:
    """Equivalent torque of one cycle for a gear unit: cubic mean, weighted with the angle turned.

    ``T_k`` torque at the output in each segment, either sign; ``omega_k`` mean output speed; ``t_k`` length of each
    segment; all of shape (n,). At least one segment must turn.

    >>> equivalent_output_torque([20.0, 10.0, 0.0], [1.0, 1.0, 0.0], [1.0, 7.0, 5.0])  # cbrt((8000 + 7000) / 8)
    12.331...
    """
    return (total(abs(T_k) ** 3 * abs(omega_k) * t_k) / total(abs(omega_k) * t_k)) ** (1 / 3)


@formula(symbol="ED", unit="%", source="IEC 60034-1: cyclic duration factor")
def duty_share(t_on: Second, t_cyc: Second) -> One:
    """Share of the cycle in which the motor is switched on, 0 to 1.

    ``t_on`` time under load in a cycle, ``t_cyc`` length of the cycle.

    >>> duty_share(24.0, 60.0)
    0.4
    """
    return t_on / t_cyc


@formula(symbol="M_mean", unit="N m", source="SEW 2001, 16.4: mean of the magnitudes, pauses included")
def mean_torque(M_k: NewtonMetre, t_k: Second) -> NewtonMetre:
    """Mean of the unsigned torque over a cycle: what the mean current of an axis module follows.

    ``M_k`` unsigned torque in each segment, ``t_k`` durations, pauses included.

    >>> mean_torque([4.0, 0.0], [1.0, 3.0])
    1.0
    """
    return total(M_k * t_k) / total(t_k)
