"""Revisions of saved projects."""

from datetime import datetime
from typing import Any

from sqlalchemy import JSON, ForeignKey, String, UniqueConstraint
from sqlalchemy.orm import Mapped, mapped_column

from app.db.base import Base, UtcDateTime


class ProjectRevision(Base):
    """One saved state of a project, never changed afterwards."""

    __tablename__ = "project_revision"
    __table_args__ = (UniqueConstraint("project_id", "number"),)

    id: Mapped[int] = mapped_column(primary_key=True)
    project_id: Mapped[int] = mapped_column(ForeignKey("project.id", ondelete="CASCADE"))
    number: Mapped[int] = mapped_column(comment="1 for the first save, counted within the project")
    document: Mapped[Any] = mapped_column(JSON, comment="The whole project as it is exported")
    engine_version: Mapped[str] = mapped_column(String(40), comment="Version that calculated the stored results")
    catalogue_editions: Mapped[Any] = mapped_column(JSON, comment="Editions in use: key and checksum of each")
    comment: Mapped[str | None] = mapped_column(String(500), comment="What the user wrote about the save")
    created_at: Mapped[datetime] = mapped_column(UtcDateTime)
