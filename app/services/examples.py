"""Worked examples of published sources, run as the ordinary requests that they are.

An example is a file of ``examples/``: requests, and a table of numbers with the place of each in the result. Nothing
in the program knows an example.
"""

import json
import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Annotated, Any, Literal, Protocol

from pydantic import BaseModel, ConfigDict, Field

from app.engine.quantity import from_si
from app.engine.sheet import Sheet
from app.services.calculation import CalculationService
from app.services.errors import InvalidInputError, NotFoundError
from app.services.multi_axis import MultiAxisService
from app.services.reading import read
from app.services.sizing import Headline, SizingService

TOLERANCE = 1e-3
"""Relative deviation from the exact value that is still agreement."""
DEMANDED = ("agrees", "rounding", "slip")
"""Rows of these statuses must be met; ``derived`` ones are further results of the recomputation."""

Produced = Literal["ok", "deviates", "missing"]


class Computed(Protocol):
    """What answers a request of an example: an axis, several axes on one supply, a calculation with formulas."""

    @property
    def sheet(self) -> Sheet:
        """Every step and check."""

    @property
    def headlines(self) -> tuple[Headline, ...]:
        """Results shown before all others."""

    @property
    def asked(self) -> Any:
        """The request, read."""


class Take(BaseModel):
    """Where a number stands in the result."""

    model_config = ConfigDict(extra="forbid", populate_by_name=True)

    request: str = Field(default="main", description="Which of the example's requests")
    origin: Literal["step", "argument", "check", "input", "headline"] = Field(
        alias="from", description="Part of the result"
    )
    key: str = Field(description="Key of the step or check, key.argument of a step, or path of the input")
    side: Literal["demanded", "permitted", "utilisation"] = Field(
        default="demanded", description="Which number of a check"
    )
    factor: float = Field(default=1.0, description="Factor from the number found to the number printed, for signs")


class ExpectedRow(BaseModel):
    """One number of an example."""

    model_config = ConfigDict(extra="allow")

    name: str
    symbol: str = ""
    unit: str = "1"
    printed: float | str | None = None
    exact: float | None = None
    correct: float | None = None
    status: str
    note: str = ""
    take: Take | None = None
    tolerance: float = Field(default=TOLERANCE, gt=0)
    missing: str = ""

    @property
    def expected(self) -> float:
        """The number that a correct calculation gives."""
        found = self.exact if self.correct is None else self.correct
        return math.nan if found is None else found


class ExampleFile(BaseModel):
    """One file of ``examples/``."""

    model_config = ConfigDict(extra="allow")

    id: str
    title: str
    source: str
    summary: str = ""
    requests: Annotated[dict[str, dict[str, Any]], Field(min_length=1)]
    rows: list[ExpectedRow]


@dataclass(frozen=True)
class ExampleRow:
    """One number of an example beside what the program computes; numbers are in ``unit``."""

    name: str
    symbol: str
    unit: str
    printed: float | str | None
    expected: float
    computed: float | None
    tolerance: float
    status: str
    reason: str
    note: str

    @property
    def deviation(self) -> float | None:
        """Relative deviation from the expected number; absolute where zero is expected."""
        if self.computed is None:
            return None
        return abs(self.computed - self.expected) / (abs(self.expected) or 1.0)

    @property
    def produced(self) -> Produced:
        """Whether the number was computed and agrees."""
        if self.computed is None or self.deviation is None:
            return "missing"
        return "ok" if self.deviation <= self.tolerance else "deviates"

    @property
    def met(self) -> bool:
        """Whether the number is as demanded."""
        return self.produced == "ok" or self.status not in DEMANDED


@dataclass(frozen=True)
class Example:
    """One worked example, recomputed."""

    file: ExampleFile
    rows: tuple[ExampleRow, ...]
    computed: Mapping[str, Computed]

    @property
    def counts(self) -> dict[str, int]:
        """How many rows were produced, deviate, or are missing."""
        return {kind: sum(row.produced == kind for row in self.rows) for kind in ("ok", "deviates", "missing")}

    @property
    def met(self) -> bool:
        """Whether every demanded number is met."""
        return all(row.met for row in self.rows)


def examples_folder() -> Path:
    """Where the examples lie: beside ``app/`` in a checkout, else below the working directory."""
    beside = Path(__file__).resolve().parents[2] / "examples"
    return beside if beside.is_dir() else Path.cwd() / "examples"


class ExampleService:
    """Finds and runs the examples of a folder."""

    def __init__(self, sizing: SizingService, folder: Path) -> None:
        self._sizing = sizing
        self._calculations = CalculationService()
        self._multi_axis = MultiAxisService(sizing)
        self._folder = folder

    @cached_property
    def _files(self) -> dict[str, ExampleFile]:
        found = {}
        for path in sorted(self._folder.glob("*.json")):
            example = read(ExampleFile, json.loads(path.read_text(encoding="utf-8")))
            found[example.id] = example
        return found

    def files(self) -> list[ExampleFile]:
        """Every example as it was written, not run."""
        return list(self._files.values())

    def file(self, example_id: str) -> ExampleFile:
        """One example, not run. Raises NotFoundError."""
        found = self._files.get(example_id)
        if found is None:
            raise NotFoundError(f"There is no worked example {example_id!r}.")
        return found

    def run(self, example_id: str) -> Example:
        """One example, recomputed. Raises NotFoundError."""
        file = self.file(example_id)
        computed: dict[str, Computed] = {}
        refused: dict[str, str] = {}
        for name, request in file.requests.items():
            try:
                computed[name] = self._compute(request)
            except InvalidInputError as error:
                refused[name] = "; ".join(f"{e.name} {e.message}" for e in error.errors)
        rows = tuple(_row(row, computed, refused) for row in file.rows)
        return Example(file, rows, computed)

    def _compute(self, request: Mapping[str, Any]) -> Computed:
        """Answer one request, of whatever kind it is."""
        if "calculation" in request:
            return self._calculations.calculate(request)
        if "axes" in request:
            return self._multi_axis.size(request)
        return self._sizing.size(request)

    def run_all(self) -> list[Example]:
        """Every example, recomputed."""
        return [self.run(example_id) for example_id in self._files]


def _row(row: ExpectedRow, found: Mapping[str, Computed], refused: Mapping[str, str]) -> ExampleRow:
    computed, reason = None, row.missing
    if row.take is not None:
        if row.take.request in found:
            computed = _value(row.take, row.unit, found[row.take.request])
            reason = "" if computed is not None else f"the result has no {row.take.origin} {row.take.key!r}"
        else:
            why = refused.get(row.take.request, "there is no such request")
            reason = f"request {row.take.request!r} was refused: {why}"
    elif not reason:
        reason = "the example does not say where the number stands in the result"
    return ExampleRow(
        name=row.name, symbol=row.symbol, unit=row.unit, printed=row.printed, expected=row.expected,
        computed=computed, tolerance=row.tolerance, status=row.status, reason=reason, note=row.note,
    )  # fmt: skip


def _value(take: Take, unit: str, sizing: Computed) -> float | None:
    """The number in ``unit``, unrounded as far as ``unit`` allows."""
    match take.origin:
        case "step":
            si = sizing.sheet.value(take.key) if sizing.sheet.has(take.key) else None
        case "argument":
            key, _, name = take.key.rpartition(".")
            step = next((one for one in sizing.sheet.steps if one.key == key), None)
            put_in = None if step is None else step.inputs.get(name)
            si = float(put_in) if isinstance(put_in, (int, float)) else None
        case "headline":
            si = next((h.value for h in sizing.headlines if h.key == take.key), None)
        case "check":
            check = next((c for c in sizing.sheet.checks if c.key == take.key), None)
            si = None if check is None else getattr(check, take.side)
        case "input":
            si = _input(sizing.asked, take.key)
    if si is None:
        return None
    return take.factor * (si if take.side == "utilisation" else from_si(si, unit))


def _input(model: Any, path: str) -> float | None:
    """SI value of an input by its border path: ``mechanism.lead_mm`` or ``motion.moves.0.distance_mm``."""
    here = model
    for part in path.split("."):
        if isinstance(here, (list, tuple)):
            here = here[int(part)] if part.isdigit() and int(part) < len(here) else None
        elif isinstance(here, BaseModel):
            names = {info.alias or name: name for name, info in type(here).model_fields.items()}
            here = getattr(here, names[part]) if part in names else None
    return float(here) if isinstance(here, (int, float)) else None
