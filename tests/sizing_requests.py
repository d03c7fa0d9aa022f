"""Requests that are plainly right, as a program would send them; tests change one thing at a time."""

from typing import Any

SCREW_AXIS: dict[str, Any] = {
    "name": "X",
    "mechanism": {
        "kind": "ball_screw",
        "slide_mass_kg": 400,
        "inclination_deg": 60,
        "nominal_diameter_mm": 40,
        "lead_mm": 10,
        "length_mm": 1000,
    },
    "motion": {
        "kind": "moves",
        "moves": [
            {"distance_mm": 180, "speed_m_s": 0.5, "acceleration_m_s2": 5, "label": "up"},
            {"distance_mm": -180, "speed_m_s": 0.5, "acceleration_m_s2": 5, "dwell_s": 1, "label": "down"},
        ],
    },
    "drive": {
        "kind": "servo",
        "motor": {
            "own": {
                "rated_speed_rpm": 4000,
                "max_speed_rpm": 5000,
                "stall_torque_nm": 30,
                "rated_torque_nm": 25,
                "peak_torque_nm": 90,
                "rotor_inertia_kgcm2": 60,
                "brake_torque_nm": 40,
                "torque_constant_nm_a": 1.5,
            }
        },
    },
}
"""An inclined ball screw with a motor typed from a data sheet: needs no catalogue."""
