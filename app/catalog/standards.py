"""Standard tables of an edition: one JSON file each, ``{"title": ..., "unit": ..., "note": ..., "data": ...}``."""

import json
import math
from typing import Any

from app.catalog.report import LoadReport
from app.db.models import StandardTable
from app.engine.tables import Table

FIELDS = ("title", "unit", "note", "data")
REQUIRED = ("title", "data")


def read_standard_table(content: bytes, key: str, file: str, report: LoadReport) -> dict[str, Any] | None:
    """Row of the table ``standard_table`` (without edition and source); None when ``report`` says what is wrong."""
    try:
        found = json.loads(content.decode("utf-8-sig"), parse_constant=_refuse, object_pairs_hook=_no_twice)
    except json.JSONDecodeError as error:
        report.error(file, f"is no valid JSON: {error.msg}", error.lineno, str(error.colno))
        return None
    except (UnicodeDecodeError, ValueError, RecursionError) as error:
        report.error(file, f"is no valid JSON: {error}")
        return None
    before = len(report.errors)
    if not isinstance(found, dict):
        report.error(file, f"must be an object with {', '.join(FIELDS)}")
        return None
    for name in found:
        if name not in FIELDS:
            report.error(file, f"unknown entry; the entries are {', '.join(FIELDS)}", column=name)
    for name in REQUIRED:
        if found.get(name) in (None, "", [], {}):
            report.error(file, "is missing or empty", column=name)
    _check_length(key, "key", file, report)
    for name in ("title", "unit", "note"):
        if not isinstance(found.get(name), (str, type(None))):
            report.error(file, "must be a text", column=name)
        else:
            _check_length(found.get(name), name, file, report)
    _check_curves(found.get("data"), file, report)
    if len(report.errors) > before:
        return None
    return {
        "key": key,
        "title": found["title"],
        "unit": found.get("unit"),
        "note": found.get("note"),
        "payload": found["data"],
    }


def _check_length(value: str | None, name: str, file: str, report: LoadReport) -> None:
    limit = StandardTable.__table__.columns[name].type.length  # type: ignore[attr-defined]
    if value is not None and len(value) > limit:
        report.error(file, f"is longer than {limit} characters", column=name)


def _check_curves(data: Any, file: str, report: LoadReport) -> None:
    """A table that says it is a chart must be one: every look-up in it relies on that."""
    try:
        made = chart_table("", "", "", data)
    except (KeyError, TypeError, ValueError, AttributeError, OverflowError):
        report.error(file, "must hold curves with points [x, value]", column="data")
        return
    if made is not None:
        numbers = [
            number for family, points in made.curves for number in (family, *(n for point in points for n in point))
        ]
        if not all(map(math.isfinite, numbers)) or not all(points for _, points in made.curves) or not made.curves:
            report.error(file, "every curve needs points of finite numbers", column="data")


def _refuse(constant: str) -> Any:
    raise ValueError(f"{constant} is no number")


def _no_twice(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found = dict(pairs)
    if len(found) != len(pairs):
        names = [name for name, _ in pairs]
        raise ValueError(f"{next(name for name in names if names.count(name) > 1)!r} stands twice in one object")
    return found


def chart_table(key: str, title: str, source: str, payload: Any) -> Table | None:
    """A standard table as a chart to look values up in; None where its values are no curves.

    The data of a chart are ``{"x": ..., "family": ..., "value": ..., "curves": [{"family": 0, "points": [[x, value],
    ...]}], "clamped": true, "source": ...}``; ``x``, ``family`` and ``value`` say in words what the numbers are.
    """
    if not isinstance(payload, dict) or not isinstance(payload.get("curves"), list):
        return None
    curves = [
        (float(curve.get("family", 0.0)), tuple(sorted((float(x), float(value)) for x, value in curve["points"])))
        for curve in payload["curves"]
    ]
    return Table(key=key, title=title, source=str(payload.get("source") or source), curves=tuple(sorted(curves)),
                 clamped=bool(payload.get("clamped", False)))  # fmt: skip
