"""The catalogue as printed: kinds, products, editions."""

from typing import Annotated

from fastapi import APIRouter, Path, Query

from app.catalog.browse import BrowseQuery
from app.catalog.filters import ProductFilter
from app.catalog.schema import ColumnSpec
from app.web.api.library_models import ColumnAnswer, EditionAnswer, KindAnswer, ProductAnswer, ProductPage
from app.web.api.models import Page
from app.web.deps import Browsing, Limit, Offset
from app.web.errors import problems

router = APIRouter(prefix="/catalog", tags=["catalogue"])

Kind = Annotated[str, Path(max_length=60, description="Kind of product, for example servo_motor")]
ProductKey = Annotated[str, Path(max_length=300, description="Identifier of a product")]
Texts = Annotated[list[str], Query(max_length=50)]


@router.get("", operation_id="listKinds", summary="List the kinds of products")
def list_kinds(browsing: Browsing) -> list[KindAnswer]:
    """Every kind of product and how many there are."""
    return [KindAnswer.model_validate(table) for table in browsing.tables()]


@router.get("/editions", operation_id="listEditions", responses=problems(422), summary="List the editions")
def list_editions(browsing: Browsing, limit: Limit = 50, offset: Offset = 0) -> Page[EditionAnswer]:
    """Every catalogue edition that is loaded, with its source."""
    found = browsing.editions()
    items = [EditionAnswer.model_validate(edition) for edition in found[offset : offset + limit]]
    return Page(items=items, total=len(found), limit=limit, offset=offset)


@router.get("/{kind}", operation_id="listProducts", responses=problems(404, 422), summary="List products")
def list_products(
    kind: Kind,
    browsing: Browsing,
    q: Annotated[str, Query(max_length=200, description="Words that all occur in maker, series or order code")] = "",
    manufacturer: Annotated[Texts, Query(description="Makers that are wanted; none: all")] = [],  # noqa: B006
    series: Annotated[Texts, Query(description="Series that are wanted; none: all")] = [],  # noqa: B006
    sort: Annotated[str, Query(max_length=60, description="Column; empty: as printed")] = "",
    descending: bool = False,
    limit: Limit = 50,
    offset: Offset = 0,
) -> ProductPage:
    """Products of one kind as printed, in the units of their columns."""
    wanted = ProductFilter(manufacturers=manufacturer, series=series, text=q)
    query = BrowseQuery(filter=wanted, sort=sort, descending=descending, page_size=limit, offset=offset)
    page = browsing.page(kind, query)
    return ProductPage(
        kind=kind, title=page.title, columns=_columns(page.columns), items=page.rows, total=page.total, limit=limit,
        offset=offset,
    )  # fmt: skip


@router.get("/{kind}/{product_id}", operation_id="getProduct", responses=problems(404, 422), summary="Show a product")
def get_product(kind: Kind, product_id: ProductKey, browsing: Browsing) -> ProductAnswer:
    """One product as printed, with its source."""
    found = browsing.product(kind, product_id)
    return ProductAnswer(kind=kind, title=found.title, columns=_columns(found.columns), rows=found.rows)


def _columns(columns: list[ColumnSpec]) -> list[ColumnAnswer]:
    return [
        ColumnAnswer(
            name=c.name, label=c.meaning.label, about=c.meaning.about, unit=c.meaning.unit, symbol=c.meaning.symbol
        )
        for c in columns
    ]
