"""Industrial gear units: output speed and torque, service factor, overhung load, backlash on the machine."""

from app.engine.formula import formula, pi
from app.engine.units import (
    KilogramMetre2,
    Metre,
    MetrePerRad,
    Newton,
    NewtonMetre,
    One,
    PerSecond,
    Rad,
    RadPerSecond,
    Second,
    Watt,
)


@formula(symbol="n_a", unit="rpm", source="SEW 2001, 6.1: output speed of the chosen ratio")
def output_speed(omega: RadPerSecond, i: One) -> RadPerSecond:
    """Speed of the output shaft.

    ``omega`` speed of the motor, ``i`` ratio of the gear unit.

    >>> output_speed(150.0, 30.0)
    5.0
    """
    return omega / i


@formula(symbol="M_a", unit="N m", source="SEW 2001, 8.2: rated torque of the motor at the output, on the safe side")
def output_torque(M_N: NewtonMetre, i: One) -> NewtonMetre:
    """Torque at the output of a gear unit when the motor gives its rated torque; the losses are left out.

    ``M_N`` rated torque of the motor, ``i`` ratio of the gear unit.

    >>> output_torque(2.0, 45.0)
    90.0
    """
    return M_N * i


@formula(symbol="M_a", unit="N m", source="SEW 2001, 6.1: output torque of a geared motor")
def output_torque_of_power(P_N: Watt, eta_G: One, n_a: RadPerSecond) -> NewtonMetre:
    """Torque at the output of a geared motor, losses included.

    ``P_N`` rated power of the motor, ``eta_G`` efficiency of the gear unit, ``n_a`` speed of its output.

    >>> output_torque_of_power(550.0, 0.8, 5.0)
    88.0
    """
    return P_N * eta_G / n_a


@formula(symbol="eta_G", unit="1", source="SEW 2001, 6.1: each stage loses 2 to 3 %")
def efficiency_of_stages(eta: One, n_st: One) -> One:
    """Efficiency of a gear unit of several equal stages.

    ``eta`` efficiency of one stage, ``n_st`` number of stages.

    >>> round(efficiency_of_stages(0.98, 3), 6)
    0.941192
    """
    return eta**n_st


@formula(symbol="M_1", unit="N m", source="SEW 2001, 6.1: worm gear units lose more at standstill and when new")
def break_away_torque(T: NewtonMetre, i: One, eta_A: One) -> NewtonMetre:
    """Torque of the motor that sets a load in motion through a gear unit which is less efficient at standstill.

    ``T`` torque at the output, ``i`` ratio, ``eta_A`` efficiency of the gear unit at the start.

    >>> break_away_torque(120.0, 40.0, 0.5)
    6.0
    """
    return T / (i * eta_A)


@formula(symbol="dn", unit="%", source="derived: speed of the chosen ratio against the demanded one")
def speed_deviation(n_a: RadPerSecond, omega: RadPerSecond) -> One:
    """How far the output turns faster than demanded, as a share.

    ``n_a`` speed that the chosen ratio gives, ``omega`` speed demanded.

    >>> speed_deviation(5.5, 5.0)
    0.1
    """
    return (n_a - omega) / omega


@formula(symbol="f_a", unit="1", source="SEW 2001, 6.2: factor of inertia")
def inertia_factor_of_load(J_ext: KilogramMetre2, J_M: KilogramMetre2) -> One:
    """External inertia over everything that turns with the motor, flywheel included: it decides on the load class.

    ``J_ext`` external inertia referred to the motor shaft, without losses, ``J_M`` inertia of motor, brake and
    flywheel.

    >>> inertia_factor_of_load(0.75, 0.25)
    3.0
    """
    return J_ext / J_M


@formula(symbol="f_BT", unit="1", source="SEW 2001, 6.2: service factor of worm gear units")
def total_service_factor(f_B: One, f_B1: One, f_B2: One) -> One:
    """Service factor that is demanded of a gear unit.

    ``f_B`` by load class, hours per day and load changes, ``f_B1`` by the ambient temperature and ``f_B2`` by the duty:
    both 1 but for worm gear units.

    >>> round(total_service_factor(1.51, 1.38, 0.95), 3)
    1.98
    """
    return f_B * f_B1 * f_B2


@formula(symbol="f_B", unit="1", source="SEW 2001, 6.2: service factor that a gear unit has")
def actual_service_factor(M_amax: NewtonMetre, M_a: NewtonMetre) -> One:
    """Service factor of a gear unit behind a motor.

    ``M_amax`` permitted output torque at a service factor of 1, ``M_a`` torque at the output.

    >>> round(actual_service_factor(130.0, 87.535), 3)
    1.485
    """
    return M_amax / M_a


@formula(symbol="F_t", unit="N", source="SEW 2001, 6.4: force at the circumference")
def tangential_force(M: NewtonMetre, r: Metre) -> Newton:
    """Force at the circumference of an element on a shaft.

    ``M`` torque of the shaft, ``r`` radius of the element.

    >>> tangential_force(50.0, 0.125)
    400.0
    """
    return M / r


@formula(symbol="F_Q", unit="N", source="SEW 2001, 6.3: overhung load")
def overhung_load(M_a: NewtonMetre, d_0: Metre, f_Z: One) -> Newton:
    """Radial force on the output shaft of a gear unit.

    ``M_a`` torque at the output, ``d_0`` pitch diameter of the element that sits on the gear shaft itself, ``f_Z``
    factor of that element.

    >>> round(overhung_load(87.535, 0.13537, 1.25), 1)
    1616.6
    """
    return 2 * M_a / d_0 * f_Z


@formula(symbol="ds", unit="mm", source="derived: backlash of the output shaft as a path of the load")
def backlash_on_load(phi_G: Rad, A: MetrePerRad) -> Metre:
    """Lost motion of the load by the backlash of the gear unit.

    ``phi_G`` backlash of the output shaft, ``A`` path of the load per radian of the output shaft.

    >>> backlash_on_load(0.004, 0.25)
    0.001
    """
    return phi_G * A


@formula(symbol="Z_L", unit="1/h", source="SEW 2001, 6.2: starts, brakings and speed changes")
def load_changes(n_L: One, z_c: One, t_cyc: Second) -> PerSecond:
    """How often the load of a gear unit changes.

    ``n_L`` changes of each start: 2 for start and braking, 3 with a change of speed, ``z_c`` starts in a cycle,
    ``t_cyc`` length of the cycle.

    >>> load_changes(3.0, 1.0, 30.0) * 3600
    360.0
    """
    return n_L * z_c / t_cyc


@formula(symbol="Z", unit="1/h", source="derived: starts in a cycle over its time")
def starting_rate(z_c: One, t_cyc: Second) -> PerSecond:
    """How often the motor starts.

    ``z_c`` starts in a cycle, ``t_cyc`` length of the cycle.

    >>> round(starting_rate(1.0, 30.0) * 3600, 6)
    120.0
    """
    return z_c / t_cyc


@formula(symbol="M_a", unit="N m", source="SEW 2001, 12.2: torque that the gear unit must have in its catalogue")
def required_gear_torque(M_a: NewtonMetre, f_B: One) -> NewtonMetre:
    """Catalogue torque that a gear unit needs.

    ``M_a`` torque at the output, ``f_B`` service factor demanded.

    >>> required_gear_torque(60.0, 1.5)
    90.0
    """
    return M_a * f_B


@formula(symbol="ds", unit="mm", source="SEW 2001, 16.3: half the backlash and one increment of the encoder")
def positioning_accuracy(phi_G: Rad, A: MetrePerRad, n_inc: One, i: One) -> Metre:
    """Deviation of a position to either side.

    ``phi_G`` whole backlash of the output shaft, ``A`` path of the load per radian of it, ``n_inc`` increments of the
    encoder on the motor per revolution, ``i`` ratio.

    >>> round(positioning_accuracy(0.0029089, 0.0875, 4096, 16) * 1000, 4)
    0.1357
    """
    return A * phi_G / 2 + 2 * pi * A / (n_inc * i)
