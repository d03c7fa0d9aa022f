"""A posted form, taken apart: what was typed, and which button was pressed."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, Any

from fastapi import Depends, Request
from starlette.datastructures import UploadFile

from app.services.errors import FieldError, InvalidInputError, MalformedInputError
from app.services.selection import choose
from app.web.form_data import nested, with_row_added, with_row_removed

MAX_FIELDS = 20_000
LARGEST_VERSION = 2**31 - 1
ADD, REMOVE, ACTION, USE = "add", "remove", "action", "use"
"""Names of the buttons: a row to a list, a row away, everything else, and a candidate to be taken."""


@dataclass(frozen=True)
class Submission:
    """What a form sent."""

    raw: dict[str, Any]
    """What was typed, with the row added or removed that was asked for."""
    action: str
    """``calculate``, ``save`` ...; ``update`` where only the form itself changes."""
    steering: Mapping[str, str] = field(default_factory=dict)
    """Entries beside the axis: names that begin with an underscore, without it."""
    files: Mapping[str, bytes] = field(default_factory=dict)
    lists: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """All values of each steering entry, in order."""

    @property
    def version(self) -> int:
        """Version of the project that was edited. Raises InvalidInputError."""
        return self.number("version")

    def number(self, name: str) -> int:
        """A count among the steering entries. Raises InvalidInputError."""
        text = self.steering.get(name, "")
        if not text.isascii() or not text.isdigit() or int(text[:20]) > LARGEST_VERSION:
            raise InvalidInputError([FieldError((name,), "must be a whole number", text)])
        return int(text)


def submission_of(pairs: list[tuple[str, str]], files: Mapping[str, bytes] | None = None) -> Submission:
    """Take posted pairs apart.

    >>> found = submission_of([("m.0.x", "1"), ("_version", "2"), ("add", "m")])
    >>> found.raw, found.action, found.version
    ({'m': [{'x': '1'}, {}]}, 'update', 2)
    """
    if any("\0" in name or "\0" in value for name, value in pairs):
        raise MalformedInputError("An entry holds a NUL character.")
    buttons = {name: value for name, value in pairs if name in (ADD, REMOVE, ACTION, USE)}
    raw = nested((name, value) for name, value in pairs if name not in buttons)
    if ADD in buttons:
        raw = with_row_added(raw, buttons[ADD])
    elif REMOVE in buttons:
        raw = with_row_removed(raw, buttons[REMOVE])
    if USE in buttons:
        motor, _, gear = buttons[USE].partition("|")
        raw = choose(raw, motor, gear or None)
    lists: dict[str, tuple[str, ...]] = {}
    for name, value in pairs:
        if name.startswith("_"):
            lists[name[1:]] = (*lists.get(name[1:], ()), value)
    steering = {name[1:]: value for name, value in pairs if name.startswith("_")}
    only_form = ADD in buttons or REMOVE in buttons
    return Submission(raw, "update" if only_form else buttons.get(ACTION, "calculate"), steering, files or {}, lists)


async def get_submission(request: Request) -> Submission:
    """The form in the body of a request."""
    async with request.form(max_files=1, max_fields=MAX_FIELDS) as form:
        pairs = [(name, value) for name, value in form.multi_items() if isinstance(value, str)]
        files = {name: await value.read() for name, value in form.multi_items() if isinstance(value, UploadFile)}
    return submission_of(pairs, files)


Submitted = Annotated[Submission, Depends(get_submission)]
