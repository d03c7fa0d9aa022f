"""A project as its pages show it, and the documents that its forms make."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from datetime import datetime
from typing import Any

from fastapi import Request

from app.services.errors import FieldError, InvalidInputError
from app.services.mechanisms import MechanismKind, mechanism_kind, mechanism_kinds
from app.services.projects import ProjectState

MAX_NAME = 200


@dataclass(frozen=True)
class AxisLink:
    """One axis of a project in its list."""

    index: int
    name: str
    mechanism: str
    url: str
    current: bool


@dataclass(frozen=True)
class ProjectView:
    """The project around an axis."""

    token: str
    title: str
    version: int
    newest_version: int
    can_edit: bool
    axes: tuple[AxisLink, ...]
    axis: int
    """Index of the axis that is shown; one beyond the last for an axis that is not saved yet."""
    saved_at: datetime
    comment: str | None
    url: str
    edit_link: str
    """Absolute link that opens the project for editing; empty for whoever may only view."""
    view_link: str
    kinds: tuple[MechanismKind, ...]
    notice: str = ""
    """``new`` after the first save, ``saved`` after a later one."""

    @property
    def is_old(self) -> bool:
        """Whether a newer revision exists."""
        return self.version != self.newest_version


def project_view(request: Request, token: str, state: ProjectState, axis: int, notice: str = "") -> ProjectView:
    """The project around one of its axes."""
    base = str(request.base_url).rstrip("/")
    url = f"/p/{token}"
    shown = "" if state.version == state.newest_version else f"&revision={state.version}"
    return ProjectView(
        token=token, title=state.title, version=state.version, newest_version=state.newest_version,
        can_edit=state.can_edit, axis=axis, saved_at=state.saved_at, comment=state.comment, url=url,
        axes=tuple(
            AxisLink(index, one["name"], _title(one), f"{url}?axis={index}{shown}", index == axis)
            for index, one in enumerate(state.document["axes"])
        ),
        edit_link=f"{base}/p/{token}" if state.can_edit else "", view_link=f"{base}/p/{state.view_token}",
        kinds=tuple(mechanism_kinds()), notice=notice,
    )  # fmt: skip


def _title(axis: dict[str, Any]) -> str:
    return mechanism_kind(str(axis["request"]["mechanism"]["kind"])).title


def new_document(raw: dict[str, Any], mechanism: MechanismKind) -> dict[str, Any]:
    """A project with one axis, both under its name."""
    name = axis_name(raw, mechanism)
    return {"title": name, "axes": [{"name": name, "request": raw}]}


def axis_name(raw: dict[str, Any], mechanism: MechanismKind) -> str:
    """Name of an axis as typed, else that of its mechanism."""
    typed = raw.get("name")
    return typed.strip() if isinstance(typed, str) and typed.strip() else mechanism.title


def with_axis(document: dict[str, Any], index: int, raw: dict[str, Any], mechanism: MechanismKind) -> dict[str, Any]:
    """The document with one axis replaced, or added where ``index`` is behind the last one."""
    axes = list(document["axes"])
    others = [one["name"] for number, one in enumerate(axes) if number != index]
    axis = {"name": axis_name(raw, mechanism), "request": raw}
    if "name" not in raw:
        axis["name"] = axes[index]["name"] if index < len(axes) else unused_name(mechanism.title, others)
    axes[index : index + 1] = [axis]
    return {**document, "axes": axes}


def unused_name(wanted: str, taken: Iterable[str]) -> str:
    """A name like the wanted one that is not taken.

    >>> unused_name("X", ["X", "X (2)"])
    'X (3)'
    """
    names = set(taken)
    numbered = (f"{wanted[: MAX_NAME - 6]} ({number})" for number in range(2, len(names) + 3))
    return wanted if wanted not in names else next(name for name in numbered if name not in names)


def axis_errors(error: InvalidInputError) -> Iterator[FieldError]:
    """Errors of a document as errors of the one axis that is being edited."""
    for one in error.errors:
        path = one.path
        if path[:1] == ("axes",) and len(path) > 2:
            path = path[3:] if path[2] == "request" else path[2:]
        yield FieldError(path, one.message, one.value)
