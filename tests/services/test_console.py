"""The commands ``size`` and ``examples``."""

import json
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner, Result

from app.cli import app
from app.services.documents import read_document
from tests.sizing_requests import SCREW_AXIS


def run(*arguments: str) -> Result:
    return CliRunner().invoke(app, list(arguments))


@pytest.fixture(autouse=True)
def _loaded(database: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DATABASE_URL", database)


def written(folder: Path, value: Any) -> str:
    path = folder / "axis.json"
    path.write_text(json.dumps(value), encoding="utf-8")
    return str(path)


def test_a_request_is_sized_with_its_checks(tmp_path: Path):
    result = run("size", written(tmp_path, SCREW_AXIS))
    assert result.exit_code == 0
    assert "tight        Motor speed: 3000 of 3600 rpm (83%)" in result.stdout
    assert result.stdout.startswith("X - Ball or lead screw axis")


def test_as_json_it_is_what_rest_answers(tmp_path: Path, client: Any):
    result = run("size", written(tmp_path, SCREW_AXIS), "--json")
    assert json.loads(result.stdout) == client.post("/api/v1/sizings", json=SCREW_AXIS).json()


def test_a_project_is_sized_axis_by_axis(tmp_path: Path):
    axes = [{"name": name, "request": {**SCREW_AXIS, "name": name}} for name in ("X", "Z")]
    path = written(tmp_path, read_document({"title": "Portal", "axes": axes}))
    assert [answer["request"]["name"] for answer in json.loads(run("size", path, "--json").stdout)] == ["X", "Z"]


def test_a_failing_check_gives_exit_code_1(tmp_path: Path):
    slow = {"own": {**SCREW_AXIS["drive"]["motor"]["own"], "rated_speed_rpm": 1000}}
    result = run("size", written(tmp_path, {**SCREW_AXIS, "drive": {"motor": slow}}))
    assert result.exit_code == 1
    assert "FAILS" in result.stdout


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (json.dumps({**SCREW_AXIS, "motion": {}}), "motion.kind: is missing"),
        ("{", "not valid JSON"),
        ("[]", "input: must be an object"),
    ],
)
def test_a_refused_file_gives_exit_code_2_and_the_place(tmp_path: Path, content: str, words: str):
    path = tmp_path / "axis.json"
    path.write_text(content, encoding="utf-8")
    result = run("size", str(path))
    assert (result.exit_code, result.stdout) == (2, "")
    assert words in result.stderr


def test_a_missing_file_gives_exit_code_2(tmp_path: Path):
    result = run("size", str(tmp_path / "none.json"))
    assert result.exit_code == 2
    assert "none.json" in result.stderr


def test_all_examples_are_met():
    """The missing rows are further results beside the handbook's, such as angles on a grid; nothing demanded is."""
    result = run("examples")
    assert result.exit_code == 0, result.stdout
    assert "0 deviates, 5 missing" in result.stdout


def test_examples_as_json_name_every_number(tmp_path: Path):
    found = json.loads(run("examples", "--json").stdout)
    rows = [row for example in found["examples"] for row in example["rows"]]
    assert found["totals"]["rows"] == len(rows) > 100
    assert found["totals"]["not_met"] == 0
    wanted = {"name", "expected", "printed", "computed", "deviation", "status", "produced", "reason"}
    assert all(wanted <= set(row) for row in rows)
