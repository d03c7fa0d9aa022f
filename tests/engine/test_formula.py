"""What makes a function a formula, and every function that cannot be one."""

import ast
from collections.abc import Callable
from typing import Annotated, Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.engine import formula as module
from app.engine.formula import Formula, FormulaBody, formula, maximum, registered, sqrt, total, where
from app.engine.units import Kilogram, Metre, MetrePerSecond, Newton, NewtonMetre, One, Second


@pytest.fixture(autouse=True)
def _registry(monkeypatch: pytest.MonkeyPatch) -> None:
    """Formulas made here leave no trace."""
    monkeypatch.setattr(module, "_REGISTRY", dict(module._REGISTRY))


def lever(F: Newton, r: Metre) -> NewtonMetre:
    """Torque of a force
    on a lever.

    Holds at right angles.
    """
    return F * r


def rms(M_k: NewtonMetre, t_k: Second) -> NewtonMetre:
    """Root mean square."""
    t_c = total(t_k)
    return sqrt(total(M_k**2 * t_k) / t_c)


def made(function: Callable[..., Any], **changed: str) -> Formula[..., Any]:
    return formula(**{"symbol": "M", "unit": "N m", "source": "test", **changed})(function)


def test_a_formula_knows_its_declaration() -> None:
    torque = made(lever, unit="N cm")
    assert (torque.name, torque.symbol, torque.unit, torque.si_unit, torque.source, torque.topic) == (
        "lever", "M", "N cm", "N m", "test", "test_formula",
    )  # fmt: skip
    assert torque.parameters == {"F": "N", "r": "m"}
    assert torque.summary == "Torque of a force on a lever."
    assert repr(torque) == "<formula lever: M [N cm]>"
    assert torque.__doc__ == lever.__doc__


def test_floats_give_a_float_and_arrays_an_array() -> None:
    torque = made(lever)
    assert torque(3.0, 2.0) == 6.0
    assert type(torque(3.0, r=2.0)) is float
    assert type(torque(np.float64(3.0), 2.0)) is float
    assert torque([1.0, 2.0], 2.0).tolist() == [2.0, 4.0]
    assert torque((1, 2), np.array([[1.0], [10.0]])).shape == (2, 2)


def test_a_choice_between_floats_gives_a_float() -> None:
    def friction(v: MetrePerSecond, F: Newton) -> Newton:
        """Friction against the motion."""
        return where(v > 0, F, -F)

    assert type(made(friction)(-1.0, 5.0)) is float
    assert made(friction)(-1.0, 5.0) == -5.0


@given(st.lists(st.tuples(st.floats(-1e3, 1e3), st.floats(0, 1e3)), min_size=1, max_size=8))
def test_an_array_gives_what_a_loop_of_floats_gives(pairs: list[tuple[float, float]]) -> None:
    torque = Formula(lever, "M", "N m", "test")
    forces, levers = map(list, zip(*pairs, strict=True))
    assert torque(forces, levers).tolist() == [torque(F, r) for F, r in pairs]


def test_the_body_is_its_intermediates_and_its_result() -> None:
    body = made(rms).body
    assert {name: ast.unparse(node) for name, node in body.intermediates.items()} == {"t_c": "total(t_k)"}
    assert ast.unparse(body.result) == "sqrt(total(M_k ** 2 * t_k) / t_c)"


def test_every_function_that_a_body_may_call_exists() -> None:
    builtin = {"abs"}
    assert all(callable(getattr(module, name)) for name in module.FUNCTIONS - builtin)
    assert maximum(1, 2) == 2


def no_unit_of_argument(F: Newton, r) -> NewtonMetre:  # type: ignore[no-untyped-def]
    """Text."""
    return F * r


def plain_type(F: float) -> NewtonMetre:
    """Text."""
    return F


def no_result(F: Newton):  # type: ignore[no-untyped-def]
    """Text."""
    return F


def late_annotation(F: "Newton") -> Newton:
    """Text."""
    return F


def two_units(F: Annotated[Any, "N", "kN"]) -> Newton:
    """Text."""
    return F


def unit_that_is_no_text(F: Annotated[Any, 1]) -> Newton:
    """Text."""
    return F


def no_docstring(F: Newton) -> Newton:
    return F


def blank_docstring(F: Newton) -> Newton:
    """ """
    return F


@pytest.mark.parametrize(
    "function",
    [no_unit_of_argument, plain_type, no_result, late_annotation, two_units, unit_that_is_no_text, no_docstring,
     blank_docstring],
)  # fmt: skip
def test_an_incomplete_declaration_is_refused(function: Callable[..., Any]) -> None:
    with pytest.raises(TypeError, match=function.__name__):
        made(function)
    assert function.__name__ not in registered()


@pytest.mark.parametrize("missing", [{"symbol": ""}, {"source": ""}, {"source": "  "}])
def test_a_formula_without_symbol_or_source_is_refused(missing: dict[str, str]) -> None:
    with pytest.raises(TypeError, match="symbol and a source"):
        made(lever, **missing)


def with_loop(m: Kilogram) -> Kilogram:
    """Text."""
    for _ in range(3):
        m = m + 1
    return m


def with_branch(m: Kilogram) -> Kilogram:
    """Text."""
    if m > 1:
        return m
    return 2 * m


def without_return(m: Kilogram) -> Kilogram:
    """Text."""
    m = m + 1


def empty_return(m: Kilogram) -> Kilogram:
    """Text."""
    return


def two_targets(m: Kilogram) -> Kilogram:
    """Text."""
    a = b = m
    return a + b


def changed_in_place(m: Kilogram) -> Kilogram:
    """Text."""
    m += 1
    return m


def of_another_module(m: Kilogram) -> Kilogram:
    """Text."""
    return np.sin(m)


def other_function(m: Kilogram) -> Kilogram:
    """Text."""
    return float(m)


def global_constant(m: Kilogram) -> Kilogram:
    """Text."""
    return m * GRAVITY


GRAVITY = 9.81


@pytest.mark.parametrize(
    "function",
    [with_loop, with_branch, without_return, empty_return, two_targets, changed_in_place, of_another_module,
     other_function, global_constant],
)  # fmt: skip
def test_a_body_that_cannot_be_shown_is_refused(function: Callable[..., Any]) -> None:
    with pytest.raises(TypeError, match=function.__name__):
        _ = made(function).body


def test_a_body_knows_the_constant_pi() -> None:
    FormulaBody({}, ast.parse("2 * pi * r", mode="eval").body, made(lever))


def test_a_name_may_be_registered_by_one_module_only() -> None:
    made(lever)
    made(lever)  # the same module once more: a reload

    def lever_of_another(m: One) -> One:
        """Text."""
        return m

    lever_of_another.__name__ = "lever"
    lever_of_another.__module__ = "somewhere.else"
    with pytest.raises(TypeError, match="is a formula in"):
        made(lever_of_another)


def test_registered_formulas_are_sorted_and_cannot_be_changed_through_the_list() -> None:
    made(rms)
    made(lever)
    names = list(registered())
    assert names == sorted(names)
    assert {"lever", "rms"} <= set(names)
    registered().clear()  # type: ignore[attr-defined]
    assert "lever" in registered()
