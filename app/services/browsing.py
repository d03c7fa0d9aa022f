"""The catalogue as printed: tables, products and editions, for whoever wants to look."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeVar

from sqlalchemy.orm import Session

from app.catalog.browse import BrowseError, BrowsePage, BrowseQuery
from app.catalog.repository import CatalogRepository, EditionSummary, ProductNotFoundError
from app.catalog.schema import TABLES, ColumnSpec
from app.services.errors import FieldError, InvalidInputError, NotFoundError

T = TypeVar("T")


@dataclass(frozen=True)
class TableSummary:
    """One kind of product and how many there are."""

    kind: str
    title: str
    count: int


@dataclass(frozen=True)
class ProductSheet:
    """One product as printed: several rows where it has several operating points."""

    kind: str
    title: str
    columns: list[ColumnSpec]
    rows: list[dict[str, Any]]


class BrowsingService:
    """Reads the catalogue in the units of its data sheets."""

    def __init__(self, session: Session) -> None:
        self._catalogue = CatalogRepository(session)

    def tables(self) -> list[TableSummary]:
        """Every kind of product."""
        counts = self._catalogue.counts()
        return [TableSummary(spec.name, spec.title, counts[spec.name]) for spec in TABLES.values()]

    def page(self, kind: str, query: BrowseQuery) -> BrowsePage:
        """A page of one kind. Raises NotFoundError for an unknown kind and InvalidInputError for an unknown column."""
        try:
            return self._found(lambda: self._catalogue.browse(kind, query), f"There is no kind of product {kind!r}.")
        except BrowseError as error:
            raise InvalidInputError([FieldError((error.field,), str(error))]) from error

    def product(self, kind: str, product_id: str) -> ProductSheet:
        """One product. Raises NotFoundError."""
        missing = "The catalogue that is loaded holds no such product."
        rows = self._found(lambda: self._catalogue.row(kind, product_id), missing)
        return ProductSheet(kind, TABLES[kind].title, self._catalogue.columns(kind), rows)

    def editions(self) -> list[EditionSummary]:
        """Every edition that is loaded, with its source."""
        return self._catalogue.editions()

    def makers(self, kind: str | None = None) -> list[str]:
        """Makers with products of a kind, or of any. Raises NotFoundError for an unknown kind."""
        return self._found(lambda: self._catalogue.makers(kind), "There is no such kind of product.")

    def series(self, kind: str, manufacturer: str | None = None) -> list[str]:
        """Series of a kind. Raises NotFoundError for an unknown kind."""
        return self._found(lambda: self._catalogue.series(kind, manufacturer), "There is no such kind of product.")

    @staticmethod
    def _found(read: Callable[[], T], missing: str) -> T:
        try:
            return read()
        except ProductNotFoundError as error:
            raise NotFoundError(missing) from error
