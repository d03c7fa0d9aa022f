"""The calculation sheet: every step, assumption, decision and check of one calculation, in order.

A sheet belongs to one calculation and is handed down; nothing is kept at module level.
"""

import math
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any, ParamSpec, TypeVar

import numpy as np

from app.engine.errors import RangeError
from app.engine.formula import Formula
from app.engine.quantity import Declared, Quantity, from_si
from app.engine.tables import Table

P = ParamSpec("P")
R = TypeVar("R")

TIGHT = 0.8
"""Utilisation above which a check that holds is called tight."""
ROUNDING = 1e-9
"""Relative excess over a limit that is floating-point noise, not a violation."""


class Verdict(StrEnum):
    """Outcome of a check."""

    OK = "ok"
    TIGHT = "tight"
    FAILS = "fails"
    NOT_CHECKED = "not_checked"


@dataclass(frozen=True)
class Step:
    """One evaluated formula: its inputs (SI, by argument name), value (SI) and where it stands."""

    key: str
    section: str
    label: str
    symbol: str
    formula: Formula[..., Any]
    inputs: dict[str, Any]
    value: float
    unit: str
    """Unit in which the value is shown."""

    @property
    def shown_value(self) -> float:
        """The value in ``unit``."""
        return from_si(self.value, self.unit)


@dataclass(frozen=True)
class Assumption:
    """A value that the user did not give: what was taken instead, and from where."""

    key: str
    text: str
    symbol: str
    value: Any
    """SI for a quantity, the choice itself otherwise."""
    unit: str
    source: str


@dataclass(frozen=True)
class Decision:
    """A branch that was taken, and why."""

    section: str
    text: str
    reason: str
    position: int = 0
    """Number of steps recorded before it: where it stands among them."""


@dataclass(frozen=True)
class Check:
    """A demand against what is permitted or available; it holds when demanded <= permitted. Values are SI."""

    key: str
    name: str
    demanded: float | None
    permitted: float | None
    unit: str
    """Unit in which both are shown."""
    source: str
    """Where the limit comes from."""
    section: str = ""
    formula: str = ""
    """Name of the formula behind the demanded value, empty where the step list has none."""
    missing: str = ""
    """What is missing when the check could not be made."""

    @property
    def utilisation(self) -> float | None:
        """demanded / permitted; infinite where nothing is permitted, None where the check could not be made."""
        return None if self.demanded is None or self.permitted is None else utilisation(self.demanded, self.permitted)

    @property
    def verdict(self) -> Verdict:
        """ok, tight (above 0.8), fails (above 1) or not_checked."""
        return verdict(self.utilisation)


def utilisation(demanded: float, permitted: float) -> float:
    """Share of the permitted value that is used; 0 without demand, infinite where a demand meets nothing permitted.

    A permitted value below zero is exceeded by no demand too.
    """
    if demanded <= 0:
        return 0.0 if demanded <= permitted else math.inf
    return demanded / permitted if permitted > 0 else math.inf


def verdict(used: float | None) -> Verdict:
    """Verdict on a utilisation.

    >>> [str(verdict(u)) for u in (0.5, 0.9, 1.0, 1.001, None)]
    ['ok', 'tight', 'tight', 'fails', 'not_checked']
    """
    if used is None:
        return Verdict.NOT_CHECKED
    if used > 1 + ROUNDING:
        return Verdict.FAILS
    return Verdict.TIGHT if used > TIGHT else Verdict.OK


def _unique(key: str, used: set[str]) -> str:
    """The key itself, or the first of key#2, key#3 ... that is not used."""
    if key not in used:
        return key
    return next(name for count in range(2, len(used) + 3) if (name := f"{key}#{count}") not in used)


@dataclass
class Sheet:
    """Records a calculation as it runs: ``sheet(formula, a=..., b=...)`` evaluates, records and returns the value."""

    steps: list[Step] = field(default_factory=list)
    assumptions: list[Assumption] = field(default_factory=list)
    decisions: list[Decision] = field(default_factory=list)
    checks: list[Check] = field(default_factory=list)
    tables: Mapping[str, Table] = field(default_factory=dict)
    """Tabulated charts that a look-up may use, by key."""
    _section: str = ""

    def __call__(
        self,
        formula: Formula[..., Any],
        /,
        *,
        key: str = "",
        symbol: str = "",
        label: str = "",
        unit: str = "",
        **values: Any,
    ) -> float:
        """Evaluate ``formula`` with SI ``values``, record the step, return the value.

        ``key``, ``symbol``, ``label`` and ``unit`` replace the formula's own name, symbol, summary and shown unit where
        one formula serves several quantities. Raises RangeError when the result is not finite.
        """
        with np.errstate(all="ignore"):
            try:
                value = float(formula(**values))
            except (ZeroDivisionError, OverflowError):
                value = math.nan
        if not math.isfinite(value):
            given = ", ".join(f"{name} = {number}" for name, number in values.items())
            raise RangeError(f"{formula.summary} cannot be computed from {given}")
        key = _unique(key or formula.name, {step.key for step in self.steps})
        self.steps.append(Step(
            key=key, section=self._section, label=label or formula.summary,
            symbol=symbol or formula.symbol, formula=formula, inputs=values, value=value, unit=unit or formula.unit,
        ))  # fmt: skip
        return value

    @contextmanager
    def section(self, title: str) -> Iterator[None]:
        """Put everything recorded inside under a heading."""
        outer, self._section = self._section, title
        try:
            yield
        finally:
            self._section = outer

    def assume(
        self, key: str, text: str, *, value: Any = None, unit: str = "1", symbol: str = "", source: str = ""
    ) -> None:
        """Record something that was taken because the user gave nothing, once per key."""
        if all(known.key != key for known in self.assumptions):
            self.assumptions.append(Assumption(key, text, symbol, value, unit, source))

    def look_up(
        self, key: str, text: str, *, x: float, family: float = 0.0, symbol: str = "", unit: str = "1",
        given: float | None = None,
    ) -> float | None:  # fmt: skip
        """The value read from a tabulated chart, recorded as an assumption; ``given``, the user's own, goes before it.

        ``key`` is that of the table, ``text`` says what is read. None where there is no such table or no value at
        ``x`` and ``family``: then what needs it cannot be checked. Several readings of one table are all recorded.
        """
        if given is not None:
            return given
        table = self.tables.get(key)
        value = None if table is None else table.value(x, family)
        if table is not None and value is not None:
            taken = _unique(f"table.{key}", {known.key for known in self.assumptions})
            self.assume(taken, text, value=value, unit=unit, symbol=symbol, source=f"{table.title}: {table.source}")
        return value

    def assume_defaults(self, model: Declared, path: str = "") -> None:
        """Record each default of a model that the user has not confirmed, nested models included."""
        for name, found, value in model.defaults_taken():
            unit = found.unit if isinstance(found, Quantity) else "1"
            self.assume(f"{path}{model.border_name(name)}", found.about or name, value=value, unit=unit,
                        symbol=found.symbol, source=found.source)  # fmt: skip
        for name in type(model).model_fields:
            inner = getattr(model, name)
            if isinstance(inner, Declared):
                self.assume_defaults(inner, f"{path}{name}.")
            elif isinstance(inner, (list, tuple)):
                for index, item in enumerate(inner):
                    if isinstance(item, Declared):
                        self.assume_defaults(item, f"{path}{name}.{index}.")

    def decide(self, text: str, reason: str) -> None:
        """Record the branch taken and why."""
        self.decisions.append(Decision(self._section, text, reason, len(self.steps)))

    def check(
        self,
        key: str,
        name: str,
        demanded: float | None,
        permitted: float | None,
        unit: str,
        source: str,
        *,
        formula: str = "",
        missing: str = "",
    ) -> Check:
        """Record a check of demanded <= permitted (SI values).

        None on either side needs ``missing``: what is not known. A key that is taken gets a number. Raises RangeError
        for NaN, which would pass as holding.
        """
        if (demanded is None or permitted is None) and not missing:
            raise ValueError(f"check {key}: say what is missing")
        if any(value is not None and math.isnan(value) for value in (demanded, permitted)):
            raise RangeError(f"{name} cannot be checked: a value is not a number")
        key = _unique(key, {known.key for known in self.checks})
        made = Check(key, name, demanded, permitted, unit, source, self._section, formula, missing)
        self.checks.append(made)
        return made

    def value(self, key: str) -> float:
        """SI value of a recorded step; KeyError when there is none of that key."""
        for step in self.steps:
            if step.key == key:
                return step.value
        raise KeyError(key)

    def has(self, key: str) -> bool:
        """Whether a step of that key was recorded."""
        return any(step.key == key for step in self.steps)
