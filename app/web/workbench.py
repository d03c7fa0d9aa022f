"""The workbench as a page shows it: the form of one axis, and what follows from it. Handlers call, templates show."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any

from markupsafe import Markup

from app.engine.drives import DEFAULT_KIND, drives
from app.engine.environment import Environment
from app.engine.motion import motions
from app.engine.optimum import OptimumInput
from app.engine.quantity import declaration
from app.engine.sheet import Verdict
from app.reports import mathml
from app.reports.numbers import show
from app.reports.sheet_view import VERDICT_ICONS, CheckView, SheetView, sheet_view
from app.services.errors import FieldError, InvalidInputError
from app.services.mechanisms import MechanismKind
from app.services.reports import ROLES
from app.services.requests import SizingRequest
from app.services.sizing import Sizing, SizingService
from app.web.alternatives import AlternativesView
from app.web.chart_views import ChartView, charts_of
from app.web.form_data import fitted
from app.web.forms import (
    ChoiceView,
    FieldView,
    PartView,
    Reader,
    choice_view,
    errors_by_name,
    field_id,
    field_view,
    optional_view,
    part_view,
)

Translate = Callable[[str], str]


@dataclass(frozen=True)
class ErrorLine:
    """One line of the summary of errors, or one entry that is still needed."""

    name: str
    """Dotted path of the value."""
    id: str
    """Identifier of the element to go to."""
    label: str
    message: str


@dataclass(frozen=True)
class FormView:
    """The form of one axis."""

    kind: str
    name: FieldView
    notes: FieldView
    mechanism: PartView
    motion: ChoiceView
    environment: PartView
    drive: ChoiceView
    optimum: ChoiceView
    errors: tuple[ErrorLine, ...]

    @property
    def ranked(self) -> bool:
        """Whether candidates of the catalogue are ranked for this kind of drive, and its transmission optimised."""
        return self.drive.selected == DEFAULT_KIND

    @property
    def sections(self) -> tuple[PartView | ChoiceView, ...]:
        """The parts of an axis in order."""
        return (self.mechanism, self.motion, self.environment, self.drive, self.optimum)


@dataclass(frozen=True)
class HeadlineView:
    """A result that is shown before all others."""

    key: str
    label: str
    symbol: Markup
    value: str


@dataclass(frozen=True)
class PartLine:
    """A chosen product."""

    role: str
    title: str
    """What it is called, for the reader."""
    name: str
    source: str


@dataclass(frozen=True)
class ResultView:
    """What follows from the entries. ``state`` is ``open`` (entries are missing), ``refused`` or ``done``."""

    state: str
    needed: tuple[ErrorLine, ...] = ()
    errors: tuple[ErrorLine, ...] = ()
    verdict: str = "not_checked"
    icon: str = "?"
    deciding: CheckView | None = None
    counts: Mapping[str, int] | None = None
    headlines: tuple[HeadlineView, ...] = ()
    checks: tuple[CheckView, ...] = ()
    unchecked: tuple[CheckView, ...] = ()
    parts: tuple[PartLine, ...] = ()
    sheet: SheetView | None = None
    charts: tuple[ChartView, ...] = ()
    four_quadrants: bool = False
    alternatives: AlternativesView | None = None
    sizing: Sizing | None = None


@dataclass(frozen=True)
class Axis:
    """One axis as typed, its form and its result."""

    raw: dict[str, Any]
    form: FormView
    result: ResultView

    @property
    def refused(self) -> bool:
        """Whether something typed cannot be used, or is missing though a result was demanded."""
        return bool(self.form.errors)


def complete(kind: MechanismKind, raw: Mapping[str, Any]) -> dict[str, Any]:
    """What was typed for a mechanism, with its kind, a motion that fits it, and one row in each list that needs one."""
    values = {name: raw[name] for name in SizingRequest.model_fields if name in raw}
    values["mechanism"] = {**_mapping(raw.get("mechanism")), "kind": kind.kind}
    motion = _mapping(raw.get("motion"))
    fitting = motions(kind.motion_kind)
    values["motion"] = {**motion, "kind": motion["kind"] if motion.get("kind") in fitting else next(iter(fitting))}
    drive = _mapping(raw.get("drive"))
    values["drive"] = {**drive, "kind": drive["kind"] if drive.get("kind") in drives() else DEFAULT_KIND}
    return fitted(SizingRequest, values)


def axis_of(
    kind: MechanismKind,
    raw: Mapping[str, Any],
    sizings: SizingService,
    translate: Translate,
    *,
    demanded: bool = False,
    further: Iterable[FieldError] = (),
    alternatives: Callable[[Mapping[str, Any]], AlternativesView] | None = None,
    four_quadrants: bool = False,
) -> Axis:
    """Calculate what was typed. Where entries are missing this is no error unless the result was demanded.

    ``further`` are errors from elsewhere (saving) to be shown too; ``alternatives`` searches the catalogue.
    """
    typed = complete(kind, raw)
    sizing, refused = None, list(further)
    try:
        sizing = sizings.size(typed)
    except InvalidInputError as error:
        known = {(one.path, one.message) for one in refused}
        refused += [one for one in error.errors if (one.path, one.message) not in known]
    missing = [] if demanded else [error for error in refused if _is_empty(error.value)]
    wrong = [error for error in refused if error not in missing]
    form, needed = _form(kind, typed, wrong, missing)
    result = _result(sizing, form.errors, needed, translate)
    if sizing is not None:
        charts = charts_of(sizing, translate, four_quadrants=four_quadrants)
        result = replace(result, charts=charts, four_quadrants=four_quadrants)
    if sizing is not None and alternatives is not None and form.ranked:
        result = replace(result, alternatives=alternatives(typed))
    return Axis(typed, form, result)


def _is_empty(value: Any) -> bool:
    return value is None or value in ("", {}, [], ())


def _mapping(value: Any) -> Mapping[str, Any]:
    return value if isinstance(value, Mapping) else {}


def _form(
    kind: MechanismKind, raw: Mapping[str, Any], wrong: list[FieldError], missing: list[FieldError]
) -> tuple[FormView, tuple[ErrorLine, ...]]:
    reader = Reader(errors_by_name(wrong))
    form = FormView(
        kind=kind.kind,
        name=_own_field("name", raw, reader),
        notes=_own_field("notes", raw, reader),
        mechanism=part_view(kind.model, raw.get("mechanism"), reader, "mechanism", kind.title),
        motion=choice_view(motions(kind.motion_kind), raw.get("motion"), reader, "motion", "Motion"),
        environment=part_view(Environment, raw.get("environment"), reader, "environment", "Environment"),
        drive=choice_view(drives(), raw.get("drive"), reader, "drive", "Drive"),
        optimum=optional_view(OptimumInput, raw.get("optimum"), reader, "optimum", "Optimum for acceleration"),
        errors=(),
    )
    return replace(form, errors=_lines(wrong, reader)), _lines(missing, reader)


def _own_field(name: str, raw: Mapping[str, Any], reader: Reader) -> FieldView:
    info = SizingRequest.model_fields[name]
    found = declaration(info)
    assert found is not None
    return field_view(found, info, name, raw.get(name), reader, name)


def _lines(errors: Iterable[FieldError], reader: Reader) -> tuple[ErrorLine, ...]:
    """Each error with the place on the page that is nearest to it."""
    lines = []
    for error in errors:
        parts = error.name.split(".") if error.name else []
        near = [".".join(parts[:count]) for count in range(len(parts), 0, -1)]
        place = next((reader.places[name] for name in near if name in reader.places), (field_id("form"), error.name))
        lines.append(ErrorLine(error.name, place[0], place[1], error.message))
    return tuple(lines)


def _result(
    sizing: Sizing | None, errors: tuple[ErrorLine, ...], needed: tuple[ErrorLine, ...], translate: Translate
) -> ResultView:
    if sizing is None:
        return ResultView("refused" if errors else "open", needed, errors)
    view = sheet_view(sizing.sheet, translate)
    deciding = sizing.deciding_check
    return ResultView(
        state="done",
        errors=errors,
        verdict=str(sizing.verdict),
        icon=VERDICT_ICONS[sizing.verdict],
        deciding=next((check for check in view.checks if deciding is not None and check.key == deciding.key), None),
        counts={str(verdict): count for verdict, count in sizing.counts.items()},
        headlines=tuple(
            HeadlineView(h.key, translate(h.label).removesuffix("."), mathml.symbol(h.symbol), show(h.value, h.unit))
            for h in sizing.headlines
        ),
        checks=tuple(check for check in view.checks if check.verdict != Verdict.NOT_CHECKED),
        unchecked=tuple(check for check in view.checks if check.verdict == Verdict.NOT_CHECKED),
        parts=tuple(
            PartLine(role, ROLES.get(role, role), f"{product.manufacturer} {product.model}".strip(), product.source)
            for role, product in sizing.parts.chosen()
        ),
        sheet=view,
        sizing=sizing,
    )
