"""What is answered when something is refused: one shape of problem for programs, one page for readers.

Programs get ``application/problem+json`` (RFC 9457) with the path of every refused value. Pages install
``app.state.problem_page``, a callable that turns a request and a Problem into HTML; a page that shows a refused form
again catches InvalidInputError itself.
"""

import http
import logging
import secrets
from collections.abc import Callable
from typing import Any, cast

from fastapi import FastAPI, Request
from fastapi.exceptions import RequestValidationError
from fastapi.responses import HTMLResponse, Response
from markupsafe import escape
from pydantic import BaseModel, Field
from pydantic_core import to_json
from starlette.exceptions import HTTPException

from app.services.errors import (
    CatalogueEmptyError,
    ConflictError,
    FieldError,
    ForbiddenError,
    InvalidInputError,
    MalformedInputError,
    NotFoundError,
    ServiceError,
)

API_PREFIX = "/api/"
MEDIA_TYPE = "application/problem+json"
SHOWN_VALUE = 200
"""A typed value longer than this many characters is not repeated in full."""

log = logging.getLogger("drivewright")


class ProblemField(BaseModel):
    """One refused value."""

    path: list[str | int] = Field(description="Names and positions from the outside in; empty: the whole input")
    pointer: str = Field(description="The path as a JSON pointer")
    name: str = Field(description="The path as one dotted name")
    message: str = Field(description="Why the value cannot be used; continues a sentence that begins with its name")
    value: str | None = Field(default=None, description="What was given, as text; null where nothing was given")


class Problem(BaseModel):
    """Problem details (RFC 9457)."""

    type: str = Field(description="Identifies the kind of problem")
    title: str = Field(description="The kind of problem in a few words")
    status: int = Field(description="HTTP status")
    detail: str = Field(description="What happened this time, as a sentence")
    errors: list[ProblemField] = Field(default=[], description="Every refused value with its place")
    current_version: int | None = Field(default=None, description="Newest version of a project after a conflict")
    id: str | None = Field(default=None, description="Names this failure in the log of the server")


class PreconditionRequiredError(ServiceError):
    """A change that does not name the version it was made from."""


class TooLargeError(HTTPException):
    """A request body above the limit; a HTTPException because FastAPI passes these on while it reads a body."""

    def __init__(self, limit: int) -> None:
        size = f"{limit // 1024} KiB" if limit % 1024 == 0 else f"{limit} bytes"
        super().__init__(413, f"The body is larger than {size}, the most that is read.")


class UnsupportedMediaError(ServiceError):
    """A body that is not declared as JSON."""


_STATUS: dict[type[ServiceError], int] = {
    InvalidInputError: 422,
    MalformedInputError: 400,
    NotFoundError: 404,
    ForbiddenError: 403,
    ConflictError: 412,
    CatalogueEmptyError: 409,
    PreconditionRequiredError: 428,
    UnsupportedMediaError: 415,
}
_KINDS = {
    400: ("malformed", "Malformed request"),
    403: ("forbidden", "Not allowed with this link"),
    404: ("not-found", "Not found"),
    405: ("method-not-allowed", "Method not allowed"),
    409: ("catalogue-empty", "The catalogue is empty"),
    412: ("conflict", "Saved by someone else"),
    413: ("too-large", "Body too large"),
    415: ("unsupported-media-type", "Unsupported media type"),
    422: ("invalid-input", "Some values cannot be used"),
    428: ("version-required", "Version required"),
    500: ("internal", "Internal error"),
}


def status_of(error: ServiceError) -> int:
    """HTTP status of what a service refused."""
    return next((_STATUS[kind] for kind in type(error).__mro__ if kind in _STATUS), 400)


def problem(status: int, detail: str, **more: Any) -> Problem:
    """A problem of the kind that belongs to a status."""
    phrase = http.HTTPStatus(status).phrase if status in set(http.HTTPStatus) else "Error"
    slug, title = _KINDS.get(status, (phrase.lower().replace(" ", "-"), phrase))
    return Problem(type=f"urn:drivewright:problem:{slug}", title=title, status=status, detail=detail, **more)


def problem_of(error: ServiceError) -> Problem:
    """The problem that a refusal of a service becomes."""
    errors = [problem_field(e) for e in error.errors] if isinstance(error, InvalidInputError) else []
    current = error.current if isinstance(error, ConflictError) else None
    return problem(status_of(error), error.message, errors=errors, current_version=current)


def problem_field(error: FieldError) -> ProblemField:
    """One refused value for a program."""
    path = [part if isinstance(part, int) else part[:SHOWN_VALUE] for part in error.path]
    shown = FieldError(tuple(path), error.message, error.value)
    return ProblemField(
        path=path, pointer=shown.pointer, name=shown.name, message=error.message, value=shown_value(error.value)
    )


def shown_value(value: Any) -> str | None:
    """A typed value as text, shortened."""
    if value is None:
        return None
    text = value if isinstance(value, str) else repr(value)
    return text if len(text) <= SHOWN_VALUE else text[: SHOWN_VALUE - 1] + "…"


def problems(*statuses: int) -> dict[int | str, dict[str, Any]]:
    """The ``responses=`` of a route: what it may refuse, for OpenAPI."""
    schema = {"schema": {"$ref": "#/components/schemas/Problem"}}
    return {
        status: {"description": _KINDS[status][1], "model": Problem, "content": {MEDIA_TYPE: schema}}
        for status in statuses
    }


def respond(request: Request, found: Problem, headers: dict[str, str] | None = None) -> Response:
    """The problem as JSON for a program or as a page for a reader."""
    page: Callable[[Request, Problem], Response] | None = getattr(request.app.state, "problem_page", None)
    if request.url.path.startswith(API_PREFIX):
        body = to_json(found.model_dump(exclude_none=True))
        return Response(body, found.status, headers, MEDIA_TYPE)
    if page is None:
        text = (
            f"<!doctype html><title>{escape(found.title)}</title><h1>{escape(found.title)}</h1>{escape(found.detail)}"
        )
        return HTMLResponse(text, found.status, headers)
    made = page(request, found)
    made.status_code = found.status
    made.headers.update(headers or {})
    return made


def install_errors(app: FastAPI) -> None:
    """Answer every known error, and the unknown ones without a trace."""

    def service_error(request: Request, error: Exception) -> Response:
        return respond(request, problem_of(cast(ServiceError, error)))

    def http_error(request: Request, error: Exception) -> Response:
        refused = cast(HTTPException, error)
        detail = _http_detail(request, refused)
        return respond(request, problem(refused.status_code, detail), dict(refused.headers or {}))

    def parameters(request: Request, error: Exception) -> Response:
        return respond(request, problem_of(_parameter_errors(cast(RequestValidationError, error))))

    def unknown(request: Request, error: Exception) -> Response:
        name = secrets.token_hex(6)
        log.error("failure %s at %s %s", name, request.method, request.url.path, exc_info=error)
        return respond(request, problem(500, f"Something failed here; the log names it {name}.", id=name))

    app.add_exception_handler(ServiceError, service_error)
    app.add_exception_handler(HTTPException, http_error)
    app.add_exception_handler(RequestValidationError, parameters)
    app.add_exception_handler(Exception, unknown)


def _http_detail(request: Request, error: HTTPException) -> str:
    if error.status_code == 404:
        return f"There is nothing at {request.url.path[:SHOWN_VALUE]}."
    if error.status_code == 405:
        return f"{request.method} is not possible at {request.url.path[:SHOWN_VALUE]}."
    return str(error.detail)


def _parameter_errors(error: RequestValidationError) -> InvalidInputError:
    """Errors of path, query and header parameters; bodies are read by the services."""
    found = []
    for item in error.errors():
        message = "is missing" if item["type"] == "missing" else item["msg"].replace("Input should be", "must be")
        found.append(FieldError(tuple(item["loc"][1:]), message, item.get("input")))
    return InvalidInputError(found)
