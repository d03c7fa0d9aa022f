"""OpenAPI for bodies that services read themselves: the schema of the declared models, in the common components."""

from typing import Any

from fastapi import FastAPI
from fastapi.openapi.utils import get_openapi
from pydantic import BaseModel
from pydantic.json_schema import models_json_schema

from app.services.calculation import CalculationRequest
from app.services.documents import ProjectDocument
from app.services.multi_axis import MultiAxisRequest
from app.services.requests import SelectionRequest, SizingRequest
from app.services.version import ENGINE_VERSION
from app.web.api.models import ExplanationRequest

BODIES: tuple[type[BaseModel], ...] = (
    SizingRequest, SelectionRequest, ExplanationRequest, ProjectDocument, MultiAxisRequest, CalculationRequest,
)  # fmt: skip
_TEMPLATE = "#/components/schemas/{model}"


def json_body(model: type[BaseModel]) -> dict[str, Any]:
    """``openapi_extra`` of a route whose body is this model."""
    schema = {"$ref": _TEMPLATE.format(model=model.__name__)}
    return {"requestBody": {"required": True, "content": {"application/json": {"schema": schema}}}}


def install_openapi(app: FastAPI) -> None:
    """Replace the application's OpenAPI by one that holds the schemas of all bodies."""

    def openapi() -> dict[str, Any]:
        if app.openapi_schema is None:
            app.openapi_schema = _described(app)
        return app.openapi_schema

    app.openapi = openapi  # type: ignore[method-assign]


def _described(app: FastAPI) -> dict[str, Any]:
    described = get_openapi(
        title="Drivewright",
        version=ENGINE_VERSION,
        summary="Select an electric drive, with every number open to its formula.",
        description=(
            "Names of quantities end in their unit (`diameter_mm`). A number is in that unit; a text may carry another "
            'one (`"9.84 in"`). Errors are problem details (RFC 9457) that name the path of every refused value.'
        ),
        routes=app.routes,
    )
    _, bodies = models_json_schema([(model, "validation") for model in BODIES], ref_template=_TEMPLATE)
    schemas = described.setdefault("components", {}).setdefault("schemas", {})
    for name, schema in bodies["$defs"].items():
        schemas.setdefault(name, schema)
    for unused in ("HTTPValidationError", "ValidationError"):
        schemas.pop(unused, None)
    for path in described["paths"].values():
        for operation in path.values():
            _only_problems(operation["responses"])
    return described


def _only_problems(responses: dict[str, Any]) -> None:
    """FastAPI describes its own error bodies; ours replace them."""
    for status, response in responses.items():
        if status.startswith(("4", "5")):
            content = response.setdefault("content", {})
            content.clear()
            content["application/problem+json"] = {"schema": {"$ref": "#/components/schemas/Problem"}}
