"""Formulas and texts as Typst source, for the PDF.

A text reaches Typst only as a string literal (:func:`literal`), so nothing a user typed can act as markup or code.
"""

from collections.abc import Mapping
from typing import Any

from app.engine.formula import Formula
from app.reports import expression, symbols
from app.reports.expression import Equation, Expression
from app.reports.numbers import ELLIPSIS, MINUS, Rounded
from app.reports.symbols import Symbol
from app.reports.writer import Translate, Writer

_SIGN = 'class("unary", minus)'


def literal(text: str) -> str:
    r"""A Typst string literal, valid in code and in formulas; control characters become blanks.

    >>> literal('5" wide \\ #x')
    '"5\\" wide \\\\ #x"'
    """
    plain = "".join(c if c.isprintable() or c == "\n" else " " for c in text)
    return '"' + plain.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'


class TypstWriter(Writer):
    """Writes expressions in Typst's formula language. Parts are divided by blanks, which mean nothing there."""

    def row(self, *parts: str) -> str:
        return " ".join(part for part in parts if part)

    def operator(self, sign: str) -> str:
        return {"<": "lt", ">": "gt", "·": "dot.op", "−": "minus"}.get(sign, sign)

    def minus(self, operand: str) -> str:
        return f"{_SIGN} {operand}"

    def symbol(self, symbol: Symbol, power: str = "") -> str:
        base = symbol.base if _is_letter(symbol.base) else _upright(symbol.base)
        if symbol.prefix:
            base = f"{_upright(symbol.prefix)} {base}"
        if not (symbol.subscript or symbol.primes or power):
            return base
        above = power or (literal(symbol.primes) if symbol.primes else "")
        attached = [f"b: {_upright(symbol.subscript)}"] if symbol.subscript else []
        attached += [f"t: {above}"] if above else []
        return f"attach({base}, {', '.join(attached)})"

    def number(self, number: Rounded) -> str:
        sign = f"{_SIGN} " if number.negative else ""
        digits = sign + literal(number.mantissa.removeprefix(MINUS))
        if number.exponent is None:
            return digits
        power = self.number(Rounded(str(number.exponent).replace("-", MINUS)))
        return f'{digits} dot.op attach("10", t: {power})'

    def array(self, items: list[str]) -> str:
        return f"lr([{'; '.join(item or literal(ELLIPSIS) for item in items)}])"

    def unit(self, unit: str) -> str:
        return f"thin {literal(unit)}" if unit else ""

    def brackets(self, inner: str) -> str:
        return f"lr(({inner}))"

    def fraction(self, above: str, below: str) -> str:
        return f"frac({above}, {below})"

    def power(self, base: str, exponent: str) -> str:
        return f"attach({base}, t: {exponent})"

    def root(self, inner: str) -> str:
        return f"sqrt({inner})"

    def bars(self, inner: str) -> str:
        return f"abs({inner})"

    def function(self, name: str, arguments: list[str]) -> str:
        return f"op({literal(name)}) {self.brackets(', '.join(arguments))}"

    def exponential(self, exponent: str) -> str:
        return f"attach({_upright('e')}, t: {exponent})"

    def sum_sign(self, operand: str) -> str:
        return f"sum {operand}"

    def cases(self, rows: list[tuple[str, str]]) -> str:
        return f"cases({', '.join(f'{value} & quad {condition}' for value, condition in rows)})"

    def words(self, text: str) -> str:
        return literal(f" {text} ")


def _upright(text: str) -> str:
    return f"upright({text if _is_letter(text) else literal(text)})"


def _is_letter(text: str) -> bool:
    return len(text) == 1 and text.isalpha()


def symbol(name: str) -> str:
    """A symbol as the inside of a formula."""
    return TypstWriter().symbol(symbols.read(name))


def of_expression(tree: Expression, *, translate: Translate = str) -> str:
    """One expression as the inside of a formula."""
    return TypstWriter(translate=translate).write(tree)


def symbolic(formula: Formula[..., Any], *, name: str = "", translate: Translate = str) -> tuple[str, ...]:
    """Lines of a formula in symbols, each the inside of a formula; see :func:`app.reports.mathml.symbolic`."""
    return _lines(expression.symbolic(formula, name), translate)


def with_numbers(
    formula: Formula[..., Any],
    inputs: Mapping[str, Any],
    value: Any,
    *,
    name: str = "",
    unit: str = "",
    translate: Translate = str,
) -> tuple[str, ...]:
    """Lines of an evaluated formula, each the inside of a formula; see :func:`app.reports.mathml.with_numbers`."""
    return _lines(expression.with_numbers(formula, inputs, value, symbol=name, unit=unit), translate)


def _lines(equations: tuple[Equation, ...], translate: Translate) -> tuple[str, ...]:
    writer = TypstWriter(translate=translate)
    return tuple(line for equation in equations for line in writer.lines(equation))
