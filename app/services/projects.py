"""Projects: saved under unguessable links, one to edit and one to view; every save is a revision."""

import base64
import hashlib
import secrets
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Any

from app.db.models import Project, ProjectRevision
from app.db.repositories.projects import NewRevision, ProjectRepository, RevisionLine
from app.services.documents import Difference, differences, read_document
from app.services.errors import ConflictError, FieldError, ForbiddenError, InvalidInputError, NotFoundError
from app.services.version import ENGINE_VERSION

MAX_COMMENT = 500


def new_edit_token() -> str:
    """A token of 192 random bits."""
    return secrets.token_urlsafe(24)


def view_token_of(edit_token: str) -> str:
    """The token that may only look, derived one way: who can edit can always hand out the link to view."""
    digest = hashlib.sha256(b"drivewright view " + edit_token.encode()).digest()[:24]
    return base64.urlsafe_b64encode(digest).decode()


def token_hash(token: str) -> str:
    """What the database keeps of a token."""
    return hashlib.sha256(token.encode()).hexdigest()


@dataclass(frozen=True, kw_only=True)
class ProjectState:
    """A project at one of its revisions, as one link shows it."""

    title: str
    version: int
    """Number of this revision."""
    newest_version: int
    document: dict[str, Any]
    can_edit: bool
    created_at: datetime
    """When the project was created"""
    saved_at: datetime
    """When this revision was saved"""
    comment: str | None
    engine_version: str
    catalogue_editions: Any
    view_token: str
    """Opens the project for viewing; known to whoever edits, and the link itself for whoever views."""


@dataclass(frozen=True)
class OpenedProject:
    """A new project with the only sight of its edit token."""

    state: ProjectState
    edit_token: str
    view_token: str


class ProjectService:
    """Creates, opens, saves, compares and restores projects; ``editions`` says which catalogue editions are loaded."""

    def __init__(
        self,
        projects: ProjectRepository,
        editions: Callable[[], Sequence[dict[str, str]]],
        now: Callable[[], datetime] = lambda: datetime.now(UTC),
    ) -> None:
        self._projects = projects
        self._editions = editions
        self._now = now

    def create(self, raw: Any, comment: str | None = None) -> OpenedProject:
        """Save a new project; also the way to import an exported one. Raises InvalidInputError."""
        document = read_document(raw)
        self._projects.begin_writing()
        edit = new_edit_token()
        view = view_token_of(edit)
        revision = self._revision(document, comment)
        project = self._projects.add(token_hash(edit), token_hash(view), revision)
        return OpenedProject(self._state(project, self._stored(project, 1), edit), edit, view)

    def open(self, token: str, number: int | None = None) -> ProjectState:
        """The project behind a link, at its newest or at an older revision. Raises NotFoundError."""
        project, _ = self._find(token)
        return self._state(project, self._stored(project, number or project.version), token)

    def save(self, token: str, raw: Any, version: int, comment: str | None = None) -> ProjectState:
        """Save the next revision; ``version`` is the one that was edited.

        Raises InvalidInputError, NotFoundError, ForbiddenError (a link to view) and ConflictError (saved since).
        """
        document = read_document(raw)
        self._projects.begin_writing()
        project = self._editable(token)
        return self._save(project, token, document, version, comment)

    def restore(self, token: str, number: int, version: int) -> ProjectState:
        """Make an older revision the newest one again, as a save of its own. Raises as ``save`` does."""
        self._projects.begin_writing()
        project = self._editable(token)
        old = self._stored(project, number)
        return self._save(project, token, old.document, version, f"Revision {number} restored")

    def duplicate(self, token: str) -> OpenedProject:
        """A new project with the newest revision of another one, which a link to view may copy too."""
        self._projects.begin_writing()
        project, _ = self._find(token)
        document = dict(self._stored(project, project.version).document)
        document["title"] = f"{document['title'][:190]} (copy)"
        edit = new_edit_token()
        view = view_token_of(edit)
        made = self._projects.add(token_hash(edit), token_hash(view), self._revision(document, None))
        return OpenedProject(self._state(made, self._stored(made, 1), edit), edit, view)

    def delete(self, token: str, version: int) -> None:
        """Close a project; no link opens it any more. Raises NotFoundError, ForbiddenError and ConflictError."""
        self._projects.begin_writing()
        project = self._editable(token)
        if project.version != version:
            raise _conflict(project)
        self._projects.delete(project, self._now())

    def revisions(self, token: str, limit: int = 50, offset: int = 0) -> tuple[Sequence[RevisionLine], int]:
        """Revisions from the newest on, and how many there are."""
        project, _ = self._find(token)
        return self._projects.revisions(project, limit, offset)

    def compare(self, token: str, first: int, second: int) -> list[Difference]:
        """Every value that differs between two revisions."""
        project, _ = self._find(token)
        before, after = (self._stored(project, number).document for number in (first, second))
        return list(differences(before, after))

    def export(self, token: str) -> dict[str, Any]:
        """The project as one JSON object that ``create`` takes back; it holds no token."""
        return self.open(token).document

    def _find(self, token: str) -> tuple[Project, bool]:
        found = self._projects.find(token_hash(token))
        if found is None:
            raise NotFoundError("No project opens with this link. It may have been deleted, or the link is incomplete.")
        return found[0], found[1] == "edit"

    def _editable(self, token: str) -> Project:
        project, can_edit = self._find(token)
        if not can_edit:
            raise ForbiddenError("This link shows the project but does not change it. Duplicate it to go on from here.")
        return project

    def _stored(self, project: Project, number: int) -> ProjectRevision:
        found = self._projects.revision(project, number)
        if found is None:
            raise NotFoundError(f"The project has no revision {number}; the newest one is {project.version}.")
        return found

    def _save(self, project: Project, token: str, document: Any, version: int, comment: str | None) -> ProjectState:
        if not self._projects.save(project, version, self._revision(document, comment)):
            raise _conflict(project)
        return self._state(project, self._stored(project, project.version), token)

    def _revision(self, document: dict[str, Any], comment: str | None) -> NewRevision:
        if comment is not None and len(comment) > MAX_COMMENT:
            text = f"must have at most {MAX_COMMENT} characters"
            raise InvalidInputError([FieldError(("comment",), text, comment)])
        return NewRevision(
            document=document,
            title=document["title"],
            engine_version=ENGINE_VERSION,
            catalogue_editions=list(self._editions()),
            comment=comment or None,
            created_at=self._now(),
        )

    @staticmethod
    def _state(project: Project, revision: ProjectRevision, token: str) -> ProjectState:
        can_edit = project.edit_token_hash == token_hash(token)
        return ProjectState(
            title=revision.document["title"],
            version=revision.number,
            newest_version=project.version,
            document=revision.document,
            can_edit=can_edit,
            created_at=project.created_at,
            saved_at=revision.created_at,
            comment=revision.comment,
            engine_version=revision.engine_version,
            catalogue_editions=revision.catalogue_editions,
            view_token=view_token_of(token) if can_edit else token,
        )


def _conflict(project: Project) -> ConflictError:
    return ConflictError(
        f"Someone else saved the project in the meantime: version {project.version} is the newest. "
        "Open it, compare, and save again.",
        current=project.version,
    )
