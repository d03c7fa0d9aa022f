"""How a number and a unit are written for a reader: the one place where values are rounded.

A value is rounded only here, for display; everything computed keeps its full precision.
"""

import math
import re
from dataclasses import dataclass
from typing import Any

import numpy as np

from app.engine.quantity import from_si

DIGITS = 5
"""Significant digits of a shown value."""
ABSENT = "–"
"""Stands for a value that is not known."""
MINUS = "−"
ELLIPSIS = "…"
_PLAIN_FROM, _PLAIN_BELOW = -4, 6
"""Powers of ten between which a number is written without a factor 10^n."""
_SHOWN_ELEMENTS = 5
"""Elements of an array that are listed; a longer one is shortened to the first and the last ones."""
_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_UNIT_WORDS = {"um": "µm", "us": "µs", "uH": "µH", "deg": "°", "degC": "°C", "ohm": "Ω", "mohm": "mΩ", "Ohm": "Ω"}
_TIGHT_UNITS = ("°", "′", "″")
"""Units that follow their number without a space."""


@dataclass(frozen=True)
class Rounded:
    """A rounded number: ``mantissa`` (its sign a true minus), times 10 to the ``exponent`` unless that is None."""

    mantissa: str
    exponent: int | None = None

    @property
    def text(self) -> str:
        """The number in one line of text.

        >>> Rounded("1.2", -5).text
        '1.2·10⁻⁵'
        """
        return self.mantissa if self.exponent is None else f"{self.mantissa}·10{superscript(self.exponent)}"

    @property
    def negative(self) -> bool:
        """Whether the number carries a minus sign."""
        return self.mantissa.startswith(MINUS)


def superscript(number: int) -> str:
    """Write a whole number in raised digits.

    >>> superscript(-12)
    '⁻¹²'
    """
    return str(number).translate(_SUPERSCRIPTS)


def rounded(value: float, digits: int = DIGITS) -> Rounded:
    """Round a number to ``digits`` significant digits; digits before the decimal point are never replaced by zeros.

    >>> [rounded(v).text for v in (1388.617, 423612.7, 0.0025, 1.2e-5, -2.0, 0.0)]
    ['1388.6', '423613', '0.0025', '1.2·10⁻⁵', '−2', '0']
    """
    if math.isnan(value):
        return Rounded(ABSENT)
    if math.isinf(value):
        return Rounded(f"{MINUS if value < 0 else ''}∞")
    if value == 0:
        return Rounded("0")
    power = int(f"{abs(value):.16e}".partition("e")[2])
    plain = _PLAIN_FROM <= power < _PLAIN_BELOW
    if plain:
        mantissa = f"{abs(value):.{max(0, digits - 1 - power)}f}"
    else:
        mantissa, _, exponent = f"{abs(value):.{digits - 1}e}".partition("e")
        power = int(exponent)
    if "." in mantissa:
        mantissa = mantissa.rstrip("0").rstrip(".")
    return Rounded((MINUS if value < 0 else "") + mantissa, None if plain else power)


def elements(values: Any) -> list[float | None]:
    """The elements of an array that are shown, in order; None stands for those left out.

    >>> elements(range(9))
    [0.0, 1.0, 2.0, None, 8.0]
    """
    flat = [float(item) for item in np.ravel(np.asarray(values, dtype=float))]
    if len(flat) <= _SHOWN_ELEMENTS:
        return list(flat)
    return [*flat[: _SHOWN_ELEMENTS - 2], None, flat[-1]]


def number(value: Any, digits: int = DIGITS) -> str:
    """Write a number, or a list of numbers, as text.

    >>> number([4.0, -2.0, 0.0])
    '[4; −2; 0]'
    """
    if np.ndim(value):
        return f"[{'; '.join(ELLIPSIS if v is None else rounded(v, digits).text for v in elements(value))}]"
    return rounded(float(value), digits).text


def unit_text(unit: str) -> str:
    """Typeset a unit.

    >>> [unit_text(u) for u in ("kg m2", "m/s2", "N/um", "1", "%", "deg", "N s/m", "min-1")]
    ['kg·m²', 'm/s²', 'N/µm', '', '%', '°', 'N·s/m', 'min⁻¹']
    """
    if unit == "1":
        return ""
    return re.sub(r"[^\s*/·]+", _unit_word, unit.strip()).replace("*", "·").replace(" ", "·")


def _unit_word(match: re.Match[str]) -> str:
    word = match[0]
    parts = re.fullmatch(r"([^\d\s^-]+)\^?(-?\d+)", word)
    if parts is None:
        return _UNIT_WORDS.get(word, word)
    return _UNIT_WORDS.get(parts[1], parts[1]) + parts[2].translate(_SUPERSCRIPTS)


def join_unit(text: str, unit: str) -> str:
    """Put a typeset unit behind a written number.

    >>> join_unit("30", "deg"), join_unit("5", "N m"), join_unit("0.8", "1")
    ('30°', '5 N·m', '0.8')
    """
    shown = unit_text(unit)
    return f"{text}{'' if not shown or shown in _TIGHT_UNITS else ' '}{shown}"


def in_unit(value: Any, unit: str) -> Any:
    """Turn an SI number, or a list of them, into ``unit``."""
    if np.ndim(value):
        return [from_si(float(item), unit) for item in np.ravel(np.asarray(value, dtype=float))]
    return from_si(float(value), unit)


def show(value_si: Any, unit: str, digits: int = DIGITS) -> str:
    """Write an SI value in ``unit``; a value that is not known is a dash.

    >>> show(163.84, "Hz"), show(0.0042, "kg cm2"), show(None, "N m")
    ('163.84 Hz', '42 kg·cm²', '–')
    """
    if value_si is None:
        return ABSENT
    return join_unit(number(in_unit(value_si, unit), digits), unit)


def percent(share: float | None) -> str:
    """Write a share as percentage with one decimal where that matters; never rounds across 100 %.

    >>> [percent(s) for s in (0.534, 1.0004, 0.99996, 12.3, None)]
    ['53.4 %', '100.1 %', '99.9 %', '1230 %', '–']
    """
    if share is None:
        return ABSENT
    if math.isinf(share):
        return "∞"
    tenths = round(share * 1000, 6)  # what is only floating-point noise above the limit stays 100 %
    shown = math.floor(tenths) if 999 <= tenths < 1000 else math.ceil(tenths) if 1000 < tenths < 1001 else round(tenths)
    return f"{shown / 10:.1f}".removesuffix(".0") + " %"
