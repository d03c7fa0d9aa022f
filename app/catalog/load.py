"""Load a folder of catalogue editions into the tables: everything or nothing.

All files are read and checked before the first write, and all writes are one transaction. An edition whose files have
not changed since they were loaded is left alone; one that has changed replaces its rows. Editions that the database
holds beside those of the folder stay: an administrator's own catalogue is loaded by the same function from its folder.
"""

from collections import Counter
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from sqlalchemy import Connection, Engine, Table, delete, insert, select, text, update

from app.catalog.checks import check_rows, row_key
from app.catalog.editions import SOURCE_FIELDS, STANDARD_SUFFIX, EditionFolder, find_editions
from app.catalog.names import MAX_SLUG, short_hash, slugify
from app.catalog.parse import Row, Value, read_rows
from app.catalog.report import LoadReport
from app.catalog.schema import TABLES, TableSpec
from app.catalog.standards import read_standard_table
from app.db.models import CatalogEdition, StandardTable

EDITIONS: Table = CatalogEdition.metadata.tables["catalog_edition"]
STANDARDS: Table = StandardTable.metadata.tables["standard_table"]
_LOCK = 0x6361_7461  # any number that no other user of the same server takes: "cata"


@dataclass
class CheckedEdition:
    """An edition that may be written: its rows by table."""

    folder: EditionFolder
    checksum: str
    products: dict[str, list[Row]] = field(default_factory=dict)
    standards: list[dict[str, Any]] = field(default_factory=list)


def load_catalog(engine: Engine, directory: Path) -> LoadReport:
    """Load every edition below ``directory``, or the one edition that ``directory`` is.

    The report lists what was found; when it holds an error (``not report.ok``), nothing was written.
    """
    report = LoadReport()
    editions = [_check_edition(folder, report) for folder in find_editions(directory, report)]
    if not report.ok:
        return report
    with engine.connect().execution_options(writes=True) as connection, connection.begin():
        if connection.dialect.name == "postgresql":
            connection.execute(text("SELECT pg_advisory_xact_lock(:lock)"), {"lock": _LOCK})
        for edition in editions:
            _write_edition(connection, edition, report)
    return report


def _check_edition(folder: EditionFolder, report: LoadReport) -> CheckedEdition:
    edition = CheckedEdition(folder, folder.checksum)
    for file, content in folder.files.items():
        shown = folder.path(file)
        name = Path(file).stem
        if file.endswith(".csv") and name in TABLES:
            rows = read_rows(content, TABLES[name], shown, report)
            check_rows(rows, TABLES[name], shown, report)
            edition.products[name] = rows
            report.rows[name] += len(rows)
        elif file.endswith(STANDARD_SUFFIX):
            found = read_standard_table(content, name, shown, report)
            if found is not None:
                edition.standards.append(found)
                report.rows[STANDARDS.name] += 1
    return edition


def _write_edition(connection: Connection, edition: CheckedEdition, report: LoadReport) -> None:
    folder = edition.folder
    stored = connection.execute(
        select(EDITIONS.c.id, EDITIONS.c.checksum).where(
            EDITIONS.c.maker_slug == folder.maker_slug, EDITIONS.c.slug == folder.slug
        )
    ).one_or_none()
    if stored is not None and stored.checksum == edition.checksum:
        report.unchanged.append(folder.key)
        return
    values: dict[str, Any] = {name: folder.source.get(name) for name in SOURCE_FIELDS}
    values |= {"maker_slug": folder.maker_slug, "slug": folder.slug}
    values |= {"checksum": edition.checksum, "loaded_at": datetime.now(UTC)}
    if stored is None:
        edition_id = connection.execute(insert(EDITIONS).values(values).returning(EDITIONS.c.id)).scalar_one()
    else:
        edition_id = stored.id
        connection.execute(update(EDITIONS).where(EDITIONS.c.id == edition_id).values(values))
        for table in (*(spec.table for spec in TABLES.values()), STANDARDS):
            connection.execute(delete(table).where(table.c.edition_id == edition_id))
    for name, rows in edition.products.items():
        _write_products(connection, TABLES[name], rows, edition_id, report.written)
    _write_standards(connection, edition, edition_id, report.written)
    report.loaded.append(folder.key)


def _write_products(
    connection: Connection, table: TableSpec, rows: list[Row], edition_id: int, written: Counter[str]
) -> None:
    groups: dict[tuple[Value, ...], list[Row]] = {}
    for row in rows:
        groups.setdefault(row_key(row, table), []).append(row)
    if not groups:
        return
    slugs = _slugs(list(groups))
    names = [spec.name for spec in table.columns.values() if spec.table == table.name]
    records = [
        {name: members[0].values[name] for name in names} | {"edition_id": edition_id, "slug": slugs[key]}
        for key, members in groups.items()
    ]
    for record, members in zip(records, groups.values(), strict=True):
        record["note"] = _joined(members, "note", table)
        record["source_page"] = _joined(members, "source_page", table)
    written[table.name] += len(records)
    if table.detail is None:
        connection.execute(insert(table.table), records)
        return
    ids = connection.scalars(insert(table.table).returning(table.table.c.id, sort_by_parameter_order=True), records)
    points = [spec.name for spec in table.columns.values() if spec.table == table.detail.name]
    details = [
        {name: row.values[name] for name in points} | {"motor_id": motor_id, "position": position}
        for motor_id, members in zip(ids, groups.values(), strict=True)
        for position, row in enumerate(members, 1)
    ]
    written[table.detail.name] += len(details)
    connection.execute(insert(table.detail), details)


def _slugs(keys: list[tuple[Value, ...]]) -> dict[tuple[Value, ...], str]:
    """Slug of each product; order codes that differ in signs only get the hash of the code behind."""
    names = {
        key: " ".join(f"{part:g}" if isinstance(part, float) else str(part) for part in key if part) for key in keys
    }
    plain = {key: slugify(name) for key, name in names.items()}
    count = Counter(plain.values())
    return {
        key: slug if count[slug] == 1 and len(slug) < MAX_SLUG else f"{slug}-{short_hash(names[key])}"
        for key, slug in plain.items()
    }


def _joined(members: list[Row], name: str, table: TableSpec) -> str | None:
    """What the rows of one product say in a text column, each text once."""
    texts = dict.fromkeys(str(row.values[name]) for row in members if row.values[name])
    return "; ".join(texts)[: table.columns[name].max_length] or None


def _write_standards(connection: Connection, edition: CheckedEdition, edition_id: int, written: Counter[str]) -> None:
    if not edition.standards:
        return
    given = edition.folder.source
    parts = (given.get("publisher"), given["document"], given.get("edition") or given.get("date"))
    source = ", ".join(part for part in parts if part)[:800]
    records = [found | {"edition_id": edition_id, "source": source} for found in edition.standards]
    connection.execute(insert(STANDARDS), records)
    written[STANDARDS.name] += len(records)
