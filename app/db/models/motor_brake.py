"""Brakes that are built onto motors."""

from typing import ClassVar

from sqlalchemy.orm import Mapped

from app.db.base import Base
from app.db.columns import number, text
from app.db.models.product import ProductColumns


class MotorBrake(ProductColumns, Base):
    """One spring-applied brake (at one torque setting) for the motors it is listed with."""

    __tablename__ = "motor_brake"
    title: ClassVar[str] = "Motor brakes"

    fits_motor: Mapped[str | None] = text("Fits", 200, about="Frame sizes or motors, separated by semicolons")
    brake_torque_nm: Mapped[float] = number(
        "N m",
        "Brake torque",
        symbol="M_B",
        about="Brake torque, the highest where it is adjustable",
        low=0.01,
        high=1e6,
    )
    min_brake_torque_nm: Mapped[float | None] = number(
        "N m", "Lowest brake torque", about="Lowest setting of an adjustable brake", low=0.01, high=1e6
    )
    inertia_kgm2: Mapped[float | None] = number("kg m2", "Inertia", symbol="J_B", low=1e-8, high=1e4)
    work_until_adjustment_mj: Mapped[float | None] = number(
        "MJ",
        "Work until adjustment",
        symbol="W_N",
        about="Friction work until the air gap must be set",
        low=0.1,
        high=1e6,
    )
    max_work_per_operation_j: Mapped[float | None] = number(
        "J", "Work per operation", about="Permitted friction work of one brake application", low=1, high=1e9
    )
    release_time_ms: Mapped[float | None] = number("ms", "Release time", symbol="t_1", low=0.1, high=10_000)
    application_time_ac_ms: Mapped[float | None] = number(
        "ms", "Application time, AC", symbol="t_2I", about="Switched off on the AC side", low=0.1, high=10_000
    )
    application_time_dc_ms: Mapped[float | None] = number(
        "ms", "Application time, DC", symbol="t_2II", about="Switched off on the AC and DC side", low=0.1, high=10_000
    )
