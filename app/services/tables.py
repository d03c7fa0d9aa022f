"""Standard tables for readers: which there are, and one as rows, columns and curves."""

import textwrap
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from sqlalchemy.orm import Session

from app.catalog.repository import CatalogRepository, ProductNotFoundError, StandardTableSummary
from app.catalog.standards import chart_table
from app.engine.tables import Table
from app.reports.numbers import number, unit_text
from app.services.errors import NotFoundError
from app.services.table_shapes import Column, Grid, grids, text_of

_SHORT = 160
_DIGITS = 10
_CLOSE = 1e-6
"""Two points of a chart that lie nearer than this are the two sides of a step."""


@dataclass(frozen=True)
class TableTopic:
    """What a group of tables is about."""

    name: str
    title: str
    begins: tuple[str, ...] = ()
    """How the keys of its tables begin."""


TOPICS = (
    TableTopic("duty", "Duty and rating of motors", (
        "duty_", "motor_power_", "power_increase_", "motor_rating_", "derating", "starting_",
    )),
    TableTopic("motors", "Data and sizes of motors", (
        "iec_60034_", "iec_ts_60034_", "cemep_", "pole_changing_", "synchronous_", "preferred_powers", "shaft_height",
    )),
    TableTopic("protection", "Protection of motors", ("insulation_", "degrees_of_protection", "motor_protection")),
    TableTopic("brakes", "Brakes", ("brake_",)),
    TableTopic("gear_units", "Gear units", ("service_factor_", "load_class_", "overhung_", "worm_", "iec_am_")),
    TableTopic("friction", "Friction and efficiency", (
        "bearing_friction", "rolling_friction", "sliding_friction", "wheel_", "transmission_efficiency",
    )),
    TableTopic("conveyors", "Belt conveyors", ("din_22101_", "belt_conveyor_")),
)  # fmt: skip
OTHER = TableTopic("other", "Other tables")
"""For tables that an operator loads besides those of this catalogue."""


@dataclass(frozen=True)
class TableEntry:
    """One table in the list."""

    key: str
    title: str
    topic: TableTopic
    unit: str
    note: str
    source: str

    @property
    def summary(self) -> str:
        """How the note begins: its first sentence, shortened."""
        first, dot, _ = self.note.partition(". ")
        return textwrap.shorten(first + dot.strip(), _SHORT, placeholder=" …")


@dataclass(frozen=True)
class TableChart:
    """A table whose values are curves."""

    table: Table
    x: str
    """What runs along the curves, in words, with its unit behind "in"."""
    family: str
    """What tells the curves apart; empty where there is one."""
    value: str
    """What is read."""


@dataclass(frozen=True)
class ShownTable:
    """One table with its values, ready to show."""

    entry: TableEntry
    payload: Any
    chart: TableChart | None
    """None where the values are no curves."""
    grids: tuple[Grid, ...]


class TableService:
    """Reads standard tables."""

    def __init__(self, session: Session) -> None:
        self._catalogue = CatalogRepository(session)

    def entries(self, text: str = "", topic: str = "") -> list[TableEntry]:
        """Tables by topic and title: those of a topic, or of all, whose texts hold every word of ``text``."""
        wanted = text.casefold().split()
        found = [_entry(record) for record in self._catalogue.standard_tables()]
        found = [one for one in found if topic in ("", one.topic.name) and _holds(one, wanted)]
        order = [*TOPICS, OTHER]
        return sorted(found, key=lambda one: (order.index(one.topic), one.title.casefold(), one.key))

    def table(self, key: str) -> ShownTable:
        """One table. Raises NotFoundError."""
        try:
            record = self._catalogue.standard_table(key)
        except ProductNotFoundError as error:
            raise NotFoundError("The catalogue that is loaded holds no such table.") from error
        entry = _entry(record)
        chart = _chart(record.payload, entry)
        shown = (chart_grid(chart),) if chart is not None else grids(record.payload, entry.unit)
        return ShownTable(entry, record.payload, chart, shown)


def topic_of(key: str) -> TableTopic:
    """The topic that a table belongs to.

    >>> topic_of("duty_types").title, topic_of("of_my_own").title
    ('Duty and rating of motors', 'Other tables')
    """
    return next((topic for topic in TOPICS if key.startswith(topic.begins)), OTHER)


def _entry(record: StandardTableSummary) -> TableEntry:
    unit = "%" if record.unit == "percent" else unit_text(record.unit or "1")
    return TableEntry(record.key, record.title, topic_of(record.key), unit, record.note or "", record.source)


def _holds(entry: TableEntry, wanted: Sequence[str]) -> bool:
    text = " ".join((entry.key, entry.title, entry.note, entry.source)).casefold()
    return all(word in text for word in wanted)


def _chart(payload: Any, entry: TableEntry) -> TableChart | None:
    """The chart that the values make; None where they are no curves."""
    table = chart_table(entry.key, entry.title, entry.source, payload)
    if table is None:
        return None
    return TableChart(table, *(_typeset(str(payload.get(name) or "")) for name in ("x", "family", "value")))


def _typeset(label: str) -> str:
    """The words of an axis with their unit as it is written for readers."""
    words, _, unit = label.rpartition(" in ")
    return f"{words} in {unit_text(unit)}" if words and len(unit) < len("kg m2/s2") else label


# Points as a table ---------------------------------------------------------------------------------------------------
def chart_grid(chart: TableChart) -> Grid:
    """Every point of a chart: one row per place on the x axis, one column per curve."""
    curves = chart.table.curves
    places = sorted({x for _, points in curves for x, _ in points})
    columns = [[text_of([y for x, y in points if x == at]) for at in places] for _, points in curves]
    single = len(curves) == 1
    heads = [chart.value or "Value"] if single else [number(family, _DIGITS) for family, _ in curves]
    return Grid(
        title="",
        columns=tuple(_column(head) for head in (chart.x, *heads)),
        rows=tuple(zip(map(place, places), *columns, strict=True)),
        groups=() if single else (("", 1), (chart.family, len(curves))),
    )


def place(x: float) -> str:
    """A place on the x axis; what lies next to a round number only to make a step is said to be below or above it.

    >>> place(200.0), place(19.999999), place(2000.000001)
    ('200', 'below 20', 'above 2000')
    """
    near = float(f"{x:.6g}")
    if near == x or abs(x - near) > _CLOSE * abs(near):
        return number(x, _DIGITS)
    return f"{'below' if x < near else 'above'} {number(near, _DIGITS)}"


def _column(label: str) -> Column:
    words, _, unit = (label[:1].upper() + label[1:]).rpartition(" in ")
    return Column(words, unit, numeric=True) if words else Column(unit, "", numeric=True)


def by_topic(entries: Sequence[TableEntry]) -> Iterator[tuple[TableTopic, list[TableEntry]]]:
    """The entries of a list by topic, in its order."""
    for topic in dict.fromkeys(one.topic for one in entries):
        yield topic, [one for one in entries if one.topic == topic]
