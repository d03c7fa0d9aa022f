"""A calculation with formulas of the formula book: several steps on one sheet, each with its own numbers.

For what belongs to no axis: a side calculation, a textbook line, a check by hand.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field
from pydantic_core import PydanticCustomError

import app.engine.formulas  # noqa: F401  registers every formula
from app.engine.errors import EngineError
from app.engine.formula import Formula, registered
from app.engine.quantity import Quantity
from app.engine.sheet import Sheet
from app.services.errors import FieldError, InvalidInputError
from app.services.reading import read
from app.services.sizing import Headline

MAX_STEPS = 200
LONGEST = 60
"""Of a text that stands for a value."""


def _one_or_many(value: object) -> object:
    """Refuse what is no value in one sentence, in place of one for each way in which it is none."""
    many = value if isinstance(value, list) else [value]
    for one in many:
        if isinstance(one, bool) or not isinstance(one, (int, float, str)):
            raise PydanticCustomError("value", _WANTED)
        if isinstance(one, str) and not 1 <= len(one) <= LONGEST:
            raise PydanticCustomError("value", f"{_WANTED}, of at most {LONGEST} characters")
    return value


_WANTED = 'must be a number, a text with its unit ("250 mm"), or "=key" of an earlier step'
Value = float | Annotated[str, Field(min_length=1, max_length=LONGEST)]
"""A number in SI, a text with its unit, or ``"=key"`` for the result of an earlier step."""


class CalculationStep(BaseModel):
    """One formula with its numbers."""

    model_config = ConfigDict(extra="forbid")

    formula: Annotated[str, Field(max_length=100, description="Name of a formula of the formula book")]
    key: Annotated[str, Field(max_length=100)] = Field(
        default="", description="Name of the result; empty: the formula's"
    )
    values: dict[str, Annotated[Value | list[Value], BeforeValidator(_one_or_many)]] = Field(
        description='Each argument: a number in SI, a text with its unit ("250 mm"), or "=key" of an earlier step'
    )


class CalculationRequest(BaseModel):
    """Steps in order; a later one may use the results of earlier ones."""

    model_config = ConfigDict(extra="forbid")

    name: Annotated[str, Field(max_length=200)] = ""
    calculation: Annotated[list[CalculationStep], Field(min_length=1, max_length=MAX_STEPS)]


@dataclass(frozen=True)
class Calculation:
    """A calculation with formulas, carried out."""

    request: CalculationRequest
    raw: Mapping[str, Any]
    sheet: Sheet
    headlines: tuple[Headline, ...] = ()

    @property
    def asked(self) -> CalculationRequest:
        """What was asked, read."""
        return self.request


class CalculationService:
    """Evaluates formulas of the formula book."""

    def calculate(self, raw: Any) -> Calculation:
        """Evaluate every step in order. Raises InvalidInputError with the path of every refused value."""
        request, sheet = read(CalculationRequest, raw), Sheet()
        results: dict[str, float] = {}
        for index, step in enumerate(request.calculation):
            path = ("calculation", index)
            formula = registered().get(step.formula)
            if formula is None:
                raise InvalidInputError([FieldError((*path, "formula"), "is not in the formula book", step.formula)])
            key = step.key or step.formula
            if key in results:
                raise InvalidInputError([FieldError((*path, "key"), "names another step already", key)])
            values = _values(formula, step, results, path)
            try:
                results[key] = sheet(formula, key=key, **values)
            except EngineError as error:
                raise InvalidInputError([FieldError((*path, "values"), error.message, step.values)]) from error
            except (TypeError, ValueError) as error:  # numpy's: shapes that do not go together
                raise InvalidInputError(_misfits(step, path)) from error
        return Calculation(request, raw, sheet)


def _values(
    formula: Formula[..., Any], step: CalculationStep, results: Mapping[str, float], path: tuple[str | int, ...]
) -> dict[str, Any]:
    """Arguments in SI; every wrong one is told at its place."""
    errors, made = [], {}
    for name, unit in formula.parameters.items():
        if name not in step.values:
            errors.append(FieldError((*path, "values", name), f"is needed, in {unit}", None))
            continue
        given = step.values[name]
        try:
            many = [_value(item, unit, results) for item in given] if isinstance(given, list) else None
            made[name] = many if many is not None else _value(given, unit, results)
        except EngineError as error:
            errors.append(FieldError((*path, "values", name), error.message, given))
    for name in step.values:
        if name not in formula.parameters:
            known = ", ".join(formula.parameters)
            errors.append(FieldError((*path, "values", name), f"is no argument; there are {known}", step.values[name]))
    if errors:
        raise InvalidInputError(errors)
    return made


def _misfits(step: CalculationStep, path: tuple[str | int, ...]) -> list[FieldError]:
    """What to say where several values stand for an argument that takes one, or another number of them."""
    message = "several values do not fit here: give one, or as many as of the other arguments that take several"
    return [
        FieldError((*path, "values", name), message, given)
        for name, given in step.values.items()
        if isinstance(given, list)
    ]


def _value(given: Any, unit: str, results: Mapping[str, float]) -> float:
    """One argument in SI."""
    if isinstance(given, str) and given.startswith("="):
        if given[1:] not in results:
            raise EngineError(f"{given[1:]!r} is the name of no earlier step")
        return results[given[1:]]
    return Quantity(unit).to_si(given)
