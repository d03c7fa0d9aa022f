"""What a sizing and a selection are asked with: one declared model for pages, REST, projects, examples and files.

The mechanisms and motions are found, not listed: a new one appears here by itself.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Annotated, Any, Literal, Union

from pydantic import Field, StringConstraints, ValidationError, ValidationInfo, field_validator, model_validator
from pydantic_core import InitErrorDetails, PydanticCustomError

from app.engine.drives import DEFAULT_KIND, drives
from app.engine.drives.base import DriveModel
from app.engine.drives.servo import ServoDriveModel
from app.engine.environment import Environment
from app.engine.mechanisms import mechanisms
from app.engine.mechanisms.base import Mechanism
from app.engine.motion import Motion
from app.engine.optimum import OptimumInput
from app.engine.quantity import Declared, Option, Quantity
from app.services.reading import read

if TYPE_CHECKING:
    AnyMechanism = Mechanism
    AnyDrive = DriveModel
else:
    _KINDS = tuple(mechanisms().values())
    AnyMechanism = Annotated[Union[_KINDS], Field(discriminator="kind")]  # noqa: UP007
    _DRIVES = tuple(drives().values())
    AnyDrive = Annotated[Union[_DRIVES], Field(discriminator="kind")]  # noqa: UP007

Name = Annotated[str, StringConstraints(max_length=200)]


MOTION_WORDS = {"linear": "a linear motion (distances)", "rotary": "a rotary motion (angles or turns)"}


class SizingRequest(Declared):
    """One axis: mechanism, motion, surroundings and drive."""

    name: Annotated[Name, Option(default="", about="name of the axis")]
    notes: Annotated[
        Annotated[str, StringConstraints(max_length=4000)], Option(default="", about="notes for whoever reads this")
    ]
    mechanism: AnyMechanism
    motion: Motion
    environment: Environment = Field(default_factory=lambda: Environment.model_validate({}))
    drive: AnyDrive = Field(default_factory=lambda: ServoDriveModel.model_validate({}))
    optimum: OptimumInput | None = None

    @field_validator("drive", mode="before")
    @classmethod
    def _servo_unless_told(cls, drive: Any) -> Any:
        """A drive that does not say of which kind it is, is a servo drive: the only kind there once was."""
        return {"kind": DEFAULT_KIND, **drive} if isinstance(drive, Mapping) and "kind" not in drive else drive

    @field_validator("motion")
    @classmethod
    def _fits_the_mechanism(cls, motion: Any, info: ValidationInfo) -> Any:
        """A linear mechanism needs a linear motion; data of either kind show theirs when they are solved."""
        mechanism = info.data.get("mechanism")
        if mechanism is None or motion.motion_kind in ("either", mechanism.motion_kind):
            return motion
        problem = PydanticCustomError(
            "motion_kind",
            "describes {given}, but the mechanism ({mechanism}) needs {needed}",
            {
                "given": MOTION_WORDS[motion.motion_kind],
                "needed": MOTION_WORDS[mechanism.motion_kind],
                "mechanism": mechanism.title,
            },
        )
        raise ValidationError.from_exception_data(
            "motion", [InitErrorDetails(type=problem, loc=("kind",), input=motion.kind)]
        )

    @model_validator(mode="after")
    def _optimum_needs_a_servo_drive(self) -> "SizingRequest":
        """The search for the best transmission shares out a peak torque, which only a servo drive has."""
        if self.optimum is not None and not isinstance(self.drive, ServoDriveModel):
            problem = PydanticCustomError("optimum", "is sought for servo drives only")
            raise ValidationError.from_exception_data(
                "optimum", [InitErrorDetails(type=problem, loc=("optimum",), input=None)]
            )
        return self


Texts = Annotated[tuple[Annotated[str, StringConstraints(min_length=1, max_length=120)], ...], Field(max_length=50)]
Ranking = Literal["utilisation", "mass", "rated_torque", "inertia_match"]


class SelectionFilter(Declared):
    """Which catalogue products are admitted; an empty list admits all.

    A product that does not state what a limit asks for (its voltage, say) is not admitted by that limit.
    """

    manufacturers: Annotated[Texts, Option(default=(), about="makers of motors that are admitted", group="Motors")]
    series: Annotated[Texts, Option(default=(), about="series of motors that are admitted", group="Motors")]
    voltage: Annotated[
        float | None,
        Quantity("V", symbol="U", gt=0, le=2000, default=None, about="supply voltage of the motor", group="Motors"),
    ]
    direct: Annotated[bool, Option(default=True, about="admit motors without gear unit", group="Gear units")]
    geared: Annotated[bool, Option(default=True, about="admit motors with gear unit", group="Gear units")]
    gear_manufacturers: Annotated[
        Texts, Option(default=(), about="makers of gear units that are admitted", group="Gear units")
    ]
    gear_series: Annotated[
        Texts, Option(default=(), about="series of gear units that are admitted", group="Gear units")
    ]
    max_ratio: Annotated[
        float | None,
        Quantity("1", symbol="i_max", ge=1, le=1e4, default=None, about="highest ratio", group="Gear units"),
    ]
    max_backlash: Annotated[
        float | None,
        Quantity("arcmin", symbol="phi_max", gt=0, le=1, default=None, about="largest backlash", group="Gear units"),
    ]

    @model_validator(mode="after")
    def _something_is_left(self) -> "SelectionFilter":
        if not self.direct and not self.geared:
            problem = PydanticCustomError("filter", "admit motors with gear unit, without, or both")
            raise ValidationError.from_exception_data(
                "filters", [InitErrorDetails(type=problem, loc=("geared",), input=False)]
            )
        return self


class SelectionRequest(SizingRequest):
    """One axis, and how the candidates for its drive are filtered and ranked.

    A motor or gear unit named under ``drive`` is kept: only the rest is searched.
    """

    filters: SelectionFilter = Field(default_factory=lambda: SelectionFilter.model_validate({}))
    ranking: Annotated[
        Ranking,
        Option(
            default="utilisation",
            about="what the candidates are ranked by",
            labels={
                "utilisation": "best used without failing a check",
                "mass": "least mass",
                "rated_torque": "smallest rated torque",
                "inertia_match": "inertia ratio closest to one",
            },
        ),
    ]
    demand_all_checks: Annotated[
        bool, Option(default=False, about="admit only candidates whose data sheet allows every check")
    ]
    limit: Annotated[int, Option(default=20, ge=1, le=200, about="how many candidates are listed")]
    offset: Annotated[int, Option(default=0, ge=0, le=10_000_000, about="how many candidates are skipped")]


@dataclass(frozen=True)
class Typed:
    """A parsed request beside what was typed: the first is calculated, the second is stored and shown again."""

    request: SizingRequest
    raw: Mapping[str, Any] = field(default_factory=dict)

    @property
    def selection(self) -> SelectionRequest:
        """The request as a selection; TypeError when it is a sizing."""
        if not isinstance(self.request, SelectionRequest):
            raise TypeError("this request asks for a sizing, not for a selection")
        return self.request


def read_sizing(raw: Any) -> Typed:
    """Parse a sizing request; raises InvalidInputError with the path of every refused value."""
    return Typed(read(SizingRequest, raw), raw)


def read_selection(raw: Any) -> Typed:
    """Parse a selection request; raises InvalidInputError with the path of every refused value."""
    return Typed(read(SelectionRequest, raw), raw)
