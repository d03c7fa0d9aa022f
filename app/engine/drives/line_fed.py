"""What line-fed and pole-changing motors share: parts, states of load on the motor shaft, static power, holding."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from app.engine.drives.base import Given
from app.engine.drives.gear_service import GearCase, check_load_speed, record_gear_service
from app.engine.drives.mains_motion import Brake
from app.engine.drives.mains_rules import CHECK_NAMES, BrakingRules, MotorRules
from app.engine.drives.mains_shaft import Gravity, MotorSide
from app.engine.drives.parts import not_below
from app.engine.environment import RATED_ALTITUDE, RATED_AMBIENT, Environment
from app.engine.errors import EngineError
from app.engine.formulas import induction as run
from app.engine.formulas.braking import brake_torque_ratio
from app.engine.formulas.conversion import sum_of_torques, torque_before_ratio, travel_before_ratio
from app.engine.formulas.efficiency import driving_stage_torque, retrograde_efficiency, returning_stage_torque
from app.engine.formulas.servo import shaft_power
from app.engine.mechanisms.load import Load
from app.engine.products import GearUnit, InductionMotor, MotorBrake, Winding
from app.engine.sheet import Sheet

HELICAL_EFFICIENCY = 0.95
HELICAL_SOURCE = "SEW 2001, 8.1: mean of two- and three-stage helical gear units"


@dataclass(frozen=True)
class MotorData:
    """One winding, ready to calculate with."""

    winding: Winding
    rated_speed: float
    synchronous_speed: float
    rated_torque: float
    run_up: float | None
    """Mean run-up torque M_H as it is started, in star a third [N m]; None where the source does not give it."""
    full_run_up: float | None
    """The same as it is connected in steady running [N m]"""

    @property
    def star(self) -> bool:
        """Whether it runs up in star."""
        return self.run_up != self.full_run_up


@dataclass(frozen=True, kw_only=True)
class LineFed:
    """Parts and load of one line-fed drive."""

    rules: MotorRules
    load: Load
    environment: Environment
    motor: InductionMotor | None
    gear: GearUnit | None
    brake_product: MotorBrake
    brake: Brake | None
    """None where no brake is chosen, or its application time is not known."""
    gear_efficiency: float
    motor_inertia: float | None
    """With brake where there is one [kg m2]"""

    @classmethod
    def of(cls, rules: MotorRules, given: Given, sheet: Sheet) -> "LineFed":
        """Join what was chosen, and put on the sheet what had to be assumed for it."""
        motor, gear, brake = given.product("motor"), given.product("gear_unit"), given.product("brake")
        if gear is None:
            sheet.decide("The motor drives the load directly", "no gear unit is given")
        return cls(
            rules=rules, load=given.load, environment=given.environment, motor=motor, gear=gear,
            brake_product=brake or MotorBrake(id="", manufacturer="", series="", model="", source=""),
            brake=brake_of(rules, brake, sheet), gear_efficiency=_gear_efficiency(rules, gear, sheet),
            motor_inertia=None if motor is None else motor_inertia_of(motor, brake, sheet),
        )  # fmt: skip

    @property
    def ratio(self) -> float:
        """i = n_motor / n_output; 1 where the motor drives directly."""
        return 1.0 if self.gear is None else self.gear.ratio

    @property
    def hangs(self) -> bool:
        """Whether gravity moves the axis when nothing holds it."""
        largest = max(abs(self.load.statics.forward), abs(self.load.statics.backward), 1e-12)
        return abs(self.load.statics.holding) > 1e-9 * largest

    @property
    def gravity(self) -> Gravity | None:
        """What pulls at the load while nothing holds it; None where nothing does."""
        return Gravity(self.load.states, self.load.statics) if self.hangs else None

    @property
    def cycle_time(self) -> float:
        """[s]"""
        return self.load.cycle.cycle_time

    def sides(self) -> list[MotorSide]:
        """Every state of the load on the motor shaft."""
        added = self.rules.flywheel_inertia + ((self.gear.inertia or 0.0) if self.gear else 0.0)
        return [
            MotorSide(
                state=state, ratio=self.ratio, gear_efficiency=self.gear_efficiency,
                motor_inertia=self.motor_inertia or 0.0, added_inertia=added, model=self.environment.regeneration,
            )
            for state in self.load.states
        ]  # fmt: skip

    def record_static(self, side: MotorSide, data: MotorData | None, sheet: Sheet) -> float:
        """Write efficiency and power in steady running [W, unsigned]."""
        key, eta = side.state.key, side.efficiency
        if not sheet.has("total_efficiency"):
            if side.state.travel is not None:
                label = "Way of the load per radian of the motor shaft"
                sheet(
                    travel_before_ratio, key="travel_per_motor_radian", label=label, A=side.state.travel, i=side.ratio
                )
            sheet(run.total_efficiency, eta_L=side.state.efficiency, eta_G=self.gear_efficiency)
            sheet(retrograde_efficiency, eta=eta)
        label = "Torque of the load with losses, in steady running"
        if side.driven_by_load:
            torque = sheet(returning_stage_torque, key=f"{key}_static_torque", symbol="M_S", label=label,
                           T=side.load_torque, eta_r=side.factor(driving=False))  # fmt: skip
        else:
            torque = sheet(driving_stage_torque, key=f"{key}_static_torque", symbol="M_S", label=label,
                           T=side.load_torque, eta=eta)  # fmt: skip
        speed = side.state.speed * side.ratio
        power = sheet(shaft_power, key=f"{key}_static_power", symbol="P_S", unit="W",
                      label="Power in steady running at the motor shaft", M=abs(torque), omega=speed)  # fmt: skip
        limit = side.state.permissible_acceleration
        if limit is not None and not side.driven_by_load:
            alpha = limit / (side.state.travel or 1.0)
            net = (side.state.torque + side.state.inertia * alpha) / side.ratio
            total = sheet(driving_stage_torque, key=f"{key}_torque_at_limit", symbol="M_T", T=net, eta=eta,
                          label="Torque at the permissible acceleration, without the motor itself")  # fmt: skip
            sheet(shaft_power, key=f"{key}_power_at_limit", symbol="P_T", unit="W", M=total, omega=speed,
                  label="Power at the permissible acceleration, without the motor")  # fmt: skip
        if data is not None:
            sheet(run.relative_static_power, key=f"{key}_relative_static_power", P_S=power,
                  P_N=data.winding.rated_power)  # fmt: skip
        return power

    def record_running(self, side: MotorSide, data: MotorData, speed: float, sheet: Sheet, name: str = "") -> MotorSide:
        """Write torque and power at the speed at which the motor itself runs [rad/s], whatever the motion asks for.

        A torque curve ends there: the load at that speed is returned. ``name`` goes into the keys.
        """
        own, key = side.at_speed(speed), f"{side.state.key}{name}"
        losses = own.factor(driving=not own.driven_by_load)
        label = "Torque of the load with losses, at the speed of the motor"
        if own.driven_by_load:
            torque = sheet(returning_stage_torque, key=f"{key}_running_torque", symbol="M_R", label=label,
                           T=own.load_torque, eta_r=losses)  # fmt: skip
        else:
            torque = sheet(driving_stage_torque, key=f"{key}_running_torque", symbol="M_R", label=label,
                           T=own.load_torque, eta=own.efficiency)  # fmt: skip
        power = sheet(shaft_power, key=f"{key}_running_power", symbol="P_R", unit="W", M=abs(torque), omega=speed,
                      label="Power in steady running at the speed of the motor")  # fmt: skip
        label = "Power at the speed of the motor over rated power, losses included"
        sheet(run.relative_static_power, key=f"{key}_relative_running_power", symbol="P_R/P_N", label=label, P_S=power,
              P_N=data.winding.rated_power)  # fmt: skip
        return own

    def check_power(self, data: MotorData | None, sheet: Sheet, *, low: MotorData | None = None) -> None:
        """Check the largest power in steady running against the rating, derated by the surroundings.

        ``low`` is the low-speed winding of a motor with two. The power is that at the motor's own speed.
        """
        if data is None or not self.load.states:
            return
        with sheet.section("Rating of the motor"):
            factors, missing = self._rating_factors(sheet)
            for name, winding in (("", data), ("_low", low)):
                if winding is None:
                    continue
                demanded = max(sheet.value(f"{state.key}{name}_running_power") for state in self.load.states)
                permitted: float | None = winding.winding.rated_power
                if factors is None:
                    permitted = None
                elif factors != (1.0, 1.0, 1.0):
                    f_T, f_H, K = factors
                    permitted = sheet(run.permitted_power, key=f"permitted_power{name}", P_N=permitted, f_T=f_T,
                                      f_H=f_H, K=K)  # fmt: skip
                sheet.check(f"static_power{name}", CHECK_NAMES[f"static_power{name}"], demanded, permitted, "kW",
                            "motor: data sheet, rated power", formula="shaft_power", missing=missing)  # fmt: skip

    def _power_increase(self, sheet: Sheet) -> float | None:
        """K of the duty type: the user's own, else read from the table; None where that does not reach so far."""
        given, text = self.rules.power_increase, "power increase factor of the duty type"
        match self.rules.duty_type:
            case "S2":  # by the longest time in operation
                minutes = max((state.duration for state in self.load.states), default=0.0) / 60
                return sheet.look_up("power_increase_s2", text, symbol="K", x=max(minutes, 10.0), given=given)
            case "S3":
                return sheet.look_up("power_increase_s3", text, symbol="K", x=max(self.duty * 100, 15.0), given=given)
        return given or 1.0

    def _rating_factors(self, sheet: Sheet) -> tuple[tuple[float, float, float] | None, str]:
        """Factors of temperature, altitude and duty type on the rated power, None with what lacks."""
        hot = self.environment.ambient_temperature > RATED_AMBIENT
        high = self.environment.altitude > RATED_ALTITUDE
        f_T: float | None = 1.0
        f_H: float | None = 1.0
        if hot:
            celsius = self.environment.ambient_temperature - 273.15
            text = "factor of the ambient temperature on the rated power"
            f_T = sheet.look_up("derating_f_t", text, symbol="f_T", x=celsius)
        if high:
            text = "factor of the altitude on the rated power"
            f_H = sheet.look_up("derating_f_h", text, symbol="f_H", x=self.environment.altitude)
        if f_T is None or f_H is None:
            return None, "factor of the surroundings on the rated power"
        K = self._power_increase(sheet)
        if K is None:
            return None, "power increase factor for this operating time"
        return (f_T, f_H, K), ""

    @property
    def duty(self) -> float:
        """Share of the cycle in motion, or as given."""
        if self.rules.duty is not None:
            return self.rules.duty
        return min(sum(state.duration for state in self.load.states) / self.cycle_time, 1.0)

    def record_gear_unit(
        self, data: MotorData, sides: Sequence[MotorSide], sheet: Sheet, *, highest_speed: float | None = None
    ) -> None:
        """Write and check what the gear unit bears behind this winding.

        ``highest_speed`` of the motor in operation [rad/s] where an inverter sets it.
        """
        if self.gear is None:
            if highest_speed is None:
                with sheet.section("Speed of the load"):
                    check_load_speed(self.load, self.rules, data.rated_speed, sheet, direct=True)
            return
        flywheel = self.rules.flywheel_inertia
        case = GearCase(
            gear=self.gear, service=self.rules, load=self.load, motor_speed=data.rated_speed,
            rated_torque=data.rated_torque, external_inertia=max((s.external_inertia for s in sides), default=None),
            motor_inertia=None if self.motor_inertia is None else self.motor_inertia + flywheel,
            efficiency=self.gear_efficiency, ambient=self.environment.ambient_temperature, duty=self.duty,
            run_up_torque=data.full_run_up, highest_speed=highest_speed,
        )  # fmt: skip
        record_gear_service(case, sheet)

    def check_holding(self, sheet: Sheet) -> None:
        """Check the brake against the torque that holds the load at standstill, where gravity pulls.

        The check is always there on such an axis: without a torque of the brake it is not made, and says so.
        """
        if not self.hangs:
            return
        with sheet.section("Brake"):
            label, M_B = "Torque that holds the load, on the motor shaft", self.brake_product.torque
            torque = sheet(torque_before_ratio, key="holding_torque_on_motor", symbol="M_hold", label=label,
                           M=self.load.statics.holding, i=self.ratio)  # fmt: skip
            if M_B is not None:
                sheet(brake_torque_ratio, M_B=M_B, M_L=torque)
                static = max(
                    (abs(sheet.value(f"{state.key}_static_torque")) for state in self.load.states), default=0.0
                )
                if static > 0:
                    label = "How often the brake has the largest steady torque of the motor"
                    sheet(brake_torque_ratio, key="brake_torque_to_static_torque", label=label, M_B=M_B, M_L=static)
            demanded = abs(torque) * self.rules.holding_reserve
            sheet.check("brake_holding", CHECK_NAMES["brake_holding"], demanded, M_B, "N m", "brake: data sheet",
                        formula="torque_before_ratio",
                        missing="" if M_B is not None else "brake with its torque")  # fmt: skip


def motor_data(
    line: LineFed, winding: Winding, sheet: Sheet, name: str = "", *, starts: bool = True, star: bool = False
) -> MotorData | None:
    """Torques and speeds of one winding; None where the source gives no rated speed, with a check that says so.

    ``starts``: whether the motor starts by itself, so that its run-up torque is needed; ``star``: whether in star.
    """
    if winding.rated_speed is None:
        sheet.check("static_power", CHECK_NAMES["static_power"], None, None, "kW", "motor: data sheet",
                    missing="rated speed of the motor")  # fmt: skip
        return None
    with sheet.section(f"Motor{name.replace('_', ' ')}"):
        sync = sheet(run.synchronous_speed, key=f"synchronous_speed{name}", f_1=winding.frequency, z_p=winding.poles)
        if winding.rated_speed >= sync:
            text = not_below(sync, winding.frequency, winding.poles)
            raise EngineError(f"the rated speed of its winding {text}", field="motor")
        M_N = record_rated_torque(winding, winding.rated_speed, sheet, name)
        M_H = winding.run_up_torque
        if M_H is None and winding.run_up_torque_ratio is not None:
            M_H = sheet(run.run_up_torque, key=f"run_up_torque{name}", r_H=winding.run_up_torque_ratio, M_N=M_N)
        if M_H is None and starts:
            sheet.check(f"run_up_torque{name}", CHECK_NAMES["run_up_torque"], None, None, "N m", "motor: data sheet",
                        missing="mean run-up torque of the motor")  # fmt: skip
        if line.motor_inertia is None:
            sheet.check(f"run_up_inertia{name}", CHECK_NAMES["run_up_torque"], None, None, "N m", "motor: data sheet",
                        missing="rotor inertia of the motor")  # fmt: skip
        full = M_H
        if M_H is not None and star:
            M_H = sheet(run.star_run_up_torque, key=f"star_run_up_torque{name}", M_H=M_H)
            sheet.decide("The motor runs up in star, with a third of its torque, and changes over to delta",
                         "star-delta starting is chosen; its power in steady running is unchanged")  # fmt: skip
    return MotorData(winding, winding.rated_speed, sync, M_N, M_H, full)


def record_rated_torque(winding: Winding, rated_speed: float, sheet: Sheet, name: str = "") -> float:
    """Rated torque of a winding [N m]: as its data sheet gives it, else from power and speed."""
    if winding.rated_torque is None:
        return sheet(run.rated_torque, key=f"rated_torque{name}", P_N=winding.rated_power, n_N=rated_speed)
    label = "Rated torque of the motor, from its data sheet"
    return sheet(sum_of_torques, key=f"rated_torque{name}", symbol="M_N", label=label, M_k=[winding.rated_torque])


def _gear_efficiency(rules: MotorRules, gear: GearUnit | None, sheet: Sheet) -> float:
    if gear is None:
        return 1.0
    found = gear.efficiency if gear.efficiency is not None else rules.gear_efficiency
    if found is None:
        sheet.assume("drive.gear_unit.efficiency", "efficiency of the gear unit", value=HELICAL_EFFICIENCY,
                     symbol="eta_G", source=HELICAL_SOURCE)  # fmt: skip
        return HELICAL_EFFICIENCY
    return found


def motor_inertia_of(motor: InductionMotor, brake: MotorBrake | None, sheet: Sheet) -> float | None:
    """Inertia of rotor and brake [kg m2]."""
    if brake is None:
        return motor.rotor_inertia if motor.rotor_inertia is not None else motor.rotor_inertia_with_brake
    if motor.rotor_inertia_with_brake is not None:
        return motor.rotor_inertia_with_brake
    if motor.rotor_inertia is not None and brake.inertia is not None:
        return motor.rotor_inertia + brake.inertia
    if motor.rotor_inertia is not None:
        sheet.assume("drive.motor.rotor_inertia_with_brake", "the inertia of the brake is unknown, left out",
                     value=motor.rotor_inertia, unit="kg m2", symbol="J_M", source=motor.source)  # fmt: skip
    return motor.rotor_inertia


def brake_of(rules: BrakingRules, brake: MotorBrake | None, sheet: Sheet) -> Brake | None:
    """The brake as it is set and cut off; None, and said so, where no stop can be calculated."""
    if brake is None:
        sheet.decide("No stop is calculated", "no brake is given")
        return None
    delay = brake.application_time_dc if rules.cut_off == "dc" else brake.application_time_ac
    if brake.torque is None or delay is None:
        sheet.check("brake_stops", CHECK_NAMES["brake_stops"], None, None, "N m", "brake: data sheet",
                    missing="torque or application time of the brake")  # fmt: skip
        return None
    return Brake(torque=brake.torque, delay=delay, tolerance=rules.stopping_tolerance)


def with_torque(brake: Brake, torque: float) -> Brake:
    """The same brake set to another torque."""
    return replace(brake, torque=torque)
