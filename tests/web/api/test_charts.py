"""Charts over REST: the figures hold the numbers of the sizing."""

import pytest
from starlette.testclient import TestClient

from app.web.api.models import ChartsAnswer
from tests.sizing_requests import SCREW_AXIS

ADDRESS = "/api/v1/charts"


@pytest.mark.parametrize("signed", [False, True])
def test_the_charts_hold_the_top_speed_of_the_sizing(client: TestClient, signed: bool):
    """0.5 m/s on a lead of 10 mm is 3000 rpm, in both directions."""
    response = client.post(ADDRESS, json=SCREW_AXIS, params={"four_quadrants": signed})
    assert response.status_code == 200
    charts = ChartsAnswer.model_validate_json(response.content, strict=True)
    speeds = charts.cycle.data[0]["y"]
    assert (min(speeds), max(speeds)) == (pytest.approx(-3000), pytest.approx(3000))
    lowest = min(min(trace["x"]) for trace in charts.torque_speed.data)
    assert (lowest < -2999) == signed


def test_charts_are_drawn_without_a_motor(client: TestClient):
    request = {name: value for name, value in SCREW_AXIS.items() if name != "drive"}
    assert client.post(ADDRESS, json=request).status_code == 200
