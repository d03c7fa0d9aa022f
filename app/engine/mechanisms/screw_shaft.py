"""The screw with its bearings: inertia, stiffness, speed limits and buckling, each checked as far as data are given."""

from collections.abc import Iterator
from typing import Annotated, Any, Literal, NamedTuple, Self

import numpy as np
from pydantic import model_validator

from app.engine.formulas.inertia import cylinder_mass, linear_mass_inertia, solid_cylinder_inertia, sum_of_inertias
from app.engine.formulas.screw import (
    buckling_force,
    critical_screw_speed,
    dn_factor,
    permissible_axial_force,
    permissible_screw_speed,
    screw_constant,
)
from app.engine.formulas.stiffness import (
    ball_contact_stiffness,
    damping_coefficient,
    friction_lost_motion,
    natural_frequency,
    parallel_stiffness,
    round_cross_section,
    series_stiffness,
    stiffness_held_at_both_ends,
    stiffness_held_at_one_end,
    torsion_stiffness_at_nut,
)
from app.engine.mechanisms.guided_axis import refused, without_zeros
from app.engine.quantity import Declaration, Declared, Option, Quantity
from app.engine.sheet import Sheet

SCREW = "Screw"
STIFFNESS = "Stiffness and bearings"
LIMITS = "Limits"
LACHMAN = "Lachman, Mendricky 2015, part 3"
STEEL = "steel"
MAKERS = "usual with makers of ball screws, e.g. THK"

Mounting = Literal["fixed_fixed", "fixed_supported", "supported_supported", "fixed_free"]


class _MountingFactors(NamedTuple):
    """What the mounting of a screw decides."""

    eigenvalue: float
    """First eigenvalue of the bending beam"""
    buckling: float
    """Factor on Euler's load of the beam hinged at both ends"""
    thrust_at_both_ends: bool


MOUNTINGS: dict[str, _MountingFactors] = {
    "fixed_fixed": _MountingFactors(4.730, 4.0, True),
    "fixed_supported": _MountingFactors(3.927, 2.0, False),
    "supported_supported": _MountingFactors(np.pi, 1.0, True),
    "fixed_free": _MountingFactors(1.875, 0.25, False),
}


class ScrewShaft(Declared):
    """Screw and bearings. Every stiffness is optional: what is missing is named by the check that needs it."""

    nominal_diameter: Annotated[
        float, Quantity("mm", symbol="D", gt=0, le=1, group=SCREW, about="nominal diameter of the screw")
    ]
    lead: Annotated[
        float,
        Quantity(
            "mm", symbol="h", gt=0, le=1, group=SCREW,
            about="lead: travel per revolution, pitch times number of starts",
        ),
    ]  # fmt: skip
    length: Annotated[
        float | None, Quantity("mm", symbol="l", gt=0, le=30, default=None, group=SCREW, about="length of the screw")
    ]
    root_diameter: Annotated[
        float | None,
        Quantity("mm", symbol="d_r", gt=0, le=1, default=None, group=SCREW, about="root (core) diameter of the thread"),
    ]
    density: Annotated[
        float,
        Quantity(
            "kg/m3",
            symbol="rho",
            gt=0,
            le=25e3,
            default=7850.0,
            source=STEEL,
            group=SCREW,
            about="density of the screw",
        ),
    ]
    screw_mass: Annotated[
        float | None,
        Quantity(
            "kg", symbol="m_s", gt=0, le=1e5, default=None, group=SCREW,
            about="mass of the screw, in place of length and density",
        ),
    ]  # fmt: skip
    screw_inertia: Annotated[
        float | None,
        Quantity(
            "kg cm2", symbol="J_s", ge=0, le=1e4, default=None, group=SCREW,
            about="inertia of the screw, in place of its mass or length",
        ),
    ]  # fmt: skip
    coupling_inertia: Annotated[
        float,
        Quantity(
            "kg cm2", symbol="J_cpl", ge=0, le=1e4, default=0.0, source="none given", group=SCREW,
            about="inertia of coupling or wheel at the end of the screw",
        ),
    ]  # fmt: skip

    mounting: Annotated[
        Mounting,
        Option(
            default="fixed_supported", source="usual mounting of feed screws", group=STIFFNESS,
            about="how the ends of the screw are held",
            labels={
                "fixed_fixed": "fixed – fixed (thrust at both ends)",
                "fixed_supported": "fixed – supported (thrust at one end)",
                "supported_supported": "supported – supported (thrust at both ends)",
                "fixed_free": "fixed – free (thrust at one end)",
            },
        ),
    ]  # fmt: skip
    bearing_stiffness: Annotated[
        float | None,
        Quantity(
            "N/um", symbol="k_B", gt=0, le=1e12, default=None, group=STIFFNESS,
            about="axial stiffness of the thrust bearing at one end",
        ),
    ]  # fmt: skip
    loaded_turns: Annotated[
        float | None,
        Quantity(
            "1", symbol="z_t", gt=0, le=50, default=None, group=STIFFNESS,
            about="loaded turns of the ball nut, for the empirical stiffness of the ball contact",
        ),
    ]  # fmt: skip
    nut_stiffness: Annotated[
        float | None,
        Quantity(
            "N/um", symbol="k_st", gt=0, le=1e12, default=None, group=STIFFNESS,
            about="stiffness of the nut with its ball contact as the maker gives it, in place of the loaded turns",
        ),
    ]  # fmt: skip
    stressed_length: Annotated[
        float | None,
        Quantity(
            "mm", symbol="x", gt=0, le=30, default=None, group=STIFFNESS,
            about="largest length of the screw under load: from the driven end to the nut in its worst place",
        ),
    ]  # fmt: skip
    bearing_distance: Annotated[
        float | None,
        Quantity(
            "mm", symbol="l_b", gt=0, le=30, default=None, group=STIFFNESS,
            about="free length between the bearings; without it the length of the screw",
        ),
    ]  # fmt: skip
    elastic_modulus: Annotated[
        float,
        Quantity(
            "GPa",
            symbol="E",
            gt=0,
            le=1e12,
            default=210e9,
            source=STEEL,
            group=STIFFNESS,
            about="modulus of elasticity",
        ),
    ]
    shear_modulus: Annotated[
        float,
        Quantity("GPa", symbol="G", gt=0, le=1e12, default=80e9, source=STEEL, group=STIFFNESS, about="shear modulus"),
    ]
    damping_ratio: Annotated[
        float,
        Quantity(
            "1",
            symbol="xi",
            ge=0,
            le=2,
            default=0.1,
            source=LACHMAN,
            group=STIFFNESS,
            about="damping ratio of the axis",
        ),
    ]

    natural_frequency_limit: Annotated[
        float,
        Quantity(
            "Hz",
            symbol="f_min",
            gt=0,
            le=1e4,
            default=50.0,
            source=LACHMAN,
            group=LIMITS,
            about="least natural frequency",
        ),
    ]
    measured_on_motor: Annotated[
        bool,
        Option(
            default=True, source="usual servo motor with encoder", group=LIMITS,
            about="position is measured on the motor: friction winds up the screw unseen",
        ),
    ]  # fmt: skip
    lost_motion_limit: Annotated[
        float,
        Quantity(
            "um", symbol="Delta_x_max", gt=0, le=0.1, default=5e-6, source=LACHMAN, group=LIMITS,
            about="permitted lost motion through friction",
        ),
    ]  # fmt: skip
    dn_limit: Annotated[
        float | None,
        Quantity(
            "mm rpm", symbol="DN_max", gt=0, le=1e5, default=None, group=LIMITS,
            about="permitted speed figure of the screw: diameter times speed",
        ),
    ]  # fmt: skip
    permitted_speed: Annotated[
        float | None,
        Quantity(
            "rpm", symbol="n_max", gt=0, le=1e4, default=None, group=LIMITS,
            about="permitted speed of the screw as its maker states it",
        ),
    ]  # fmt: skip
    critical_speed_share: Annotated[
        float,
        Quantity(
            "1", symbol="k_c", gt=0, le=1, default=0.8, source=MAKERS, group=LIMITS,
            about="permitted share of the critical speed",
        ),
    ]  # fmt: skip
    buckling_safety: Annotated[
        float,
        Quantity(
            "1", symbol="nu", ge=1, le=20, default=2.0, source=MAKERS, group=LIMITS,
            about="safety against buckling",
        ),
    ]  # fmt: skip

    @model_validator(mode="after")
    def _screw_is_possible(self) -> Self:
        if self.length is None and self.screw_mass is None and self.screw_inertia is None:
            raise refused(self, "length", "give the length of the screw, its mass or its inertia")
        if self.root_diameter is not None and self.root_diameter > self.nominal_diameter:
            raise refused(self, "root_diameter", "the root diameter is larger than the nominal diameter")
        for name in ("stressed_length", "bearing_distance"):
            value = getattr(self, name)
            if value is not None and self.length is not None and value > self.length:
                raise refused(self, name, "is longer than the screw")
        return self

    def defaults_taken(self) -> Iterator[tuple[str, Declaration, Any]]:
        """As in the base, without those that do not count here because nothing is computed from them."""
        idle: set[str] = set()
        if self._missing_for_stiffness():
            idle |= {"shear_modulus", "damping_ratio", "natural_frequency_limit", "lost_motion_limit"}
            idle |= {"measured_on_motor"}
        if not self.measured_on_motor:
            idle.add("lost_motion_limit")
        if self.root_diameter is None:
            idle |= {"critical_speed_share", "buckling_safety"}
            if self._missing_for_stiffness():
                idle |= {"elastic_modulus", "mounting"}
            if self.screw_mass is not None or self.screw_inertia is not None:
                idle.add("density")
        yield from (found for found in super().defaults_taken() if found[0] not in idle)

    @property
    def transmission_constant(self) -> float:
        """A: travel of the nut per radian of the screw [m/rad]."""
        return float(screw_constant(self.lead))

    @property
    def shaft_inertia(self) -> float:
        """Inertia that turns with the screw whatever its lead: screw and coupling [kg m2]."""
        if self.screw_inertia is not None:
            return self.screw_inertia + self.coupling_inertia
        mass = self.screw_mass or cylinder_mass(self.nominal_diameter, self.length, self.density)
        return float(solid_cylinder_inertia(mass, self.nominal_diameter)) + self.coupling_inertia

    def record_inertia(self, sheet: Sheet, moved_mass: float) -> tuple[float, float]:
        """Record the inertia of the screw alone with its coupling and with all that it moves; returns both [kg m2]."""
        D = self.nominal_diameter
        A = sheet(screw_constant, h=self.lead)
        if self.screw_inertia is not None:
            J_s = self.screw_inertia
            sheet.decide("Inertia of the screw as given", "it replaces the one from mass or length")
        else:
            mass = self.screw_mass
            if mass is None:
                mass = sheet(cylinder_mass, key="screw_mass", symbol="m_s", label="Mass of the screw as a solid bar",
                             D=D, l=self.length, rho=self.density)  # fmt: skip
            J_s = sheet(
                solid_cylinder_inertia, key="screw_inertia", symbol="J_s", label="Inertia of the screw", m=mass, D=D
            )
        rotating = sheet(
            sum_of_inertias, key="rotating_inertia", symbol="J_rot", label="Inertia of screw and coupling",
            J_k=without_zeros([J_s, self.coupling_inertia]),
        )  # fmt: skip
        J_m = sheet(
            linear_mass_inertia, key="mass_inertia_on_screw", symbol="J_m", m=moved_mass, A=A,
            label="Inertia of all moved masses on the screw",
        )  # fmt: skip
        load = sheet(
            sum_of_inertias, key="load_inertia_on_screw", symbol="J_load", label="Inertia of the load on the screw",
            J_k=[rotating, J_m],
        )  # fmt: skip
        return rotating, load

    def check_speed(self, sheet: Sheet, speed: float) -> None:
        """Check the highest speed of the screw [rad/s]: speed figure, maker's limit, critical speed."""
        figure = sheet(dn_factor, D=self.nominal_diameter, omega=speed)
        missing = "" if self.dn_limit else "permitted speed figure DN of the screw"
        sheet.check("dn_factor", "Speed figure of the screw", figure, self.dn_limit, "mm rpm",
                    "limit of the maker of the screw", formula="dn_factor", missing=missing)  # fmt: skip
        missing = "" if self.permitted_speed else "permitted speed of the screw"
        sheet.check("screw_speed", "Speed of the screw", speed, self.permitted_speed, "rpm",
                    "limit of the maker of the screw", missing=missing)  # fmt: skip
        self._check_critical_speed(sheet, speed)

    def _check_critical_speed(self, sheet: Sheet, speed: float) -> None:
        missing = self._missing(root_diameter="root diameter of the screw")
        if self._span is None:
            missing = ", ".join(filter(None, [missing, "distance of the bearings"]))
        permitted = None
        if not missing:
            if self.bearing_distance is None:
                self._assume_bearing_distance(sheet)
            critical = sheet(
                critical_screw_speed, lambda_b=MOUNTINGS[self.mounting].eigenvalue, d_r=self.root_diameter,
                l_b=self._span, E=self.elastic_modulus, rho=self.density,
            )  # fmt: skip
            permitted = sheet(permissible_screw_speed, k_c=self.critical_speed_share, omega_c=critical)
        sheet.check("critical_speed", "Critical speed of the screw", speed, permitted, "rpm",
                    "first bending frequency of the screw by its mounting", formula="permissible_screw_speed",
                    missing=missing)  # fmt: skip

    def _assume_bearing_distance(self, sheet: Sheet) -> None:
        sheet.assume("bearing_distance", "free length between the bearings: the length of the screw", value=self.length,
                     unit="mm", symbol="l_b", source="on the safe side")  # fmt: skip

    def check_buckling(self, sheet: Sheet, axial_force: float) -> None:
        """Check the largest force on the nut [N], unsigned, against buckling, as if it always were compression."""
        missing = self._missing(root_diameter="root diameter of the screw", stressed_length="largest length under load")
        permitted = None
        if not missing:
            limit = sheet(
                buckling_force, k_b=MOUNTINGS[self.mounting].buckling, E=self.elastic_modulus, d_r=self.root_diameter,
                l_x=self.stressed_length,
            )  # fmt: skip
            permitted = sheet(permissible_axial_force, F_B=limit, nu=self.buckling_safety)
        sheet.check("buckling", "Buckling of the screw", axial_force, permitted, "N", "Euler, with a safety factor",
                    formula="permissible_axial_force", missing=missing)  # fmt: skip

    def check_stiffness(self, sheet: Sheet, mass: float, friction: float) -> dict[str, float]:
        """Record each stiffness that the data allow and check natural frequency and lost motion.

        ``mass`` [kg] swings on the screw, ``friction`` [N] winds it up. Returns the headline results by sheet key.
        """
        members, missing = self._members(sheet), self._missing_for_stiffness()
        results: dict[str, float] = {}
        frequency = lost = None
        if not missing:
            label = "Stiffness of the axis: ball contact, bearings, shaft and torsion in series"
            total = sheet(series_stiffness, key="total_stiffness", label=label, k_k=members)
            sheet(damping_coefficient, key="damping", xi=self.damping_ratio, k=total, m=mass)
            frequency = sheet(natural_frequency, k=total, m=mass)
            lost = sheet(friction_lost_motion, key="lost_motion_friction", F_T=friction, k=total)
            results = {"total_stiffness": total, "natural_frequency": frequency, "lost_motion_friction": lost}
        sheet.check("natural_frequency", "Natural frequency of the axis", self.natural_frequency_limit, frequency, "Hz",
                    "lower limit for a position loop", formula="natural_frequency", missing=missing)  # fmt: skip
        if self.measured_on_motor:
            sheet.check("lost_motion", "Lost motion through friction", lost, self.lost_motion_limit, "um",
                        "limit when the position is measured on the motor", formula="friction_lost_motion",
                        missing=missing)  # fmt: skip
        else:
            sheet.decide("Lost motion is not judged", "the position is measured at the slide")
        return results

    def _missing_for_stiffness(self) -> str:
        names = []
        if self.nut_stiffness is None and self.loaded_turns is None:
            names.append("stiffness of the nut or its loaded turns")
        if self.bearing_stiffness is None:
            names.append("stiffness of the thrust bearing")
        if MOUNTINGS[self.mounting].thrust_at_both_ends and self._span is None:
            names.append("length of the screw")
        if self.stressed_length is None:
            names.append("largest length under load")
        return ", ".join(names)

    @property
    def _span(self) -> float | None:
        return self.bearing_distance or self.length

    def _members(self, sheet: Sheet) -> list[float]:
        """Stiffness of each member that the data allow [N/m]."""
        found = (self._contact(sheet), self._bearings(sheet), self._shaft(sheet), self._torsion(sheet))
        return [value for value in found if value is not None]

    def _contact(self, sheet: Sheet) -> float | None:
        if self.nut_stiffness is not None or self.loaded_turns is None:
            return self.nut_stiffness
        return sheet(ball_contact_stiffness, z_t=self.loaded_turns, D=self.nominal_diameter)

    def _bearings(self, sheet: Sheet) -> float | None:
        one = self.bearing_stiffness
        if one is None:
            return None
        ends = 2 if MOUNTINGS[self.mounting].thrust_at_both_ends else 1
        return sheet(parallel_stiffness, key="bearing_stiffness_total", symbol="k_bear", k_k=[one] * ends,
                     label="Axial stiffness of the bearings that take thrust")  # fmt: skip

    def _loaded_diameter(self, sheet: Sheet) -> float:
        if self.root_diameter is None:
            sheet.assume("stiffness_diameter", "diameter that carries the load of the screw: the nominal diameter",
                         value=self.nominal_diameter, unit="mm", symbol="D",
                         source="no root diameter given; it would give a lower stiffness")  # fmt: skip
        return self.root_diameter or self.nominal_diameter

    def _shaft(self, sheet: Sheet) -> float | None:
        both = MOUNTINGS[self.mounting].thrust_at_both_ends
        span = self._span
        if (span if both else self.stressed_length) is None:
            return None
        S = sheet(round_cross_section, key="screw_cross_section", label="Cross-section of the screw",
                  D=self._loaded_diameter(sheet))  # fmt: skip
        if both:
            return sheet(
                stiffness_held_at_both_ends, key="screw_tension_stiffness", E=self.elastic_modulus, S=S, l=span
            )
        return sheet(
            stiffness_held_at_one_end,
            key="screw_tension_stiffness",
            E=self.elastic_modulus,
            S=S,
            x=self.stressed_length,
        )

    def _torsion(self, sheet: Sheet) -> float | None:
        if self.stressed_length is None:
            return None
        return sheet(
            torsion_stiffness_at_nut, key="screw_torsion_stiffness", G=self.shear_modulus,
            D=self._loaded_diameter(sheet), h=self.lead, x=self.stressed_length,
        )  # fmt: skip

    def _missing(self, **names: str) -> str:
        return ", ".join(text for name, text in names.items() if getattr(self, name) is None)
