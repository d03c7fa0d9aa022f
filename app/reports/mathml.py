"""Formulas as MathML Core, for the pages. Every text in it is escaped, so the result is safe to put into a page."""

from collections.abc import Mapping
from functools import lru_cache
from typing import Any

from markupsafe import Markup, escape

from app.engine.formula import Formula
from app.reports import expression, symbols
from app.reports.expression import Equation, Expression
from app.reports.numbers import ELLIPSIS, MINUS, Rounded
from app.reports.symbols import Symbol
from app.reports.writer import Translate, Writer

_GAP = '<mspace width="0.25em"></mspace>'


class MathmlWriter(Writer):
    """Writes expressions as presentation MathML."""

    def row(self, *parts: str) -> str:
        return f"<mrow>{''.join(parts)}</mrow>"

    def operator(self, sign: str) -> str:
        return f"<mo>{escape(sign)}</mo>"

    def minus(self, operand: str) -> str:
        return f"<mrow><mo>{MINUS}</mo>{operand}</mrow>"

    def symbol(self, symbol: Symbol, power: str = "") -> str:
        base = _identifier(symbol.base)
        if symbol.prefix:
            base = f'<mrow><mi mathvariant="normal">{escape(symbol.prefix)}</mi>{base}</mrow>'
        below = f"<mtext>{escape(symbol.subscript)}</mtext>"
        above = power or (f"<mo>{escape(symbol.primes)}</mo>" if symbol.primes else "")
        if symbol.subscript and above:
            return f"<msubsup>{base}{below}{above}</msubsup>"
        if symbol.subscript:
            return f"<msub>{base}{below}</msub>"
        return f"<msup>{base}{above}</msup>" if above else base

    def number(self, number: Rounded) -> str:
        digits = f"<mn>{escape(number.mantissa.removeprefix(MINUS))}</mn>"
        sign = f"<mo>{MINUS}</mo>" if number.negative else ""
        if number.exponent is None:
            return f"<mrow>{sign}{digits}</mrow>" if sign else digits
        power = self.number(Rounded(str(number.exponent).replace("-", MINUS)))
        return f"<mrow>{sign}{digits}<mo>·</mo><msup><mn>10</mn>{power}</msup></mrow>"

    def array(self, items: list[str]) -> str:
        shown = '<mo separator="true">;</mo>'.join(item or f"<mi>{ELLIPSIS}</mi>" for item in items)
        return f"<mrow><mo>[</mo>{shown}<mo>]</mo></mrow>"

    def unit(self, unit: str) -> str:
        return f"{_GAP}<mtext>{escape(unit)}</mtext>" if unit else ""

    def brackets(self, inner: str) -> str:
        return f"<mrow><mo>(</mo>{inner}<mo>)</mo></mrow>"

    def fraction(self, above: str, below: str) -> str:
        return f"<mfrac>{above}{below}</mfrac>"

    def power(self, base: str, exponent: str) -> str:
        return f"<msup>{base}{exponent}</msup>"

    def root(self, inner: str) -> str:
        return f"<msqrt>{inner}</msqrt>"

    def bars(self, inner: str) -> str:
        return f'<mrow><mo form="prefix" stretchy="true">|</mo>{inner}<mo form="postfix" stretchy="true">|</mo></mrow>'

    def function(self, name: str, arguments: list[str]) -> str:
        inner = '<mo separator="true">,</mo>'.join(arguments)
        return f"<mrow><mi>{escape(name)}</mi>{self.brackets(inner)}</mrow>"

    def exponential(self, exponent: str) -> str:
        return f'<msup><mi mathvariant="normal">e</mi>{exponent}</msup>'

    def sum_sign(self, operand: str) -> str:
        return f"<mrow><mo>∑</mo>{operand}</mrow>"

    def cases(self, rows: list[tuple[str, str]]) -> str:
        shown = "".join(f"<mtr><mtd>{value}</mtd><mtd>{condition}</mtd></mtr>" for value, condition in rows)
        return f'<mrow><mo form="prefix" stretchy="true">{{</mo><mtable>{shown}</mtable></mrow>'

    def words(self, text: str) -> str:
        return f'<mspace width="0.4em"></mspace><mtext>{escape(text)}</mtext><mspace width="0.4em"></mspace>'


def _identifier(text: str) -> str:
    """A single letter slants by itself, a word stands upright; what is no name (``n/a``) is a text."""
    return f"<mi>{escape(text)}</mi>" if text.isalnum() else f"<mtext>{escape(text)}</mtext>"


def math(inner: str, *, block: bool = True, continued: bool = False) -> Markup:
    """Wrap written MathML into its ``<math>`` element; a line that continues the one above gets a class of its own."""
    kind = Markup(' class="continued"') if continued else Markup("")
    shown = "block" if block else "inline"
    return Markup('<math display="{}"{}>').format(shown, kind) + Markup(inner) + Markup("</math>")


@lru_cache(maxsize=2000)
def symbol(name: str) -> Markup:
    """A symbol for use within a text.

    >>> symbol("mu_L")
    Markup('<math display="inline"><msub><mi>μ</mi><mtext>L</mtext></msub></math>')
    """
    return math(MathmlWriter().symbol(symbols.read(name)), block=False) if name else Markup("")


def of_expression(tree: Expression, *, translate: Translate = str) -> Markup:
    """One expression."""
    return math(MathmlWriter(translate=translate).write(tree))


def symbolic(formula: Formula[..., Any], *, name: str = "", translate: Translate = str) -> tuple[Markup, ...]:
    """Lines of a formula in symbols: its named intermediates, then the result. ``name`` replaces its symbol."""
    return _lines(expression.symbolic(formula, name), translate)


def with_numbers(
    formula: Formula[..., Any],
    inputs: Mapping[str, Any],
    value: Any,
    *,
    name: str = "",
    unit: str = "",
    translate: Translate = str,
) -> tuple[Markup, ...]:
    """Lines of an evaluated formula: each equation in symbols, then with numbers (SI) and its value.

    ``unit`` is the one in which the result is shown beside SI; the formula's own where it is empty.
    """
    return _lines(expression.with_numbers(formula, inputs, value, symbol=name, unit=unit), translate)


def _lines(equations: tuple[Equation, ...], translate: Translate) -> tuple[Markup, ...]:
    writer = MathmlWriter(translate=translate)
    return tuple(
        math(line, continued=index > 0) for equation in equations for index, line in enumerate(writer.lines(equation))
    )
