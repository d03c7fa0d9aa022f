"""Pages of a catalogue table as printed, for the browser: search, filter, sort; any table by its declaration."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from sqlalchemy import ColumnElement, Select, func, select
from sqlalchemy.orm import Session

from app.catalog.filters import ProductFilter, conditions
from app.catalog.names import product_id
from app.catalog.schema import ColumnSpec, TableSpec

MAX_PAGE_SIZE = 200


class BrowseError(ValueError):
    """A page that cannot be shown: ``field`` of the query is to blame."""

    def __init__(self, field: str, text: str) -> None:
        super().__init__(text)
        self.field = field


@dataclass(frozen=True, kw_only=True)
class BrowseQuery:
    """What to show of a table. ``sort`` names a column (empty: as printed).

    ``page`` counts from 1; an ``offset`` in rows is taken instead where it is given.
    """

    filter: ProductFilter = field(default_factory=ProductFilter)
    sort: str = ""
    descending: bool = False
    page: int = 1
    page_size: int = 50
    offset: int | None = None

    @property
    def skipped(self) -> int:
        """Rows before the page."""
        return (self.page - 1) * self.page_size if self.offset is None else self.offset


@dataclass(frozen=True)
class BrowsePage:
    """One page. Each row holds every column by name in the column's unit (None: not stated), ``id`` and ``edition``."""

    table: str
    title: str
    columns: list[ColumnSpec]
    rows: list[dict[str, Any]]
    total: int
    page: int
    page_size: int

    @property
    def pages(self) -> int:
        """Number of pages, at least one."""
        return max(1, -(-self.total // self.page_size))


def browse_page(
    session: Session,
    spec: TableSpec,
    query: BrowseQuery,
    editions: Mapping[int, str],
    edition_ids: Sequence[int] | None,
) -> BrowsePage:
    """One page of ``spec``. A page beyond the last one is empty.

    Raises BrowseError when the sort column is unknown or the page is none.
    """
    if query.page < 1:
        raise BrowseError("page", "pages count from 1")
    if not 1 <= query.page_size <= MAX_PAGE_SIZE:
        raise BrowseError("page_size", f"a page has 1 to {MAX_PAGE_SIZE} rows")
    where = conditions(spec, query.filter, edition_ids)
    statement = _rows(spec).where(*where)
    total = session.execute(select(func.count()).select_from(statement.subquery())).scalar_one()
    statement = statement.order_by(*_order(spec, query))
    statement = statement.limit(query.page_size).offset(min(query.skipped, 2**31))
    found = session.execute(statement).mappings()
    rows = [_as_printed(spec, row, editions) for row in found]
    return BrowsePage(spec.name, spec.title, list(spec.columns.values()), rows, total, query.page, query.page_size)


def rows_of_product(
    session: Session, spec: TableSpec, edition_id: int, slug: str, editions: Mapping[int, str]
) -> list[dict[str, Any]]:
    """The row of one product, or one per operating point; empty when there is none."""
    statement = _rows(spec).where(spec.table.c.edition_id == edition_id, spec.table.c.slug == slug)
    statement = statement.order_by(*_order(spec, BrowseQuery()))
    return [_as_printed(spec, row, editions) for row in session.execute(statement).mappings()]


def _rows(spec: TableSpec) -> Select[Any]:
    """One row per printed row: a motor with two operating points has two."""
    table, detail = spec.table, spec.detail
    columns = [_column(spec, name) for name in spec.columns]
    statement = select(table.c.edition_id, table.c.slug, *columns)
    return statement if detail is None else statement.join_from(table, detail, detail.c.motor_id == table.c.id)


def _column(spec: TableSpec, name: str) -> ColumnElement[Any]:
    if spec.detail is not None and spec.columns[name].table == spec.detail.name:
        return spec.detail.c[name]
    return spec.table.c[name]


def _order(spec: TableSpec, query: BrowseQuery) -> list[ColumnElement[Any]]:
    """As printed within maker and edition, or by the wanted column with missing values last."""
    detail = [] if spec.detail is None else [spec.detail.c.position]
    printed: list[ColumnElement[Any]] = [spec.table.c.manufacturer, spec.table.c.edition_id, spec.table.c.id, *detail]
    if not query.sort:
        return printed
    if query.sort not in spec.columns:
        raise BrowseError("sort", f"{query.sort[:40]!r} is no column of {spec.name}")
    column = _column(spec, query.sort)
    return [column.is_(None), column.desc() if query.descending else column.asc(), *printed]


def _as_printed(spec: TableSpec, row: Mapping[Any, Any], editions: Mapping[int, str]) -> dict[str, Any]:
    edition = editions[row["edition_id"]]
    shown = {name: row[name] for name in spec.columns}
    return {"id": product_id(spec.name, edition, row["slug"]), "edition": edition, **shown}
