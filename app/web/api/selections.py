"""Selecting motor and gear unit from the catalogue, and asking why."""

from typing import Any

from fastapi import APIRouter, Request, Response
from starlette.concurrency import run_in_threadpool

from app.services.reading import parse_json, read
from app.services.requests import SelectionRequest
from app.services.results import explanation_json, selection_json
from app.web.api.documentation import json_body
from app.web.api.models import ExplanationAnswer, ExplanationRequest, SelectionAnswer
from app.web.api.stateless import answered
from app.web.deps import BodyBytes
from app.web.errors import problems
from app.web.state import Running

router = APIRouter(prefix="/selections", tags=["selection"])

REFUSALS = problems(400, 409, 413, 415, 422)


@router.post("", operation_id="selectDrives", response_model=SelectionAnswer, responses=REFUSALS,
             openapi_extra=json_body(SelectionRequest), summary="Select drives")  # fmt: skip
async def select_drives(request: Request, body: BodyBytes) -> Response:
    """Judge every motor with every gear unit by every check, and list the admitted ones, best first."""
    return await answered(request, "selection", body, _select)


@router.post("/explain", operation_id="explainCandidate", response_model=ExplanationAnswer, responses=REFUSALS,
             openapi_extra=json_body(ExplanationRequest), summary="Explain a candidate")  # fmt: skip
async def explain_candidate(request: Request, body: BodyBytes) -> Response:
    """All checks of one motor with one gear unit: why it was admitted, or why not."""
    running: Running = request.app.state.running
    return Response(await run_in_threadpool(_explain, running, body), media_type="application/json")


def _select(running: Running, body: bytes) -> bytes:
    return selection_json(running.selection.select(parse_json(body)))


def _explain(running: Running, body: bytes) -> bytes:
    raw: Any = parse_json(body)
    question = read(ExplanationRequest, raw)
    selection = {name: value for name, value in raw.items() if name not in ("motor_id", "gear_unit_id")}
    return explanation_json(running.selection.explain(selection, question.motor_id, question.gear_unit_id))
