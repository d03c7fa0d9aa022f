"""Chain conveyor: goods on a chain that slides on its guide, level or climbing, with goods held at a stop."""

from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from app.engine.environment import Environment
from app.engine.formulas import conveyor as formulas
from app.engine.formulas.belt import pulley_transmission
from app.engine.formulas.resistance import guide_friction, sum_of_forces, weight_along_axis
from app.engine.mechanisms.base import Mechanism
from app.engine.mechanisms.conveyed import Conveyed
from app.engine.mechanisms.linear_axis import AxisWords, LinearAxis, record_axis
from app.engine.mechanisms.load import Load
from app.engine.motion.profile import MotionProfile
from app.engine.quantity import Option, Quantity
from app.engine.sheet import Sheet

CHAIN = "Chain and goods"
DRIVE = "Sprocket"


class ChainConveyor(Mechanism):
    """Goods on a sliding chain. The drive's output shaft is the sprocket shaft, or the input of a stage before it."""

    title: ClassVar[str] = "Chain conveyor"
    summary: ClassVar[str] = "Pallets or boxes on a sliding chain, level or climbing, also held at a stop."
    drawing: ClassVar[str] = "chain_conveyor.svg"
    motion_kind: ClassVar[Literal["linear", "rotary"]] = "linear"

    kind: Literal["chain_conveyor"] = "chain_conveyor"
    chain_mass: Annotated[
        float,
        Quantity("kg", symbol="m_K", gt=0, le=1e6, group=CHAIN,
                 about="whole chain, both strands; the goods are the payload of the motion"),
    ]  # fmt: skip
    inclination: Annotated[
        float,
        Quantity("deg", symbol="alpha", ge=0, le=np.pi / 3, default=0.0, source="level", group=CHAIN,
                 about="inclination; positive motion is uphill"),
    ]  # fmt: skip
    guide_friction: Annotated[
        float,
        Quantity("1", symbol="mu_1", ge=0, le=2, default=0.2, source="SEW 2001, 10.1: steel chain on plastic",
                 group=CHAIN, about="friction between chain and slideway"),
    ]  # fmt: skip
    strands: Annotated[
        Literal["carrying", "balanced"],
        Option(default="balanced", source="closed loop", group=CHAIN, about="weight of the chain",
               labels={"balanced": "both strands balance each other",
                       "carrying": "the carrying strand is lifted as if it were goods"}),
    ]  # fmt: skip
    return_strand: Annotated[
        Literal["hanging", "guided"],
        Option(default="hanging", source="hangs free", group=CHAIN, about="return strand",
               labels={"hanging": "hangs free", "guided": "slides on a guide"}),
    ]  # fmt: skip
    blocked_mass: Annotated[
        float,
        Quantity("kg", symbol="m_b", ge=0, le=1e6, default=0.0, source="none", group=CHAIN,
                 about="part of the goods that is held at a stop while the chain runs on"),
    ]  # fmt: skip
    goods_friction: Annotated[
        float,
        Quantity("1", symbol="mu_2", ge=0, le=2, default=0.7, source="SEW 2001, 10.1: box on chain", group=CHAIN,
                 about="friction between goods and chain"),
    ]  # fmt: skip
    sprocket_diameter: Annotated[
        float, Quantity("mm", symbol="D", gt=0, le=5, group=DRIVE, about="pitch diameter of the sprocket")
    ]
    efficiency: Annotated[
        float,
        Quantity("1", symbol="eta_L", gt=0, le=1, default=0.9, source="SEW 2001, 17.1: chain, lower value",
                 group=DRIVE, about="efficiency of the chain on its sprockets"),
    ]  # fmt: skip

    def load_at_shaft(self, motion: MotionProfile, environment: Environment, sheet: Sheet) -> Load:
        """Load cycle at the sprocket shaft or the input of the stage before it."""
        with sheet.section("Sprocket"):
            radius = sheet(pulley_transmission, key="transmission_constant", d=self.sprocket_diameter,
                           label="Travel of the chain per radian of the sprocket")  # fmt: skip
        self._record(sheet, float(motion.payload.max()), environment.gravity)
        body = Conveyed(
            self.chain_mass, self._weight, self._resistance,
            inclined=bool(self.inclination and (motion.payload.max() > 0 or self.strands == "carrying")),
        )  # fmt: skip
        words = AxisWords("chain_pull", "Pull of the chain", "sprocket")
        axis = LinearAxis(body=body, words=words, constant=radius, efficiency=self.efficiency)
        cycle = axis.cycle(motion, environment)
        record_axis(axis, sheet, motion, cycle, environment)
        return Load(
            cycle=cycle, statics=axis.statics(motion, environment), opposite=axis.opposite(motion, environment),
            results={"sprocket_speed": cycle.max_speed, "load_inertia_at_sprocket": cycle.inertia},
            states=axis.states(motion, environment),
        )  # fmt: skip

    def _weight(self, payload: Any, gravity: float) -> Any:
        """Weight of goods, and of the carrying strand where it is not balanced."""
        strand = self.chain_mass / 2 if self.strands == "carrying" else 0.0
        return weight_along_axis(payload + strand, gravity, self.inclination)

    def _resistance(self, payload: Any, gravity: float) -> Any:
        """Friction of the chain on its guide, and of goods that are held."""
        both = self.chain_mass if self.return_strand == "guided" else self.chain_mass / 2
        sliding = guide_friction(self.guide_friction, payload + both, gravity, self.inclination)
        return sliding + self._blocked(gravity)

    def _blocked(self, gravity: float) -> float:
        """What goods that are held add; never less than nothing."""
        found = formulas.blocked_goods_resistance(self.blocked_mass, self.goods_friction, gravity, self.inclination)
        return max(float(found), 0.0)

    def _record(self, sheet: Sheet, payload: float, gravity: float) -> None:
        with sheet.section("Resistances of the chain"):
            law = formulas.sliding_conveyor_resistance
            if self.strands == "balanced":
                law = formulas.balanced_conveyor_resistance
            parts = [sheet(law, key="conveyor_resistance", m=payload, m_K=self.chain_mass / 2, mu=self.guide_friction,
                           g=gravity, alpha=self.inclination)]  # fmt: skip
            if self.return_strand == "guided":
                parts.append(sheet(guide_friction, key="return_strand_friction", mu=self.guide_friction,
                                   label="Friction of the return strand", m=self.chain_mass / 2, g=gravity,
                                   alpha=self.inclination))  # fmt: skip
            if self.blocked_mass:
                sheet(guide_friction, key="blocked_goods_friction", mu=self.goods_friction, m=self.blocked_mass,
                      label="Friction of the goods that are held", g=gravity, alpha=self.inclination)  # fmt: skip
                parts.append(sheet(formulas.blocked_goods_resistance, m_b=self.blocked_mass, mu_b=self.goods_friction,
                                   g=gravity, alpha=self.inclination))  # fmt: skip
            sheet(sum_of_forces, key="conveyor_force", symbol="F", label="Force at constant speed uphill", F_k=parts)
