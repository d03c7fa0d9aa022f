"""Columns of catalogue tables, declared once: the table, the loader's checks and the catalogue browser read them.

A column's name ends in its unit (``rated_torque_nm``); the same name heads the column in a CSV file. ``label`` is what
a reader sees, ``about`` says precisely what is meant. Whether a value is required follows from the annotation:
``Mapped[float]`` is, ``Mapped[float | None]`` is not.
"""

from dataclasses import dataclass
from typing import Any

from sqlalchemy import Float, Integer, String
from sqlalchemy.orm import MappedColumn, mapped_column

from app.engine.quantity import unit_suffix

_INFO_KEY = "catalog"


@dataclass(frozen=True, kw_only=True)
class Meaning:
    """What a catalogue column holds. ``low`` and ``high`` bound what is plausible, in the column's unit."""

    label: str
    about: str
    unit: str | None = None
    symbol: str = ""
    low: float | None = None
    high: float | None = None
    choices: tuple[str, ...] = ()

    @property
    def comment(self) -> str:
        """Comment of the column in the database."""
        text = self.about or self.label
        return f"{text} [{self.unit}]" if self.unit else text


def number(unit: str, label: str, *, low: float, high: float, symbol: str = "", about: str = "") -> MappedColumn[Any]:
    """A measured value in ``unit``, plausible from ``low`` to ``high`` (both included)."""
    meaning = Meaning(label=label, about=about, unit=unit, symbol=symbol, low=low, high=high)
    return mapped_column(Float(53), comment=meaning.comment, info={_INFO_KEY: meaning})


def count(label: str, *, low: int, high: int, symbol: str = "", about: str = "") -> MappedColumn[Any]:
    """A whole number."""
    meaning = Meaning(label=label, about=about, symbol=symbol, low=low, high=high)
    return mapped_column(Integer, comment=meaning.comment, info={_INFO_KEY: meaning})


def text(
    label: str, length: int, *, about: str = "", choices: tuple[str, ...] = (), sort_order: int = 0, index: bool = False
) -> MappedColumn[Any]:
    """A text of at most ``length`` characters, or one of ``choices``."""
    meaning = Meaning(label=label, about=about, choices=choices)
    return mapped_column(
        String(length), comment=meaning.comment, info={_INFO_KEY: meaning}, sort_order=sort_order, index=index
    )


def meaning_of(info: dict[Any, Any]) -> Meaning | None:
    """The meaning stored in a column's ``info``; None for a column that no file fills (keys, slugs)."""
    found = info.get(_INFO_KEY)
    return found if isinstance(found, Meaning) else None


def column_suffix(unit: str | None) -> str:
    """What a column in ``unit`` ends in.

    >>> [column_suffix(unit) for unit in ("N m", "kg cm2", "1/h", "1", None)]
    ['_nm', '_kgcm2', '_per_h', '', '']
    """
    if unit is None:
        return ""
    return "_per" + unit_suffix(unit[2:]) if unit.startswith("1/") else unit_suffix(unit)
