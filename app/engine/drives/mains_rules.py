"""What is asked about every line-fed motor, and the names of its checks."""

from typing import Annotated, Literal

from pydantic import Field

from app.engine.drives.gear_service import GearService
from app.engine.quantity import Declared, Option, Quantity

_START, _BRAKE, _MOTOR = "Starting", "Braking", "Motor"


class StartingFactor(Declared):
    """The factor of static power and duty for one state of load, read from the maker's chart."""

    state: Annotated[
        Annotated[str, Field(min_length=1, max_length=60)],
        Option(about="state of load as the sheet names it, e.g. laden_forward"),
    ]
    factor: Annotated[float, Quantity("1", symbol="K_P", gt=0, le=2, about="factor K_P")]


class BrakingRules(Declared):
    """How a brake stops and holds."""

    cut_off: Annotated[
        Literal["dc", "ac"],
        Option(default="dc", source="faster, as hoists need", about="where the brake is cut off", group=_BRAKE,
               labels={"dc": "in the DC and AC circuit", "ac": "in the AC circuit"}),
    ]  # fmt: skip
    stopping_tolerance: Annotated[
        float,
        Quantity("%", symbol="k_X", ge=0, le=1, default=0.12, source="SEW 2001, 7.9: about 12 %", group=_BRAKE,
                 about="tolerance of the stopping distance"),
    ]  # fmt: skip
    accuracy: Annotated[
        float | None,
        Quantity("mm", symbol="X", gt=0, le=100, default=None, group=_BRAKE,
                 about="demanded stopping accuracy to either side"),
    ]  # fmt: skip
    holding_reserve: Annotated[
        float,
        Quantity("1", symbol="k_B", ge=1, le=10, default=2.0, source="SEW 2001, 9.1: hoists take about twice",
                 about="brake torque over the torque that holds the load", group=_BRAKE),
    ]  # fmt: skip


class MotorRules(BrakingRules, GearService):
    """Rules of induction motors with gear unit and brake, on the mains or on an inverter."""

    flywheel_inertia: Annotated[
        float,
        Quantity("kg m2", symbol="J_Z", ge=0, le=1e4, default=0.0, source="none", group=_START,
                 about="additional inertia on the motor shaft: flywheel or heavy fan"),
    ]  # fmt: skip
    duty: Annotated[
        float | None,
        Quantity("%", symbol="ED", gt=0, le=1, default=None, group=_START,
                 about="cyclic duration factor; empty: from the motion"),
    ]  # fmt: skip
    duty_type: Annotated[
        Literal["S1", "S2", "S3"],
        Option(default="S1", source="continuous duty", about="duty type of the rating (IEC 60034-1)", group=_MOTOR,
               labels={"S1": "S1: continuous", "S2": "S2: short time", "S3": "S3: intermittent"}),
    ]  # fmt: skip
    power_increase: Annotated[
        float | None,
        Quantity("1", symbol="K", ge=1, le=2, default=None, group=_MOTOR,
                 about="power increase factor of the maker for S2 or S3; empty: from the table of the duty type"),
    ]  # fmt: skip
    gear_efficiency: Annotated[
        float | None,
        Quantity("1", symbol="eta_G", gt=0, le=1, default=None, group=_MOTOR,
                 about="efficiency of the gear unit, where its data sheet gives none"),
    ]  # fmt: skip


class LineFedRules(MotorRules):
    """Rules of motors that run on the mains."""

    starting: Annotated[
        Literal["direct", "star_delta"],
        Option(default="direct", source="one contactor", about="how the motor is connected while it runs up",
               group=_START, labels={"direct": "direct on line", "star_delta": "star-delta: run-up in star"}),
    ]  # fmt: skip
    starting_factors: Annotated[
        tuple[StartingFactor, ...],
        Option(default=(), about="factors K_P of the maker, instead of the tabulated ones", group=_START),
    ]


CHECK_NAMES = {
    "run_up_torque": "Run-up torque",
    "star_speed": "Speed reached in star",
    "slip_starting": "Permissible acceleration while starting",
    "slip_braking": "Permissible deceleration while braking",
    "slip_changing": "Permissible deceleration while changing the poles",
    "static_power": "Power in steady running",
    "static_power_low": "Power in steady running on the low-speed winding",
    "starting_frequency": "Cycles per hour by the heating of the motor",
    "brake_holding": "Brake: holding the load",
    "brake_stops": "Brake: stopping the load",
    "brake_work": "Brake: work of one stop",
    "stopping_accuracy": "Stopping accuracy",
}
"""Name of every check for the reader, by key."""
