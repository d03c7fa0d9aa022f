"""What comes over the border becomes a declared model, or an InvalidInputError in the reader's words.

Every face (REST, pages, command line, examples) reads its input here, so the same mistake gets the same answer.
"""

import difflib
import json
import types
from collections.abc import Iterable, Iterator
from typing import Annotated, Any, TypeVar, Union, get_args, get_origin

from pydantic import BaseModel, ValidationError
from pydantic_core import ErrorDetails, from_json

from app.engine.errors import EngineError
from app.engine.quantity import Declared, Quantity, declaration
from app.services.errors import FieldError, InvalidInputError, MalformedInputError, Path

M = TypeVar("M", bound=BaseModel)

MAX_ERRORS = 100
"""More refused values than this are not listed one by one."""
_TAGS = ("kind", "shape")
"""Fields that choose a member of a union; pydantic puts their value into the location of an error."""


def parse_json(data: bytes) -> Any:
    """Read JSON strictly: UTF-8, no NaN, no name twice in one object, no NUL, no endless nesting.

    A number too large for a float becomes infinite and is refused later, at its field. Raises MalformedInputError.
    """
    try:
        from_json(data, allow_inf_nan=False)  # UTF-8, lone surrogates, depth
        value = json.loads(data, object_pairs_hook=_object)
        if b"\\u0000" in data and _has_nul(value):
            raise ValueError("a text holds a NUL character")
    except (ValueError, RecursionError) as error:
        raise MalformedInputError(f"The body is not valid JSON: {_reason(error)}.") from error
    return value


def _object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found = dict(pairs)
    if len(found) != len(pairs):
        names = [name for name, _ in pairs]
        twice = next(name for name in names if names.count(name) > 1)
        raise ValueError(f"{twice[:60]!r} is given twice in one object")
    return found


def _has_nul(value: Any) -> bool:
    """Whether any text holds the character that no database stores."""
    if isinstance(value, str):
        return "\0" in value
    if isinstance(value, dict):
        return any("\0" in name or _has_nul(inner) for name, inner in value.items())
    return isinstance(value, list) and any(_has_nul(inner) for inner in value)


def _reason(error: Exception) -> str:
    if isinstance(error, UnicodeDecodeError):
        return "it is not encoded in UTF-8"
    return "it is nested too deeply" if isinstance(error, RecursionError) else str(error).rstrip(".")[:200]


def read(model: type[M], raw: Any) -> M:
    """Validate what was given against a model.

    Raises InvalidInputError with one FieldError per refused value.
    """
    try:
        return model.model_validate(raw)
    except ValidationError as error:
        raise InvalidInputError(field_errors(error.errors(include_url=False), model, raw)) from error


def engine_refusal(error: EngineError, raw: Any = None) -> InvalidInputError:
    """The same refusal as an input error, with what was typed at its place."""
    return InvalidInputError([FieldError(error.path, error.message, _typed(raw, error.path))])


def field_errors(errors: Iterable[ErrorDetails], model: type[BaseModel], raw: Any) -> list[FieldError]:
    """Say each of pydantic's errors in the reader's words, at the path that the reader knows."""
    found: dict[tuple[Path, str], FieldError] = {}
    told = list(errors)
    for error in told:
        if error["type"] == "too_short" and any(_deeper(other["loc"], error["loc"]) for other in told):
            continue  # a list is not short: one of its entries was refused and is told itself
        path = reader_path(error["loc"], raw, missing=error["type"] in ("missing", "related_fields"))
        if error["type"].startswith("union_tag"):
            path = (*path, str(error.get("ctx", {}).get("discriminator", "kind")).strip("'"))
        message = _message(error, model, path, raw)
        found.setdefault((path, message), FieldError(path, message, _typed(raw, path)))
        if len(found) >= MAX_ERRORS:
            break
    return list(found.values())


def _deeper(location: tuple[str | int, ...], outer: tuple[str | int, ...]) -> bool:
    return len(location) > len(outer) and location[: len(outer)] == outer


def reader_path(location: tuple[str | int, ...], raw: Any, *, missing: bool = False) -> Path:
    """Location of an error without what pydantic adds for itself (tags and members of unions).

    ``missing``: the last part names a field, whether it was given or not.

    >>> raw = {"motion": {"kind": "moves", "moves": [{"distance_mm": "x"}]}}
    >>> reader_path(("motion", "moves", "moves", 0, "distance_mm"), raw)
    ('motion', 'moves', 0, 'distance_mm')
    """
    path: list[str | int] = []
    here, entered = raw, True
    for index, part in enumerate(location):
        last = index == len(location) - 1
        if isinstance(here, dict):
            if entered and any(here.get(tag) == part for tag in _TAGS) and not (last and missing):
                entered = False
                continue
            if part not in here and not (last and missing):
                continue
            here = here.get(str(part))
        elif isinstance(here, list) and isinstance(part, int) and part < len(here):
            here = here[part]
        elif not (last and missing):
            continue
        path.append(part)
        entered = True
    return tuple(path)


def _typed(raw: Any, path: Path) -> Any:
    """What was given at ``path``; None where nothing was."""
    for part in path:
        if isinstance(raw, dict):
            raw = raw.get(str(part))
        elif isinstance(raw, list) and isinstance(part, int) and 0 <= part < len(raw):
            raw = raw[part]
        else:
            return None
    return raw


def _message(error: ErrorDetails, model: type[BaseModel], path: Path, raw: Any) -> str:
    """Words for one error; own errors (``quantity...``) are in the reader's words already."""
    context: dict[str, Any] = error.get("ctx") or {}
    match error["type"]:
        case "missing":
            return _missing(model, path, raw)
        case "extra_forbidden":
            return _unknown(model, path, raw)
        case "union_tag_invalid":
            return f"is none of {context.get('expected_tags', '')}"
        case "union_tag_not_found":
            return "is missing: say which kind"
        case "literal_error" | "enum":
            return f"must be {context.get('expected', 'one of the choices')}"
        case "model_type" | "model_attributes_type" | "dict_type":
            return "must be an object with named values"
        case "list_type" | "tuple_type":
            return "must be a list"
        case "string_type":
            return "must be a text"
        case "int_type" | "int_parsing" | "int_from_float":
            return "must be a whole number"
        case "bool_type" | "bool_parsing":
            return "must be true or false"
        case "string_too_long":
            return f"must have at most {context['max_length']} characters"
        case "string_too_short":
            return f"must have at least {context['min_length']} characters"
        case "too_long":
            return f"must have at most {context['max_length']} entries"
        case "too_short":
            return f"must have at least {context['min_length']} entries"
        case "greater_than_equal" | "greater_than" | "less_than_equal" | "less_than":
            return error["msg"].replace("Input should be", "must be")
        case _:
            text = error["msg"].removeprefix("Value error, ")
            return text.replace("Input should be", "must be")


def _missing(model: type[BaseModel], path: Path, raw: Any) -> str:
    for owner in models_at(model, path[:-1], raw):
        for name, info in owner.model_fields.items():
            if (info.alias or name) == path[-1]:
                found = declaration(info)
                if found is None or not found.about:
                    return "is missing"
                unit = f" in {found.unit}" if isinstance(found, Quantity) and found.unit != "1" else ""
                return f"is missing: give {found.about}{unit}"
    return "is missing"


def _unknown(model: type[BaseModel], path: Path, raw: Any) -> str:
    names = [i.alias or n for owner in models_at(model, path[:-1], raw) for n, i in owner.model_fields.items()]
    given = str(path[-1])[:80] if path else ""
    near = difflib.get_close_matches(given, names, n=1, cutoff=0.6)
    return "is not known here" + (f"; did you mean {near[0]}?" if near else "")


def models_at(model: type[BaseModel], path: Path, raw: Any) -> list[type[BaseModel]]:
    """The models that an object at ``path`` may be, narrowed by the kind that is given there."""
    here: list[Any] = [model]
    for part in path:
        raw = _typed(raw, (part,))
        here = [inner for one in here for inner in _inside(one, part)]
        here = _of_kind([m for annotation in here for m in _members(annotation)], raw)
    return [one for one in here if isinstance(one, type) and issubclass(one, BaseModel)]


def _inside(annotation: Any, part: str | int) -> Iterator[Any]:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        for name, info in annotation.model_fields.items():
            if (info.alias or name) == part:
                yield info.annotation
    elif isinstance(part, int) and get_origin(annotation) in (list, tuple):
        yield from (inner for inner in get_args(annotation) if inner is not Ellipsis)


def _members(annotation: Any) -> Iterator[Any]:
    origin = get_origin(annotation)
    if origin is Annotated:
        yield from _members(get_args(annotation)[0])
    elif origin in (Union, types.UnionType):
        for member in get_args(annotation):
            yield from _members(member)
    elif annotation is not type(None):
        yield annotation


def _of_kind(candidates: list[Any], raw: Any) -> list[Any]:
    if len(candidates) < 2 or not isinstance(raw, dict):
        return candidates
    kinds = {str(raw[tag]) for tag in _TAGS if isinstance(raw.get(tag), str)}
    chosen = [
        one
        for one in candidates
        if isinstance(one, type)
        and issubclass(one, Declared)
        and any(str(one.model_fields[tag].default) in kinds for tag in _TAGS if tag in one.model_fields)
    ]
    return chosen or candidates
