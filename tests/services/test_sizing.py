"""Sizing an axis as a use case: verdict, parts, assumptions, and refusals with the path of the whole request."""

import copy
from typing import Any

import pytest

from app.engine.sheet import Verdict
from app.services.catalogue import CatalogueCache
from app.services.errors import InvalidInputError
from app.services.sizing import Sizing, SizingService
from tests.sizing_requests import SCREW_AXIS


def no_catalogue() -> CatalogueCache:
    """A catalogue that must not be asked."""

    def refuse() -> Any:
        raise AssertionError("this request needs no catalogue")

    return CatalogueCache(refuse)


def size(**changes: Any) -> Sizing:
    """The plainly right request with parts of it replaced."""
    return SizingService(no_catalogue()).size({**SCREW_AXIS, **changes})


def with_motor(**changes: Any) -> dict[str, Any]:
    drive = copy.deepcopy(SCREW_AXIS["drive"])
    drive["motor"]["own"].update(changes)
    return drive


def refused(**changes: Any) -> list[tuple[str, str]]:
    with pytest.raises(InvalidInputError) as caught:
        size(**changes)
    return [(error.name, error.message) for error in caught.value.errors]


def test_the_verdict_is_that_of_the_check_used_most():
    """3000 rpm of 0.9 * 4000 rpm is 83 %: tight. At 0.9 * 3000 rpm it is 111 %: fails. At 0.9 * 5000 rpm: 67 %."""
    for rated, verdict in ((4000, Verdict.TIGHT), (3000, Verdict.FAILS), (5000, Verdict.OK)):
        sizing = size(drive=with_motor(rated_speed_rpm=rated, max_speed_rpm=6000))
        assert sizing.verdict == verdict
        deciding = sizing.deciding_check
        assert deciding is not None
        assert deciding.key == "speed"
        assert deciding.utilisation == pytest.approx(3000 / (0.9 * rated))


def test_missing_data_are_counted_not_guessed():
    full, lacking = size(), size(drive=with_motor(peak_torque_nm=None))
    more = lacking.counts[Verdict.NOT_CHECKED] - full.counts[Verdict.NOT_CHECKED]
    assert more == 1
    (check,) = (check for check in lacking.sheet.checks if check.key == "peak_torque")
    assert (check.verdict, bool(check.missing)) == (Verdict.NOT_CHECKED, True)


def test_headlines_are_steps_of_the_sheet():
    sizing = size()
    keys = [headline.key for headline in sizing.headlines]
    assert len(keys) == len(set(keys))
    assert {"motor_speed_max", "peak_torque", "effective_torque"} <= set(keys)
    assert all(headline.value == sizing.sheet.value(headline.key) for headline in sizing.headlines)


def test_the_request_is_kept_as_it_was_typed():
    mechanism = {**SCREW_AXIS["mechanism"], "lead_mm": "10,000"}
    sizing = size(mechanism=mechanism)
    assert sizing.typed.raw["mechanism"] == mechanism
    assert sizing.headlines == size().headlines


def test_what_the_engine_refuses_stands_at_its_place_in_the_whole_request():
    ((name, message),) = refused(motion={"kind": "moves", "moves": [{"distance_mm": 180, "time_s": 0.5}]})
    assert name.startswith("motion.moves.0")
    assert message


def test_a_table_of_the_wrong_kind_is_refused_when_it_is_solved():
    text = "time [s];speed [rpm]\n0;0\n1;100\n2;0\n"
    ((name, message),) = refused(motion={"kind": "csv", "text": text})
    assert name == "motion.kind"
    assert "needs a linear motion" in message


def test_the_optimum_is_found_for_the_chosen_motor():
    """With more torque to accelerate, the best lead stays (no load force): J and m alone decide (Jakab)."""
    small, large = (size(optimum={"accelerating_torque_nm": torque}).optimum for torque in (10, 20))
    assert small is not None
    assert large is not None
    assert small.ratio == pytest.approx(large.ratio)


def test_defaults_are_assumptions_with_their_path_until_confirmed():
    keys = {assumption.key for assumption in size().sheet.assumptions}
    assert {"environment.gravity_m_s2", "drive.inertia_ratio_limit", "mechanism.efficiency"} <= keys
    confirmed = {a.key for a in size(environment={"gravity_m_s2": 9.81}).sheet.assumptions}
    assert keys - confirmed == {"environment.gravity_m_s2"}


def test_the_same_request_gives_the_same_bytes():
    from app.services.results import sizing_json

    assert sizing_json(size()) == sizing_json(size())


def test_a_torque_that_keeps_changing_is_no_load_for_a_line_fed_motor():
    crank = {"kind": "crank", "crank_radius_mm": 100, "rod_length_mm": 500, "load_mass_kg": 20}
    turning = {"kind": "rotations", "speed_rpm": 40, "runs": [{"duration_s": 3}]}
    ((name, message),) = refused(mechanism=crank, motion=turning, drive={"kind": "mains"})
    assert name == "drive.kind"
    assert "crank drive keeps changing" in message
