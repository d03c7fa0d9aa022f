"""Sizing one axis: stateless, the same request gives the same answer as long as the catalogue is the same."""

from fastapi import APIRouter, Request, Response
from starlette.concurrency import run_in_threadpool

from app.services.reading import parse_json
from app.services.requests import SizingRequest
from app.services.results import sizing_json
from app.web.answers import AnswerCache
from app.web.api.documentation import json_body
from app.web.api.models import SizingAnswer
from app.web.deps import BodyBytes
from app.web.errors import problems
from app.web.state import Running

router = APIRouter(prefix="/sizings", tags=["sizing"])


@router.post("", operation_id="calculateSizing", response_model=SizingAnswer, responses=problems(400, 413, 415, 422),
             openapi_extra=json_body(SizingRequest), summary="Size an axis")  # fmt: skip
async def calculate_sizing(request: Request, body: BodyBytes) -> Response:
    """Calculate an axis: load cycle, every step with its formula, every check. Nothing is stored.

    The answer is kept for a while: the same bytes asked again are not calculated again.
    """
    running: Running = request.app.state.running
    version = running.catalogue.known_version or await run_in_threadpool(lambda: running.catalogue.snapshot().version)
    key = AnswerCache.key("sizing", version, body)
    answer = running.answers.get(key)
    if answer is None:
        answer = await run_in_threadpool(_calculate, running, body)
        running.answers.put(key, answer)
    return Response(answer, media_type="application/json")


def _calculate(running: Running, body: bytes) -> bytes:
    return sizing_json(running.sizing.size(parse_json(body)))
