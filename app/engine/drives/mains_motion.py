"""Starting and stopping of one state of load on the mains: steps and checks that several kinds of drive share."""

from dataclasses import dataclass

import numpy as np

from app.engine.drives.mains_rules import CHECK_NAMES
from app.engine.drives.mains_shaft import Gravity, MotorSide
from app.engine.formulas import braking as stop
from app.engine.formulas import induction as run
from app.engine.formulas.conversion import linear_speed
from app.engine.formulas.motion import ramp_acceleration, ramp_distance, sum_of_times
from app.engine.sheet import Sheet

STAR_SHARE = 0.9
"""Share of full speed that must be reached in star."""
STAR_SOURCE = "common practice: 90 % of rated speed before changing over to delta"
CHANGE_SHARE = 0.98
"""Share of the speed reached in star at which it is left, where the load takes all of its torque."""
SLIP_SOURCE = "mechanism: acceleration at which wheels slip or goods topple"


@dataclass(frozen=True)
class Start:
    """One run-up; None where the motor does not start the load."""

    time: float
    """[s]"""
    acceleration: float
    """Of the load [m/s2 or rad/s2]"""


@dataclass(frozen=True)
class Stop:
    """One stop by the brake."""

    distance: float
    """[m or rad]"""
    deceleration: float
    work: float
    """[J]"""


@dataclass(frozen=True, kw_only=True)
class Brake:
    """The brake as it is set."""

    torque: float
    """[N m]"""
    delay: float
    """t_2 [s]"""
    tolerance: float


def record_start(
    sheet: Sheet,
    side: MotorSide,
    M_H: float,
    omega: float,
    name: str = "",
    winding: str = "",
    *,
    delta: float | None = None,
) -> Start | None:
    """Write a run-up against the load to speed ``omega``.

    ``name`` goes into the keys and ``winding`` into the name of the check where a state starts twice. ``delta`` is the
    mean run-up torque in delta where ``M_H`` is that in star; None without changing over.
    """
    whole, side = side.without_process, side.changing
    key, label = f"{side.state.key}{name}", f"{side.state.label}{winding}"
    burden = side.record_burden(sheet, M_H, f"starting{name}", "Starting")
    demanded, given = burden.torque, M_H
    if whole.state.curve:
        # a torque that grows with the speed holds the motor back at its highest point, whatever its mean
        demanded = max(demanded, whole.largest_torque * whole.factor(driving=True))
        given = delta or M_H
    sheet.check(f"run_up_torque_{key}", f"{CHECK_NAMES['run_up_torque']}: {label}", max(demanded, 0.0), given, "N m",
                "motor: mean run-up torque", formula="run_up_torque")  # fmt: skip
    if whole.state.curve:
        curved = _Curved(sheet, whole, key, burden.inertia, whole.factor(driving=side.drives(M_H)))
        if delta is not None:
            time = curved.record_star(M_H, delta, omega, label, starts=demanded < delta)
        else:
            time = curved.record_time(M_H, 0.0, omega, "run_up_time") if demanded < M_H else None
        if time is None:
            return None
        sheet(run.equivalent_load_torque, key=f"{key}_equivalent_load_torque", M_H=M_H, J_tot=burden.inertia,
              omega=omega, t_A=time)  # fmt: skip
    elif demanded >= M_H:
        return None
    else:
        time = sheet(
            run.run_up_time, key=f"{key}_run_up_time", J_tot=burden.inertia, omega=omega, M_H=M_H, M_L=burden.torque
        )
    v = sheet(linear_speed, key=f"{key}_speed_reached", symbol="v", label="Speed of the load after the run-up",
              omega=omega, A=side.travel)  # fmt: skip
    turning = side.state.travel is None
    a = sheet(ramp_acceleration, key=f"{key}_run_up_acceleration", symbol="a_A", label="Acceleration of the load",
              unit="rad/s2" if turning else "", v=v, t_A=time)  # fmt: skip
    sheet(ramp_distance, key=f"{key}_run_up_distance", symbol="s_A", label="Path of the run-up",
          unit="rad" if turning else "mm", v=v, t_A=time)  # fmt: skip
    return Start(time, a)


@dataclass(frozen=True)
class _Curved:
    """A run-up against a torque that depends on the speed."""

    sheet: Sheet
    side: MotorSide
    key: str
    inertia: float
    """All inertia on the motor shaft [kg m2]"""
    losses: float
    """What losses make of the torque of the load."""

    def record_time(self, M_H: float, slow: float, fast: float, name: str, label: str = "") -> float:
        """Write the time between two speeds [s]."""
        M_L, n_a, n_b = self.side.steps(slow, fast, self.losses)
        return self.sheet(run.run_up_time_over_speed, key=f"{self.key}_{name}", label=label, J_tot=self.inertia,
                          M_H=M_H, M_L=M_L, n_a=n_a, n_b=n_b)  # fmt: skip

    def record_star(self, star: float, delta: float, omega: float, label: str, *, starts: bool) -> float | None:
        """Write and check how fast the motor becomes in star, then the run-up with the rest of it in delta.

        Returns its time [s]; None where star moves nothing, or delta does not suffice.
        """
        reached = self._record_speed_in_star(star, omega)
        self.sheet.check(f"star_speed_{self.key}", f"{CHECK_NAMES['star_speed']}: {label}", STAR_SHARE * omega, reached,
                         "rpm", STAR_SOURCE, formula="speed_at_torque")  # fmt: skip
        if reached <= 0 or not starts:
            return None
        if reached == omega:
            return self.record_time(star, 0.0, omega, "run_up_time")
        change = CHANGE_SHARE * reached
        self.sheet.decide("The rest of the run-up is in delta", f"it changes over at {CHANGE_SHARE:.0%} of the speed "
                          "reached in star, which it approaches ever more slowly")  # fmt: skip
        times = [self.record_time(star, 0.0, change, "star_time", "Time in star"),
                 self.record_time(delta, change, omega, "delta_time", "Time in delta up to full speed")]  # fmt: skip
        return self.sheet(sum_of_times, key=f"{self.key}_run_up_time", symbol="t_A", label="Run-up time", t_k=times)

    def _record_speed_in_star(self, star: float, omega: float) -> float:
        """Speed at which the load takes all of the torque in star; full speed where it never does [rad/s]."""
        M_a, M_b, n_a, n_b = self.side.curve_steps
        M_a, M_b = M_a * self.losses, M_b * self.losses
        if M_a[0] >= star:
            return 0.0
        over = np.flatnonzero(M_b >= star)
        if not over.size:
            return omega
        k = int(over[0])
        return self.sheet(run.speed_at_torque, key=f"{self.key}_speed_in_star", label="Speed reached in star", M_H=star,
                          M_a=float(M_a[k]), M_b=float(M_b[k]), n_a=float(n_a[k]), n_b=float(n_b[k]))  # fmt: skip


def check_slip(sheet: Sheet, side: MotorSide, rate: float, phase: str, name: str = "", winding: str = "") -> None:
    """Check acceleration or deceleration (unsigned) against what the load bears; ``phase`` as in ``CHECK_NAMES``.

    ``name`` and ``winding`` as in :func:`record_start`.
    """
    limit = side.state.permissible_acceleration
    if limit is not None:
        unit = "rad/s2" if side.state.travel is None else "m/s2"
        sheet.check(f"{phase}_{side.state.key}{name}", f"{CHECK_NAMES[phase]}: {side.state.label}{winding}", rate,
                    limit, unit, SLIP_SOURCE, formula="ramp_acceleration")  # fmt: skip


def record_least_flywheel(sheet: Sheet, side: MotorSide, M_H: float, omega: float) -> None:
    """Write the least additional inertia with which the run-up keeps the permissible acceleration.

    Where none is permitted (wheels without weight on them) no inertia is large enough.
    """
    limit = side.state.permissible_acceleration
    if not limit:
        return
    bare = side.changing.with_added(0.0)
    burden, known = bare.burden(M_H), f"{side.state.key}_equivalent_load_torque"
    torque = sheet.value(known) if sheet.has(known) else burden.torque
    sheet(run.least_flywheel, key=f"{side.state.key}_least_flywheel", M_H=M_H, M_L=torque, omega=omega,
          v=omega * side.travel, a_p=limit, J_tot=burden.inertia)  # fmt: skip


@dataclass(frozen=True)
class _Applied:
    """The load at the moment when the brake applies."""

    side: MotorSide
    """In the direction in which it moves then"""
    speed: float
    """Of the motor; 0 where the load stands [rad/s]"""
    mean: float
    """Mean unsigned speed of the motor until then [rad/s]"""


def record_stop(
    sheet: Sheet, side: MotorSide, brake: Brake, omega: float, *, gravity: Gravity | None, name: str = ""
) -> Stop | None:
    """Write a stop from motor speed ``omega``; ``gravity`` changes the speed until the brake applies.

    None where the brake does not stop the load. ``name`` goes into the keys where a state stops twice.
    """
    side = side.changing
    key = f"{side.state.key}{name}"
    applied = _Applied(side, omega, omega)
    if gravity is not None:
        applied = _record_delay(sheet, side, brake, omega, gravity, name)
    burden = applied.side.record_burden(sheet, -brake.torque, f"braking{name}", "Braking")
    label = f"{CHECK_NAMES['brake_stops']}: {side.state.label}"
    sheet.check(f"brake_stops_{key}", label, max(-burden.torque, 0.0), brake.torque, "N m", "brake: data sheet",
                formula="braking_time")  # fmt: skip
    if applied.speed == 0:
        rate = sheet.value(f"{key}_coasting_deceleration")
        return Stop(_record_distance(sheet, key, applied, brake, 0.0), rate, 0.0)
    if brake.torque + burden.torque <= 0:
        return None
    time = sheet(stop.braking_time, key=f"{key}_braking_time", J_tot=burden.inertia, omega=applied.speed,
                 M_B=brake.torque, M_L=burden.torque)  # fmt: skip
    v_0 = sheet(linear_speed, key=f"{key}_braking_speed", symbol="v_0", label="Speed at which the brake applies",
                omega=applied.speed, A=side.travel)  # fmt: skip
    turning = side.state.travel is None
    rate = sheet(stop.braking_deceleration, key=f"{key}_braking_deceleration", unit="rad/s2" if turning else "",
                 v=v_0, t_B=time)  # fmt: skip
    distance = _record_distance(sheet, key, applied, brake, time)
    work = sheet(stop.braking_work, key=f"{key}_braking_work", M_B=brake.torque, omega=applied.speed, t_B=time)
    return Stop(distance, rate, work)


def _record_delay(sheet: Sheet, side: MotorSide, brake: Brake, omega: float, gravity: Gravity, name: str) -> _Applied:
    """Write what the load does until the brake applies: slow down, quicken, or come to rest and fall back."""
    key, turning = f"{side.state.key}{name}", side.state.travel is None
    free = side.record_burden(sheet, 0.0, f"delay{name}", "Until the brake applies")
    change = sheet(stop.speed_change_in_delay, key=f"{key}_speed_change_in_delay", M_L=free.torque,
                   J_tot=free.inertia, t_2=brake.delay)  # fmt: skip
    if omega + change > 0:
        return _Applied(side, omega + change, (omega + omega + change) / 2)
    time = sheet(stop.coasting_time, key=f"{key}_coasting_time", J_tot=free.inertia, omega=omega, M_L=free.torque)
    v = sheet(linear_speed, key=f"{key}_cut_off_speed", symbol="v", label="Speed of the load at cut-off", omega=omega,
              A=side.travel)  # fmt: skip
    label = "Mean deceleration of the load that comes to rest by itself"
    sheet(stop.braking_deceleration, key=f"{key}_coasting_deceleration", symbol="a_c", label=label, v=v, t_B=time,
          unit="rad/s2" if turning else "")  # fmt: skip
    label = "Path of the load that comes to rest by itself"
    sheet(ramp_distance, key=f"{key}_coasting_distance", symbol="s_c", label=label, v=v, t_A=time,
          unit="rad" if turning else "mm")  # fmt: skip
    back, left = side.falling_back(gravity), brake.delay - time
    at_rest = _Applied(back, 0.0, omega * time / 2 / brake.delay)
    if back.burden(0.0).torque >= 0:
        sheet.decide("The load stands before the brake applies", "it comes to rest by itself and nothing pulls it back")
        return at_rest
    if left <= 1e-9 * brake.delay:
        sheet.decide("The load stands as the brake applies", "it has just come to rest by itself")
        return at_rest
    sheet.decide("The load falls back before the brake applies", "it comes to rest by itself, then gravity pulls it")
    pull = back.record_burden(sheet, 0.0, f"falling_back{name}", "Falling back")
    label = "Speed at which the load falls back as the brake applies"
    speed = sheet(stop.speed_change_in_delay, key=f"{key}_falling_back_speed", label=label, M_L=pull.torque,
                  J_tot=pull.inertia, t_2=left)  # fmt: skip
    return _Applied(back, speed, (omega * time + speed * left) / 2 / brake.delay)


def _record_distance(sheet: Sheet, key: str, applied: _Applied, brake: Brake, time: float) -> float:
    """Write the path from cut-off to standstill, there and back, and its tolerance; returns the path [m or rad]."""
    travel, unit = applied.side.travel, "rad" if applied.side.state.travel is None else ""
    distance = sheet(stop.stopping_distance, key=f"{key}_stopping_distance", unit=unit, v=applied.mean * travel,
                     v_0=applied.speed * travel, t_2=brake.delay, t_B=time)  # fmt: skip
    sheet(stop.stopping_accuracy, key=f"{key}_stopping_accuracy", unit=unit, k_X=brake.tolerance, s_B=distance)
    return distance


def record_brake_limit(sheet: Sheet, side: MotorSide, brake: Brake, omega: float) -> None:
    """Write the braking torque that just keeps the permissible deceleration."""
    limit = side.state.permissible_acceleration
    if limit is not None:
        burden = side.changing.burden(-brake.torque)
        sheet(stop.braking_torque_of_deceleration, key=f"{side.state.key}_largest_braking_torque", J_tot=burden.inertia,
              a_p=limit, omega=omega, v=omega * side.travel, M_L=burden.torque)  # fmt: skip
