"""An axis whose shaft moves a body in a straight line with a constant transmission: from forces to torques and cycle.

Belt, rack and conveyor describe themselves as a :class:`LinearAxis`; the same formula functions then serve the arrays
over the cycle and the steps on the sheet.
"""

from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from app.engine.cycle import LoadCycle
from app.engine.environment import Environment
from app.engine.formulas.conversion import (
    acceleration_torque,
    shaft_acceleration,
    shaft_speed,
    sum_of_torques,
    torque_of_force,
)
from app.engine.formulas.efficiency import RegenerationModel, record_stage, through_stage
from app.engine.formulas.inertia import linear_mass_inertia, sum_of_inertias
from app.engine.formulas.resistance import acceleration_force, sum_of_forces, viscous_friction
from app.engine.mechanisms.load import LoadState, Statics
from app.engine.mechanisms.phases import record_phases
from app.engine.mechanisms.states import TRAVELLING, Words, steady_runs
from app.engine.motion.profile import FloatArray, MotionProfile
from app.engine.sheet import Sheet
from app.engine.transmission import LinearTransmission

SHOWN_PAYLOADS = 4
"""Weight and friction are written out for so many different payloads."""


class MovedBody(Protocol):
    """What is moved, without its payload, which comes with the motion: see GuidedAxis."""

    @property
    def viscous_coefficient(self) -> float:
        """Friction per speed [N s/m]."""

    @property
    def inclined(self) -> bool:
        """Whether the two directions differ."""

    def moved_mass(self, payload: Any) -> Any:
        """All mass that is accelerated [kg]."""

    def constant_force(self, payload: Any, gravity: float) -> Any:
        """Force against the positive direction whatever the motion [N]."""

    def friction(self, payload: Any, gravity: float) -> Any:
        """Unsigned friction without the viscous part [N]."""

    def force(self, motion: MotionProfile, gravity: float) -> FloatArray:
        """Force that moves the body in each segment, shape (n,) [N]."""

    def record_forces(self, sheet: Sheet, payload: float, environment: Environment) -> tuple[float, float]:
        """Record constant force and friction with one payload."""


def force_on(body: MovedBody, motion: MotionProfile, gravity: float) -> FloatArray:
    """Force that moves a body without viscous friction in each segment, positive forward, shape (n,) [N]."""
    found: FloatArray = (
        acceleration_force(body.moved_mass(motion.payload), motion.acceleration)
        + body.constant_force(motion.payload, gravity)
        + body.friction(motion.payload, gravity) * np.sign(motion.mean_speed)
        + motion.process_force * motion.direction
    )
    return found


@dataclass(frozen=True)
class AxisWords:
    """How one kind of axis calls its force and its shaft."""

    force: str
    """Step key of the force between shaft and moving mass, e.g. ``"tangential_force"``."""
    force_label: str
    shaft: str
    """e.g. ``"pinion"``: step keys ``pinion_torque``, ``pinion_speed``."""


@dataclass(frozen=True, kw_only=True)
class LinearAxis:
    """One axis in SI."""

    body: MovedBody
    words: AxisWords
    constant: float
    """A: travel per radian of the shaft [m/rad]"""
    efficiency: float
    added_mass: float = 0.0
    """Mass that moves beside the body without friction or weight of its own: the belt [kg]"""
    front_inertia: float = 0.0
    """On the shaft, before the losses [kg m2]"""
    rear_inertia: float = 0.0
    """Turning with the shaft, behind the losses [kg m2]"""
    driven_inertia: float = 0.0
    """Part of the rear inertia that the force between shaft and axis turns: idlers [kg m2]"""

    def moved_mass(self, payload: Any) -> Any:
        """All mass moved in a straight line [kg]."""
        return self.body.moved_mass(payload) + self.added_mass

    def force(self, motion: MotionProfile, gravity: float) -> FloatArray:
        """Force between shaft and moving mass over the segments [N], in positive direction."""
        force: FloatArray = self.body.force(motion, gravity) + acceleration_force(self.added_mass, motion.acceleration)
        return force

    def torque(self, force: Any, acceleration: Any, speed: Any, model: RegenerationModel) -> Any:
        """Torque at the shaft [N m] of a force on the axis, an acceleration and a direction of motion of the axis."""
        alpha = shaft_acceleration(acceleration, self.constant)
        net = torque_of_force(force, self.constant) + acceleration_torque(self.rear_inertia, alpha)
        passed = through_stage(net, speed, self.efficiency, model)
        return passed + acceleration_torque(self.front_inertia, alpha)

    def inertia(self, payload: float) -> float:
        """All inertia referred to the shaft [kg m2]."""
        moved = linear_mass_inertia(self.moved_mass(payload), self.constant)
        return float(moved + self.front_inertia + self.rear_inertia)

    def cycle(self, motion: MotionProfile, environment: Environment) -> LoadCycle:
        """The load cycle at the shaft."""
        force = self.force(motion, environment.gravity)
        torque = self.torque(force, motion.acceleration, motion.mean_speed, environment.regeneration)
        return LoadCycle(
            duration=motion.duration,
            speed_start=shaft_speed(motion.speed_start, self.constant),
            speed_end=shaft_speed(motion.speed_end, self.constant),
            torque=np.where(motion.braked, 0.0, torque),
            braked=motion.braked,
            label=motion.label,
            inertia=self.inertia(float(motion.payload.max())),
        )

    def opposite(self, motion: MotionProfile, environment: Environment) -> LoadCycle | None:
        """The same motion in the opposite direction, where that makes a difference."""
        return self.cycle(motion.mirrored(), environment) if self.body.inclined else None

    def states(
        self,
        motion: MotionProfile,
        environment: Environment,
        *,
        permissible_acceleration: float | None = None,
        also_unladen: bool = False,
        words: Words = TRAVELLING,
    ) -> tuple[LoadState, ...]:
        """States of load at the shaft, in both directions where they differ; see :func:`steady_runs`."""
        g = environment.gravity
        runs = steady_runs(motion, both_directions=self.body.inclined, also_unladen=also_unladen, words=words)
        found = []
        for run in runs:
            parts = [
                run.direction * float(self.body.constant_force(run.payload, g)),
                float(self.body.friction(run.payload, g)),
                float(viscous_friction(self.body.viscous_coefficient, run.speed)),
                run.process_force,
            ]
            inertia = linear_mass_inertia(self.moved_mass(run.payload), self.constant) + self.rear_inertia
            found.append(LoadState(
                key=run.key, label=run.label, direction=run.direction,
                torque=float(torque_of_force(sum(parts), self.constant)), inertia=float(inertia),
                front_inertia=self.front_inertia, speed=run.speed / self.constant, efficiency=self.efficiency,
                process_torque=run.process_force * self.constant if run.at_speed_only else 0.0,
                travel=self.constant, permissible_acceleration=permissible_acceleration, starts=run.starts,
                duration=run.duration,
            ))  # fmt: skip
        return tuple(found)

    def statics(self, motion: MotionProfile, environment: Environment) -> Statics:
        """Torques without acceleration, each with the payload of the cycle that asks for most."""
        model, g = environment.regeneration, environment.gravity
        resisting = self.resisting(float(motion.payload.max()), motion, g)
        working = (motion.process_force != 0) & (motion.mean_speed != 0)
        relevant = working if working.any() else motion.mean_speed != 0
        accelerating = acceleration_force(self.moved_mass(motion.payload), motion.acceleration)
        steady = self.torque(self.force(motion, g) - accelerating, 0.0, motion.mean_speed, model)
        speed = np.maximum(np.abs(motion.speed_start), np.abs(motion.speed_end))
        return Statics(
            friction=resisting * self.constant,
            forward=float(self.torque(sum(self.steady_forces(motion, environment, 1.0)), 0.0, 1.0, model)),
            backward=float(self.torque(sum(self.steady_forces(motion, environment, -1.0)), 0.0, -1.0, model)),
            holding=sum(holding_forces(self.body, motion, g)) * self.constant,
            working=_largest(steady, relevant),
            rapid_speed=motion.max_speed / self.constant,
            working_speed=_largest(speed, relevant) / self.constant,
        )

    def resisting(self, payload: float, motion: MotionProfile, gravity: float) -> float:
        """Unsigned friction at the highest speed of the cycle [N]."""
        viscous = viscous_friction(self.body.viscous_coefficient, motion.max_speed)
        return float(self.body.friction(payload, gravity) + viscous)

    def steady_forces(self, motion: MotionProfile, environment: Environment, direction: float) -> tuple[float, float]:
        """Constant force and friction [N] at constant speed, with the payload of the largest torque: not always the
        largest one, since a counterweight may outweigh an empty slide.
        """
        g, model = environment.gravity, environment.regeneration
        cases = [
            (float(self.body.constant_force(payload, g)), direction * self.resisting(payload, motion, g))
            for payload in (float(motion.payload.max()), float(motion.payload.min()))
        ]
        return max(cases, key=lambda forces: abs(self.torque(sum(forces), 0.0, direction, model)))

    def largest_force(self, motion: MotionProfile, environment: Environment) -> float:
        """Largest unsigned force between shaft and axis [N], in both directions of an inclined axis.

        A brake sits on the motor, so what it holds passes here too.
        """
        runs = [motion, motion.mirrored()] if self.body.inclined else [motion]
        driven = self.driven_inertia / self.constant**2
        found = [self.force(run, environment.gravity) + driven * run.acceleration for run in runs]
        return float(np.abs(found).max())

    def transmission(self, payload: float, environment: Environment) -> LinearTransmission:
        """The axis as a transmission whose diameter can be chosen; its rotating parts are kept as they are."""
        g = environment.gravity
        return LinearTransmission(
            size="diameter",
            constant=self.constant,
            mass=float(self.moved_mass(payload)),
            front_inertia=self.front_inertia,
            rear_inertia=self.rear_inertia,
            resisting_force=float(self.body.constant_force(payload, g) + self.body.friction(payload, g)),
            efficiency=self.efficiency,
        )


def holding_forces(body: MovedBody, motion: MotionProfile, gravity: float) -> list[float]:
    """Pull and process force at the standstill that is hardest to hold [N], signed, friction not counted.

    Any payload of the cycle counts, the process force where the brake must hold against it; in both directions of an
    inclined axis.
    """
    pull = np.broadcast_to(body.constant_force(motion.payload, gravity), motion.payload.shape)
    process = np.where(motion.braked, motion.process_force * motion.direction, 0.0)
    ways = [0.0 * process, process, -process] if body.inclined else [0.0 * process, process]
    largest = max(ways, key=lambda way: float(np.abs(pull + way).max()))
    k = int(np.abs(pull + largest).argmax())
    return [float(pull[k]), float(largest[k])]


def record_axis(
    axis: LinearAxis, sheet: Sheet, motion: MotionProfile, cycle: LoadCycle, environment: Environment
) -> None:
    """Write inertia, speed, forces and torques of one axis: of each payload, phase and direction."""
    _record_inertia(axis, sheet, motion)
    for payload in sorted(set(motion.payload.tolist()), reverse=True)[:SHOWN_PAYLOADS]:
        with sheet.section(f"Weight and friction with {payload:g} kg payload"):
            axis.body.record_forces(sheet, payload, environment)

    def write(k: int, prefix: str) -> None:
        force = _record_force(axis, sheet, motion, environment, k, prefix)
        alpha = float(cycle.acceleration[k])
        _record_torque(axis, sheet, force, alpha, float(motion.mean_speed[k]), environment.regeneration, prefix)

    record_phases(sheet, motion, cycle.torque, write)
    _record_statics(axis, sheet, motion, environment)


def _record_inertia(axis: LinearAxis, sheet: Sheet, motion: MotionProfile) -> None:
    name, payload = axis.words.shaft, float(motion.payload.max())
    with sheet.section("Inertia and speed"):
        moved = sheet(
            linear_mass_inertia,
            key=f"moved_inertia_on_{name}",
            symbol="J_m",
            label=f"Moved mass, payload included, as inertia of the {name}",
            m=axis.moved_mass(payload),
            A=axis.constant,
        )
        sheet(
            sum_of_inertias,
            key=f"load_inertia_at_{name}",
            symbol="J_L",
            label=f"Load inertia at the {name} shaft",
            J_k=_without_zeros([moved, axis.front_inertia, axis.rear_inertia]),
        )
        sheet(
            shaft_speed,
            key=f"{name}_speed",
            symbol="n",
            label=f"Highest speed of the {name} shaft",
            v=motion.max_speed,
            A=axis.constant,
        )
        sheet(
            shaft_acceleration,
            key=f"{name}_acceleration",
            symbol="alpha",
            label=f"Largest angular acceleration of the {name} shaft",
            a=float(np.abs(motion.acceleration).max()),
            A=axis.constant,
        )


def _record_force(
    axis: LinearAxis, sheet: Sheet, motion: MotionProfile, environment: Environment, k: int, prefix: str
) -> float:
    payload, g, speed = float(motion.payload[k]), environment.gravity, float(motion.mean_speed[k])
    parts = [
        float(axis.body.constant_force(payload, g)),
        float(axis.body.friction(payload, g)) * float(np.sign(speed)),
        float(viscous_friction(axis.body.viscous_coefficient, speed)),
        float(motion.process_force[k] * motion.direction[k]),
    ]
    if motion.acceleration[k] != 0:
        accelerating = sheet(
            acceleration_force,
            key=f"{prefix}accelerating_force",
            symbol="F_a",
            m=axis.moved_mass(payload),
            a=float(motion.acceleration[k]),
        )
        parts.insert(0, accelerating)
    return sheet(
        sum_of_forces,
        key=f"{prefix}{axis.words.force}",
        symbol="F",
        label=axis.words.force_label,
        F_k=_without_zeros(parts),
    )


def _record_torque(
    axis: LinearAxis, sheet: Sheet, force: float, alpha: float, speed: float, model: RegenerationModel, prefix: str
) -> None:
    name = axis.words.shaft
    net = _record_moment(axis, sheet, force, prefix)
    if axis.rear_inertia and alpha:
        turning = sheet(
            acceleration_torque,
            key=f"{prefix}rotating_parts_torque",
            symbol="M_a",
            label="Torque that accelerates the rotating parts",
            J=axis.rear_inertia,
            alpha_s=alpha,
        )
        net = sheet(
            sum_of_torques, key=f"{prefix}net_torque", symbol="M_n", label="Net torque, no losses", M_k=[net, turning]
        )
    label = f"Torque at the {name} shaft"
    own = axis.front_inertia if alpha else 0.0
    key = f"{prefix}torque_with_losses" if own else f"{prefix}{name}_torque"
    passed = record_stage(sheet, net, speed, axis.efficiency, model, key=key, symbol="M", label=label)
    if own:
        turning = sheet(
            acceleration_torque,
            key=f"{prefix}{name}_inertia_torque",
            symbol="M_a1",
            label=f"Torque that accelerates the {name} itself",
            J=own,
            alpha_s=alpha,
        )
        sheet(sum_of_torques, key=f"{prefix}{name}_torque", symbol="M", label=f"{label}, all", M_k=[passed, turning])
    elif net * speed == 0:  # at standstill no power passes and nothing is lost
        sheet(sum_of_torques, key=key, symbol="M", label=label, M_k=[passed])


def _record_moment(axis: LinearAxis, sheet: Sheet, force: float, prefix: str) -> float:
    label = f"Torque of the force on the {axis.words.shaft}"
    return sheet(torque_of_force, key=f"{prefix}torque_of_force", symbol="M_F", label=label, F=force, A=axis.constant)


def _record_statics(axis: LinearAxis, sheet: Sheet, motion: MotionProfile, environment: Environment) -> None:
    name = axis.words.shaft
    with sheet.section("Constant speed without process force, and standstill"):
        for key, direction in (("forward", 1.0), ("backward", -1.0)):
            way = "positive direction" if direction > 0 else "negative direction"
            force = sheet(
                sum_of_forces,
                key=f"force_{key}",
                symbol="F_st",
                label=f"Force at constant speed, {way}",
                F_k=_without_zeros(list(axis.steady_forces(motion, environment, direction))),
            )
            moment = _record_moment(axis, sheet, force, f"{key}_")
            label = f"Torque at the {name} shaft at constant speed, {way}"
            key, model = f"{name}_torque_{key}", environment.regeneration
            record_stage(sheet, moment, direction, axis.efficiency, model, key=key, symbol="M_st", label=label)
        held = _without_zeros(holding_forces(axis.body, motion, environment.gravity))
        if any(held):
            label = "Force to be held at standstill, without the help of friction"
            force = sheet(sum_of_forces, key="holding_force", symbol="F_H", label=label, F_k=held)
            label = "Holding torque at standstill"
            sheet(torque_of_force, key="holding_torque", symbol="M_H", label=label, F=force, A=axis.constant)


def _largest(values: Any, where: NDArray[np.bool_]) -> float:
    chosen = np.abs(np.broadcast_to(values, where.shape)[where])
    return float(chosen.max()) if chosen.size else 0.0


def _without_zeros(parts: list[float]) -> list[float]:
    return [part for part in parts if part] or [0.0]
