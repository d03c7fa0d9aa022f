"""Any diagram of the engine as a figure."""

import math

import pytest

from app.charts import diagram_figure, svg
from app.engine.diagram import Diagram, series


def test_values_are_shown_in_the_units_of_the_diagram() -> None:
    """Half a turn is 180 degrees; pi / 30 rad/s is 1 rpm."""
    lines = (series("exact", [0, math.pi], [0, math.pi / 30]), series("limit", [0, math.pi], [1, 1], "limit"))
    diagram = Diagram("d", "Speed over angle", "angle", "deg", "speed", "rpm", lines)
    figure = diagram_figure(diagram)
    assert figure["data"][0]["x"] == [0, 180]
    assert figure["data"][0]["y"] == pytest.approx([0, 1])
    assert figure["layout"]["xaxis"]["title"]["text"] == "angle in deg"
    assert len({trace["line"]["color"] for trace in figure["data"]}) == 2
    assert svg(figure, "chart").startswith("<svg")
