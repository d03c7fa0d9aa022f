"""Projects: opened by unguessable links, saved with the version that was edited."""

from typing import Annotated, Any

from fastapi import APIRouter, Path, Query, Response

from app.services.documents import ProjectDocument
from app.services.projects import OpenedProject, ProjectState
from app.web.api.documentation import json_body
from app.web.api.library_models import ComparisonAnswer, NewProjectAnswer, ProjectAnswer, RevisionAnswer
from app.web.api.models import Page
from app.web.deps import LARGEST_VERSION, IfMatch, JsonBody, Limit, Offset, Projects
from app.web.errors import problems

router = APIRouter(prefix="/projects", tags=["projects"])

Token = Annotated[str, Path(min_length=1, max_length=100, description="Token of an edit link or of a view link")]
Number = Annotated[int, Path(ge=1, le=LARGEST_VERSION, description="Number of a revision")]
NumberQuery = Annotated[int, Query(ge=1, le=LARGEST_VERSION, description="Number of a revision")]
Comment = Annotated[str | None, Query(max_length=500, description="What is new in this revision")]

BODY = json_body(ProjectDocument)
READ = problems(404, 422)
WRITE = problems(400, 403, 404, 412, 413, 415, 422, 428)


@router.post("", status_code=201, operation_id="createProject", responses=problems(400, 413, 415, 422),
             openapi_extra=BODY, summary="Save a new project")  # fmt: skip
def create_project(body: JsonBody, projects: Projects, response: Response, comment: Comment = None) -> NewProjectAnswer:
    """Save a new project, or import an exported one. The edit token is told only in this answer."""
    return _opened(projects.create(body, comment), response)


@router.get("/{token}", operation_id="getProject", responses=READ, summary="Open a project")
def get_project(token: Token, projects: Projects, response: Response) -> ProjectAnswer:
    """The newest revision of the project that a link opens; its version stands in the ETag too."""
    return _state(projects.open(token), response)


@router.put("/{token}", operation_id="saveProject", responses=WRITE, openapi_extra=BODY, summary="Save a project")
def save_project(token: Token, version: IfMatch, body: JsonBody, projects: Projects, response: Response,
                 comment: Comment = None) -> ProjectAnswer:  # fmt: skip
    """Save the next revision. If-Match names the version that was edited; another save since is answered with 412."""
    return _state(projects.save(token, body, version, comment), response)


@router.delete("/{token}", status_code=204, operation_id="deleteProject", responses=problems(403, 404, 412, 422, 428),
               summary="Delete a project")  # fmt: skip
def delete_project(token: Token, version: IfMatch, projects: Projects) -> None:
    """Close a project: neither of its links opens it any more."""
    projects.delete(token, version)


@router.get("/{token}/revisions", operation_id="listRevisions", responses=READ, summary="List the revisions")
def list_revisions(token: Token, projects: Projects, limit: Limit = 50, offset: Offset = 0) -> Page[RevisionAnswer]:
    """Every save of the project, newest first."""
    lines, total = projects.revisions(token, limit, offset)
    items = [
        RevisionAnswer(
            number=line.number, saved_at=line.created_at, comment=line.comment, engine_version=line.engine_version
        )
        for line in lines
    ]
    return Page(items=items, total=total, limit=limit, offset=offset)


@router.get("/{token}/revisions/{number}", operation_id="getRevision", responses=READ, summary="Open a revision")
def get_revision(token: Token, number: Number, projects: Projects, response: Response) -> ProjectAnswer:
    """The project as it was saved then."""
    return _state(projects.open(token, number), response)


@router.post("/{token}/revisions/{number}/restore", operation_id="restoreRevision",
             responses=problems(403, 404, 412, 422, 428), summary="Restore a revision")  # fmt: skip
def restore_revision(
    token: Token, number: Number, version: IfMatch, projects: Projects, response: Response
) -> ProjectAnswer:
    """Make an older revision the newest again; nothing in between is lost."""
    return _state(projects.restore(token, number, version), response)


@router.get("/{token}/comparison", operation_id="compareRevisions", responses=READ, summary="Compare two revisions")
def compare_revisions(token: Token, first: NumberQuery, second: NumberQuery, projects: Projects) -> ComparisonAnswer:
    """Every value that differs between two revisions."""
    found = projects.compare(token, first, second)
    return ComparisonAnswer.model_validate({"first": first, "second": second, "differences": found})


@router.post("/{token}/duplicate", status_code=201, operation_id="duplicateProject", responses=READ,
             summary="Duplicate a project")  # fmt: skip
def duplicate_project(token: Token, projects: Projects, response: Response) -> NewProjectAnswer:
    """A new project with the newest revision of this one; a link to view suffices."""
    return _opened(projects.duplicate(token), response)


@router.get("/{token}/export", operation_id="exportProject", responses=READ, summary="Export a project",
            response_model=ProjectDocument)  # fmt: skip
def export_project(token: Token, projects: Projects, response: Response) -> dict[str, Any]:
    """The project as one file that `createProject` takes back, here or elsewhere, now or later."""
    response.headers["Content-Disposition"] = 'attachment; filename="project.drivewright.json"'
    return projects.export(token)


def _state(state: ProjectState, response: Response) -> ProjectAnswer:
    response.headers["ETag"] = f'"{state.version}"'
    response.headers["Cache-Control"] = "no-store"
    return ProjectAnswer.model_validate(state)


def _opened(opened: OpenedProject, response: Response) -> NewProjectAnswer:
    response.headers["ETag"] = f'"{opened.state.version}"'
    response.headers["Cache-Control"] = "no-store"
    shown = ProjectAnswer.model_validate(opened.state)
    return NewProjectAnswer.model_validate({**dict(shown), "edit_token": opened.edit_token})
