"""The REST interface at a glance, read from its own OpenAPI description."""

from dataclasses import dataclass

from fastapi import APIRouter, Request, Response

from app.web.templating import page

router = APIRouter()


@dataclass(frozen=True)
class Operation:
    """One operation."""

    method: str
    path: str
    summary: str
    description: str
    tag: str


@dataclass(frozen=True)
class RestPage:
    """Context of ``rest.html``."""

    operations: tuple[Operation, ...]


@router.get("/rest")
def show_rest(request: Request) -> Response:
    """Every operation with its address."""
    described = request.app.openapi()["paths"]
    operations = tuple(
        Operation(method.upper(), path, one.get("summary", ""), one.get("description", ""), one.get("tags", [""])[0])
        for path, methods in described.items()
        for method, one in methods.items()
    )
    return page(request, "rest.html", RestPage(operations))
