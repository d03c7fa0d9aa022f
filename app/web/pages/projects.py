"""Saved projects: opened by a link to edit or to view; saved, compared, restored, copied, exported, imported."""

import json
from dataclasses import dataclass, replace
from typing import Annotated, Any

from fastapi import APIRouter, Depends, Path, Query, Request, Response
from fastapi.responses import RedirectResponse
from markupsafe import Markup

from app.db.repositories.projects import RevisionLine
from app.services.documents import Difference
from app.services.errors import ConflictError, FieldError, InvalidInputError, NotFoundError
from app.services.mechanisms import MechanismKind, mechanism_kind
from app.services.projects import ProjectState
from app.services.reading import parse_json
from app.web.alternatives import Wanted
from app.web.deps import LARGEST_VERSION, Examples, Projects, Selections, Sizings
from app.web.drawings import drawing_of
from app.web.form_data import flat
from app.web.pages.workbench import report_of, searching, wants_signs, workbench_page
from app.web.project_views import ProjectView, axis_errors, project_view, unused_name, with_axis
from app.web.submission import Submission, Submitted
from app.web.templating import page, translator
from app.web.workbench import Axis, axis_of

router = APIRouter()
CONFLICT = 412
SHOWN_REVISIONS = 200
Token = Annotated[str, Path(min_length=1, max_length=100)]
Number = Annotated[int | None, Query(ge=1, le=LARGEST_VERSION)]


@dataclass(frozen=True)
class Calculating:
    """The services that a workbench needs."""

    sizings: Sizings
    selections: Selections
    examples: Examples


Services = Annotated[Calculating, Depends()]


@dataclass(frozen=True)
class ViewPage:
    """Context of ``projects/view.html``: the project as a link to view shows it."""

    mechanism: MechanismKind
    drawing: Markup
    axis: Axis
    project: ProjectView
    inputs: tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class RevisionsPage:
    """Context of ``projects/revisions.html``."""

    project: ProjectView
    revisions: tuple[RevisionLine, ...]
    older: int
    newer: int
    differences: tuple[Difference, ...] | None


@dataclass(frozen=True)
class SettingsPage:
    """Context of ``projects/settings.html``."""

    project: ProjectView
    errors: tuple[FieldError, ...] = ()
    title: str = ""


@router.get("/p/{token}")
def open_project(
    request: Request,
    token: Token,
    projects: Projects,
    services: Services,
    axis: Annotated[int, Query(ge=0, le=1000)] = 0,
    revision: Number = None,
    saved: Annotated[str, Query(max_length=10)] = "",
) -> Response:
    """An axis of a project: in the workbench for a link to edit, as a page without entries for a link to view."""
    state = projects.open(token, revision)
    axes = state.document["axes"]
    if not axes:
        return RedirectResponse(f"/p/{token}/settings", 303)
    index = min(axis, len(axes) - 1)
    raw = axes[index]["request"]
    view = project_view(request, token, state, index, saved if saved in ("new", "saved") else "")
    return _shown(request, view, raw, services)


def _shown(request: Request, view: ProjectView, raw: dict[str, Any], services: Services) -> Response:
    mechanism = mechanism_kind(str(raw["mechanism"]["kind"]))
    search = searching(request, Wanted(), services.selections)
    axis = axis_of(mechanism, raw, services.sizings, translator(request), alternatives=search)
    if view.can_edit and not view.is_old:
        return workbench_page(request, mechanism, axis, services.examples, view, view.url)
    inputs = tuple((name, value) for name, value in flat(raw) if not name.endswith("._row"))
    return page(request, "projects/view.html", ViewPage(mechanism, drawing_of(mechanism.drawing), axis, view, inputs))


@router.get("/p/{token}/new/{kind}")
def begin_axis(request: Request, token: Token, kind: str, projects: Projects, services: Services) -> Response:
    """The workbench for an axis that the project does not have yet."""
    state, mechanism = projects.open(token), mechanism_kind(kind)
    view = project_view(request, token, state, len(state.document["axes"]))
    axis = axis_of(mechanism, {}, services.sizings, translator(request))
    return workbench_page(request, mechanism, axis, services.examples, view, view.url)


@router.post("/p/{token}")
def submit_axis(request: Request, token: Token, form: Submitted, projects: Projects, services: Services) -> Response:
    """Calculate, change the form, or save the next revision. What was typed is kept whatever happens."""
    state = projects.open(token)
    index, mechanism = min(form.number("axis"), len(state.document["axes"])), _kind_of(form)
    search = searching(request, Wanted.of(form.lists), services.selections)
    axis = axis_of(
        mechanism,
        form.raw,
        services.sizings,
        translator(request),
        demanded=form.action != "update",
        alternatives=search,
        four_quadrants=wants_signs(form),
    )
    view = project_view(request, token, state, index)
    if form.action == "report" and axis.result.sizing is not None:
        return report_of(axis, translator(request))
    if form.action != "save" or axis.refused:
        # the version that was edited stays in the form, so that saving later still notices a save in between
        view = replace(view, newest_version=form.version, version=form.version)
        return workbench_page(request, mechanism, axis, services.examples, view, view.url)
    return _saved(request, token, form, axis, view, projects, services)


def _saved(
    request: Request,
    token: str,
    form: Submission,
    axis: Axis,
    view: ProjectView,
    projects: Projects,
    services: Services,
) -> Response:
    """Save, or say why not beside everything as typed."""
    mechanism, index = _kind_of(form), view.axis
    document = with_axis(projects.open(token).document, index, axis.raw, mechanism)
    try:
        projects.save(token, document, form.version, form.steering.get("comment") or None)
    except ConflictError:
        newest = replace(view, notice="conflict")
        response = workbench_page(request, mechanism, axis, services.examples, newest, view.url)
        response.status_code = CONFLICT
        return response
    except InvalidInputError as error:
        refused = axis_of(mechanism, form.raw, services.sizings, translator(request), demanded=True,
                          further=axis_errors(error))  # fmt: skip
        return workbench_page(request, mechanism, refused, services.examples, view, view.url)
    return RedirectResponse(f"/p/{token}?axis={index}&saved=saved", 303)


def _kind_of(form: Submission) -> MechanismKind:
    mechanism = form.raw.get("mechanism")
    return mechanism_kind(str(mechanism.get("kind", "")) if isinstance(mechanism, dict) else "")


@router.get("/p/{token}/revisions")
def show_revisions(
    request: Request,
    token: Token,
    projects: Projects,
    older: Annotated[int, Query(alias="from", ge=0, le=LARGEST_VERSION)] = 0,
    newer: Annotated[int, Query(alias="to", ge=0, le=LARGEST_VERSION)] = 0,
) -> Response:
    """Every save, and on request what two of them do not share."""
    state = projects.open(token)
    lines, _ = projects.revisions(token, SHOWN_REVISIONS)
    found = tuple(projects.compare(token, older, newer)) if older and newer else None
    first = older or max(1, state.newest_version - 1)
    view = project_view(request, token, state, 0)
    return page(
        request, "projects/revisions.html", RevisionsPage(view, tuple(lines), first, newer or state.version, found)
    )


@router.post("/p/{token}/restore")
def restore_revision(token: Token, form: Submitted, projects: Projects) -> Response:
    """Make an older revision the newest one."""
    projects.restore(token, form.number("revision"), form.version)
    return RedirectResponse(f"/p/{token}?saved=saved", 303)


@router.get("/p/{token}/export")
def export_project(token: Token, projects: Projects) -> Response:
    """The project as a file that can be imported again; it holds no link."""
    text = json.dumps(projects.export(token), ensure_ascii=False, indent=1)
    name = {"Content-Disposition": 'attachment; filename="drivewright-project.json"'}
    return Response(text, media_type="application/json", headers=name)


@router.get("/p/{token}/settings")
def show_settings(request: Request, token: Token, projects: Projects) -> Response:
    """Title, axes, copies."""
    view = project_view(request, token, projects.open(token), 0)
    return page(request, "projects/settings.html", SettingsPage(view, title=view.title))


@router.post("/p/{token}/settings")
def change_settings(request: Request, token: Token, form: Submitted, projects: Projects) -> Response:
    """Rename, copy or delete an axis or the project."""
    if form.action == "copy":
        return RedirectResponse(f"/p/{projects.duplicate(token).edit_token}?saved=new", 303)
    if form.action == "delete":
        projects.delete(token, form.version)
        return RedirectResponse("/", 303)
    state = projects.open(token)
    try:
        projects.save(token, changed(state, form), form.version)
    except InvalidInputError as error:
        view = project_view(request, token, state, 0)
        context = SettingsPage(view, tuple(error.errors), form.steering.get("title", ""))
        return page(request, "projects/settings.html", context, 422)
    return RedirectResponse(f"/p/{token}/settings", 303)


def changed(state: ProjectState, form: Submission) -> dict[str, Any]:
    """The document with the title and the names of the form, and one axis copied or removed where that was asked."""
    title = form.steering.get("title", state.title)
    axes = [
        {**axis, "name": form.steering.get(f"name_{index}", axis["name"])}
        for index, axis in enumerate(state.document["axes"])
    ]
    what, _, place = form.action.partition("-")
    if place.isascii() and place.isdigit() and int(place[:6]) < len(axes):
        chosen = axes[int(place)]
        if what == "remove":
            axes.remove(chosen)
        elif what == "duplicate":
            axes.append({**chosen, "name": unused_name(chosen["name"], [one["name"] for one in axes])})
    return {**state.document, "title": title, "axes": axes}


@router.post("/import")
def import_project(form: Submitted, projects: Projects) -> Response:
    """Make a project of an exported file. A file that is no project is refused with the reason."""
    if not form.files.get("file"):
        raise NotFoundError("No file was chosen.")
    opened = projects.create(parse_json(form.files["file"]))
    return RedirectResponse(f"/p/{opened.edit_token}?saved=new", 303)
