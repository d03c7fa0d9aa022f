"""The rules by which a servo drive is judged, and what follows from them for every motor."""

from collections.abc import Iterator
from typing import Annotated, Any, Literal

from app.engine.mechanisms.load import Load
from app.engine.products import ServoMotor
from app.engine.quantity import Declaration, Declared, Option, Quantity

CHECK_NAMES = {
    "gear_acceleration_torque": "Gear unit: acceleration torque",
    "gear_nominal_torque": "Gear unit: nominal torque",
    "gear_emergency_torque": "Gear unit: emergency torque",
    "gear_mean_input_speed": "Gear unit: mean input speed",
    "gear_max_input_speed": "Gear unit: highest input speed",
    "speed": "Motor speed",
    "motor_speed": "Motor speed",
    "inertia_ratio": "Inertia ratio",
    "motor_inertia": "Motor inertia",
    "holding_brake": "Holding brake",
    "peak_torque": "Peak torque",
    "effective_torque": "Effective torque at mean speed",
    "friction_torque": "Passive resistances at standstill (M_1)",
    "rest_torque": "Steady torque at rapid speed (M_2)",
    "working_torque": "Steady torque at working speed (M_3)",
    "dynamic_peak_torque": "Dynamic torque",
    "positioning_accuracy": "Positioning accuracy",
    "drive_peak_current": "Servo drive: peak current",
    "drive_continuous_current": "Servo drive: effective current",
}
"""Name of every check for the reader, by key, in the order in which they are made."""

LACHMAN_INERTIA_LIMIT = 1.25
"""External / motor inertia that Lachman permits (J_M >= 0.8 * J_red * k^2)."""

_ONLY_USUAL = {"inertia_ratio_limit", "speed_limit", "speed_share", "peak_reserve"}
_ONLY_LACHMAN = {"friction_share", "continuous_tolerance"}


class ServoRules(Declared):
    """By what a servo drive is judged."""

    rule_set: Annotated[
        Literal["usual", "lachman"],
        Option(
            default="usual",
            about="rule set",
            source="usual practice",
            group="Rules",
            labels={
                "usual": "Peak and effective torque, speed, inertia ratio",
                "lachman": "Lachman: inertia, friction, rest and working torque, dynamic torque",
            },
        ),
    ]
    inertia_ratio_limit: Annotated[
        float,
        Quantity(
            "1",
            symbol="lambda_J",
            gt=0,
            le=1000,
            default=10.0,
            source="value from experience",
            about="permitted ratio of external to motor inertia",
            group="Rules",
        ),
    ]
    speed_limit: Annotated[
        Literal["rated", "maximum"],
        Option(
            default="rated",
            about="speed that the motor is held to",
            source="usual practice: control reserve below rated speed",
            group="Rules",
            labels={"rated": "Rated speed", "maximum": "Highest permitted speed"},
        ),
    ]
    speed_share: Annotated[
        float,
        Quantity(
            "1",
            symbol="r_n",
            gt=0,
            le=1,
            default=0.9,
            source="usual practice: 10 % control reserve",
            about="share of that speed that may be used",
            group="Rules",
        ),
    ]
    peak_reserve: Annotated[
        float,
        Quantity(
            "1",
            symbol="k_M",
            ge=1,
            le=10,
            default=1.0,
            source="no reserve beyond the computed peak torque",
            about="reserve factor on the peak torque",
            group="Rules",
        ),
    ]
    brake: Annotated[
        Literal["auto", "yes", "no"],
        Option(
            default="auto",
            about="holding brake in the motor",
            source="needed where the axis does not rest by itself or a segment is braked",
            group="Rules",
            labels={"auto": "Where the axis needs it", "yes": "Yes", "no": "No"},
        ),
    ]
    holding_reserve: Annotated[
        float,
        Quantity(
            "1",
            symbol="k_B",
            ge=1,
            le=10,
            default=1.0,
            source="no reserve beyond the computed holding torque",
            about="reserve factor on the holding torque",
            group="Rules",
        ),
    ]
    coupling_inertia: Annotated[
        float,
        Quantity(
            "kg cm2",
            symbol="J_C",
            ge=0,
            le=10,
            default=0.0,
            source="no coupling given",
            about="inertia of coupling or pinion on the motor shaft",
            group="Rules",
        ),
    ]
    encoder_increments: Annotated[
        float | None,
        Quantity("1", symbol="n_inc", gt=0, le=1e9, default=None, about="increments of the encoder per revolution",
                 group="Rules"),
    ]  # fmt: skip
    accuracy: Annotated[
        float | None,
        Quantity("mm", symbol="ds_p", gt=0, le=1, default=None, about="demanded positioning accuracy to either side",
                 group="Rules"),
    ]  # fmt: skip
    emergency_stop_factor: Annotated[
        float | None,
        Quantity(
            "1",
            symbol="k_em",
            ge=1,
            le=20,
            default=None,
            about="output torque in an emergency stop over the largest in operation",
            group="Rules",
        ),
    ]
    friction_share: Annotated[
        float,
        Quantity(
            "1",
            symbol="c_T",
            gt=0,
            le=1,
            default=0.2,
            source="Lachman, Mendricky 2015, part 6: 20 %, relaxed 40 %",
            about="share of the standstill torque that passive resistances may take (Lachman)",
            group="Rules",
        ),
    ]
    continuous_tolerance: Annotated[
        float,
        Quantity(
            "%",
            symbol="c_S1",
            ge=0,
            le=0.2,
            default=0.05,
            source="Lachman, Mendricky 2015, part 6: about 5 % excess is tolerated",
            about="tolerated excess over the continuous torque (Lachman)",
            group="Rules",
        ),
    ]

    def defaults_taken(self) -> Iterator[tuple[str, Declaration, Any]]:
        """As in the base, without those that the chosen rule set does not use."""
        idle = _ONLY_USUAL if self.rule_set == "lachman" else _ONLY_LACHMAN
        yield from (found for found in super().defaults_taken() if found[0] not in idle)


def brake_needed(load: Load, rules: ServoRules) -> bool:
    """Whether the motor needs a holding brake: as demanded, or because the axis does not rest without torque."""
    if rules.brake != "auto":
        return rules.brake == "yes"
    cycles = (load.cycle,) if load.opposite is None else (load.cycle, load.opposite)
    largest = max(abs(load.statics.forward), abs(load.statics.backward), abs(load.statics.friction))
    held = abs(load.statics.holding) > 1e-9 * largest
    return held or any(bool(cycle.braked.any()) for cycle in cycles)


def rotor_inertia(motor: ServoMotor, with_brake: bool) -> float | None:
    """Rotor inertia [kg m2], brake included where one is needed and its inertia known; None: the source gives none."""
    if with_brake and motor.rotor_inertia_with_brake is not None:
        return motor.rotor_inertia_with_brake
    return motor.rotor_inertia


def permitted_speed(motor: ServoMotor, rules: ServoRules) -> float | None:
    """Speed [rad/s] up to which the highest motor speed may reach under these rules; None where it is not known.

    The usual rules take a share of rated or highest speed. Lachman's reserve is part of his demanded speed.
    """
    if rules.rule_set == "lachman":
        return motor.rated_speed if motor.max_speed is None else motor.max_speed
    base = motor.rated_speed if rules.speed_limit == "rated" else motor.max_speed or motor.rated_speed
    return None if base is None else rules.speed_share * base
