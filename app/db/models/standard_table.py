"""Tables of standards and handbooks."""

from typing import Any

from sqlalchemy import JSON, ForeignKey, String, UniqueConstraint
from sqlalchemy.orm import Mapped, mapped_column

from app.db.base import Base


class StandardTable(Base):
    """One published table of coefficients or limits, kept as JSON in the shape its source gives it."""

    __tablename__ = "standard_table"
    __table_args__ = (UniqueConstraint("edition_id", "key"),)

    id: Mapped[int] = mapped_column(primary_key=True)
    edition_id: Mapped[int] = mapped_column(
        ForeignKey("catalog_edition.id", ondelete="CASCADE"), comment="Edition the table was read from"
    )
    key: Mapped[str] = mapped_column(String(80), index=True, comment="Name of the table: that of its file")
    title: Mapped[str] = mapped_column(String(200), comment="What the table gives, for the reader")
    unit: Mapped[str | None] = mapped_column(String(40), comment="Unit of all values, where they share one")
    note: Mapped[str | None] = mapped_column(String(1000), comment="What else a reader must know")
    payload: Mapped[Any] = mapped_column(JSON, comment="The values")
    source: Mapped[str] = mapped_column(String(800), comment="Where the values were read")
