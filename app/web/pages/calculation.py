"""Calculating with one formula of the formula book, or with several of a worked example."""

from dataclasses import dataclass
from typing import Annotated, Any

from fastapi import APIRouter, Query, Request, Response

import app.engine.formulas  # noqa: F401  registers every formula
from app.engine.formula import Formula, registered
from app.engine.glossary import meaning
from app.reports import mathml
from app.reports.sheet_view import SheetView, sheet_view
from app.services.calculation import Calculation, CalculationService
from app.services.errors import InvalidInputError, NotFoundError
from app.web.deps import Examples
from app.web.forms import FieldView
from app.web.templating import page, translator

router = APIRouter()
UNPROCESSABLE = 422


@dataclass(frozen=True)
class CalculationPage:
    """Context of ``calculation.html``."""

    title: str
    formula: str
    """Name of the formula whose arguments are asked; empty where several are shown."""
    lines: tuple[Any, ...]
    fields: tuple[FieldView, ...]
    sheet: SheetView | None
    example: str
    """Identifier of the example that is shown; empty without one."""


@router.get("/calculation")
def show_calculation(
    request: Request,
    examples: Examples,
    formula: Annotated[str, Query(max_length=100)] = "",
    example: Annotated[str, Query(max_length=200)] = "",
    name: Annotated[str, Query(alias="request", max_length=200)] = "",
) -> Response:
    """Arguments of one formula with its result, or the calculation of an example."""
    if example:
        return _shown_example(request, examples, example, name)
    found = registered().get(formula)
    if found is None:
        raise NotFoundError(f"There is no formula {formula[:60]!r} in the formula book.")
    return _shown_formula(request, found)


def _shown_example(request: Request, examples: Examples, example: str, name: str) -> Response:
    raw = examples.file(example).requests.get(name)
    if raw is None or "calculation" not in raw:
        raise NotFoundError(f"The example has no calculation {name[:60]!r}.")
    done = CalculationService().calculate(raw)
    context = CalculationPage(
        title=str(raw.get("name") or name), formula="", lines=(), fields=(),
        sheet=sheet_view(done.sheet, translator(request)), example=example,
    )  # fmt: skip
    return page(request, "calculation.html", context)


def _shown_formula(request: Request, formula: Formula[..., Any]) -> Response:
    typed = {name: request.query_params.get(name, "").strip()[:200] for name in formula.parameters}
    done: Calculation | None = None
    errors: dict[str, str] = {}
    if any(typed.values()):
        values = {name: _listed(text) for name, text in typed.items() if text}
        try:
            done = CalculationService().calculate({"calculation": [{"formula": formula.name, "values": values}]})
        except InvalidInputError as error:
            errors = {str(one.path[-1]): one.message for one in error.errors}
    translate = translator(request)
    fields = tuple(_field(formula, name, typed[name], errors.get(name, ""), translate) for name in typed)
    if "values" in errors and fields:
        fields = (_with_error(fields[0], errors["values"]), *fields[1:])
    context = CalculationPage(
        title=translate(formula.summary), formula=formula.name,
        lines=(mathml.symbol(formula.symbol),), fields=fields,
        sheet=None if done is None else sheet_view(done.sheet, translate), example="",
    )  # fmt: skip
    return page(request, "calculation.html", context, UNPROCESSABLE if errors else 200)


def _listed(text: str) -> Any:
    """One value, or several divided by semicolons."""
    parts = [part.strip() for part in text.split(";") if part.strip()]
    return parts if len(parts) > 1 else text


def _field(formula: Formula[..., Any], name: str, value: str, error: str, translate: Any) -> FieldView:
    unit = formula.parameters[name]
    return FieldView(
        name=name, kind="number", label=translate(meaning(name)) or name, symbol=name, unit="" if unit == "1" else unit,
        value=value, default="", source="", required=True, error=error,
    )  # fmt: skip


def _with_error(field: FieldView, message: str) -> FieldView:
    return FieldView(**{**vars(field), "error": message})
