"""Mechanical variable-speed gears: what the three ways of dimensioning ask of both ends of the speed range."""

from app.engine.formula import formula
from app.engine.units import NewtonMetre, One, RadPerSecond, Watt


@formula(symbol="i_0", unit="1", source="SEW 2001, 5.2: output over input, both without load")
def variator_ratio(n_a0: RadPerSecond, n_e0: RadPerSecond) -> One:
    """Setting of a variable-speed gear: the reciprocal of what is called a ratio elsewhere.

    ``n_a0`` speed of its output without load, ``n_e0`` speed of its input without load.

    >>> variator_ratio(300.0, 150.0)
    2.0
    """
    return n_a0 / n_e0


@formula(symbol="n_amin", unit="rpm", source="derived: definition of the speed range")
def lowest_output_speed(n_amax: RadPerSecond, R_n: One) -> RadPerSecond:
    """Lowest speed of a range 1 : R_n.

    ``n_amax`` highest speed of the output, ``R_n`` speed range.

    >>> lowest_output_speed(3.9, 3.0)
    1.3
    """
    return n_amax / R_n


@formula(symbol="P_amin", unit="kW", source="SEW 2001, 5.2: dimensioning for constant torque")
def lowest_power_constant_torque(P_amax: Watt, R_n: One) -> Watt:
    """Power at the lowest speed where the torque stays the same.

    ``P_amax`` power at the highest speed, ``R_n`` speed range.

    >>> lowest_power_constant_torque(2200.0, 4.0)
    550.0
    """
    return P_amax / R_n


@formula(symbol="P_amin", unit="kW", source="SEW 2001, 5.2: constant torque below n_c, constant power above")
def lowest_power_both(n_amin: RadPerSecond, n_c: RadPerSecond, P_amax: Watt) -> Watt:
    """Power at the lowest speed where the torque is constant below one speed and the power above it.

    ``n_amin`` lowest speed, ``n_c`` speed where the two parts meet, ``P_amax`` power above it.

    >>> lowest_power_both(50.0, 125.0, 2200.0)
    880.0
    """
    return n_amin / n_c * P_amax


@formula(symbol="dM", unit="%", source="SEW 2001, 5.2: the gear unit behind bears 200 to 600 % more for constant power")
def extra_torque_constant_power(R_n: One) -> One:
    """Additional torque at the lowest speed where the power stays the same, over the torque at the highest.

    ``R_n`` speed range.

    >>> extra_torque_constant_power(3.0)
    2.0
    """
    return R_n - 1


@formula(symbol="f_BT", unit="1", source="SEW 2001, 5.2: factors of load class and ambient temperature multiply")
def variator_service_factor(f_B: One, f_TV: One) -> One:
    """Service factor that is demanded of a variable-speed gear.

    ``f_B`` factor of the load class, ``f_TV`` factor of the ambient temperature.

    >>> variator_service_factor(1.25, 1.2)
    1.5
    """
    return f_B * f_TV


@formula(symbol="M_a'", unit="N m", source="SEW 2001, 5.2: chosen by the torque times the service factor")
def torque_with_service_factor(M_a: NewtonMetre, f_B: One) -> NewtonMetre:
    """Torque by which a variable-speed gear is chosen.

    ``M_a`` torque at the output, ``f_B`` service factor demanded.

    >>> torque_with_service_factor(400.0, 1.5)
    600.0
    """
    return M_a * f_B


@formula(symbol="P_a'", unit="kW", source="SEW 2001, 5.2: chosen by the power times the service factor")
def power_with_service_factor(P_a: Watt, f_B: One) -> Watt:
    """Power by which a variable-speed gear is chosen.

    ``P_a`` power at the output, ``f_B`` service factor demanded.

    >>> power_with_service_factor(2000.0, 1.25)
    2500.0
    """
    return P_a * f_B


@formula(symbol="M_zul", unit="N m", source="derived: power in a straight line between the two listed ends")
def variator_torque_between(
    n_a: RadPerSecond, n_a1: RadPerSecond, n_a2: RadPerSecond, M_a1: NewtonMetre, M_a2: NewtonMetre
) -> NewtonMetre:  # fmt: skip
    """Permitted torque of a variable-speed gear between the two speeds that its list gives.

    A straight line of the power lies below a straight line of the torque: the safe one of the two. ``n_a`` speed of the
    output, ``n_a1`` and ``M_a1`` low speed of the list and torque there, ``n_a2`` and ``M_a2`` high speed and torque
    there.

    >>> variator_torque_between(2.0, 1.0, 4.0, 300.0, 150.0)  # 300 W and 600 W at the ends: 400 W at 2 rad/s
    200.0
    """
    return (M_a1 * n_a1 + (M_a2 * n_a2 - M_a1 * n_a1) * (n_a - n_a1) / (n_a2 - n_a1)) / n_a


@formula(symbol="P_e", unit="kW", source="derived: losses of gear unit and variable-speed gear")
def variator_input_power(P_a: Watt, eta_V: One) -> Watt:
    """Power that the motor gives.

    ``P_a`` power at the output, ``eta_V`` efficiency of variable-speed gear and gear unit together.

    >>> variator_input_power(800.0, 0.8)
    1000.0
    """
    return P_a / eta_V
