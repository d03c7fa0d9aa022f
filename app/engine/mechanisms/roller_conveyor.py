"""Roller conveyor: goods on driven rollers, the drive at one of them and chains from each to the next."""

from typing import Annotated, Any, ClassVar, Literal, Self

import numpy as np
from pydantic import model_validator

from app.engine.environment import Environment
from app.engine.formulas import conveyor as formulas
from app.engine.formulas.belt import pulley_transmission
from app.engine.formulas.inertia import hollow_cylinder_inertia
from app.engine.formulas.rail import rolling_resistance, slip_acceleration
from app.engine.mechanisms.base import Mechanism
from app.engine.mechanisms.conveyed import Conveyed
from app.engine.mechanisms.guided_axis import refused
from app.engine.mechanisms.linear_axis import AxisWords, LinearAxis, record_axis
from app.engine.mechanisms.load import Load
from app.engine.motion.profile import MotionProfile
from app.engine.quantity import Option, Quantity
from app.engine.sheet import Sheet

ROLLERS, FRICTION, CHAINS = "Rollers", "Resistances", "Chains between the rollers"


class RollerConveyor(Mechanism):
    """Goods on driven rollers. The drive's output shaft is the shaft of a roller, or the input of a stage before it."""

    title: ClassVar[str] = "Roller conveyor"
    summary: ClassVar[str] = "Plates or pallets on driven rollers that chains connect."
    drawing: ClassVar[str] = "roller_conveyor.svg"
    motion_kind: ClassVar[Literal["linear", "rotary"]] = "linear"

    kind: Literal["roller_conveyor"] = "roller_conveyor"
    roller_diameter: Annotated[
        float, Quantity("mm", symbol="D", gt=0, le=5, group=ROLLERS, about="outer diameter of the rollers")
    ]
    roller_inner_diameter: Annotated[
        float,
        Quantity("mm", symbol="D_i", ge=0, le=5, default=0.0, source="solid", group=ROLLERS, about="inner diameter"),
    ]  # fmt: skip
    roller_length: Annotated[
        float, Quantity("mm", symbol="l", gt=0, le=20, group=ROLLERS, about="length of the rollers")
    ]
    density: Annotated[
        float,
        Quantity("kg/m3", symbol="rho", gt=0, le=3e4, default=7850.0, source="steel", group=ROLLERS,
                 about="density of the rollers"),
    ]  # fmt: skip
    rollers: Annotated[int, Option(ge=1, le=1000, symbol="n_R", group=ROLLERS, about="rollers of one drive")]
    journal_diameter: Annotated[
        float, Quantity("mm", symbol="d_j", gt=0, le=5, group=FRICTION, about="diameter of the journals")
    ]
    bearing_friction: Annotated[
        float,
        Quantity("1", symbol="mu_L", ge=0, le=1, default=0.005, source="SEW 2001, 17.1: rolling bearing",
                 group=FRICTION, about="coefficient of bearing friction"),
    ]  # fmt: skip
    rolling_arm: Annotated[
        float,
        Quantity("mm", symbol="f", ge=0, le=0.05, default=0.0005, source="SEW 2001, 17.1: steel on steel",
                 group=FRICTION, about="lever arm of rolling friction"),
    ]  # fmt: skip
    rim_friction: Annotated[
        float,
        Quantity("1", symbol="c", ge=0, le=0.1, default=0.0, source="no flanges", group=FRICTION,
                 about="guiding friction as a share of weight"),
    ]  # fmt: skip
    own_weight: Annotated[
        bool,
        Option(default=True, source="the rollers weigh on their bearings, too", group=FRICTION,
               about="bearing friction of the rollers' own weight"),
    ]  # fmt: skip
    static_friction: Annotated[
        float | None,
        Quantity("1", symbol="mu_0", gt=0, le=2, default=None, group=FRICTION,
                 about="static friction between goods and rollers; empty: slipping is not checked"),
    ]  # fmt: skip
    wrap_efficiency: Annotated[
        float,
        Quantity("1", symbol="eta_1", gt=0, le=1, default=0.9, source="SEW 2001, 17.1: chain, lower value",
                 group=CHAINS, about="efficiency of one full wrap"),
    ]  # fmt: skip
    loss_model: Annotated[
        Literal["last_roller", "distributed"],
        Option(default="distributed", source="the goods lie on all rollers", group=CHAINS, about="where the load is",
               labels={"distributed": "spread over all rollers",
                       "last_roller": "at the last roller (bound on the safe side)"}),
    ]  # fmt: skip

    @model_validator(mode="after")
    def _diameters_fit(self) -> Self:
        if self.roller_inner_diameter >= self.roller_diameter:
            raise refused(self, "roller_inner_diameter", "must be smaller than the outer diameter")
        if self.journal_diameter >= self.roller_diameter:
            raise refused(self, "journal_diameter", "the journal must be thinner than the roller")
        return self

    def load_at_shaft(self, motion: MotionProfile, environment: Environment, sheet: Sheet) -> Load:
        """Load cycle at the shaft of the driven roller or the input of the stage before it."""
        g, payload = environment.gravity, float(motion.payload.max())
        with sheet.section(ROLLERS):
            radius = sheet(pulley_transmission, key="transmission_constant", d=self.roller_diameter,
                           label="Travel of the goods per radian of a roller")  # fmt: skip
            inertia = self._record_rollers(sheet)
        with sheet.section(FRICTION):
            sheet(rolling_resistance, key="rolling_resistance", m=payload, g=g, alpha=0.0, D=self.roller_diameter,
                  mu_L=self.bearing_friction, d_j=self.journal_diameter, f=self.rolling_arm,
                  c=self.rim_friction)  # fmt: skip
            self._record_own_weight(sheet, g)
        efficiency, permissible = self._record_chains(sheet), self._record_slip(sheet, g)
        body = Conveyed(0.0, lambda _, __: 0.0, self._resistance, inclined=False)
        axis = LinearAxis(
            body=body, words=AxisWords("roller_force", "Force that moves the goods", "roller"), constant=radius,
            efficiency=efficiency, rear_inertia=inertia * self.rollers,
        )  # fmt: skip
        cycle = axis.cycle(motion, environment)
        record_axis(axis, sheet, motion, cycle, environment)
        found = Load(
            cycle=cycle, statics=axis.statics(motion, environment),
            results={"roller_speed": cycle.max_speed, "load_inertia_at_roller": cycle.inertia},
            states=axis.states(motion, environment, permissible_acceleration=permissible),
        )  # fmt: skip
        if permissible is not None:
            sheet.check("goods_slip", "Goods slip on the rollers", float(abs(motion.acceleration).max()), permissible,
                        "m/s2", "static friction between goods and rollers", formula="slip_acceleration")  # fmt: skip
        return found

    def _roller_mass(self) -> float:
        volume = formulas.tube_volume(self.roller_diameter, self.roller_inner_diameter, self.roller_length)
        return float(formulas.mass_of_volume(volume, self.density))

    def _resistance(self, payload: Any, gravity: float) -> Any:
        rolling = rolling_resistance(payload, gravity, 0.0, self.roller_diameter, self.bearing_friction,
                                     self.journal_diameter, self.rolling_arm, self.rim_friction)  # fmt: skip
        if not self.own_weight:
            return rolling
        return rolling + formulas.roller_weight_friction(
            self.rollers, self._roller_mass(), gravity, self.bearing_friction, self.journal_diameter,
            self.roller_diameter,
        )  # fmt: skip

    def _record_rollers(self, sheet: Sheet) -> float:
        """Inertia of one roller [kg m2]."""
        D, D_i = self.roller_diameter, self.roller_inner_diameter
        volume = sheet(formulas.tube_volume, key="roller_volume", D=D, D_i=D_i, l=self.roller_length)
        mass = sheet(formulas.mass_of_volume, key="roller_mass", symbol="m_R", label="Mass of one roller", V=volume,
                     rho=self.density)  # fmt: skip
        return sheet(hollow_cylinder_inertia, key="roller_inertia", symbol="J_R", label="Inertia of one roller", m=mass,
                     D=D, D_i=D_i)  # fmt: skip

    def _record_own_weight(self, sheet: Sheet, gravity: float) -> None:
        if self.own_weight:
            sheet(formulas.roller_weight_friction, n_R=self.rollers, m_R=self._roller_mass(), g=gravity,
                  mu_L=self.bearing_friction, d_j=self.journal_diameter, D=self.roller_diameter)  # fmt: skip

    def _record_chains(self, sheet: Sheet) -> float:
        with sheet.section(CHAINS):
            if self.rollers == 1:
                sheet.decide("No chain between rollers", "there is one roller only")
                return 1.0
            if self.loss_model == "distributed":
                return sheet(formulas.distributed_wraps_efficiency, key="chain_efficiency", n_R=self.rollers,
                             eta_k=self.wrap_efficiency ** np.arange(self.rollers))  # fmt: skip
            return sheet(formulas.wraps_efficiency, key="chain_efficiency", eta=self.wrap_efficiency,
                         x_w=self.rollers - 1)  # fmt: skip

    def _record_slip(self, sheet: Sheet, gravity: float) -> float | None:
        if self.static_friction is None:
            return None
        with sheet.section("Slip of the goods"):
            return sheet(slip_acceleration, key="permissible_acceleration", mu_0=self.static_friction, k_d=1.0,
                         g=gravity, alpha=0.0)  # fmt: skip
