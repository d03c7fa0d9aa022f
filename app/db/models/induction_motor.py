"""Induction motors; a pole-changing motor is one motor with two operating points."""

from typing import ClassVar

from sqlalchemy.orm import Mapped

from app.db.base import Base
from app.db.columns import number, text
from app.db.models.product import ProductColumns


class InductionMotor(ProductColumns, Base):
    """One three-phase cage motor; what depends on the winding stands in its operating points."""

    __tablename__ = "induction_motor"
    title: ClassVar[str] = "Induction motors"
    key: ClassVar[tuple[str, ...]] = ("model", "variant")

    variant: Mapped[str | None] = text(
        "Variant", 40, about="Tells apart motors that the source prints under one order code", sort_order=-14
    )
    frame_size_mm: Mapped[float | None] = number(
        "mm", "Frame size", symbol="H", about="Shaft height (IEC 60072)", low=10, high=2000
    )
    rotor_inertia_kgm2: Mapped[float | None] = number(
        "kg m2", "Rotor inertia", symbol="J_M", about="Rotor without brake", low=1e-6, high=1e5
    )
    rotor_inertia_with_brake_kgm2: Mapped[float | None] = number(
        "kg m2", "Rotor inertia with brake", symbol="J_MB", about="Rotor with brake", low=1e-6, high=1e5
    )
    mass_kg: Mapped[float | None] = number("kg", "Mass", symbol="m", low=0.1, high=100_000)
