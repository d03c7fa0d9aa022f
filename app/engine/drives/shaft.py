"""The load on the motor shaft: torque, speed and inertia of one drive, segment by segment and on the sheet."""

from dataclasses import dataclass
from functools import cached_property
from itertools import groupby

import numpy as np

from app.engine.cycle import CycleHull, FloatArray, LoadCycle
from app.engine.formulas.conversion import speed_before_ratio, torque_before_ratio
from app.engine.formulas.duty import effective_torque, mean_speed, mean_torque
from app.engine.formulas.inertia import referred_inertia, sum_of_inertias
from app.engine.formulas.servo import motor_acceleration, motor_torque, peak_torque, shaft_power
from app.engine.gear import Transmission
from app.engine.mechanisms.load import Load
from app.engine.resistor import PowerSegment
from app.engine.sheet import Sheet

MAX_PHASES = 12
"""Phases whose torque is written on the sheet one by one."""
_LEVEL = 1e-9
"""Acceleration below which a segment counts as steady, relative to the largest one of the cycle."""


@dataclass(frozen=True)
class Point:
    """One segment of one cycle of a load."""

    cycle: LoadCycle
    segment: int

    @property
    def torque(self) -> float:
        """Torque at the output shaft [N m], zero where the brake is closed."""
        return float(self.cycle.held[0][self.segment])

    @property
    def acceleration(self) -> float:
        """Angular acceleration of the output shaft [rad/s2]."""
        return float(self.cycle.held[1][self.segment])

    @property
    def speed(self) -> float:
        """Signed mean speed of the output shaft [rad/s]: its sign decides on the direction of power."""
        return float(self.cycle.mean_speed[self.segment])

    @property
    def top_speed(self) -> float:
        """Higher unsigned speed of its two ends [rad/s]."""
        return max(abs(float(self.cycle.speed_start[self.segment])), abs(float(self.cycle.speed_end[self.segment])))

    @property
    def label(self) -> str:
        """What happens in it."""
        return self.cycle.label[self.segment]


@dataclass(frozen=True)
class MotorShaft:
    """One load behind one transmission on one rotor: what the motor must do."""

    load: Load
    transmission: Transmission
    rotor: float
    """J_M [kg m2]; 0 where no motor is chosen."""

    @cached_property
    def cycles(self) -> tuple[LoadCycle, ...]:
        """The cycle, and the same motion in the opposite direction where the axis has one."""
        return (self.load.cycle,) if self.load.opposite is None else (self.load.cycle, self.load.opposite)

    @cached_property
    def hull(self) -> CycleHull:
        """Outermost points of all cycles at the output shaft."""
        return CycleHull(self.cycles)

    @cached_property
    def load_inertia(self) -> float:
        """J_L / i^2 [kg m2]."""
        return float(referred_inertia(max(cycle.inertia for cycle in self.cycles), self.transmission.ratio))

    @property
    def external_inertia(self) -> float:
        """Load, gear unit and coupling referred to the motor shaft [kg m2]."""
        return self.load_inertia + self.transmission.inertia

    def torque(self, cycle: LoadCycle) -> FloatArray:
        """Torque that the motor must give in every segment [N m], rotor included, signed as its speed."""
        alpha = speed_before_ratio(cycle.held[1], self.transmission.ratio)
        found: FloatArray = np.asarray(
            motor_torque(self.transmission.load_torque(cycle), self.rotor, self.transmission.inertia, alpha)
        )
        return found

    def extreme(self, with_rotor: bool = True) -> Point:
        """The segment of any cycle with the largest unsigned torque on the motor shaft."""
        found = []
        for cycle in self.cycles:
            size = np.abs(self.torque(cycle) if with_rotor else self.transmission.load_torque(cycle))
            found.append((float(size.max()), Point(cycle, int(size.argmax()))))
        return max(found, key=lambda item: item[0])[1]

    def strongest(self, with_rotor: bool = True) -> Point:
        """The segment of any cycle with the largest unsigned power on the motor shaft at one of its ends."""
        found = []
        for cycle in self.cycles:
            torque = self.torque(cycle) if with_rotor else self.transmission.load_torque(cycle)
            power = np.abs(torque) * np.maximum(np.abs(cycle.speed_start), np.abs(cycle.speed_end))
            found.append((float(power.max()), Point(cycle, int(power.argmax()))))
        return max(found, key=lambda item: item[0])[1]

    def steady(self) -> Point | None:
        """The moving segment without acceleration that has the largest torque; None where there is none."""
        found = []
        for cycle in self.cycles:
            alpha = np.abs(cycle.held[1])
            level = (alpha <= _LEVEL * max(self.hull.max_acceleration, _LEVEL)) & (cycle.mean_speed != 0)
            size = np.where(level, np.abs(self.transmission.load_torque(cycle)), -1.0)
            found.append((float(size.max()), Point(cycle, int(size.argmax()))))
        size_found, point = max(found, key=lambda item: item[0])
        return point if size_found >= 0 else None

    @property
    def effective_torque(self) -> float:
        """Over the cycle as given [N m]."""
        return float(effective_torque(self.torque(self.load.cycle), self.load.cycle.duration))

    @property
    def peak_torque(self) -> float:
        """Largest unsigned torque of any cycle [N m], rotor included."""
        return max(float(np.abs(self.torque(cycle)).max()) for cycle in self.cycles)

    @property
    def mean_speed(self) -> float:
        """Mean unsigned speed of the motor [rad/s]."""
        cycle = self.load.cycle
        return float(mean_speed(speed_before_ratio(cycle.mean_speed, self.transmission.ratio), cycle.duration))

    @property
    def max_speed(self) -> float:
        """Highest unsigned speed of the motor [rad/s]."""
        return float(speed_before_ratio(self.hull.max_speed, self.transmission.ratio))


def power_segments(shaft: MotorShaft, cycle: LoadCycle) -> list[PowerSegment]:
    """Power of the motor shaft in every segment; a closed brake takes and gives none."""
    ratio, torque = shaft.transmission.ratio, shaft.torque(cycle)
    start, end = torque * cycle.speed_start * ratio, torque * cycle.speed_end * ratio
    return [
        PowerSegment(cycle.label[k], float(cycle.duration[k]), float(start[k]), float(end[k]),
                     bool(abs(cycle.speed_end[k]) < abs(cycle.speed_start[k])))
        for k in range(len(cycle.duration)) if not cycle.braked[k]
    ]  # fmt: skip


def record_speeds(shaft: MotorShaft, sheet: Sheet) -> None:
    """Put speeds and acceleration of the motor shaft on the sheet; they need the ratio only."""
    ratio = shaft.transmission.ratio
    cycle = shaft.load.cycle
    sheet(speed_before_ratio, key="motor_speed_max", symbol="n_max,M", label="Highest motor speed",
          omega=shaft.hull.max_speed, i=ratio)  # fmt: skip
    sheet(mean_speed, label="Mean motor speed over the cycle",
          omega_k=speed_before_ratio(cycle.mean_speed, ratio), t_k=cycle.duration)  # fmt: skip
    sheet(motor_acceleration, key="motor_angular_acceleration", alpha_L=shaft.hull.max_acceleration, i=ratio)


def record_inertias(shaft: MotorShaft, sheet: Sheet) -> None:
    """Put load, external and total inertia on the motor shaft on the sheet."""
    inertia = max(cycle.inertia for cycle in shaft.cycles)
    load = sheet(referred_inertia, key="load_inertia_on_motor", symbol="J_L,M", J=inertia, i=shaft.transmission.ratio,
                 label="Inertia of the load referred to the motor shaft")  # fmt: skip
    external = sheet(sum_of_inertias, key="external_inertia_on_motor", symbol="J_ext",
                     label="External inertia on the motor shaft: load, gear unit, coupling",
                     J_k=[load, shaft.transmission.inertia])  # fmt: skip
    sheet(sum_of_inertias, key="total_inertia", symbol="J_tot", label="Rotor and external inertia on the motor shaft",
          J_k=[shaft.rotor, external])  # fmt: skip


def record_torques(shaft: MotorShaft, sheet: Sheet) -> None:
    """Put the torque of every phase, the extremes and the effective torque on the sheet."""
    _record_phases(shaft, sheet)
    _record_load_extremes(shaft, sheet)
    _record_rotor_torque(shaft, shaft.extreme(), "peak", sheet)
    powerful = shaft.strongest(with_rotor=True)
    torque = float(shaft.torque(powerful.cycle)[powerful.segment])
    _record_power(shaft, powerful, torque, "motor_power_peak", "Largest power of the motor, rotor included", sheet)
    torques = shaft.torque(shaft.load.cycle)
    sheet(effective_torque, M_k=torques, t_k=shaft.load.cycle.duration)
    sheet(mean_torque, M_k=np.abs(torques), t_k=shaft.load.cycle.duration)
    sheet(torque_before_ratio, key="holding_torque_on_motor", symbol="M_H", M=abs(shaft.load.statics.holding),
          i=shaft.transmission.ratio, label="Torque that holds the axis at standstill, no friction")  # fmt: skip


def _record_phases(shaft: MotorShaft, sheet: Sheet) -> None:
    """One step set per phase of the cycle: the segment with the largest torque stands for it."""
    cycle = shaft.load.cycle
    size = np.abs(shaft.torque(cycle))
    start, count = 0, 0
    for label, run in groupby(cycle.label):
        stop = start + len(list(run))
        count += 1
        if count <= MAX_PHASES and not cycle.braked[start:stop].all():
            point = Point(cycle, start + int(size[start:stop].argmax()))
            _record_rotor_torque(shaft, point, f"phase_{count}", sheet, label)
        start = stop
    if count > MAX_PHASES:
        sheet.decide("Only the first phases are written out", "the extremes below are those of the whole cycle")


def _record_rotor_torque(shaft: MotorShaft, point: Point, name: str, sheet: Sheet, label: str = "") -> None:
    """Way of one segment's torque through the gear unit, then the rotor: ``<name>_torque`` is the last key."""
    transmission = shaft.transmission
    load = transmission.record(sheet, point.torque, point.speed, key=f"{name}_torque_of_load", symbol="M_L",
                               label=label or "Torque of the load on the motor shaft")  # fmt: skip
    alpha = sheet(motor_acceleration, key=f"{name}_angular_acceleration", label=label,
                  alpha_L=point.acceleration, i=transmission.ratio)  # fmt: skip
    formula = motor_torque if label else peak_torque
    sheet(
        formula, key=f"{name}_torque", label=label, M_L=load, J_M=shaft.rotor, J_x=transmission.inertia, alpha_M=alpha
    )


def _record_load_extremes(shaft: MotorShaft, sheet: Sheet) -> None:
    """Largest and largest steady torque and power of the load on the motor shaft, rotor not included."""
    largest, steady = shaft.extreme(with_rotor=False), shaft.steady()
    _record_load_torque(shaft, largest, "peak_load_torque_on_motor", "M_L,max",
                        "Largest torque of the load on the motor shaft, rotor not included", sheet)  # fmt: skip
    powerful = shaft.strongest(with_rotor=False)
    torque = float(shaft.transmission.load_torque(powerful.cycle)[powerful.segment])
    _record_power(shaft, powerful, torque, "load_power_peak",
                  "Largest power of the load on the motor shaft, rotor not included", sheet)  # fmt: skip
    if steady is None:
        sheet.decide("No steady torque is written", "no segment moves at constant speed")
        return
    torque = _record_load_torque(shaft, steady, "steady_load_torque_on_motor", "M_st",
                                 "Largest torque on the motor shaft at constant speed", sheet)  # fmt: skip
    _record_power(shaft, steady, torque, "motor_power_steady", "Power of the motor at that torque", sheet)


def _record_load_torque(shaft: MotorShaft, point: Point, key: str, symbol: str, label: str, sheet: Sheet) -> float:
    torque, speed = abs(point.torque), point.speed * float(np.sign(point.torque))
    return shaft.transmission.record(sheet, torque, speed, key=key, symbol=symbol, label=label)


def _record_power(shaft: MotorShaft, point: Point, torque: float, key: str, label: str, sheet: Sheet) -> None:
    omega = float(speed_before_ratio(point.top_speed, shaft.transmission.ratio))
    sheet(shaft_power, key=key, label=label, M=torque, omega=omega)
