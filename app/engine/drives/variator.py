"""Mechanical variable-speed gear behind a line-fed motor: dimensioned at both ends of its speed range."""

from typing import Annotated, ClassVar, Literal

import numpy as np
from pydantic import model_validator
from pydantic_core import PydanticCustomError

from app.engine.diagram import Diagram, series
from app.engine.drives.base import DriveModel, DriveResult, Given
from app.engine.drives.mains_rules import BrakingRules
from app.engine.drives.parts import InductionMotorChoice, MotorBrakeChoice
from app.engine.drives.variator_motor import VariatorLine, record_motor
from app.engine.drives.variator_range import Demand, RangeRules, VariatorCase, demand_of, record_range, torque_between
from app.engine.environment import RATED_AMBIENT
from app.engine.errors import EngineError
from app.engine.formulas import variator as formulas
from app.engine.mechanisms.load import LoadState
from app.engine.quantity import Declared, Option, Quantity
from app.engine.sheet import Sheet

_UNIT, _DEMAND = "Variable-speed gear", "Speed range"
HEADLINES = ("output_torque", "output_power", "lowest_output_speed", "lowest_speed_torque", "service_factor_demanded")
LOAD_CLASSES: dict[str, tuple[int, float]] = {"I": (1, 1.0), "II": (2, 1.25), "III": (3, 1.5)}
"""Number and service factor of each load class: SEW 2001, 5.2."""
POINTS = 41


class VariableSpeedGear(Declared):
    """A geared motor with variable-speed gear as its list prints it; torques and speeds at the output."""

    design: Annotated[
        Literal["belt", "friction_disc", "other"],
        Option(about="design", group=_UNIT,
               labels={"belt": "V-belt", "friction_disc": "friction disc", "other": "another"}),
    ]  # fmt: skip
    lowest_speed: Annotated[
        float, Quantity("rpm", symbol="n_a1", gt=0, le=2000, about="lowest output speed", group=_UNIT)
    ]
    highest_speed: Annotated[
        float, Quantity("rpm", symbol="n_a2", gt=0, le=2000, about="highest output speed", group=_UNIT)
    ]
    torque_at_lowest_speed: Annotated[
        float, Quantity("N m", symbol="M_a1", gt=0, le=1e7, about="permitted torque at the lowest speed", group=_UNIT)
    ]
    torque_at_highest_speed: Annotated[
        float, Quantity("N m", symbol="M_a2", gt=0, le=1e7, about="permitted torque at the highest speed", group=_UNIT)
    ]
    power_at_highest_speed: Annotated[
        float | None,
        Quantity("kW", symbol="P_a2", gt=0, le=1e7, default=None, group=_UNIT,
                 about="output power at the highest speed"),
    ]  # fmt: skip
    efficiency: Annotated[
        float | None,
        Quantity("1", symbol="eta_V", gt=0, le=1, default=None, group=_UNIT,
                 about="efficiency of variable-speed gear and gear unit together"),
    ]  # fmt: skip

    @model_validator(mode="after")
    def _low_and_high(self) -> "VariableSpeedGear":
        if self.lowest_speed >= self.highest_speed:
            raise PydanticCustomError("variator", "the lowest output speed must be below the highest")
        return self


class VariatorDrive(BrakingRules, DriveModel):
    """A cage motor on the mains with a variable-speed gear and its gear unit."""

    title: ClassVar[str] = "Mechanical variable-speed gear"
    summary: ClassVar[str] = "Line-fed motor with V-belt or friction-disc variator: both ends of the speed range."
    own_ramps: ClassVar[bool] = True

    kind: Literal["variator"] = "variator"
    speed_range: Annotated[
        float,
        Quantity("1", symbol="R_n", ge=1, le=100, default=1.0, source="one speed", group=_DEMAND,
                 about="highest over lowest speed of the machine; the motion gives the highest"),
    ]  # fmt: skip
    law: Annotated[
        Literal["constant_torque", "constant_power", "both"],
        Option(default="constant_torque", source="SEW 2001, 5.2: most machines", group=_DEMAND,
               about="what stays the same over the speed",
               labels={"constant_torque": "torque", "constant_power": "power",
                       "both": "torque at low speed, power at high speed"}),
    ]  # fmt: skip
    corner_speed: Annotated[
        float | None,
        Quantity("rpm", symbol="n_c", gt=0, le=1000, default=None, group=_DEMAND,
                 about="output speed between constant torque and constant power, where both occur"),
    ]  # fmt: skip
    load_class: Annotated[
        Literal["I", "II", "III"],
        Option(default="I", source="uniform load", about="load class", group=_UNIT,
               labels={"I": "I: uniform", "II": "II: moderate shocks", "III": "III: heavy shocks"}),
    ]  # fmt: skip
    service_factor: Annotated[
        float | None,
        Quantity("1", symbol="f_B", gt=0, le=10, default=None, group=_UNIT,
                 about="service factor of the load class; empty: 1, 1.25 or 1.5"),
    ]  # fmt: skip
    temperature_factor: Annotated[
        float | None,
        Quantity("1", symbol="f_TV", gt=0, le=10, default=None, group=_UNIT,
                 about="service factor of the ambient temperature, from the chart of the maker"),
    ]  # fmt: skip
    variable_speed_gear: VariableSpeedGear | None = None
    motor: InductionMotorChoice | None = None
    brake: MotorBrakeChoice | None = None

    @model_validator(mode="after")
    def _corner(self) -> "VariatorDrive":
        if self.law == "both" and self.corner_speed is None:
            raise PydanticCustomError("variator", "constant torque and power need the speed where they meet")
        return self

    def check(self, given: Given, sheet: Sheet) -> DriveResult:
        """Check variable-speed gear and motor over the speed range."""
        first, unit = len(sheet.checks), self.variable_speed_gear
        states = [state for state in given.load.states if state.speed > 0]
        if not states:
            sheet.check("variator_torque_high", "Torque at the highest speed", None, None, "N m",
                        "variable-speed gear: list", missing="steady running of the mechanism")  # fmt: skip
            return DriveResult(checks=tuple(sheet.checks[first:]))
        with sheet.section("Speed range"):
            rules = RangeRules(self.law, self.speed_range, self._corner_speed(states), given.environment.regeneration)
            demand = demand_of(states, rules, sheet)
            number, _ = LOAD_CLASSES[self.load_class]
            factor = self._service_factor(given.environment.ambient_temperature, sheet)
        diagrams: tuple[Diagram, ...] = ()
        if unit is not None:
            with sheet.section(_UNIT):
                case = VariatorCase(
                    lowest_speed=unit.lowest_speed, highest_speed=unit.highest_speed,
                    lowest_torque=unit.torque_at_lowest_speed, highest_torque=unit.torque_at_highest_speed,
                    highest_power=unit.power_at_highest_speed, uniform_only=unit.design == "friction_disc",
                )  # fmt: skip
                record_range(case, demand, factor, number, sheet)
            diagrams = (_diagram(demand, case),)
        line = VariatorLine(
            given=given, rules=self, demand=demand, efficiency=None if unit is None else unit.efficiency
        )
        ratio = record_motor(line, sheet)
        return DriveResult(ratio=ratio, checks=tuple(sheet.checks[first:]), headlines=HEADLINES, diagrams=diagrams)

    def _corner_speed(self, states: list[LoadState]) -> float | None:
        """Speed between the two parts of the range, inside it; None where there is only one part."""
        if self.law != "both" or self.corner_speed is None:
            return None
        highest = max(state.speed for state in states)
        if not highest / self.speed_range <= self.corner_speed <= highest:
            raise EngineError("must lie within the speed range of the machine", field="corner_speed_rpm")
        return self.corner_speed

    def _service_factor(self, ambient: float, sheet: Sheet) -> float | None:
        """f_B * f_TV, None where the factor of a hot place is not known."""
        f_B = self.service_factor if self.service_factor is not None else LOAD_CLASSES[self.load_class][1]
        f_TV = self.temperature_factor
        if f_TV is None and ambient <= RATED_AMBIENT:
            f_TV = 1.0
            sheet.assume("drive.temperature_factor", "factor of the ambient temperature on the service factor",
                         value=f_TV, symbol="f_TV", source="none up to 40 °C; the maker's chart decides")  # fmt: skip
        if f_TV is None:
            return None
        return sheet(formulas.variator_service_factor, key="service_factor_demanded", f_B=f_B, f_TV=f_TV)


def _diagram(demand: Demand, case: VariatorCase) -> Diagram:
    """Torque that is demanded and permitted over the output speed."""
    asked = np.linspace(demand.lowest_speed, demand.highest_speed, POINTS)
    listed = np.linspace(case.lowest_speed, case.highest_speed, POINTS)
    shown = (
        series("demanded", asked, [demand.torque(speed) for speed in asked]),
        series("permitted", listed, [torque_between(case, speed) for speed in listed], "limit"),
    )
    return Diagram("variator", "Torque over the speed range", "output speed", "rpm", "torque at the output", "N m",
                   shown)  # fmt: skip
