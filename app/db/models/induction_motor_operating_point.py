"""Operating points of induction motors."""

from sqlalchemy import ForeignKey, UniqueConstraint
from sqlalchemy.orm import Mapped, mapped_column

from app.db.base import Base
from app.db.columns import count, number, text


class InductionMotorOperatingPoint(Base):
    """Rated data of one winding of an induction motor at one voltage and frequency."""

    __tablename__ = "induction_motor_operating_point"
    __table_args__ = (UniqueConstraint("motor_id", "position"),)

    id: Mapped[int] = mapped_column(primary_key=True)
    motor_id: Mapped[int] = mapped_column(
        ForeignKey("induction_motor.id", ondelete="CASCADE"), comment="Motor the point belongs to"
    )
    position: Mapped[int] = mapped_column(comment="1 for the first point as printed, 2 for the next")
    winding: Mapped[str | None] = text(
        "Winding", 4, about="Low-speed or high-speed winding of a pole-changing motor", choices=("low", "high")
    )
    poles: Mapped[int] = count("Poles", symbol="2p", about="Number of poles (twice the pole pairs)", low=2, high=96)
    efficiency_class: Mapped[str | None] = text(
        "Class", 4, about="Efficiency class (IEC 60034-30-1)", choices=("IE1", "IE2", "IE3", "IE4", "IE5")
    )
    rated_power_kw: Mapped[float] = number("kW", "Rated power", symbol="P_N", low=0.001, high=50_000)
    voltage_v: Mapped[float | None] = number("V", "Voltage", symbol="U", low=20, high=20_000)
    frequency_hz: Mapped[float] = number("Hz", "Frequency", symbol="f", low=1, high=1000)
    rated_speed_rpm: Mapped[float | None] = number("rpm", "Rated speed", symbol="n_N", low=1, high=60_000)
    rated_torque_nm: Mapped[float | None] = number("N m", "Rated torque", symbol="M_N", low=0.001, high=1e6)
    rated_current_a: Mapped[float | None] = number("A", "Rated current", symbol="I_N", low=0.01, high=20_000)
    power_factor: Mapped[float | None] = number("1", "Power factor", symbol="cos phi", low=0.1, high=1)
    efficiency_100_percent: Mapped[float | None] = number(
        "%", "Efficiency", symbol="eta", about="Efficiency at rated load", low=5, high=100
    )
    efficiency_75_percent: Mapped[float | None] = number(
        "%", "Efficiency at 3/4 load", about="Efficiency at three quarters of the rated load", low=5, high=100
    )
    efficiency_50_percent: Mapped[float | None] = number(
        "%", "Efficiency at 1/2 load", about="Efficiency at half the rated load", low=5, high=100
    )
    starting_torque_ratio: Mapped[float | None] = number(
        "1", "Starting torque", symbol="M_A/M_N", about="Locked-rotor torque by rated torque", low=0.1, high=15
    )
    run_up_torque_ratio: Mapped[float | None] = number(
        "1", "Run-up torque", symbol="M_H/M_N", about="Mean run-up torque by rated torque", low=0.1, high=15
    )
    run_up_torque_nm: Mapped[float | None] = number(
        "N m", "Run-up torque", symbol="M_H", about="Mean run-up torque", low=0.001, high=1e6
    )
    breakdown_torque_ratio: Mapped[float | None] = number(
        "1", "Breakdown torque", symbol="M_K/M_N", about="Breakdown torque by rated torque", low=1, high=15
    )
    starting_current_ratio: Mapped[float | None] = number(
        "1", "Starting current", symbol="I_A/I_N", about="Locked-rotor current by rated current", low=1, high=20
    )
    no_load_starting_frequency_per_h: Mapped[float | None] = number(
        "1/h", "No-load starting frequency", symbol="Z_0", about="Permitted starts per hour, no load", low=1, high=1e6
    )
