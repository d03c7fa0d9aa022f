"""Worked examples of published sources: printed, computed, deviation, and what is wrong in the source."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any
from urllib.parse import urlencode

from fastapi import APIRouter, Request, Response

from app.reports.numbers import ABSENT, number, unit_text
from app.services.examples import Example, ExampleFile, ExampleRow
from app.web.deps import Examples
from app.web.form_data import flat
from app.web.templating import page

router = APIRouter()

STATUS_WORDS = {
    "agrees": "the source is right",
    "rounding": "the source rounds",
    "slip": "the source errs",
    "derived": "not in the source",
}
PRODUCED_WORDS = {"ok": "agrees", "deviates": "deviates", "missing": "not computed"}
PRODUCED_ICONS = {"ok": "✓", "deviates": "✗", "missing": "?"}


@dataclass(frozen=True)
class ExampleLine:
    """One example in the list."""

    file: ExampleFile
    slips: int


@dataclass(frozen=True)
class RowView:
    """One number of an example."""

    name: str
    unit: str
    printed: str
    expected: str
    computed: str
    deviation: str
    status: str
    status_word: str
    produced: str
    produced_word: str
    icon: str
    note: str


@dataclass(frozen=True)
class RequestView:
    """One request of an example with its entries and the way into the workbench."""

    name: str
    title: str
    url: str
    inputs: tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class ExamplesPage:
    """Context of ``examples/list.html``."""

    examples: tuple[ExampleLine, ...]


@dataclass(frozen=True)
class ExamplePage:
    """Context of ``examples/one.html``."""

    file: ExampleFile
    rows: tuple[RowView, ...]
    requests: tuple[RequestView, ...]
    counts: dict[str, int]


@router.get("/examples")
def list_examples(request: Request, examples: Examples) -> Response:
    """Every worked example with the number of slips in its source."""
    lines = [ExampleLine(one, sum(row.status == "slip" for row in one.rows)) for one in examples.files()]
    return page(request, "examples/list.html", ExamplesPage(tuple(lines)))


@router.get("/examples/{example_id}")
def show_example(request: Request, example_id: str, examples: Examples) -> Response:
    """One worked example, recomputed now."""
    found = examples.run(example_id)
    rows = tuple(row_view(row) for row in found.rows)
    context = ExamplePage(found.file, rows, tuple(request_views(found)), found.counts)
    return page(request, "examples/one.html", context)


def row_view(row: ExampleRow) -> RowView:
    """One number made ready for reading."""
    printed = row.printed if isinstance(row.printed, str) else _number(row.printed)
    return RowView(
        name=row.name.replace("_", " "), unit=unit_text(row.unit) if row.unit not in ("1", "-") else "",
        printed=printed, expected=_number(row.expected), computed=_number(row.computed),
        deviation=ABSENT if row.deviation is None else f"{row.deviation:.1e}",
        status=row.status, status_word=STATUS_WORDS.get(row.status, row.status), produced=row.produced,
        produced_word=PRODUCED_WORDS[row.produced], icon=PRODUCED_ICONS[row.produced], note=row.note or row.reason,
    )  # fmt: skip


def request_views(example: Example) -> list[RequestView]:
    """The requests of an example."""
    views = []
    for name, raw in example.file.requests.items():
        query = urlencode({"example": example.file.id, "request": name})
        entries = tuple((path, value) for path, value in flat(raw) if not path.endswith("._row"))
        views.append(RequestView(name, str(raw.get("name") or name.replace("_", " ")), _url(raw, query), entries))
    return views


def _url(raw: Mapping[str, Any], query: str) -> str:
    """Where a request is opened: an axis in the workbench, formulas in the calculation."""
    if "calculation" in raw:
        return f"/calculation?{query}"
    return f"/supply?{query}" if "axes" in raw else f"/workbench/{raw['mechanism']['kind']}?{query}"


def _number(value: float | None) -> str:
    return ABSENT if value is None or value != value else number(value)
