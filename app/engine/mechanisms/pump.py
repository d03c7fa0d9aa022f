"""Centrifugal pump: laws of affinity, and a static head below which nothing flows."""

from collections.abc import Iterator
from typing import Annotated, Any, ClassVar, Literal, Self

from pydantic import model_validator

from app.engine.environment import Environment
from app.engine.formulas import fluid as formulas
from app.engine.mechanisms.fluid import POINT, FluidMachine, consistent
from app.engine.mechanisms.guided_axis import refused
from app.engine.mechanisms.load import Load
from app.engine.motion.profile import MotionProfile
from app.engine.quantity import Declaration, Quantity
from app.engine.sheet import Sheet

SYSTEM = "System"


class Pump(FluidMachine):
    """A centrifugal pump. Its shaft is that of the impeller, or the input of a stage before it."""

    title: ClassVar[str] = "Centrifugal pump"
    summary: ClassVar[str] = "Pump with or without static head: flow, head and torque at every speed."
    drawing: ClassVar[str] = "pump.svg"

    kind: Literal["pump"] = "pump"
    head: Annotated[float | None, Quantity("m", symbol="H", gt=0, le=1e4, default=None, group=POINT, about="head")]
    density: Annotated[
        float,
        Quantity("kg/m3", symbol="rho", gt=0, le=2e4, default=1000.0, source="water", group=POINT,
                 about="density of the liquid"),
    ]  # fmt: skip
    pump_efficiency: Annotated[
        float | None,
        Quantity("1", symbol="eta_P", gt=0, le=1, default=None, group=POINT, about="efficiency of the pump"),
    ]
    static_head: Annotated[
        float,
        Quantity("m", symbol="H_st", ge=0, le=1e4, default=0.0, source="closed circuit", group=SYSTEM,
                 about="head that the system takes without any flow: height and pressure of the vessel"),
    ]  # fmt: skip
    closed_valve_head: Annotated[
        float | None,
        Quantity("m", symbol="H_0", gt=0, le=1e4, default=None, group=SYSTEM,
                 about="head of the pump against a closed valve at the speed of the operating point"),
    ]  # fmt: skip
    closed_valve_torque: Annotated[
        float,
        Quantity("1", symbol="k_0", ge=0, le=1, default=0.4, source="common practice: radial pumps, 0.3 to 0.5",
                 group=SYSTEM, about="torque against a closed valve over that of the operating point"),
    ]  # fmt: skip

    @model_validator(mode="after")
    def _an_operating_point(self) -> Self:
        consistent(self, ("head", "pump_efficiency"))
        if not self.static_head:
            return self
        for name, words in (("head", "the head of the operating point"), ("closed_valve_head", "this head")):
            if getattr(self, name) is None:
                raise refused(self, name, f"with a static head {words} is needed, too")
        assert self.head is not None
        assert self.closed_valve_head is not None
        if self.static_head >= self.head:
            raise refused(self, "static_head", "must be smaller than the head of the operating point")
        if self.closed_valve_head <= self.head:
            raise refused(self, "closed_valve_head", "must be larger than the head of the operating point")
        return self

    def defaults_taken(self) -> Iterator[tuple[str, Declaration, Any]]:
        """As in the base, without those that do not count here."""
        idle = set() if self.static_head else {"closed_valve_torque"}
        if self.rated_power is not None:
            idle.add("density")
        yield from (found for found in super().defaults_taken() if found[0] not in idle)

    def load_at_shaft(self, motion: MotionProfile, environment: Environment, sheet: Sheet) -> Load:
        """Load cycle at the shaft of the pump; flow and head at the highest speed."""
        found = super().load_at_shaft(motion, environment, sheet)
        if self.volume_flow is not None and self.head is not None and motion.max_speed:
            with sheet.section("Flow at the highest speed"):
                flow = self._record_flow(sheet, motion.max_speed, "highest_")
                sheet(formulas.head_of_system, H_st=self.static_head, H=self.head, Q=flow, Q_r=self.volume_flow)
        return found

    @property
    def _closed_head(self) -> float:
        """H_0; without a static head it does not matter, so any value above none will do [m]."""
        return self.closed_valve_head or 1.0

    def _flow(self, speed: Any) -> Any:
        """Flow at a speed, as a share of that of the operating point."""
        return formulas.flow_at_speed(1.0, self._closed_head, self.static_head, speed, self.rated_speed)

    def torque(self, speed: Any, rated: float, gravity: float) -> Any:
        """Steady torque at an unsigned speed [N m]."""
        return formulas.pump_torque(rated, self.friction_torque, self._closed_torque, self._flow(speed), 1.0, speed,
                                    self.rated_speed)  # fmt: skip

    @property
    def _closed_torque(self) -> float:
        """k_0; without a static head flow and speed go together, so that it has no effect."""
        return self.closed_valve_torque if self.static_head else 0.0

    def record_torque(self, sheet: Sheet, speed: float, rated: float, gravity: float, prefix: str) -> float:
        """The same on the sheet."""
        if not self.static_head:
            return sheet(formulas.affine_torque, key=f"{prefix}pump_torque", M_N=rated, M_f=self.friction_torque,
                         n=speed, n_W=self.rated_speed)  # fmt: skip
        flow = self._record_flow(sheet, speed, prefix)
        return sheet(formulas.pump_torque, key=f"{prefix}pump_torque", M_N=rated, M_f=self.friction_torque,
                     k_0=self.closed_valve_torque, Q=flow, Q_r=self.volume_flow or 1.0, n=speed,
                     n_W=self.rated_speed)  # fmt: skip

    def _record_flow(self, sheet: Sheet, speed: float, prefix: str) -> float:
        return sheet(formulas.flow_at_speed, key=f"{prefix}flow", Q=self.volume_flow or 1.0, H_0=self._closed_head,
                     H_st=self.static_head, n=speed, n_W=self.rated_speed)  # fmt: skip

    def power(self, gravity: float) -> float:
        """Power of the operating point [W]."""
        return float(formulas.pump_power(self.volume_flow, self.head, self.density, gravity, self.pump_efficiency))

    def record_power(self, sheet: Sheet, gravity: float) -> float:
        """The same on the sheet."""
        return sheet(formulas.pump_power, Q=self.volume_flow, H=self.head, rho=self.density, g=gravity,
                     eta_P=self.pump_efficiency)  # fmt: skip
