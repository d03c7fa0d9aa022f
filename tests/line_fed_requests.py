"""Requests for drives with induction motors whose numbers are easily calculated by hand; tests change parts of them."""

import copy
import json
from pathlib import Path
from typing import Any

import pytest

from app.engine.sheet import Check
from app.services.catalogue import CatalogueCache
from app.services.errors import InvalidInputError
from app.services.sizing import Sizing, SizingService

EXAMPLES = Path(__file__).resolve().parent.parent / "examples"
WINDING: dict[str, Any] = {
    "poles": 4,
    "rated_power_kw": 1.5,
    "rated_speed_rpm": "150 rad/s",
    "run_up_torque_ratio": 2,
    "no_load_starting_frequency_1_h": 1000,
}
"""10 N m at 150 rad/s of 157.08 rad/s, run-up torque 20 N m."""

MOTOR: dict[str, Any] = {
    "own": {"rotor_inertia_kgm2": 0.01, "rotor_inertia_with_brake_kgm2": 0.01, "windings": [WINDING]}
}
GEAR: dict[str, Any] = {"own": {"ratio": 10, "efficiency": 0.8}}
BRAKE: dict[str, Any] = {"own": {"torque_nm": 10, "application_time_dc_ms": 20}}

TABLE: dict[str, Any] = {
    "mechanism": {
        "kind": "rotary_load",
        "bodies": [{"shape": "point", "mass_kg": 4, "radius_mm": 1000}],
        "friction_torque_nm": 40,
    },
    "motion": {"kind": "rotations", "speed_rpm": "15 rad/s", "runs": [{"duration_s": 10}], "pause_s": 10},
    "drive": {
        "kind": "mains",
        "motor": MOTOR,
        "gear_unit": GEAR,
        "brake": BRAKE,
        "service_factor": 1.3,
        "starting_factors": [{"state": "unladen_forward", "factor": 0.7}],
    },
}
"""A table of 4 kg m2 with 40 N m of friction behind i = 10: on the motor shaft 0.04 kg m2 and 4 N m, without losses."""

HOIST: dict[str, Any] = {
    "mechanism": {"kind": "hoist", "cage_mass_kg": 100, "drum_diameter_mm": 200, "efficiency": 1},
    "motion": {
        "kind": "trips",
        "speed_m_s": 1.5,
        "pause_s": 5,
        "runs": [{"distance_m": 6}, {"distance_m": 6, "direction": "backward"}],
    },
    "environment": {"gravity_m_s2": 10},
    "drive": {
        "kind": "mains",
        "motor": MOTOR,
        "gear_unit": GEAR,
        "brake": BRAKE,
        "service_factor": 1.3,
        "starting_factors": [
            {"state": "unladen_lifting", "factor": 0.5},
            {"state": "unladen_lowering", "factor": 0.5},
        ],
    },
}
"""1000 N on a radius of 0.1 m behind i = 10: 10 N m and 0.01 kg m2 on the motor shaft, without losses."""

INDEXING: dict[str, Any] = {
    "mechanism": TABLE["mechanism"],
    "motion": {
        "kind": "turns",
        "moves": [
            {"distance_deg": f"{way} rad", "speed_rpm": "15 rad/s", "acceleration_rad_s2": 15, "dwell_s": 4,
             "hold": "brake"}
            for way in (45, -45)
        ],
    },
    "drive": {"kind": "inverter_fed", "motor": MOTOR, "gear_unit": GEAR, "service_factor": 1.3},
}  # fmt: skip
"""The table there and back: 1 s to 15 rad/s, 2 s at this speed, 1 s down, 4 s of standstill with closed brake."""


def example(name: str, which: str = "main") -> dict[str, Any]:
    """A request of a worked example."""
    found: dict[str, Any] = json.loads((EXAMPLES / f"{name}.json").read_text(encoding="utf-8"))["requests"][which]
    return found


def request(base: dict[str, Any], **parts: dict[str, Any]) -> dict[str, Any]:
    """A copy of a request in which values of its parts are replaced; ``None`` takes a value away."""
    made = copy.deepcopy(base)
    for part, values in parts.items():
        made[part] = {name: value for name, value in {**made.get(part, {}), **values}.items() if value is not None}
    return made


def motor(*windings: dict[str, Any], **values: Any) -> dict[str, Any]:
    """The motor with other values; each winding is the usual one with some of them replaced."""
    made = [{name: value for name, value in {**WINDING, **one}.items() if value is not None} for one in windings]
    own = {**MOTOR["own"], **values, **({"windings": made} if made else {})}
    return {"own": {name: value for name, value in own.items() if value is not None}}


def no_catalogue() -> CatalogueCache:
    """A catalogue that must not be asked."""

    def refuse() -> Any:
        raise AssertionError("this request needs no catalogue")

    return CatalogueCache(refuse)


def size(base: dict[str, Any], **parts: dict[str, Any]) -> Sizing:
    """Calculate such a request, changed as by ``request``, without any catalogue."""
    return SizingService(no_catalogue()).size(request(base, **parts))


def calculated(base: dict[str, Any], **parts: dict[str, Any]) -> tuple[Sizing, dict[str, Check]]:
    """The same with all checks by key."""
    sizing = size(base, **parts)
    return sizing, {check.key: check for check in sizing.sheet.checks}


def refused(base: dict[str, Any], **parts: dict[str, Any]) -> list[tuple[str, str]]:
    """Path and message of everything that is refused."""
    with pytest.raises(InvalidInputError) as caught:
        size(base, **parts)
    return [(error.name, error.message) for error in caught.value.errors]
