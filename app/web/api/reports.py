"""The report of an axis as a PDF."""

from fastapi import APIRouter, Request, Response
from starlette.concurrency import run_in_threadpool

from app.services.reading import parse_json
from app.services.reports import axis_report
from app.services.requests import SizingRequest
from app.web.api.documentation import json_body
from app.web.deps import BodyBytes
from app.web.drawings import drawing_of
from app.web.errors import problems
from app.web.state import Running

router = APIRouter(prefix="/reports", tags=["sizing"])
PDF = "application/pdf"


@router.post("", operation_id="reportAxis", response_class=Response,
             responses={200: {"content": {PDF: {"schema": {"type": "string", "format": "binary"}}},
                              "description": "The report"}, **problems(400, 409, 413, 415, 422)},
             openapi_extra=json_body(SizingRequest), summary="Report an axis as a PDF")  # fmt: skip
async def report_axis(request: Request, body: BodyBytes) -> Response:
    """Inputs, assumptions, checks, charts and the whole calculation on A4. The same input gives the same bytes."""
    running: Running = request.app.state.running
    return Response(await run_in_threadpool(_report, running, body), media_type=PDF)


def _report(running: Running, body: bytes) -> bytes:
    sizing = running.sizing.size(parse_json(body))
    return axis_report(sizing, drawing_of(sizing.typed.request.mechanism.drawing))
