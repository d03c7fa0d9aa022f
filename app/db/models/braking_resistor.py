"""Braking resistors."""

from typing import ClassVar

from sqlalchemy.orm import Mapped

from app.db.base import Base
from app.db.columns import number
from app.db.models.product import ProductColumns


class BrakingResistor(ProductColumns, Base):
    """One braking resistor with the power it takes at the duty ratios that the source lists."""

    __tablename__ = "braking_resistor"
    title: ClassVar[str] = "Braking resistors"

    resistance_ohm: Mapped[float] = number("ohm", "Resistance", symbol="R", low=0.01, high=1e5)
    power_100_kw: Mapped[float | None] = number(
        "kW", "Power at 100 %", about="Continuous power", low=0.001, high=10_000
    )
    power_50_kw: Mapped[float | None] = number("kW", "Power at 50 %", about="At 50 % duty", low=0.001, high=10_000)
    power_40_kw: Mapped[float | None] = number("kW", "Power at 40 %", about="At 40 % duty", low=0.001, high=10_000)
    power_25_kw: Mapped[float | None] = number("kW", "Power at 25 %", about="At 25 % duty", low=0.001, high=10_000)
    power_15_kw: Mapped[float | None] = number("kW", "Power at 15 %", about="At 15 % duty", low=0.001, high=10_000)
    power_12_kw: Mapped[float | None] = number("kW", "Power at 12 %", about="At 12 % duty", low=0.001, high=10_000)
    power_10_kw: Mapped[float | None] = number("kW", "Power at 10 %", about="At 10 % duty", low=0.001, high=10_000)
    power_6_kw: Mapped[float | None] = number("kW", "Power at 6 %", about="At 6 % duty", low=0.001, high=10_000)
    duty_cycle_time_s: Mapped[float | None] = number(
        "s", "Cycle time", about="Longest cycle over which the duty may be counted", low=1, high=3600
    )
    peak_power_kw: Mapped[float | None] = number("kW", "Peak power", low=0.001, high=100_000)
    pulse_energy_kj: Mapped[float | None] = number(
        "kJ", "Pulse energy", about="Energy that a single braking may bring", low=0.001, high=1e6
    )
    mass_kg: Mapped[float | None] = number("kg", "Mass", symbol="m", low=0.001, high=10_000)
