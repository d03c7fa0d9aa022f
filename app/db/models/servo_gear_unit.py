"""Servo gear units."""

from typing import ClassVar

from sqlalchemy.orm import Mapped

from app.db.base import Base
from app.db.columns import count, number, text
from app.db.models.product import ProductColumns


class ServoGearUnit(ProductColumns, Base):
    """One ratio of one low-backlash gear unit."""

    __tablename__ = "servo_gear_unit"
    title: ClassVar[str] = "Servo gear units"

    kind: Mapped[str | None] = text("Kind", 16, choices=("planetary", "right_angle", "strain_wave", "cycloidal"))
    stages: Mapped[int | None] = count("Stages", low=1, high=10)
    ratio: Mapped[float | None] = number("1", "Ratio", symbol="i", about="Input by output speed", low=0.01, high=1e5)
    nominal_torque_nm: Mapped[float | None] = number(
        "N m", "Nominal torque", symbol="T_2N", about="Continuous output torque", low=0.001, high=1e7
    )
    acceleration_torque_nm: Mapped[float | None] = number(
        "N m", "Acceleration torque", symbol="T_2B", about="Output torque in cyclic operation", low=0.001, high=1e7
    )
    emergency_torque_nm: Mapped[float | None] = number(
        "N m", "Emergency torque", symbol="T_2Not", about="Output torque in rare emergencies", low=0.001, high=1e7
    )
    nominal_input_speed_rpm: Mapped[float | None] = number(
        "rpm", "Nominal input speed", symbol="n_1N", about="Permitted mean input speed", low=1, high=50_000
    )
    max_input_speed_rpm: Mapped[float | None] = number(
        "rpm", "Maximum input speed", symbol="n_1max", low=1, high=50_000
    )
    efficiency: Mapped[float | None] = number("1", "Efficiency", symbol="eta", about="At full load", low=0.05, high=1)
    backlash_arcmin: Mapped[float | None] = number(
        "arcmin", "Backlash", symbol="phi", about="Torsional backlash at the output", low=0, high=600
    )
    torsional_stiffness_nm_arcmin: Mapped[float | None] = number(
        "N m/arcmin", "Torsional stiffness", symbol="C_t", about="At the output", low=0.001, high=1e6
    )
    inertia_kgcm2: Mapped[float | None] = number(
        "kg cm2", "Inertia", symbol="J_G", about="Referred to the input shaft", low=1e-6, high=1e7
    )
    max_radial_force_n: Mapped[float | None] = number(
        "N", "Radial force", symbol="F_R", about="Permitted at the output shaft", low=0.1, high=1e8
    )
    max_axial_force_n: Mapped[float | None] = number(
        "N", "Axial force", symbol="F_A", about="Permitted at the output shaft", low=0.1, high=1e8
    )
    mass_kg: Mapped[float | None] = number("kg", "Mass", symbol="m", low=0.001, high=50_000)
