"""Timing belt axis: a slide clamped to a belt that runs over a drive pulley and idlers, at any inclination."""

from dataclasses import replace
from typing import Annotated, ClassVar, Literal, Self

import numpy as np
from pydantic import model_validator

from app.engine.environment import Environment
from app.engine.formulas.belt import (
    belt_mass,
    largest_strand_force,
    pulley_pitch_diameter,
    pulley_transmission,
    solid_pulley_inertia,
)
from app.engine.formulas.conversion import shaft_speed
from app.engine.formulas.inertia import solid_cylinder_inertia
from app.engine.formulas.optimum import pulley_inertia_coefficient
from app.engine.formulas.rack import travel_per_revolution
from app.engine.formulas.resistance import acceleration_force
from app.engine.mechanisms.base import Mechanism
from app.engine.mechanisms.guided_axis import GuidedAxis, refused
from app.engine.mechanisms.linear_axis import AxisWords, LinearAxis, record_axis
from app.engine.mechanisms.load import Load
from app.engine.motion.profile import MotionProfile
from app.engine.quantity import Option, Quantity
from app.engine.sheet import Sheet
from app.engine.transmission import LinearTransmission

PULLEYS = "Belt and pulleys"
LIMITS = "Limits of the belt"


class TimingBelt(GuidedAxis, Mechanism):
    """A slide on a timing belt. The drive's output shaft carries the drive pulley.

    A counterweight hangs on the other strand. The weight of the belt itself is balanced between its strands.
    """

    title: ClassVar[str] = "Timing belt axis"
    summary: ClassVar[str] = "Fast linear axis or hoist on a toothed belt, with or without counterweight."
    drawing: ClassVar[str] = "timing_belt.svg"
    motion_kind: ClassVar[Literal["linear", "rotary"]] = "linear"

    kind: Literal["timing_belt"] = "timing_belt"
    pulley_diameter: Annotated[
        float | None,
        Quantity(
            "mm", symbol="d", gt=0, le=5, default=None, group=PULLEYS,
            about="pitch diameter of the pulleys, or teeth and pitch instead",
        ),
    ]  # fmt: skip
    pulley_teeth: Annotated[
        int | None,
        Option(symbol="z", ge=6, le=1000, default=None, group=PULLEYS, about="number of teeth of the drive pulley"),
    ]
    belt_pitch: Annotated[
        float | None,
        Quantity("mm", symbol="p", gt=0, le=0.1, default=None, group=PULLEYS, about="pitch of the belt"),
    ]
    drive_pulley_inertia: Annotated[
        float | None,
        Quantity(
            "kg cm2", symbol="J_t", ge=0, le=1e3, default=None, group=PULLEYS,
            about="inertia of the drive pulley; without it and without a width the pulleys are left out",
        ),
    ]  # fmt: skip
    idler_inertia: Annotated[
        float | None,
        Quantity(
            "kg cm2", symbol="J_u", ge=0, le=1e3, default=None, group=PULLEYS,
            about="inertia of all idlers together, referred to the drive pulley's diameter",
        ),
    ]  # fmt: skip
    drive_pulley_mass: Annotated[
        float | None,
        Quantity(
            "kg", symbol="m_t", ge=0, le=1e4, default=None, group=PULLEYS,
            about="mass of the drive pulley as a solid disc, instead of its inertia",
        ),
    ]  # fmt: skip
    idler_mass: Annotated[
        float | None,
        Quantity(
            "kg", symbol="m_u", ge=0, le=1e4, default=None, group=PULLEYS,
            about="mass of all idlers together as solid discs, instead of their inertia",
        ),
    ]  # fmt: skip
    pulley_width: Annotated[
        float | None,
        Quantity(
            "mm", symbol="b", gt=0, le=2, default=None, group=PULLEYS,
            about="width of one drive pulley and one equal idler as solid discs, instead of masses and inertias",
        ),
    ]  # fmt: skip
    pulley_density: Annotated[
        float,
        Quantity(
            "kg/m3", symbol="rho", gt=0, le=25000, default=2700.0, group=PULLEYS, source="aluminium",
            about="density of the pulleys, where their width is given",
        ),
    ]  # fmt: skip
    belt_mass_per_length: Annotated[
        float,
        Quantity(
            "kg/m", symbol="q", ge=0, le=100, default=0.0, group=PULLEYS, source="left out until given",
            about="mass of the belt per length, in the width used",
        ),
    ]  # fmt: skip
    belt_length: Annotated[
        float,
        Quantity(
            "m", symbol="L", ge=0, le=500, default=0.0, group=PULLEYS, source="left out until given",
            about="length of the whole belt, both strands",
        ),
    ]  # fmt: skip
    efficiency: Annotated[
        float,
        Quantity(
            "1", symbol="eta", gt=0, le=1, default=0.9, group=PULLEYS, about="efficiency of the belt drive",
            source="SEW 2001, 17.1: toothed belt on rolling bearings, lower value",
        ),
    ]  # fmt: skip
    efficiency_covers: Annotated[
        Literal["belt", "load_side"],
        Option(
            default="belt", group=PULLEYS, about="what the efficiency acts on",
            source="the loss arises between drive pulley and belt",
            labels={"belt": "what the belt transmits", "load_side": "the whole load side, drive pulley included"},
        ),
    ]  # fmt: skip
    pretension: Annotated[
        float | None,
        Quantity(
            "N", symbol="F_V", ge=0, le=1e7, default=None, group=LIMITS,
            about="pretension of each strand at rest, 0 where only hanging masses tension the belt",
        ),
    ]  # fmt: skip
    permitted_strand_force: Annotated[
        float | None,
        Quantity(
            "N", symbol="F_perm", gt=0, le=1e8, default=None, group=LIMITS,
            about="permitted force in a strand of the belt, from the maker",
        ),
    ]  # fmt: skip
    permitted_peripheral_force: Annotated[
        float | None,
        Quantity(
            "N", symbol="F_Uperm", gt=0, le=1e8, default=None, group=LIMITS,
            about="permitted peripheral force of the teeth in mesh, from the maker",
        ),
    ]  # fmt: skip

    @model_validator(mode="after")
    def _one_description_of_the_pulleys(self) -> Self:
        if (self.pulley_teeth is None) != (self.belt_pitch is None):
            lacking = "pulley_teeth" if self.pulley_teeth is None else "belt_pitch"
            raise refused(self, lacking, "number of teeth and pitch belong together; give both or neither")
        if (self.pulley_diameter is None) == (self.pulley_teeth is None):
            raise refused(self, "pulley_diameter", "give either the pitch diameter or teeth and pitch")
        masses = (("drive_pulley_mass", self.drive_pulley_inertia), ("idler_mass", self.idler_inertia))
        for name, inertia in masses:
            if getattr(self, name) is not None and inertia is not None:
                raise refused(self, name, "give either the mass or the inertia, not both")
        given = [self.drive_pulley_inertia, self.idler_inertia, self.drive_pulley_mass, self.idler_mass]
        if self.pulley_width is not None and any(value is not None for value in given):
            raise refused(
                self, "pulley_width", "stands instead of masses and inertias of the pulleys; give one of them"
            )
        return self

    def load_at_shaft(self, motion: MotionProfile, environment: Environment, sheet: Sheet) -> Load:
        """Load cycle at the drive pulley: inertia, forces, torques; checks of the belt."""
        motion = self.refined(motion)
        axis = self._axis(sheet)
        cycle = axis.cycle(motion, environment)
        record_axis(axis, sheet, motion, cycle, environment)
        self._check_belt(axis, motion, environment, sheet)
        results = {
            "pulley_speed": shaft_speed(motion.max_speed, axis.constant),
            "load_inertia_at_pulley": cycle.inertia,
        }
        return Load(
            cycle=cycle,
            statics=axis.statics(motion, environment),
            opposite=axis.opposite(motion, environment),
            states=axis.states(motion, environment),
            results=results,
        )

    def transmission(self, payload: float, environment: Environment) -> LinearTransmission:
        """The pulley as a transmission whose diameter can be chosen; solid pulleys of a given width grow with it."""
        found = self._axis(Sheet()).transmission(payload, environment)
        if self.pulley_width is None:
            return found
        each = float(pulley_inertia_coefficient(1.0, self.pulley_density, self.pulley_width))
        front, rear = (0.0, 2 * each) if self.efficiency_covers == "load_side" else (each, each)
        return replace(found, front_inertia=0.0, rear_inertia=0.0, front_pulleys=front, rear_pulleys=rear)

    def _axis(self, sheet: Sheet) -> LinearAxis:
        """The axis in SI, with its geometry written to ``sheet``."""
        with sheet.section("Belt and pulleys"):
            d = self.pulley_diameter
            if self.pulley_teeth is not None and self.belt_pitch is not None:
                d = sheet(pulley_pitch_diameter, key="pulley_diameter", z=self.pulley_teeth, p=self.belt_pitch)
            assert d is not None
            radius = sheet(pulley_transmission, key="transmission_constant", d=d)
            sheet(travel_per_revolution, key="travel_per_pulley_revolution", R=radius,
                  label="Travel per revolution of the drive pulley")  # fmt: skip
            belt = 0.0
            if self.belt_mass_per_length and self.belt_length:
                belt = sheet(belt_mass, q=self.belt_mass_per_length, L=self.belt_length)
            drive, idler = self._pulleys(sheet, d)
        whole = self.efficiency_covers == "load_side"
        if whole:
            sheet.decide("The efficiency acts on the whole load side", "chosen: drive pulley included")
        return LinearAxis(
            body=self,
            words=AxisWords("peripheral_force", "Peripheral force at the drive pulley", "pulley"),
            constant=radius,
            efficiency=self.efficiency,
            added_mass=belt,
            front_inertia=0.0 if whole else drive,
            rear_inertia=idler + drive if whole else idler,
            driven_inertia=idler,
        )

    def _pulleys(self, sheet: Sheet, d: float) -> tuple[float, float]:
        """Inertia of drive pulley and idlers [kg m2]."""
        if self.pulley_width is not None:
            each = sheet(solid_pulley_inertia, key="pulley_inertia", d=d, b=self.pulley_width, rho=self.pulley_density)
            return each, each
        drive, idler = self.drive_pulley_inertia, self.idler_inertia
        if self.drive_pulley_mass is not None:
            label = "Inertia of the drive pulley, a solid disc"
            m = self.drive_pulley_mass
            drive = sheet(solid_cylinder_inertia, key="drive_pulley_inertia", symbol="J_t", label=label, m=m, D=d)
        if self.idler_mass is not None:
            label = "Inertia of the idlers, solid discs"
            idler = sheet(
                solid_cylinder_inertia, key="idler_inertia", symbol="J_u", label=label, m=self.idler_mass, D=d
            )
        for key, value, text in (
            ("drive_pulley_inertia_kgcm2", drive, "Inertia of the drive pulley"),
            ("idler_inertia_kgcm2", idler, "Inertia of the idlers"),
        ):
            if value is None:
                sheet.assume(f"mechanism.{key}", text, value=0.0, unit="kg cm2", source="left out until given")
        return drive or 0.0, idler or 0.0

    def _check_belt(self, axis: LinearAxis, motion: MotionProfile, environment: Environment, sheet: Sheet) -> None:
        peripheral = axis.largest_force(motion, environment)
        with sheet.section("Belt under load"):
            sheet.check(
                "peripheral_force", "Peripheral force of the teeth in mesh", peripheral,
                self.permitted_peripheral_force, "N", "permitted force of the maker, given with the axis",
                missing="" if self.permitted_peripheral_force else "permitted peripheral force",
            )  # fmt: skip
            if self.pretension == 0:
                sheet.decide("No slack strand to keep taut", "only hanging masses tension the belt")
            else:
                sheet.check(
                    "belt_pretension", "Pretension keeps the slack strand taut", peripheral, self.pretension, "N",
                    "derived: a short strand beside the slide loses the whole peripheral force",
                    missing="" if self.pretension is not None else "pretension of the belt",
                )  # fmt: skip
            strand = None
            if self.pretension is not None:
                strand = self._record_strands(axis, motion, environment, sheet, self.pretension)
            limits = (("pretension", self.pretension), ("permitted strand force", self.permitted_strand_force))
            sheet.check(
                "strand_force", "Force in the strand", strand, self.permitted_strand_force, "N",
                "permitted force of the maker, given with the axis",
                missing=", ".join(name for name, value in limits if value is None),
            )  # fmt: skip

    def _record_strands(
        self, axis: LinearAxis, motion: MotionProfile, environment: Environment, sheet: Sheet, pretension: float
    ) -> float:
        """Largest force in a strand over the cycle, in both directions of an inclined axis."""
        hanging, worst = self.counterweight_mass or 0.0, (-1.0, 0.0, 0.0)
        for run in [motion, motion.mirrored()] if self.inclined else [motion]:
            # the belt carries what the counterweight weighs, less what its own fall or lift takes
            counter = hanging * environment.gravity - acceleration_force(hanging, run.acceleration)
            slide = axis.force(run, environment.gravity) + counter
            pulls = np.maximum(np.abs(slide), np.abs(counter))
            k = int(pulls.argmax())
            worst = max(worst, (float(pulls[k]), float(slide[k]), float(np.broadcast_to(counter, slide.shape)[k])))
        return sheet(largest_strand_force, key="largest_strand_force", F_V=pretension, F_C=worst[1], F_Z=worst[2])
