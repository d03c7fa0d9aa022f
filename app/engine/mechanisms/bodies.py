"""Bodies that turn about an axis: what a turntable, a drum or an arm is put together from."""

from abc import abstractmethod
from collections.abc import Iterator
from typing import Annotated, Any, ClassVar, Literal, Self

from pydantic import Field, model_validator

from app.engine.formula import Formula
from app.engine.formulas.inertia import (
    cuboid_inertia,
    disc_about_diameter_inertia,
    hollow_cylinder_inertia,
    parallel_axis_inertia,
    point_mass_inertia,
    referred_inertia,
    rod_inertia,
    solid_cylinder_inertia,
    sphere_inertia,
    spherical_shell_inertia,
    sum_of_inertias,
)
from app.engine.mechanisms.guided_axis import refused
from app.engine.quantity import Declaration, Declared, Quantity
from app.engine.sheet import Sheet


class Body(Declared):
    """One body that turns with the load, on its axis or geared to it."""

    shown_last = frozenset({"ratio"})

    ratio: Annotated[
        float,
        Quantity(
            "1", symbol="i_b", gt=0, le=1e4, default=1.0, source="on the axis itself",
            about="speed of the axis over speed of the body, where gear wheels or a belt lie between them",
        ),
    ]  # fmt: skip

    def defaults_taken(self) -> Iterator[tuple[str, Declaration, Any]]:
        """As for every input model; that a body sits on the axis itself needs no confirmation."""
        yield from (found for found in super().defaults_taken() if found[0] != "ratio")

    @property
    def total_mass(self) -> float:
        """What the bearings of the axis carry of it [kg]."""
        return self._own_mass if self.ratio == 1 else 0.0

    @property
    def _own_mass(self) -> float:
        return 0.0

    def record_inertia(self, sheet: Sheet, key: str, label: str) -> float:
        """Inertia referred to the axis of rotation [kg m2], written to ``sheet`` under ``key``."""
        if self.ratio == 1:
            return self._record_about_axis(sheet, key, label)
        own = self._record_about_axis(sheet, f"{key}_own_speed", f"{label}, on its own shaft")
        return sheet(referred_inertia, key=key, label=label, J=own, i=self.ratio)

    @abstractmethod
    def _record_about_axis(self, sheet: Sheet, key: str, label: str) -> float:
        """Inertia about the axis that the body turns about [kg m2]."""


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
    def _own_mass(self) -> float:
        return self.mass

    def _record_about_axis(self, sheet: Sheet, key: str, label: str) -> float:
        # own inertia, moved to the axis of rotation where the body stands beside it (Steiner)
        if self.offset == 0:
            return self._record_own(sheet, key, label)
        own = self._record_own(sheet, f"{key}_own", f"{label}, about its own centre")
        return sheet(parallel_axis_inertia, key=key, label=label, J_c=own, m=self.mass, r=self.offset)

    @abstractmethod
    def _record_own(self, sheet: Sheet, key: str, label: str) -> float: ...


class RoundBody(MassiveBody):
    """A body that its mass and diameter describe."""

    law: ClassVar[Formula[..., Any]]
    """Inertia about its own centre from mass and diameter."""

    diameter: Annotated[float, Quantity("mm", symbol="D", gt=0, le=100, about="diameter")]

    def _record_own(self, sheet: Sheet, key: str, label: str) -> float:
        return sheet(self.law, key=key, label=label, m=self.mass, D=self.diameter)


class Cylinder(RoundBody):
    """A disc or solid cylinder that turns about its own axis or one parallel to it."""

    title = "Disc or solid cylinder"
    law = solid_cylinder_inertia

    shape: Literal["cylinder"] = "cylinder"


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


class UprightDisc(RoundBody):
    """A thin disc whose plane holds the axis of rotation."""

    title = "Thin disc about its diameter"
    law = disc_about_diameter_inertia

    shape: Literal["upright_disc"] = "upright_disc"


class Sphere(RoundBody):
    """A solid ball."""

    title = "Solid sphere"
    law = sphere_inertia

    shape: Literal["sphere"] = "sphere"


class SphericalShell(RoundBody):
    """A thin hollow ball; its diameter is the mean one of the shell."""

    title = "Thin spherical shell"
    law = spherical_shell_inertia

    shape: Literal["spherical_shell"] = "spherical_shell"


class Rod(MassiveBody):
    """A thin rod or arm across the axis of rotation."""

    title = "Thin rod across the axis"

    shape: Literal["rod"] = "rod"
    length: Annotated[float, Quantity("mm", symbol="l", gt=0, le=100, about="length of the rod")]

    def _record_own(self, sheet: Sheet, key: str, label: str) -> float:
        return sheet(rod_inertia, key=key, label=label, m=self.mass, l=self.length)


class PointMass(Body):
    """A body that is small against its distance from the axis."""

    title = "Point mass"

    shape: Literal["point"] = "point"
    mass: Annotated[float, Quantity("kg", symbol="m", gt=0, le=1e7, about="mass of the body")]
    radius: Annotated[float, Quantity("mm", symbol="r", ge=0, le=100, about="distance from the axis of rotation")]

    @property
    def _own_mass(self) -> float:
        return self.mass

    def _record_about_axis(self, sheet: Sheet, key: str, label: str) -> float:
        return sheet(point_mass_inertia, key=key, label=label, m=self.mass, r=self.radius)


class GivenInertia(Body):
    """A body whose inertia about the axis of rotation is known."""

    title = "Known inertia"

    shape: Literal["given"] = "given"
    inertia: Annotated[float, Quantity("kg m2", symbol="J", ge=0, le=1e7, about="inertia about the axis of rotation")]

    def _record_about_axis(self, sheet: Sheet, key: str, label: str) -> float:
        return sheet(sum_of_inertias, key=key, label=label, J_k=[self.inertia])


AnyBody = Annotated[
    Cylinder | HollowCylinder | Cuboid | UprightDisc | Sphere | SphericalShell | Rod | PointMass | GivenInertia,
    Field(discriminator="shape"),
]
