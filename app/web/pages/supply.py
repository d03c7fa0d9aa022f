"""Several axes on one supply: those of a project, or of a worked example. The entries stand in the address."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any

from fastapi import APIRouter, Path, Query, Request, Response

from app.charts import diagram_figure
from app.engine.drives import DEFAULT_KIND
from app.engine.sheet import Verdict
from app.engine.supply import AxisModule, SupplyRules
from app.reports import mathml
from app.reports.numbers import show
from app.reports.sheet_view import VERDICT_ICONS, sheet_view
from app.services.errors import FieldError, InvalidInputError, NotFoundError
from app.services.multi_axis import AxisOnSupply, MultiAxis, MultiAxisService
from app.web.chart_views import chart_view
from app.web.deps import Examples, Projects, Sizings
from app.web.form_data import fitted
from app.web.forms import FieldView, PartView, Reader, errors_by_name, field_view, part_view
from app.web.project_views import ProjectView, project_view
from app.web.submission import submission_of
from app.web.templating import Translate, page, translator
from app.web.workbench import HeadlineView, ResultView

router = APIRouter()
UNPROCESSABLE = 422
Token = Annotated[str, Path(min_length=1, max_length=100)]


@dataclass(frozen=True)
class AxisEntries:
    """What is asked about one axis."""

    name: str
    start: FieldView
    module: PartView


@dataclass(frozen=True)
class SupplyPage:
    """Context of ``supply.html``."""

    url: str
    hidden: tuple[tuple[str, str], ...]
    axes: tuple[AxisEntries, ...]
    supply: PartView
    result: ResultView
    errors: tuple[FieldError, ...]
    left_out: tuple[str, ...]
    """Axes that stand on no supply module."""
    project: ProjectView | None


@router.get("/supply")
def show_supply(
    request: Request, examples: Examples, sizings: Sizings,
    example: Annotated[str, Query(max_length=200)],
    name: Annotated[str, Query(alias="request", max_length=200)] = "main",
) -> Response:  # fmt: skip
    """The supply of a worked example, with its own entries until others are typed."""
    raw = examples.file(example).requests.get(name)
    if raw is None or "axes" not in raw:
        raise NotFoundError(f"The example has no supply {name[:60]!r}.")
    hidden = (("example", example), ("request", name))
    requests = [(str(one["sizing"].get("name") or number), one["sizing"]) for number, one in enumerate(raw["axes"], 1)]
    return _page(request, sizings, "/supply", hidden, requests, raw, None)


@router.get("/p/{token}/supply")
def show_project_supply(request: Request, token: Token, projects: Projects, sizings: Sizings) -> Response:
    """The supply of the servo axes of a project."""
    state = projects.open(token)
    requests = [(str(axis["name"]), dict(axis["request"])) for axis in state.document["axes"]]
    view = project_view(request, token, state, -1)
    return _page(request, sizings, f"/p/{token}/supply", (), requests, {}, view)


def _page(
    request: Request, sizings: Sizings, url: str, hidden: tuple[tuple[str, str], ...],
    requests: list[tuple[str, dict[str, Any]]], given: Mapping[str, Any], project: ProjectView | None,
) -> Response:  # fmt: skip
    steering = {"example", "request"}
    pairs = [(key, value) for key, value in request.query_params.multi_items() if key not in steering]
    form = submission_of(pairs)
    typed = form.raw if pairs else _entries(given)
    on_supply = [(name, raw) for name, raw in requests if _is_servo(raw)]
    left_out = tuple(name for name, raw in requests if not _is_servo(raw))
    asked = _asked(typed, on_supply)
    found, errors = _calculated(sizings, asked) if pairs or given else (None, [])
    translate = translator(request)
    reader = Reader(errors_by_name(errors))
    context = SupplyPage(
        url=url, hidden=hidden, axes=tuple(_axis_entries(reader, typed, on_supply)),
        supply=part_view(SupplyRules, fitted(SupplyRules, typed.get("supply")), reader, "supply", "Supply"),
        result=ResultView("open") if found is None else _result(found, translate),
        errors=tuple(errors), left_out=left_out, project=project,
    )  # fmt: skip
    return page(request, "supply.html", context, UNPROCESSABLE if errors else 200)


def _is_servo(raw: Mapping[str, Any]) -> bool:
    drive = raw.get("drive")
    return not isinstance(drive, Mapping) or drive.get("kind", DEFAULT_KIND) == DEFAULT_KIND


def _entries(given: Mapping[str, Any]) -> dict[str, Any]:
    """The entries of a request without its sizings."""
    axes = [{key: value for key, value in one.items() if key != "sizing"} for one in given.get("axes", [])]
    return {"supply": given.get("supply", {}), "axes": axes}


def _asked(typed: Mapping[str, Any], requests: list[tuple[str, dict[str, Any]]]) -> dict[str, Any]:
    rows = typed.get("axes")
    entries = rows if isinstance(rows, list) else []
    axes = []
    for number, (name, raw) in enumerate(requests):
        own = entries[number] if number < len(entries) and isinstance(entries[number], Mapping) else {}
        more = {
            key: value for key, value in own.items() if key in ("start_s", "module") and value not in ("", {}, None)
        }
        axes.append({"sizing": {**raw, "name": raw.get("name") or name}, **more})
    return {"axes": axes, "supply": typed.get("supply") or {}}


def _calculated(sizings: Sizings, asked: dict[str, Any]) -> tuple[MultiAxis | None, list[FieldError]]:
    if not asked["axes"]:
        return None, []
    try:
        return MultiAxisService(sizings).size(asked), []
    except InvalidInputError as error:
        return None, list(error.errors)


def _axis_entries(
    reader: Reader, typed: Mapping[str, Any], requests: list[tuple[str, dict[str, Any]]]
) -> list[AxisEntries]:
    rows = typed.get("axes")
    entries = rows if isinstance(rows, list) else []
    info = AxisOnSupply.model_fields["start"]
    declared = next(found for name, _, found in AxisOnSupply.declarations() if name == "start")
    made = []
    for number, (name, _) in enumerate(requests):
        own = entries[number] if number < len(entries) and isinstance(entries[number], Mapping) else {}
        path = f"axes.{number}"
        made.append(AxisEntries(
            name=name, start=field_view(declared, info, "start", own.get("start_s"), reader, f"{path}.start_s"),
            module=part_view(AxisModule, own.get("module"), reader, f"{path}.module", "Axis module"),
        ))  # fmt: skip
    return made


def _result(found: MultiAxis, translate: Translate) -> ResultView:
    view = sheet_view(found.sheet, translate)
    made = [check for check in found.sheet.checks if check.utilisation is not None]
    deciding = max(made, key=lambda check: check.utilisation or 0.0, default=None)
    counts = {str(one): sum(check.verdict == one for check in found.sheet.checks) for one in Verdict}
    return ResultView(
        state="done", verdict=str(found.verdict), icon=VERDICT_ICONS[found.verdict], counts=counts,
        deciding=next((one for one in view.checks if deciding is not None and one.key == deciding.key), None),
        headlines=tuple(
            HeadlineView(h.key, translate(h.label).removesuffix("."), mathml.symbol(h.symbol), show(h.value, h.unit))
            for h in found.headlines
        ),
        checks=tuple(one for one in view.checks if one.verdict != Verdict.NOT_CHECKED),
        unchecked=tuple(one for one in view.checks if one.verdict == Verdict.NOT_CHECKED), sheet=view,
        charts=tuple(chart_view(one.key.replace("_", "-"), diagram_figure(one, translate)) for one in found.diagrams),
    )  # fmt: skip
