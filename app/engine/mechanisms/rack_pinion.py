"""Rack and pinion: the pinion on the drive's shaft rolls on a rack, straight or helical."""

from collections.abc import Iterator
from typing import Annotated, Any, ClassVar, Literal, Self

from pydantic import model_validator

from app.engine.environment import Environment
from app.engine.formulas.conversion import shaft_speed
from app.engine.formulas.rack import (
    pinion_axial_force,
    pinion_pitch_radius,
    pinion_radial_force,
    travel_per_revolution,
)
from app.engine.mechanisms.base import Mechanism
from app.engine.mechanisms.guided_axis import MASSES, GuidedAxis, refused
from app.engine.mechanisms.linear_axis import AxisWords, LinearAxis, record_axis
from app.engine.mechanisms.load import Load
from app.engine.motion.profile import MotionProfile
from app.engine.quantity import Declaration, Option, Quantity
from app.engine.sheet import Sheet
from app.engine.transmission import LinearTransmission

GEOMETRY = "Rack and pinion"
LIMITS = "Limits"
PRESSURE_ANGLE = 0.3490658503988659
"""Normal pressure angle of 20 degrees, usual for racks [rad]"""


class RackPinion(GuidedAxis, Mechanism):
    """A rack-and-pinion axis, horizontal to vertical. The drive's output shaft is the pinion's."""

    title: ClassVar[str] = "Rack and pinion axis"
    summary: ClassVar[str] = "Long travels and large masses: a pinion rolls on a straight or helical rack."
    drawing: ClassVar[str] = "rack_pinion.svg"
    motion_kind: ClassVar[Literal["linear", "rotary"]] = "linear"

    kind: Literal["rack_pinion"] = "rack_pinion"
    moving: Annotated[
        Literal["pinion", "rack"],
        Option(
            default="pinion", group=MASSES, source="usual build of long axes", about="part that travels",
            labels={"pinion": "the pinion, with motor and gear unit", "rack": "the rack; the motor stands"},
        ),
    ]  # fmt: skip
    drive_mass: Annotated[
        float,
        Quantity(
            "kg", symbol="m_2", ge=0, le=1e6, default=0.0, group=MASSES, source="contained in the mass of the slide",
            about="mass of motor and gear unit, where they travel with the pinion",
        ),
    ]  # fmt: skip
    rack_mass: Annotated[
        float,
        Quantity(
            "kg", symbol="m_z", ge=0, le=1e6, default=0.0, group=MASSES, source="contained in the mass of the slide",
            about="mass of the rack, where it travels",
        ),
    ]  # fmt: skip
    module: Annotated[
        float,
        Quantity("mm", symbol="m_n", gt=0, le=0.1, group=GEOMETRY, about="normal module of the teeth"),
    ]
    teeth: Annotated[int, Option(symbol="z", ge=3, le=1000, group=GEOMETRY, about="number of teeth of the pinion")]
    helix_angle: Annotated[
        float,
        Quantity(
            "deg", symbol="beta", ge=0, le=0.7853981633974484, default=0.0, group=GEOMETRY, source="straight teeth",
            about="helix angle of the teeth, 0 for straight teeth",
        ),
    ]  # fmt: skip
    pinion_inertia: Annotated[
        float,
        Quantity(
            "kg cm2", symbol="J_p", ge=0, le=1e3, default=0.0, group=GEOMETRY, source="left out until given",
            about="inertia of the pinion with its shaft",
        ),
    ]  # fmt: skip
    efficiency: Annotated[
        float,
        Quantity(
            "1", symbol="eta", gt=0, le=1, default=0.94, group=GEOMETRY, about="efficiency of the mesh",
            source="SEW 2001, 17.1: toothed wheels with oil lubrication, lower value",
        ),
    ]  # fmt: skip
    permitted_force: Annotated[
        float | None,
        Quantity(
            "N", symbol="F_perm", gt=0, le=1e8, default=None, group=LIMITS,
            about="permitted tangential force of rack and pinion, from the maker",
        ),
    ]  # fmt: skip

    @model_validator(mode="after")
    def _only_what_travels_has_a_moved_mass(self) -> Self:
        if self.moving == "pinion" and self.rack_mass:
            raise refused(self, "rack_mass", "the rack stands, so its mass is not moved; choose which part travels")
        if self.moving == "rack" and self.drive_mass:
            raise refused(self, "drive_mass", "the motor stands, so its mass is not moved; choose which part travels")
        return self

    def defaults_taken(self) -> Iterator[tuple[str, Declaration, Any]]:
        """As in the base, without the mass of what stands."""
        idle = "rack_mass" if self.moving == "pinion" else "drive_mass"
        yield from (found for found in super().defaults_taken() if found[0] != idle)

    @property
    def travelling_mass(self) -> float:
        """Mass of what travels along beside the slide [kg]."""
        return self.drive_mass if self.moving == "pinion" else self.rack_mass

    def slide_side_mass(self, payload: Any) -> Any:
        """Mass on the slide's side [kg], with what travels along."""
        return super().slide_side_mass(payload) + self.travelling_mass

    def weight_mass(self, payload: Any) -> Any:
        """Mass whose weight acts along the axis [kg], with what travels along."""
        return super().weight_mass(payload) + self.travelling_mass

    def guided_mass(self, payload: Any) -> Any:
        """Mass that rests on the guides [kg], with what travels along."""
        return super().guided_mass(payload) + self.travelling_mass

    def load_at_shaft(self, motion: MotionProfile, environment: Environment, sheet: Sheet) -> Load:
        """Load cycle at the pinion's shaft: pitch circle, inertia, forces, torques; check of the tangential force."""
        motion = self.refined(motion)
        with sheet.section("Pinion"):
            z, m_n, beta = self.teeth, self.module, self.helix_angle
            radius = sheet(pinion_pitch_radius, key="pitch_radius", z=z, m_n=m_n, beta=beta)
            sheet(travel_per_revolution, key="travel_per_pinion_revolution", R=radius)
        axis = self._axis(radius)
        cycle = axis.cycle(motion, environment)
        record_axis(axis, sheet, motion, cycle, environment)
        self._record_mesh(sheet, axis.largest_force(motion, environment))
        return Load(
            cycle=cycle,
            statics=axis.statics(motion, environment),
            opposite=axis.opposite(motion, environment),
            states=axis.states(motion, environment),
            results={"pinion_speed": shaft_speed(motion.max_speed, radius), "load_inertia_at_pinion": cycle.inertia},
        )

    def transmission(self, payload: float, environment: Environment) -> LinearTransmission:
        """The pinion as a transmission whose diameter can be chosen; its own inertia is kept as it is."""
        radius = pinion_pitch_radius(self.teeth, self.module, self.helix_angle)
        return self._axis(radius).transmission(payload, environment)

    def _axis(self, radius: float) -> LinearAxis:
        return LinearAxis(
            body=self,
            words=AxisWords("tangential_force", "Tangential force at the pinion", "pinion"),
            constant=radius,
            efficiency=self.efficiency,
            # the pinion sits on the drive's shaft: what accelerates it does not pass the mesh
            front_inertia=self.pinion_inertia,
        )

    def _record_mesh(self, sheet: Sheet, force: float) -> None:
        with sheet.section("Teeth under load"):
            beta = self.helix_angle
            sheet(pinion_radial_force, key="pinion_radial_force", F_t=force, alpha_n=PRESSURE_ANGLE, beta=beta)
            if beta:
                sheet(pinion_axial_force, key="pinion_axial_force", F_t=force, beta=beta)
            sheet.check(
                "tangential_force", "Tangential force of rack and pinion", force, self.permitted_force, "N",
                "permitted force of the maker, given with the axis",
                missing="" if self.permitted_force else "permitted tangential force of rack and pinion",
            )  # fmt: skip
