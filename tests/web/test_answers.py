"""The store of answers stays within its bounds and never answers another question."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.web.answers import AnswerCache


def key(question: str, version: str = "v", kind: str = "sizing") -> bytes:
    return AnswerCache.key(kind, version, question.encode())


def test_an_answer_belongs_to_its_question_kind_and_catalogue():
    kept = AnswerCache()
    kept.put(key("a"), b"answer")
    assert kept.get(key("a")) == b"answer"
    assert kept.get(key("b")) is None
    assert kept.get(key("a", version="w")) is None
    assert kept.get(key("a", kind="selection")) is None


def test_what_was_not_asked_for_longest_goes_first():
    kept = AnswerCache(max_entries=2)
    kept.put(key("a"), b"1")
    kept.put(key("b"), b"2")
    assert kept.get(key("a")) == b"1"
    kept.put(key("c"), b"3")
    assert [kept.get(key(name)) for name in "abc"] == [b"1", None, b"3"]


@pytest.mark.parametrize(("size", "found"), [(25, True), (26, False)])
def test_a_very_large_answer_is_not_kept(size: int, found: bool):
    kept = AnswerCache(max_bytes=100)
    kept.put(key("a"), b"x" * size)
    assert (kept.get(key("a")) is not None) == found


@given(st.lists(st.tuples(st.sampled_from("abcdef"), st.integers(0, 30)), max_size=40))
def test_it_holds_at_most_what_it_may(puts: list[tuple[str, int]]):
    kept = AnswerCache(max_entries=4, max_bytes=60)
    for name, size in puts:
        kept.put(key(name), b"x" * size)
        held = [answer for other in "abcdef" if (answer := kept.get(key(other))) is not None]
        assert len(held) <= 4
        assert sum(map(len, held)) <= 60
