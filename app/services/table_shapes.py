"""The values of a standard table as rectangular tables with headings, whatever shape its JSON has.

A source gives its values as a list, as named values, as named groups of values or as rows; nothing here knows a single
table. Names of the JSON become words, a unit at their end becomes the unit of the column.
"""

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain
from typing import Any

from app.reports.numbers import ABSENT, MINUS, number

Path = tuple[str, ...]
Row = dict[Path, Any]

MAX_DEPTH = 5
"""Values that lie deeper than this are shown as JSON."""
_DIGITS = 10
"""More digits than any source prints: values are shown as they are kept."""
_LONGEST_JSON = 200
_UNITS = {
    "mm": "mm", "m": "m", "kW": "kW", "rpm": "rpm", "percent": "%", "degC": "°C", "K": "K", "deg": "°", "kgm2": "kg·m²",
    "Nm": "N·m", "m2": "m²", "kg": "kg", "min": "min", "Hz": "Hz",
}  # fmt: skip
_WORDS = {"ge": "from", "gt": "above", "le": "up to", "lt": "below", "eff": "efficiency"}
_SNAKE = re.compile(r"\w+(_\w+)+")
_NUMERIC = re.compile(rf"[{MINUS}±]?\d[^a-zA-Z]*")
_UNNAMED = {"data", "rows", "values"}


@dataclass(frozen=True)
class Column:
    """Heading of a column; the label is empty where the rows below say what they are."""

    label: str
    unit: str = ""
    numeric: bool = False


@dataclass(frozen=True)
class Grid:
    """One rectangular table, every cell as text."""

    title: str
    columns: tuple[Column, ...]
    rows: tuple[tuple[str, ...], ...]
    row_headings: int = 1
    """How many columns at the beginning head their row."""
    groups: tuple[tuple[str, int], ...] = ()
    """Headings above those of the columns, each with the number of columns below; empty: there is only one line."""


def grids(payload: Any, unit: str = "") -> tuple[Grid, ...]:
    """Every table that the values make; ``unit`` is that of values which do not name their own."""
    return tuple(_shaped(_bounded(payload, MAX_DEPTH), "", unit, ()))


def words(name: str) -> tuple[str, str]:
    """Words and typeset unit of a name.

    >>> [words(name) for name in ("rated_speed_rpm", "gear_lt_17_teeth", "35_to_45_deg", "pressure_N_m2", "belt_mu1")]
    [('Rated speed', 'rpm'), ('Gear below 17 teeth', ''), ('35 to 45°', ''), ('Pressure', 'N/m²'), ('Belt µ1', '')]
    """
    unit = ""
    parts = name.split("_") if _SNAKE.fullmatch(name) else [name]
    if parts[-2:] == ["N", "m2"] and len(parts) > 2:
        parts, unit = parts[:-2], "N/m²"
    elif len(parts) > 1 and parts[-1] in _UNITS:
        parts, unit = parts[:-1], _UNITS[parts[-1]]
    text = re.sub(r"\bmu(?=\d?\b)", "µ", " ".join(_WORDS.get(part, part) for part in parts))
    if unit and parts[-1].isdigit():
        text, unit = text + ("" if unit == "°" else " ") + unit, ""
    first = text.partition(" ")[0]
    return (text[:1].upper() + text[1:] if len(first) > 1 and first.isalpha() and first.islower() else text), unit


def texts(values: Sequence[Any]) -> list[str]:
    """The cells of a column. A pair of rising numbers is a range, unless the column also holds longer or shorter lists.

    >>> texts([0.5, [0.12, 0.6], [None, 3], None]), texts([[63], [71, 80]])
    (['0.5', '0.12 to 0.6', 'up to 3', '–'], ['63', '71, 80'])
    """
    ranges = all(_is_range(value) for value in values if isinstance(value, list))
    return [_range(*value) if ranges and isinstance(value, list) else text_of(value) for value in values]


def text_of(value: Any) -> str:
    """One value as text; a list is enumerated."""
    match value:
        case None | "" | []:
            return ABSENT
        case bool():
            return "yes" if value else "no"
        case int():
            return str(value).replace("-", MINUS)
        case float():
            return number(value, _DIGITS)
        case str():
            return " ".join(value.split("_")) if _SNAKE.fullmatch(value) else value
        case list():
            return ", ".join(text_of(item) for item in value)
    return _json(value) if value else ABSENT


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _is_range(value: list[Any]) -> bool:
    if len(value) != 2 or not all(end is None or _is_number(end) for end in value):
        return False
    low, high = value
    return (low is None) != (high is None) if None in value else bool(low < high)


def _range(low: Any, high: Any) -> str:
    if low is None:
        return f"up to {text_of(high)}"
    return f"from {text_of(low)}" if high is None else f"{text_of(low)} to {text_of(high)}"


def _json(value: Any) -> str:
    text = json.dumps(value, ensure_ascii=False)
    return text if len(text) <= _LONGEST_JSON else text[: _LONGEST_JSON - 1] + "…"


def _bounded(value: Any, depth: int) -> Any:
    if isinstance(value, dict | list) and not depth:
        return _json(value)
    if isinstance(value, dict):
        return {key: _bounded(inner, depth - 1) for key, inner in value.items()}
    return [_bounded(inner, depth - 1) for inner in value] if isinstance(value, list) else value


# Which shape ---------------------------------------------------------------------------------------------------------
def _shaped(value: Any, title: str, unit: str, columns: Path) -> Iterator[Grid]:
    if isinstance(value, dict) and value:
        yield from _of_object(value, title, unit, columns)
    elif rows := _row_list(value, columns):
        yield _of_rows(rows, title)
    else:
        items = value if isinstance(value, list) and value else [value]
        yield _grid(title, [("Value", unit)], [[item] for item in items], 0)


def _of_object(value: Mapping[str, Any], title: str, unit: str, columns: Path) -> Iterator[Grid]:
    entries = dict(value)
    named = entries.get("columns")
    if len(entries) > 1 and isinstance(named, list) and named and all(isinstance(one, str) for one in named):
        columns = tuple(entries.pop("columns"))
    lists = {key: _row_list(inner, columns) for key, inner in entries.items()}
    if all(_is_tree(inner) for inner in entries.values()):
        yield _matrix(entries, title) or _long(entries, title, unit)
    elif all(lists.values()) and (joined := _joined(lists, title)) is not None:
        yield joined
    else:
        plain = {key: inner for key, inner in entries.items() if _is_leaf(inner)}
        if plain:
            yield _long(plain, title, unit)
        for key, inner in entries.items():
            if key not in plain:
                label, own = words(key)
                below = title if key in _UNNAMED else ": ".join(filter(None, (title, label)))
                yield from _shaped(inner, below, own or unit, columns)


def _is_leaf(value: Any) -> bool:
    if isinstance(value, list):
        return not any(isinstance(item, dict | list) for item in value)
    return not isinstance(value, dict) or not value


def _is_tree(value: Any) -> bool:
    """Whether named values, at any depth, end in single values and nowhere in rows."""
    return all(map(_is_tree, value.values())) if isinstance(value, dict) and value else _is_leaf(value)


def _row_list(value: Any, columns: Path) -> list[Row]:
    """The value as rows; none where it is no list of rows."""
    if not isinstance(value, list):
        return []
    if all(isinstance(item, dict) and item for item in value):
        return [dict(_paths(item)) for item in value]
    if columns and all(isinstance(item, list) and len(item) == len(columns) for item in value):
        return [{(name,): cell for name, cell in zip(columns, item, strict=True)} for item in value]
    return []


def _paths(value: Mapping[str, Any], before: Path = ()) -> Iterator[tuple[Path, Any]]:
    for key, inner in value.items():
        if isinstance(inner, dict) and inner:
            yield from _paths(inner, (*before, key))
        else:
            yield (*before, key), inner


# Tables --------------------------------------------------------------------------------------------------------------
def _grid(
    title: str, columns: Sequence[tuple[str, str]], rows: Sequence[Sequence[Any]], row_headings: int = 1,
    groups: Sequence[tuple[str, int]] = (),
) -> Grid:  # fmt: skip
    cells = [texts([row[index] for row in rows]) for index in range(len(columns))]
    made = tuple(Column(label, unit, _is_numeric(column)) for (label, unit), column in zip(columns, cells, strict=True))
    return Grid(title, made, tuple(zip(*cells, strict=True)), row_headings, tuple(groups))


def _is_numeric(cells: Sequence[str]) -> bool:
    """Whether a column holds numbers and ranges of numbers only."""
    told = [part for cell in cells if cell != ABSENT for part in re.split(" to |, |up to |from ", cell) if part]
    return bool(told) and all(_NUMERIC.fullmatch(part) for part in told)


def _heading(path: Path) -> tuple[str, str]:
    parts = [words(part) for part in path]
    return ": ".join(text for text, _ in parts), parts[-1][1]


def _of_rows(rows: Sequence[Row], title: str) -> Grid:
    """Rows of named cells, one column for every name that occurs."""
    names = list(dict.fromkeys(chain.from_iterable(rows)))
    return _grid(title, [_heading(name) for name in names], [[row.get(name) for name in names] for row in rows])


def _matrix(entries: Mapping[str, Any], title: str) -> Grid | None:
    """Groups of values under the same names, side by side; None where the groups have too little in common."""
    if not all(isinstance(inner, dict) and inner and all(map(_is_leaf, inner.values())) for inner in entries.values()):
        return None
    names = list(dict.fromkeys(chain.from_iterable(entries.values())))
    told = sum(len(inner) for inner in entries.values())
    if len(names) == told or 2 * told < len(names) * len(entries):
        return None
    rows = [[_words_of(key), *(inner.get(name) for name in names)] for key, inner in entries.items()]
    return _grid(title, [("", ""), *(words(name) for name in names)], rows)


def _long(entries: Mapping[str, Any], title: str, unit: str) -> Grid:
    """One line for every value, headed by the names that lead to it."""
    paths = dict(_paths(entries))
    depth = max(map(len, paths))
    cells = texts(list(paths.values()))
    rows = []
    for path, cell in zip(paths, cells, strict=True):
        parts = [words(part) for part in path]
        own = parts[-1][1]
        names = [text for text, _ in parts] + [""] * (depth - len(parts))
        rows.append((*names, cell + (" " + own if own and cell != ABSENT else "")))
    columns = (*[Column("")] * depth, Column("Value", unit, _is_numeric(cells)))
    return Grid(title, columns, tuple(rows), depth)


def _joined(lists: Mapping[str, list[Row]], title: str) -> Grid | None:
    """Lists of rows that begin with the same column, side by side; None where they have too little in common."""
    firsts = {next(iter(rows[0])) for rows in lists.values()}
    if len(lists) < 2 or len(firsts) > 1:
        return None
    (first,) = firsts
    by_first = {key: {_key(row.get(first)): row for row in rows} for key, rows in lists.items()}
    longest = max(map(len, lists.values()))
    found = list(dict.fromkeys(chain.from_iterable(by_first.values())))
    if any(len(by_first[key]) < len(rows) for key, rows in lists.items()) or len(found) > 2 * longest:
        return None
    heads = {found_key: row[first] for rows in by_first.values() for found_key, row in rows.items() if first in row}
    if len(heads) < len(found) or not all(_is_leaf(head) for head in heads.values()):
        return None
    if all(_is_number(head) for head in heads.values()):
        found.sort(key=lambda one: heads[one])
    others = {
        key: [name for name in dict.fromkeys(chain.from_iterable(rows)) if name != first] for key, rows in lists.items()
    }
    rows = [
        [heads[one], *(by_first[key].get(one, {}).get(name) for key in lists for name in others[key])] for one in found
    ]
    columns = [_heading(first), *(_heading(name) for key in lists for name in others[key])]
    groups = [("", 1), *((_words_of(key), len(others[key])) for key in lists if others[key])]
    return _grid(title, columns, rows, groups=groups)


def _key(value: Any) -> str:
    return json.dumps(value)


def _words_of(name: str) -> str:
    text, unit = words(name)
    return f"{text} [{unit}]" if unit else text
