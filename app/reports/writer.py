"""Writes an expression tree in a notation, with no more brackets than its meaning needs.

Precedence is decided here, once; a notation (MathML, Typst) only says how a fraction, a root or a power looks.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable
from enum import IntEnum
from typing import Any

import numpy as np

from app.reports import symbols
from app.reports.expression import (
    Binary,
    Call,
    Comparison,
    Equation,
    Expression,
    Logic,
    Name,
    Negative,
    Number,
    Value,
)
from app.reports.numbers import DIGITS, Rounded, elements, in_unit, rounded, unit_text
from app.reports.symbols import Symbol

Translate = Callable[[str], str]
"""Turns an English text into the reader's language."""


def never_empty(translate: Translate) -> Translate:
    """The same translation for use on texts that may be empty: to gettext the empty text is the catalogue's header."""
    return lambda text: translate(text) if text else ""


_EXACT = 12
"""Digits of a number that stands in the formula itself: it is shown as it is."""
_SHOWN_OPERATORS = {"+": "+", "-": "−", "*": "·", "<": "<", "<=": "≤", ">": ">", ">=": "≥", "==": "=", "!=": "≠"}
_FUNCTION_NAMES = {"log": "ln", "minimum": "min", "maximum": "max", "sign": "sgn"}


class Binding(IntEnum):
    """How tightly an expression holds together, loosest first."""

    CASES = 0
    LOGIC = 1
    COMPARISON = 2
    ADDITION = 3
    SUM_SIGN = 4
    PRODUCT = 5
    POWER = 6
    FUNCTION = 7
    ATOM = 8


def binding(expression: Expression, digits: int = DIGITS) -> Binding:
    """How tightly the written form of an expression holds together; a fraction bar holds like a product."""
    match expression:
        case Number(value) | Value(value):
            return Binding.ATOM if np.ndim(value) else _number_binding(rounded(float(value), digits))
        case Name(name):
            return Binding.POWER if symbols.read(name).primes else Binding.ATOM
        case Binary("+" | "-"):
            return Binding.ADDITION
        case Binary("**") | Call("exp"):
            return Binding.POWER
        case Binary() | Negative():
            return Binding.PRODUCT
        case Call("where"):
            return Binding.CASES
        case Call("total"):
            return Binding.SUM_SIGN
        case Call("abs"):
            return Binding.ATOM
        case Call():
            return Binding.FUNCTION
        case Comparison():
            return Binding.COMPARISON
        case Logic():
            return Binding.LOGIC


def _number_binding(number: Rounded) -> Binding:
    return Binding.PRODUCT if number.negative or number.exponent is not None else Binding.ATOM


def leads_with_minus(expression: Expression) -> bool:
    """Whether the written form begins with a minus sign, so that no other sign may stand before it."""
    match expression:
        case Negative():
            return True
        case Number(value) | Value(value):
            return not np.ndim(value) and float(value) < 0
        case Binary("+" | "-" | "*", left):
            return leads_with_minus(left)
    return False


class Writer(ABC):
    """Writes expressions; the abstract methods are the notation, ``translate`` serves words such as "otherwise"."""

    def __init__(self, *, digits: int = DIGITS, translate: Translate = str) -> None:
        self.digits = digits
        self.translate = translate

    @abstractmethod
    def row(self, *parts: str) -> str:
        """Parts beside each other."""

    @abstractmethod
    def operator(self, sign: str) -> str:
        """A sign between two operands."""

    @abstractmethod
    def minus(self, operand: str) -> str:
        """A minus sign before an operand."""

    @abstractmethod
    def symbol(self, symbol: Symbol, power: str = "") -> str:
        """A symbol, on request raised to a power."""

    @abstractmethod
    def number(self, number: Rounded) -> str:
        """A rounded number."""

    @abstractmethod
    def array(self, items: list[str]) -> str:
        """The elements of an array; an empty text stands for those left out."""

    @abstractmethod
    def unit(self, unit: str) -> str:
        """A typeset unit behind a number."""

    @abstractmethod
    def brackets(self, inner: str) -> str:
        """Round brackets."""

    @abstractmethod
    def fraction(self, above: str, below: str) -> str:
        """A fraction."""

    @abstractmethod
    def power(self, base: str, exponent: str) -> str:
        """A power."""

    @abstractmethod
    def root(self, inner: str) -> str:
        """A square root."""

    @abstractmethod
    def bars(self, inner: str) -> str:
        """An absolute value."""

    @abstractmethod
    def function(self, name: str, arguments: list[str]) -> str:
        """A function by its name."""

    @abstractmethod
    def exponential(self, exponent: str) -> str:
        """A power of e."""

    @abstractmethod
    def sum_sign(self, operand: str) -> str:
        """A sum over the elements of what follows."""

    @abstractmethod
    def cases(self, rows: list[tuple[str, str]]) -> str:
        """A distinction of cases: (value, condition) per row, the last condition being a word."""

    @abstractmethod
    def words(self, text: str) -> str:
        """A word within a formula."""

    def write(self, expression: Expression) -> str:
        """Write an expression."""
        match expression:
            case Number(value):
                return self.number(rounded(value, _EXACT))
            case Value(value):
                return self.value(value)
            case Name(name):
                return self.symbol(symbols.read(name))
            case Negative(operand):
                return self.minus(self._within(operand, Binding.SUM_SIGN, after_sign=True))
            case Binary(operator, left, right):
                return self._binary(operator, left, right)
            case Call(function, arguments):
                return self._call(function, arguments)
            case Comparison(operators, operands):
                parts = [self._within(operands[0], Binding.ADDITION)]
                for sign, operand in zip(operators, operands[1:], strict=True):
                    parts += [self.operator(_SHOWN_OPERATORS[sign]), self._within(operand, Binding.ADDITION)]
                return self.row(*parts)
            case Logic("not", operands):
                return self.row(self.words(self.translate("not")), self._within(operands[0], Binding.POWER))
            case Logic(operator, operands):
                word = self.words(self.translate(operator))
                return self._joined(word, [self._within(operand, Binding.COMPARISON) for operand in operands])

    def value(self, value: Any) -> str:
        """Write a number or an array that was put in."""
        if np.ndim(value):
            return self.array(["" if v is None else self.number(rounded(v, self.digits)) for v in elements(value)])
        return self.number(rounded(float(value), self.digits))

    def lines(self, equation: Equation) -> tuple[str, ...]:
        """Write an equation: the line in symbols and, where there are numbers, the line with them put in."""
        equals = self.operator("=")
        first = self.row(self.symbol(symbols.read(equation.symbol)), equals, self.write(equation.expression))
        if equation.numbers is None:
            return (first,)
        parts = [equals] if isinstance(equation.numbers, Value) else [equals, self.write(equation.numbers), equals]
        parts += [self.value(equation.value), self.unit(unit_text(equation.unit or "1"))]
        if equation.shown_unit:
            parts += [equals, self.value(in_unit(equation.value, equation.shown_unit))]
            parts += [self.unit(unit_text(equation.shown_unit))]
        return first, self.row(*parts)

    def _within(self, expression: Expression, floor: Binding, *, after_sign: bool = False) -> str:
        """Write an operand, in brackets where it holds less tightly than its place asks."""
        text = self.write(expression)
        loose = binding(expression, _EXACT if isinstance(expression, Number) else self.digits) < floor
        return self.brackets(text) if loose or (after_sign and leads_with_minus(expression)) else text

    def _binary(self, operator: str, left: Expression, right: Expression) -> str:
        if operator == "/":
            return self.fraction(self.write(left), self.write(right))
        if operator == "**":
            exponent = self.write(right)
            if isinstance(left, Name) and binding(left) == Binding.ATOM:
                return self.symbol(symbols.read(left.name), exponent)
            return self.power(self._within(left, Binding.ATOM), exponent)
        first = Binding.PRODUCT if operator == "*" else Binding.ADDITION
        second = Binding.SUM_SIGN if operator == "-" else first
        return self.row(
            self._within(left, first),
            self.operator(_SHOWN_OPERATORS[operator]),
            self._within(right, second, after_sign=True),
        )

    def _call(self, function: str, arguments: tuple[Expression, ...]) -> str:
        match function, arguments:
            case "sqrt", (inner,):
                return self.root(self.write(inner))
            case "abs", (inner,):
                return self.bars(self.write(inner))
            case "exp", (inner,):
                return self.exponential(self.write(inner))
            case "total", (inner,):
                return self.sum_sign(self._within(inner, Binding.PRODUCT, after_sign=True))
            case "where", _:
                return self.cases(self._rows(Call(function, arguments)))
        return self.function(_FUNCTION_NAMES.get(function, function), [self.write(a) for a in arguments])

    def _rows(self, choice: Expression) -> list[tuple[str, str]]:
        """Rows of a choice; a choice in the place of "otherwise" adds its own rows."""
        match choice:
            case Call("where", (condition, value, other)):
                return [(self.write(value), self._condition(condition)), *self._rows(other)]
        return [(self.write(choice), self.words(self.translate("otherwise")))]

    def _condition(self, condition: Expression) -> str:
        return self.row(self.words(self.translate("if")), self.write(condition))

    def _joined(self, between: str, parts: list[str]) -> str:
        joined = [parts[0]]
        for part in parts[1:]:
            joined += [between, part]
        return self.row(*joined)
