"""Catalogue products as the engine sees them: frozen records in SI units.

The catalogue keeps each row in the units that the data sheet prints; the repository converts once and hands these
records to the engine. ``None`` always means that the source does not say: a check that needs such a value is
``not_checked``, never guessed.
"""

from dataclasses import dataclass


@dataclass(frozen=True, kw_only=True)
class Product:
    """What every product carries: who makes it, what it is called and where its values were read."""

    id: str
    """Stable identifier ``servo-motor:<maker>:<edition>:<order code>``; ``"own"`` for a row that the user typed."""
    manufacturer: str
    series: str
    model: str
    source: str
    """Document and page of the values, as shown to the reader."""
    note: str = ""

    @property
    def name(self) -> str:
        """Maker and model in one line."""
        return f"{self.manufacturer} {self.model}".strip()


@dataclass(frozen=True, kw_only=True)
class ServoMotor(Product):
    """One servo motor, synchronous or asynchronous, as its data sheet describes it."""

    kind: str = "sync"
    """``sync``, ``async`` or ``torque`` as the source says."""
    cooling: str | None = None
    rated_speed: float | None = None
    """n_N [rad/s]"""
    max_speed: float | None = None
    """n_max, mechanical or voltage limit [rad/s]"""
    stall_torque: float | None = None
    """M_0, continuous at standstill [N m]"""
    rated_torque: float | None = None
    """M_N, continuous at rated speed [N m]"""
    peak_torque: float | None = None
    """M_max [N m]"""
    stall_current: float | None = None
    """I_0, rms [A]"""
    rated_current: float | None = None
    """I_N, rms [A]"""
    peak_current: float | None = None
    """I_max, rms [A]"""
    rated_power: float | None = None
    """P_N [W]"""
    rotor_inertia: float | None = None
    """J_M without brake [kg m2]"""
    rotor_inertia_with_brake: float | None = None
    """J_M with holding brake [kg m2]"""
    brake_torque: float | None = None
    """Holding torque of the built-in brake [N m]"""
    mass: float | None = None
    """[kg]"""
    torque_constant: float | None = None
    """k_T [N m / A rms]"""
    peak_curve: tuple[tuple[float, float], ...] = ()
    """Points (speed [rad/s], torque [N m]) of the peak curve where the source gives them, by rising speed."""
    continuous_curve: tuple[tuple[float, float], ...] = ()
    """Points (speed [rad/s], torque [N m]) of the S1 curve where the source gives them, by rising speed."""


@dataclass(frozen=True, kw_only=True)
class ServoGearUnit(Product):
    """One ratio of a low-backlash gear unit."""

    ratio: float
    """i = n_in / n_out"""
    stages: int | None = None
    nominal_torque: float | None = None
    """T_2N at the output [N m]"""
    acceleration_torque: float | None = None
    """T_2B at the output, in normal operation [N m]"""
    emergency_torque: float | None = None
    """T_2Not at the output [N m]"""
    nominal_input_speed: float | None = None
    """Permitted mean input speed [rad/s]"""
    max_input_speed: float | None = None
    """Permitted highest input speed [rad/s]"""
    efficiency: float | None = None
    """At full load, 0 to 1"""
    backlash: float | None = None
    """[rad] at the output"""
    torsional_stiffness: float | None = None
    """[N m/rad] at the output"""
    inertia: float | None = None
    """Referred to the input shaft [kg m2]"""
    max_radial_force: float | None = None
    """[N]"""
    max_axial_force: float | None = None
    """[N]"""
    mass: float | None = None
    """[kg]"""


@dataclass(frozen=True, kw_only=True)
class ServoDrive(Product):
    """One servo amplifier."""

    supply_voltage: float | None = None
    phases: int | None = None
    continuous_current: float | None = None
    """rms [A]"""
    peak_current: float | None = None
    """rms [A]"""
    peak_time: float | None = None
    """How long the peak current may flow [s]"""
    motor_power: float | None = None
    """[W]"""
