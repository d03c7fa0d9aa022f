"""Editions: where published data come from."""

from datetime import datetime

from sqlalchemy import String, UniqueConstraint
from sqlalchemy.orm import Mapped, mapped_column

from app.db.base import Base, UtcDateTime


class CatalogEdition(Base):
    """One edition of one maker's published data: a folder of ``catalog_data`` with its ``SOURCE.toml``."""

    __tablename__ = "catalog_edition"
    __table_args__ = (UniqueConstraint("maker_slug", "slug"),)

    id: Mapped[int] = mapped_column(primary_key=True)
    maker: Mapped[str] = mapped_column(String(80), comment="Maker whose products the edition describes")
    maker_slug: Mapped[str] = mapped_column(String(80), comment="The maker in a product's id")
    slug: Mapped[str] = mapped_column(String(80), comment="The edition in a product's id: name of its folder")
    document: Mapped[str] = mapped_column(String(400), comment="Title of the document the values were read from")
    publisher: Mapped[str | None] = mapped_column(String(400), comment="Who published the document")
    edition: Mapped[str | None] = mapped_column(String(80), comment="Edition or revision as printed")
    date: Mapped[str | None] = mapped_column(String(10), comment="Date of the edition: YYYY, YYYY-MM or YYYY-MM-DD")
    url: Mapped[str | None] = mapped_column(String(500), comment="Where the document can be had")
    retrieved: Mapped[str | None] = mapped_column(String(10), comment="Date on which the values were read")
    licence: Mapped[str | None] = mapped_column(String(200), comment="Licence of the data, where known")
    note: Mapped[str | None] = mapped_column(String(500), comment="What else a reader of the source must know")
    checksum: Mapped[str] = mapped_column(String(64), comment="SHA-256 of the files of the edition")
    loaded_at: Mapped[datetime] = mapped_column(UtcDateTime, comment="When the rows were last written")

    @property
    def key(self) -> str:
        """Stable name of the edition, as it stands in product ids and in saved sizings."""
        return f"{self.maker_slug}:{self.slug}"

    @property
    def citation(self) -> str:
        """Publisher, document and edition in one line, for the reader."""
        parts = (self.publisher, self.document, self.edition or self.date)
        return ", ".join(part for part in parts if part)
