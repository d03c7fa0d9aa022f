"""The standard tables of the catalogue: a list by topic, and each one with its values, explanation and source."""

from dataclasses import dataclass, replace
from typing import Annotated

from fastapi import APIRouter, Query, Request, Response

from app.charts import drawn, table_figure
from app.services.table_shapes import Grid
from app.services.tables import OTHER, TOPICS, ShownTable, TableChart, TableEntry, TableTopic, by_topic
from app.web.chart_views import ChartView, chart_view
from app.web.deps import Tables
from app.web.templating import Translate, page, translator

router = APIRouter()


@dataclass(frozen=True)
class TablesPage:
    """Context of ``tables/list.html``."""

    groups: tuple[tuple[TableTopic, list[TableEntry]], ...]
    total: int
    topics: tuple[TableTopic, ...]
    text: str
    topic: str


@dataclass(frozen=True)
class OneTablePage:
    """Context of ``tables/one.html``."""

    entry: TableEntry
    grids: tuple[Grid, ...]
    unit: str
    """Unit of all values; empty where columns or values name their own."""
    chart: ChartView | None
    shortened: bool
    """Whether the chart leaves away a part of a level end."""
    clamped: bool
    printed: str
    """Where the points of a chart were printed, if that is told apart from the document."""


@router.get("/tables")
def list_tables(
    request: Request, tables: Tables,
    text: Annotated[str, Query(max_length=200)] = "",
    topic: Annotated[str, Query(max_length=60)] = "",
) -> Response:  # fmt: skip
    """Every table by topic, or those that are asked for."""
    found = tables.entries(text, topic)
    context = TablesPage(tuple(by_topic(found)), len(found), (*TOPICS, OTHER), text, topic)
    return page(request, "tables/list.html", context)


@router.get("/tables/{key}")
def show_table(request: Request, key: str, tables: Tables) -> Response:
    """One table."""
    found = tables.table(key)
    curves = [points for _, points in found.chart.table.curves] if found.chart is not None else []
    a_line = any(len(points) > 1 for points in curves)
    context = OneTablePage(
        entry=found.entry, grids=found.grids, unit=_unit(found),
        chart=_chart(found.chart, translator(request)) if found.chart is not None and a_line else None,
        shortened=any(drawn(points) is not points for points in curves),
        clamped=found.chart is not None and found.chart.table.clamped,
        printed=_printed(found),
    )  # fmt: skip
    return page(request, "tables/one.html", context)


def _chart(chart: TableChart, translate: Translate) -> ChartView:
    made = chart_view(
        chart.table.key.replace("_", "-"), table_figure(chart.table, chart.x, chart.family, chart.value, translate)
    )
    return replace(made, series=())  # the page shows every point as its table


def _unit(found: ShownTable) -> str:
    return "" if any(column.unit for grid in found.grids for column in grid.columns) else found.entry.unit


def _printed(found: ShownTable) -> str:
    source = found.chart.table.source if found.chart is not None else ""
    return source if source != found.entry.source else ""
