"""The symbols of the formula library: one name, one meaning, one SI unit.

A test holds every argument of every formula to this list. A name whose entry lists variants means the same thing of
different parts (``J_1``, ``J_2``) or at different times (``M_k`` per segment).
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class Term:
    """What a symbol stands for, and the SI unit in which formulas take it."""

    meaning: str
    unit: str


_TERMS: tuple[tuple[str, str, str], ...] = (
    # names, meaning, SI unit
    ("A", "transmission constant: travel per radian of the shaft", "m/rad"),
    ("A_opt", "transmission constant that accelerates the load fastest", "m/rad"),
    ("D", "outer or effective diameter", "m"),
    ("D_i", "inner diameter", "m"),
    ("E", "modulus of elasticity", "Pa"),
    ("F F_k", "force", "N"),
    ("F_2", "tension of the slack strand of a belt", "N"),
    ("F_B", "buckling force", "N"),
    ("F_C", "pull of a belt on the slide", "N"),
    ("F_F", "resistance of a wheeled load", "N"),
    ("F_T", "friction force", "N"),
    ("F_V", "pretension of a strand", "N"),
    ("F_Z", "pull of a belt on the counterweight", "N"),
    ("F_t", "tangential force of a mesh", "N"),
    ("G", "shear modulus", "Pa"),
    ("I", "current (rms)", "A"),
    ("I_a", "current at the continuous point (rms)", "A"),
    ("I_max", "peak current (rms)", "A"),
    ("J J_k", "moment of inertia", "kg m2"),
    ("J_L", "moment of inertia of the load on the mechanism's shaft", "kg m2"),
    ("J_M", "inertia of the motor", "kg m2"),
    ("J_c", "moment of inertia about an axis through the centre of gravity", "kg m2"),
    ("J_d", "moment of inertia of all that turns with the motor", "kg m2"),
    ("J_ext", "external inertia referred to the motor shaft", "kg m2"),
    ("J_f", "moment of inertia on the mechanism's shaft beside the moved mass", "kg m2"),
    ("J_red", "moment of inertia of the whole axis referred to the motor shaft", "kg m2"),
    ("J_s", "moment of inertia of what turns with the mechanism's shaft", "kg m2"),
    ("J_tot", "rotor and external inertia on the motor shaft", "kg m2"),
    ("J_x", "inertia of gear unit and coupling on the motor shaft", "kg m2"),
    ("L", "length of a whole belt", "m"),
    ("M M_k", "torque", "N m"),
    ("M_0", "stall torque", "N m"),
    ("M_B", "torque of the brake on the motor shaft", "N m"),
    ("M_L", "torque of the load on the motor shaft", "N m"),
    ("M_N", "rated torque", "N m"),
    ("M_P", "largest steady torque on the motor shaft", "N m"),
    ("M_T", "torque of all passive resistances on the motor shaft", "N m"),
    ("M_a M_b", "torque at a point of the limit curve", "N m"),
    ("M_dm", "dynamic torque on the motor shaft", "N m"),
    ("M_max", "peak torque", "N m"),
    ("M_u0", "largest torque of an unbalance", "N m"),
    ("R", "pitch radius of a pinion or pulley", "m/rad"),
    ("S", "cross-section", "m2"),
    ("T T_k", "torque of the load, behind a stage", "N m"),
    ("T_2", "torque at the output in the segment that decides", "N m"),
    ("T_max", "largest torque at the output in operation", "N m"),
    ("a", "acceleration", "m/s2"),
    ("a_d", "deceleration", "m/s2"),
    ("alpha", "inclination against the horizontal", "rad"),
    ("alpha_L", "angular acceleration of the output shaft", "rad/s2"),
    ("alpha_M", "angular acceleration of the motor shaft", "rad/s2"),
    ("alpha_n", "normal pressure angle of teeth", "rad"),
    ("alpha_s", "angular acceleration of the shaft", "rad/s2"),
    ("b", "width", "m"),
    ("beta", "helix angle of teeth", "rad"),
    ("c", "rim and flange friction of wheels as a share of their load", "1"),
    ("c_T", "share of the continuous torque that passive resistances may take", "1"),
    ("c_t", "inertia of solid pulleys divided by diameter^4", "kg/m2"),
    ("d", "pitch diameter", "m"),
    ("d_L", "mean diameter of a bearing", "m"),
    ("d_j", "diameter of the journals of a wheel", "m"),
    ("d_r", "root diameter of a thread", "m"),
    ("delta", "tilt of an axis of rotation against the vertical", "rad"),
    ("epsilon", "angular acceleration of the motor", "rad/s2"),
    ("eta", "efficiency", "1"),
    ("eta_r", "efficiency while the load returns power", "1"),
    ("f", "lever arm of rolling friction", "m"),
    ("g", "acceleration of free fall", "m/s2"),
    ("h", "lead of a screw: travel per revolution", "m"),
    ("i", "ratio: fast speed / slow speed", "1"),
    ("i_opt", "ratio that accelerates the load fastest", "1"),
    ("j", "jerk", "m/s3"),
    ("k k_k", "stiffness", "N/m"),
    ("k_M", "factor of the torque reserve", "1"),
    ("k_T", "torque constant", "N m/A"),
    ("k_b", "factor of the mounting on the buckling force", "1"),
    ("k_c", "permitted share of the critical speed", "1"),
    ("k_d", "share of the weight that rests on driven wheels", "1"),
    ("k_em", "emergency torque / largest torque in operation", "1"),
    ("k_t", "friction force per guided mass", "N/kg"),
    ("k_v", "viscous friction: force per speed", "N s/m"),
    ("l", "length", "m"),
    ("l_b", "free length between bearings", "m"),
    ("l_x", "length under compression", "m"),
    ("lambda_J", "ratio of external inertia to motor inertia", "1"),
    ("lambda_b", "first eigenvalue of a bending beam by its mounting", "1"),
    ("lambda_j", "share of a ramp in which the acceleration changes", "1"),
    ("m m_k", "mass", "kg"),
    ("m_n", "normal module of teeth", "m"),
    ("m_u", "mass of an unbalance", "kg"),
    ("mu", "friction coefficient", "1"),
    ("mu_0", "coefficient of static friction", "1"),
    ("mu_L", "coefficient of bearing friction", "1"),
    ("mu_d", "friction coefficient between belt and drum", "1"),
    ("mu_th", "friction coefficient of a thread", "1"),
    ("n n_a n_b", "speed", "rad/s"),
    ("n_N", "rated speed", "rad/s"),
    ("n_t", "number of pulleys", "1"),
    ("nu", "safety factor", "1"),
    ("omega omega_k", "angular speed", "rad/s"),
    ("omega_L", "highest speed of the output shaft", "rad/s"),
    ("omega_c", "critical angular speed", "rad/s"),
    ("omega_max", "permitted speed of the motor", "rad/s"),
    ("p", "pitch of a belt", "m"),
    ("phi", "angle", "rad"),
    ("phi_h", "lead angle of a thread", "rad"),
    ("q", "mass per length", "kg/m"),
    ("r", "radius", "m"),
    ("r_a", "deceleration / acceleration", "1"),
    ("r_n", "share of the highest speed that may be used", "1"),
    ("r_u", "distance of an unbalance from the axis", "m"),
    ("rho", "density", "kg/m3"),
    ("s", "distance", "m"),
    ("t t_k", "time or duration", "s"),
    ("t_A", "time of accelerating", "s"),
    ("t_D", "time of braking", "s"),
    ("t_cyc", "length of a cycle", "s"),
    ("t_on", "time under load in a cycle", "s"),
    ("t_set", "settling time", "s"),
    ("v v_k", "speed", "m/s"),
    ("x", "length of a screw under load", "m"),
    ("xi", "damping ratio", "1"),
    ("z", "number of teeth", "1"),
    ("z_t", "loaded turns of a ball nut", "1"),
)

GLOSSARY: dict[str, Term] = {name: Term(meaning, unit) for names, meaning, unit in _TERMS for name in names.split()}
"""Name of a formula's argument -> what it stands for."""


def meaning(name: str) -> str:
    """What a symbol stands for, in words; empty for a name that is not in the glossary.

    >>> meaning("eta")
    'efficiency'
    """
    found = GLOSSARY.get(name)
    return found.meaning if found else ""
