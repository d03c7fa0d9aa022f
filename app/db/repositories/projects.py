"""Projects and their revisions."""

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime
from typing import Any, Literal

from sqlalchemy import func, or_, select, update
from sqlalchemy.orm import Session

from app.db.models import Project, ProjectRevision
from app.db.session import take_write_lock

Access = Literal["view", "edit"]


@dataclass(frozen=True, kw_only=True)
class NewRevision:
    """What is stored with every save."""

    document: Any
    title: str
    engine_version: str
    catalogue_editions: Any
    comment: str | None
    created_at: datetime


@dataclass(frozen=True)
class RevisionLine:
    """A revision without its document, for lists."""

    number: int
    created_at: datetime
    comment: str | None
    engine_version: str


class ProjectRepository:
    """Reads and writes projects in one session; whoever opened the session commits it."""

    def __init__(self, session: Session) -> None:
        self._session = session

    def begin_writing(self) -> None:
        """Take the lock of a writer; call it before anything is read. Within a transaction it is too late for that."""
        if not self._session.in_transaction():
            take_write_lock(self._session)

    def find(self, token_hash: str) -> tuple[Project, Access] | None:
        """The project that a token opens and what it may do; None for an unknown token or a deleted project."""
        wanted = or_(Project.view_token_hash == token_hash, Project.edit_token_hash == token_hash)
        found = self._session.scalars(select(Project).where(wanted, Project.deleted_at.is_(None))).one_or_none()
        if found is None:
            return None
        return found, "edit" if found.edit_token_hash == token_hash else "view"

    def add(self, edit_token_hash: str, view_token_hash: str, first: NewRevision) -> Project:
        """Store a new project with its first revision."""
        project = Project(
            edit_token_hash=edit_token_hash,
            view_token_hash=view_token_hash,
            title=first.title,
            version=1,
            created_at=first.created_at,
            updated_at=first.created_at,
        )
        self._session.add(project)
        self._session.flush()
        self._add_revision(project, first)
        return project

    def save(self, project: Project, version: int, revision: NewRevision) -> bool:
        """Store the next revision if ``version`` still is the newest one; else store nothing and return False."""
        result = self._session.execute(
            update(Project)
            .where(Project.id == project.id, Project.version == version, Project.deleted_at.is_(None))
            .values(version=version + 1, title=revision.title, updated_at=revision.created_at)
            .execution_options(synchronize_session=False)
        )
        self._session.refresh(project)
        if result.rowcount != 1:  # type: ignore[attr-defined]
            return False
        self._add_revision(project, revision)
        return True

    def delete(self, project: Project, now: datetime) -> None:
        """Close a project: no link opens it any more."""
        project.deleted_at = now
        self._session.flush()

    def _add_revision(self, project: Project, new: NewRevision) -> None:
        self._session.add(
            ProjectRevision(
                project_id=project.id,
                number=project.version,
                document=new.document,
                engine_version=new.engine_version,
                catalogue_editions=new.catalogue_editions,
                comment=new.comment,
                created_at=new.created_at,
            )
        )
        self._session.flush()

    def revision(self, project: Project, number: int) -> ProjectRevision | None:
        """One revision with its document."""
        wanted = select(ProjectRevision).where(
            ProjectRevision.project_id == project.id, ProjectRevision.number == number
        )
        return self._session.scalars(wanted).one_or_none()

    def revisions(self, project: Project, limit: int, offset: int) -> tuple[Sequence[RevisionLine], int]:
        """Revisions from the newest on, without their documents, and how many there are."""
        mine = ProjectRevision.project_id == project.id
        columns = (
            ProjectRevision.number,
            ProjectRevision.created_at,
            ProjectRevision.comment,
            ProjectRevision.engine_version,
        )
        rows = self._session.execute(
            select(*columns).where(mine).order_by(ProjectRevision.number.desc()).limit(limit).offset(offset)
        )
        count = self._session.scalar(select(func.count()).select_from(ProjectRevision).where(mine)) or 0
        return [RevisionLine(*row) for row in rows], count
