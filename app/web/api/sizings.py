"""Sizing one axis: stateless, the same request gives the same answer as long as the catalogue is the same."""

from fastapi import APIRouter, Request, Response

from app.services.reading import parse_json
from app.services.requests import SizingRequest
from app.services.results import sizing_json
from app.web.api.documentation import json_body
from app.web.api.models import SizingAnswer
from app.web.api.stateless import answered
from app.web.deps import BodyBytes
from app.web.errors import problems
from app.web.state import Running

router = APIRouter(prefix="/sizings", tags=["sizing"])


@router.post("", operation_id="calculateSizing", response_model=SizingAnswer, responses=problems(400, 413, 415, 422),
             openapi_extra=json_body(SizingRequest), summary="Size an axis")  # fmt: skip
async def calculate_sizing(request: Request, body: BodyBytes) -> Response:
    """Calculate an axis: load cycle, every step with its formula, every check. Nothing is stored."""
    return await answered(request, "sizing", body, _size)


def _size(running: Running, body: bytes) -> bytes:
    return sizing_json(running.sizing.size(parse_json(body)))
