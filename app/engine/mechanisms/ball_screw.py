"""Slide moved by a ball or lead screw, at any inclination."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Annotated, Any, ClassVar, Literal, Self

import numpy as np
from pydantic import model_validator

from app.engine.cycle import LoadCycle
from app.engine.environment import Environment
from app.engine.formulas.conversion import (
    acceleration_torque,
    shaft_acceleration,
    shaft_speed,
    sum_of_torques,
    torque_of_force,
)
from app.engine.formulas.efficiency import RegenerationModel, record_stage, regenerative_factor, through_stage
from app.engine.formulas.inertia import linear_mass_inertia
from app.engine.formulas.motion import triangle_speed
from app.engine.formulas.resistance import acceleration_force, sum_of_forces, viscous_friction
from app.engine.formulas.screw import lead_angle, screw_friction_by_diameter, thread_efficiency
from app.engine.mechanisms.base import Mechanism
from app.engine.mechanisms.guided_axis import GuidedAxis, refused, without_zeros
from app.engine.mechanisms.linear_axis import holding_forces
from app.engine.mechanisms.load import Load, LoadState, Statics
from app.engine.mechanisms.phases import record_phases
from app.engine.mechanisms.screw_shaft import ScrewShaft
from app.engine.mechanisms.states import steady_runs
from app.engine.motion.profile import FloatArray, MotionProfile
from app.engine.quantity import Declaration, Option, Quantity
from app.engine.sheet import Sheet
from app.engine.transmission import LinearTransmission

LOSSES = "Losses of the screw"


@dataclass(frozen=True)
class _Screw:
    """The screw of one calculation: what turns a force on the nut into a torque on the shaft."""

    A: float
    """Travel per radian [m/rad]"""
    eta: float
    covers_load_side: bool
    """Whether the efficiency acts on the screw's own torque too"""
    model: RegenerationModel
    rotating: float
    """Inertia of screw and coupling [kg m2]"""
    drag: float
    """Constant friction torque of the screw [N m], unsigned"""

    def torque(self, force: Any, speed: Any, acceleration: Any) -> Any:
        """Torque on the screw [N m] from force on the nut [N], its speed [m/s] and acceleration [m/s2]."""
        nut = torque_of_force(force, self.A)
        own = acceleration_torque(self.rotating, shaft_acceleration(acceleration, self.A)) + self.drag * np.sign(speed)
        if self.covers_load_side:
            return through_stage(nut + own, speed, self.eta, self.model)
        return through_stage(nut, speed, self.eta, self.model) + own

    def record(self, sheet: Sheet, key: str, label: str, force: float, speed: float, acceleration: float) -> float:
        """The same torque, each step on the sheet; the last one carries ``key`` and ``label``."""
        nut = sheet(torque_of_force, key=f"{key}_at_nut", label="Torque of the force on the nut", symbol="M_n",
                    F=force, A=self.A)  # fmt: skip
        own = [self.drag * float(np.sign(speed))]
        if acceleration:
            alpha_s = sheet(shaft_acceleration, key=f"{key}_angular_acceleration", a=acceleration, A=self.A,
                            label="Angular acceleration of the screw")  # fmt: skip
            own.append(sheet(acceleration_torque, key=f"{key}_own_inertia", symbol="M_J", J=self.rotating,
                             alpha_s=alpha_s, label="Torque that accelerates screw and coupling"))  # fmt: skip
        if self.covers_load_side:
            label_net = "Net torque of the load side"
            net = sheet(sum_of_torques, key=f"{key}_net", symbol="M_L", label=label_net, M_k=[nut, *own])
            return sheet(sum_of_torques, key=key, symbol="M_s", label=label, M_k=[self._lossy(sheet, key, net, speed)])
        return sheet(
            sum_of_torques, key=key, symbol="M_s", label=label, M_k=[self._lossy(sheet, key, nut, speed), *own]
        )

    def _lossy(self, sheet: Sheet, key: str, torque: float, speed: float) -> float:
        if self.eta == 1:
            return torque
        label = "Torque with the loss of the screw"
        return record_stage(sheet, torque, speed, self.eta, self.model, key=f"{key}_lossy", symbol="M_d", label=label)


class BallScrew(ScrewShaft, GuidedAxis, Mechanism):
    """Slide on a ball or lead screw. The drive's output shaft is the screw."""

    title: ClassVar[str] = "Ball or lead screw axis"
    summary: ClassVar[str] = "A slide moved by a ball screw or lead screw, horizontal to vertical."
    drawing: ClassVar[str] = "ball_screw.svg"
    motion_kind: ClassVar[Literal["linear", "rotary"]] = "linear"

    kind: Literal["ball_screw"] = "ball_screw"
    efficiency: Annotated[
        float,
        Quantity(
            "1", symbol="eta", gt=0, le=1, default=0.9, group=LOSSES,
            about="efficiency of the screw while it drives the nut",
            source="Jakab: ball screws 0.85 to 0.95",
        ),
    ]  # fmt: skip
    efficiency_covers: Annotated[
        Literal["nut", "load_side"],
        Option(
            default="nut", group=LOSSES, about="what the efficiency acts on",
            source="the loss arises where the nut turns on the screw",
            labels={"nut": "what passes the nut", "load_side": "the whole load side, inertia of the screw included"},
        ),
    ]  # fmt: skip
    thread_friction: Annotated[
        float | None,
        Quantity(
            "1", symbol="mu_th", gt=0, le=1, default=None, group=LOSSES,
            about="friction coefficient in the thread of a lead screw, in place of the efficiency",
        ),
    ]  # fmt: skip
    screw_friction: Annotated[
        Literal["torque", "diameter_rule"],
        Option(
            default="torque", source="a figure of the maker is better than a rule", group=LOSSES,
            about="constant friction torque of screw and bearings",
            labels={"torque": "as given", "diameter_rule": "by experience: as many N m as the diameter has cm"},
        ),
    ]  # fmt: skip
    screw_friction_torque: Annotated[
        float,
        Quantity(
            "N m", symbol="M_Ts", ge=0, le=1e5, default=0.0, source="contained in the efficiency", group=LOSSES,
            about="friction torque of the bearings and seals of the screw",
        ),
    ]  # fmt: skip
    preload_torque: Annotated[
        float,
        Quantity(
            "N m", symbol="M_p", ge=0, le=1e5, default=0.0, source="contained in the efficiency", group=LOSSES,
            about="drag torque of a preloaded nut",
        ),
    ]  # fmt: skip

    @model_validator(mode="after")
    def _one_description_of_the_losses(self) -> Self:
        given = self.model_fields_set
        if self.thread_friction is not None and "efficiency" in given:
            raise refused(self, "thread_friction", "give either the friction of the thread or the efficiency, not both")
        if self.thread_friction is not None and self.thread_friction * self.lead >= np.pi * self.nominal_diameter:
            raise refused(self, "thread_friction", "the screw cannot move its nut: lead and friction are too large for "
                          "this diameter")  # fmt: skip
        if self.screw_friction == "diameter_rule" and self.screw_friction_torque:
            raise refused(self, "screw_friction_torque", "stands beside the rule by diameter; choose one of them")
        return self

    def defaults_taken(self) -> Iterator[tuple[str, Declaration, Any]]:
        """As in the base, without those that another input replaces."""
        idle = {"efficiency"} if self.thread_friction is not None else set()
        if self.screw_friction == "diameter_rule":
            idle.add("screw_friction_torque")
        yield from (found for found in super().defaults_taken() if found[0] not in idle)

    def load_at_shaft(self, motion: MotionProfile, environment: Environment, sheet: Sheet) -> Load:
        """Load cycle at the screw, with stiffness, speed and buckling of the screw checked on the way."""
        payload = float(motion.payload.max())
        with sheet.section("Forces along the axis"):
            constant, friction = self.record_forces(sheet, payload, environment)
        with sheet.section("Screw"):
            rotating, inertia = self.record_inertia(sheet, float(self.moved_mass(payload)))
            screw = self._screw(sheet, environment, rotating)
            speed = sheet(shaft_speed, key="screw_speed_rapid", symbol="n_s", label="Highest speed of the screw",
                          v=motion.max_speed, A=screw.A)  # fmt: skip
            self._record_limit_speed(sheet, motion)
            self.check_speed(sheet, speed)
        with sheet.section("Stiffness of the axis"):
            results = self.check_stiffness(sheet, float(self.slide_side_mass(payload)), friction)
        statics = self._statics(sheet, screw, motion, environment, friction)
        self._decide_self_locking(sheet, screw, constant, friction)
        self._record_shares(sheet, screw, motion, payload)

        fine = self.refined(motion)
        cycle, force = self._cycle(screw, fine, environment, inertia)

        def write(k: int, prefix: str) -> None:
            self._record_segment(
                sheet, screw, fine, k, environment, f"{prefix}torque" if prefix else "peak_torque_at_screw"
            )

        record_phases(sheet, fine, cycle.torque, write)
        opposite, force_back = self._cycle(screw, fine.mirrored(), environment, inertia)
        if self.inclined:
            force = np.concatenate([force, force_back])
        with sheet.section("Screw under load"):
            self.check_buckling(sheet, float(np.abs(force).max()))
        results |= {"load_inertia_on_screw": inertia, "peak_torque_at_screw": float(np.abs(cycle.torque).max())}
        return Load(
            cycle=cycle, statics=statics, opposite=opposite if self.inclined else None, results=results,
            states=self._states(screw, motion, environment.gravity),
        )  # fmt: skip

    def _states(self, screw: _Screw, motion: MotionProfile, gravity: float) -> tuple[LoadState, ...]:
        """States of load at the screw.

        The friction torque of the screw itself passes no nut: it is taken so that it comes out unchanged while the
        motor drives.
        """
        found = []
        for run in steady_runs(motion, both_directions=self.inclined):
            force = (
                run.direction * float(self.constant_force(run.payload, gravity))
                + float(self.friction(run.payload, gravity))
                + float(viscous_friction(self.viscous_coefficient, run.speed))
                + run.process_force
            )
            moved = float(linear_mass_inertia(self.moved_mass(run.payload), screw.A))
            lossy = screw.covers_load_side
            found.append(LoadState(
                key=run.key, label=run.label, direction=run.direction,
                torque=float(torque_of_force(force, screw.A)) + screw.drag * (1.0 if lossy else screw.eta),
                process_torque=run.process_force * screw.A if run.at_speed_only else 0.0,
                inertia=moved + (screw.rotating if lossy else 0.0), front_inertia=0.0 if lossy else screw.rotating,
                speed=run.speed / screw.A, efficiency=screw.eta, travel=screw.A, starts=run.starts,
                duration=run.duration,
            ))  # fmt: skip
        return tuple(found)

    def transmission(self, payload: float, environment: Environment) -> LinearTransmission:
        """The axis as a transmission whose lead can be chosen; screw and coupling are kept as they are."""
        g, lossy = environment.gravity, self.efficiency_covers == "load_side"
        A = self.transmission_constant
        resisting = float(self.constant_force(payload, g) + self.friction(payload, g))
        eta = self.efficiency
        if self.thread_friction is not None:
            eta = float(thread_efficiency(lead_angle(self.lead, self.nominal_diameter), self.thread_friction))
        return LinearTransmission(
            size="lead", constant=A, mass=float(self.moved_mass(payload)), resisting_force=resisting, efficiency=eta,
            front_inertia=0.0 if lossy else self.shaft_inertia, rear_inertia=self.shaft_inertia if lossy else 0.0,
        )  # fmt: skip

    def _screw(self, sheet: Sheet, environment: Environment, rotating: float) -> _Screw:
        drag = self.screw_friction_torque
        if self.screw_friction == "diameter_rule":
            drag = sheet(screw_friction_by_diameter, key="screw_friction_torque", D=self.nominal_diameter)
        eta = self.efficiency
        if self.thread_friction is not None:
            phi = sheet(lead_angle, h=self.lead, D=self.nominal_diameter)
            eta = sheet(thread_efficiency, key="efficiency", phi_h=phi, mu_th=self.thread_friction)
        if self.efficiency_covers == "load_side":
            sheet.decide("The efficiency acts on the whole load side", "chosen: inertia of the screw included")
        return _Screw(
            A=self.transmission_constant, eta=eta, covers_load_side=self.efficiency_covers == "load_side",
            model=environment.regeneration, rotating=rotating, drag=drag + self.preload_torque,
        )  # fmt: skip

    def _record_limit_speed(self, sheet: Sheet, motion: MotionProfile) -> None:
        a, stroke = float(np.abs(motion.acceleration).max()), float(np.ptp(motion.position))
        if a == 0 or stroke == 0:
            return
        limit = sheet(triangle_speed, key="limit_speed", symbol="v_lim", label="Limit speed: what the stroke allows",
                      s=stroke, a=a, a_d=a)  # fmt: skip
        if motion.max_speed < limit:
            sheet.decide("The stroke lets the axis reach its rapid speed", "the rapid speed is below the limit speed")

    def _cycle(
        self, screw: _Screw, motion: MotionProfile, environment: Environment, inertia: float
    ) -> tuple[LoadCycle, FloatArray]:
        """Load cycle at the screw, and the force on the nut in each of its segments [N]."""
        force = self.force(motion, environment.gravity)
        torque = np.where(motion.braked, 0.0, screw.torque(force, motion.mean_speed, motion.acceleration))
        cycle = LoadCycle(
            duration=motion.duration, speed_start=shaft_speed(motion.speed_start, screw.A),
            speed_end=shaft_speed(motion.speed_end, screw.A), torque=torque, braked=motion.braked, label=motion.label,
            inertia=inertia,
        )  # fmt: skip
        return cycle, force

    def _statics(
        self, sheet: Sheet, screw: _Screw, motion: MotionProfile, environment: Environment, friction: float
    ) -> Statics:
        rapid = motion.max_speed
        loads = sorted({float(motion.payload.min()), float(motion.payload.max())})
        with sheet.section("Friction without acceleration"):
            friction_torque = self._record_friction_torque(sheet, screw, friction)
        steady = []
        for key, title, label, v in (
            ("rest_torque_upward", "Constant speed in positive direction (up)", "Steady torque, up", rapid),
            ("rest_torque_downward", "Constant speed in negative direction (down)", "Steady torque, down", -rapid),
        ):
            with sheet.section(title):
                steady.append(self._steady(sheet, screw, environment, loads, v, key, label))
        forward, backward = steady
        with sheet.section("Standstill"):
            holding = self._record_holding(sheet, screw, holding_forces(self, motion, environment.gravity))
        with sheet.section("Constant speed with process force"):
            working, working_speed = self._working(sheet, screw, motion, environment)
        return Statics(
            friction=friction_torque, forward=forward, backward=backward, holding=holding, rapid_speed=rapid / screw.A,
            working=max(abs(forward), abs(backward)) if working is None else working,
            working_speed=working_speed if working is not None else rapid / screw.A,
        )  # fmt: skip

    def _record_friction_torque(self, sheet: Sheet, screw: _Screw, friction: float) -> float:
        label = "Torque of all friction, without acceleration"
        return screw.record(sheet, "friction_torque_on_screw", label, friction, 1.0, 0.0)

    def _steady(
        self, sheet: Sheet, screw: _Screw, environment: Environment, loads: list[float], v: float, key: str, label: str
    ) -> float:
        """Record the torque at a constant speed with the payload that asks for most."""
        direction = np.sign(v)
        parts = [
            [
                float(self.constant_force(load, environment.gravity)),
                float(self.friction(load, environment.gravity)) * direction,
                float(viscous_friction(self.viscous_coefficient, v)),
            ]
            for load in loads
        ]
        worst = max(parts, key=lambda forces: abs(screw.torque(sum(forces), v, 0.0)))
        force = sheet(sum_of_forces, key=f"{key}_force", label="Force on the nut", F_k=without_zeros(worst))
        return screw.record(sheet, key, label, force, v, 0.0)

    def _record_holding(self, sheet: Sheet, screw: _Screw, forces: list[float]) -> float:
        key, label = "holding_torque_at_screw", "Holding torque without the help of friction"
        force = sheet(sum_of_forces, key=f"{key}_force", label="Force on the nut", F_k=without_zeros(forces))
        return screw.record(sheet, key, label, force, 0.0, 0.0)

    def _working(
        self, sheet: Sheet, screw: _Screw, motion: MotionProfile, environment: Environment
    ) -> tuple[float | None, float]:
        """Largest steady torque with process force, None without one, and the highest speed of such a move [rad/s]."""
        acts = (motion.process_force != 0) & (motion.mean_speed != 0)
        if not acts.any():
            return None, 0.0
        ends = np.maximum(np.abs(motion.speed_start), np.abs(motion.speed_end)) * motion.direction
        level = replace(motion, speed_start=ends, speed_end=ends)
        torque = screw.torque(self.force(level, environment.gravity), ends, 0.0)
        worst = int(np.argmax(np.where(acts, np.abs(torque), -1.0)))
        force = self._record_force(sheet, "max_static_working_torque", level, worst, environment)
        label = "Steady torque with process force"
        found = screw.record(sheet, "max_static_working_torque", label, force, float(ends[worst]), 0.0)
        label = "Highest speed of the screw with process force"
        v = float(np.abs(ends[acts]).max())
        speed = sheet(shaft_speed, key="screw_speed_working", symbol="n_w", label=label, v=v, A=screw.A)
        return abs(found), speed

    def _decide_self_locking(self, sheet: Sheet, screw: _Screw, constant: float, friction: float) -> None:
        if constant == 0:
            return
        with sheet.section("Standstill"):
            if self.thread_friction is not None and np.tan(sheet.value("lead_angle")) <= self.thread_friction:
                sheet.decide("The screw is self-locking", "its lead angle is below the friction angle of the thread")
            elif regenerative_factor(screw.eta, screw.model) == 0:
                sheet.decide("The screw is self-locking", "by the chosen model the efficiency is 0.5 or less")
            if abs(constant) * screw.A <= friction * screw.A + screw.drag:
                sheet.decide("Friction alone holds the axis", "it exceeds the pull; holding is judged without its help")

    def _record_shares(self, sheet: Sheet, screw: _Screw, motion: MotionProfile, payload: float) -> None:
        """Record what the torque at the largest acceleration consists of, while it drives."""
        a = float(np.abs(motion.acceleration).max())
        if a == 0:
            return
        with sheet.section("Shares of the torque at the largest acceleration, driving"):
            label = "Angular acceleration of the screw"
            alpha_s = sheet(shaft_acceleration, key="angular_acceleration", label=label, a=a, A=screw.A)
            J_m = float(linear_mass_inertia(self.moved_mass(payload), screw.A))
            shares = (
                ("load_acceleration_torque", "Torque that accelerates the moved masses", J_m, True),
                ("screw_acceleration_torque", "Torque that accelerates screw and coupling", screw.rotating,
                 screw.covers_load_side),
            )  # fmt: skip
            parts = [self._record_share(sheet, screw, alpha_s, *share) for share in shares]
            label = "Torque that accelerates all masses"
            sheet(sum_of_torques, key="acceleration_torque_total", symbol="M_a", label=label, M_k=without_zeros(parts))

    def _record_share(
        self, sheet: Sheet, screw: _Screw, alpha_s: float, key: str, label: str, J: float, lossy: bool
    ) -> float:
        if not lossy or screw.eta == 1:
            return sheet(acceleration_torque, key=key, symbol="M_a", label=label, J=J, alpha_s=alpha_s)
        torque = sheet(
            acceleration_torque,
            key=f"{key}_without_loss",
            symbol="M_a0",
            label=f"{label}, without loss",
            J=J,
            alpha_s=alpha_s,
        )
        return record_stage(sheet, torque, 1.0, screw.eta, screw.model, key=key, symbol="M_a", label=label)

    def _record_force(self, sheet: Sheet, key: str, motion: MotionProfile, k: int, environment: Environment) -> float:
        """Record the force on the nut in segment ``k``."""
        g, load, moving = environment.gravity, float(motion.payload[k]), float(np.sign(motion.mean_speed[k]))
        parts = [
            float(self.constant_force(load, g)),
            float(self.friction(load, g)) * moving,
            float(viscous_friction(self.viscous_coefficient, motion.mean_speed[k])),
            float(motion.process_force[k] * motion.direction[k]),
        ]
        a = float(motion.acceleration[k])
        if a:
            parts.insert(0, sheet(acceleration_force, key=f"{key}_inertia_force", m=float(self.moved_mass(load)), a=a))
        label = "Force on the nut: inertia, weight, friction, process"
        return sheet(sum_of_forces, key=f"{key}_force", label=label, F_k=without_zeros(parts))

    def _record_segment(
        self, sheet: Sheet, screw: _Screw, motion: MotionProfile, k: int, environment: Environment, key: str
    ) -> float:
        force = self._record_force(sheet, key, motion, k, environment)
        speed, acceleration = float(motion.mean_speed[k]), float(motion.acceleration[k])
        return screw.record(sheet, key, "Torque at the screw", force, speed, acceleration)
