"""Selection: every servo motor with every gear unit, evaluated exactly, ranked, and explained.

Nothing is left out beforehand: every candidate goes through every check of the rule set. The work is done in blocks
that stay in the cache of a core; its cost does not depend on the number of segments of the cycle.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import groupby
from typing import Literal

import numpy as np

from app.engine.candidates import ColumnTerm, GearArrays, Missing, MotorArrays, Term
from app.engine.cycle import BoolArray, FloatArray, IndexArray
from app.engine.drives.rules import CHECK_NAMES, ServoRules
from app.engine.drives.servo import check_servo
from app.engine.drives.servo_terms import ServoTerms, servo_terms
from app.engine.environment import Environment
from app.engine.mechanisms.load import Load
from app.engine.sheet import ROUNDING, Check, Sheet

Ranking = Literal["utilisation", "mass", "rated_torque", "inertia_match"]

NOT_CHECKED = "not_checked"
"""Key under which candidates are counted that lack data, where all checks are demanded."""
_LIMIT = (1 + ROUNDING) ** 2
"""Squared utilisation above which a check fails."""
_BLOCK = 32768
"""Candidates per block: five arrays of it stay in the second-level cache."""
_BLOCK_COLUMNS = 4096
DIRECT = -1
"""Gear index of a motor that drives the load directly."""


@dataclass(frozen=True)
class Candidate:
    """One admitted motor with its gear unit."""

    motor: int
    """Index of the motor record"""
    gear: int
    """Index of the gear unit record; ``DIRECT`` without one"""
    utilisation: float
    """Largest utilisation of the checks that could be made"""
    deciding: str
    """Key of that check; empty where none could be made"""
    mass: float | None
    """Motor and gear unit [kg]; None where one of them is not known"""
    rated_torque: float | None
    """M_N of the motor, else M_0 [N m]"""
    inertia_ratio: float | None
    """External over motor inertia; None where it is not known"""
    utilisations: dict[str, float]
    """Utilisation of every check that could be made, by key"""
    not_checked: tuple[str, ...]
    """Keys of the checks that could not be made"""


@dataclass(frozen=True)
class Selection:
    """Result of one selection: counts, the ranked candidates asked for, and the means to explain any other."""

    terms: ServoTerms
    evaluated: int
    """Candidates that went through all checks"""
    admitted: int
    """Candidates without a failing check"""
    rejected: dict[str, int]
    """The others by the key of the first check that fails, in the order of ``CHECK_NAMES``"""
    candidates: tuple[Candidate, ...]
    """The ranked ones from ``offset`` on"""
    offset: int
    without_input: tuple[str, ...] = field(default=())
    """Checks that no candidate with a gear unit could go through because the user's input for them is missing"""

    def utilisations(self, motor: int, gear: int) -> dict[str, float | None]:
        """Utilisation of every check of one candidate, as evaluated with all others; None where it was not made."""
        column = gear + 1
        rows, columns = np.array([motor]), np.array([column])
        found: dict[str, float | None] = {}
        for key, terms in _by_key(self.terms.terms):
            if gear == DIRECT and key.startswith("gear_"):
                continue
            missing = self.terms.missing.get(key)
            used = max(float(term.at(rows, columns)[0]) for term in terms)
            found[key] = None if missing is not None and missing.at(motor, column) else used
        found |= {key: None for key, where in self.terms.unasked.items() if where[column]}
        return dict(sorted(found.items(), key=lambda item: _ORDER[item[0]]))

    def explain(self, motor: int, gear: int) -> list[Check]:
        """All checks of one candidate, admitted or rejected, with demanded and permitted values."""
        terms = self.terms
        unit = None if gear == DIRECT else terms.gears.records[gear]
        record = terms.motors.records[motor]
        return list(check_servo(terms.load, record, unit, None, terms.rules, terms.environment, Sheet()).checks)


_ORDER = {key: number for number, key in enumerate(CHECK_NAMES)}


def select(
    load: Load,
    motors: MotorArrays,
    gears: GearArrays,
    rules: ServoRules,
    environment: Environment,
    *,
    include_direct: bool = True,
    ranking: Ranking = "utilisation",
    limit: int = 50,
    offset: int = 0,
    require_all: bool = False,
) -> Selection:
    """Evaluate every motor with every gear unit (and, with ``include_direct``, without one) and rank the admitted.

    ``ranking``: ``utilisation`` (closest fit first), ``mass``, ``rated_torque`` (smallest first) or ``inertia_match``
    (inertia ratio nearest to 1 first); equal ones by mass, then utilisation. A candidate with a check that cannot be
    made for want of catalogue data is admitted behind all others and carries its key, unless ``require_all``: then it
    is rejected as ``NOT_CHECKED``. A check that only lacks an input of the user never rejects.
    """
    terms = servo_terms(load, motors, gears, rules, environment)
    first = 0 if include_direct else 1
    best = _Ranker(terms, ranking, offset + limit)
    admitted, rejected = _evaluate(terms, first, require_all, best)
    rows, columns = best.ranked()
    return Selection(
        terms=terms,
        evaluated=len(motors) * (gears.ratio.size - first),
        admitted=admitted,
        rejected={key: count for key, count in rejected.items() if count},
        candidates=_candidates(terms, rows[offset:], columns[offset:]),
        offset=offset,
        without_input=tuple(terms.unasked),
    )


def _by_key(terms: list[Term]) -> list[tuple[str, list[Term]]]:
    ordered = sorted(terms, key=lambda term: _ORDER[term.key])
    return [(key, list(group)) for key, group in groupby(ordered, key=lambda term: term.key)]


def _evaluate(terms: ServoTerms, first: int, require_all: bool, best: "_Ranker") -> tuple[int, dict[str, int]]:
    """Run every candidate through every check; how many are admitted, and how many each check rejects first."""
    rejected = dict.fromkeys((*CHECK_NAMES, NOT_CHECKED), 0)
    own, holds = _gear_checks(terms, first, rejected)
    pairs = [
        (key, parts)
        for key, group in _by_key(terms.terms)
        if (parts := [term for term in group if not isinstance(term, ColumnTerm)])
    ]
    motors, gears = len(terms.motors), terms.gears.ratio.size
    width = min(_BLOCK_COLUMNS, gears)
    height = max(1, _BLOCK // width)
    spares = [np.empty(height * width) for _ in range(3)]
    lacking = Missing.any_of(list(terms.missing.values()))
    admitted = 0
    for left in range(0, gears, width):
        columns = slice(left, min(left + width, gears))
        for top in range(0, motors, height):
            rows = slice(top, min(top + height, motors))
            alive = np.repeat(holds[None, columns], rows.stop - rows.start, axis=0)
            worst = _block(pairs, rows, columns, own[columns], alive, spares, rejected)
            whole = alive.copy()
            lacking.drop(rows, columns, whole)
            if require_all:
                rejected[NOT_CHECKED] += int(np.count_nonzero(alive)) - int(np.count_nonzero(whole))
                alive = whole
            admitted += int(np.count_nonzero(alive))
            best.offer(rows, columns, worst, whole, alive)
    return admitted, rejected


def _gear_checks(terms: ServoTerms, first: int, rejected: dict[str, int]) -> tuple[FloatArray, BoolArray]:
    """Largest squared utilisation of every gear unit by the checks of its own, and which ones hold."""
    own: FloatArray = np.zeros(terms.gears.ratio.size)
    holds = np.arange(own.size) >= first
    for key, group in _by_key(terms.terms):
        for term in group:
            if isinstance(term, ColumnTerm):
                squares = term.used**2
                fails = holds & (squares > _LIMIT)
                rejected[key] += int(np.count_nonzero(fails)) * len(terms.motors)
                holds &= ~fails
                np.maximum(own, squares, out=own)
    return own, holds


def _block(
    pairs: list[tuple[str, list[Term]]],
    rows: slice,
    columns: slice,
    own: FloatArray,
    alive: BoolArray,
    spares: list[FloatArray],
    rejected: dict[str, int],
) -> FloatArray:
    """Run all checks of motor and gear unit together on one block; ``alive`` loses the candidates that fail."""
    used, spare, worst = (array[: alive.size].reshape(alive.shape) for array in spares)
    worst[...] = own
    fails = np.empty(alive.shape, dtype=bool)
    for key, group in pairs:
        for term in group:
            term.squares(rows, columns, used, spare)
            np.maximum(worst, used, out=worst)
            np.greater(used, _LIMIT, out=fails)
            np.logical_and(fails, alive, out=fails)
            count = int(np.count_nonzero(fails))
            if count:
                rejected[key] += count
                np.logical_xor(alive, fails, out=alive)
    return worst


class _Ranker:
    """The best ``count`` of all candidates: those with every check made first, then the others."""

    def __init__(self, terms: ServoTerms, ranking: Ranking, count: int) -> None:
        self.terms = terms
        self.key = _RANKINGS[ranking]
        self.whole, self.others = _Best(terms, count), _Best(terms, count)

    def offer(self, rows: slice, columns: slice, worst: FloatArray, whole: BoolArray, alive: BoolArray) -> None:
        """Take the admitted candidates of a block; ``whole`` marks those of which every check was made."""
        if self.whole.count > 0:
            key = self.key(self.terms, worst, rows, columns)
            self.whole.offer(rows, columns, key, worst, whole)
            if not self.whole.full:
                self.others.offer(rows, columns, key, worst, alive & ~whole)

    def ranked(self) -> tuple[IndexArray, IndexArray]:
        """Rows and columns of the best, best first."""
        first, then = self.whole.ranked(), self.others.ranked()
        rows, columns = (np.concatenate(pair)[: self.whole.count] for pair in zip(first, then, strict=True))
        return rows, columns


class _Best:
    """The best ``count`` of all candidates offered so far, by a key (smallest first)."""

    def __init__(self, terms: ServoTerms, count: int) -> None:
        self.terms = terms
        self.count = count
        self.threshold = np.inf
        self.full = False
        self.kept: list[tuple[FloatArray, FloatArray, IndexArray, IndexArray]] = []
        self.waiting = 0

    def offer(self, rows: slice, columns: slice, key: FloatArray, worst: FloatArray, alive: BoolArray) -> None:
        """Take the marked candidates of a block that may still be among the best."""
        if self.threshold < np.inf:
            alive = alive & (key <= self.threshold)
        found = np.flatnonzero(alive)
        if found.size == 0:
            return
        r, c = np.divmod(found, key.shape[1])
        self.kept.append((key[r, c], worst[r, c], r + rows.start, c + columns.start))
        self.waiting += found.size
        if self.waiting > 2 * self.count + 500:
            self._prune()

    def _prune(self) -> None:
        """Keep the best only, and remember the key that a later one must reach."""
        key, worst, rows, columns = (np.concatenate(part) for part in zip(*self.kept, strict=True))
        close = np.arange(key.size)
        self.full = key.size >= self.count
        if key.size > self.count:
            self.threshold = float(np.partition(key, self.count - 1)[self.count - 1])
            close = np.flatnonzero(key <= self.threshold)
        mass = self.terms.motors.mass[rows[close]] + self.terms.gears.mass[columns[close]]
        order = np.lexsort((columns[close], rows[close], -worst[close], np.nan_to_num(mass, nan=np.inf), key[close]))
        best = close[order[: self.count]]
        self.kept = [(key[best], worst[best], rows[best], columns[best])]
        self.waiting = 0

    def ranked(self) -> tuple[IndexArray, IndexArray]:
        """Rows and columns of the best, best first."""
        if not self.kept:
            return np.empty(0, dtype=np.intp), np.empty(0, dtype=np.intp)
        self._prune()
        return self.kept[0][2], self.kept[0][3]


def _closeness(terms: ServoTerms, worst: FloatArray, rows: slice, columns: slice) -> FloatArray:
    return -worst


def _mass(terms: ServoTerms, worst: FloatArray, rows: slice, columns: slice) -> FloatArray:
    return np.nan_to_num(terms.motors.mass[rows, None] + terms.gears.mass[columns], nan=np.inf, posinf=np.inf)


def _rated_torque(terms: ServoTerms, worst: FloatArray, rows: slice, columns: slice) -> FloatArray:
    rated = np.nan_to_num(terms.motors.rated_torque[rows, None], nan=np.inf)
    return np.broadcast_to(rated, worst.shape)


def _mismatch(terms: ServoTerms, worst: FloatArray, rows: slice, columns: slice) -> FloatArray:
    """How far the inertia ratio is from 1, as a factor >= 1."""
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = terms.external[columns] / terms.rotor[rows, None]
        found = np.maximum(ratio, 1 / ratio)
    return np.where(terms.rotor_unknown[rows, None] | terms.gears.incomplete[columns], np.inf, found)


_RANKINGS: dict[Ranking, Callable[[ServoTerms, FloatArray, slice, slice], FloatArray]] = {
    "utilisation": _closeness,
    "mass": _mass,
    "rated_torque": _rated_torque,
    "inertia_match": _mismatch,
}


def _candidates(terms: ServoTerms, rows: IndexArray, columns: IndexArray) -> tuple[Candidate, ...]:
    """Write out the chosen candidates with all their utilisations."""
    used: dict[str, FloatArray] = {}
    for key, group in _by_key(terms.terms):
        used[key] = np.max([term.at(rows, columns) for term in group], axis=0)
    found = []
    for place, (row, column) in enumerate(zip(rows.tolist(), columns.tolist(), strict=True)):
        lacking = {key for key, missing in terms.missing.items() if missing.at(row, column)}
        lacking |= {key for key, where in terms.unasked.items() if where[column]}
        values = {
            key: float(value[place])
            for key, value in used.items()
            if key not in lacking and not (column == 0 and key.startswith("gear_"))
        }
        found.append(_candidate(terms, row, column, values, tuple(sorted(lacking, key=lambda key: _ORDER[key]))))
    return tuple(found)


def _candidate(
    terms: ServoTerms, row: int, column: int, values: dict[str, float], lacking: tuple[str, ...]
) -> Candidate:
    def number(value: float) -> float | None:
        return float(value) if np.isfinite(value) else None

    unknown = bool(terms.rotor_unknown[row] or terms.gears.incomplete[column])
    deciding = max(values, key=lambda key: values[key], default="")
    return Candidate(
        motor=row,
        gear=column - 1,
        utilisation=values.get(deciding, 0.0),
        deciding=deciding,
        mass=number(terms.motors.mass[row] + terms.gears.mass[column]),
        rated_torque=number(terms.motors.rated_torque[row]),
        inertia_ratio=None if unknown else number(terms.external[column] / terms.rotor[row]),
        utilisations=values,
        not_checked=lacking,
    )
