"""Ball screws."""

from typing import ClassVar

from sqlalchemy.orm import Mapped

from app.db.base import Base
from app.db.columns import number
from app.db.models.product import ProductColumns


class BallScrew(ProductColumns, Base):
    """One nut on its screw."""

    __tablename__ = "ball_screw"
    title: ClassVar[str] = "Ball screws"

    nominal_diameter_mm: Mapped[float] = number("mm", "Nominal diameter", symbol="d_0", low=1, high=500)
    ball_pitch_diameter_mm: Mapped[float | None] = number("mm", "Ball pitch diameter", symbol="d_pw", low=1, high=500)
    root_diameter_mm: Mapped[float | None] = number(
        "mm", "Root diameter", symbol="d_2", about="Core of the screw", low=0.5, high=500
    )
    lead_mm: Mapped[float] = number("mm", "Lead", symbol="P_h", about="Travel per turn", low=0.1, high=500)
    dynamic_load_n: Mapped[float | None] = number(
        "N", "Dynamic load rating", symbol="C_a", about="Basic dynamic axial load rating", low=1, high=1e8
    )
    static_load_n: Mapped[float | None] = number(
        "N", "Static load rating", symbol="C_0a", about="Basic static axial load rating", low=1, high=1e8
    )
    dn_max_mmrpm: Mapped[float | None] = number(
        "mm rpm", "DN value", symbol="DN", about="Highest product of nominal diameter and speed", low=1000, high=1e6
    )
    max_speed_m_min: Mapped[float | None] = number("m/min", "Maximum speed", symbol="v_max", low=0.1, high=1000)
    axial_play_mm: Mapped[float | None] = number("mm", "Axial play", low=0, high=10)
    nut_mass_kg: Mapped[float | None] = number("kg", "Mass of the nut", low=0.001, high=10_000)
