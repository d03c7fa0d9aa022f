"""Several axes on one supply: currents, losses, DC link and resistor by hand; every refusal at its field."""

import copy
import math
from dataclasses import replace
from typing import Any

import pytest

from app.db.session import make_engine, session_factory
from app.engine.drives.own import OwnGearUnit
from app.engine.sheet import Verdict
from app.services.catalogue import CatalogueCache
from app.services.errors import InvalidInputError
from app.services.multi_axis import MultiAxis, MultiAxisService
from app.services.sizing import SizingService
from tests.line_fed_requests import GEAR, INDEXING, MOTOR, TABLE, example, no_catalogue

SERVO: dict[str, Any] = {
    "kind": "servo",
    "motor": {
        "own": {
            "rated_speed_rpm": 3000,
            "max_speed_rpm": 4000,
            "stall_torque_nm": 10,
            "rated_torque_nm": 8,
            "peak_torque_nm": 30,
            "rotor_inertia_kgcm2": 10,
            "torque_constant_nm_a": 2,
        }
    },
    "gear_unit": {"own": {"ratio": 10, "efficiency": 0.8, "inertia_kgcm2": 0}},
}
"""0.001 kg m2 and 2 N m/A."""
AXIS: dict[str, Any] = {
    "mechanism": INDEXING["mechanism"],
    "motion": {"kind": "turns", "moves": INDEXING["motion"]["moves"][:1]},
    "drive": SERVO,
}
"""One index in 8 s. Motor: 12.65 N m for 1 s, 5 N m for 2 s, -1.75 N m for 1 s, 4 s of rest; up to 150 rad/s."""


def axis(**values: Any) -> dict[str, Any]:
    """One axis on the supply; ``drive`` replaces its drive, ``dwell`` its standstill [s]."""
    sizing = copy.deepcopy(AXIS)
    sizing.update({name: copy.deepcopy(values.pop(name)) for name in ("drive", "name") if name in values})
    if "dwell" in values:
        sizing["motion"]["moves"][0]["dwell_s"] = values.pop("dwell")
    return {"sizing": sizing, **values}


def without(part: str, name: str) -> dict[str, Any]:
    """The drive without one value of its motor or gear unit."""
    drive = copy.deepcopy(SERVO)
    del drive[part]["own"][name]
    return drive


def run(*axes: dict[str, Any], **supply: Any) -> MultiAxis:
    return MultiAxisService(SizingService(no_catalogue())).size({"axes": list(axes), "supply": supply})


def refusals(raw: Any) -> list[tuple[str, str, Any]]:
    with pytest.raises(InvalidInputError) as caught:
        MultiAxisService(SizingService(no_catalogue())).size(raw)
    return [(error.name, error.message, error.value) for error in caught.value.errors]


def checks(of: MultiAxis) -> dict[str, Any]:
    return {check.key: check for check in of.sheet.checks}


# --- numbers ----------------------------------------------------------------------------------------------------------


def test_currents_of_all_axes_add_up():
    """12.65 N m / 2 N m/A peak and (12.65 + 2 * 5 + 1.75) / 8 N m / 2 N m/A mean, of two axes: 12.65 A and 3.05 A."""
    module = {"rated_current_a": 4, "peak_factor": 1.5}
    found = run(axis(module=module), axis(), supply_current_a=6)
    of = checks(found)
    assert of["supply_peak_current"].demanded == pytest.approx(12.65)
    assert (of["supply_peak_current"].permitted, of["supply_peak_current"].verdict) == (12, Verdict.FAILS)
    assert of["supply_mean_current"].demanded == pytest.approx(3.05)
    assert of["supply_mean_current"].permitted == 6
    assert (of["axis_1_peak_current"].demanded, of["axis_1_peak_current"].permitted) == (pytest.approx(6.325), 6)
    assert of["axis_1_mean_current"].demanded == pytest.approx(1.525)
    assert "axis_2_peak_current" not in of
    assert found.verdict == Verdict.FAILS


def test_power_in_the_dc_link():
    """Each takes 1897.5 W at most and 948.75 + 1500 J in 8 s; the second starts when the first stands still."""
    found = run(axis(), axis(start_s=4))
    assert found.sheet.value("supply_peak_power") == pytest.approx(2 * 12.65 * 150)
    assert found.sheet.value("mean_motoring_power") == pytest.approx(2 * 2448.75 / 8)
    assert found.sheet.value("net_peak_power") == pytest.approx(12.65 * 150, rel=1e-5)
    assert found.sheet.value("worst_peak_power") == pytest.approx(2 * 12.65 * 150, rel=1e-5)
    (diagram,) = found.diagrams
    assert [one.name for one in diagram.series] == ["axis 1", "axis 2", "all axes"]


@pytest.mark.parametrize(("start", "time"), [(0.0, 1.0), (0.5, 1.5), (4.0, 2.0)])
def test_axes_that_brake_together_load_the_resistor_harder(start: float, time: float):
    """1.75 N m from 150 rad/s: 131.25 J each, up to 262.5 W; the time of braking depends on the phase."""
    ratings = [{"duty_percent": 12, "power_kw": 0.3}, {"duty_percent": 25, "power_kw": 0.2},
               {"duty_percent": 100, "power_kw": 0.1}]  # fmt: skip
    found = run(axis(), axis(start_s=start), braking_resistor={"own": {"ratings": ratings}}, chopper_limit_kw=0.5)
    assert found.sheet.value("braking_energy_of_cycle") == pytest.approx(262.5)
    assert found.sheet.value("braking_time") == pytest.approx(time)
    of = checks(found)
    assert of["resistor_mean_power"].demanded == pytest.approx(262.5 / time)
    assert of["resistor_mean_power"].permitted == pytest.approx(200)  # 12.5 %, 18.75 % and 25 %
    assert of["chopper_power"].demanded == pytest.approx(525)
    assert of["chopper_power"].verdict == Verdict.FAILS


def test_what_one_axis_takes_does_not_reach_the_resistor():
    """3 s later: -262.5 W rising by 2160 W in 1 s while the first brakes, 15.95 J left; the second one's 131.25 J."""
    ratings = [{"duty_percent": 100, "power_kw": 0.5}]
    found = run(axis(), axis(start_s=3), exchange="shared", braking_resistor={"own": {"ratings": ratings}})
    left = 262.5**2 / 2 / 2160
    assert found.sheet.value("net_braking_energy") == pytest.approx(left + 131.25, rel=1e-5)
    mean = (left + 131.25) / (262.5 / 2160 + 1)
    assert checks(found)["resistor_mean_power"].demanded == pytest.approx(mean, rel=1e-5)
    assert checks(found)["resistor_peak_power"].demanded == pytest.approx(262.5, rel=1e-5)


def test_the_heat_sink_bears_the_losses_of_all_modules():
    """M_eff sqrt((12.65^2 + 50 + 1.75^2) / 8) = 5.161 N m or 2.580 A: 14 W/A each and 2 W/A of both for the supply,
    half of 12 W + 2 * 13 W: 101.58 W * 0.4 K/W below 80 degrees: 39.37 degrees are permitted, 40 are there."""
    found = run(axis(), axis(), thermal_resistance_k_w=0.4)
    current = math.sqrt((12.65**2 + 50 + 1.75**2) / 8) / 2
    losses = 2 * 14 * current + 2 * 2 * current + 19
    assert found.sheet.value("heat_sink_losses") == pytest.approx(losses)
    check = checks(found)["ambient_temperature"]
    assert check.permitted == pytest.approx(353.15 - 0.4 * losses)
    assert (check.demanded, check.verdict) == (pytest.approx(313.15), Verdict.FAILS)
    assert "ambient_temperature" not in checks(run(axis(), axis()))


def test_a_shorter_cycle_is_repeated():
    """8 s and 16 s: the first takes its 2448.75 J twice in 16 s."""
    found = run(axis(), axis(dwell=12))
    assert found.sheet.value("mean_motoring_power") == pytest.approx(3 * 2448.75 / 16)
    assert found.sheet.value("braking_energy_of_cycle") == pytest.approx(3 * 131.25)


def test_the_headlines_are_those_of_the_sheet():
    found = run(axis(name="X"), axis(), thermal_resistance_k_w=0.4)
    keys = [headline.key for headline in found.headlines]
    assert keys[0] == "supply_peak_current"
    assert {"supply_peak_power", "mean_braking_power", "permitted_ambient"} <= set(keys)
    assert all(headline.value == found.sheet.value(headline.key) for headline in found.headlines)
    assert [sizing.asked.name for sizing in found.sizings] == ["X", ""]
    assert found.diagrams[0].series[0].name == "X"


def test_defaults_of_the_supply_are_assumptions():
    keys = {assumption.key for assumption in run(axis()).sheet.assumptions}
    assert {"supply.supply_peak_factor", "supply.axis_losses_w_a", "supply.exchange"} <= keys
    assert "supply.exchange" not in {one.key for one in run(axis(), exchange="none").sheet.assumptions}


def test_an_unknown_supply_current_is_not_checked():
    of = checks(run(axis()))
    assert of["supply_peak_current"].verdict == Verdict.NOT_CHECKED
    assert of["supply_mean_current"].missing == "rated current of the supply module"


def test_the_gantry_of_the_handbook():
    """SEW 2001, 16.5: hoist and travel axis on one supply; every number stands in the worked example."""
    found = MultiAxisService(SizingService(no_catalogue())).size(example("sew-16-gantry-electronics"))
    assert [sizing.asked.name for sizing in found.sizings] == ["Hoist", "Travel"]
    assert found.sheet.value("worst_peak_power") >= found.sheet.value("net_peak_power") * (1 - 1e-5)


# --- refusals ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("raw", "name", "message"),
    [
        (None, "", "must be an object with named values"),
        ({}, "axes", "is missing"),
        ({"axes": []}, "axes", "must have at least 1 entries"),
        ({"axes": [axis()] * 21}, "axes", "must have at most 20 entries"),
        ({"axes": {"first": axis()}}, "axes", "must be a list"),
        ({"axes": ["X"]}, "axes.0", "must be an object with named values"),
        ({"axes": [axis()], "suply": {}}, "suply", "is not known here; did you mean supply?"),
        ({"axes": [axis(), axis(start=1)]}, "axes.1.start", "is not known here; did you mean start_s?"),
        ({"axes": [axis(), axis(start_s=-1)]}, "axes.1.start_s", "must be at least 0 s"),
        ({"axes": [axis(), {"start_s": 1}]}, "axes.1.sizing", "is missing"),
        ({"axes": [axis(module={})]}, "axes.0.module.rated_current_a", "is missing: give rated current"),
        ({"axes": [axis()], "supply": {"supply_current_a": 0}}, "supply.supply_current_a", "must be greater than 0 A"),
        ({"axes": [axis()], "supply": {"exchange": "all"}}, "supply.exchange", "must be 'none' or 'shared'"),
        ({"axes": [axis()], "supply": {"braking_resistor": {}}}, "supply.braking_resistor", 'give either "id"'),
    ],
)  # fmt: skip
def test_what_cannot_be_read_is_refused_at_its_place(raw: Any, name: str, message: str):
    ((found, told, _),) = refusals(raw)
    assert found == name
    assert told.startswith(message)


def test_a_value_deep_in_an_axis_is_refused_there():
    bad = axis()
    bad["sizing"]["motion"]["moves"][0]["speed_rpm"] = -5
    ((name, _, value),) = refusals({"axes": [axis(), bad]})
    assert (name, value) == ("axes.1.sizing.motion.moves.0.speed_rpm", -5)


def test_what_the_engine_refuses_in_an_axis_stands_there():
    """45 rad with 15 rad/s and 15 rad/s2 take 4 s."""
    bad = axis()
    bad["sizing"]["motion"]["moves"][0]["time_s"] = 0.1
    ((name, message, value),) = refusals({"axes": [axis(), bad]})
    assert (name, value) == ("axes.1.sizing.motion.moves.0.time_s", 0.1)
    assert "not 0.1 s" in message


@pytest.mark.parametrize(
    ("drive", "name", "word"),
    [
        (TABLE["drive"], "axes.1.sizing.drive.kind", "servo"),
        ({"kind": "inverter_fed", "motor": MOTOR, "gear_unit": GEAR, "service_factor": 1.3},
         "axes.1.sizing.drive.kind", "servo"),
        ({"kind": "servo"}, "axes.1.sizing.drive.motor", "motor"),
        (without("motor", "torque_constant_nm_a"), "axes.1.sizing.drive.motor", "torque constant"),
        (without("motor", "rotor_inertia_kgcm2"), "axes.1.sizing.drive.motor", "rotor inertia"),
    ],
)  # fmt: skip
def test_a_drive_without_known_currents_is_refused(drive: dict[str, Any], name: str, word: str):
    bad = axis(drive=drive)
    if drive["kind"] == "mains":
        bad["sizing"]["motion"] = TABLE["motion"]
    ((found, message, _),) = refusals({"axes": [axis(), bad]})
    assert found == name
    assert word in message
    assert "inverter" not in message  # no kind may be named that is refused as well


def test_a_gear_unit_without_inertia_is_refused_there(monkeypatch: pytest.MonkeyPatch):
    """As the catalogue has them; a typed one has no such gap."""
    typed = OwnGearUnit.product
    monkeypatch.setattr(OwnGearUnit, "product", lambda own: replace(typed(own), inertia=None))
    ((name, message, _),) = refusals({"axes": [axis()]})
    assert name == "axes.0.sizing.drive.gear_unit"
    assert "inertia" in message


@pytest.mark.parametrize("dwell", [5.0, 8.0, 4.01])
def test_cycles_that_never_meet_are_refused(dwell: float):
    """8 s, and 9 s, 12 s or 8.01 s."""
    ((name, message, _),) = refusals({"axes": [axis(name="X"), axis(name="Y", dwell=dwell)]})
    assert name == "axes"
    assert "X: 8 s" in message
    assert f"Y: {4 + dwell:.4g} s" in message


@pytest.mark.parametrize(
    ("change", "name"),
    [
        ({"supply": {"braking_resistor": {"id": "no-such-resistor"}}}, "supply.braking_resistor.id"),
        ({"axes": [axis(), axis(drive={"kind": "servo", "motor": {"id": "no-such-motor"}})]},
         "axes.1.sizing.drive.motor.id"),
    ],
)  # fmt: skip
def test_a_product_that_is_not_in_the_catalogue(empty_database: str, change: dict[str, Any], name: str):
    engine = make_engine(empty_database)
    service = MultiAxisService(SizingService(CatalogueCache(session_factory(engine))))
    try:
        with pytest.raises(InvalidInputError) as caught:
            service.size({"axes": [axis()], **change})
    finally:
        engine.dispose()
    (error,) = caught.value.errors
    assert error.name == name
    assert "of the catalogue that is loaded" in error.message
    assert str(error.value).startswith("no-such")
