"""Stateless calculations: the same bytes asked again are answered from the store, while the catalogue is the same."""

from collections.abc import Callable

from fastapi import Request, Response
from starlette.concurrency import run_in_threadpool

from app.web.answers import AnswerCache
from app.web.state import Running


async def answered(request: Request, kind: str, body: bytes, calculate: Callable[[Running, bytes], bytes]) -> Response:
    """The kept answer to these bytes, or a new one that is kept. Refusals are raised and never kept."""
    running: Running = request.app.state.running
    version = running.catalogue.known_version or await run_in_threadpool(lambda: running.catalogue.snapshot().version)
    key = AnswerCache.key(kind, version, body)
    answer = running.answers.get(key)
    if answer is None:
        answer = await run_in_threadpool(calculate, running, body)
        running.answers.put(key, answer)
    return Response(answer, media_type="application/json")
