"""Shapes of answers about what is kept or published: catalogue, projects, examples and formulas."""

from datetime import datetime
from typing import Any, Literal

from pydantic import Field

from app.services.documents import ProjectDocument
from app.web.api.models import Answer, Page


# Catalogue -----------------------------------------------------------------------------------------------------------
class KindAnswer(Answer):
    """One kind of product."""

    kind: str
    title: str
    count: int


class EditionAnswer(Answer):
    """One loaded edition with its source."""

    key: str
    maker: str
    citation: str
    date: str | None
    url: str | None
    licence: str | None
    note: str | None
    checksum: str
    rows: dict[str, int]


class ColumnAnswer(Answer):
    """One column of a table of products."""

    name: str
    label: str
    about: str
    unit: str | None
    symbol: str


class ProductPage(Page[dict[str, Any]]):
    """Products as printed: every column by name, null where the source does not say."""

    kind: str
    title: str
    columns: list[ColumnAnswer]


class ProductAnswer(Answer):
    """One product as printed; several rows where it has several operating points."""

    kind: str
    title: str
    columns: list[ColumnAnswer]
    rows: list[dict[str, Any]]


# Standard tables -----------------------------------------------------------------------------------------------------
class TableSummaryAnswer(Answer):
    """One standard table."""

    key: str
    title: str
    topic: str = Field(description="Name of the topic, as the list takes it")
    unit: str = Field(description="Unit of values that do not name their own; may be empty")
    note: str = Field(description="What it is for and how it is used")
    source: str


class CurveAnswer(Answer):
    """One curve of a chart."""

    family: float
    points: list[tuple[float, float]] = Field(description="(x, value) by rising x; straight lines between them")


class ChartTableAnswer(Answer):
    """A table whose values are curves."""

    x: str = Field(description="What runs along the curves")
    family: str = Field(description="What tells the curves apart; empty where there is one")
    value: str = Field(description="What is read")
    clamped: bool = Field(description="Whether the end values hold beyond the ends; otherwise there is no value there")
    source: str
    curves: list[CurveAnswer]


class GridColumnAnswer(Answer):
    """Heading of a column."""

    label: str
    unit: str
    numeric: bool


class GridAnswer(Answer):
    """The values as a rectangular table of texts."""

    title: str
    groups: list[tuple[str, int]] = Field(
        description="Upper line of headings: text and number of columns; may be empty"
    )
    columns: list[GridColumnAnswer]
    row_headings: int = Field(description="How many columns at the beginning head their row")
    rows: list[list[str]]


class TableAnswer(TableSummaryAnswer):
    """One standard table with its values."""

    data: Any = Field(description="The values in the shape in which they are kept")
    chart: ChartTableAnswer | None = Field(description="null where the values are no curves")
    grids: list[GridAnswer]


# Projects ------------------------------------------------------------------------------------------------------------
class ProjectAnswer(Answer):
    """A project at one revision."""

    title: str
    version: int
    newest_version: int
    can_edit: bool
    created_at: datetime
    saved_at: datetime
    comment: str | None
    engine_version: str
    catalogue_editions: list[dict[str, Any]]
    view_token: str = Field(description="Opens the project for viewing")
    document: ProjectDocument


class NewProjectAnswer(ProjectAnswer):
    """A new project. The edit token is told only here; the server keeps no copy of it."""

    edit_token: str


class RevisionAnswer(Answer):
    """One save of a project."""

    number: int
    saved_at: datetime
    comment: str | None
    engine_version: str


class DifferenceAnswer(Answer):
    """A value that differs between two revisions."""

    path: list[str | int]
    before: Any
    after: Any


class ComparisonAnswer(Answer):
    """What differs between two revisions."""

    first: int
    second: int
    differences: list[DifferenceAnswer]


# Examples and formulas -----------------------------------------------------------------------------------------------
class ExampleSummary(Answer):
    """One worked example."""

    id: str
    title: str
    source: str
    summary: str


class ExampleRowAnswer(Answer):
    """One number of a worked example: as printed, as expected after recomputation, and as computed here."""

    name: str
    symbol: str
    unit: str
    printed: float | str | None
    expected: float | None
    computed: float | None
    deviation: float | None = Field(description="Relative deviation of computed from expected")
    tolerance: float
    status: str = Field(description="agrees, rounding, slip or derived: how the printed number stands to the exact one")
    produced: Literal["ok", "deviates", "missing"]
    reason: str = Field(description="Why a number is missing")
    note: str


class ExampleAnswer(ExampleSummary):
    """One worked example, recomputed."""

    requests: dict[str, dict[str, Any]]
    rows: list[ExampleRowAnswer]


class FormulaSummary(Answer):
    """One formula of the library."""

    name: str
    topic: str
    symbol: str
    unit: str
    summary: str
    source: str


class FormulaArgument(Answer):
    """One argument of a formula."""

    name: str
    symbol: str
    meaning: str
    unit: str


class FormulaAnswer(FormulaSummary):
    """One formula with its arguments and its notation."""

    si_unit: str
    arguments: list[FormulaArgument]
    mathml: list[str]
    typst: list[str]
    notes: list[str]
    example: str
