"""One drive on one load, as the criteria of the rule sets look at it."""

from dataclasses import dataclass

from app.engine.drives.limits import ServoLimits
from app.engine.drives.rules import CHECK_NAMES, ServoRules
from app.engine.drives.shaft import MotorShaft
from app.engine.mechanisms.load import Load
from app.engine.products import ServoMotor
from app.engine.sheet import Sheet


@dataclass(frozen=True)
class ServoCase:
    """Everything that the criteria of a rule set look at."""

    load: Load
    motor: ServoMotor | None
    rules: ServoRules
    shaft: MotorShaft
    rotor: float | None
    """Rotor inertia [kg m2]; None where the source gives none, 0 where no motor is chosen."""
    torque_missing: str
    """What lacks for torques that include the rotor; empty when nothing does."""
    limits: ServoLimits | None
    """Limits of the motor; None where no motor is chosen."""
    needs_brake: bool

    def check(
        self,
        sheet: Sheet,
        key: str,
        demand: tuple[float | None, str],
        limit: tuple[float | None, str],
        unit: str,
        source: str,
    ) -> None:
        """Record a check; ``demand`` and ``limit`` are values (SI) with what lacks where they are None."""
        lacking = [name for value, name in (demand, limit) if value is None]
        sheet.check(key, CHECK_NAMES[key], demand[0], limit[0], unit, source, missing=", ".join(lacking))

    def check_holding(self, sheet: Sheet, demanded: float) -> None:
        """Check the brake of the motor against the torque that holds the axis, where a brake is needed."""
        if self.motor is not None and self.needs_brake:
            limit = (self.motor.brake_torque, "brake torque of the motor")
            self.check(sheet, "holding_brake", (demanded, ""), limit, "N m", "motor: data sheet, built-in brake")
