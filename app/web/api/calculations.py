"""Calculations with formulas of the formula book: stateless, several steps on one sheet."""

from fastapi import APIRouter, Request, Response

from app.services.calculation import CalculationRequest, CalculationService
from app.services.reading import parse_json
from app.services.results import calculation_json
from app.web.api.documentation import json_body
from app.web.api.models import CalculationAnswer
from app.web.api.stateless import answered
from app.web.deps import BodyBytes
from app.web.errors import problems
from app.web.state import Running

router = APIRouter(prefix="/calculations", tags=["formulas"])


@router.post("", operation_id="calculateFormulas", response_model=CalculationAnswer,
             responses=problems(400, 413, 415, 422), openapi_extra=json_body(CalculationRequest),
             summary="Calculate with formulas")  # fmt: skip
async def calculate_formulas(request: Request, body: BodyBytes) -> Response:
    """Evaluate formulas one after another; later ones may use earlier results. Nothing is stored."""
    return await answered(request, "calculation", body, _calculate)


def _calculate(_: Running, body: bytes) -> bytes:
    return calculation_json(CalculationService().calculate(parse_json(body)))
