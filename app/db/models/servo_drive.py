"""Servo drives."""

from typing import ClassVar

from sqlalchemy.orm import Mapped

from app.db.base import Base
from app.db.columns import number, text
from app.db.models.product import ProductColumns

PHASES = ("1", "3", "1 or 3")


class ServoDrive(ProductColumns, Base):
    """One servo amplifier (or one axis of it)."""

    __tablename__ = "servo_drive"
    title: ClassVar[str] = "Servo drives"

    supply: Mapped[str | None] = text(
        "Supply", 2, about="Whether the voltage is that of the AC mains or of the DC bus", choices=("ac", "dc")
    )
    supply_voltage_min_v: Mapped[float | None] = number("V", "Lowest supply voltage", low=5, high=2000)
    supply_voltage_max_v: Mapped[float | None] = number("V", "Highest supply voltage", low=5, high=2000)
    phases: Mapped[str | None] = text("Phases", 8, about="Phases of the supply", choices=PHASES)
    continuous_current_a: Mapped[float | None] = number(
        "A", "Continuous current", symbol="I_N", about="Output current, rms", low=0.01, high=5000
    )
    peak_current_a: Mapped[float | None] = number(
        "A", "Peak current", symbol="I_max", about="Output current for a short time, rms", low=0.01, high=15_000
    )
    peak_time_s: Mapped[float | None] = number(
        "s", "Peak time", symbol="t_max", about="How long the peak current may flow", low=0.001, high=3600
    )
    motor_power_kw: Mapped[float | None] = number(
        "kW", "Motor power", symbol="P_N", about="Rated power of the motor to be fed", low=0.001, high=5000
    )
