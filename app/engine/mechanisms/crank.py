"""Slider-crank: a crank and a rod push a slide to and fro, with exact kinematics at every angle."""

from collections.abc import Iterator
from typing import Annotated, Any, ClassVar, Literal, Self

import numpy as np
from pydantic import model_validator

from app.engine.environment import Environment
from app.engine.formulas import crank as formulas
from app.engine.formulas.conversion import dynamic_power, linear_speed, mechanical_power
from app.engine.formulas.rail import rolling_resistance
from app.engine.formulas.resistance import guide_friction, sum_of_forces, weight_along_axis
from app.engine.mechanisms.base import Mechanism
from app.engine.mechanisms.crank_motion import Slide, angle_of_largest, followed
from app.engine.mechanisms.guided_axis import refused, without_zeros
from app.engine.mechanisms.load import Load
from app.engine.motion.profile import MotionProfile
from app.engine.quantity import Declaration, Option, Quantity
from app.engine.sheet import Sheet

CRANK, SLIDE, FRICTION = "Crank and rod", "Slide and goods", "Resistances"
LONGEST_RATIO = 0.8
"""Of crank radius to rod, a limit of our own: beyond it the rod stands at over 53 degrees and the slide jams."""

Loaded = Literal["both", "inward", "outward"]


class Crank(Mechanism):
    """A central slider-crank. Its shaft is the crank shaft."""

    title: ClassVar[str] = "Crank drive"
    summary: ClassVar[str] = "Crank and rod move a slide to and fro: pushers, lifting tables, shears, presses."
    drawing: ClassVar[str] = "crank.svg"
    motion_kind: ClassVar[Literal["linear", "rotary"]] = "rotary"
    follows_course: ClassVar[bool] = True
    one_way: ClassVar[bool] = True

    kind: Literal["crank"] = "crank"
    crank_radius: Annotated[
        float, Quantity("mm", symbol="r", gt=0, le=10, group=CRANK, about="crank radius, half the stroke")
    ]
    rod_length: Annotated[float, Quantity("mm", symbol="l", gt=0, le=50, group=CRANK, about="length of the rod")]
    start_angle: Annotated[
        float,
        Quantity("deg", symbol="phi_0", ge=-2 * np.pi, le=2 * np.pi, default=0.0, source="outer dead centre",
                 group=CRANK, about="angle of the crank at the start; 0: the slide is farthest out"),
    ]  # fmt: skip
    crank_inertia: Annotated[
        float,
        Quantity("kg m2", symbol="J_K", ge=0, le=1e5, default=0.0, source="left out until given", group=CRANK,
                 about="inertia of crank and crank shaft"),
    ]  # fmt: skip
    rod_mass: Annotated[
        float,
        Quantity("kg", symbol="m_P", ge=0, le=1e5, default=0.0, source="left out until given", group=CRANK,
                 about="mass of the rod; the pin rises as it leaves the outer dead centre"),
    ]  # fmt: skip
    rod_centre: Annotated[
        float,
        Quantity("1", symbol="x_P", ge=0, le=1, default=0.5, source="uniform rod", group=CRANK,
                 about="centre of mass of the rod: distance from the crank pin as a share of its length"),
    ]  # fmt: skip
    unbalance: Annotated[
        float,
        Quantity("kg m", symbol="U_K", ge=-1e6, le=1e6, default=0.0, source="balanced, the rod apart", group=CRANK,
                 about="unbalance of the crank towards its pin, mass times distance; negative: counterweight"),
    ]  # fmt: skip
    slide_mass: Annotated[
        float,
        Quantity("kg", symbol="m_0", ge=0, le=1e6, default=0.0, source="left out until given", group=SLIDE,
                 about="mass that moves on both strokes"),
    ]  # fmt: skip
    load_mass: Annotated[
        float, Quantity("kg", symbol="m", ge=0, le=1e6, group=SLIDE, about="goods moved on the loaded stroke")
    ]
    process_force: Annotated[
        float,
        Quantity("N", symbol="F_p", ge=-1e8, le=1e8, default=0.0, source="none given", group=SLIDE,
                 about="force of the process against the motion on the loaded stroke; negative: it helps"),
    ]  # fmt: skip
    loaded: Annotated[
        Loaded,
        Option(default="both", source="on the safe side", group=SLIDE, about="loaded stroke",
               labels={"both": "both strokes", "inward": "0 to 180 degrees: towards the crank shaft",
                       "outward": "180 to 360 degrees: away from the crank shaft"}),
    ]  # fmt: skip
    inclination: Annotated[
        float,
        Quantity("deg", symbol="delta", ge=-np.pi / 2, le=np.pi / 2, default=0.0, source="level", group=SLIDE,
                 about="slope of the slideway; positive: the slide climbs towards the crank shaft"),
    ]  # fmt: skip
    friction_coefficient: Annotated[
        float,
        Quantity("1", symbol="mu", ge=0, le=2, default=0.1, source="SEW 2001, 17.1: greased steel, 0.04 to 0.25",
                 group=FRICTION, about="sliding friction of slide and goods"),
    ]  # fmt: skip
    wheel_diameter: Annotated[
        float | None,
        Quantity("mm", symbol="D", gt=0, le=5, default=None, group=FRICTION,
                 about="diameter of wheels or rollers on which everything rolls; empty: it slides"),
    ]  # fmt: skip
    journal_diameter: Annotated[
        float,
        Quantity("mm", symbol="d_j", ge=0, le=5, default=0.0, source="no bearing friction", group=FRICTION,
                 about="diameter of the journals"),
    ]  # fmt: skip
    rolling_arm: Annotated[
        float,
        Quantity("mm", symbol="f", ge=0, le=0.05, default=0.0005, source="SEW 2001, 17.1: steel on steel",
                 group=FRICTION, about="lever arm of rolling friction"),
    ]  # fmt: skip
    bearing_friction: Annotated[
        float,
        Quantity("1", symbol="mu_L", ge=0, le=1, default=0.005, source="SEW 2001, 17.1: rolling bearing",
                 group=FRICTION, about="coefficient of bearing friction"),
    ]  # fmt: skip
    rim_friction: Annotated[
        float,
        Quantity("1", symbol="c", ge=0, le=0.1, default=0.003, source="SEW 2001, 17.1: wheels on rolling bearings",
                 group=FRICTION, about="rim and guiding friction as a share of weight"),
    ]  # fmt: skip
    friction_force: Annotated[
        float,
        Quantity("N", symbol="F_c", ge=0, le=1e7, default=0.0, source="none given", group=FRICTION,
                 about="constant friction besides"),
    ]  # fmt: skip
    efficiency: Annotated[
        float,
        Quantity("1", symbol="eta_L", gt=0, le=1, default=0.9, source="SEW 2001, 14: crank drive", group=FRICTION,
                 about="efficiency of joints and guides"),
    ]  # fmt: skip

    @model_validator(mode="after")
    def _the_rod_is_long_enough(self) -> Self:
        if self.crank_radius > LONGEST_RATIO * self.rod_length:
            least = self.crank_radius / LONGEST_RATIO
            raise refused(self, "rod_length", f"too short for this crank: at least {1000 * least:g} mm")
        return self

    @model_validator(mode="after")
    def _something_moves(self) -> Self:
        if self.slide_mass + self.load_mass == 0:
            raise refused(self, "load_mass", "nothing moves: give the mass of the goods or of the slide")
        return self

    def defaults_taken(self) -> Iterator[tuple[str, Declaration, Any]]:
        """As in the base, without those that do not count here."""
        rolling = {"journal_diameter", "rolling_arm", "bearing_friction", "rim_friction"}
        idle = rolling if self.wheel_diameter is None else {"friction_coefficient"}
        if not self.rod_mass:
            idle.add("rod_centre")
        yield from (found for found in super().defaults_taken() if found[0] not in idle)

    def load_at_shaft(self, motion: MotionProfile, environment: Environment, sheet: Sheet) -> Load:
        """Load cycle at the crank shaft, cut into small angles."""
        slide = self._slide(sheet, environment)
        course = followed(motion, self.start_angle, sheet)
        self._record_kinematics(sheet, motion.max_speed)
        cycle = slide.cycle(course, environment.regeneration)
        slide.record(sheet, course, cycle, environment.regeneration)
        self._record_approximation(sheet, slide, motion.max_speed)
        return Load(
            cycle=cycle, statics=slide.statics(course, environment.regeneration),
            results={"largest_slide_speed": sheet.value("largest_slide_speed")},
            diagrams=slide.diagrams(motion.max_speed, environment.regeneration),
        )  # fmt: skip

    def _resistance(self, sheet: Sheet, key: str, label: str, m: float, gravity: float) -> float:
        """Friction of a mass on its way [N]."""
        if self.wheel_diameter is None:
            rubbing = sheet(guide_friction, key=key, label=label, mu=self.friction_coefficient, m=m, g=gravity,
                            alpha=self.inclination)  # fmt: skip
        else:
            rubbing = sheet(rolling_resistance, key=key, label=label, m=m, g=gravity, alpha=self.inclination,
                            D=self.wheel_diameter, mu_L=self.bearing_friction, d_j=self.journal_diameter,
                            f=self.rolling_arm, c=self.rim_friction)  # fmt: skip
        parts = without_zeros([rubbing, self.friction_force])
        return sheet(sum_of_forces, key=f"{key}_total", symbol="F_f", label=f"{label}, all", F_k=parts)

    def _slide(self, sheet: Sheet, environment: Environment) -> Slide:
        """Everything that moves, with its forces written to ``sheet``."""
        g, rod, turning = environment.gravity, 0.0, self.crank_inertia
        with sheet.section("Slide and resistances"):
            unbalance = self.unbalance
            if self.rod_mass:
                unbalance = sheet(formulas.crank_unbalance, U_K=unbalance, m_P=self.rod_mass, x_P=self.rod_centre,
                                  r=self.crank_radius)  # fmt: skip
                rod = sheet(formulas.rod_mass_with_slide, m_P=self.rod_mass, x_P=self.rod_centre)
                turning += sheet(formulas.rod_inertia_with_crank, m_P=self.rod_mass, x_P=self.rod_centre,
                                 r=self.crank_radius)  # fmt: skip
            empty = self.slide_mass + rod
            full = empty + self.load_mass
            weights = [
                sheet(weight_along_axis, key=key, label=label, m=m, g=g, alpha=self.inclination)
                if self.inclination
                else 0.0
                for key, label, m in (
                    ("weight_loaded", "Weight along the slideway, loaded stroke", full),
                    ("weight_empty", "Weight along the slideway, empty stroke", empty),
                )
            ]
            loaded = self._resistance(sheet, "resistance_loaded", "Friction on the loaded stroke", full, g)
            idle = loaded
            if self.loaded != "both":
                idle = self._resistance(sheet, "resistance_empty", "Friction on the empty stroke", empty, g)
        return Slide(
            radius=self.crank_radius, rod=self.rod_length, turning_inertia=turning,
            unbalance=unbalance, gravity=g, slope=self.inclination,
            efficiency=self.efficiency, loaded=self.loaded, masses=(empty, full), weights=(weights[1], weights[0]),
            frictions=(idle, loaded), process_force=self.process_force,
        )  # fmt: skip

    def _record_kinematics(self, sheet: Sheet, omega: float) -> None:
        """Write stroke, highest speed and the accelerations in the dead centres, exact."""
        r, l = self.crank_radius, self.rod_length
        fastest = angle_of_largest(lambda angles: np.asarray(formulas.crank_transmission(angles, r, l)))
        with sheet.section("Exact kinematics"):
            sheet(formulas.crank_ratio, r=r, l=l)
            sheet(formulas.crank_stroke, r=r)
            label = "Largest travel per radian"
            A = sheet(formulas.crank_transmission, key="largest_transmission", label=label, phi=fastest, r=r, l=l)
            label = "Highest speed of the slide"
            sheet(linear_speed, key="largest_slide_speed", label=label, omega=omega, A=A)
            for key, where, phi in (("outer", "outer", 0.0), ("inner", "inner", np.pi)):
                label = f"Acceleration of the slide in the {where} dead centre at constant speed"
                sheet(formulas.crank_slide_acceleration, key=f"{key}_acceleration", label=label, phi=phi, omega=omega,
                      alpha_s=0.0, A=0.0, r=r, l=l)  # fmt: skip

    def _record_approximation(self, sheet: Sheet, slide: Slide, omega: float) -> None:
        """Write what the approximate formulas of handbooks give, for comparison; nothing is built on it."""
        r, l, eta = self.crank_radius, self.rod_length, self.efficiency
        with sheet.section("By the approximate formulas, for comparison"):
            share = formulas.crank_ratio(r, l)
            phi = sheet(formulas.crank_fast_angle, r=r, l=l)
            label = "Speed at the angle where crank and rod stand at a right angle"
            v = sheet(formulas.crank_speed_approximate, key="approximate_speed", label=label, omega=omega, phi=phi, r=r,
                      lambda_c=share)  # fmt: skip
            label = "Static power there, with the losses of the mechanism"
            sheet(mechanical_power, key="approximate_static_power", symbol="P_S", label=label,
                  F=slide.frictions[1] / eta, v=v)  # fmt: skip
            phi = sheet(formulas.crank_power_angle, phi=_power_angle(share), lambda_c=share)
            label = "Speed at the largest dynamic power"
            v = sheet(formulas.crank_speed_approximate, key="approximate_power_speed", label=label, omega=omega,
                      phi=phi, r=r, lambda_c=share)  # fmt: skip
            label = "Acceleration at the largest dynamic power"
            a = sheet(formulas.crank_acceleration_approximate, key="approximate_power_acceleration", label=label,
                      omega=omega, phi=phi, r=r, lambda_c=share)  # fmt: skip
            label = "Largest dynamic power"
            sheet(dynamic_power, key="approximate_dynamic_power", label=label, m=slide.masses[1], a=a, v=v, eta=eta)


def _power_angle(share: float) -> float:
    """Root of the derivative of the approximate speed times acceleration [rad]."""
    phi = np.pi / 4
    for _ in range(50):
        phi = float(formulas.crank_power_angle(phi, share))
    return phi
