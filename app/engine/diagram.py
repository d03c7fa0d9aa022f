"""A diagram as plain data: what a mechanism or a drive wants shown beside its numbers.

The engine says what belongs into a chart; how it looks is decided in ``app.charts``.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray


@dataclass(frozen=True)
class Series:
    """One line or cloud of points; ``x`` and ``y`` are SI, shape (n,)."""

    name: str
    """Name for the reader."""
    x: NDArray[np.float64]
    y: NDArray[np.float64]
    role: Literal["demand", "limit", "second", "point", "sum"] = "demand"
    """``demand`` is what happens, ``limit`` what may happen, ``second`` a comparison, ``point`` single points."""


@dataclass(frozen=True)
class Diagram:
    """One chart: series over a common x axis. Values are SI and shown in ``x_unit`` and ``y_unit``."""

    key: str
    """Unique among the diagrams of one calculation, e.g. ``"run_up"``."""
    title: str
    x_label: str
    x_unit: str
    y_label: str
    y_unit: str
    series: tuple[Series, ...]


def series(
    name: str, x: ArrayLike, y: ArrayLike, role: Literal["demand", "limit", "second", "point", "sum"] = "demand"
) -> Series:
    """A series of anything that numpy can turn into arrays of shape (n,)."""
    return Series(name, np.asarray(x, dtype=np.float64), np.asarray(y, dtype=np.float64), role)
