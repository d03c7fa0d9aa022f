"""What all product tables share."""

from typing import ClassVar

from sqlalchemy import ForeignKey, String, UniqueConstraint
from sqlalchemy.orm import Mapped, declared_attr, mapped_column
from sqlalchemy.schema import SchemaItem

from app.db.columns import text


class ProductColumns:
    """Identity and source of one product row, as its data sheet prints it. An empty value: the source does not say."""

    title: ClassVar[str]
    """Name of the table for the reader."""
    key: ClassVar[tuple[str, ...]] = ("model",)
    """Columns that distinguish the rows of one edition."""

    id: Mapped[int] = mapped_column(primary_key=True, sort_order=-20)
    edition_id: Mapped[int] = mapped_column(
        ForeignKey("catalog_edition.id", ondelete="CASCADE"), sort_order=-19, comment="Edition the row was read from"
    )
    slug: Mapped[str] = mapped_column(
        String(160), sort_order=-18, comment="The product in its id: order code in small letters and digits"
    )
    manufacturer: Mapped[str] = text("Manufacturer", 80, sort_order=-17, index=True)
    series: Mapped[str | None] = text("Series", 80, sort_order=-16)
    model: Mapped[str] = text("Model", 80, about="Order code as printed", sort_order=-15)
    source_page: Mapped[str | None] = text("Page", 80, about="Page or chapter of the source", sort_order=90)
    note: Mapped[str | None] = text("Note", 500, about="What the source says beside the numbers", sort_order=91)

    @declared_attr.directive
    def __table_args__(cls) -> tuple[SchemaItem, ...]:  # noqa: N805 - SQLAlchemy passes the class
        """A product occurs once in an edition."""
        return (UniqueConstraint("edition_id", "slug"),)
