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


@dataclass(frozen=True, kw_only=True)
class Winding:
    """Rated data of one winding of an induction motor at one voltage and frequency."""

    poles: int
    """Number of poles (twice the pole pairs)"""
    frequency: float
    """[Hz]"""
    rated_power: float
    """P_N [W]"""
    rated_speed: float | None = None
    """n_N [rad/s]"""
    rated_torque: float | None = None
    """M_N [N m]; None: follows from power and speed"""
    voltage: float | None = None
    """[V]"""
    rated_current: float | None = None
    """I_N, rms [A]"""
    power_factor: float | None = None
    efficiency: float | None = None
    """At rated load, 0 to 1"""
    starting_torque_ratio: float | None = None
    """M_A / M_N"""
    run_up_torque_ratio: float | None = None
    """M_H / M_N, mean over the run-up"""
    run_up_torque: float | None = None
    """M_H [N m] where the source gives it itself"""
    breakdown_torque_ratio: float | None = None
    """M_K / M_N"""
    starting_current_ratio: float | None = None
    """I_A / I_N"""
    no_load_starting_frequency: float | None = None
    """Z_0: permitted starts without load [1/s]"""


@dataclass(frozen=True, kw_only=True)
class InductionMotor(Product):
    """A three-phase cage motor; a pole-changing one has two windings, the low-speed one (most poles) first."""

    windings: tuple[Winding, ...]
    rotor_inertia: float | None = None
    """J_M without brake [kg m2]"""
    rotor_inertia_with_brake: float | None = None
    """J_M with brake [kg m2]"""
    mass: float | None = None
    """[kg]"""
    frame_size: float | None = None
    """Shaft height H (IEC 60072) [m]"""


@dataclass(frozen=True, kw_only=True)
class MotorBrake(Product):
    """A spring-applied brake on the motor."""

    fits_motor: str = ""
    torque: float | None = None
    """M_B [N m]"""
    min_torque: float | None = None
    """Lowest setting [N m]"""
    inertia: float | None = None
    """[kg m2]"""
    work_until_adjustment: float | None = None
    """W_N [J]"""
    max_work_per_operation: float | None = None
    """[J]"""
    release_time: float | None = None
    """t_1 [s]"""
    application_time_ac: float | None = None
    """t_2, cut off in the AC circuit [s]"""
    application_time_dc: float | None = None
    """t_2, cut off in the DC and AC circuit [s]"""


@dataclass(frozen=True, kw_only=True)
class GearUnit(Product):
    """One ratio of an industrial gear unit."""

    kind: str | None = None
    """``helical``, ``worm`` ... as the source says."""
    ratio: float
    """i = n_in / n_out"""
    stages: int | None = None
    max_output_torque: float | None = None
    """M_a,max [N m]"""
    reference_input_speed: float | None = None
    """Input speed that the torque holds for [rad/s]"""
    max_input_speed: float | None = None
    """[rad/s]"""
    efficiency: float | None = None
    """0 to 1"""
    permissible_overhung_load: float | None = None
    """F_Ra, at the middle of the shaft end [N]"""
    service_factor: float | None = None
    """f_B that the source prints with the torque."""
    inertia: float | None = None
    """Referred to the input shaft [kg m2]"""
    backlash: float | None = None
    """[rad] at the output"""
    mass: float | None = None
    """[kg]"""


@dataclass(frozen=True, kw_only=True)
class Inverter(Product):
    """One frequency inverter."""

    supply_voltage: float | None = None
    phases: int | None = None
    motor_power: float | None = None
    """Recommended motor [W]"""
    rated_current: float | None = None
    """rms [A]"""
    overload_current: float | None = None
    """rms [A]"""
    overload_time: float | None = None
    """How long the overload current may flow [s]"""
    min_braking_resistance: float | None = None
    """[ohm]"""


@dataclass(frozen=True, kw_only=True)
class BrakingResistor(Product):
    """One braking resistor with its rating by duty."""

    resistance: float | None = None
    """[ohm]"""
    ratings: tuple[tuple[float, float], ...] = ()
    """Points (duty from 0 to 1, permitted power [W]) by rising duty, as listed."""
    duty_cycle_time: float | None = None
    """Time that the duty refers to [s]"""
    peak_power: float | None = None
    """[W]"""
    pulse_energy: float | None = None
    """[J]"""
    mass: float | None = None
    """[kg]"""
