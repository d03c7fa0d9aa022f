"""A cycle as a table of time and position, or of time and speed, read from text.

::

    time [ms];position [mm];payload [kg];force [N]
    0;0;20;0
    10;0,4;20;0
    20;1,6;20;150

The header carries the units, a column is divided by ``;``, a decimal sign is ``.`` or ``,``. ``payload`` and
``force`` (for a rotary profile ``inertia`` and ``torque``) may be left out; a row's value holds until the next row. A
process force resists the motion.

Positions are met exactly: the speed at each row is estimated from the rows around it, and between two rows the axis
has two segments of constant acceleration whose mean speed is the one the positions demand. The estimate at a row is
the median of three: that of a parabola through the row and its neighbours, and constant acceleration continued from
the two intervals before and from the two after. All three agree where the acceleration is constant, and where it
jumps at a row (the corner of a trapezoid) two of them do. A profile of trapezoids sampled at its corners is therefore
found again exactly; a plain parabola would report up to 25 % too much acceleration there. A profile of speeds runs
straight between its rows.

Noise of measured positions is amplified by differentiating twice, here as everywhere: smooth it before.
"""

import math
from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal, NoReturn

import numpy as np
from pydantic import StringConstraints

from app.engine.errors import MotionError, UnitError
from app.engine.motion.base import MotionModel
from app.engine.motion.move import HOLD_LABELS
from app.engine.motion.profile import FloatArray, MotionProfile
from app.engine.motion.segments import Burden, Hold, Segments
from app.engine.quantity import Option, Quantity, parse_number
from app.engine.sheet import Sheet

MIN_ROWS, MAX_ROWS = 3, 20_000
MAX_TEXT = 900_000
SHOWN_ERRORS = 5
_STILL = 1e-9
"""Speed below which the axis stands, as a share of the highest speed."""

_COLUMNS: dict[str, tuple[tuple[str, Literal["linear", "rotary", "either"]], ...]] = {
    "time": (("s", "either"),),
    "position": (("m", "linear"), ("deg", "rotary")),
    "speed": (("m/s", "linear"), ("rpm", "rotary")),
    "payload": (("kg", "linear"),),
    "force": (("N", "linear"),),
    "inertia": (("kg m2", "rotary"),),
    "torque": (("N m", "rotary"),),
}
"""Column -> the units it may have, and what they say about the motion."""


@dataclass(frozen=True)
class _Column:
    name: str
    kind: str
    quantity: Quantity
    unit: str


class CsvProfile(MotionModel):
    """A cycle as a table; the unit of position or speed decides whether it is linear or rotary."""

    kind: Literal["csv"] = "csv"
    title: ClassVar[str] = "Profile from a table"
    summary: ClassVar[str] = "A measured or computed course: time and position or speed, with units in the header."
    motion_kind: ClassVar[Literal["linear", "rotary", "either"]] = "either"

    text: Annotated[
        str,
        StringConstraints(max_length=MAX_TEXT),
        Option(
            about="Table: time and position or speed, columns divided by ; and units in the header", group="Profile"
        ),
    ]
    hold: Annotated[
        Hold,
        Option(default="motor", source="usual for short pauses", about="What holds while the axis stands",
               labels=HOLD_LABELS, group="Profile"),
    ]  # fmt: skip

    def solve(self, sheet: Sheet) -> MotionProfile:
        """Read the table and turn it into segments; see :class:`MotionModel`. Errors name line and column."""
        table = _read(self.text)
        columns = {column.name: values for column, values in table}
        kind: Literal["linear", "rotary"] = "rotary" if any(c.kind == "rotary" for c, _ in table) else "linear"
        time = columns["time"] - columns["time"][0]
        steps = np.diff(time)
        if "position" in columns:
            speeds, borders, rows = _speeds_of_positions(columns["position"], steps)
        else:
            speeds, borders, rows = columns["speed"], steps, np.arange(len(steps))
        peak = float(np.abs(speeds).max())
        if peak == 0:
            _refuse("the axis never moves")
        speeds = np.where(np.abs(speeds) <= _STILL * peak, 0.0, speeds)
        zeros = np.zeros_like(time)
        payload = columns.get("payload", columns.get("inertia", zeros))
        force = columns.get("force", columns.get("torque", zeros))
        with sheet.section("Motion"):
            self._describe(sheet, table, speeds, peak)
        return self._segments(kind, speeds, borders, payload[rows], force[rows])

    def _describe(self, sheet: Sheet, table: list[tuple[_Column, FloatArray]], speeds: FloatArray, peak: float) -> None:
        names = ", ".join(f"{column.name} [{column.unit}]" for column, _ in table)
        how = (
            "every position is met; two segments of constant acceleration between rows"
            if any(column.name == "position" for column, _ in table)
            else "the speed runs straight between rows"
        )
        sheet.decide(f"Profile of {len(table[0][1])} rows: {names}", how)
        if abs(speeds[0] - speeds[-1]) > 0.01 * peak:
            sheet.decide(
                "The profile does not end at the speed at which it starts",
                "repeated as a cycle the speed would jump; the jump is not judged",
            )

    def _segments(
        self, kind: Literal["linear", "rotary"], speeds: FloatArray, steps: FloatArray, payload: FloatArray,
        force: FloatArray,
    ) -> MotionProfile:  # fmt: skip
        segments = Segments(kind)
        moving = speeds[np.nonzero(speeds)[0][0]]
        direction = math.copysign(1.0, moving)
        rows = zip(steps.tolist(), speeds.tolist(), speeds[1:].tolist(), payload.tolist(), force.tolist(), strict=False)
        for step, before, after, carried, against in rows:
            burden = Burden(carried, against)
            if before == after == 0:
                braked = self.hold == "brake"
                label = f"standstill, {self.hold} holds"
                segments.add(step, 0.0, 0.0, burden, against, direction, label, braked=braked)
                continue
            # A segment keeps its direction: one that passes zero speed is divided there.
            parts = [(step, before, after)]
            if before * after < 0:
                turn = step * before / (before - after)
                parts = [(turn, before, 0.0), (step - turn, 0.0, after)]
            for duration, start, end in parts:
                direction = math.copysign(1.0, start + end)
                label = _label(start, end, direction)
                segments.add(duration, start, end, burden, against, direction, label)
        return segments.profile()


def _label(start: float, end: float, direction: float) -> str:
    way = "forward" if direction > 0 else "backward"
    if math.isclose(start, end, rel_tol=1e-6):
        return f"{way}: constant speed"
    return f"{way}: {'accelerating' if abs(end) > abs(start) else 'decelerating'}"


def _speeds_of_positions(position: FloatArray, steps: FloatArray) -> tuple[FloatArray, FloatArray, Any]:
    """Speeds at the rows and midway, lengths of the half intervals, and the row that each half belongs to."""
    mean = np.diff(position) / steps
    change = np.diff(mean) / ((steps[1:] + steps[:-1]) / 2)  # acceleration at the inner rows
    inner = (steps[1:] * mean[:-1] + steps[:-1] * mean[1:]) / (steps[1:] + steps[:-1])
    before, after = np.full_like(inner, np.nan), np.full_like(inner, np.nan)
    before[1:] = mean[1:-1] + change[:-1] * steps[1:-1] / 2
    after[:-1] = mean[1:-1] - change[1:] * steps[1:-1] / 2
    # The outermost inner rows lack one estimate: of the other two, the one nearer to the outer mean speed is taken.
    before[0] = mean[0] if len(inner) > 1 else inner[0]
    after[-1] = mean[-1] if len(inner) > 1 else inner[-1]
    speed = np.median([before, inner, after], axis=0)
    nodes = np.concatenate(([2 * mean[0] - speed[0]], speed, [2 * mean[-1] - speed[-1]]))
    middle = 2 * mean - (nodes[:-1] + nodes[1:]) / 2
    speeds = np.empty(2 * len(steps) + 1)
    speeds[0::2], speeds[1::2] = nodes, middle
    return speeds, np.repeat(steps / 2, 2), np.repeat(np.arange(len(steps)), 2)


def _refuse(message: str) -> NoReturn:
    raise MotionError(message, field=("text",))


def _read(text: str) -> list[tuple[_Column, FloatArray]]:
    """Columns of the table with their values in SI. Raises MotionError with line and column."""
    lines = [(number, line) for number, line in enumerate(text.splitlines(), 1) if line.replace(";", "").strip()]
    if not lines:
        _refuse("the table is empty: give a header such as time [s];position [mm], and rows")
    columns = _header(lines[0][1], lines[0][0])
    rows = lines[1:]
    if not MIN_ROWS <= len(rows) <= MAX_ROWS:
        _refuse(f"the table has {len(rows)} rows; {MIN_ROWS} to {MAX_ROWS} are needed")
    values = np.zeros((len(rows), len(columns)))
    errors: list[str] = []
    for index, (number, line) in enumerate(rows):
        cells = line.split(";")
        if len(cells) > len(columns) and not "".join(cells[len(columns) :]).strip():
            cells = cells[: len(columns)]
        if len(cells) != len(columns):
            errors.append(f"line {number}: {len(cells)} columns instead of {len(columns)}")
            continue
        for place, (cell, column) in enumerate(zip(cells, columns, strict=True)):
            try:
                values[index, place] = _cell(cell, column)
            except UnitError as error:
                errors.append(f"line {number}, column {place + 1} ({column.name}): {error.message}")
    if not errors:
        errors = _wrong_times(values[:, [c.name for c in columns].index("time")], [number for number, _ in rows])
    if errors:
        more = f"; and {len(errors) - SHOWN_ERRORS} more" if len(errors) > SHOWN_ERRORS else ""
        _refuse("; ".join(errors[:SHOWN_ERRORS]) + more)
    return [
        (column, values[:, index] * column.quantity.to_si(f"1 {column.unit}")) for index, column in enumerate(columns)
    ]


def _cell(cell: str, column: _Column) -> float:
    number = parse_number(cell)
    if not math.isfinite(number) or abs(number) > 1e12:
        raise UnitError(f"{cell.strip()[:30]!r} is not a plausible number")
    if number < 0 and column.name in ("payload", "inertia"):
        raise UnitError(f"{cell.strip()[:30]!r} is negative")
    return number


def _wrong_times(time: FloatArray, lines: list[int]) -> list[str]:
    wrong = np.nonzero(np.diff(time) <= 0)[0]
    return [f"line {lines[index + 1]}: the time does not increase" for index in wrong.tolist()]


def _header(line: str, number: int) -> list[_Column]:
    """Columns that the header names; each ``name [unit]``."""
    columns = [_column(text, number, place) for place, text in enumerate(line.rstrip("; \t").split(";"), 1)]
    names = [column.name for column in columns]
    doubled = next((name for name in names if names.count(name) > 1), None)
    if doubled:
        _refuse(f"line {number}: the column {doubled} stands twice")
    if "time" not in names:
        _refuse(f"line {number}: there is no column time [s]")
    if ("position" in names) == ("speed" in names):
        _refuse(f"line {number}: there must be either a column position or a column speed")
    kinds = {column.kind for column in columns} - {"either"}
    if len(kinds) > 1:
        _refuse(f"line {number}: linear and rotary columns are mixed")
    return columns


def _column(text: str, line: int, place: int) -> _Column:
    name, bracket, rest = text.strip().lstrip("\ufeff").partition("[")
    name, unit = name.strip().lower(), rest.strip().removesuffix("]").strip()
    where = f"line {line}, column {place}"
    if name not in _COLUMNS:
        _refuse(f"{where}: {name[:30]!r} is none of the columns {', '.join(_COLUMNS)}")
    if not bracket or not unit:
        _refuse(f"{where}: {name} needs a unit, such as {name} [{_COLUMNS[name][0][0]}]")
    for wanted, kind in _COLUMNS[name]:
        quantity = Quantity(wanted)
        try:
            quantity.to_si(f"1 {unit}")
        except UnitError:
            continue
        return _Column(name, kind, quantity, unit)
    units = " or ".join(wanted for wanted, _ in _COLUMNS[name])
    _refuse(f"{where}: {unit[:30]!r} is no unit of {name}; give for instance {units}")
