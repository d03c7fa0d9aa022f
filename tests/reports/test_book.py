"""The formula book holds the whole library."""

import pytest

from app.engine.formula import registered
from app.reports import formula_text
from app.reports.book import find, formula_book, title
from tests.reports.examples import sample_effective_torque, sample_rolling_resistance


def test_every_formula_of_the_library_is_in_the_book_once() -> None:
    shown = [entry.name for topic in formula_book() for entry in topic.formulas]
    library = [name for name, made in registered().items() if made.function.__module__.startswith("app.engine.")]
    assert sorted(shown) == library
    assert len(shown) > 10


def test_topics_stand_in_the_order_of_their_headings() -> None:
    titles = [topic.title for topic in formula_book()]
    assert titles == sorted(titles)
    assert len(titles) == len(set(titles))


def test_an_entry_says_all_about_its_formula() -> None:
    entry = find("retrograde_efficiency")
    assert (entry.topic, entry.unit_text, entry.symbol_text) == ("efficiency", "", "η′")
    assert [(a.name, a.symbol_text, a.meaning, a.unit) for a in entry.arguments] == [("eta", "η", "efficiency", "1")]
    assert entry.example.startswith(">>> retrograde_efficiency(0.8)")
    assert len(entry.lines) == 1
    assert entry.typst == ('attach(η, t: "′") = op("max") lr(("2" minus frac("1", η), "0"))',)
    assert "self-locking" in "".join(entry.plain_notes) + entry.summary


def test_an_intermediate_has_a_line_of_its_own() -> None:
    assert len(find("sample_effective_torque").lines) == 2


def test_an_unknown_formula_is_no_entry() -> None:
    with pytest.raises(KeyError):
        find("no_such_formula")


def test_texts_are_translated() -> None:
    entry = find("retrograde_efficiency", str.upper)
    assert entry.summary.isupper()
    assert entry.arguments[0].meaning == "EFFICIENCY"


def test_a_topic_without_heading_is_called_by_its_module() -> None:
    assert title("dc_link") == "Dc link"


def test_a_docstring_is_taken_apart() -> None:
    text = formula_text.read(sample_rolling_resistance)
    assert text.summary == "Resistance of a wheeled load."
    assert text.paragraphs == ("``m`` mass, ``D`` wheel, ``d`` bearing; holds on <dry> rails & small ``slip_angle``.",)
    assert text.example == ">>> 1 + 1\n2"
    assert formula_text.read(sample_effective_torque).paragraphs == ()


def test_names_in_a_note_become_symbols_or_code() -> None:
    note = formula_text.to_html("``mu_L`` <of> ``slip_angle``", sample_rolling_resistance)
    assert note == (
        '<math display="inline"><msub><mi>μ</mi><mtext>L</mtext></msub></math> &lt;of&gt; <code>slip_angle</code>'
    )
