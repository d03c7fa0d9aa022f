"""Forms derived from declarations: what an input is called, its unit, default and choices stand in the model only.

A form is a tree of views that templates iterate over. What was typed stays as typed: a posted form becomes a nested
``raw`` dict of texts (:func:`nested`), which the same services read as they read JSON. Empty entries are left out, so that
defaults apply. Names that begin with an underscore steer the form itself (``_row`` marks a row, ``_choice`` a choice
between parts) and never reach a service.
"""

import types
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import BaseModel
from pydantic.fields import FieldInfo
from pydantic_core import PydanticUndefined

from app.engine.quantity import Declaration, Declared, Option, Quantity, declaration, from_si
from app.services.errors import FieldError

MAX_ROWS = 500
"""Rows of one list beyond this are not read."""
MAX_DEPTH = 8
NONE = "none"
"""Value of a ``_choice`` that leaves an optional part out."""

Path = tuple[str | int, ...]
Errors = Mapping[str, str]


@dataclass(frozen=True)
class FieldView:
    """One entry. ``kind`` is ``number``, ``choice``, ``count``, ``text`` or ``long_text``."""

    name: str
    """Dotted path: name in the form, and where errors belong."""
    kind: str
    label: str
    symbol: str
    unit: str
    value: str
    """As typed; empty where nothing was."""
    default: str
    """What is taken while nothing is typed, empty where an entry is needed or nothing is taken."""
    source: str
    required: bool
    error: str = ""
    choices: tuple[tuple[str, str], ...] = ()

    @property
    def id(self) -> str:
        """Identifier of the control on the page."""
        return field_id(self.name)


@dataclass(frozen=True)
class GroupView:
    """Entries under one heading (which may be empty)."""

    title: str
    fields: tuple[FieldView, ...]


@dataclass(frozen=True)
class PartView:
    """One model: its entries by group, then its lists and nested parts."""

    name: str
    title: str
    groups: tuple[GroupView, ...]
    lists: tuple["ListView", ...] = ()
    parts: tuple["PartView | ChoiceView", ...] = ()


@dataclass(frozen=True)
class ListView:
    """A list of parts: one row each."""

    name: str
    title: str
    row_title: str
    rows: tuple["PartView | ChoiceView", ...]
    error: str = ""

    @property
    def id(self) -> str:
        """Identifier of the list on the page."""
        return field_id(self.name)


@dataclass(frozen=True)
class ChoiceView:
    """One of several parts (``kind`` of a motion, "catalogue or own" of a motor); ``chosen`` is None where none is wanted."""

    name: str
    title: str
    control: str
    """Name of the control that chooses."""
    choices: tuple[tuple[str, str], ...]
    selected: str
    chosen: PartView | None
    error: str = ""

    @property
    def id(self) -> str:
        """Identifier of the control on the page."""
        return field_id(self.control)


@dataclass
class Reader:
    """Builds views: ``errors`` by dotted path; ``used`` collects the paths that some view shows."""

    errors: Errors
    used: set[str] = field(default_factory=set)

    def error(self, name: str) -> str:
        """The error at a path, empty where there is none."""
        self.used.add(name)
        return self.errors.get(name, "")


def field_id(name: str) -> str:
    """Identifier on the page for a dotted path."""
    return "f-" + name.replace(".", "-")


def dotted(path: Iterable[str | int]) -> str:
    """One dotted name for a path."""
    return ".".join(str(part) for part in path)


def errors_by_name(errors: Iterable[FieldError]) -> dict[str, str]:
    """Errors of a service by dotted path; several at one place are joined."""
    found: dict[str, str] = {}
    for error in errors:
        name = dotted(error.path)
        found[name] = f"{found[name]}; {error.message}" if name in found else error.message
    return found


def nested(items: Iterable[tuple[str, str]]) -> dict[str, Any]:
    """Turn posted ``mechanism.lead_mm = 20`` pairs into nested dicts and lists of texts; empty entries are left out.

    >>> nested([("a.b", "1"), ("a.c", ""), ("m.0.x", "2"), ("m.2._row", "1")])
    {'a': {'b': '1'}, 'm': [{'x': '2'}, {}]}
    """
    tree: dict[str, Any] = {}
    for name, value in items:
        parts = name.split(".")
        if not value.strip() or len(parts) > MAX_DEPTH or any(not part for part in parts):
            continue
        here: Any = tree
        for part in parts[:-1]:
            here = here.setdefault(part, {})
            if not isinstance(here, dict):
                break
        if isinstance(here, dict) and not isinstance(here.get(parts[-1]), dict):
            here[parts[-1]] = value
    cleaned = _cleaned(tree)
    return cleaned if isinstance(cleaned, dict) else {}


def _cleaned(tree: Any) -> Any:
    """Apply choices, drop steering names, make lists of numbered entries."""
    if not isinstance(tree, dict):
        return tree
    choice = tree.get("_choice")
    if choice is not None:
        kept = {key: value for key, value in tree.items() if key == choice}
        return {key: _cleaned(value) for key, value in kept.items()} if choice != NONE else None
    if tree and all(key.isdecimal() and key.isascii() for key in tree):
        numbered = sorted((int(key), value) for key, value in tree.items() if len(key) < 6)
        return [_cleaned(value) for _, value in numbered[:MAX_ROWS]]
    made = {key: _cleaned(value) for key, value in tree.items() if not key.startswith("_")}
    return {key: value for key, value in made.items() if value is not None and (value != {} or _is_row(tree[key]))}


def _is_row(value: Any) -> bool:
    return isinstance(value, dict) and "_row" in value


def flat(raw: Any, prefix: str = "") -> Iterable[tuple[str, str]]:
    """The opposite of :func:`nested`: dotted names and texts of a raw request, e.g. for a link that carries a form."""
    if isinstance(raw, Mapping):
        for key, value in raw.items():
            yield from flat(value, f"{prefix}.{key}" if prefix else str(key))
    elif isinstance(raw, (list, tuple)):
        for index, value in enumerate(raw):
            yield from flat(value, f"{prefix}.{index}")
    elif raw is not None:
        yield prefix, text_of(raw)


def text_of(value: Any) -> str:
    """A raw value as a reader would type it.

    >>> [text_of(v) for v in (True, 20.0, 0.5, "250 mm", None)]
    ['true', '20', '0.5', '250 mm', '']
    """
    if value is None:
        return ""
    if isinstance(value, bool):
        return "true" if value else "false"
    return f"{value:.12g}" if isinstance(value, float) else str(value)


def part_view(model: type[BaseModel], raw: Any, reader: Reader, name: str = "", title: str = "") -> PartView:
    """View of a model with what was typed. ``raw`` that is no dict counts as nothing typed."""
    values = raw if isinstance(raw, Mapping) else {}
    groups: dict[str, list[FieldView]] = {}
    lists: list[ListView] = []
    parts: list[PartView | ChoiceView] = []
    for attribute, info in model.model_fields.items():
        border = info.alias or attribute
        path, typed = (f"{name}.{border}" if name else border), values.get(border)
        found = declaration(info)
        if _is_tag(info):
            continue
        row = _row_model(info)
        if row is not None:
            lists.append(_list_view(row, typed, reader, path, _label(found, attribute)))
        elif found is not None:
            groups.setdefault(found.group, []).append(_field_view(found, info, attribute, typed, reader, path))
        else:
            parts.extend(_nested_part(info, attribute, typed, reader, path))
    shown = tuple(GroupView(heading, tuple(entries)) for heading, entries in groups.items())
    return PartView(name, title or str(getattr(model, "title", "") or ""), shown, tuple(lists), tuple(parts))


def choice_view(models: Mapping[str, type[BaseModel]], raw: Any, reader: Reader, name: str, title: str) -> ChoiceView:
    """View of a union whose members are told apart by ``kind`` (or ``shape``); the first is taken where none is typed."""
    tag = "shape" if any("shape" in model.model_fields for model in models.values()) else "kind"
    typed = raw.get(tag) if isinstance(raw, Mapping) else None
    selected = typed if isinstance(typed, str) and typed in models else next(iter(models))
    choices = tuple((kind, _title_of(model, kind)) for kind, model in models.items())
    chosen = part_view(models[selected], raw, reader, name)
    control = f"{name}.{tag}"
    return ChoiceView(name, title, control, choices, selected, chosen, reader.error(control) or reader.error(name))


def union_members(annotation: Any) -> dict[str, type[BaseModel]]:
    """Members of a tagged union of models by tag; empty where the annotation is no such union."""
    if get_origin(annotation) is Annotated:
        return union_members(get_args(annotation)[0])
    members = get_args(annotation) if get_origin(annotation) in (Union, types.UnionType) else ()
    found: dict[str, type[BaseModel]] = {}
    for member in members:
        if isinstance(member, type) and issubclass(member, BaseModel):
            tag = member.model_fields.get("shape") or member.model_fields.get("kind")
            if tag is not None and isinstance(tag.default, str):
                found[tag.default] = member
    return found


def _nested_part(info: FieldInfo, attribute: str, typed: Any, reader: Reader, path: str) -> list[PartView | ChoiceView]:
    members = union_members(info.annotation)
    title = humanised(attribute)
    if len(members) > 1:
        return [choice_view(members, typed, reader, path, title)]
    model = _model_of(info.annotation)
    if model is None:
        return []
    optional = type(None) in get_args(info.annotation)
    if not optional:
        return [part_view(model, typed, reader, path, title)]
    return [_optional_view(model, typed, reader, path, title)]


def _optional_view(model: type[BaseModel], typed: Any, reader: Reader, path: str, title: str) -> ChoiceView:
    """A part that may be left out; one with ``id`` and ``own`` is taken from the catalogue or typed."""
    given = typed if isinstance(typed, Mapping) else {}
    control, error = f"{path}._choice", reader.error(path)
    if "id" not in model.model_fields:
        selected = "given" if given else NONE
        chosen = part_view(model, given, reader, path) if given else None
        return ChoiceView(path, title, control, ((NONE, "none"), ("given", "given")), selected, chosen, error)
    choices = [(NONE, "not chosen"), ("id", "from the catalogue")]
    if "own" in model.model_fields:
        choices.append(("own", "own data sheet"))
    selected = "own" if "own" in given and "own" in model.model_fields else "id" if "id" in given else NONE
    chosen = None
    if selected == "id":
        found = declaration(model.model_fields["id"]) or Declaration(about="catalogue identifier")
        info = model.model_fields["id"]
        entry = _field_view(found, info, "id", given.get("id"), reader, f"{path}.id")
        chosen = PartView(path, "", (GroupView("", (entry,)),))
    elif selected == "own":
        own = _model_of(model.model_fields["own"].annotation)
        assert own is not None
        chosen = part_view(own, given.get("own"), reader, f"{path}.own")
    return ChoiceView(path, title, control, tuple(choices), selected, chosen, error)


def _list_view(row: Any, typed: Any, reader: Reader, path: str, title: str) -> ListView:
    rows = typed if isinstance(typed, (list, tuple)) else []
    members = union_members(row)
    views: list[PartView | ChoiceView] = []
    for index, values in enumerate(rows):
        name = f"{path}.{index}"
        model = _model_of(row)
        if len(members) > 1:
            views.append(choice_view(members, values, reader, name, f"{index + 1}"))
        elif model is not None:
            views.append(part_view(model, values, reader, name, f"{index + 1}"))
    return ListView(path, title, title.rstrip("s"), tuple(views), reader.error(path))


def _field_view(
    found: Declaration, info: FieldInfo, attribute: str, typed: Any, reader: Reader, path: str
) -> FieldView:
    default = found.default if found.default is not PydanticUndefined else info.default
    required = info.is_required()
    kind, choices = _control(found, info)
    return FieldView(
        name=path, kind=kind, label=_label(found, attribute), symbol=found.symbol,
        unit=found.unit if isinstance(found, Quantity) and found.unit != "1" else "",
        value=text_of(typed) if not isinstance(typed, (list, tuple)) else ", ".join(text_of(item) for item in typed),
        default="" if required or default in (None, PydanticUndefined, "", ()) else _default_text(found, default),
        source=found.source, required=required, error=reader.error(path), choices=choices,
    )  # fmt: skip


def _default_text(found: Declaration, default: Any) -> str:
    if isinstance(found, Quantity):
        return text_of(from_si(float(default), found.unit))
    if isinstance(default, bool):
        return "yes" if default else "no"
    labels = found.labels if isinstance(found, Option) else {}
    return str(labels.get(default, default))


def _control(found: Declaration, info: FieldInfo) -> tuple[str, tuple[tuple[str, str], ...]]:
    """Kind of control and its choices."""
    if isinstance(found, Quantity):
        return "number", ()
    annotation = _plain(info.annotation)
    labels = found.labels if isinstance(found, Option) else {}
    if get_origin(annotation) is Literal:
        return "choice", tuple((str(value), str(labels.get(value, value))) for value in get_args(annotation))
    if annotation is bool:
        return "choice", (("true", "yes"), ("false", "no"))
    if annotation is int:
        return "count", ()
    limit = next((m.max_length for m in info.metadata if getattr(m, "max_length", None)), 0)
    return ("long_text" if limit > 1000 else "text"), ()


def _label(found: Declaration | None, attribute: str) -> str:
    text = (found.label or found.about) if found is not None else ""
    return text[:1].upper() + text[1:] if text else humanised(attribute)


def humanised(attribute: str) -> str:
    """An attribute as words.

    >>> humanised("gear_unit")
    'Gear unit'
    """
    return attribute.replace("_", " ").capitalize()


def _title_of(model: type[BaseModel], kind: str) -> str:
    return str(getattr(model, "title", "") or humanised(kind))


def _is_tag(info: FieldInfo) -> bool:
    annotation = _plain(info.annotation)
    return get_origin(annotation) is Literal and len(get_args(annotation)) == 1 and declaration(info) is None


def _row_model(info: FieldInfo) -> Any:
    """What a list holds when it holds models, else None."""
    annotation = _plain(info.annotation)
    if get_origin(annotation) not in (list, tuple):
        return None
    row = get_args(annotation)[0]
    return row if _model_of(row) is not None or union_members(row) else None


def _plain(annotation: Any) -> Any:
    """An annotation without Annotated and without None."""
    if get_origin(annotation) is Annotated:
        return _plain(get_args(annotation)[0])
    if get_origin(annotation) in (Union, types.UnionType):
        rest = [member for member in get_args(annotation) if member is not type(None)]
        return _plain(rest[0]) if len(rest) == 1 else annotation
    return annotation


def _model_of(annotation: Any) -> type[BaseModel] | None:
    plain = _plain(annotation)
    return plain if isinstance(plain, type) and issubclass(plain, (BaseModel, Declared)) else None
