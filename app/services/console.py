"""Services for the command line, and their results as text: the same services as behind pages and REST."""

import json
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from app.db.session import make_engine, session_factory
from app.engine.quantity import from_si
from app.engine.sheet import Check, Verdict
from app.services import results
from app.services.catalogue import CatalogueCache
from app.services.documents import FORMAT, read_document
from app.services.errors import InvalidInputError
from app.services.examples import Example, ExampleService, examples_folder
from app.services.reading import parse_json
from app.services.sizing import Sizing, SizingService

_MARKS = {Verdict.OK: "ok", Verdict.TIGHT: "tight", Verdict.FAILS: "FAILS", Verdict.NOT_CHECKED: "not checked"}


@dataclass(frozen=True)
class ConsoleServices:
    """What the commands use."""

    sizing: SizingService
    examples: ExampleService


@contextmanager
def services(database_url: str) -> Iterator[ConsoleServices]:
    """The services on a database, which is opened only when a product of the catalogue is named."""
    engine = make_engine(database_url)
    try:
        sizing = SizingService(CatalogueCache(session_factory(engine)))
        yield ConsoleServices(sizing, ExampleService(sizing, examples_folder()))
    finally:
        engine.dispose()


@dataclass(frozen=True)
class FileResult:
    """Every axis of a file, calculated."""

    sizings: tuple[Sizing, ...]
    is_project: bool

    @property
    def fails(self) -> bool:
        """Whether a check fails on any axis."""
        return any(sizing.verdict == Verdict.FAILS for sizing in self.sizings)

    def as_json(self) -> str:
        """What REST answers: one object, or a list of them for a project."""
        found = [json.loads(results.sizing_json(sizing)) for sizing in self.sizings]
        return json.dumps(found if self.is_project else found[0], indent=2, ensure_ascii=False)

    def as_text(self) -> str:
        """Headline numbers and checks of every axis."""
        return "\n\n".join(_sizing_text(sizing) for sizing in self.sizings)


def size_file(service: SizingService, path: Path) -> FileResult:
    """Calculate a file that holds a sizing request or a project. Raises ServiceError and OSError."""
    raw = parse_json(path.read_bytes())
    if not (isinstance(raw, dict) and raw.get("format") == FORMAT):
        return FileResult((service.size(raw),), is_project=False)
    found = []
    for index, axis in enumerate(read_document(raw)["axes"]):
        try:
            found.append(service.size(axis["request"]))
        except InvalidInputError as error:
            raise error.within("axes", index, "request") from error
    return FileResult(tuple(found), is_project=True)


def refusal(error: Exception) -> str:
    """What was refused, one line for each value."""
    if isinstance(error, InvalidInputError):
        return "\n".join(f"{field.name or 'input'}: {field.message}" for field in error.errors)
    return str(error)


def _sizing_text(sizing: Sizing) -> str:
    request = sizing.typed.request
    lines = [" - ".join(part for part in (request.name, request.mechanism.title) if part)]
    for h in sizing.headlines:
        value = f"{_number(from_si(h.value, h.unit))} {_unit(h.unit)}".rstrip()
        lines.append(f"  {h.symbol:<10} = {value:<14} {h.label.rstrip('.')}")
    lines += [_check_text(check) for check in sizing.sheet.checks]
    open_checks = sizing.counts[Verdict.NOT_CHECKED]
    lines.append(f"  {_MARKS[sizing.verdict]}" + (f", {open_checks} not checked" if open_checks else ""))
    return "\n".join(lines)


def _check_text(check: Check) -> str:
    if check.demanded is None or check.permitted is None or check.utilisation is None:
        return f"  {'not checked':<12} {check.name}: missing {check.missing}"
    demanded, permitted = (_number(from_si(value, check.unit)) for value in (check.demanded, check.permitted))
    used = f"{check.utilisation:.0%}" if check.utilisation < 1e4 else "nothing permitted"
    return f"  {_MARKS[check.verdict]:<12} {check.name}: {demanded} of {permitted} {_unit(check.unit)} ({used})"


def _number(value: float) -> str:
    return f"{value:.5g}"


def _unit(unit: str) -> str:
    return "" if unit == "1" else unit


def examples_json(found: Sequence[Example]) -> str:
    """Every row of every example, and the totals."""
    listed: list[dict[str, Any]] = [results.example_dict(example) | {"counts": example.counts} for example in found]
    return json.dumps({"examples": listed, "totals": _totals(found)}, indent=2, ensure_ascii=False)


def examples_text(found: Sequence[Example]) -> str:
    """One line per example, one more for each number that is not met, and the totals."""
    lines = []
    for example in found:
        counts = ", ".join(f"{count} {kind}" for kind, count in example.counts.items() if count)
        lines.append(f"{example.file.id}: {counts}")
        for row in example.rows:
            if not row.met:
                why = row.reason or f"computed {row.computed:.6g}, expected {row.expected:.6g} {_unit(row.unit)}"
                lines.append(f"  {row.produced}: {row.name} ({row.status}): {why}")
    totals = _totals(found)
    lines.append(f"{totals['rows']} rows of {totals['examples']} examples: " + ", ".join(
        f"{totals[kind]} {kind}" for kind in ("ok", "deviates", "missing")
    ))  # fmt: skip
    return "\n".join(lines)


def _totals(found: Sequence[Example]) -> dict[str, int]:
    sums = {kind: sum(example.counts[kind] for example in found) for kind in ("ok", "deviates", "missing")}
    not_met = sum(not row.met for example in found for row in example.rows)
    return {"examples": len(found), "rows": sum(len(e.rows) for e in found), **sums, "not_met": not_met}
