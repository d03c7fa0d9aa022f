"""Saved projects."""

from datetime import datetime

from sqlalchemy import String
from sqlalchemy.orm import Mapped, mapped_column

from app.db.base import Base, UtcDateTime


class Project(Base):
    """One project. It is opened by one of two unguessable links; the database keeps only the hashes of their tokens."""

    __tablename__ = "project"

    id: Mapped[int] = mapped_column(primary_key=True)
    view_token_hash: Mapped[str] = mapped_column(String(64), unique=True, comment="SHA-256 of the token that may read")
    edit_token_hash: Mapped[str] = mapped_column(String(64), unique=True, comment="SHA-256 of the token that may write")
    title: Mapped[str] = mapped_column(String(200), comment="Title as of the newest revision")
    version: Mapped[int] = mapped_column(comment="Number of the newest revision; a save must name it")
    created_at: Mapped[datetime] = mapped_column(UtcDateTime)
    updated_at: Mapped[datetime] = mapped_column(UtcDateTime)
    deleted_at: Mapped[datetime | None] = mapped_column(UtcDateTime, comment="NULL: not deleted")
