"""The project document: its format, and what differs between two of them."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.services.documents import FORMAT, VERSION, differences, read_document
from app.services.errors import InvalidInputError
from tests.sizing_requests import SCREW_AXIS

AXIS = {"name": "X", "request": SCREW_AXIS}
EMPTY = {"title": "x", "axes": []}


def with_motion(motion: object) -> dict[str, object]:
    return {"title": "x", "axes": [{"name": "X", "request": {**SCREW_AXIS, "motion": motion}}]}


def refused(raw: object) -> list[tuple[str, str]]:
    with pytest.raises(InvalidInputError) as caught:
        read_document(raw)
    return [(error.name, error.message) for error in caught.value.errors]


def test_a_request_is_kept_as_it_was_typed():
    typed = {**SCREW_AXIS, "mechanism": {**SCREW_AXIS["mechanism"], "lead_mm": " 10,00 "}}
    document = read_document({"title": "Portal", "axes": [{"name": "X", "request": typed}]})
    assert document["axes"][0]["request"] == typed
    assert (document["format"], document["version"]) == (FORMAT, VERSION)


def test_a_document_reads_as_itself():
    once = read_document({"title": "Portal", "axes": [AXIS]})
    assert read_document(once) == once


@pytest.mark.parametrize(
    ("raw", "expected"),
    [
        ({"axes": []}, ("title", "is missing")),
        ({"title": " ", "axes": []}, ("title", "must have at least 1 characters")),
        ({"title": "x", "axes": [AXIS, AXIS]}, ("axes.1.name", "is the name of another axis already")),
        ({"title": "x", "axes": [{"name": "X"}]}, ("axes.0.request", "is missing")),
        (with_motion({}), ("axes.0.request.motion.kind", "is missing: say which kind")),
        ({"title": "x", "axes": [], "edit_token": "y"}, ("edit_token", "is not known here")),
        ({**EMPTY, "format": "x"}, ("format", "must be 'drivewright-project': this is no project file")),
        ({**EMPTY, "version": 2}, ("version", "is newer than this program, which reads documents up to version 1")),
        ({"title": "x", "axes": [AXIS] * 51}, ("axes", "must have at most 50 entries")),
        ("text", ("", "must be an object with named values")),
    ],
)  # fmt: skip
def test_each_mistake_is_told_at_its_place(raw: object, expected: tuple[str, str]):
    assert refused(raw) == [expected]


JSON = st.recursive(
    st.none() | st.booleans() | st.integers(-5, 5) | st.text(max_size=3),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=2), inner, max_size=3),
    max_leaves=8,
)


@given(JSON)
def test_a_document_does_not_differ_from_itself(value: object):
    assert list(differences(value, value)) == []


@given(JSON, JSON)
def test_two_documents_differ_where_they_are_not_the_same(first: object, second: object):
    found = {d.path: (d.before, d.after) for d in differences(first, second)}
    back = {d.path: (d.after, d.before) for d in differences(second, first)}
    assert found == back
    assert bool(found) or _same(first, second)


def _same(first: object, second: object) -> bool:
    """Equal, where a missing value and null are one."""
    if isinstance(first, dict) and isinstance(second, dict):
        return all(_same(first.get(name), second.get(name)) for name in {*first, *second})
    if isinstance(first, list) and isinstance(second, list):
        size = max(len(first), len(second))
        pad = [*first, *[None] * (size - len(first))], [*second, *[None] * (size - len(second))]
        return all(_same(a, b) for a, b in zip(*pad, strict=True))
    return first == second


@pytest.mark.parametrize("value", [1, True, 1.0])
def test_numbers_and_flags_of_the_same_value_differ_as_typed(value: object):
    typed = [d for other in (1, True, 1.0) for d in differences({"a": value}, {"a": other})]
    assert len(typed) == 2
