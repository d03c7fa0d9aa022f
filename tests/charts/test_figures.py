"""Charts show what was calculated: points of the cycle, limits, and no extreme lost."""

import json
from xml.etree import ElementTree

import numpy as np
import pytest

from app.charts import cycle_figure, svg, torque_speed_figure
from app.charts.figure import thinned
from app.charts.svg import Scale
from app.services.sizing import Sizing, SizingService
from app.settings import PROJECT_ROOT


@pytest.fixture(scope="module")
def sizing() -> Sizing:
    """The Lachman axis with 1FT5 106."""
    path = PROJECT_ROOT / "examples" / "lachman-ball-screw-axis.json"
    return SizingService(None).size(json.loads(path.read_text(encoding="utf-8"))["requests"]["main"])  # type: ignore[arg-type]


def test_torque_over_speed_holds_peak_and_limits(sizing: Sizing) -> None:
    figure = torque_speed_figure(sizing.drive)
    traces = {trace["name"]: trace for trace in figure["data"]}
    # worked example: 100.4 N m dynamic torque; rapid 1500 rpm; S1 line from 55 N m to 39 N m at 2000 rpm
    assert max(traces["cycle"]["y"]) == pytest.approx(100.396, rel=1e-4)
    assert max(traces["cycle"]["x"]) == pytest.approx(1500)
    s1 = traces["S1 curve (continuous)"]
    assert (s1["y"][0], s1["x"][-1], s1["y"][-1]) == pytest.approx((55, 2000, 39))
    signed = torque_speed_figure(sizing.drive, four_quadrants=True)
    assert min(next(t for t in signed["data"] if t["name"] == "cycle")["x"]) == pytest.approx(-1500)


def test_power_over_time_is_torque_times_speed(sizing: Sizing) -> None:
    traces = {trace["name"]: trace for trace in cycle_figure(sizing.drive.cycle, sizing.load.cycle)["data"]}
    torque, power = np.array(traces["motor torque"]["y"]), np.array(traces["motor power"]["y"])
    speed = np.array(traces["motor speed"]["y"]) * 2 * np.pi / 60
    np.testing.assert_allclose(power, torque * speed, rtol=1e-4, atol=0.1)


def test_thinning_keeps_ends_and_extremes() -> None:
    x = np.arange(50_000.0)
    y = np.sin(x / 900)
    y[12_345], y[40_001] = 7.0, -9.0
    few_x, few_y = thinned(x, y)
    assert few_x.size <= 2002
    assert (few_x[0], few_x[-1], few_y.max(), few_y.min()) == (0, 49_999, 7, -9)


def test_a_figure_is_well_formed_svg_and_plain_json(sizing: Sizing) -> None:
    for figure in (torque_speed_figure(sizing.drive), cycle_figure(sizing.drive.cycle, sizing.load.cycle)):
        json.dumps(figure, allow_nan=False)
        hostile = {**figure, "layout": {**figure["layout"], "title": {"text": "<script>&"}}}
        root = ElementTree.fromstring(svg(hostile, "x"))
        assert root.find("{http://www.w3.org/2000/svg}title").text == "<script>&"  # type: ignore[union-attr]


@pytest.mark.parametrize("values", [[0.0], [1e-9, 2e-9], [-5.0, 1200.0], [1e12]])
def test_a_scale_holds_all_values_between_its_ends(values: list[float]) -> None:
    scale = Scale.over(values, 0.0, 100.0)
    assert scale.low <= min(values)
    assert scale.high >= max(values)
    assert 2 <= len(scale.ticks) <= 14
