"""The alternatives of the Lachman axis: which 1FT5 fit, why 104 does not, and taking one over."""

import json
import re
from typing import TYPE_CHECKING
from urllib.parse import urlencode

import pytest

from app.settings import PROJECT_ROOT
from app.web.form_data import flat

if TYPE_CHECKING:
    from starlette.testclient import TestClient


@pytest.fixture
def axis() -> list[tuple[str, str]]:
    """The Lachman axis without motor, as the form sends it."""
    path = PROJECT_ROOT / "examples" / "lachman-ball-screw-axis.json"
    raw = json.loads(path.read_text(encoding="utf-8"))["requests"]["main"]
    del raw["drive"]["motor"]
    return list(flat(raw))


def result(client: "TestClient", pairs: list[tuple[str, str]]) -> str:
    """The result part of the workbench."""
    headers = {"content-type": "application/x-www-form-urlencoded"}
    answer = client.post("/workbench/ball_screw/result", content=urlencode(pairs), headers=headers)
    assert answer.status_code == 200
    return answer.text


def test_of_the_motors_of_the_source_106_and_108_fit(client: "TestClient", axis: list[tuple[str, str]]) -> None:
    wanted = [*axis, ("_alt_maker", "Siemens"), ("_alt_kind", "direct")]
    found = re.findall(r'data-candidate="servo-motor:siemens:1ft5[^:]*:(1ft5-\d+)[^"]*\|"', result(client, wanted))
    assert sorted(found) == ["1ft5-106", "1ft5-108"]


def test_why_104_does_not_fit_is_said_with_its_utilisation(client: "TestClient", axis: list[tuple[str, str]]) -> None:
    text = result(client, [*axis, ("_alt_why_motor", "1FT5 104")])
    why = text.split("data-why", 1)[1].split("</div>", 1)[0]
    # 48.92 N m against 42 N m * 1.05 = 44.1 N m: 110.9 %
    line = re.search(r"check-line--fails.*?Steady torque at working speed.*?(\d+\.\d+) %", why, re.S)
    assert line is not None
    assert float(line[1]) == pytest.approx(110.9, abs=0.1)
    assert "no motor of this name" in result(client, [*axis, ("_alt_why_motor", "nothing like it")])


def test_a_candidate_is_taken_over_with_everything_else_as_typed(
    client: "TestClient", axis: list[tuple[str, str]]
) -> None:
    found = re.findall(r'data-candidate="([^"]+)"', result(client, axis))
    headers = {"content-type": "application/x-www-form-urlencoded"}
    answer = client.post("/workbench/ball_screw", content=urlencode([*axis, ("use", found[0])]), headers=headers)
    motor, _, gear = found[0].partition("|")
    assert f'value="{motor}"' in answer.text
    assert not gear or f'value="{gear}"' in answer.text
    assert 'name="mechanism.slide_mass_kg" value="400"' in answer.text
    compared = result(client, [*axis, *(("_alt_compare", key) for key in found[:3])])
    assert len(re.findall(r"<th scope=\"col\">[^<]+<br>", compared.split("comparison", 1)[1])) == 3


def test_four_quadrants_are_shown_on_request(client: "TestClient", axis: list[tuple[str, str]]) -> None:
    def lowest_speed(text: str) -> float:
        figure = json.loads(re.search(r"data-figure>(.*?)</script>", text, re.S)[1])  # type: ignore[index]
        return float(min(figure["data"][0]["x"]))

    assert lowest_speed(result(client, axis)) == 0
    # rapid down: 30 m/min over a lead of 20 mm, 1500 rpm backwards
    assert lowest_speed(result(client, [*axis, ("_quadrants", "4")])) == pytest.approx(-1500)
