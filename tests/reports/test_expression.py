"""What is shown is what was computed: the written formula, read back by a reader of its own, gives the same value."""

import ast
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import app.engine.formulas  # noqa: F401  (registers every formula)
from app.engine.formula import registered
from app.reports import expression, mathml, symbols
from app.reports.expression import Equation, evaluate, read, substituted, symbolic, with_numbers
from app.reports.mathml import MathmlWriter
from tests.reports import examples
from tests.reports.mathml_reader import Reader, UnclearError

SCALARS = {"a": "-3", "b": "2", "mu_L": "0.5", "Delta_t_1": "-1.25", "x_dd": "20000000", "c": "0.000001"}
ARRAYS = {"v": ["4", "-2", "0"], "w": ["1", "0.5", "-3"]}


def tree(source: str) -> expression.Expression:
    return read(ast.parse(source, mode="eval").body)


def as_floats() -> dict[str, Any]:
    return {
        **{name: float(value) for name, value in SCALARS.items()},
        **{name: [float(item) for item in items] for name, items in ARRAYS.items()},
    }


def as_fractions() -> dict[str, Any]:
    """The same numbers, exact: no order of operations rounds, so equal means equal."""
    return {
        **{name: Fraction(value) for name, value in SCALARS.items()},
        **{name: np.array([Fraction(item) for item in items]) for name, items in ARRAYS.items()},
    }


@st.composite
def sources(draw: st.DrawFn, depth: int = 4) -> str:
    """Python source of an expression; every operand is bracketed, so the source itself is beyond doubt."""

    def inner() -> str:
        return f"({draw(sources(depth - 1))})"

    def condition() -> str:
        compared = f"({inner()} {draw(st.sampled_from(['<', '<=', '>', '>=', '==']))} {inner()})"
        joined = draw(st.sampled_from(["", "", "", "&", "|"]))
        return f"({compared} {joined} {condition()})" if joined else compared

    kind = draw(st.sampled_from(["leaf", *["+-*/"] * 4, "minus", "**", "total", "call", "where"])) if depth else "leaf"
    match kind:
        case "+-*/":
            return f"{inner()} {draw(st.sampled_from('+-*/'))} {inner()}"
        case "minus":
            return f"-{inner()}"
        case "**":
            return f"{inner()} ** {draw(st.integers(1, 3))}"
        case "total":
            return f"total({draw(elementwise())})"
        case "call":
            name = draw(st.sampled_from(["abs", "minimum", "maximum"]))
            return f"{name}({inner()})" if name == "abs" else f"{name}({inner()}, {inner()})"
        case "where":
            return f"where({condition()}, {inner()}, {inner()})"
    return draw(st.sampled_from([*SCALARS, "0", "2", "7"]))


@st.composite
def elementwise(draw: st.DrawFn, depth: int = 3) -> str:
    """Source of an expression of arrays."""
    if not depth or draw(st.booleans()):
        return draw(st.sampled_from(sorted(ARRAYS)))
    if draw(st.booleans()):
        return f"-({draw(elementwise(depth - 1))})"
    return f"({draw(elementwise(depth - 1))}) {draw(st.sampled_from('+-*'))} ({draw(elementwise(depth - 1))})"


PYTHON: dict[str, Any] = {
    "total": np.sum, "abs": abs, "minimum": min, "maximum": max, "where": lambda c, a, b: a if c else b,
}  # fmt: skip


class Exact(ast.NodeTransformer):
    """Turns each number of a source into a fraction."""

    def visit_Constant(self, node: ast.Constant) -> ast.expr:
        return ast.Call(ast.Name("Fraction", ast.Load()), [node], [])


def exactly(source: str) -> Any:
    """Value of the source by Python itself, in fractions; None where it divides by zero."""
    exact = ast.fix_missing_locations(Exact().visit(ast.parse(source, mode="eval")))
    try:
        return eval(compile(exact, "source", "eval"), {**PYTHON, **as_fractions(), "Fraction": Fraction})
    except ZeroDivisionError:
        return None


@given(sources())
def test_a_written_formula_reads_as_the_code_computes(source: str) -> None:
    expected = exactly(source)
    names = {symbols.read(name).text: value for name, value in as_fractions().items()}
    shown = mathml.of_expression(tree(source))
    if expected is None:
        with pytest.raises(ZeroDivisionError):
            Reader(Fraction, names).read(shown)
    else:
        assert Reader(Fraction, names).read(shown) == expected, shown


@given(sources())
def test_the_numbers_put_in_read_as_the_code_computes(source: str) -> None:
    expected = exactly(source)
    shown = mathml.math(MathmlWriter(digits=12).write(substituted(tree(source), as_floats())))
    if expected is not None:
        assert Reader(Fraction, {}).read(shown) == expected, shown


@pytest.mark.parametrize(
    ("wrong", "why"),
    [
        ("<math><mn>2</mn><mo>−</mo><mo>−</mo><mn>1</mn></math>", "two signs"),
        ("<math><msup><mrow><mo>−</mo><mn>3</mn></mrow><mn>2</mn></msup></math>", "power of a signed number"),
        ("<math><mn>2</mn><mo>·</mo><mo>∑</mo><mn>1</mn></math>", "sum sign within a product"),
        ("<math><mn>2</mn><mn>1</mn></math>", "two numbers beside each other"),
    ],
)
def test_the_reader_refuses_what_is_unclear(wrong: str, why: str) -> None:
    with pytest.raises(UnclearError):
        Reader().read(wrong)


@pytest.mark.parametrize("name", list(registered()))
def test_every_formula_shows_what_it_computes(name: str) -> None:
    formula = registered()[name]
    inputs = examples.inputs_of(formula)
    with np.errstate(all="ignore"):
        value = formula(**inputs)
        result = with_numbers(formula, inputs, value)[-1]
        assert result.numbers is not None
        np.testing.assert_allclose(evaluate(result.numbers), value, rtol=1e-12)
        names = {symbols.read(n).text: np.array(v) if np.ndim(v) else v for n, v in inputs.items()}
        for equation in symbolic(formula):
            shown = Reader(float, names).read(mathml.of_expression(equation.expression))
            names[symbols.read(equation.symbol).text] = shown
        np.testing.assert_allclose(shown, value, rtol=1e-9)


def test_an_intermediate_is_shown_with_its_value() -> None:
    M_k, t_k = [4.0, -2.0, 0.0], [1.0, 1.0, 2.0]
    between, result = with_numbers(examples.sample_effective_torque, {"M_k": M_k, "t_k": t_k}, 5**0.5)
    assert (between.symbol, between.value) == ("t_c", 4.0)  # 1 + 1 + 2
    assert evaluate(result.numbers) == pytest.approx(5**0.5)  # type: ignore[arg-type]


def test_a_default_of_a_formula_is_put_in() -> None:
    inputs = {"c_T": 2.0, "J": 0.5}
    assert expression.all_inputs(examples.sample_natural_frequency, inputs) == {**inputs, "zeta": 0.0}
    assert "<mn>0</mn>" in mathml.with_numbers(examples.sample_natural_frequency, inputs, 1 / np.pi)[-1]


def test_the_shown_unit_is_added_where_it_is_not_si() -> None:
    result = with_numbers(examples.sample_through_stage, {"M": 2.0, "eta": 0.5}, 4.0)[-1]
    assert (result.unit, result.shown_unit) == ("N m", "N cm")
    same = with_numbers(examples.sample_through_stage, {"M": 2.0, "eta": 0.5}, 4.0, unit="N m")[-1]
    assert (same.unit, same.shown_unit) == ("N m", "")


@pytest.mark.parametrize(
    "source",
    ["a[0]", "a.b", "f(a)", "sqrt(x=a)", "'text'", "a if b else c", "a // b", "a % b", "True", "[a, b]", "a is b"],
)
def test_what_no_formula_can_show_is_refused(source: str) -> None:
    with pytest.raises(TypeError, match="cannot be shown"):
        tree(source)


def test_a_name_without_value_is_not_evaluated() -> None:
    with pytest.raises(KeyError):
        evaluate(tree("a + b"))
    assert evaluate(tree("pi")) == pytest.approx(3.141592653589793)


def test_an_equation_of_a_plain_value_is_not_repeated() -> None:
    line = MathmlWriter().lines(Equation("F", tree("F"), expression.Value(5.0), 5.0, "N"))[1]
    assert line.count("<mn>5</mn>") == 1
