"""Formulas of straight motion, read for rotation: angle for distance, angular speed for speed, and so on.

The formula stays written once; only its symbols and units are put in place, so that a sheet of a turntable shows
phi = omega * t and not metres.
"""

import ast
import copy
from collections.abc import Mapping
from functools import cache, cached_property
from inspect import Parameter, Signature
from typing import Annotated, Any

from app.engine.formula import Formula, FormulaBody

SYMBOLS: Mapping[str, str] = {
    "s": "phi", "v": "omega", "a": "alpha_s", "a_d": "alpha_d", "j": "j_phi",
    "s_A": "phi_A", "s_D": "phi_D", "s_max": "phi_max", "v_m": "omega_m", "a_m": "alpha_m", "a_r": "alpha_r",
}  # fmt: skip
"""Symbol of rotation for each symbol of straight motion that has another."""
UNITS: Mapping[str, str] = {"m": "rad", "m/s": "rad/s", "m/s2": "rad/s2", "m/s3": "rad/s3"}
SHOWN: Mapping[str, str] = {"m": "deg", "m/s": "rpm", "m/s2": "rad/s2", "m/s3": "rad/s3"}


class RotaryFormula(Formula[..., Any]):
    """A formula of straight motion under the symbols and units of rotation; ``linear`` is the registered original."""

    def __init__(self, linear: Formula[..., Any]) -> None:
        self.linear = linear
        names = {name: SYMBOLS.get(name, name) for name in linear.parameters}
        back = {new: old for old, new in names.items()}

        def function(**values: Any) -> Any:
            return linear(**{back[name]: value for name, value in values.items()})

        units = {names[name]: UNITS.get(unit, unit) for name, unit in linear.parameters.items()}
        function.__name__, function.__module__ = linear.name, linear.function.__module__
        function.__doc__ = _renamed_text(linear.function.__doc__ or "")
        function.__annotations__ = {name: Annotated[Any, unit] for name, unit in units.items()}
        function.__annotations__["return"] = Annotated[Any, UNITS.get(linear.si_unit, linear.si_unit)]
        function.__signature__ = Signature([Parameter(name, Parameter.KEYWORD_ONLY) for name in units])  # type: ignore[attr-defined]
        symbol, unit = SYMBOLS.get(linear.symbol, linear.symbol), SHOWN.get(linear.unit, linear.unit)
        super().__init__(function, symbol, unit, linear.source)

    @cached_property
    def body(self) -> FormulaBody:
        """The body of the original with the symbols of rotation."""
        original = self.linear.body
        intermediates = {SYMBOLS.get(n, n): _renamed(tree) for n, tree in original.intermediates.items()}
        return FormulaBody(intermediates, _renamed(original.result), self)


@cache
def rotary(linear: Formula[..., Any]) -> RotaryFormula:
    """The formula for rotation; its arguments are named as ``SYMBOLS`` says.

    >>> from app.engine.formulas.motion import ramp_time
    >>> rotary(ramp_time)(omega=10.0, alpha_s=5.0)
    2.0
    """
    return RotaryFormula(linear)


def _renamed(tree: ast.expr) -> ast.expr:
    made = copy.deepcopy(tree)
    for node in ast.walk(made):
        if isinstance(node, ast.Name):
            node.id = SYMBOLS.get(node.id, node.id)
    return made


def _renamed_text(text: str) -> str:
    """Docstring with its ``marked`` symbols replaced, without the example (which holds for the original)."""
    parts = text.split(">>>")[0].split("``")
    return "``".join(SYMBOLS.get(part, part) if index % 2 else part for index, part in enumerate(parts))
