"""A formula is its own documentation: the function that computes a value is also what a reader sees.

::

    @formula(symbol="F_r", unit="N", source="DIN 22101")
    def guide_friction(mu: One, F_N: Newton) -> Newton:
        \"""Friction of a guide under a normal force. ...\"""
        return mu * F_N

Called plainly, a formula takes floats or arrays. Through a :class:`~app.engine.sheet.Sheet` the same call is recorded
as a step. What is shown is rendered from the function's own syntax tree (``app.reports``), so it cannot differ from
what was computed. The body is one expression, with a few named intermediates where it must be.
"""

import ast
import inspect
import textwrap
from collections.abc import Callable, Mapping
from functools import cached_property, update_wrapper
from typing import Any, Generic, ParamSpec, TypeVar, get_args

import numpy as np

P = ParamSpec("P")
R = TypeVar("R")

pi = np.pi
sqrt, sin, cos, tan, arctan, exp, log, sign = np.sqrt, np.sin, np.cos, np.tan, np.arctan, np.exp, np.log, np.sign
minimum, maximum, where = np.minimum, np.maximum, np.where
total = np.sum
"""Sum over the elements of an array; shown as a sum sign."""

FUNCTIONS = frozenset(
    ["sqrt", "sin", "cos", "tan", "arctan", "exp", "log", "sign", "minimum", "maximum", "where", "total", "abs"]
)
"""What a formula body may call."""

_REGISTRY: dict[str, "Formula[..., Any]"] = {}


class Formula(Generic[P, R]):
    """A registered formula: a function that knows its symbol, unit, source and syntax tree.

    ``unit`` is the unit in which a result is shown; arguments and results themselves are SI (``parameters`` and
    ``si_unit`` name the SI unit of each).
    """

    def __init__(self, function: Callable[P, R], symbol: str, unit: str, source: str) -> None:
        update_wrapper(self, function)
        self.function = function
        self.name: str = function.__name__
        self.symbol = symbol
        self.unit = unit
        self.source = source
        self.topic: str = function.__module__.rsplit(".", 1)[-1]
        hints = inspect.get_annotations(function)
        self.si_unit: str = _unit_of(hints.pop("return", None), self.name)
        self.parameters: dict[str, str] = {name: _unit_of(hint, self.name) for name, hint in hints.items()}
        if list(self.parameters) != list(inspect.signature(function).parameters):
            raise TypeError(f"{self.name}: every argument needs a unit")
        if not (function.__doc__ or "").strip():
            raise TypeError(f"{self.name}: a formula needs a docstring")
        if not (symbol.strip() and source.strip()):
            raise TypeError(f"{self.name}: a formula needs a symbol and a source")

    def __call__(self, *args: P.args, **kwargs: P.kwargs) -> R:
        """Evaluate: floats give a float, arrays (or lists) give an array of the broadcast shape."""
        plain = [_array(value) for value in args]
        named = {name: _array(value) for name, value in kwargs.items()}
        result: Any = self.function(*plain, **named)
        value: R = result.item() if isinstance(result, (np.generic, np.ndarray)) and result.ndim == 0 else result
        return value

    def __repr__(self) -> str:
        return f"<formula {self.name}: {self.symbol} [{self.unit}]>"

    @property
    def summary(self) -> str:
        """First paragraph of the docstring: what the result is."""
        return " ".join((inspect.getdoc(self.function) or "").split("\n\n")[0].split())

    @cached_property
    def body(self) -> "FormulaBody":
        """The parsed body: named intermediates in order, then the result expression."""
        tree = ast.parse(textwrap.dedent(inspect.getsource(self.function))).body[0]
        assert isinstance(tree, ast.FunctionDef)
        intermediates: dict[str, ast.expr] = {}
        for node in tree.body[1:]:
            match node:
                case ast.Assign(targets=[ast.Name(id=name)], value=value):
                    intermediates[name] = value
                case ast.Return(value=ast.expr() as value):
                    return FormulaBody(intermediates, value, self)
                case _:
                    break
        raise TypeError(f"{self.name}: the body must be named intermediates and one returned expression")


class FormulaBody:
    """Syntax of a formula: ``intermediates`` (name -> expression) and ``result`` (expression), checked."""

    def __init__(self, intermediates: Mapping[str, ast.expr], result: ast.expr, owner: "Formula[..., Any]") -> None:
        self.intermediates = dict(intermediates)
        self.result = result
        known = {*owner.parameters, *self.intermediates, "pi", *FUNCTIONS}
        for expression in (*self.intermediates.values(), result):
            for node in ast.walk(expression):
                if isinstance(node, ast.Name) and node.id not in known:
                    raise TypeError(f"{owner.name}: {node.id!r} is neither an argument nor a known function")


def formula(*, symbol: str, unit: str, source: str) -> Callable[[Callable[P, R]], Formula[P, R]]:
    """Register a function as a formula. ``source`` names document and clause; own derivations say "derived: ...".

    Raises TypeError for a name registered twice, an argument or result without unit, and where docstring, symbol or
    source is missing. A body that cannot be shown raises TypeError when it is first shown.
    """

    def register(function: Callable[P, R]) -> Formula[P, R]:
        made = Formula(function, symbol, unit, source)
        known = _REGISTRY.get(made.name)
        if known is not None and known.function.__module__ != function.__module__:
            raise TypeError(f"{made.name} is a formula in {known.function.__module__} already")
        _REGISTRY[made.name] = made
        return made

    return register


def registered() -> Mapping[str, "Formula[..., Any]"]:
    """All formulas of the modules imported so far, by name (``app.engine.formulas`` imports every one)."""
    return dict(sorted(_REGISTRY.items()))


def _unit_of(hint: Any, owner: str) -> str:
    arguments = get_args(hint)
    if len(arguments) != 2 or not isinstance(arguments[1], str):
        raise TypeError(f"{owner}: annotate arguments and result with a name of app.engine.units")
    return arguments[1]


def _array(value: Any) -> Any:
    return np.asarray(value, dtype=float) if isinstance(value, (list, tuple)) else value
