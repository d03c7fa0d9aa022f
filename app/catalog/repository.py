"""Read the catalogue: products in SI for the engine, rows as printed for the browser, editions and makers."""

import hashlib
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from sqlalchemy import ColumnElement, RowMapping, func, select
from sqlalchemy.orm import Session

from app.catalog.browse import BrowsePage, BrowseQuery, browse_page, rows_of_product
from app.catalog.filters import ProductFilter, conditions
from app.catalog.records import ProductT, product_from_row, table_of
from app.catalog.schema import TABLES, ColumnSpec, TableSpec
from app.catalog.standards import chart_table
from app.db.models import CatalogEdition, StandardTable
from app.engine.products import GearUnit, InductionMotor, ServoDrive, ServoGearUnit, ServoMotor
from app.engine.tables import Table


class ProductNotFoundError(LookupError):
    """No product (or table) of this name in the catalogue."""

    def __init__(self, name: str) -> None:
        super().__init__(f"{name!r} is not in the catalogue")
        self.name = name


ALL = ProductFilter()


@dataclass(frozen=True)
class EditionSummary:
    """One loaded edition."""

    key: str
    maker: str
    citation: str
    date: str | None
    url: str | None
    licence: str | None
    note: str | None
    checksum: str
    rows: dict[str, int]
    """Number of products by table; tables without any are left out."""


@dataclass(frozen=True)
class StandardTableSummary:
    """What one standard table is, without its values."""

    key: str
    title: str
    unit: str | None
    note: str | None
    source: str


@dataclass(frozen=True)
class StandardTableRecord(StandardTableSummary):
    """One standard table with its values and source."""

    payload: Any


class CatalogRepository:
    """All reading access to the catalogue, within one session."""

    def __init__(self, session: Session) -> None:
        self._session = session

    @cached_property
    def _editions(self) -> dict[int, CatalogEdition]:
        query = select(CatalogEdition).order_by(CatalogEdition.maker_slug, CatalogEdition.slug)
        return {edition.id: edition for edition in self._session.scalars(query)}

    def servo_motors(self, wanted: ProductFilter = ALL) -> list[ServoMotor]:
        """Servo motors by maker, series and order code."""
        return self._products(ServoMotor, wanted)

    def servo_gear_units(self, wanted: ProductFilter = ALL) -> list[ServoGearUnit]:
        """Servo gear units by maker, series and order code; those without a ratio are left out."""
        ratio = table_of(ServoGearUnit).table.c.ratio
        return self._products(ServoGearUnit, wanted, ratio.is_not(None))

    def servo_drives(self, wanted: ProductFilter = ALL) -> list[ServoDrive]:
        """Servo drives by maker, series and order code."""
        return self._products(ServoDrive, wanted)

    def servo_motor(self, product_id: str) -> ServoMotor:
        """The servo motor of this id. Raises ProductNotFoundError."""
        return self._product(ServoMotor, product_id)

    def servo_gear_unit(self, product_id: str) -> ServoGearUnit:
        """The servo gear unit of this id. Raises ProductNotFoundError."""
        return self._product(ServoGearUnit, product_id)

    def servo_drive(self, product_id: str) -> ServoDrive:
        """The servo drive of this id. Raises ProductNotFoundError."""
        return self._product(ServoDrive, product_id)

    def products(self, product: type[ProductT], wanted: ProductFilter = ALL) -> list[ProductT]:
        """All products of an engine type by maker, series and order code; gear units without a ratio are left out."""
        table = table_of(product).table
        needed = [table.c.ratio.is_not(None)] if product in (ServoGearUnit, GearUnit) else []
        return self._products(product, wanted, *needed)

    def tables(self) -> dict[str, Table]:
        """Standard tables that are tabulated charts, by key: ready for a look-up. Of several editions the newest."""
        found = {}
        tables = self._session.scalars(select(StandardTable))
        for table in sorted(tables, key=lambda one: self._editions[one.edition_id].date or ""):
            made = chart_table(table.key, table.title, table.source, table.payload)
            if made is not None:
                found[table.key] = made
        return found

    def _products(self, product: type[ProductT], wanted: ProductFilter, *more: ColumnElement[bool]) -> list[ProductT]:
        spec = table_of(product)
        table = spec.table
        query = select(table).where(*conditions(spec, wanted, self._edition_ids(wanted)), *more)
        query = query.order_by(table.c.manufacturer, table.c.series, table.c.id)
        cited = {id_: (edition.key, edition.citation) for id_, edition in self._editions.items()}
        points = self._points() if product is InductionMotor else {}
        return [
            product_from_row(product, {**row, "points": points.get(row["id"], [])}, *cited[row["edition_id"]])
            for row in self._session.execute(query).mappings()
        ]

    def _points(self) -> dict[int, list[RowMapping]]:
        """Operating points of all induction motors by motor, in the order of the source."""
        detail = TABLES["induction_motor"].detail
        assert detail is not None
        found: dict[int, list[RowMapping]] = {}
        for row in self._session.execute(select(detail).order_by(detail.c.motor_id, detail.c.position)).mappings():
            found.setdefault(row["motor_id"], []).append(row)
        return found

    def _product(self, product: type[ProductT], product_id: str) -> ProductT:
        spec = table_of(product)
        edition, slug = self._locate(spec, product_id)
        query = select(spec.table).where(spec.table.c.edition_id == edition.id, spec.table.c.slug == slug)
        row = self._session.execute(query).mappings().one_or_none()
        if row is None:
            raise ProductNotFoundError(product_id)
        return product_from_row(product, row, edition.key, edition.citation)

    def _locate(self, spec: TableSpec, product_id: str) -> tuple[CatalogEdition, str]:
        """Edition and slug behind a product id of this table."""
        parts = product_id.split(":")
        if len(parts) == 4 and parts[0] == spec.name.replace("_", "-"):
            for edition in self._editions.values():
                if [edition.maker_slug, edition.slug] == parts[1:3]:
                    return edition, parts[3]
        raise ProductNotFoundError(product_id)

    def _edition_ids(self, wanted: ProductFilter) -> list[int] | None:
        if not wanted.editions:
            return None
        return [id_ for id_, edition in self._editions.items() if edition.key in wanted.editions]

    def browse(self, table: str, query: BrowseQuery) -> BrowsePage:
        """One page of a table as printed.

        Raises ProductNotFoundError when there is no such table, BrowseError when the page or its order is none.
        """
        return browse_page(self._session, _table(table), query, self._keys(), self._edition_ids(query.filter))

    def row(self, table: str, product_id: str) -> list[dict[str, Any]]:
        """All columns of one product as printed: one row, or one per operating point of an induction motor.

        Raises ProductNotFoundError when there is no such table or product.
        """
        spec = _table(table)
        edition, slug = self._locate(spec, product_id)
        rows = rows_of_product(self._session, spec, edition.id, slug, self._keys())
        if not rows:
            raise ProductNotFoundError(product_id)
        return [row | {"source": edition.citation, "url": edition.url} for row in rows]

    def columns(self, table: str) -> list[ColumnSpec]:
        """Declared columns of a table, in order. Raises ProductNotFoundError when there is no such table."""
        return list(_table(table).columns.values())

    def makers(self, table: str | None = None) -> list[str]:
        """Makers with products in the table, or in any product table."""
        specs = [_table(table)] if table is not None else TABLES.values()
        found = {
            maker for spec in specs for maker in self._session.scalars(select(spec.table.c.manufacturer).distinct())
        }
        return sorted(found, key=str.casefold)

    def series(self, table: str, manufacturer: str | None = None) -> list[str]:
        """Series in the table, of one maker or of all. Raises ProductNotFoundError when there is no such table."""
        column = _table(table).table.c
        query = select(column.series).where(column.series.is_not(None)).distinct()
        if manufacturer is not None:
            query = query.where(column.manufacturer == manufacturer)
        return sorted(self._session.scalars(query), key=str.casefold)

    def counts(self) -> dict[str, int]:
        """Number of products by table."""
        return {
            name: self._session.execute(select(func.count()).select_from(spec.table)).scalar_one()
            for name, spec in TABLES.items()
        }

    def editions(self) -> list[EditionSummary]:
        """Every loaded edition by maker, with its source and its number of products by table."""
        rows: dict[int, dict[str, int]] = {id_: {} for id_ in self._editions}
        tables = [(name, spec.table) for name, spec in TABLES.items()]
        for name, table in [*tables, (StandardTable.__tablename__, StandardTable.metadata.tables["standard_table"])]:
            counted = select(table.c.edition_id, func.count()).group_by(table.c.edition_id)
            for edition_id, count in self._session.execute(counted):
                rows[edition_id][name] = count
        return [
            EditionSummary(
                key=edition.key,
                maker=edition.maker,
                citation=edition.citation,
                date=edition.date,
                url=edition.url,
                licence=edition.licence,
                note=edition.note,
                checksum=edition.checksum,
                rows=rows[id_],
            )
            for id_, edition in self._editions.items()
        ]

    def edition_checksums(self) -> dict[str, str]:
        """Checksum of every edition by its key: what a saved sizing keeps to say which data it used."""
        return {edition.key: edition.checksum for edition in self._editions.values()}

    def catalogue_version(self) -> str:
        """Short hash over all editions: the same as long as the catalogue is, so that results may be kept by it."""
        query = select(CatalogEdition.maker_slug, CatalogEdition.slug, CatalogEdition.checksum).order_by(
            CatalogEdition.maker_slug, CatalogEdition.slug
        )
        digest = hashlib.sha256()
        for row in self._session.execute(query):
            digest.update(("\0".join(row) + "\n").encode())
        return digest.hexdigest()[:16]

    def standard_table(self, key: str) -> StandardTableRecord:
        """A standard table by its key; of several editions the one of the newest date.

        Raises ProductNotFoundError when there is none.
        """
        query = select(StandardTable).where(StandardTable.key == key)
        found = sorted(self._session.scalars(query), key=lambda table: self._editions[table.edition_id].date or "")
        if not found:
            raise ProductNotFoundError(key)
        table = found[-1]
        return StandardTableRecord(table.key, table.title, table.unit, table.note, table.source, table.payload)

    def standard_tables(self) -> list[StandardTableSummary]:
        """All standard tables by key, without their values; of several editions the one of the newest date."""
        of = StandardTable
        query = select(of.edition_id, of.key, of.title, of.unit, of.note, of.source)
        rows = sorted(
            self._session.execute(query), key=lambda row: (row.key, self._editions[row.edition_id].date or "")
        )
        newest = {row.key: StandardTableSummary(row.key, row.title, row.unit, row.note, row.source) for row in rows}
        return list(newest.values())

    def _keys(self) -> dict[int, str]:
        return {id_: edition.key for id_, edition in self._editions.items()}


def _table(name: str) -> TableSpec:
    if name not in TABLES:
        raise ProductNotFoundError(name)
    return TABLES[name]
