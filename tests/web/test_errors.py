"""One shape of error for programs, whatever went wrong, and a page for readers."""

import json
from collections.abc import Iterator
from typing import Annotated, Any

import pytest
from fastapi import FastAPI, Query, Request
from fastapi.responses import HTMLResponse, PlainTextResponse, Response
from starlette.testclient import TestClient

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
from app.web.errors import PreconditionRequiredError, Problem, UnsupportedMediaError, install_errors
from app.web.middleware import SECURITY_HEADERS, Guard

LIMIT = 1024

REFUSALS: list[tuple[ServiceError, int]] = [
    (InvalidInputError([FieldError(("motion", "moves", 0, "distance_mm"), "must be greater than 0 mm", "-3 mm")]), 422),
    (MalformedInputError("no JSON"), 400),
    (NotFoundError("no such project"), 404),
    (ForbiddenError("view only"), 403),
    (ConflictError("saved meanwhile", 7), 412),
    (CatalogueEmptyError("the catalogue holds no servo motors: run drivewright load-catalog"), 409),
    (PreconditionRequiredError("name the version"), 428),
    (UnsupportedMediaError("text/plain"), 415),
]


def small_app() -> FastAPI:
    """An application of our own with every kind of failure."""
    app = FastAPI()
    app.add_middleware(Guard, max_body_bytes=LIMIT)
    install_errors(app)

    @app.get("/api/refuse/{number}")
    def refuse(number: int) -> None:
        raise REFUSALS[number][0]

    @app.get("/refuse/{number}")
    def refuse_page(number: int) -> None:
        raise REFUSALS[number][0]

    @app.get("/api/break")
    def break_down() -> None:
        raise RuntimeError("secret of the house")

    @app.get("/api/query")
    def query(limit: Annotated[int, Query(le=5)]) -> int:
        return limit

    @app.post("/api/echo")
    async def echo(request: Request) -> Response:
        return PlainTextResponse(str(len(await request.body())))

    return app


@pytest.fixture
def http() -> Iterator[TestClient]:
    with TestClient(small_app(), raise_server_exceptions=False) as client:
        yield client


def is_problem(response: Any, status: int) -> dict[str, Any]:
    """The problem in an answer, after its form was checked."""
    assert response.status_code == status
    assert response.headers["content-type"] == "application/problem+json"
    found = Problem.model_validate_json(response.content, strict=True)
    assert found.status == status
    assert found.type.startswith("urn:drivewright:problem:")
    assert found.title
    assert found.detail
    body: dict[str, Any] = response.json()
    return body


@pytest.mark.parametrize("number", range(len(REFUSALS)))
def test_every_refusal_has_its_status_and_the_one_shape(http: TestClient, number: int):
    error, status = REFUSALS[number]
    assert is_problem(http.get(f"/api/refuse/{number}"), status)["detail"] == error.message


def test_a_refused_value_is_named_by_path_pointer_and_as_typed(http: TestClient):
    assert is_problem(http.get("/api/refuse/0"), 422)["errors"] == [
        {
            "path": ["motion", "moves", 0, "distance_mm"],
            "pointer": "/motion/moves/0/distance_mm",
            "name": "motion.moves.0.distance_mm",
            "message": "must be greater than 0 mm",
            "value": "-3 mm",
        }
    ]


def test_a_conflict_tells_the_newest_version(http: TestClient):
    assert is_problem(http.get("/api/refuse/4"), 412)["current_version"] == 7


def test_an_unknown_failure_tells_nothing_but_its_name_in_the_log(http: TestClient, caplog: pytest.LogCaptureFixture):
    response = http.get("/api/break")
    found = is_problem(response, 500)
    assert "secret" not in response.text
    assert "Traceback" not in response.text
    assert found["id"] in caplog.text
    assert "secret of the house" in caplog.text


def test_paths_methods_and_parameters_are_refused_in_the_same_shape(http: TestClient):
    is_problem(http.get("/api/nowhere"), 404)
    wrong = http.post("/api/query")
    is_problem(wrong, 405)
    assert wrong.headers["allow"] == "GET"
    errors = is_problem(http.get("/api/query?limit=six"), 422)["errors"]
    assert [error["name"] for error in errors] == ["limit"]
    assert is_problem(http.get("/api/query"), 422)["errors"][0]["message"] == "is missing"


def test_a_reader_gets_a_page_in_which_nothing_becomes_markup(http: TestClient):
    response = http.get("/<script>alert(1)</script>")
    assert response.status_code == 404
    assert response.headers["content-type"].startswith("text/html")
    assert "<script>" not in response.text


def test_pages_bring_their_own_error_page():
    app = small_app()
    app.state.problem_page = lambda request, found: HTMLResponse(f"<p>{found.status}</p>")
    with TestClient(app) as http:
        response = http.get("/refuse/2")
    assert (response.status_code, response.text) == (404, "<p>404</p>")


@pytest.mark.parametrize("path", ["/api/query?limit=%00", "/api/%00"])
def test_nul_in_an_address_is_refused(http: TestClient, path: str):
    is_problem(http.get(path), 400)


def test_headers_for_browsers_stand_on_answers_and_on_errors(http: TestClient):
    for response in (http.get("/api/query?limit=1"), http.get("/api/nowhere"), http.get("/api/query?q=%00")):
        assert {name: response.headers[name] for name in SECURITY_HEADERS} == SECURITY_HEADERS


@pytest.mark.parametrize("chunked", [False, True])
def test_a_body_above_the_limit_is_refused(http: TestClient, chunked: bool):
    def parts(size: int) -> Iterator[bytes]:
        for start in range(0, size, 100):
            yield b"x" * min(100, size - start)

    def content(size: int) -> Any:
        return parts(size) if chunked else b"x" * size

    assert http.post("/api/echo", content=content(LIMIT)).text == str(LIMIT)
    assert "1 KiB" in is_problem(http.post("/api/echo", content=content(LIMIT + 1)), 413)["detail"]
    is_problem(http.post("/api/echo", content=content(10 * 1024 * 1024)), 413)


def test_a_long_value_is_not_repeated_in_full():
    app = FastAPI()
    install_errors(app)

    @app.get("/api/long")
    def long() -> None:
        raise InvalidInputError([FieldError(("a" * 1000,), "is unknown", ["x"] * 1000)])

    with TestClient(app) as http:
        response = http.get("/api/long")
    assert len(response.content) < 1500
    assert len(json.loads(response.content)["errors"][0]["value"]) == 200
