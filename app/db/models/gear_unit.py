"""Gear units of line-fed and inverter-fed drives."""

from typing import ClassVar

from sqlalchemy.orm import Mapped

from app.db.base import Base
from app.db.columns import count, number, text
from app.db.models.product import ProductColumns


class GearUnit(ProductColumns, Base):
    """One ratio of one gear unit; one whose ratio or torque the source does not print cannot be selected."""

    __tablename__ = "gear_unit"
    title: ClassVar[str] = "Gear units"

    kind: Mapped[str | None] = text(
        "Kind", 16, choices=("helical", "parallel_shaft", "bevel", "worm", "helical_worm", "planetary")
    )
    stages: Mapped[int | None] = count("Stages", low=1, high=10)
    ratio: Mapped[float | None] = number("1", "Ratio", symbol="i", about="Input by output speed", low=0.01, high=1e5)
    max_output_torque_nm: Mapped[float | None] = number(
        "N m", "Output torque", symbol="M_a max", about="Permitted torque at the output", low=0.1, high=1e7
    )
    torque_basis: Mapped[str | None] = text(
        "Torque is",
        16,
        about="The limit of the gear unit's size, or the torque of one geared motor at the stated service factor",
        choices=("size", "geared_motor"),
    )
    service_factor: Mapped[float | None] = number(
        "1", "Service factor", symbol="f_B", about="Service factor at which the torque is stated", low=0.1, high=20
    )
    reference_input_speed_rpm: Mapped[float | None] = number(
        "rpm", "Reference speed", symbol="n_1", about="Input speed at which the torque is stated", low=1, high=50_000
    )
    max_input_speed_rpm: Mapped[float | None] = number("rpm", "Maximum input speed", symbol="n_max", low=1, high=50_000)
    efficiency: Mapped[float | None] = number("1", "Efficiency", symbol="eta", low=0.05, high=1)
    permissible_overhung_load_n: Mapped[float | None] = number(
        "N", "Overhung load", symbol="F_Ra", about="Permitted radial force at the output shaft", low=0.1, high=1e8
    )
    inertia_kgm2: Mapped[float | None] = number(
        "kg m2", "Inertia", symbol="J_G", about="Referred to the input shaft", low=1e-8, high=1e4
    )
    mass_kg: Mapped[float | None] = number("kg", "Mass", symbol="m", low=0.01, high=200_000)
