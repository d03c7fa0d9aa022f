"""The kinds of mechanism and motion that can be described, with their inputs as JSON schema."""

from dataclasses import dataclass
from functools import cache
from typing import Any, Literal

from pydantic_core import PydanticUndefined

from app.engine.mechanisms import mechanisms
from app.engine.mechanisms.base import Mechanism
from app.engine.quantity import Declared, Quantity
from app.services.errors import NotFoundError


@dataclass(frozen=True)
class MechanismKind:
    """One kind of mechanism as a reader chooses it."""

    kind: str
    title: str
    summary: str
    drawing: str
    """File in ``static/drawings``"""
    motion_kind: Literal["linear", "rotary"]
    model: type[Mechanism]


def mechanism_kinds() -> list[MechanismKind]:
    """Every kind by its title."""
    kinds = [
        MechanismKind(kind, model.title, model.summary, model.drawing, model.motion_kind, model)
        for kind, model in mechanisms().items()
    ]
    return sorted(kinds, key=lambda found: found.title)


def mechanism_kind(kind: str) -> MechanismKind:
    """One kind. Raises NotFoundError."""
    for found in mechanism_kinds():
        if found.kind == kind:
            return found
    raise NotFoundError(f"There is no mechanism {kind!r}.")


@cache
def input_schema(model: type[Declared]) -> dict[str, Any]:
    """JSON schema of a model's inputs; do not change what is returned."""
    return model.model_json_schema()


def defaults_of(model: type[Declared]) -> dict[str, Any]:
    """Default of every declared input that has one, under its border name and in its unit."""
    found: dict[str, Any] = {}
    for name, _, declared in model.declarations():
        if declared.default is PydanticUndefined:
            continue
        value = declared.default
        is_number = isinstance(declared, Quantity) and value is not None
        found[model.border_name(name)] = declared.from_si(value) if is_number else value  # type: ignore[attr-defined]
    return found
