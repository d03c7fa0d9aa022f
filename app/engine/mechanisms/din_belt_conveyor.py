"""Belt conveyor for bulk goods to DIN 22101: main, secondary, slope and special resistances."""

from typing import Annotated, ClassVar, Literal, Self

import numpy as np
from pydantic import model_validator

from app.engine.environment import Environment
from app.engine.errors import RangeError
from app.engine.formulas import conveyor as formulas
from app.engine.formulas.belt import pulley_transmission
from app.engine.formulas.conversion import mechanical_power, shaft_speed
from app.engine.formulas.efficiency import driving_stage_torque
from app.engine.formulas.inertia import hollow_cylinder_inertia
from app.engine.formulas.resistance import sum_of_forces
from app.engine.mechanisms.base import Mechanism
from app.engine.mechanisms.conveyed import Conveyed
from app.engine.mechanisms.guided_axis import refused, without_zeros
from app.engine.mechanisms.linear_axis import AxisWords, LinearAxis, record_axis
from app.engine.mechanisms.load import Load
from app.engine.motion.profile import MotionProfile
from app.engine.quantity import Quantity
from app.engine.sheet import Sheet

GOODS, BELT, DRUM = "Goods", "Belt and idlers", "Drive drum"
C_TABLE = "din_22101_c_factor"


class DinBeltConveyor(Mechanism):
    """A belt on idlers that carries bulk goods. The drive's output shaft is the drum, or the input of a stage."""

    title: ClassVar[str] = "Belt conveyor to DIN 22101"
    summary: ClassVar[str] = "Bulk goods on a belt with idlers: mass flow, length, slope."
    drawing: ClassVar[str] = "din_belt_conveyor.svg"
    motion_kind: ClassVar[Literal["linear", "rotary"]] = "linear"

    kind: Literal["din_belt_conveyor"] = "din_belt_conveyor"
    mass_flow: Annotated[float, Quantity("t/h", symbol="m_dot", gt=0, le=1e5, group=GOODS, about="goods per time")]
    belt_speed: Annotated[
        float, Quantity("m/s", symbol="v_N", gt=0, le=50, group=GOODS, about="speed of the belt at that mass flow")
    ]
    length: Annotated[float, Quantity("m", symbol="L", gt=0, le=2e4, group=GOODS, about="length of the conveyor")]
    inclination: Annotated[
        float,
        Quantity("deg", symbol="alpha", ge=-np.pi / 6, le=np.pi / 6, default=0.0, source="level", group=GOODS,
                 about="inclination; positive: the goods are lifted"),
    ]  # fmt: skip
    belt_mass_per_length: Annotated[
        float, Quantity("kg/m", symbol="m_G", gt=0, le=1000, group=BELT, about="one strand of the belt per length")
    ]
    idler_mass: Annotated[
        float, Quantity("kg", symbol="m_R", ge=0, le=1e6, group=BELT, about="turning mass of all idlers")
    ]
    idler_diameter: Annotated[
        float | None,
        Quantity("mm", symbol="D_R", gt=0, le=2, default=None, group=BELT,
                 about="outer diameter of the idlers; empty: they count as if they were thin tubes"),
    ]  # fmt: skip
    idler_inner_diameter: Annotated[
        float, Quantity("mm", symbol="D_iR", ge=0, le=2, default=0.0, source="solid", group=BELT,
                        about="inner diameter of the idlers"),
    ]  # fmt: skip
    friction_factor: Annotated[
        float,
        Quantity("1", symbol="f_c", gt=0, le=0.2, default=0.02, source="DIN 22101: usual", group=BELT,
                 about="friction factor of belt and idlers"),
    ]  # fmt: skip
    secondary_factor: Annotated[
        float | None,
        Quantity("1", symbol="C", ge=1, le=20, default=None, group=BELT,
                 about="factor of the total resistance; empty: from the table by the length"),
    ]  # fmt: skip
    special_resistance: Annotated[
        float,
        Quantity("N", symbol="F_S", ge=0, le=1e7, default=0.0, source="none", group=BELT,
                 about="special resistances: scrapers, ploughs, tilted idlers"),
    ]  # fmt: skip
    drum_diameter: Annotated[
        float, Quantity("mm", symbol="D", gt=0, le=5, group=DRUM, about="diameter of the drive drum")
    ]
    efficiency: Annotated[
        float,
        Quantity("1", symbol="eta_L", gt=0, le=1, default=0.9, source="SEW 2001, 13.1", group=DRUM,
                 about="efficiency of belt and drum"),
    ]  # fmt: skip
    drum_inertia: Annotated[
        float,
        Quantity("kg m2", symbol="J_D", ge=0, le=1e5, default=0.0, source="left out until given", group=DRUM,
                 about="inertia of all drums, referred to the drive drum"),
    ]  # fmt: skip

    @model_validator(mode="after")
    def _idlers_are_tubes(self) -> Self:
        if self.idler_diameter is not None and self.idler_inner_diameter >= self.idler_diameter:
            raise refused(self, "idler_inner_diameter", "must be smaller than the outer diameter")
        return self

    def load_at_shaft(self, motion: MotionProfile, environment: Environment, sheet: Sheet) -> Load:
        """Load cycle at the drive drum or the input of the stage before it."""
        with sheet.section(DRUM):
            radius = sheet(pulley_transmission, key="transmission_constant", d=self.drum_diameter,
                           label="Travel of the belt per radian of the drive drum")  # fmt: skip
        m_l, resistance, slope = self._record_resistances(sheet, motion.max_speed, environment.gravity)
        idlers = self._record_idlers(sheet, motion.max_speed)
        moved = self.length * (2 * self.belt_mass_per_length + m_l)
        body = Conveyed(moved + idlers, lambda _, __: slope, lambda _, __: resistance, inclined=slope != 0)
        axis = LinearAxis(body=body, words=AxisWords("peripheral_force", "Force at the rim of the drum", "drum"),
                          constant=radius, efficiency=self.efficiency, front_inertia=self.drum_inertia)  # fmt: skip
        cycle = axis.cycle(motion, environment)
        record_axis(axis, sheet, motion, cycle, environment)
        return Load(
            cycle=cycle, statics=axis.statics(motion, environment), opposite=axis.opposite(motion, environment),
            results={"drum_speed": cycle.max_speed, "conveying_power": sheet.value("conveying_power")},
            states=axis.states(motion, environment),
        )  # fmt: skip

    def _record_resistances(self, sheet: Sheet, speed: float, gravity: float) -> tuple[float, float, float]:
        """Goods per length [kg/m], resistance and slope resistance [N]."""
        with sheet.section("Resistances to DIN 22101"):
            m_l = sheet(formulas.load_per_length, m_dot=self.mass_flow, v=self.belt_speed)
            C = sheet.look_up(C_TABLE, "factor of the total resistance by the length of the conveyor", symbol="C",
                              x=self.length, given=self.secondary_factor)  # fmt: skip
            if C is None:
                message = "is needed: the table of the factor is not in the catalogue that is loaded"
                raise RangeError(message, field="secondary_factor")
            F_H = sheet(formulas.main_resistance, L=self.length, f_c=self.friction_factor, g=gravity,
                        m_R=self.idler_mass, m_G=self.belt_mass_per_length, m_l=m_l,
                        alpha=self.inclination)  # fmt: skip
            F_N = sheet(formulas.secondary_resistance, C=C, F_H=F_H)
            slope = sheet(formulas.slope_resistance, m_l=m_l, L=self.length, g=gravity, alpha=self.inclination)
            force = sheet(sum_of_forces, key="belt_force", symbol="F", label="Force at the rim of the drive drum",
                          F_k=without_zeros([F_H, F_N, slope, self.special_resistance]))  # fmt: skip
            power = sheet(mechanical_power, key="belt_power", label="Power at the rim of the drive drum", F=force,
                          v=speed)  # fmt: skip
            sheet(driving_stage_torque, key="conveying_power", symbol="P_S", unit="W", T=power, eta=self.efficiency,
                  label="Power at the shaft of the drive drum")  # fmt: skip
        return m_l, F_H + F_N + self.special_resistance, slope

    def _record_idlers(self, sheet: Sheet, speed: float) -> float:
        """Mass that moves as the idlers do [kg]."""
        if self.idler_diameter is None:
            return self.idler_mass
        with sheet.section("Idlers"):
            D, D_i = self.idler_diameter, self.idler_inner_diameter
            label = "Inertia of all idlers about their own axes"
            sheet(hollow_cylinder_inertia, key="idlers_inertia", symbol="J_R", label=label, m=self.idler_mass, D=D,
                  D_i=D_i)  # fmt: skip
            sheet(shaft_speed, key="idler_speed", label="Speed of the idlers", v=speed, A=D / 2)
            return sheet(formulas.idlers_equivalent_mass, m_R=self.idler_mass, D=D, D_i=D_i)
