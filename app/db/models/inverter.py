"""Frequency inverters."""

from typing import ClassVar

from sqlalchemy.orm import Mapped

from app.db.base import Base
from app.db.columns import number, text
from app.db.models.product import ProductColumns
from app.db.models.servo_drive import PHASES


class Inverter(ProductColumns, Base):
    """One frequency inverter in one rating (the note says which: heavy duty, normal duty ...)."""

    __tablename__ = "inverter"
    title: ClassVar[str] = "Inverters"

    supply_voltage_min_v: Mapped[float | None] = number("V", "Lowest supply voltage", low=20, high=20_000)
    supply_voltage_max_v: Mapped[float | None] = number("V", "Highest supply voltage", low=20, high=20_000)
    phases: Mapped[str | None] = text("Phases", 8, about="Phases of the supply", choices=PHASES)
    motor_power_kw: Mapped[float | None] = number(
        "kW", "Motor power", symbol="P_N", about="Rated power of the motor to be fed", low=0.01, high=50_000
    )
    rated_current_a: Mapped[float | None] = number(
        "A", "Rated current", symbol="I_N", about="Output current, rms", low=0.01, high=20_000
    )
    overload_current_a: Mapped[float | None] = number(
        "A", "Overload current", symbol="I_max", about="Output current for the overload time", low=0.01, high=50_000
    )
    overload_time_s: Mapped[float | None] = number("s", "Overload time", low=0.01, high=3600)
    min_braking_resistance_ohm: Mapped[float | None] = number(
        "ohm", "Lowest braking resistance", symbol="R_min", low=0.01, high=1e5
    )
