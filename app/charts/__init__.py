"""Charts: a result becomes a Plotly figure as a plain dict, and the same figure an SVG for pages without scripts.

Every trace carries in ``meta`` the name of its colour in the page's stylesheet (``series-1`` ...), so that the page can
follow the reader's light or dark theme; the colours written into the figure are those of the light theme.
"""

from app.charts.axis import axis_figures
from app.charts.cycle import cycle_figure
from app.charts.diagram import diagram_figure
from app.charts.figure import Figure
from app.charts.svg import svg
from app.charts.table_curves import drawn, table_figure
from app.charts.torque_speed import torque_speed_figure

__all__ = [
    "Figure",
    "axis_figures",
    "cycle_figure",
    "diagram_figure",
    "drawn",
    "svg",
    "table_figure",
    "torque_speed_figure",
]
