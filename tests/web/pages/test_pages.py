"""Every address of the pages answers, with one heading and no word that is missing in a template."""

import json
import re
from typing import TYPE_CHECKING

import pytest

from app.settings import PROJECT_ROOT

if TYPE_CHECKING:
    from starlette.testclient import TestClient

MOTOR = "servo-motor:siemens:1ft5-lachman-2015:1ft5-106-1ac71"
PAGES = [
    "/",
    "/workbench/ball_screw",
    "/workbench/timing_belt",
    "/workbench/rack_pinion",
    "/workbench/rotary_load",
    "/workbench/belt_conveyor",
    "/workbench/ball_screw?example=tr-ball-screw",
    "/examples",
    *(f"/examples/{path.stem}" for path in sorted((PROJECT_ROOT / "examples").glob("*.json"))),
    "/formulas",
    "/catalogue",
    "/catalogue/servo_motor",
    "/catalogue/servo_motor?text=1FT5&sort=rated_torque_nm&descending=true",
    f"/catalogue/servo_motor/{MOTOR}",
    "/catalogue/induction_motor?page=3",
    "/tables",
    "/tables?text=factor&topic=gear_units",
    "/tables/duty_types",
    "/rest",
]


@pytest.mark.parametrize("address", PAGES)
def test_a_page_answers_with_one_heading(client: "TestClient", address: str) -> None:
    answer = client.get(address)
    assert answer.status_code == 200
    assert len(re.findall(r"<h1[ >]", answer.text)) == 1
    assert re.search(r"<title>[^<]+ · Drivewright</title>", answer.text)
    assert "default-src 'self'" in answer.headers["content-security-policy"]


@pytest.mark.parametrize(
    ("address", "status"),
    [("/nowhere", 404), ("/examples/none", 404), ("/catalogue/none", 404), ("/workbench/none", 404), ("/p/none", 404),
     ("/catalogue/servo_motor?sort=none", 422), ("/catalogue/servo_motor?page=0", 422),
     ("/catalogue/servo_motor/none", 404)],
)  # fmt: skip
def test_what_is_not_there_is_a_page_that_says_so(client: "TestClient", address: str, status: int) -> None:
    answer = client.get(address, headers={"accept": "text/html"})
    assert answer.status_code == status
    assert len(re.findall(r"<h1[ >]", answer.text)) == 1
    assert "Traceback" not in answer.text


def test_the_catalogue_list_sorts_by_the_column(client: "TestClient") -> None:
    text = client.get("/catalogue/servo_motor?text=1FT5&sort=rated_torque_nm&descending=true").text
    assert 'aria-sort="descending"' in text
    models = re.findall(r'<th scope="row"><a href="[^"]+">([^<]+)</a>', text)
    # the table of the source: M_N rises with the size, 1FT5 108 is the largest and 1FT5 062 the smallest
    assert (models[0][:8], models[-1][:8], len(models)) == ("1FT5 108", "1FT5 062", 10)


def test_an_example_opens_as_an_ordinary_axis(client: "TestClient") -> None:
    text = client.get("/examples/lachman-ball-screw-axis").text
    link = re.search(r'href="(/workbench/ball_screw\?[^"]+)"', text)
    assert link is not None
    workbench = client.get(link[1].replace("&amp;", "&")).text
    assert re.search(r'data-headline="total_stiffness".*?423\.6', workbench, re.S)


def test_the_report_is_a_pdf_and_the_same_every_time(client: "TestClient") -> None:
    file = json.loads((PROJECT_ROOT / "examples" / "tr-conveyor-two-stage.json").read_text(encoding="utf-8"))
    request = next(iter(file["requests"].values()))
    first, second = (client.post("/api/v1/reports", json=request) for _ in range(2))
    assert first.headers["content-type"] == "application/pdf"
    assert first.content[:5] == b"%PDF-"
    assert first.content == second.content
    refused = client.post("/api/v1/reports", json={**request, "mechanism": {"kind": "belt_conveyor"}})
    assert refused.status_code == 422
