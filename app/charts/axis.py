"""All charts of one axis, in the order in which a reader meets them: one list for page, REST and report."""

from collections.abc import Iterator

from app.charts.cycle import cycle_figure
from app.charts.diagram import diagram_figure
from app.charts.figure import Figure, Translate
from app.charts.torque_speed import torque_speed_figure
from app.engine.drives.base import DriveResult
from app.engine.mechanisms.load import Load


def axis_figures(
    result: DriveResult, load: Load, translate: Translate = str, *, four_quadrants: bool = False
) -> Iterator[tuple[str, Figure]]:
    """Key and figure of every chart.

    A drive that makes its own ramps has no cycle of its own: neither torque over speed nor the course over time.
    """
    if result.cycle is not None:
        yield "torque-speed", torque_speed_figure(result, translate, four_quadrants=four_quadrants)
        yield "cycle", cycle_figure(result.cycle, load.cycle, translate)
    for diagram in (*result.diagrams, *load.diagrams):
        yield diagram.key.replace("_", "-"), diagram_figure(diagram, translate)
