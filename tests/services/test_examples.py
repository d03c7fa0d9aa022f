"""Every number of every worked example, recomputed by the ordinary services on the shipped catalogue."""

import json
from pathlib import Path
from typing import Any

import pytest

from app.db.session import make_engine, session_factory
from app.services.catalogue import CatalogueCache
from app.services.errors import NotFoundError
from app.services.examples import DEMANDED, Example, ExampleService, examples_folder
from app.services.sizing import SizingService
from tests.sizing_requests import SCREW_AXIS

ROWS = {
    "cn-rack-and-pinion": 10,
    "cn-timing-belt-vertical-counterweight": 15,
    "jakab-ball-screw-optimum": 12,
    "jakab-timing-belt-optimum": 15,
    "lachman-ball-screw-axis": 44,
    "sew-02-motor-tables": 34,
    "sew-03-inverter-operation": 11,
    "sew-04-servo-flow": 1,
    "sew-05-variable-speed-gear": 12,
    "sew-06-gear-units": 8,
    "sew-07-formulas": 91,
    "sew-08-1-travel-drive-two-pole": 61,
    "sew-08-3-travel-drive-pole-changing": 45,
    "sew-08-4-flying-saw": 11,
    "sew-08-4-travel-drive-inverter": 41,
    "sew-09-1-hoist-pole-changing": 56,
    "sew-09-2-hoist-inverter": 48,
    "sew-10-chain-conveyor": 21,
    "sew-11-roller-conveyor": 29,
    "sew-12-turntable": 36,
    "sew-13-belt-conveyor": 26,
    "sew-14-crank-drive": 45,
    "sew-15-spindle-drive": 33,
    "sew-16-gantry-electronics": 39,
    "sew-16-gantry-hoist-axis": 47,
    "sew-16-gantry-travel-axis": 35,
    "tr-ball-screw": 11,
    "tr-conveyor-two-stage": 10,
    "tr-rotating-disc": 10,
}
"""How many numbers each truth table has: none may be dropped quietly."""


def service(folder: Path, database: str = "sqlite://") -> ExampleService:
    catalogue = CatalogueCache(session_factory(make_engine(database)))
    return ExampleService(SizingService(catalogue), folder)


@pytest.fixture(scope="module")
def examples(loaded_file: Path) -> dict[str, Example]:
    return {found.file.id: found for found in service(examples_folder(), f"sqlite:///{loaded_file}").run_all()}


def test_every_example_is_there_with_all_its_rows(examples: dict[str, Example]):
    assert {name: len(found.rows) for name, found in examples.items()} == ROWS


@pytest.mark.parametrize("name", ROWS)
def test_every_demanded_number_is_met(examples: dict[str, Example], name: str):
    missed = [
        f"{row.name}: computed {row.computed}, expected {row.expected} {row.unit} {row.reason}"
        for row in examples[name].rows
        if not row.met
    ]
    assert missed == []


def test_a_wider_tolerance_is_explained(examples: dict[str, Example]):
    wide = [row for found in examples.values() for row in found.rows if row.tolerance > 1e-3]
    assert [row.name for row in wide if not row.note] == []


def test_a_slip_of_the_source_is_explained(examples: dict[str, Example]):
    slips = [row for found in examples.values() for row in found.rows if row.status == "slip"]
    assert slips
    assert [row.name for row in slips if not row.note] == []


def example(**row: Any) -> dict[str, Any]:
    take = {"from": "step", "key": "motor_speed_max"}
    base = {"name": "top speed", "unit": "rpm", "printed": 3000, "exact": 3000, "status": "agrees", "take": take}
    return {"id": "own", "title": "t", "source": "s", "requests": {"main": SCREW_AXIS}, "rows": [{**base, **row}]}


def run(folder: Path, **row: Any) -> Any:
    (folder / "own.json").write_text(json.dumps(example(**row)), encoding="utf-8")
    (found,) = service(folder).run("own").rows
    return found


def test_a_number_is_compared_in_its_own_unit(tmp_path: Path):
    """0.5 m/s on a lead of 10 mm: 50 turns per second, 3000 rpm, 314.16 rad/s."""
    assert run(tmp_path).computed == pytest.approx(3000)
    found = run(tmp_path, unit="rad/s", exact=314.159265)
    assert (found.computed, found.produced) == (pytest.approx(314.159265), "ok")


@pytest.mark.parametrize(("exact", "produced"), [(3002.9, "ok"), (3003.1, "deviates"), (2990, "deviates")])
def test_agreement_is_a_thousandth(tmp_path: Path, exact: float, produced: str):
    found = run(tmp_path, exact=exact)
    assert found.produced == produced
    assert found.met == (produced == "ok")


def test_the_corrected_number_stands_before_the_exact_one(tmp_path: Path):
    found = run(tmp_path, exact=2000, correct=3000, status="slip")
    assert (found.expected, found.produced) == (3000, "ok")


@pytest.mark.parametrize(
    ("take", "value"),
    [
        ({"from": "input", "key": "mechanism.lead_mm"}, 10),
        ({"from": "input", "key": "motion.moves.1.distance_mm"}, -180),
        ({"from": "input", "key": "motion.moves.1.distance_mm", "factor": -1}, 180),
        ({"from": "check", "key": "speed", "side": "utilisation"}, 3000 / 3600),
    ],
)
def test_a_number_is_taken_from_where_the_row_says(tmp_path: Path, take: dict[str, Any], value: float):
    unit = "mm" if take["from"] == "input" else "1"
    assert run(tmp_path, take=take, unit=unit, exact=value).computed == pytest.approx(value)


@pytest.mark.parametrize(
    ("row", "reason"),
    [
        ({"take": {"from": "step", "key": "unheard_of"}}, "the result has no step 'unheard_of'"),
        ({"take": {"from": "input", "key": "motion.moves.9.distance_mm"}}, "the result has no input"),
        ({"take": {"request": "other", "from": "step", "key": "x"}}, "there is no such request"),
        ({"take": None}, "does not say where"),
        ({"take": None, "missing": "needs a chart"}, "needs a chart"),
    ],
)
def test_a_number_that_is_not_produced_is_missing_with_the_reason(tmp_path: Path, row: dict[str, Any], reason: str):
    found = run(tmp_path, **row)
    assert (found.produced, found.met) == ("missing", False)
    assert reason in found.reason
    assert run(tmp_path, **row, status="derived").met
    assert "derived" not in DEMANDED


def test_a_refused_request_makes_its_numbers_missing(tmp_path: Path):
    written = example()
    written["requests"] = {"main": {**SCREW_AXIS, "motion": {"kind": "moves", "moves": []}}}
    (tmp_path / "own.json").write_text(json.dumps(written), encoding="utf-8")
    (found,) = service(tmp_path).run("own").rows
    assert "motion.moves must have at least 1 entries" in found.reason


def test_an_unknown_example_is_told(tmp_path: Path):
    with pytest.raises(NotFoundError):
        service(tmp_path).run("nothing")
