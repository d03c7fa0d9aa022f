"""Several axes on one supply: stateless, each axis sized as by itself, then joined on a common DC link."""

from fastapi import APIRouter, Request, Response

from app.services.multi_axis import MultiAxisRequest, MultiAxisService
from app.services.reading import parse_json
from app.services.results import multi_axis_json
from app.web.api.documentation import json_body
from app.web.api.models import SupplyAnswer
from app.web.api.stateless import answered
from app.web.deps import BodyBytes
from app.web.errors import problems
from app.web.state import Running

router = APIRouter(prefix="/supplies", tags=["sizing"])


@router.post("", operation_id="calculateSupply", response_model=SupplyAnswer, responses=problems(400, 413, 415, 422),
             openapi_extra=json_body(MultiAxisRequest), summary="Size the supply of several axes")  # fmt: skip
async def calculate_supply(request: Request, body: BodyBytes) -> Response:
    """Axis modules, supply module, DC link, braking resistor and heat sink of several servo axes."""
    return await answered(request, "supply", body, _calculate)


def _calculate(running: Running, body: bytes) -> bytes:
    return multi_axis_json(MultiAxisService(running.sizing).size(parse_json(body)))
