"""Worked examples, recomputed by the ordinary engine."""

from typing import Annotated

from fastapi import APIRouter, Path

from app.services.examples import ExampleFile
from app.services.results import example_dict
from app.web.api.library_models import ExampleAnswer, ExampleSummary
from app.web.api.models import Page
from app.web.deps import Examples, Limit, Offset
from app.web.errors import problems

router = APIRouter(prefix="/examples", tags=["examples"])


@router.get("", operation_id="listExamples", responses=problems(422), summary="List the worked examples")
def list_examples(examples: Examples, limit: Limit = 50, offset: Offset = 0) -> Page[ExampleSummary]:
    """Every worked example."""
    found = examples.files()
    items = [ExampleSummary.model_validate(_summary(file)) for file in found[offset : offset + limit]]
    return Page(items=items, total=len(found), limit=limit, offset=offset)


@router.get("/{example_id}", operation_id="getExample", responses=problems(404, 422), summary="Recompute an example")
def get_example(
    example_id: Annotated[str, Path(max_length=100, description="Name of the example")], examples: Examples
) -> ExampleAnswer:
    """One worked example: its requests, and every number as printed, expected and computed."""
    return ExampleAnswer.model_validate(example_dict(examples.run(example_id)))


def _summary(file: ExampleFile) -> dict[str, str]:
    return {name: getattr(file, name) for name in ("id", "title", "source", "summary")}
