"""What a form sends, as the nested values that services read, and back: nothing typed is changed on the way.

Names are dotted paths: ``motion.moves.0.distance_mm``. Entries left empty are left out, so that defaults apply. Parts
of a name that begin with an underscore steer the form itself (``_row`` marks a row, ``_choice`` chooses between parts)
and never reach a service.
"""

from collections.abc import Iterable, Iterator, Mapping
from typing import Any, cast

from pydantic import BaseModel

from app.web.form_models import Models, border, model_of, row_of, tag_of, union_members

MAX_ROWS = 500
"""Rows of one list beyond this are not read."""
MAX_DEPTH = 8
NONE = "none"
"""Value of a ``_choice`` that leaves an optional part out."""
GIVEN = "given"
"""Value of a ``_choice`` that takes an optional part whose entries stand directly in it."""


def nested(items: Iterable[tuple[str, str]]) -> dict[str, Any]:
    """Turn posted ``mechanism.lead_mm = 20`` pairs into nested dicts and lists of texts; empty entries are left out.

    >>> nested([("a.b", "1"), ("a.c", ""), ("m.0.x", "2"), ("m.2._row", "1")])
    {'a': {'b': '1'}, 'm': [{'x': '2'}, {}]}
    >>> nested([("motor._choice", "id"), ("motor.own.mass_kg", "3")])
    {'motor': {'id': ''}}
    """
    tree: dict[str, Any] = {}
    for name, value in items:
        parts = name.split(".")
        if value.strip() and len(parts) <= MAX_DEPTH and all(parts):
            _put(tree, parts, value)
    return {key: found for key, value in tree.items() if (found := _cleaned(value)) is not None and key[0] != "_"}


def _put(tree: dict[str, Any], parts: list[str], value: str) -> None:
    here: Any = tree
    for part in parts[:-1]:
        here = here.setdefault(part, {})
        if not isinstance(here, dict):
            return
    if not isinstance(here.get(parts[-1]), dict):
        here[parts[-1]] = value


def _cleaned(tree: Any) -> Any:
    """Apply choices, drop steering names, make lists of numbered entries; None where nothing is left."""
    if not isinstance(tree, dict):
        return tree
    choice = tree.get("_choice")
    if choice == NONE:
        return None
    if tree and all(key.isdecimal() and key.isascii() and len(key) < 6 for key in tree):
        rows = [_cleaned(value) for _, value in sorted((int(key), value) for key, value in tree.items())]
        return [{} if row is None else row for row in rows[:MAX_ROWS]]
    made = {key: _cleaned(value) for key, value in tree.items() if not key.startswith("_")}
    made = {key: value for key, value in made.items() if value is not None}
    if isinstance(choice, str) and choice != GIVEN:
        return {choice: made.get(choice, "" if choice == "id" else {})}
    return made if made or choice or "_row" in tree else None


def flat(raw: Any, prefix: str = "") -> Iterator[tuple[str, str]]:
    """The opposite of :func:`nested`: dotted names and texts, e.g. for a link or a form that carries a request.

    >>> list(flat({"m": [{"x": 2.0}, {}], "b": True}))
    [('m.0._row', '1'), ('m.0.x', '2'), ('m.1._row', '1'), ('b', 'true')]
    """
    if isinstance(raw, Mapping):
        for key, value in raw.items():
            yield from flat(value, f"{prefix}.{key}" if prefix else str(key))
    elif isinstance(raw, (list, tuple)):
        for index, value in enumerate(raw):
            yield f"{prefix}.{index}._row", "1"
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
    return f"{value:.15g}" if isinstance(value, float) else str(value)


def fitted(model: type[BaseModel], raw: Any) -> dict[str, Any]:
    """The same values where each choice between parts is made: its tag is set, entries of the other parts are gone.

    A choice nobody made falls on the first part, and a list that is needed begins with an empty row. Entries that the
    model does not know are kept, to be refused.
    """
    values = dict(raw) if isinstance(raw, Mapping) else {}
    for attribute, info in model.model_fields.items():
        name, row = border(attribute, info), row_of(info)
        members, inner = union_members(info.annotation), model_of(info.annotation)
        if row is not None and info.is_required():
            values[name] = values.get(name) or [{}]
        if row is not None and isinstance(values.get(name), (list, tuple)):
            values[name] = [_fitted_row(row, value) for value in values[name]]
        elif len(members) > 1:
            values[name] = _fitted_member(members, values.get(name))
        elif inner is not None and isinstance(values.get(name), Mapping):
            values[name] = fitted(inner, values[name])
    return values


def _fitted_row(row: Any, raw: Any) -> dict[str, Any]:
    members, model = union_members(row), model_of(row)
    if len(members) > 1 or model is None:
        return _fitted_member(members, raw)
    return fitted(model, raw)


def _fitted_member(members: Models, raw: Any) -> dict[str, Any]:
    values = raw if isinstance(raw, Mapping) else {}
    tag = tag_of(members)
    selected = selected_member(members, values)
    model = members[selected]
    known = {border(attribute, info) for attribute, info in model.model_fields.items()}
    others = {border(a, i) for member in members.values() for a, i in member.model_fields.items()} - known
    kept = {k: v for k, v in values.items() if k not in others and k != tag}
    return fitted(model, {tag: selected, **_without_foreign(kept, model, list(members.values()))})


def _without_foreign(raw: Mapping[str, Any], model: type[BaseModel], others: list[type[BaseModel]]) -> dict[str, Any]:
    """Without the entries inside nested parts that belong to a part of the same name in another member.

    After another kind of drive is chosen, the data sheet of a servomotor is no data of an induction motor.
    """
    made = dict(raw)
    for attribute, info in model.model_fields.items():
        name, inner = border(attribute, info), model_of(info.annotation)
        if inner is None or not isinstance(made.get(name), Mapping):
            continue
        same = [found for other in others if attribute in other.model_fields
                and (found := model_of(other.model_fields[attribute].annotation)) is not None]  # fmt: skip
        known = {border(a, i) for a, i in inner.model_fields.items()}
        foreign = {border(a, i) for one in same for a, i in one.model_fields.items()} - known
        left = {key: value for key, value in made[name].items() if key not in foreign}
        made[name] = _without_foreign(left, inner, same)
    return made


def selected_member(members: Models, raw: Any) -> str:
    """Tag of the member that was chosen; the first one where none was."""
    typed = raw.get(tag_of(members)) if isinstance(raw, Mapping) else None
    return typed if isinstance(typed, str) and typed in members else next(iter(members))


def with_row_added(raw: dict[str, Any], path: str) -> dict[str, Any]:
    """The same values with an empty row at the end of the list at ``path``."""
    added = _with_rows(raw, path.split("."), lambda rows: [*rows, {}] if len(rows) < MAX_ROWS else rows)
    return cast(dict[str, Any], added)


def with_row_removed(raw: dict[str, Any], path: str) -> dict[str, Any]:
    """The same values without the row at ``path``: ``motion.moves.1``."""
    *parts, last = path.split(".")
    if not last.isdecimal() or not last.isascii() or len(last) > 5:
        return raw
    removed = _with_rows(raw, parts, lambda rows: [row for index, row in enumerate(rows) if index != int(last)])
    return cast(dict[str, Any], removed)


def _with_rows(tree: Any, parts: list[str], change: Any) -> Any:
    if len(parts) > MAX_DEPTH:
        return tree
    if not parts:
        return change(tree if isinstance(tree, list) else [])
    key, rest = parts[0], parts[1:]
    if isinstance(tree, list):
        known = key.isdecimal() and key.isascii() and len(key) < 6 and int(key) < len(tree)
        return [_with_rows(v, rest, change) if known and n == int(key) else v for n, v in enumerate(tree)]
    values = dict(tree) if isinstance(tree, Mapping) else {}
    return {**values, key: _with_rows(values.get(key), rest, change)}
