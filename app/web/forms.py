"""Forms derived from declarations: what an input is called, its unit, default and choices stand in the model only.

A form is a tree of views that templates iterate over. Texts are the English ones of the declarations; templates
translate them.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal, get_args, get_origin

from pydantic import BaseModel
from pydantic.fields import FieldInfo
from pydantic_core import PydanticUndefined

from app.engine.quantity import Declaration, Option, Quantity, declaration, from_si, in_shown_order
from app.reports.symbols import read as read_symbol
from app.services.errors import FieldError
from app.web.form_data import GIVEN, NONE, selected_member, text_of
from app.web.form_models import (
    Models,
    border,
    is_optional,
    is_tag,
    model_of,
    plain,
    row_of,
    tag_of,
    union_members,
)

LEADING_FIELDS = 5
"""So many entries of a row are always seen; the others open on demand."""
LONG_TEXT = 300
"""A text that may be longer than this gets several lines."""


@dataclass(frozen=True)
class FieldView:
    """One entry. ``kind`` is ``number``, ``choice``, ``count``, ``text`` or ``long_text``."""

    name: str
    """Dotted path: name in the form, and where errors belong."""
    kind: str
    label: str
    """What it is, in the words of the declaration."""
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

    @property
    def symbol_text(self) -> str:
        """The symbol as plain text."""
        return read_symbol(self.symbol).text if self.symbol else ""

    @property
    def touched(self) -> bool:
        """Whether there is something to see: a value, an error, or an entry that is needed."""
        return bool(self.required or self.value or self.error)


@dataclass(frozen=True)
class GroupView:
    """Entries under one heading (which may be empty)."""

    title: str
    fields: tuple[FieldView, ...]
    further: bool = False
    """Whether these are the less usual entries of the group before."""

    @property
    def open(self) -> bool:
        """Whether to show the entries at once: some are needed or typed, or most have no default to rest on."""
        if any(entry.touched for entry in self.fields):
            return True
        return not self.further and 2 * sum(not entry.default for entry in self.fields) > len(self.fields)

    @property
    def touched(self) -> bool:
        """Whether something was typed here, or refused."""
        return any(entry.value or entry.error for entry in self.fields)


@dataclass(frozen=True)
class PartView:
    """One model: its entries by group, then its lists and nested parts."""

    name: str
    title: str
    groups: tuple[GroupView, ...]
    lists: tuple["ListView", ...] = ()
    parts: tuple["PartView | ChoiceView", ...] = ()
    is_choice: bool = False

    @property
    def touched(self) -> bool:
        """Whether something was typed here, or refused."""
        return any(part.touched for part in (*self.groups, *self.lists, *self.parts))


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

    @property
    def touched(self) -> bool:
        """Whether there are rows, or an error."""
        return bool(self.rows or self.error)


@dataclass(frozen=True)
class ChoiceView:
    """One of several parts (``kind`` of a motion, "catalogue or own" of a motor)."""

    name: str
    title: str
    control: str
    """Name of the control that chooses."""
    choices: tuple[tuple[str, str], ...]
    selected: str
    chosen: PartView | None
    """None where no part is wanted."""
    error: str = ""
    is_choice: bool = True

    @property
    def id(self) -> str:
        """Identifier of the control on the page."""
        return field_id(self.control)

    @property
    def touched(self) -> bool:
        """Whether something was chosen or refused."""
        return bool(self.selected != self.choices[0][0] or self.error or (self.chosen and self.chosen.touched))


@dataclass
class Reader:
    """Builds views: ``errors`` by dotted path; ``places`` collects where each path is shown: identifier and label."""

    errors: Mapping[str, str]
    places: dict[str, tuple[str, str]] = field(default_factory=dict)

    def error(self, name: str, element: str, label: str) -> str:
        """The error at a path, empty where there is none."""
        self.places.setdefault(name, (element, label))
        return self.errors.get(name, "")


def field_id(name: str) -> str:
    """Identifier on the page for a dotted path."""
    return "f-" + name.replace(".", "-")


def errors_by_name(errors: Iterable[FieldError]) -> dict[str, str]:
    """Errors of a service by dotted path; several at one place are joined."""
    found: dict[str, str] = {}
    for error in errors:
        found[error.name] = f"{found[error.name]}; {error.message}" if error.name in found else error.message
    return found


def part_view(model: type[BaseModel], raw: Any, reader: Reader, name: str = "", title: str = "") -> PartView:
    """View of a model with what was typed. ``raw`` that is no mapping counts as nothing typed."""
    values = raw if isinstance(raw, Mapping) else {}
    groups: dict[str, list[FieldView]] = {}
    lists: list[ListView] = []
    parts: list[PartView | ChoiceView] = []
    for attribute, info in in_shown_order(model):
        key = border(attribute, info)
        path, typed = (f"{name}.{key}" if name else key), values.get(key)
        found, row = declaration(info), row_of(info)
        if is_tag(info):
            continue
        if row is not None:
            lists.append(_list_view(row, typed, reader, path, _label(found, attribute)))
        elif found is not None:
            groups.setdefault(found.group, []).append(field_view(found, info, attribute, typed, reader, path))
        else:
            parts.extend(_nested_parts(info, attribute, typed, reader, path))
    shown = tuple(GroupView(heading, tuple(entries)) for heading, entries in groups.items())
    return PartView(name, title or str(getattr(model, "title", "") or ""), shown, tuple(lists), tuple(parts))


def choice_view(models: Models, raw: Any, reader: Reader, name: str, title: str) -> ChoiceView:
    """View of a union whose members are told apart by a tag; the first one is taken where none is typed."""
    tag = tag_of(models)
    selected = selected_member(models, raw)
    choices = tuple((kind, _title_of(model, kind)) for kind, model in models.items())
    control = f"{name}.{tag}"
    error = reader.error(control, field_id(control), title) or reader.error(name, field_id(control), title)
    return ChoiceView(
        name, title, control, choices, selected, part_view(models[selected], raw, reader, name), error
    )  # fmt: skip


def optional_view(model: type[BaseModel], typed: Any, reader: Reader, path: str, title: str) -> ChoiceView:
    """A part that may be left out; one with ``id`` and ``own`` is taken from the catalogue or typed."""
    control = f"{path}._choice"
    error = reader.error(path, field_id(control), title)
    given = typed if isinstance(typed, Mapping) else {}
    own = model.model_fields.get("own")
    if "id" not in model.model_fields:
        chosen = part_view(model, given, reader, path) if typed is not None else None
        choices: tuple[tuple[str, str], ...] = ((NONE, "not wanted"), (GIVEN, "wanted"))
        return ChoiceView(path, title, control, choices, NONE if chosen is None else GIVEN, chosen, error)
    choices = ((NONE, "not chosen yet"), ("id", "from the catalogue"))
    if own is not None:
        choices = (*choices, ("own", "from its data sheet"))
    if own is not None and "own" in given:
        own_model = model_of(own.annotation)
        assert own_model is not None
        chosen = part_view(own_model, given["own"], reader, f"{path}.own")
        return ChoiceView(path, title, control, choices, "own", chosen, error)
    if "id" in given:
        info = model.model_fields["id"]
        entry = field_view(Declaration(about="identifier in the catalogue"), info, "id", given["id"], reader,
                           f"{path}.id")  # fmt: skip
        return ChoiceView(path, title, control, choices, "id", PartView(path, "", (GroupView("", (entry,)),)), error)
    return ChoiceView(path, title, control, choices, NONE, None, error)


def field_view(found: Declaration, info: FieldInfo, attribute: str, typed: Any, reader: Reader, path: str) -> FieldView:
    """View of one entry."""
    default = found.default if found.default is not PydanticUndefined else info.default
    label = _label(found, attribute)
    kind, choices = _control(found, info)
    return FieldView(
        name=path, kind=kind, label=label, symbol=found.symbol,
        unit=found.unit if isinstance(found, Quantity) and found.unit != "1" else "",
        value=", ".join(text_of(item) for item in typed) if isinstance(typed, (list, tuple)) else text_of(typed),
        default="" if default in (None, PydanticUndefined, "", ()) else _default_text(found, default),
        source=found.source, required=info.is_required(), error=reader.error(path, field_id(path), label),
        choices=choices,
    )  # fmt: skip


def _nested_parts(
    info: FieldInfo, attribute: str, typed: Any, reader: Reader, path: str
) -> list[PartView | ChoiceView]:
    members, model = union_members(info.annotation), model_of(info.annotation)
    title = humanised(attribute)
    if len(members) > 1:
        return [choice_view(members, typed, reader, path, title)]
    if model is None:
        return []
    if is_optional(info):
        return [optional_view(model, typed, reader, path, title)]
    return [part_view(model, typed, reader, path, title)]


def _list_view(row: Any, typed: Any, reader: Reader, path: str, title: str) -> ListView:
    rows = typed if isinstance(typed, (list, tuple)) else []
    members, model = union_members(row), model_of(row)
    views: list[PartView | ChoiceView] = []
    for index, values in enumerate(rows):
        name = f"{path}.{index}"
        if len(members) > 1:
            views.append(choice_view(members, values, reader, name, str(index + 1)))
        elif model is not None:
            reader.error(name, field_id(name), title)
            found = part_view(model, values, reader, name, str(index + 1))
            views.append(PartView(name, found.title, _row_groups(found.groups), found.lists, found.parts))
    return ListView(path, title, "", tuple(views), reader.error(path, field_id(path), title))


def _row_groups(groups: tuple[GroupView, ...]) -> tuple[GroupView, ...]:
    """The usual entries of a row first, the further ones of the same group behind."""
    if not groups:
        return ()
    first, rest = groups[0], groups[1:]
    usual, further = first.fields[:LEADING_FIELDS], first.fields[LEADING_FIELDS:]
    made = [GroupView("", usual)]
    if further:
        made.append(GroupView(first.title, further, further=True))
    return (*made, *(GroupView(group.title, group.fields, further=True) for group in rest))


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
    annotation = plain(info.annotation)
    labels = found.labels if isinstance(found, Option) else {}
    if get_origin(annotation) is Literal:
        return "choice", tuple((str(value), str(labels.get(value, value))) for value in get_args(annotation))
    if annotation is bool:
        return "choice", (("true", "yes"), ("false", "no"))
    if annotation is int:
        return "count", ()
    limit = max((getattr(item, "max_length", None) or 0 for item in info.metadata), default=0)
    return ("long_text" if limit > LONG_TEXT else "text"), ()


def _label(found: Declaration | None, attribute: str) -> str:
    text = (found.label or found.about) if found is not None else ""
    return text or humanised(attribute)


def humanised(attribute: str) -> str:
    """An attribute as words.

    >>> humanised("gear_unit")
    'Gear unit'
    """
    return attribute.replace("_", " ").capitalize()


def _title_of(model: type[BaseModel], kind: str) -> str:
    return str(getattr(model, "title", "") or humanised(kind))
