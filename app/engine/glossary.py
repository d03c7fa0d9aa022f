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
    ("D", "outer or effective diameter", "m"),
    ("F F_k", "force", "N"),
    ("J J_k", "moment of inertia", "kg m2"),
    ("M M_k", "torque", "N m"),
    ("a", "acceleration", "m/s2"),
    ("alpha_s", "angular acceleration of the shaft", "rad/s2"),
    ("eta", "efficiency", "1"),
    ("g", "acceleration of free fall", "m/s2"),
    ("i", "ratio: fast speed / slow speed", "1"),
    ("l", "length", "m"),
    ("m m_k", "mass", "kg"),
    ("omega omega_k", "angular speed", "rad/s"),
    ("r", "radius", "m"),
    ("rho", "density", "kg/m3"),
    ("t t_k", "time or duration", "s"),
    ("v v_k", "speed", "m/s"),
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
