"""What the annotations of a declared model say about its form: parts, lists of parts and choices between parts."""

import types
from collections.abc import Mapping
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import BaseModel
from pydantic.fields import FieldInfo

from app.engine.quantity import declaration

Models = Mapping[str, type[BaseModel]]
"""Members of a tagged union by their tag."""


def border(attribute: str, info: FieldInfo) -> str:
    """Name of an attribute at the border."""
    return info.alias or attribute


def plain(annotation: Any) -> Any:
    """An annotation without Annotated and without None.

    >>> plain(Annotated[int | None, "more"])
    <class 'int'>
    """
    if get_origin(annotation) is Annotated:
        return plain(get_args(annotation)[0])
    if get_origin(annotation) in (Union, types.UnionType):
        rest = [member for member in get_args(annotation) if member is not type(None)]
        return plain(rest[0]) if len(rest) == 1 else annotation
    return annotation


def model_of(annotation: Any) -> type[BaseModel] | None:
    """The model that an annotation means, or None where it means something else."""
    found = plain(annotation)
    return found if isinstance(found, type) and issubclass(found, BaseModel) else None


def union_members(annotation: Any) -> Models:
    """Members of a tagged union of models by tag; empty where the annotation is no such union."""
    found = plain(annotation)
    members = get_args(found) if get_origin(found) in (Union, types.UnionType) else ()
    by_tag: dict[str, type[BaseModel]] = {}
    for member in members:
        if isinstance(member, type) and issubclass(member, BaseModel):
            tag = member.model_fields.get(tag_of({"": member}))
            if tag is not None and isinstance(tag.default, str):
                by_tag[tag.default] = member
    return by_tag


def tag_of(models: Models) -> str:
    """Name of the field that tells the members apart."""
    return "shape" if any("shape" in model.model_fields for model in models.values()) else "kind"


def row_of(info: FieldInfo) -> Any:
    """What a list holds when it holds models, else None."""
    annotation = plain(info.annotation)
    if get_origin(annotation) not in (list, tuple):
        return None
    row = get_args(annotation)[0]
    return row if model_of(row) is not None or union_members(row) else None


def is_tag(info: FieldInfo) -> bool:
    """Whether a field only says of which kind its model is."""
    annotation = plain(info.annotation)
    return get_origin(annotation) is Literal and len(get_args(annotation)) == 1 and declaration(info) is None


def is_optional(info: FieldInfo) -> bool:
    """Whether a part may be left out."""
    return type(None) in get_args(info.annotation)
