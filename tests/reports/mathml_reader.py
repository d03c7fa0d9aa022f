"""Reads presentation MathML as a person does: brackets, signs and layout decide, nothing of how it was written.

Groups (``mrow``) are invisible on a page, so they are dissolved; what then cannot be read in one way only is refused.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any
from xml.etree import ElementTree

import numpy as np

FUNCTIONS: dict[str, Callable[..., Any]] = {
    "min": lambda a, b: np.where(a < b, a, b) if np.ndim(a) or np.ndim(b) else min(a, b),
    "max": lambda a, b: np.where(a > b, a, b) if np.ndim(a) or np.ndim(b) else max(a, b),
    "sin": np.sin, "cos": np.cos, "tan": np.tan, "arctan": np.arctan, "sgn": np.sign,
    "ln": np.log,
}  # fmt: skip
COMPARISONS: dict[str, Callable[[Any, Any], Any]] = {
    "<": lambda a, b: a < b, "≤": lambda a, b: a <= b, ">": lambda a, b: a > b, "≥": lambda a, b: a >= b,
    "=": lambda a, b: a == b, "≠": lambda a, b: a != b,
}  # fmt: skip


class UnclearError(Exception):
    """The formula on the page can be read in more than one way, or in none."""


@dataclass
class Token:
    """``kind`` is value, sign, function, word or sum; ``closing`` tells the second of two bars."""

    kind: str
    content: Any
    closing: bool = False


class Reader:
    """Reads one formula; ``number`` turns digits into a number (``float``, ``Fraction``), ``names`` gives values."""

    def __init__(self, number: Callable[[str], Any] = float, names: Mapping[str, Any] | None = None) -> None:
        self.number = number
        self.names = {"π": math.pi, **(names or {})}

    def read(self, mathml: str) -> Any:
        """Value of a ``<math>`` element that holds one expression."""
        return self.value(ElementTree.fromstring(mathml.replace("&nbsp;", " ")))

    def value(self, *elements: ElementTree.Element) -> Any:
        return self._whole([token for element in elements for token in self.tokens(element)])

    def tokens(self, element: ElementTree.Element) -> list[Token]:
        """Leaves of an element from left to right, with everything two-dimensional read into one value."""
        text = (element.text or "").strip()
        match element.tag, list(element):
            case (("math" | "mrow" | "mtd"), inner):
                return [token for child in inner for token in self.tokens(child)]
            case "mspace", _:
                return []
            case "mn", _:
                return [Token("value", self.number(text))]
            case "mo", _ if text == "∑":
                return [Token("sum", text)]
            case "mo", _:
                return [Token("sign", text, element.get("form") == "postfix")]
            case "mtext", _ if text in ("if", "otherwise", "and", "or", "not"):
                return [Token("word", text)]
            case "mi", _ if text in FUNCTIONS:
                return [Token("function", text)]
            case (("mi" | "mtext" | "msub"), _):
                return [Token("value", self.names[self.name(element)])]
            case "mfrac", [above, below]:
                return [Token("value", self.value(above) / self.value(below))]
            case "msqrt", inner:
                return [Token("value", np.sqrt(self.value(*inner)))]
            case "msup", [base, exponent] if self.name(base) == "e" and "e" not in self.names:
                return [Token("value", np.exp(self.value(exponent)))]
            case "msup", [base, exponent]:
                return [Token("value", self._atom(base) ** self.value(exponent))]
            case "msubsup", [base, below, exponent]:
                return [Token("value", self.names[f"{self.name(base)}_{self.name(below)}"] ** self.value(exponent))]
            case "mtable", rows:
                return [Token("value", self._cases(rows))]
        raise UnclearError(ElementTree.tostring(element, encoding="unicode"))

    def name(self, element: ElementTree.Element) -> str:
        """Text of a symbol, its subscript behind ``_``."""
        if element.tag == "msub":
            return "_".join(self.name(child) for child in element)
        return "".join(element.itertext()).strip()

    def _atom(self, base: ElementTree.Element) -> Any:
        """A power belongs to what stands directly before it: one value, or all within one pair of brackets."""
        tokens = self.tokens(base)
        stream = _Stream(tokens)
        value = self._factor(stream)
        if stream.left:
            raise UnclearError(f"the power of {self.name(base)}")
        return value

    def _cases(self, rows: list[ElementTree.Element]) -> Any:
        values = [self.value(row[0]) for row in rows]
        conditions = [self._condition(self.tokens(row[1])) for row in rows[:-1]]
        assert [token.content for token in self.tokens(rows[-1][1])] == ["otherwise"]
        result = values[-1]
        for value, holds in reversed(list(zip(values[:-1], conditions, strict=True))):
            result = np.where(holds, value, result) if np.ndim(holds) else (value if holds else result)
        return result

    def _condition(self, tokens: list[Token]) -> Any:
        assert tokens[0].content == "if"
        return self._logic(_Stream(tokens[1:]), whole=True)

    def _whole(self, tokens: list[Token]) -> Any:
        stream = _Stream(tokens)
        value = self._sum(stream)
        if stream.left:
            raise UnclearError(f"{stream.left[0]} follows a whole expression")
        return value

    def _logic(self, stream: "_Stream", *, whole: bool = False) -> Any:
        value = self._comparison(stream)
        words = set()
        while stream.at("and", "or"):
            word = stream.next().content
            words.add(word)
            other = self._comparison(stream)
            value = np.logical_and(value, other) if word == "and" else np.logical_or(value, other)
        if len(words) > 1 or (whole and stream.left):
            raise UnclearError("and beside or")
        return value

    def _comparison(self, stream: "_Stream") -> Any:
        if stream.at("not"):
            stream.next()
            return np.logical_not(self._bracketed(stream, self._logic))
        if stream.at("("):  # a bracket here may hold a condition or a number
            mark = stream.position
            try:
                return self._bracketed(stream, self._logic)
            except UnclearError:
                stream.position = mark
        left = self._sum(stream)
        if not stream.at(*COMPARISONS):
            raise UnclearError("a condition without comparison")
        result: Any = True
        while stream.at(*COMPARISONS):
            sign = stream.next().content
            right = self._sum(stream)
            result = np.logical_and(result, COMPARISONS[sign](left, right))
            left = right
        return result

    def _sum(self, stream: "_Stream") -> Any:
        minus = stream.at("−") and bool(stream.next())
        value = self._product(stream)
        value = -value if minus else value
        while stream.at("+", "−"):
            sign = stream.next().content
            if stream.at("+", "−"):
                raise UnclearError("two signs in a row")
            other = self._product(stream)
            value = value + other if sign == "+" else value - other
        return value

    def _product(self, stream: "_Stream") -> Any:
        if stream.at("∑"):
            stream.next()
            return np.sum(self._product(stream))
        value = self._factor(stream)
        while stream.at("·"):
            stream.next()
            value = value * self._factor(stream)
        return value

    def _factor(self, stream: "_Stream") -> Any:
        token = stream.next()
        match token:
            case Token("value", value):
                return value
            case Token("function", name):
                return FUNCTIONS[name](*self._bracketed(stream, self._arguments))
            case Token("sign", "("):
                stream.position -= 1
                return self._bracketed(stream, self._sum)
            case Token("sign", "|", False):
                value = self._sum(stream)
                stream.expect("|")
                return abs(value)
            case Token("sign", "["):
                items = [self._sum(stream)]
                while stream.at(";"):
                    stream.next()
                    items.append(self._sum(stream))
                stream.expect("]")
                return np.array(items)
            case Token("sign", "{"):
                value = self._factor(stream)
                if stream.left and not stream.at(")", ",", "|"):
                    raise UnclearError("something follows the cases")
                return value
        raise UnclearError(f"{token} where a value was expected")

    def _arguments(self, stream: "_Stream") -> list[Any]:
        found = [self._sum(stream)]
        while stream.at(","):
            stream.next()
            found.append(self._sum(stream))
        return found

    def _bracketed(self, stream: "_Stream", inner: Callable[["_Stream"], Any]) -> Any:
        stream.expect("(")
        value = inner(stream)
        stream.expect(")")
        return value


class _Stream:
    def __init__(self, tokens: list[Token]) -> None:
        self.all = tokens
        self.position = 0

    @property
    def left(self) -> list[Token]:
        return self.all[self.position :]

    def at(self, *contents: str) -> bool:
        here = self.left[0] if self.left else None
        return here is not None and here.kind not in ("value", "function") and here.content in contents

    def next(self) -> Token:
        if not self.left:
            raise UnclearError("the formula ends too early")
        self.position += 1
        return self.all[self.position - 1]

    def expect(self, content: str) -> None:
        if not self.at(content):
            raise UnclearError(f"no {content!r}")
        self.position += 1
