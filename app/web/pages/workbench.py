"""The workbench: one axis, from its entries to verdict, charts and sheet."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Annotated, Any

from fastapi import APIRouter, Query, Request, Response
from fastapi.responses import RedirectResponse
from markupsafe import Markup

from app.services.errors import InvalidInputError
from app.services.mechanisms import MechanismKind, mechanism_kind
from app.services.reports import axis_report
from app.web.alternatives import AlternativesView, Wanted, alternatives_of
from app.web.deps import Examples, Projects, Selections, Sizings
from app.web.drawings import drawing_of
from app.web.form_data import nested
from app.web.project_views import ProjectView, axis_errors, new_document
from app.web.submission import Submission, Submitted
from app.web.templating import page, translator
from app.web.workbench import Axis, axis_of

router = APIRouter()
UNPROCESSABLE = 422


@dataclass(frozen=True)
class ExampleLink:
    """A worked example that fills the form."""

    title: str
    source: str
    url: str


@dataclass(frozen=True)
class WorkbenchPage:
    """Context of ``workbench.html``."""

    mechanism: MechanismKind
    drawing: Markup
    axis: Axis
    examples: tuple[ExampleLink, ...]
    project: ProjectView | None
    url: str
    """Where the form is sent."""


@dataclass(frozen=True)
class AxisPart:
    """Context of the parts of the workbench that are fetched alone."""

    axis: Axis
    project: ProjectView | None = None


@router.get("/workbench/{kind}")
def show_workbench(
    request: Request,
    kind: str,
    sizings: Sizings,
    selections: Selections,
    examples: Examples,
    example: Annotated[str | None, Query(max_length=200)] = None,
    name: Annotated[str | None, Query(alias="request", max_length=200)] = None,
) -> Response:
    """An empty workbench, one filled by the query (every entry under its name), or one filled by an example."""
    mechanism = mechanism_kind(kind)
    raw: Mapping[str, Any] = nested(request.query_params.multi_items())
    if example is not None:
        requests = examples.file(example).requests
        raw = requests.get(name or "", next(iter(requests.values())))
        kind_of_example = raw.get("mechanism", {}).get("kind", kind)
        mechanism = mechanism_kind(kind_of_example)
    search = searching(request, Wanted(), selections)
    axis = axis_of(mechanism, raw, sizings, translator(request), alternatives=search)
    return workbench_page(request, mechanism, axis, examples)


@router.post("/workbench/{kind}")
def submit_workbench(
    request: Request,
    kind: str,
    form: Submitted,
    sizings: Sizings,
    selections: Selections,
    projects: Projects,
    examples: Examples,
) -> Response:
    """Calculate, change the form, or save: always with everything as it was typed."""
    mechanism, translate = mechanism_kind(kind), translator(request)
    search = searching(request, Wanted.of(form.lists), selections)
    axis = axis_of(
        mechanism,
        form.raw,
        sizings,
        translate,
        demanded=form.action != "update",
        alternatives=search,
        four_quadrants=wants_signs(form),
    )
    if form.action == "report" and axis.result.sizing is not None:
        return report_of(axis, translate)
    if form.action == "save" and not axis.refused:
        try:
            opened = projects.create(new_document(axis.raw, mechanism))
        except InvalidInputError as error:
            axis = axis_of(mechanism, form.raw, sizings, translate, demanded=True, further=axis_errors(error))
        else:
            return RedirectResponse(f"/p/{opened.edit_token}?saved=new", 303)
    return workbench_page(request, mechanism, axis, examples)


@router.post("/workbench/{kind}/result")
def show_result(request: Request, kind: str, form: Submitted, sizings: Sizings, selections: Selections) -> Response:
    """What follows from the entries, as the part of the page that shows it: for recalculating while typing."""
    search = searching(request, Wanted.of(form.lists), selections)
    axis = axis_of(
        mechanism_kind(kind), form.raw, sizings, translator(request), alternatives=search,
        four_quadrants=wants_signs(form),
    )  # fmt: skip
    return page(request, "partials/result/result.html", AxisPart(axis))


@router.post("/workbench/{kind}/form")
def show_form(request: Request, kind: str, form: Submitted, sizings: Sizings) -> Response:
    """The entries alone, after a row or a choice has changed."""
    axis = axis_of(mechanism_kind(kind), form.raw, sizings, translator(request))
    return page(request, "partials/form/axis.html", AxisPart(axis))


def workbench_page(
    request: Request,
    mechanism: MechanismKind,
    axis: Axis,
    examples: Examples,
    project: ProjectView | None = None,
    url: str = "",
) -> Response:
    """The whole workbench; 422 where something typed cannot be used."""
    context = WorkbenchPage(
        mechanism=mechanism,
        drawing=drawing_of(mechanism.drawing),
        axis=axis,
        examples=tuple(example_links(mechanism.kind, examples)) if project is None else (),
        project=project,
        url=url or f"/workbench/{mechanism.kind}",
    )
    return page(request, "workbench.html", context, UNPROCESSABLE if axis.refused else 200)


def report_of(axis: Axis, translate: Callable[[str], str]) -> Response:
    """The PDF report of a calculated axis."""
    assert axis.result.sizing is not None
    sizing = axis.result.sizing
    made = axis_report(sizing, drawing_of(sizing.typed.request.mechanism.drawing), translate)
    return Response(
        made, media_type="application/pdf", headers={"Content-Disposition": 'inline; filename="report.pdf"'}
    )


def wants_signs(form: Submission) -> bool:
    """Whether the reader asks for all four quadrants of the torque-speed chart."""
    return form.steering.get("quadrants") == "4"


def searching(
    request: Request, wanted: Wanted, selections: Selections
) -> Callable[[Mapping[str, Any]], AlternativesView]:
    """The search for alternatives as this reader wants it."""
    return lambda raw: alternatives_of(raw, wanted, selections, translator(request))


def example_links(kind: str, examples: Examples) -> list[ExampleLink]:
    """The worked examples that a mechanism can be filled with: the first request of each file that is of its kind."""
    found = []
    for file in examples.files():
        for name, raw in file.requests.items():
            if raw.get("mechanism", {}).get("kind") == kind:
                url = f"/workbench/{kind}?example={file.id}&request={name}"
                found.append(ExampleLink(str(raw.get("name") or file.title), file.source, url))
    return found
