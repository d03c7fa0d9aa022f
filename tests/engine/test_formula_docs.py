"""Every formula of the library documents itself, and one symbol means one thing in all of them."""

import ast
from collections import Counter

import pint
import pytest

import app.engine.formulas  # noqa: F401  (registers every formula)
from app.engine import glossary
from app.engine.formula import Formula, registered
from app.engine.glossary import GLOSSARY
from app.engine.quantity import si_factor
from app.reports.numbers import unit_text

LIBRARY = [made for made in registered().values() if made.function.__module__.startswith("app.engine.")]
FORBIDDEN_FACTORS = {9.55, 9550.0, 91.2, 19100.0, 9.549, 30.0 / 3.14}
"""Unit factors in disguise: the engine computes in SI and rad/s."""


def by_name(made: Formula[..., object]) -> str:
    return made.name


@pytest.mark.parametrize("made", LIBRARY, ids=by_name)
def test_the_docstring_begins_with_a_sentence(made: Formula[..., object]) -> None:
    assert made.summary.endswith(".")
    assert made.summary[0].isupper()
    assert len(made.summary) < 160


@pytest.mark.parametrize("made", LIBRARY, ids=by_name)
def test_the_docstring_has_an_example_that_is_run(made: Formula[..., object]) -> None:
    assert f">>> {made.name}(" in str(made.__doc__) or f"{made.name}(" in str(made.__doc__).partition(">>> ")[2]


@pytest.mark.parametrize("made", LIBRARY, ids=by_name)
def test_the_source_says_where_the_formula_comes_from(made: Formula[..., object]) -> None:
    assert len(made.source) > 5
    assert made.source == made.source.strip()


@pytest.mark.parametrize("made", LIBRARY, ids=by_name)
def test_every_argument_has_its_one_meaning_and_unit(made: Formula[..., object]) -> None:
    wrong = [
        f"{name} [{unit}]: "
        + (f"the glossary says [{GLOSSARY[name].unit}]" if name in GLOSSARY else "not in the glossary")
        for name, unit in made.parameters.items()
        if name not in GLOSSARY or GLOSSARY[name].unit != unit
    ]
    assert not wrong, "app/engine/glossary.py: one name, one meaning"


@pytest.mark.parametrize("made", LIBRARY, ids=by_name)
def test_what_is_shown_measures_what_is_computed(made: Formula[..., object]) -> None:
    assert dimension(made.unit) == dimension(made.si_unit)
    assert si_factor(made.si_unit) == (pytest.approx(1.0), 0.0)


def dimension(unit: str) -> object:
    """Dimension of a unit, by a registry of its own."""
    registry = pint.application_registry.get()
    spelt = unit_text(unit).replace("·", "*") or "dimensionless"
    for raised, power in {"²": "**2", "³": "**3", "⁴": "**4", "⁻¹": "**-1"}.items():
        spelt = spelt.replace(raised, power)
    return registry.Unit(spelt.replace("°", "deg")).dimensionality


@pytest.mark.parametrize("made", LIBRARY, ids=by_name)
def test_no_unit_factor_hides_in_a_formula(made: Formula[..., object]) -> None:
    for tree in (*made.body.intermediates.values(), made.body.result):
        found = {float(node.value) for node in ast.walk(tree) if isinstance(node, ast.Constant)}
        assert not found & FORBIDDEN_FACTORS


def test_the_library_is_not_empty() -> None:
    assert len(LIBRARY) > 20


def test_the_glossary_names_each_symbol_once() -> None:
    names = Counter(name for names, _, _ in glossary._TERMS for name in names.split())
    assert [name for name, count in names.items() if count > 1] == []


def test_the_glossary_holds_no_symbol_that_nothing_uses() -> None:
    used = {name for made in LIBRARY for name in made.parameters}
    grown = {"J_k", "m_k", "v_k", "F_k", "M_k", "t_k", "k_k", "T_k", "omega_k"}  # variants, whether used yet or not
    assert sorted(set(GLOSSARY) - used - grown) == []


@pytest.mark.parametrize("name", sorted(GLOSSARY))
def test_a_meaning_is_a_phrase_and_its_unit_is_si(name: str) -> None:
    term = GLOSSARY[name]
    assert term.meaning
    assert not term.meaning.endswith(".")
    assert si_factor(term.unit) == (pytest.approx(1.0), 0.0)


def test_a_name_without_entry_has_no_meaning() -> None:
    assert glossary.meaning("no_such_symbol") == ""
    assert glossary.meaning("eta") == "efficiency"
