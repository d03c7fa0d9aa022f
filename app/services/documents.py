"""The project document: what is saved, exported and imported, as one JSON object with a format and a version.

An axis keeps its request as it was typed. A document of an older version is lifted on reading, so a file exported
once can be imported for ever.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Annotated, Any, Final, Literal

from pydantic import BaseModel, ConfigDict, Field, StringConstraints

from app.services.errors import FieldError, InvalidInputError
from app.services.reading import read
from app.services.requests import read_sizing

FORMAT: Final = "drivewright-project"
VERSION: Final = 1

Title = Annotated[str, StringConstraints(strip_whitespace=True, min_length=1, max_length=200)]


class AxisDocument(BaseModel):
    """One axis of a project."""

    model_config = ConfigDict(extra="forbid")

    name: Title = Field(description="Name of the axis, unique within the project")
    request: dict[str, Any] = Field(description="Sizing request of the axis as it was typed")


class ProjectDocument(BaseModel):
    """A whole project: title and axes."""

    model_config = ConfigDict(extra="forbid")

    format: Literal["drivewright-project"] = FORMAT
    version: Literal[1] = VERSION
    title: Title = Field(description="Title of the project")
    notes: str = Field(default="", max_length=4000, description="Notes for whoever opens the project")
    axes: list[AxisDocument] = Field(max_length=50, description="The axes in the order in which they are shown")


def read_document(raw: Any) -> dict[str, Any]:
    """Check a document and every request in it; returns it in the newest version, requests untouched.

    Raises InvalidInputError with the path of every refused value.
    """
    document = read(ProjectDocument, _lifted(raw))
    errors: list[FieldError] = []
    names: set[str] = set()
    for index, axis in enumerate(document.axes):
        if axis.name in names:
            errors.append(FieldError(("axes", index, "name"), "is the name of another axis already", axis.name))
        names.add(axis.name)
        try:
            read_sizing(axis.request)
        except InvalidInputError as refused:
            errors.extend(refused.within("axes", index, "request").errors)
    if errors:
        raise InvalidInputError(errors)
    return document.model_dump(mode="python")


def _lifted(raw: Any) -> Any:
    """The same document in the newest version of the format."""
    if not isinstance(raw, dict):
        return raw
    found = raw.get("format", FORMAT)
    if found != FORMAT:
        raise InvalidInputError([FieldError(("format",), f"must be {FORMAT!r}: this is no project file", found)])
    version = raw.get("version", VERSION)
    if isinstance(version, int) and version > VERSION:
        text = f"is newer than this program, which reads documents up to version {VERSION}"
        raise InvalidInputError([FieldError(("version",), text, version)])
    return raw


@dataclass(frozen=True)
class Difference:
    """A value that two documents do not share; ``before`` or ``after`` is None where there is nothing."""

    path: tuple[str | int, ...]
    before: Any
    after: Any


def differences(before: Any, after: Any, path: tuple[str | int, ...] = ()) -> Iterator[Difference]:
    """Every place at which two documents differ, in order; axes are told apart by their position.

    >>> [(d.path, d.before, d.after) for d in differences({"a": [1, 2]}, {"a": [1, 3], "b": 0})]
    [(('a', 1), 2, 3), (('b',), None, 0)]
    """
    if isinstance(before, Mapping) and isinstance(after, Mapping):
        for name in [*before, *(name for name in after if name not in before)]:
            yield from differences(before.get(name), after.get(name), (*path, name))
    elif isinstance(before, list) and isinstance(after, list):
        for index in range(max(len(before), len(after))):
            old = before[index] if index < len(before) else None
            new = after[index] if index < len(after) else None
            yield from differences(old, new, (*path, index))
    elif before != after or type(before) is not type(after):
        yield Difference(path, before, after)
