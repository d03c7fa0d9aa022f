"""Fan or blower: torque with the square of the speed."""

from typing import Annotated, Any, ClassVar, Literal, Self

from pydantic import model_validator

from app.engine.formulas import fluid as formulas
from app.engine.mechanisms.fluid import POINT, FluidMachine, consistent
from app.engine.quantity import Quantity
from app.engine.sheet import Sheet


class Fan(FluidMachine):
    """A fan. Its shaft is that of the impeller, or the input of a belt drive before it."""

    title: ClassVar[str] = "Fan"
    summary: ClassVar[str] = "Fan or blower: torque with the square of the speed, power with its cube."
    drawing: ClassVar[str] = "fan.svg"

    kind: Literal["fan"] = "fan"
    pressure: Annotated[
        float | None,
        Quantity("Pa", symbol="p_t", gt=0, le=1e7, default=None, group=POINT, about="total pressure"),
    ]
    fan_efficiency: Annotated[
        float | None,
        Quantity("1", symbol="eta_F", gt=0, le=1, default=None, group=POINT, about="efficiency of the fan"),
    ]

    @model_validator(mode="after")
    def _an_operating_point(self) -> Self:
        consistent(self, ("pressure", "fan_efficiency"))
        return self

    def torque(self, speed: Any, rated: float, gravity: float) -> Any:
        """Steady torque at an unsigned speed [N m]."""
        return formulas.affine_torque(rated, self.friction_torque, speed, self.rated_speed)

    def record_torque(self, sheet: Sheet, speed: float, rated: float, gravity: float, prefix: str) -> float:
        """The same on the sheet."""
        return sheet(formulas.affine_torque, key=f"{prefix}fan_torque", M_N=rated, M_f=self.friction_torque, n=speed,
                     n_W=self.rated_speed)  # fmt: skip

    def power(self, gravity: float) -> float:
        """Power of the operating point [W]."""
        return float(formulas.fan_power(self.volume_flow, self.pressure, self.fan_efficiency))

    def record_power(self, sheet: Sheet, gravity: float) -> float:
        """The same on the sheet."""
        return sheet(formulas.fan_power, Q=self.volume_flow, p_t=self.pressure, eta_F=self.fan_efficiency)
