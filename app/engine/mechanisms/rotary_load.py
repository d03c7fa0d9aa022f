"""Rotary load: a turntable, drum, swivel arm or any other body that turns about a fixed axis."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal, Self

import numpy as np
from pydantic import Field, model_validator

from app.engine.cycle import LoadCycle
from app.engine.environment import Environment
from app.engine.formulas.belt import pulley_transmission
from app.engine.formulas.conversion import acceleration_torque, linear_speed, linear_way, sum_of_torques
from app.engine.formulas.inertia import sum_of_inertias
from app.engine.formulas.rotary import bearing_friction_torque, unbalance_amplitude, unbalance_torque
from app.engine.mechanisms.base import Mechanism
from app.engine.mechanisms.bodies import AnyBody
from app.engine.mechanisms.guided_axis import refused, split
from app.engine.mechanisms.load import Load, LoadState, Statics
from app.engine.mechanisms.phases import record_phases
from app.engine.mechanisms.states import steady_runs
from app.engine.motion.profile import FloatArray, MotionProfile
from app.engine.quantity import Declaration, Option, Quantity
from app.engine.sheet import Sheet

RESISTANCES = "Resistances"
RIM = "Rim"
UNBALANCE = "Unbalance"
ANGLE_STEP = np.pi / 90
"""Steps in which the torque of an unbalance is followed: 2 degrees, exact within 0.02 % [rad]"""
MOST_STEPS = 20_000
"""Beyond so many steps the unbalance is taken at its worst throughout."""


@dataclass(frozen=True)
class _Resistances:
    """Torques on the axis [N m]."""

    friction: float
    external: float
    unbalance: float
    """Amplitude: largest torque of the unbalance"""
    by_angle: bool
    start_angle: float

    def constant(self, motion: MotionProfile, inertia: float) -> FloatArray:
        """Torque of unbalance and external torque in each segment, shape (n,)."""
        if self.by_angle:
            middle = (motion.position[:-1] + motion.position[1:]) / 2
            return self.external + np.asarray(unbalance_torque(self.unbalance, self.start_angle + middle))
        # taken against the motor: it adds to whatever else the motor must give in this segment
        others = (
            acceleration_torque(inertia + motion.payload, motion.acceleration)
            + self.friction * np.sign(motion.mean_speed)
            + motion.process_force * motion.direction
            + self.external
        )
        side = np.where(others == 0, motion.direction, np.sign(others))
        found: FloatArray = self.external + self.unbalance * side
        return found


class RotaryLoad(Mechanism):
    """Any body that turns about a fixed axis. The drive's output shaft is that axis, or the input of a stage."""

    title: ClassVar[str] = "Rotary load"
    summary: ClassVar[str] = "Turntable, indexing disc, drum or swivel arm, with or without a stage before it."
    drawing: ClassVar[str] = "rotary_load.svg"
    motion_kind: ClassVar[Literal["linear", "rotary"]] = "rotary"

    kind: Literal["rotary_load"] = "rotary_load"
    bodies: Annotated[
        tuple[AnyBody, ...],
        Field(min_length=1, max_length=50),
        Option(group="Turning bodies", about="bodies that turn with the load"),
    ]
    friction_torque: Annotated[
        float,
        Quantity(
            "N m", symbol="M_f", ge=0, le=1e7, default=0.0, source="none given", group=RESISTANCES,
            about="constant friction torque of seals, slip rings and guides",
        ),
    ]  # fmt: skip
    bearing_diameter: Annotated[
        float | None,
        Quantity(
            "mm", symbol="d_L", gt=0, le=50, default=None, group=RESISTANCES,
            about="mean diameter of the bearing that carries the weight; without it the bearing is left out",
        ),
    ]  # fmt: skip
    bearing_friction: Annotated[
        float,
        Quantity(
            "1", symbol="mu_L", ge=0, le=1, default=0.005, source="SEW 2001, 17.1: rolling bearing", group=RESISTANCES,
            about="coefficient of bearing friction",
        ),
    ]  # fmt: skip
    rim_diameter: Annotated[
        float | None,
        Quantity(
            "mm", symbol="D", gt=0, le=100, default=None, group=RIM,
            about="diameter at which ways, speeds and accelerations are told, e.g. the rim of a table",
        ),
    ]  # fmt: skip
    permissible_acceleration: Annotated[
        float | None,
        Quantity(
            "m/s2", symbol="a_p", gt=0, le=1000, default=None, group=RIM,
            about="acceleration that the goods bear at that diameter; empty: no limit",
        ),
    ]  # fmt: skip
    external_torque: Annotated[
        float,
        Quantity(
            "N m", symbol="M_e", ge=-1e7, le=1e7, default=0.0, source="none given", group=RESISTANCES,
            about="constant torque against the positive direction, whatever the motion",
        ),
    ]  # fmt: skip
    axis_tilt: Annotated[
        float,
        Quantity(
            "deg", symbol="delta", ge=0, le=np.pi / 2, default=0.0, group=UNBALANCE, source="vertical axis",
            about="tilt of the axis of rotation: 0 vertical, 90 horizontal",
        ),
    ]  # fmt: skip
    unbalance_mass: Annotated[
        float,
        Quantity(
            "kg", symbol="m_u", ge=0, le=1e7, default=0.0, group=UNBALANCE, source="balanced",
            about="mass beside the axis whose weight makes a torque; its inertia belongs to the bodies",
        ),
    ]  # fmt: skip
    unbalance_radius: Annotated[
        float,
        Quantity(
            "mm", symbol="r_u", ge=0, le=100, default=0.0, group=UNBALANCE, source="balanced",
            about="distance of that mass from the axis",
        ),
    ]  # fmt: skip
    unbalance_follows: Annotated[
        Literal["worst_case", "angle"],
        Option(
            default="worst_case", group=UNBALANCE, about="how the torque of the unbalance is counted",
            source="safe without knowing the angle",
            labels={"worst_case": "always at its largest, against the motor", "angle": "by the angle of the load"},
        ),
    ]  # fmt: skip
    start_angle: Annotated[
        float,
        Quantity(
            "deg", symbol="phi_0", ge=-2 * np.pi, le=2 * np.pi, default=0.0, group=UNBALANCE, source="arm level",
            about="angle of the arm above level at the start, rising in positive direction",
        ),
    ]  # fmt: skip

    @model_validator(mode="after")
    def _an_unbalance_has_an_arm(self) -> Self:
        if bool(self.unbalance_mass) != bool(self.unbalance_radius):
            lacking = "unbalance_radius" if self.unbalance_mass else "unbalance_mass"
            raise refused(self, lacking, "mass and radius of the unbalance belong together; give both or neither")
        return self

    @model_validator(mode="after")
    def _a_limit_needs_its_diameter(self) -> Self:
        if self.permissible_acceleration is not None and self.rim_diameter is None:
            raise refused(self, "rim_diameter", "is needed for the permissible acceleration")
        return self

    def defaults_taken(self) -> Iterator[tuple[str, Declaration, Any]]:
        """As in the base, without those that do not count here."""
        idle = set() if self.bearing_diameter is not None else {"bearing_friction"}
        if not self.unbalance_mass:
            idle |= {"axis_tilt", "unbalance_mass", "unbalance_radius", "unbalance_follows", "start_angle"}
        elif self.unbalance_follows == "worst_case":
            idle.add("start_angle")
        yield from (found for found in super().defaults_taken() if found[0] not in idle)

    def load_at_shaft(self, motion: MotionProfile, environment: Environment, sheet: Sheet) -> Load:
        """Load cycle at the axis, or at the input of the stage before it."""
        inertia = self._record_inertia(sheet)
        resistances = self._resistances(sheet, motion, environment)
        course = motion
        self._record_rim(sheet, motion)
        if resistances.by_angle:
            motion = split(motion, _angle_steps(motion))
        cycle = _cycle(motion, inertia, resistances)
        self._record_phases(sheet, motion, cycle, inertia, resistances)
        one_way = resistances.unbalance == 0 and resistances.external == 0
        return Load(
            cycle=cycle,
            statics=_statics(motion, resistances),
            opposite=None if one_way else _cycle(motion.mirrored(), inertia, resistances),
            results={"load_inertia_at_axis": cycle.inertia},
            states=self._states(course, inertia, resistances),
        )

    def _record_inertia(self, sheet: Sheet) -> float:
        with sheet.section("Turning bodies"):
            parts = [
                body.record_inertia(sheet, f"body_{number}_inertia", f"Inertia of body {number}")
                for number, body in enumerate(self.bodies, start=1)
            ]
            label = "Inertia of all bodies about the axis"
            return sheet(sum_of_inertias, key="load_inertia", symbol="J_L", label=label, J_k=parts)

    def _resistances(self, sheet: Sheet, motion: MotionProfile, environment: Environment) -> _Resistances:
        with sheet.section("Resistances"):
            parts = [self.friction_torque]
            if self.bearing_diameter is not None:
                mass = sum(body.total_mass for body in self.bodies)
                mu_L, g, d_L = self.bearing_friction, environment.gravity, self.bearing_diameter
                parts.append(sheet(bearing_friction_torque, mu_L=mu_L, m=mass, g=g, d_L=d_L))
            label = "Friction torque of the axis"
            friction = sheet(sum_of_torques, key="friction_torque", symbol="M_f", label=label, M_k=parts)
            amplitude = 0.0
            if self.unbalance_mass:
                amplitude = sheet(unbalance_amplitude, symbol="M_u0", m_u=self.unbalance_mass, g=environment.gravity,
                                  r_u=self.unbalance_radius, delta=self.axis_tilt)  # fmt: skip
            by_angle = amplitude > 0 and self._can_follow_angle(sheet, motion)
            return _Resistances(friction, self.external_torque, amplitude, by_angle, self.start_angle)

    def _record_rim(self, sheet: Sheet, motion: MotionProfile) -> None:
        """Write way, speed and acceleration at the rim."""
        if self.rim_diameter is None:
            return
        with sheet.section(RIM):
            A = sheet(pulley_transmission, key="rim_radius", label="Way at the rim per radian", d=self.rim_diameter)
            swept = float(np.ptp(motion.position))
            sheet(linear_way, key="rim_way", label="Way at the rim over the cycle", phi=swept, A=A)
            sheet(linear_speed, key="rim_speed", label="Highest speed at the rim", omega=motion.max_speed, A=A)

    def _states(self, motion: MotionProfile, inertia: float, resistances: _Resistances) -> tuple[LoadState, ...]:
        """States of load at the axis, the unbalance at its worst."""
        one_way = resistances.unbalance == 0 and resistances.external == 0
        return tuple(
            LoadState(
                key=run.key, label=run.label, direction=run.direction,
                torque=resistances.friction + resistances.unbalance + run.direction * resistances.external
                + run.process_force,
                process_torque=run.process_force if run.at_speed_only else 0.0,
                inertia=inertia + run.payload, speed=run.speed,
                travel=None if self.rim_diameter is None else self.rim_diameter / 2,
                permissible_acceleration=self.permissible_acceleration, starts=run.starts, duration=run.duration,
            )
            for run in steady_runs(motion, both_directions=not one_way, unit="kg m2")
        )  # fmt: skip

    def _can_follow_angle(self, sheet: Sheet, motion: MotionProfile) -> bool:
        if self.unbalance_follows == "worst_case":
            return False
        text = "The unbalance is taken at its largest throughout"
        turns = float(motion.position[-1]) / (2 * np.pi)
        if abs(turns - round(turns)) > 1e-6:
            sheet.decide(text, "the cycle ends at another angle than it began, so in time it meets every angle")
            return False
        if _angle_steps(motion).sum() > MOST_STEPS:
            sheet.decide(text, "the cycle has too many turns to follow the angle")
            return False
        return True

    def _record_phases(
        self, sheet: Sheet, motion: MotionProfile, cycle: LoadCycle, inertia: float, resistances: _Resistances
    ) -> None:
        constant = resistances.constant(motion, inertia)

        def write(k: int, prefix: str) -> None:
            process = float(motion.process_force[k] * motion.direction[k])
            parts = [
                resistances.friction * float(np.sign(motion.mean_speed[k])),
                float(constant[k]),
                process,
            ]
            if motion.acceleration[k] != 0:
                J, label = inertia + float(motion.payload[k]), "Torque that accelerates the load"
                alpha = float(motion.acceleration[k])
                key = f"{prefix}accelerating_torque"
                parts.insert(0, sheet(acceleration_torque, key=key, symbol="M_a", label=label, J=J, alpha_s=alpha))
            label = "Torque at the axis"
            nonzero = [part for part in parts if part] or [0.0]
            sheet(sum_of_torques, key=f"{prefix}load_torque", symbol="M_L", label=label, M_k=nonzero)

        record_phases(sheet, motion, cycle.torque, write)


def _angle_steps(motion: MotionProfile) -> np.ndarray[Any, np.dtype[np.int_]]:
    """How often each segment is cut so that no piece turns by more than :data:`ANGLE_STEP`, shape (n,)."""
    return np.maximum(np.ceil(np.abs(np.diff(motion.position)) / ANGLE_STEP - 1e-9), 1).astype(int)


def _cycle(motion: MotionProfile, inertia: float, resistances: _Resistances) -> LoadCycle:
    torque = (
        acceleration_torque(inertia + motion.payload, motion.acceleration)
        + resistances.friction * np.sign(motion.mean_speed)
        + resistances.constant(motion, inertia)
        + motion.process_force * motion.direction
    )
    return LoadCycle(
        duration=motion.duration,
        speed_start=motion.speed_start,
        speed_end=motion.speed_end,
        torque=np.where(motion.braked, 0.0, torque),
        braked=motion.braked,
        label=motion.label,
        inertia=inertia + float(motion.payload.max()),
    )


def _statics(motion: MotionProfile, resistances: _Resistances) -> Statics:
    """Torques without acceleration, with the unbalance at its worst."""
    against, external, friction = resistances.unbalance, resistances.external, resistances.friction
    working = (motion.process_force != 0) & (motion.mean_speed != 0)
    relevant = working if working.any() else motion.mean_speed != 0
    process = np.where(motion.braked, motion.process_force * motion.direction, 0.0)
    # the brake also holds what the process asks of it, in either direction of the motion
    helped = np.concatenate((external + process, external - process))
    held = float(helped[np.abs(helped).argmax()])
    steady = (friction + against) * motion.direction + external + motion.process_force * motion.direction
    speed = np.maximum(np.abs(motion.speed_start), np.abs(motion.speed_end))
    return Statics(
        friction=friction,
        forward=friction + against + external,
        backward=external - friction - against,
        holding=held + float(np.copysign(against, held)),
        working=float(np.abs(steady[relevant]).max()) if relevant.any() else 0.0,
        rapid_speed=motion.max_speed,
        working_speed=float(speed[relevant].max()) if relevant.any() else 0.0,
    )
