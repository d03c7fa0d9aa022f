"""Entries of an axis for the tests with the keyboard: picked by hand, or found from the declarations."""

import json
import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any, get_args

import httpx
import pytest
from pydantic import BaseModel, ValidationError

from app.engine.mechanisms import mechanisms
from app.engine.mechanisms.base import Mechanism
from app.engine.mechanisms.bodies import AnyBody
from app.engine.quantity import Option, Quantity, declaration
from app.web.form_data import flat
from app.web.form_models import border, model_of, row_of, tag_of, union_members

MOTIONS: dict[str, dict[str, Any]] = {
    "linear": {
        "kind": "moves",
        "moves": [{"distance_mm": "1 m", "speed_m_s": "1", "acceleration_m_s2": "2", "dwell_s": "2"}],
    },
    "rotary": {
        "kind": "turns",
        "moves": [{"distance_deg": "10 rad", "speed_rpm": "10 rad/s", "acceleration_rad_s2": "20", "dwell_s": "1"}],
    },
}
"""A move is determined by any of its values, so none of them is declared as needed."""

SHAPES = union_members(get_args(AnyBody)[0])
BODIES: dict[str, dict[str, str]] = {
    "cylinder": {"mass_kg": "8", "diameter_mm": "100"},
    "hollow_cylinder": {"mass_kg": "6,4", "diameter_mm": "100", "inner_diameter_mm": "50"},
    "cuboid": {"mass_kg": "12", "width_mm": "60", "length_mm": "80"},
    "upright_disc": {"mass_kg": "16", "diameter_mm": "100"},
    "sphere": {"mass_kg": "10", "diameter_mm": "100"},
    "spherical_shell": {"mass_kg": "6", "diameter_mm": "100"},
    "rod": {"mass_kg": "12", "length_mm": "100"},
    "point": {"mass_kg": "4", "radius_mm": "50"},
    "given": {"inertia_kgm2": "0.01"},
}
"""0.01 kg m2 each: m D^2 over 8, 16, 10 and 6; m (D^2 + D_i^2) / 8; m (b^2 + l^2) / 12; m l^2 / 12; m r^2."""


@dataclass(frozen=True)
class Case:
    """What is typed for one mechanism, and what must be seen then."""

    mechanism: dict[str, Any]
    headlines: dict[str, str]
    """Numbers known by hand."""
    motion: dict[str, Any] | None = None
    drive: dict[str, Any] | None = None
    diagrams: dict[str, tuple[str, str]] = field(default_factory=dict)
    """What runs along and what up in the charts of the mechanism itself."""


TURNING = {"kind": "constant_rotation", "speed_rpm": "10 rad/s"}
SPEED = ("Speed", "Torque")

# 10 rad/s are 95.493 rpm: 1 m/s on a radius of 100 mm
CASES: dict[str, Case] = {
    # 1 m/s of 10 mm for each turn
    "ball_screw": Case(
        {"slide_mass_kg": "100", "nominal_diameter_mm": "40", "lead_mm": "10", "length_mm": "1 m"},
        {"motor_speed_max": "6000 rpm"},
    ),
    # 100 kg * (0.1 m)^2
    "belt_conveyor": Case(
        {"load_mass_kg": "100", "friction_coefficient": "0,3", "drum_diameter_mm": "200"},
        {"drum_speed": "95.493 rpm", "load_inertia_at_drum": "10000 kg·cm²"},
    ),
    "chain_conveyor": Case(
        {"chain_mass_kg": "100", "sprocket_diameter_mm": "200"},
        {"sprocket_speed": "95.493 rpm", "load_inertia_at_sprocket": "10000 kg·cm²"},
    ),
    # 1 m/s at the pin; 1 m/s * sqrt(1 + 0.2^2) where crank and rod stand at a right angle, hardly less than the most
    "crank": Case(
        {"crank_radius_mm": "100", "rod_length_mm": "500", "load_mass_kg": "50"},
        {"motor_speed_max": "95.493 rpm", "largest_slide_speed": "1.0198 m/s"},
        motion=TURNING,
        diagrams={"crank-torque": ("Angle", "Torque"), "crank-speed": ("Angle", "Speed")},
    ),
    # examples/sew-13-belt-conveyor.json: static power 3353.632 W; 0.6 m/s / 0.1575 m = 3.8095 rad/s
    "din_belt_conveyor": Case(
        {"mass_flow_t_h": "650", "belt_speed_m_s": "0,6", "length_m": "30", "belt_mass_per_length_kg_m": "20",
         "idler_mass_kg": "500", "drum_diameter_mm": "315"},
        {"conveying_power": "3353.6 W", "drum_speed": "36.378 rpm"},
        motion={"kind": "constant", "speed_m_s": "0.6"},
    ),
    # 5 m3/s * 1200 Pa / 0.75 = 8 kW over 104.72 rad/s
    "fan": Case(
        {"rated_speed_rpm": "1000", "volume_flow_m3_h": "18000", "pressure_pa": "1200", "fan_efficiency": "0,75",
         "rotor_inertia_kgm2": "8"},
        {"rated_load_torque": "76.394 N·m", "motor_speed_max": "1000 rpm"},
        motion={"kind": "constant_rotation", "speed_rpm": "1000"},
        diagrams={"machine-torque": SPEED},
    ),
    "hoist": Case(
        {"cage_mass_kg": "100", "drum_diameter_mm": "200"},
        {"drum_speed": "95.493 rpm", "load_inertia_at_drum": "10000 kg·cm²"},
    ),
    # 7848 W over 151.84 rad/s; at half the speed, 725 rpm, a quarter of that torque
    "pump": Case(
        {"rated_speed_rpm": "1450", "rated_power_kw": "7848 W", "rotor_inertia_kgm2": "0.05"},
        {"rated_load_torque": "51.685 N·m", "effective_torque": "12.921 N·m"},
        motion={"kind": "constant_rotation", "speed_rpm": "725"},
        diagrams={"machine-torque": SPEED},
    ),
    # 4 mm * 20 = 80 mm: 25 rad/s, 100 kg * (40 mm)^2
    "rack_pinion": Case(
        {"slide_mass_kg": "100", "module_mm": "4", "teeth": "20"},
        {"pinion_speed": "238.73 rpm", "load_inertia_at_pinion": "1600 kg·cm²"},
    ),
    "roller_conveyor": Case(
        {"roller_diameter_mm": "200", "roller_length_mm": "1000", "rollers": "20", "journal_diameter_mm": "20"},
        {"roller_speed": "95.493 rpm"},
        motion={"kind": "constant", "speed_m_s": "1", "payload_kg": "500"},
    ),
    # 80 kg * (1 m)^2 / 8 and the further body of 0.01 kg m2, at 20 rad/s2
    "rotary_load": Case(
        {"bodies": [{"shape": "cylinder", "mass_kg": "80", "diameter_mm": "1000"}]},
        {"motor_speed_max": "95.493 rpm", "peak_torque": "200.2 N·m"},
    ),
    "timing_belt": Case(
        {"slide_mass_kg": "100", "pulley_diameter_mm": "200"},
        {"pulley_speed": "95.493 rpm", "load_inertia_at_pulley": "10000 kg·cm²"},
    ),
    # 1500 kg * (125 mm)^2
    "travel_drive": Case(
        {"vehicle_mass_kg": "1500", "wheel_diameter_mm": "250", "journal_diameter_mm": "60"},
        {"wheel_speed": "76.394 rpm", "load_inertia_at_wheel": "234375 kg·cm²"},
    ),
    # 300 N * 5 m/s; sqrt((0.1 m)^2 + 4 * 0.1 mm * 100 m / pi)
    "winder": Case(
        {"core_diameter_mm": "100", "full_diameter_mm": "1 m", "tension_n": "300", "thickness_mm": "0,1",
         "width_mm": "1200", "density_kg_m3": "900"},
        {"web_power": "1500 W", "largest_diameter": "150.77 mm"},
        motion={"kind": "moves",
                "moves": [{"distance_mm": "100 m", "speed_m_s": "5", "acceleration_m_s2": "0,5", "dwell_s": "1"}]},
        diagrams={"reel-torque": ("Diameter", "Torque"), "reel-speed": ("Diameter", "Speed")},
    ),
}  # fmt: skip


# --- out of the declarations ------------------------------------------------------------------------------------------


def plausible(info: Any) -> Any:
    """A value of one field as it is typed: lengths of some 100 mm, masses of some 10 kg, the first of several words."""
    found, row = declaration(info), row_of(info)
    if row is not None:
        members = union_members(row)
        model = next(iter(members.values())) if members else model_of(row)
        assert model is not None
        tag = {tag_of(members): next(iter(members))} if members else {}
        return [tag | needed(model)]
    if isinstance(found, Quantity):
        return f"{found.from_si(_size(found)):.3g}"
    assert isinstance(found, Option), info
    if found.labels:
        return str(next(iter(found.labels)))
    if found.ge is not None:
        return str(min(found.ge + 17, found.le or found.ge + 17))
    return "true" if "bool" in str(info.annotation) else "1"


def _size(found: Quantity) -> float:
    low = next((bound for bound in (found.gt, found.ge) if bound is not None), 0.0)
    high = next((bound for bound in (found.lt, found.le) if bound is not None), 1e3)
    if low > 0 or high <= 1:
        return (max(low, 0.0) + min(high, 4 * low or high)) / 2
    return float(10 ** (0.45 * math.log10(high) - 1))


def needed(model: type[BaseModel]) -> dict[str, Any]:
    """A value of everything that a model must have."""
    fields = model.model_fields.items()
    return {border(name, info): plausible(info) for name, info in fields if info.is_required()}


def found_values(kind: str, server: str) -> dict[str, Any]:
    """Values of a mechanism that are accepted: what is refused as missing is given, what does not fit is changed."""
    model = mechanisms()[kind]
    infos = {border(name, info): info for name, info in model.model_fields.items()}
    values = needed(model)
    place, words = "", ""
    for attempt in range(12):
        place, words = _refusal(model, values, server)
        if not words:
            return values
        if place not in infos:
            break
        if place not in values:
            values[place] = plausible(infos[place])
        elif isinstance(declaration(infos[place]), Quantity):
            values[place] = f"{float(values[place]) * (8 if attempt % 2 else 0.25):.3g}"
    pytest.fail(f"{kind} needs a case in tests/web/browser/entries.py: {place} {words}", pytrace=False)


def _refusal(model: type[Mechanism], values: dict[str, Any], server: str) -> tuple[str, str]:
    """The first entry that is refused, and why; empty texts where a sizing comes out."""
    try:
        model.model_validate(values)
    except ValidationError as error:
        first = error.errors()[0]
        return str(first["loc"][0]), first["msg"]
    kind = model.model_fields["kind"].default
    answer = post(server, "sizings", {"mechanism": {"kind": kind, **values}, "motion": MOTIONS[model.motion_kind]})
    if answer.status_code == 200:
        return "", ""
    first = answer.json()["errors"][0]
    return first["name"].removeprefix("mechanism."), first["message"]


# --- requests ---------------------------------------------------------------------------------------------------------


def post(server: str, what: str, request: dict[str, Any]) -> httpx.Response:
    """What REST answers to a request."""
    return httpx.post(f"{server}/api/v1/{what}", json=request, timeout=30)


def request_of(kind: str, case: Case, shape: str) -> dict[str, Any]:
    """The axis of a case with one further body on the shaft of its drive."""
    body = {"shape": shape, **BODIES[shape]}
    motion = case.motion or MOTIONS[mechanisms()[kind].motion_kind]
    made = {"mechanism": {"kind": kind, **case.mechanism, "further_bodies": [body]}, "motion": motion}
    return made if case.drive is None else {**made, "drive": case.drive}


def typed(request: dict[str, Any]) -> dict[str, str]:
    """Controls of the form and what is chosen or typed there."""
    return {name: text for name, text in _controls(json.loads(json.dumps(request))) if name != "mechanism.kind"}


def _controls(request: dict[str, Any]) -> Iterator[tuple[str, str]]:
    for name, text in flat(request):
        before, own, _ = name.partition(".own.")
        if own:
            yield f"{before}._choice", "own"
        if not name.endswith("._row"):
            yield name, text
