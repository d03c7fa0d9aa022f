"""The alternatives of an axis as a page shows them: ranked, compared, and why another one does not fit."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, get_args

from app.charts.alternatives import alternatives_figure
from app.engine.drives.rules import CHECK_NAMES
from app.engine.products import Product, ServoGearUnit
from app.engine.quantity import declaration
from app.reports.numbers import ABSENT, number, percent, show
from app.reports.sheet_view import CheckView, check_view
from app.services.errors import InvalidInputError, ServiceError
from app.services.requests import Ranking, SelectionRequest
from app.services.selection import RankedCandidate, SelectionOutcome, SelectionService
from app.web.chart_views import ChartView, chart_view

Translate = Callable[[str], str]
PAGE = 15
COMPARED = 3
"""So many candidates stand side by side."""


@dataclass(frozen=True)
class OptionView:
    """One choice of a control."""

    value: str
    label: str
    selected: bool


@dataclass(frozen=True)
class CandidateView:
    """One admitted candidate."""

    rank: int
    key: str
    """Identifiers of motor and gear unit, as the buttons send them."""
    motor: str
    gear_unit: str
    """Empty for a direct drive."""
    ratio: str
    utilisation: str
    verdict: str
    deciding: str
    mass: str
    rated_torque: str
    inertia_ratio: str
    not_checked: tuple[str, ...]
    compared: bool


@dataclass(frozen=True)
class ComparedView:
    """One candidate with all its checks, beside others or alone."""

    key: str
    motor: str
    gear_unit: str
    source: str
    checks: tuple[CheckView, ...]
    failing: int
    drives: tuple[str, ...]


@dataclass(frozen=True)
class AlternativesView:
    """Everything in the tab. ``problem`` says why there is no list."""

    problem: str = ""
    evaluated: str = ""
    admitted: str = ""
    rejected: tuple[tuple[str, str], ...] = ()
    """Name of the first failing check and how many candidates it rejects."""
    rankings: tuple[OptionView, ...] = ()
    makers: tuple[OptionView, ...] = ()
    gear_makers: tuple[OptionView, ...] = ()
    kinds: tuple[OptionView, ...] = ()
    complete: bool = False
    candidates: tuple[CandidateView, ...] = ()
    compared: tuple[ComparedView, ...] = ()
    why: ComparedView | None = None
    why_problem: str = ""
    why_motor: str = ""
    why_gear: str = ""
    chart: ChartView | None = None
    offset: int = 0
    earlier: int | None = None
    later: int | None = None


@dataclass(frozen=True)
class Wanted:
    """What a reader asked of the list: the entries of a form that begin with ``_alt_``."""

    ranking: str = "utilisation"
    maker: str = ""
    gear_maker: str = ""
    kind: str = ""
    """``direct``, ``geared`` or empty for both."""
    complete: bool = False
    offset: int = 0
    compare: tuple[str, ...] = ()
    why_motor: str = ""
    why_gear: str = ""

    @classmethod
    def of(cls, pairs: Mapping[str, tuple[str, ...]]) -> "Wanted":
        """Read the steering entries of a form; what is not understood counts as not given."""

        def one(name: str) -> str:
            return next((value for value in reversed(pairs.get(f"alt_{name}", ())) if value), "").strip()[:200]

        offset = one("offset")
        ranking = one("ranking")
        return cls(
            ranking=ranking if ranking in get_args(Ranking) else "utilisation",
            maker=one("maker"), gear_maker=one("gear_maker"), complete=one("complete") == "yes",
            kind=one("kind") if one("kind") in ("direct", "geared") else "",
            offset=int(offset) if offset.isascii() and offset.isdigit() and len(offset) < 8 else 0,
            compare=tuple(dict.fromkeys(pairs.get("alt_compare", ())))[:COMPARED],
            why_motor=one("why_motor"), why_gear=one("why_gear"),
        )  # fmt: skip


def alternatives_of(
    raw: Mapping[str, Any], wanted: Wanted, selections: SelectionService, translate: Translate
) -> AlternativesView:
    """Search the catalogue for the axis in ``raw``; parts that are chosen already are left out of the question."""
    request = selection_request(raw, wanted)
    motors, gears = selections.products()
    try:
        outcome = selections.select(request)
    except InvalidInputError as error:
        return AlternativesView("; ".join(f"{one.name} {one.message}" for one in error.errors))
    except ServiceError as error:
        return AlternativesView(translate(error.message))
    shown = len(outcome.candidates)
    why, problem = _why(request, wanted, selections, motors, gears, translate)
    return AlternativesView(
        evaluated=count(outcome.selection.evaluated), admitted=count(outcome.selection.admitted),
        rejected=tuple((translate(CHECK_NAMES[key]), count(n)) for key, n in outcome.selection.rejected.items() if n),
        rankings=_rankings(wanted.ranking, translate), complete=wanted.complete,
        makers=_options({one.manufacturer for one in motors}, wanted.maker, translate("all makers")),
        gear_makers=_options({one.manufacturer for one in gears}, wanted.gear_maker, translate("all makers")),
        kinds=tuple(OptionView(value, translate(label), value == wanted.kind) for value, label in _KINDS),
        candidates=tuple(_candidate(one, wanted, translate) for one in outcome.candidates),
        compared=tuple(_compared(request, key, selections, translate) for key in _known(wanted.compare, motors, gears)),
        why=why, why_problem=problem, why_motor=wanted.why_motor, why_gear=wanted.why_gear,
        chart=_chart(outcome, translate), offset=wanted.offset,
        earlier=max(0, wanted.offset - PAGE) if wanted.offset else None,
        later=wanted.offset + PAGE if wanted.offset + shown < outcome.selection.admitted else None,
    )  # fmt: skip


_KINDS = (("", "with and without gear unit"), ("geared", "with gear unit"), ("direct", "direct drive"))


def selection_request(raw: Mapping[str, Any], wanted: Wanted) -> dict[str, Any]:
    """The axis as a question to the catalogue: rules as typed, motor and gear unit open."""
    drive = {name: value for name, value in (raw.get("drive") or {}).items() if name not in ("motor", "gear_unit")}
    filters: dict[str, Any] = {
        "manufacturers": [wanted.maker] if wanted.maker else [],
        "gear_manufacturers": [wanted.gear_maker] if wanted.gear_maker else [],
        "direct": wanted.kind != "geared",
        "geared": wanted.kind != "direct",
    }
    own = {name: value for name, value in raw.items() if name != "drive"}
    return {**own, "drive": drive, "filters": filters, "ranking": wanted.ranking, "limit": PAGE,
            "offset": wanted.offset, "demand_all_checks": wanted.complete}  # fmt: skip


def count(value: int) -> str:
    """A number of things with its digits in groups.

    >>> count(890145)
    '890\\u202f145'
    """
    return f"{value:,}".replace(",", "\u202f")


def split_key(key: str) -> tuple[str, str | None]:
    """Identifiers of motor and gear unit (None: direct) from what a button sends: ``motor|gear`` or ``motor|``."""
    motor, _, gear = key.partition("|")
    return motor, gear or None


def _rankings(chosen: str, translate: Translate) -> tuple[OptionView, ...]:
    found = declaration(SelectionRequest.model_fields["ranking"])
    labels = getattr(found, "labels", {})
    return tuple(OptionView(key, translate(labels.get(key, key)), key == chosen) for key in get_args(Ranking))


def _options(names: set[str], chosen: str, everything: str) -> tuple[OptionView, ...]:
    options = [OptionView("", everything, not chosen)]
    return tuple(options + [OptionView(name, name, name == chosen) for name in sorted(names)])


def _candidate(one: RankedCandidate, wanted: Wanted, translate: Translate) -> CandidateView:
    found, key = one.candidate, f"{one.motor.id}|{one.gear_unit.id if one.gear_unit else ''}"
    return CandidateView(
        rank=one.rank, key=key, motor=one.motor.name, gear_unit=one.gear_unit.name if one.gear_unit else "",
        ratio=number(one.gear_unit.ratio) if one.gear_unit else "1",
        utilisation=percent(found.utilisation), verdict="tight" if found.utilisation > 0.8 else "ok",
        deciding=translate(CHECK_NAMES.get(found.deciding, ABSENT)),
        mass=ABSENT if found.mass is None else show(found.mass, "kg"),
        rated_torque=ABSENT if found.rated_torque is None else show(found.rated_torque, "N m"),
        inertia_ratio=ABSENT if found.inertia_ratio is None else number(found.inertia_ratio),
        not_checked=tuple(translate(CHECK_NAMES[name]) for name in found.not_checked), compared=key in wanted.compare,
    )  # fmt: skip


def _known(keys: tuple[str, ...], motors: tuple[Any, ...], gears: tuple[Any, ...]) -> list[str]:
    names = {one.id for one in (*motors, *gears)}
    parts = [(key, split_key(key)) for key in keys]
    return [key for key, (motor, gear) in parts if motor in names and (gear is None or gear in names)]


def _compared(request: Mapping[str, Any], key: str, selections: SelectionService, translate: Translate) -> ComparedView:
    motor_id, gear_id = split_key(key)
    found = selections.explain(dict(request), motor_id, gear_id)
    parts, checks = found.parts, found.drive.checks
    views = tuple(check_view(check, found.sheet, translate) for check in checks)
    assert parts.motor is not None
    return ComparedView(
        key=key, motor=parts.motor.name, gear_unit=parts.gear_unit.name if parts.gear_unit else "",
        source=parts.motor.source, checks=views, failing=sum(view.verdict == "fails" for view in views),
        drives=tuple(suggestion.drive.name for suggestion in found.suggestions),
    )  # fmt: skip


def _why(
    request: Mapping[str, Any],
    wanted: Wanted,
    selections: SelectionService,
    motors: tuple[Any, ...],
    gears: tuple[Any, ...],
    translate: Translate,
) -> tuple[ComparedView | None, str]:
    """All checks of the motor (and gear unit) that the reader named."""
    if not wanted.why_motor:
        return None, ""
    motor = _named(motors, wanted.why_motor)
    gear: Product | ServoGearUnit | None = _named(gears, wanted.why_gear) if wanted.why_gear else None
    if motor is None:
        return None, translate("The catalogue holds no motor of this name.")
    if wanted.why_gear and gear is None:
        return None, translate("The catalogue holds no gear unit of this name.")
    return _compared(request, f"{motor.id}|{gear.id if gear else ''}", selections, translate), ""


def _named(products: tuple[Any, ...], text: str) -> Any:
    """The product that a reader means: identifier, full name or type, else the first whose name holds the text."""
    wanted = text.casefold()
    exact = (one for one in products if wanted in (one.id, one.name.casefold(), one.model.casefold()))
    return next(exact, None) or next((one for one in products if wanted in one.name.casefold()), None)


def _chart(outcome: SelectionOutcome, translate: Translate) -> ChartView | None:
    points = [(one.candidate.mass, one.candidate.utilisation, one.motor.name, one.gear_unit is None)
              for one in outcome.candidates if one.candidate.mass is not None]  # fmt: skip
    return chart_view("alternatives", alternatives_figure(points, translate)) if points else None
