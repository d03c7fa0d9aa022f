"""The transmission that accelerates a load fastest with a given motor torque.

``A`` is the transmission constant (travel per radian of the mechanism's shaft: lead / 2 pi, pitch radius), ``i`` the
ratio motor / mechanism shaft, ``M`` the motor torque that is there for accelerating and for the opposing force ``F``.
With ``F`` = 0 these are the equations of Jakab; the load force is an extension of them.
"""

from app.engine.formula import formula, pi, sqrt
from app.engine.units import (
    Kilogram,
    KilogramMetre2,
    KilogramPerMetre2,
    KilogramPerMetre3,
    Metre,
    MetrePerRad,
    MetrePerSecond2,
    Newton,
    NewtonMetre,
    One,
)

JAKAB = "Jakab, Design of linear positioning feed drives, University of Miskolc"


@formula(symbol="J_red", unit="kg cm2", source=f"{JAKAB}, (3.1), (3.2), (3.8), (3.11)")
def motor_side_inertia(J_d: KilogramMetre2, J_s: KilogramMetre2, m: Kilogram, A: MetrePerRad, i: One) -> KilogramMetre2:
    """Inertia of the whole axis referred to the motor shaft.

    ``J_d`` on the motor shaft (rotor, first wheel), ``J_s`` on the mechanism's shaft, ``m`` mass moved in a straight
    line, ``A`` transmission constant, ``i`` ratio motor / mechanism shaft.

    >>> motor_side_inertia(0.001, 0.002, 50.0, 0.02, 2.0)  # 0.001 + (0.002 + 50 * 0.0004) / 4
    0.0065
    """
    return J_d + (J_s + m * A**2) / i**2


@formula(symbol="a", unit="m/s2", source=f"{JAKAB}, (3.9), (3.11), extended by the load force")
def load_acceleration(M: NewtonMetre, F: Newton, A: MetrePerRad, i: One, J_red: KilogramMetre2) -> MetrePerSecond2:
    """Acceleration of the load that a motor torque gives.

    ``M`` motor torque, ``F`` opposing force, 0 when ``M`` is free for accelerating, ``A`` transmission constant, ``i``
    ratio motor / mechanism shaft, ``J_red`` inertia of the whole axis referred to the motor shaft.

    >>> round(load_acceleration(4.0, 100.0, 0.02, 2.0, 0.0065), 6)  # 0.01 * (4 - 100 * 0.01) / 0.0065
    4.615385
    """
    return A / i * (M - F * A / i) / J_red


@formula(symbol="M_a", unit="N m", source=f"{JAKAB}, (4.4)")
def accelerating_torque_needed(J_red: KilogramMetre2, a: MetrePerSecond2, A: MetrePerRad, i: One) -> NewtonMetre:
    """Motor torque that accelerates the whole axis, rotor included, without friction, weight or losses.

    ``J_red`` inertia of the whole axis referred to the motor shaft, ``a`` acceleration of the load, ``A`` transmission
    constant, ``i`` ratio motor / mechanism shaft.

    >>> round(accelerating_torque_needed(0.0063, 20.0, 0.03, 1.0), 6)
    4.2
    """
    return J_red * a * i / A


@formula(symbol="J_f", unit="kg cm2", source="derived: the part of the inertia that A does not change")
def inertia_beside_load(J_d: KilogramMetre2, J_s: KilogramMetre2, i: One) -> KilogramMetre2:
    """Inertia on the mechanism's shaft of everything but the mass moved in a straight line.

    ``J_d`` on the motor shaft, ``J_s`` on the mechanism's shaft, ``i`` ratio motor / mechanism shaft.

    >>> inertia_beside_load(0.001, 0.002, 2.0)
    0.006
    """
    return J_d * i**2 + J_s


@formula(symbol="A_opt", unit="mm/rad", source=f"{JAKAB}, (3.5), (3.7), (3.10), (3.12), extended by the load force")
def optimum_transmission(M: NewtonMetre, F: Newton, i: One, J_f: KilogramMetre2, m: Kilogram) -> MetrePerRad:
    """Transmission constant with which a motor accelerates the load fastest, for a given ratio.

    ``M`` motor torque, ``F`` opposing force, ``i`` ratio motor / mechanism shaft, ``J_f`` inertia on the mechanism's
    shaft of everything but the moved mass, ``m`` moved mass. Root of the derivative of the acceleration. Without ``F``
    it is sqrt(J_f / m): the moved mass then weighs on the shaft just as much as everything else (inertia match). An
    opposing force shortens it.

    >>> optimum_transmission(4.0, 0.0, 1.0, 0.005, 50.0)  # sqrt(0.005 / 50)
    0.01
    """
    return (sqrt((F * J_f) ** 2 + m * J_f * (M * i) ** 2) - F * J_f) / (m * M * i)


@formula(symbol="h_opt", unit="mm", source=f"{JAKAB}, (3.7): lead from the travel per radian")
def optimum_lead(A_opt: MetrePerRad) -> Metre:
    """Lead of the screw that accelerates the load fastest.

    ``A_opt`` best transmission constant.

    >>> round(optimum_lead(0.01), 6)
    0.062832
    """
    return 2 * pi * A_opt


@formula(symbol="d_opt", unit="mm", source=f"{JAKAB}, (3.10): diameter from the travel per radian")
def optimum_diameter(A_opt: MetrePerRad) -> Metre:
    """Pitch diameter of the pulley or pinion that accelerates the load fastest.

    ``A_opt`` best transmission constant.

    >>> optimum_diameter(0.02)
    0.04
    """
    return 2 * A_opt


@formula(symbol="c_t", unit="kg/m2", source="derived: J = pi*rho*b*d^4/32 for each solid disc")
def pulley_inertia_coefficient(n_t: One, rho: KilogramPerMetre3, b: Metre) -> KilogramPerMetre2:
    """Inertia of all solid pulleys of a belt together, divided by the fourth power of their diameter.

    ``n_t`` number of equal pulleys, ``rho`` density, ``b`` width.

    >>> round(pulley_inertia_coefficient(2.0, 2700.0, 0.03), 4)
    15.9043
    """
    return n_t * pi * rho * b / 32


@formula(symbol="d_opt", unit="mm", source="derived: root of m*d^2/4 + 3*c_t*d^4 = J_f, a quadratic in d^2")
def optimum_solid_pulley_diameter(J_f: KilogramMetre2, m: Kilogram, c_t: KilogramPerMetre2) -> Metre:
    """Pulley diameter that accelerates the load fastest when the pulleys are solid and grow with it; no opposing force.

    ``J_f`` inertia on the pulley's shaft that does not change with the diameter, ``m`` moved mass, ``c_t`` inertia of
    all pulleys divided by d^4.

    >>> optimum_solid_pulley_diameter(J_f=0.31, m=4.0, c_t=1000.0)  # 4 * 0.01 / 4 + 3 * 1000 * 0.0001 = 0.31
    0.1
    """
    return sqrt((sqrt(m**2 / 16 + 12 * c_t * J_f) - m / 4) / (6 * c_t))


@formula(symbol="J_t", unit="kg cm2", source="derived: J = c_t*d^4")
def solid_pulleys_inertia(c_t: KilogramPerMetre2, d: Metre) -> KilogramMetre2:
    """Inertia of all solid pulleys of a belt together.

    ``c_t`` their inertia divided by d^4, ``d`` pitch diameter.

    >>> round(solid_pulleys_inertia(1000.0, 0.1), 9)
    0.1
    """
    return c_t * d**4


@formula(symbol="i_opt", unit="1", source=f"{JAKAB}, (3.6), (3.13), extended by the load torque")
def optimum_ratio(M: NewtonMetre, T: NewtonMetre, J_d: KilogramMetre2, J_L: KilogramMetre2) -> One:
    """Ratio with which a motor accelerates the load fastest, for a given mechanism.

    ``M`` motor torque, ``T`` opposing torque on the mechanism's shaft, ``J_d`` inertia on the motor shaft, ``J_L``
    inertia on the mechanism's shaft, both > 0. Without ``T`` it is sqrt(J_L / J_d) (inertia match); an opposing torque
    raises it.

    >>> optimum_ratio(4.0, 0.0, 0.001, 0.025)  # sqrt(25)
    5.0
    """
    return J_L * M / (sqrt((T * J_d) ** 2 + J_L * J_d * M**2) - T * J_d)


@formula(symbol="k_opt", unit="1", source=f"{JAKAB}, (3.6): k = output speed / motor speed")
def speed_reduction(i_opt: One) -> One:
    """Reduction as output speed over motor speed, the reciprocal of the ratio.

    ``i_opt`` ratio motor speed / output speed.

    >>> speed_reduction(4.0)
    0.25
    """
    return 1 / i_opt


@formula(symbol="a_sup", unit="m/s2", source="derived: limit of the best acceleration for an ever larger ratio")
def acceleration_bound(M: NewtonMetre, F: Newton, J_d: KilogramMetre2, m: Kilogram) -> MetrePerSecond2:
    """Acceleration that no choice of lead or diameter and ratio together can exceed; approached, never reached.

    ``M`` motor torque, ``F`` opposing force, ``J_d`` inertia on the motor shaft, ``m`` moved mass. The larger the ratio
    (with a lead or diameter that grows along), the less the inertia on the mechanism's shaft counts. Without ``F``
    it is M / (2 sqrt(m J_d)).

    >>> acceleration_bound(4.0, 0.0, 0.01, 25.0)  # 4 / (2 * 0.5)
    4.0
    """
    B = (sqrt((F * J_d) ** 2 + m * J_d * M**2) - F * J_d) / (m * M)
    return B * (M - F * B) / (J_d + m * B**2)


@formula(symbol="lambda_J", unit="1", source="derived: 1 at the optimum without opposing force")
def inertia_match(m: Kilogram, A: MetrePerRad, J_f: KilogramMetre2) -> One:
    """Inertia of the moved mass over the inertia of everything else, on the mechanism's shaft.

    ``m`` moved mass, ``A`` transmission constant, ``J_f`` inertia of everything else. 1 is the match; above it a
    smaller lead or diameter accelerates faster.

    >>> inertia_match(50.0, 0.01, 0.005)
    1.0
    """
    return m * A**2 / J_f
