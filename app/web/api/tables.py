"""The standard tables: factors, limits and charts of standards and handbooks."""

from typing import Annotated

from fastapi import APIRouter, Path, Query

from app.services.tables import TableChart, TableEntry
from app.web.api.library_models import ChartTableAnswer, CurveAnswer, GridAnswer, TableAnswer, TableSummaryAnswer
from app.web.api.models import Page
from app.web.deps import Limit, Offset, Tables
from app.web.errors import problems

router = APIRouter(prefix="/tables", tags=["tables"])

Key = Annotated[str, Path(max_length=100, description="Key of a table, for example duty_types")]


@router.get("", operation_id="listTables", responses=problems(422), summary="List the standard tables")
def list_tables(
    tables: Tables,
    q: Annotated[str, Query(max_length=200, description="Words that all occur in title, note, source or key")] = "",
    topic: Annotated[str, Query(max_length=60, description="Only this topic; empty: all")] = "",
    limit: Limit = 50,
    offset: Offset = 0,
) -> Page[TableSummaryAnswer]:
    """Every standard table, by topic, without its values."""
    found = tables.entries(q, topic)
    items = [TableSummaryAnswer(**_summary(one)) for one in found[offset : offset + limit]]
    return Page(items=items, total=len(found), limit=limit, offset=offset)


@router.get("/{key}", operation_id="getTable", responses=problems(404, 422), summary="Show a standard table")
def get_table(key: Key, tables: Tables) -> TableAnswer:
    """One standard table: its values as they are kept, as rows and columns, and as curves where it is a chart."""
    found = tables.table(key)
    return TableAnswer(
        **_summary(found.entry), data=found.payload, chart=None if found.chart is None else _chart(found.chart),
        grids=[GridAnswer.model_validate(grid) for grid in found.grids],
    )  # fmt: skip


def _summary(entry: TableEntry) -> dict[str, str]:
    return {
        "key": entry.key, "title": entry.title, "topic": entry.topic.name, "unit": entry.unit, "note": entry.note,
        "source": entry.source,
    }  # fmt: skip


def _chart(chart: TableChart) -> ChartTableAnswer:
    return ChartTableAnswer(
        x=chart.x, family=chart.family, value=chart.value, clamped=chart.table.clamped, source=chart.table.source,
        curves=[CurveAnswer(family=family, points=list(points)) for family, points in chart.table.curves],
    )  # fmt: skip
