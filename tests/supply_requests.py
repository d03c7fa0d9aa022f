"""Two equal servo axes on one supply whose numbers are easily calculated by hand.

A pinion of 20 teeth, module 5 mm, has a radius of 50 mm. Of 96 kg it carries 96 * 0.05^2 = 0.24 kg m2, with the rotor's
0.01 kg m2 together 0.25 kg m2. 2 m/s2 are 40 rad/s2: 10 N m while starting and while braking, 0 between, since nothing
rubs. 1 m at 1 m/s takes 0.5 s + 0.5 s + 0.5 s of a cycle of 4 s:

- mean unsigned torque 10 N m * 1 s / 4 s = 2.5 N m; effective torque 10 N m * sqrt(1 / 4) = 5 N m
- with 2 N m/A: peak 5 A, mean 1.25 A, effective 2.5 A
- power up to 10 N m * 20 rad/s = 200 W, taken and returned: 200 W * 0.5 s / 2 = 50 J each
"""

import copy
from typing import Any

SERVO_AXIS: dict[str, Any] = {
    "mechanism": {
        "kind": "rack_pinion",
        "slide_mass_kg": 96,
        "friction_model": "normal_force",
        "friction_coefficient": 0,
        "module_mm": 5,
        "teeth": 20,
        "efficiency": 1,
    },
    "motion": {
        "kind": "moves",
        "moves": [{"distance_mm": 1000, "speed_m_s": 1, "acceleration_m_s2": 2, "label": "out"}],
        "cycle_time_s": 4,
    },
    "drive": {
        "kind": "servo",
        "brake": "no",
        "inertia_ratio_limit": 30,
        "motor": {
            "own": {
                "rated_speed_rpm": 3000,
                "max_speed_rpm": 3000,
                "stall_torque_nm": 8,
                "peak_torque_nm": 24,
                "rotor_inertia_kgcm2": 100,
                "stall_current_a": 4,
            }
        },
    },
}
"""One of the axes; 8 N m at 4 A are 2 N m/A."""

MAINS_AXIS: dict[str, Any] = {
    "mechanism": {"kind": "travel_drive", "vehicle_mass_kg": 1500, "wheel_diameter_mm": 250, "journal_diameter_mm": 60},
    "motion": {"kind": "trips", "speed_m_s": 0.5, "cycles_per_hour": 75, "runs": [{"duration_s": 9.6}]},
    "drive": {"kind": "mains"},
}
"""An axis that stands on no supply module."""

AXIS_MODULE = {"rated_current_a": 4, "peak_factor": 1.5}
SUPPLY = {"supply_current_a": 8, "supply_peak_factor": 2, "thermal_resistance_k_w": 0.2}


def two_axes(start_s: float = 0) -> dict[str, Any]:
    """Both axes, the second one later by ``start_s``; they share nothing, so that each may be changed alone."""
    first, second = ({"sizing": {"name": name, **SERVO_AXIS}, "module": AXIS_MODULE} for name in ("X", "Y"))
    return {"axes": [copy.deepcopy(first), {**copy.deepcopy(second), "start_s": start_s}], "supply": dict(SUPPLY)}


def project(**axes: dict[str, Any]) -> dict[str, Any]:
    """A project with these axes, to be saved."""
    return {"title": "Gantry", "axes": [{"name": name, "request": request} for name, request in axes.items()]}
