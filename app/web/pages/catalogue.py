"""The catalogue as printed: kinds of product, pages of rows, single products, editions."""

from dataclasses import dataclass
from typing import Annotated, Any
from urllib.parse import urlencode

from fastapi import APIRouter, Query, Request, Response

from app.catalog.browse import BrowseQuery
from app.catalog.filters import ProductFilter
from app.catalog.repository import EditionSummary
from app.catalog.schema import ColumnSpec
from app.reports.numbers import ABSENT, unit_text
from app.services.browsing import TableSummary
from app.web.deps import Browsing
from app.web.templating import page

router = APIRouter()
PAGE_SIZE = 50
_NAMES = ("manufacturer", "series", "model")
MAX_PAGE = 1_000_000


@dataclass(frozen=True)
class CataloguePage:
    """Context of ``catalogue/kinds.html``."""

    tables: tuple[TableSummary, ...]
    editions: tuple[EditionSummary, ...]


@dataclass(frozen=True)
class ColumnView:
    """A column of the list."""

    name: str
    label: str
    unit: str
    numeric: bool
    url: str
    sorted: str
    """``ascending``, ``descending`` or empty."""


@dataclass(frozen=True)
class RowView:
    """A product in the list."""

    url: str
    cells: tuple[tuple[str, bool], ...]


@dataclass(frozen=True)
class TablePage:
    """Context of ``catalogue/table.html``."""

    kind: str
    title: str
    columns: tuple[ColumnView, ...]
    rows: tuple[RowView, ...]
    total: int
    page: int
    pages: int
    text: str
    makers: tuple[str, ...]
    maker: str
    sort: str
    descending: bool
    earlier: str
    later: str


@dataclass(frozen=True)
class ProductPage:
    """Context of ``catalogue/product.html``."""

    kind: str
    kind_title: str
    name: str
    lines: tuple[tuple[str, str, tuple[str, ...]], ...]
    """Label, meaning, and the value at each operating point."""


@router.get("/catalogue")
def show_catalogue(request: Request, browsing: Browsing) -> Response:
    """Every kind of product, and every edition with its source."""
    return page(request, "catalogue/kinds.html", CataloguePage(tuple(browsing.tables()), tuple(browsing.editions())))


@router.get("/catalogue/{kind}")
def show_table(
    request: Request,
    kind: str,
    browsing: Browsing,
    text: Annotated[str, Query(max_length=200)] = "",
    maker: Annotated[str, Query(max_length=200)] = "",
    sort: Annotated[str, Query(max_length=80)] = "",
    descending: bool = False,
    number: Annotated[int, Query(alias="page", ge=1, le=MAX_PAGE)] = 1,
) -> Response:
    """A page of one kind: searched, filtered, sorted."""
    wanted = ProductFilter(manufacturers=(maker,) if maker else (), text=text)
    query = BrowseQuery(filter=wanted, sort=sort, descending=descending, page=number, page_size=PAGE_SIZE)
    found, makers = browsing.page(kind, query), browsing.makers(kind)
    chosen = {"text": text, "maker": maker}

    def url(**more: Any) -> str:
        entries = {"sort": sort, "descending": "true" if descending else "", **more}
        return f"/catalogue/{kind}?" + urlencode(
            {k: v for k, v in {**chosen, **entries}.items() if v not in ("", None)}
        )

    columns = [one for one in found.columns if one.name != "note"]
    context = TablePage(
        kind=kind, title=found.title, total=found.total, page=found.page, pages=found.pages, text=text,
        makers=tuple(makers), maker=maker, sort=sort, descending=descending,
        columns=tuple(
            ColumnView(
                one.name, one.meaning.label, _unit(one), one.type != "text",
                url(sort=one.name, descending="true" if sort == one.name and not descending else ""),
                "" if sort != one.name else "descending" if descending else "ascending",
            )
            for one in columns
        ),
        rows=tuple(
            RowView(f"/catalogue/{kind}/{row['id']}", tuple((shown(row[c.name]), c.type != "text") for c in columns))
            for row in found.rows
        ),
        earlier=url(page=found.page - 1) if found.page > 1 else "",
        later=url(page=found.page + 1) if found.page < found.pages else "",
    )  # fmt: skip
    return page(request, "catalogue/table.html", context)


@router.get("/catalogue/{kind}/{product_id:path}")
def show_product(request: Request, kind: str, product_id: str, browsing: Browsing) -> Response:
    """One product with everything its source says."""
    found = browsing.product(kind, product_id)
    first = found.rows[0]
    lines = [
        (
            column.meaning.label + (f" [{_unit(column)}]" if _unit(column) else ""),
            column.meaning.about,
            tuple(dict.fromkeys(shown(row[column.name]) for row in found.rows)),
        )
        for column in found.columns
    ]
    lines.append(("Edition", "", (str(first["edition"]),)))
    name = " ".join(str(first[part]) for part in _NAMES if first.get(part))
    return page(request, "catalogue/product.html", ProductPage(kind, found.title, name, tuple(lines)))


def _unit(column: ColumnSpec) -> str:
    return unit_text(column.unit) if column.unit and column.unit != "1" else ""


def shown(value: Any) -> str:
    """A value as printed.

    >>> [shown(value) for value in (None, 4.90, "sync", 3)]
    ['–', '4.9', 'sync', '3']
    """
    if value is None or value == "":
        return ABSENT
    return f"{value:.10g}" if isinstance(value, float) else str(value)
