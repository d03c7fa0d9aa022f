"""Kinds of mechanism with the schema of their inputs."""

from typing import Annotated

from fastapi import APIRouter, Path

from app.services.mechanisms import MechanismKind, defaults_of, input_schema, mechanism_kind, mechanism_kinds
from app.web.api.models import MechanismDetail, MechanismSummary, Page
from app.web.deps import Limit, Offset
from app.web.errors import problems

router = APIRouter(prefix="/mechanisms", tags=["mechanisms"])


@router.get("", operation_id="listMechanisms", responses=problems(422), summary="List the mechanisms")
def list_mechanisms(limit: Limit = 50, offset: Offset = 0) -> Page[MechanismSummary]:
    """Every kind of mechanism that can be sized."""
    found = mechanism_kinds()
    items = [MechanismSummary.model_validate(_summary(kind)) for kind in found[offset : offset + limit]]
    return Page(items=items, total=len(found), limit=limit, offset=offset)


@router.get("/{kind}", operation_id="getMechanism", responses=problems(404, 422), summary="Show a mechanism")
def get_mechanism(kind: Annotated[str, Path(max_length=60, description="Kind of mechanism")]) -> MechanismDetail:
    """One kind of mechanism: the JSON schema of its inputs and their defaults."""
    found = mechanism_kind(kind)
    schema, defaults = input_schema(found.model), defaults_of(found.model)
    return MechanismDetail.model_validate({**_summary(found), "input_schema": schema, "defaults": defaults})


def _summary(found: MechanismKind) -> dict[str, str]:
    return {
        "kind": found.kind, "title": found.title, "summary": found.summary, "motion_kind": found.motion_kind,
        "drawing": f"/static/drawings/{found.drawing}",
    }  # fmt: skip
