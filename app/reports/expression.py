"""A formula body as a small tree of its own: read from the syntax tree, substituted, evaluated.

The tree knows nothing of MathML or Typst; :mod:`app.reports.writer` writes it with a notation. Both show the same tree,
and the tree is what was computed: :func:`evaluate` and the formula itself agree.
"""

import ast
import inspect
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from app.engine import formula as engine
from app.engine.formula import FUNCTIONS, Formula
from app.engine.quantity import si_factor


@dataclass(frozen=True)
class Number:
    """A number that stands in the formula itself."""

    value: float


@dataclass(frozen=True)
class Name:
    """An argument, a named intermediate or ``pi``."""

    name: str


@dataclass(frozen=True, eq=False)
class Value:
    """What was put in for a name: a number or an array, in SI."""

    value: Any


@dataclass(frozen=True)
class Negative:
    """Minus the operand."""

    operand: "Expression"


@dataclass(frozen=True)
class Binary:
    """Two operands joined by ``+ - * / **``."""

    operator: str
    left: "Expression"
    right: "Expression"


@dataclass(frozen=True)
class Call:
    """One of the functions that a formula may call."""

    function: str
    arguments: tuple["Expression", ...]


@dataclass(frozen=True)
class Comparison:
    """A chain of comparisons: ``operands[0] operators[0] operands[1] ...``."""

    operators: tuple[str, ...]
    operands: tuple["Expression", ...]


@dataclass(frozen=True)
class Logic:
    """Conditions joined by ``and`` or ``or``, or the contrary of one (``not``)."""

    operator: str
    operands: tuple["Expression", ...]


Expression = Number | Name | Value | Negative | Binary | Call | Comparison | Logic

_ARITHMETIC: dict[type[ast.operator], str] = {
    ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.Pow: "**",
}  # fmt: skip
_COMPARISONS: dict[type[ast.cmpop], str] = {
    ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "==", ast.NotEq: "!=",
}  # fmt: skip
_LOGIC: dict[type[ast.AST], str] = {ast.And: "and", ast.Or: "or", ast.BitAnd: "and", ast.BitOr: "or"}


def read(node: ast.expr) -> Expression:
    """Turn a Python expression into a tree.

    Raises TypeError for what no formula can show: calls of other functions, subscripts, texts.
    """
    match node:
        case ast.Constant(value=bool()):
            pass
        case ast.Constant(value=int() | float() as value):
            return Number(float(value))
        case ast.Name(id=name):
            return Name(name)
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return Negative(read(operand))
        case ast.UnaryOp(op=ast.UAdd(), operand=operand):
            return read(operand)
        case ast.UnaryOp(op=ast.Invert() | ast.Not(), operand=operand):
            return Logic("not", (read(operand),))
        case ast.BinOp(op=operator, left=left, right=right) if type(operator) in _ARITHMETIC:
            return Binary(_ARITHMETIC[type(operator)], read(left), read(right))
        case ast.BinOp(op=operator, left=left, right=right) if type(operator) in _LOGIC:
            return _joined(_LOGIC[type(operator)], read(left), read(right))
        case ast.BoolOp(op=operator, values=values):
            return Logic(_LOGIC[type(operator)], tuple(read(value) for value in values))
        case ast.Compare(left=left, ops=operators, comparators=others) if all(
            type(o) in _COMPARISONS for o in operators
        ):
            return Comparison(tuple(_COMPARISONS[type(o)] for o in operators), tuple(map(read, [left, *others])))
        case ast.Call(func=ast.Name(id=function), args=arguments, keywords=[]) if function in FUNCTIONS:
            return Call(function, tuple(read(argument) for argument in arguments))
    raise TypeError(f"{ast.unparse(node)!r} cannot be shown in a formula")


def _joined(operator: str, left: Expression, right: Expression) -> Logic:
    """Join two conditions; ``a & b & c`` is one chain, not a chain within a chain."""
    chain = left.operands if isinstance(left, Logic) and left.operator == operator else (left,)
    return Logic(operator, (*chain, right))


def children(expression: Expression) -> tuple[Expression, ...]:
    """The operands of an expression, in order."""
    match expression:
        case Negative(operand):
            return (operand,)
        case Binary(_, left, right):
            return (left, right)
        case Call(_, operands) | Comparison(_, operands) | Logic(_, operands):
            return operands
    return ()


def substituted(expression: Expression, values: Mapping[str, Any]) -> Expression:
    """Put values in for the names; a name without value (``pi``) stays."""
    put = [substituted(child, values) for child in children(expression)]
    match expression:
        case Name(name):
            return Value(values[name]) if name in values else expression
        case Negative():
            return Negative(put[0])
        case Binary(operator):
            return Binary(operator, put[0], put[1])
        case Call(function):
            return Call(function, tuple(put))
        case Comparison(operators):
            return Comparison(operators, tuple(put))
        case Logic(operator):
            return Logic(operator, tuple(put))
    return expression


def evaluate(expression: Expression) -> Any:
    """Value of a tree, computed by the operations that the formulas use. Raises KeyError for a name without value."""
    put = [evaluate(child) for child in children(expression)]
    match expression:
        case Number(value) | Value(value):
            return np.asarray(value, dtype=float) if np.ndim(value) else float(value)
        case Name("pi"):
            return engine.pi
        case Name(name):
            raise KeyError(name)
        case Negative():
            return -put[0]
        case Binary(operator):
            return _BINARY[operator](put[0], put[1])
        case Call("abs"):
            return np.abs(put[0])
        case Call(function):
            return getattr(engine, function)(*put)
        case Comparison(operators):
            holds = [_COMPARE[o](a, b) for o, a, b in zip(operators, put, put[1:], strict=False)]
            return np.logical_and.reduce(holds)
        case Logic("not"):
            return np.logical_not(put[0])
        case Logic(operator):
            return (np.logical_and if operator == "and" else np.logical_or).reduce(put)


_BINARY: dict[str, Any] = {
    "+": np.add, "-": np.subtract, "*": np.multiply, "/": np.true_divide, "**": np.float_power,
}  # fmt: skip
_COMPARE: dict[str, Any] = {
    "<": np.less, "<=": np.less_equal, ">": np.greater, ">=": np.greater_equal, "==": np.equal, "!=": np.not_equal,
}  # fmt: skip


@dataclass(frozen=True)
class Equation:
    """One line of a calculation: what is computed, and, with numbers, what was put in and came out (SI)."""

    symbol: str
    expression: Expression
    numbers: Expression | None = None
    value: Any = None
    unit: str = ""
    """SI unit of ``value``; empty for an intermediate, which has no declared unit."""
    shown_unit: str = ""
    """Unit in which the value is shown beside SI; empty where that is the same."""


@cache
def _trees(formula: Formula[..., Any]) -> tuple[tuple[str, Expression], ...]:
    body = formula.body
    return *((name, read(node)) for name, node in body.intermediates.items()), ("", read(body.result))


def symbolic(formula: Formula[..., Any], symbol: str = "") -> tuple[Equation, ...]:
    """Equations of a formula in symbols: the named intermediates in order, then the result.

    Raises TypeError when the body holds what cannot be shown.
    """
    return tuple(Equation(name or symbol or formula.symbol, tree) for name, tree in _trees(formula))


def all_inputs(formula: Formula[..., Any], inputs: Mapping[str, Any]) -> dict[str, Any]:
    """The inputs of a formula in the order of its arguments, with the defaults of those not given."""
    bound = inspect.signature(formula.function).bind(**inputs)
    bound.apply_defaults()
    return dict(bound.arguments)


def with_numbers(
    formula: Formula[..., Any], inputs: Mapping[str, Any], value: Any, *, symbol: str = "", unit: str = ""
) -> tuple[Equation, ...]:
    """Equations of an evaluated formula: ``inputs`` and ``value`` in SI, ``unit`` the one in which it is shown."""
    known = all_inputs(formula, inputs)
    made = []
    for name, tree in _trees(formula):
        put = substituted(tree, known)
        if name:
            with np.errstate(all="ignore"):
                known[name] = evaluate(put)
            made.append(Equation(name, tree, put, known[name]))
        else:
            shown = unit or formula.unit
            same = si_factor(shown) == (1.0, 0.0)
            made.append(Equation(
                symbol or formula.symbol, tree, put, value, shown if same else formula.si_unit, "" if same else shown
            ))  # fmt: skip
    return tuple(made)
