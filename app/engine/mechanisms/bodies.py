"""Bodies that turn about an axis: what a turntable, a drum or an arm is put together from."""

from abc import abstractmethod
from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from app.engine.formulas.inertia import (
    cuboid_inertia,
    hollow_cylinder_inertia,
    parallel_axis_inertia,
    point_mass_inertia,
    solid_cylinder_inertia,
    sum_of_inertias,
)
from app.engine.mechanisms.guided_axis import refused
from app.engine.quantity import Declared, Quantity
from app.engine.sheet import Sheet


class Body(Declared):
    """One body that turns with the load."""

    @property
    def total_mass(self) -> float:
        """What the bearings carry of it [kg]."""
        return 0.0

    @abstractmethod
    def record_inertia(self, sheet: Sheet, key: str, label: str) -> float:
        """Inertia about the axis of rotation [kg m2], written to ``sheet`` under ``key``."""


class MassiveBody(Body):
    """A body with an extension of its own, beside the axis or on it."""

    mass: Annotated[float, Quantity("kg", symbol="m", gt=0, le=1e7, about="mass of the body")]
    offset: Annotated[
        float,
        Quantity(
            "mm", symbol="r", ge=0, le=100, default=0.0, source="on the axis of rotation",
            about="distance of the body's own centre from the axis of rotation",
        ),
    ]  # fmt: skip

    @property
    def total_mass(self) -> float:
        """What the bearings carry of it [kg]."""
        return self.mass

    def record_inertia(self, sheet: Sheet, key: str, label: str) -> float:
        """Own inertia, moved to the axis of rotation where the body stands beside it (Steiner)."""
        if self.offset == 0:
            return self._record_own(sheet, key, label)
        own = self._record_own(sheet, f"{key}_own", f"{label}, about its own centre")
        return sheet(parallel_axis_inertia, key=key, label=label, J_c=own, m=self.mass, r=self.offset)

    @abstractmethod
    def _record_own(self, sheet: Sheet, key: str, label: str) -> float: ...


class Cylinder(MassiveBody):
    """A disc or solid cylinder that turns about its own axis or one parallel to it."""

    title = "Disc or solid cylinder"

    shape: Literal["cylinder"] = "cylinder"
    diameter: Annotated[float, Quantity("mm", symbol="D", gt=0, le=100, about="diameter")]

    def _record_own(self, sheet: Sheet, key: str, label: str) -> float:
        return sheet(solid_cylinder_inertia, key=key, label=label, m=self.mass, D=self.diameter)


class HollowCylinder(MassiveBody):
    """A ring or tube."""

    title = "Ring or hollow cylinder"

    shape: Literal["hollow_cylinder"] = "hollow_cylinder"
    diameter: Annotated[float, Quantity("mm", symbol="D", gt=0, le=100, about="outer diameter")]
    inner_diameter: Annotated[float, Quantity("mm", symbol="D_i", ge=0, le=100, about="inner diameter")]

    @model_validator(mode="after")
    def _a_wall_between_the_diameters(self) -> Self:
        if self.inner_diameter >= self.diameter:
            raise refused(self, "inner_diameter", "must be smaller than the outer diameter")
        return self

    def _record_own(self, sheet: Sheet, key: str, label: str) -> float:
        D, D_i = self.diameter, self.inner_diameter
        return sheet(hollow_cylinder_inertia, key=key, label=label, m=self.mass, D=D, D_i=D_i)


class Cuboid(MassiveBody):
    """A box or plate whose height stands along the axis."""

    title = "Box or plate"

    shape: Literal["cuboid"] = "cuboid"
    width: Annotated[float, Quantity("mm", symbol="b", gt=0, le=100, about="width in the plane of rotation")]
    length: Annotated[float, Quantity("mm", symbol="l", gt=0, le=100, about="length in the plane of rotation")]

    def _record_own(self, sheet: Sheet, key: str, label: str) -> float:
        return sheet(cuboid_inertia, key=key, label=label, m=self.mass, b=self.width, l=self.length)


class PointMass(Body):
    """A body that is small against its distance from the axis."""

    title = "Point mass"

    shape: Literal["point"] = "point"
    mass: Annotated[float, Quantity("kg", symbol="m", gt=0, le=1e7, about="mass of the body")]
    radius: Annotated[float, Quantity("mm", symbol="r", ge=0, le=100, about="distance from the axis of rotation")]

    @property
    def total_mass(self) -> float:
        """What the bearings carry of it [kg]."""
        return self.mass

    def record_inertia(self, sheet: Sheet, key: str, label: str) -> float:
        """Mass times radius squared."""
        return sheet(point_mass_inertia, key=key, label=label, m=self.mass, r=self.radius)


class GivenInertia(Body):
    """A body whose inertia about the axis of rotation is known."""

    title = "Known inertia"

    shape: Literal["given"] = "given"
    inertia: Annotated[float, Quantity("kg m2", symbol="J", ge=0, le=1e7, about="inertia about the axis of rotation")]

    def record_inertia(self, sheet: Sheet, key: str, label: str) -> float:
        """The inertia as given."""
        return sheet(sum_of_inertias, key=key, label=label, J_k=[self.inertia])


AnyBody = Annotated[Cylinder | HollowCylinder | Cuboid | PointMass | GivenInertia, Field(discriminator="shape")]
