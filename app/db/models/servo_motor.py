"""Servo motors."""

from typing import ClassVar

from sqlalchemy.orm import Mapped

from app.db.base import Base
from app.db.columns import count, number, text
from app.db.models.product import ProductColumns


class ServoMotor(ProductColumns, Base):
    """One servo motor (one winding)."""

    __tablename__ = "servo_motor"
    title: ClassVar[str] = "Servo motors"

    kind: Mapped[str] = text(
        "Kind",
        12,
        about="Synchronous, asynchronous, torque motor, or brushless DC (block commutation)",
        choices=("sync", "async", "torque", "bldc"),
    )
    cooling: Mapped[str | None] = text("Cooling", 12, choices=("natural", "forced", "liquid"))
    supply: Mapped[str | None] = text(
        "Supply", 2, about="Whether the voltage is that of the AC mains or of the DC bus", choices=("ac", "dc")
    )
    supply_voltage_v: Mapped[float | None] = number("V", "Supply voltage", symbol="U", low=5, high=1500)
    rated_speed_rpm: Mapped[float | None] = number("rpm", "Rated speed", symbol="n_N", low=1, high=100_000)
    max_speed_rpm: Mapped[float | None] = number(
        "rpm", "Maximum speed", symbol="n_max", about="Highest speed, mechanical or by voltage", low=1, high=100_000
    )
    stall_torque_nm: Mapped[float | None] = number(
        "N m", "Stall torque", symbol="M_0", about="Continuous torque at standstill", low=0.001, high=100_000
    )
    rated_torque_nm: Mapped[float | None] = number(
        "N m", "Rated torque", symbol="M_N", about="Continuous torque at rated speed", low=0.001, high=100_000
    )
    peak_torque_nm: Mapped[float | None] = number("N m", "Peak torque", symbol="M_max", low=0.001, high=300_000)
    stall_current_a: Mapped[float | None] = number(
        "A", "Stall current", symbol="I_0", about="Current at stall torque, rms", low=0.01, high=5000
    )
    rated_current_a: Mapped[float | None] = number(
        "A", "Rated current", symbol="I_N", about="Current at rated torque, rms", low=0.01, high=5000
    )
    peak_current_a: Mapped[float | None] = number(
        "A", "Peak current", symbol="I_max", about="Current at peak torque, rms", low=0.01, high=15_000
    )
    rated_power_kw: Mapped[float | None] = number("kW", "Rated power", symbol="P_N", low=0.001, high=2000)
    rotor_inertia_kgcm2: Mapped[float | None] = number(
        "kg cm2", "Rotor inertia", symbol="J_M", about="Rotor without brake", low=1e-5, high=1e7
    )
    rotor_inertia_with_brake_kgcm2: Mapped[float | None] = number(
        "kg cm2", "Rotor inertia with brake", symbol="J_MB", about="Rotor with holding brake", low=1e-5, high=1e7
    )
    brake_torque_nm: Mapped[float | None] = number(
        "N m", "Brake torque", symbol="M_B", about="Holding torque of the built-in brake", low=0.001, high=100_000
    )
    mass_kg: Mapped[float | None] = number("kg", "Mass", symbol="m", low=0.001, high=50_000)
    flange_size_mm: Mapped[float | None] = number("mm", "Flange size", low=1, high=2000)
    torque_constant_nm_a: Mapped[float | None] = number(
        "N m/A", "Torque constant", symbol="k_T", about="Torque per ampere rms", low=1e-4, high=1000
    )
    voltage_constant_vs_rad: Mapped[float | None] = number(
        "V s/rad",
        "Voltage constant",
        symbol="k_E",
        about="Voltage by speed, as the source defines it",
        low=1e-4,
        high=1000,
    )
    winding_resistance_ohm: Mapped[float | None] = number("ohm", "Winding resistance", symbol="R", low=1e-5, high=1e5)
    winding_inductance_mh: Mapped[float | None] = number("mH", "Winding inductance", symbol="L", low=1e-4, high=1e5)
    pole_pairs: Mapped[int | None] = count("Pole pairs", symbol="p", low=1, high=200)
