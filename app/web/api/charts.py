"""Charts of a sizing as Plotly figures, the same that the pages show."""

from typing import Annotated

from fastapi import APIRouter, Query, Request, Response
from pydantic_core import to_json

from app.charts import axis_figures
from app.services.reading import parse_json
from app.services.requests import SizingRequest
from app.web.api.documentation import json_body
from app.web.api.models import ChartsAnswer
from app.web.api.stateless import answered
from app.web.deps import BodyBytes
from app.web.errors import problems
from app.web.state import Running

router = APIRouter(prefix="/charts", tags=["sizing"])


@router.post("", operation_id="drawCharts", response_model=ChartsAnswer, responses=problems(400, 413, 415, 422),
             openapi_extra=json_body(SizingRequest), summary="Draw the charts of an axis")  # fmt: skip
async def draw_charts(
    request: Request,
    body: BodyBytes,
    four_quadrants: Annotated[bool, Query(description="Keep the signs of speed and torque")] = False,
) -> Response:
    """Torque over speed with the limits of the motor, speed, torque and power over time, and what else there is."""
    if four_quadrants:
        return await answered(request, "charts, four quadrants", body, _draw_signed)
    return await answered(request, "charts", body, _draw)


def _draw(running: Running, body: bytes) -> bytes:
    return _figures(running, body, signed=False)


def _draw_signed(running: Running, body: bytes) -> bytes:
    return _figures(running, body, signed=True)


def _figures(running: Running, body: bytes, *, signed: bool) -> bytes:
    sizing = running.sizing.size(parse_json(body))
    figures = dict(axis_figures(sizing.drive, sizing.load, four_quadrants=signed))
    known = {"torque_speed": figures.pop("torque-speed", None), "cycle": figures.pop("cycle", None)}
    return to_json({**known, "diagrams": figures})
