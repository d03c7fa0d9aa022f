"""Read one CSV file of the catalogue into checked rows: header, cells, ranges; nothing is repaired or guessed.

Files are UTF-8, with or without byte order mark, with any line ends. The delimiter is a comma and the decimal sign a
point; a file whose header is separated by semicolons may write decimal commas, as spreadsheets of many countries do.
"""

import csv
import io
import math
import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TypeAlias

from app.catalog.report import LoadReport
from app.catalog.schema import ColumnSpec, HeaderCell, HeaderError, TableSpec

Value: TypeAlias = float | int | str | None

_NUMBER = re.compile(r"[-+]?(\d+(\.\d*)?|\.\d+)([eE][-+]?\d+)?")
_INTEGER = re.compile(r"[-+]?\d{1,9}")
_CONTROL = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f]")


class CellError(ValueError):
    """A cell that does not hold what its column takes."""


@dataclass(frozen=True)
class Row:
    """One row of a file: ``values`` by column name in the column's unit, None where the cell is empty or missing."""

    line: int
    values: dict[str, Value]

    def number(self, name: str) -> float | None:
        """Value of a number column."""
        value = self.values.get(name)
        return value if isinstance(value, (int, float)) else None


def read_rows(content: bytes, table: TableSpec, file: str, report: LoadReport) -> list[Row]:
    """Rows of ``content``, a CSV file of ``table``; what is wrong goes into ``report``, a wrong row is left out."""
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        report.error(file, "is not written in UTF-8", line=content.count(b"\n", 0, error.start) + 1)
        return []
    before = len(report.errors)
    records = _records(text, file, report)
    header = next(records, None)
    if header is None:
        if len(report.errors) == before:
            report.error(file, "is empty", line=1)
        return []
    cells = _read_header(header[1], header[0], table, file, report)
    if cells is None:
        return []
    comma = ";" in text.split("\n", 1)[0]
    rows = []
    for line, record in records:
        if len(record) != len(cells):
            report.error(file, f"has {len(record)} cells, the header {len(cells)}", line=line)
            continue
        row = _read_row(record, cells, table, comma, (file, line), report)
        if row is not None:
            rows.append(row)
    return rows


def _records(text: str, file: str, report: LoadReport) -> Iterator[tuple[int, list[str]]]:
    """Each record that is not blank, with the line on which it begins."""
    first = text.split("\n", 1)[0]
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=";" if ";" in first else ",", strict=True)
    line = 1
    while True:
        try:
            record = next(reader, None)
        except csv.Error as error:
            report.error(file, f"is no valid CSV: {error}", line=reader.line_num)
            return
        if record is None:
            return
        if any(cell.strip() for cell in record):
            yield line, record
        line = reader.line_num + 1


def _read_header(
    record: list[str], line: int, table: TableSpec, file: str, report: LoadReport
) -> list[HeaderCell] | None:
    cells: list[HeaderCell] = []
    before = len(report.errors)
    for name in (cell.strip() for cell in record):
        try:
            cell = table.column(name)
        except HeaderError as error:
            report.error(file, str(error), line=line, column=name)
            continue
        if any(cell.spec is other.spec for other in cells):
            report.error(file, f"{cell.spec.quantity!r} stands in two columns", line=line, column=name)
        cells.append(cell)
    given = {cell.spec.name for cell in cells}
    for spec in table.columns.values():
        if spec.required and spec.name not in given:
            report.error(file, "this column is required", line=line, column=spec.name)
    return cells if len(report.errors) == before else None


def _read_row(
    record: list[str],
    cells: list[HeaderCell],
    table: TableSpec,
    comma: bool,
    place: tuple[str, int],
    report: LoadReport,
) -> Row | None:
    file, line = place
    values: dict[str, Value] = dict.fromkeys(table.columns)
    sound = True
    for text, cell in zip(record, cells, strict=True):
        try:
            values[cell.spec.name] = read_cell(text.strip(), cell, comma=comma)
        except CellError as error:
            report.error(file, str(error), line=line, column=cell.spec.name)
            sound = False
    return Row(line, values) if sound else None


def read_cell(text: str, cell: HeaderCell, *, comma: bool = False) -> Value:
    """Value of one cell in the unit of its column; None when the cell is empty.

    Raises CellError when it is no such value or not plausible.
    """
    spec = cell.spec
    if text == "":
        if spec.required:
            raise CellError("must not be empty")
        return None
    if spec.type == "text":
        return _read_text(text, spec)
    if comma and text.count(",") == 1 and "." not in text:
        text = text.replace(",", ".")
    value: float | int
    if spec.type == "integer":
        if not _INTEGER.fullmatch(text):
            raise CellError(f"{text[:40]!r} is not a whole number")
        value = int(text)
    else:
        value = _read_number(text, cell)
    low, high = spec.meaning.low, spec.meaning.high
    if (low is not None and value < low) or (high is not None and value > high):
        unit = f" {spec.unit}" if spec.unit not in (None, "1") else ""
        raise CellError(f"{value:g}{unit} is not plausible: expected {low:g} to {high:g}{unit}")
    return value


def _read_number(text: str, cell: HeaderCell) -> float:
    if not _NUMBER.fullmatch(text):
        hint = "; the decimal sign is a point" if "," in text else ""
        raise CellError(f"{text[:40]!r} is not a number{hint}")
    value = float(text)
    if cell.scale != 1.0:
        value = float(f"{value * cell.scale:.12g}")
    if not math.isfinite(value):
        raise CellError(f"{text[:40]!r} is too large for a number")
    return value


def _read_text(text: str, spec: ColumnSpec) -> str:
    if _CONTROL.search(text):
        raise CellError("holds a control character")
    if spec.meaning.choices and text not in spec.meaning.choices:
        raise CellError(f"{text[:40]!r} is none of {', '.join(spec.meaning.choices)}")
    if spec.max_length is not None and len(text) > spec.max_length:
        raise CellError(f"is longer than {spec.max_length} characters")
    return text
