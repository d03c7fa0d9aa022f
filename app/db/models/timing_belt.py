"""Timing belts."""

from typing import ClassVar

from sqlalchemy.orm import Mapped

from app.db.base import Base
from app.db.columns import number
from app.db.models.product import ProductColumns


class TimingBelt(ProductColumns, Base):
    """One width of one belt profile; ``model`` is the profile."""

    __tablename__ = "timing_belt"
    title: ClassVar[str] = "Timing belts"
    key: ClassVar[tuple[str, ...]] = ("model", "width_mm")

    pitch_mm: Mapped[float | None] = number("mm", "Pitch", symbol="p_b", low=0.1, high=200)
    width_mm: Mapped[float] = number("mm", "Width", symbol="b", low=0.1, high=2000)
    permissible_tensile_force_n: Mapped[float | None] = number(
        "N", "Tensile force", symbol="F_zul", about="Permitted force in the belt", low=0.1, high=1e7
    )
    mass_per_length_kg_m: Mapped[float | None] = number("kg/m", "Mass per length", low=1e-5, high=1000)
