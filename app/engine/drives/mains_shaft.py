"""One state of load as a line-fed motor sees it on its own shaft: starting, slowing down and stopping.

Losses act on the net torque by its direction. Which direction that is depends on how fast the load is accelerated,
which depends on the losses: a lowered load drives the motor unless it is started faster than it would fall. Both cases
are tried and the one that agrees with itself is taken.
"""

from dataclasses import dataclass, replace

import numpy as np

from app.engine.cycle import FloatArray
from app.engine.formulas.conversion import torque_before_ratio
from app.engine.formulas.efficiency import (
    RegenerationModel,
    driving_stage_inertia,
    driving_stage_torque,
    regenerative_factor,
    returning_stage_inertia,
    returning_stage_torque,
)
from app.engine.formulas.induction import mean_torque_over_speed, torque_at_speed
from app.engine.formulas.inertia import referred_inertia, sum_of_inertias
from app.engine.mechanisms.load import LoadState, Statics
from app.engine.sheet import Sheet

RUN_UP_STEPS = 128
"""Steps of the speed in a run-up against a curve."""


@dataclass(frozen=True)
class Burden:
    """What acts on the motor shaft during one change of speed, losses included."""

    torque: float
    """Load torque, positive against the rotation [N m]"""
    inertia: float
    """All inertia on the motor shaft [kg m2]"""


@dataclass(frozen=True)
class Gravity:
    """What pulls at a load while neither motor nor brake hold it."""

    states: tuple[LoadState, ...]
    """Every state of the load."""
    statics: Statics

    def opposite(self, state: LoadState) -> LoadState:
        """The same load moving the other way, under the name of ``state``.

        It is the state of the other direction where there is one. An unbalance, which both directions count at its
        worst, and a load without such a state are pulled back by what holding takes beyond friction.
        """
        friction = self.statics.friction
        known = [
            other for other in self.states
            if other.direction == -state.direction and _same(other.inertia, state.inertia)
            and _same(other.front_inertia, state.front_inertia)
        ]  # fmt: skip
        if known:
            found = min(known, key=lambda other: other.torque - other.process_torque)
            torque = found.torque - found.process_torque
            if (state.torque + torque) / 2 <= friction * (1 + 1e-9):
                return replace(found, key=state.key, label=state.label, torque=torque, process_torque=0.0)
        pulled = friction - abs(self.statics.holding)
        return replace(state, direction=-state.direction, torque=pulled, process_torque=0.0)


def _same(one: float, other: float) -> bool:
    return abs(one - other) <= 1e-9 * max(abs(one), abs(other))


@dataclass(frozen=True, kw_only=True)
class MotorSide:
    """One state of load referred to the motor shaft."""

    state: LoadState
    ratio: float
    """i = n_motor / n_output"""
    gear_efficiency: float
    motor_inertia: float
    """J_M, brake included [kg m2]"""
    added_inertia: float = 0.0
    """J_Z: flywheel, and the gear unit's own [kg m2]"""
    model: RegenerationModel = "eta"

    @property
    def efficiency(self) -> float:
        """Of everything between motor shaft and load."""
        return self.state.efficiency * self.gear_efficiency

    @property
    def load_torque(self) -> float:
        """M_L: steady torque without losses, negative where the load drives [N m]."""
        return float(torque_before_ratio(self.state.torque, self.ratio))

    @property
    def external_inertia(self) -> float:
        """J_X, without losses [kg m2]."""
        return float(referred_inertia(self.state.inertia, self.ratio))

    @property
    def own_inertia(self) -> float:
        """Motor, flywheel and what sits on the output shaft before the losses of the mechanism [kg m2]."""
        return self.motor_inertia + self.added_inertia + float(referred_inertia(self.state.front_inertia, self.ratio))

    @property
    def travel(self) -> float:
        """Path of the load per radian of the motor shaft: [m/rad], or [rad/rad] where the load turns."""
        return (1.0 if self.state.travel is None else self.state.travel) / self.ratio

    @property
    def driven_by_load(self) -> bool:
        """Whether the load drives the motor in steady running: lowering."""
        return self.state.torque < 0

    @property
    def mean_torque(self) -> float:
        """Mean of a torque that depends on the speed, from standstill to full speed, without losses [N m]."""
        return float(mean_torque_over_speed(*self.curve_steps))

    @property
    def curve_steps(self) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
        """Torque and speed at both ends of every step of the curve, on the motor shaft: M_a, M_b, n_a, n_b."""
        speed, torque = np.array(self.state.curve, dtype=float).T
        speed, torque = speed * self.ratio, np.asarray(torque_before_ratio(torque, self.ratio))
        return torque[:-1], torque[1:], speed[:-1], speed[1:]

    @property
    def largest_torque(self) -> float:
        """Largest torque without losses that the load has at any speed [N m]: ``load_torque`` but for a curve."""
        curve = [torque for _, torque in self.state.curve]
        return float(torque_before_ratio(max(curve, default=self.state.torque), self.ratio))

    @property
    def averaged(self) -> "MotorSide":
        """The same with the mean torque over the speed, where the torque depends on it."""
        if not self.state.curve:
            return self
        return replace(self, state=replace(self.state, torque=self.mean_torque * self.ratio, curve=()))

    @property
    def without_process(self) -> "MotorSide":
        """The same without a process that acts at full speed only."""
        process = self.state.process_torque
        if not process:
            return self
        curve = tuple((speed, torque - process) for speed, torque in self.state.curve)
        state = replace(self.state, torque=self.state.torque - process, process_torque=0.0, curve=curve)
        return replace(self, state=state)

    @property
    def changing(self) -> "MotorSide":
        """The same while it starts or stops: no process of full speed, mean torque where it depends on the speed."""
        return self.without_process.averaged

    def between(self, slow: float, fast: float) -> "MotorSide":
        """The same with only that part of a torque curve between two shares of full speed, the higher one last."""
        if not self.state.curve:
            return self
        speed, torque = np.array(self.state.curve, dtype=float).T
        ends = np.array([slow, fast]) * speed[-1]
        inside = speed[(speed > ends[0]) & (speed < ends[1])]
        speeds = np.concatenate((ends[:1], inside, ends[1:]))
        torques = np.interp(speeds, speed, torque)
        points = tuple(zip(speeds.tolist(), torques.tolist(), strict=True))
        return replace(self, state=replace(self.state, torque=float(torques[-1]), curve=points))

    def at_speed(self, omega: float) -> "MotorSide":
        """The same with its torque curve up to another speed of the motor [rad/s]: see ``torque_at_speed``.

        Between two points of the curve, or beyond the last two, a parabola without a linear part goes through both.
        """
        if not self.state.curve:
            return self
        reached = omega / self.ratio
        speed, torque = np.array(self.state.curve, dtype=float).T
        k = int(np.clip(np.searchsorted(speed, reached), 1, len(speed) - 1))
        last = float(torque_at_speed(torque[k - 1], torque[k], speed[k - 1], speed[k], reached))
        points = [point for point in self.state.curve if point[0] < reached * (1 - 1e-9)]
        if reached > speed[-1]:  # more points, as close as those of the curve
            number = int(np.ceil((reached - speed[-1]) / (speed[-1] - speed[-2])))
            more = np.linspace(speed[-1], reached, number + 1)[1:-1]
            beyond = torque_at_speed(torque[-2], torque[-1], speed[-2], speed[-1], more)
            points += list(zip(more.tolist(), np.asarray(beyond).tolist(), strict=True))
        curve = (*points, (reached, last))
        return replace(self, state=replace(self.state, torque=last, curve=curve))

    def steps(self, slow: float, fast: float, losses: float) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Torque of the curve with losses in the middle of small steps between two motor speeds [rad/s]: M_L, n_a, n_b.

        ``losses``: what they make of a torque, see ``factor``.
        """
        speed, torque = np.array(self.state.curve, dtype=float).T
        borders = np.linspace(slow, fast, RUN_UP_STEPS + 1)
        middle = (borders[:-1] + borders[1:]) / 2
        load = np.interp(middle / self.ratio, speed, torque)
        return np.asarray(torque_before_ratio(load, self.ratio)) * losses, borders[:-1], borders[1:]

    def falling_back(self, gravity: "Gravity") -> "MotorSide":
        """The same load on its way back, after it has come to rest."""
        return replace(self, state=gravity.opposite(self.state))

    def with_added(self, inertia: float) -> "MotorSide":
        """The same with another additional inertia on the motor shaft."""
        return replace(self, added_inertia=inertia)

    def factor(self, *, driving: bool) -> float:
        """What losses make of a torque or inertia of the load."""
        return 1 / self.efficiency if driving else float(regenerative_factor(self.efficiency, self.model))

    def drives(self, torque: float) -> bool:
        """Whether power goes from motor to load while ``torque`` acts on the motor shaft (negative: a brake)."""
        k = self.factor(driving=True)
        alpha = (torque - self.load_torque * k) / (self.own_inertia + self.external_inertia * k)
        return self.load_torque + self.external_inertia * alpha >= 0

    def burden(self, torque: float) -> Burden:
        """Load torque and inertia, losses included, while ``torque`` acts on the motor shaft."""
        k = self.factor(driving=self.drives(torque))
        return Burden(self.load_torque * k, self.own_inertia + self.external_inertia * k)

    def record(self, sheet: Sheet) -> None:
        """Write load torque and external inertia without losses."""
        key = self.state.key
        label = "Torque of the load on the motor shaft, no losses"
        sheet(torque_before_ratio, key=f"{key}_load_torque", symbol="M_L", label=label, M=self.state.torque,
              i=self.ratio)  # fmt: skip
        label = "External inertia on the motor shaft, no losses"
        sheet(referred_inertia, key=f"{key}_external_inertia", symbol="J_X", label=label, J=self.state.inertia,
              i=self.ratio)  # fmt: skip

    def record_curve(self, sheet: Sheet) -> None:
        """Write the mean of a torque that depends on the speed."""
        key = self.state.key
        if self.state.curve:
            label = "Mean torque of the load from standstill to full speed, on the motor shaft, no losses"
            M_a, M_b, n_a, n_b = self.without_process.curve_steps
            sheet(mean_torque_over_speed, key=f"{key}_mean_run_up_load_torque", symbol="M_Lm", label=label, M_a=M_a,
                  M_b=M_b, n_a=n_a, n_b=n_b)  # fmt: skip

    def record_burden(self, sheet: Sheet, torque: float, phase: str, doing: str) -> Burden:
        """Write what acts on the motor shaft while ``torque`` acts there; keys ``<state>_<phase>_...``."""
        key, driving = f"{self.state.key}_{phase}", self.drives(torque)
        why = "the motor drives the load" if driving else "the load drives the motor"
        losses = self.factor(driving=driving)
        sheet.decide(f"{doing}: losses {'divide by' if driving else 'multiply by'} the efficiency", why)
        label, symbol = f"Torque of the load with losses, {doing.lower()}", "M_L'"
        M_L, J_X = self.load_torque, self.external_inertia
        name = f"{key}_load_torque"
        if driving:
            load = sheet(driving_stage_torque, key=name, symbol=symbol, label=label, T=M_L, eta=self.efficiency)
        else:
            load = sheet(returning_stage_torque, key=name, symbol=symbol, label=label, T=M_L, eta_r=losses)
        label, name = f"External inertia with losses, {doing.lower()}", f"{key}_external_inertia"
        if driving:
            outer = sheet(driving_stage_inertia, key=name, symbol="J_X'", label=label, J=J_X, eta=self.efficiency)
        else:
            outer = sheet(returning_stage_inertia, key=name, symbol="J_X'", label=label, J=J_X, eta_r=losses)
        front = float(referred_inertia(self.state.front_inertia, self.ratio))
        parts = [part for part in (self.motor_inertia, self.added_inertia, front, outer) if part]
        label = f"All inertia on the motor shaft, {doing.lower()}"
        total = sheet(sum_of_inertias, key=f"{key}_inertia", symbol="J_tot", label=label, J_k=parts)
        return Burden(load, total)
