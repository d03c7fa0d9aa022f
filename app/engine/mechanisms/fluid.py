"""What fans and pumps share: a torque that grows with the speed, and nothing that is moved but the rotor."""

from abc import abstractmethod
from dataclasses import replace
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from app.engine.cycle import LoadCycle
from app.engine.diagram import Diagram, series
from app.engine.environment import Environment
from app.engine.errors import EngineError
from app.engine.formulas.conversion import acceleration_torque, sum_of_torques, torque_of_power
from app.engine.mechanisms.base import Mechanism
from app.engine.mechanisms.guided_axis import refused, split, without_zeros
from app.engine.mechanisms.load import Load, LoadState, Statics
from app.engine.mechanisms.phases import record_phases
from app.engine.mechanisms.states import steady_runs
from app.engine.motion.profile import MotionProfile
from app.engine.quantity import Quantity
from app.engine.sheet import Sheet

POINT, ROTOR = "Operating point", "Rotor"
SPEED_STEPS = 1024
"""Steps from standstill to the highest speed: twice as many move the torque by less than 0.1 %."""
CURVE_POINTS = 33
STANDARD_GRAVITY = 9.81
"""For judging inputs only [m/s2]"""


class FluidMachine(Mechanism):
    """A machine whose torque is known at one operating point and follows the laws of affinity elsewhere."""

    motion_kind: ClassVar[Literal["linear", "rotary"]] = "rotary"
    follows_course: ClassVar[bool] = True

    rated_speed: Annotated[
        float,
        Quantity("rpm", symbol="n_W", gt=0, le=3e4, group=POINT, about="speed of the operating point"),
    ]
    volume_flow: Annotated[
        float | None,
        Quantity("m3/h", symbol="Q", gt=0, le=1e3, default=None, group=POINT, about="volume flow"),
    ]
    rated_power: Annotated[
        float | None,
        Quantity("kW", symbol="P_W", gt=0, le=1e8, default=None, group=POINT,
                 about="power at the shaft, from the maker, instead of flow, pressure or head, and efficiency"),
    ]  # fmt: skip
    friction_torque: Annotated[
        float,
        Quantity("N m", symbol="M_f", ge=0, le=1e6, default=0.0, source="small against the rest", group=ROTOR,
                 about="friction of bearings and seals: part of the torque that does not depend on the speed"),
    ]  # fmt: skip
    rotor_inertia: Annotated[
        float,
        Quantity("kg m2", symbol="J_R", ge=0, le=1e6, group=ROTOR, about="inertia of the impeller with its shaft"),
    ]

    @abstractmethod
    def torque(self, speed: Any, rated: float, gravity: float) -> Any:
        """Steady torque at an unsigned speed [N m]; ``rated`` that of the operating point."""

    @abstractmethod
    def record_torque(self, sheet: Sheet, speed: float, rated: float, gravity: float, prefix: str) -> float:
        """The same on the sheet."""

    @abstractmethod
    def power(self, gravity: float) -> float:
        """Power of the operating point [W] from flow, pressure or head, and efficiency, all of which are given."""

    @abstractmethod
    def record_power(self, sheet: Sheet, gravity: float) -> float:
        """The same on the sheet."""

    def load_at_shaft(self, motion: MotionProfile, environment: Environment, sheet: Sheet) -> Load:
        """Load cycle at the shaft of the machine, ramps in small steps of the speed."""
        g = environment.gravity
        with sheet.section(POINT):
            power = self.rated_power if self.rated_power is not None else self.record_power(sheet, g)
            label = "Torque of the operating point"
            rated = sheet(torque_of_power, key="rated_load_torque", label=label, P=power,
                          omega=self.rated_speed)  # fmt: skip
        if rated < self.friction_torque:  # only where gravity is not that of the inputs' own check
            message = f"must be below the torque of the operating point, {rated:.4g} N m"
            raise EngineError(message, field=self.border_name("friction_torque"))
        course = _refined(motion)
        cycle = self._cycle(course, rated, g)
        self._record(sheet, course, cycle, rated, g)
        statics = self._statics(motion, rated, g)
        return Load(
            cycle=cycle, statics=statics, results={"rated_load_torque": rated},
            states=self._states(motion, rated, g), diagrams=(self._diagram(motion, rated, g),),
        )  # fmt: skip

    def _cycle(self, motion: MotionProfile, rated: float, gravity: float) -> LoadCycle:
        torque = (
            self.torque(np.abs(motion.mean_speed), rated, gravity) * np.sign(motion.mean_speed)
            + acceleration_torque(self.rotor_inertia + motion.payload, motion.acceleration)
            + motion.process_force * motion.direction
        )
        return LoadCycle(
            duration=motion.duration, speed_start=motion.speed_start, speed_end=motion.speed_end,
            torque=np.where(motion.braked, 0.0, torque), braked=motion.braked, label=motion.label,
            inertia=self.rotor_inertia + float(motion.payload.max()),
        )  # fmt: skip

    def _statics(self, motion: MotionProfile, rated: float, gravity: float) -> Statics:
        highest = motion.max_speed
        steady = float(self.torque(highest, rated, gravity))
        ends = np.maximum(np.abs(motion.speed_start), np.abs(motion.speed_end))
        acts = (motion.process_force != 0) & (motion.mean_speed != 0)
        working = np.abs(self.torque(ends, rated, gravity) + motion.process_force)[acts]
        standing = np.abs(motion.process_force[motion.mean_speed == 0])
        return Statics(
            friction=steady, forward=steady, backward=-steady, holding=float(standing.max(initial=0.0)),
            working=float(working.max()) if acts.any() else steady, rapid_speed=highest,
            working_speed=float(ends[acts].max()) if acts.any() else highest,
        )  # fmt: skip

    def _states(self, motion: MotionProfile, rated: float, gravity: float) -> tuple[LoadState, ...]:
        runs = steady_runs(motion, unit="kg m2")
        if len(runs) == 1:
            runs = (replace(runs[0], key="running", label="running"),)
        return tuple(
            LoadState(
                key=run.key, label=run.label, direction=run.direction, speed=run.speed,
                torque=float(self.torque(run.speed, rated, gravity)) + run.process_force,
                process_torque=run.process_force if run.at_speed_only else 0.0,
                inertia=self.rotor_inertia + run.payload, starts=run.starts, duration=run.duration,
                curve=tuple(
                    (float(speed), float(self.torque(speed, rated, gravity)) + run.process_force)
                    for speed in np.linspace(0.0, run.speed, CURVE_POINTS)
                ),
            )
            for run in runs
        )  # fmt: skip

    def _diagram(self, motion: MotionProfile, rated: float, gravity: float) -> Diagram:
        top = max(motion.max_speed, self.rated_speed)
        speeds = np.linspace(0.0, top, 101)
        highest = motion.max_speed
        lines = (
            series("torque of the machine", speeds, self.torque(speeds, rated, gravity)),
            series("operating point", [self.rated_speed], [rated], "point"),
            series("highest speed of the cycle", [highest] * 2, [0.0, self.torque(highest, rated, gravity)], "second"),
        )
        return Diagram("machine_torque", "Torque over the speed", "Speed", "rpm", "Torque", "N m", lines)

    def _record(self, sheet: Sheet, motion: MotionProfile, cycle: LoadCycle, rated: float, gravity: float) -> None:
        def write(k: int, prefix: str) -> None:
            parts = [float(motion.process_force[k] * motion.direction[k])]
            moving = float(motion.mean_speed[k])
            if moving:
                steady = self.record_torque(sheet, abs(moving), rated, gravity, prefix)
                parts.insert(0, steady * float(np.sign(moving)))
            alpha = float(motion.acceleration[k])
            J = self.rotor_inertia + float(motion.payload[k])
            if alpha and J:
                label = "Torque that accelerates the rotor"
                parts.append(sheet(acceleration_torque, key=f"{prefix}accelerating_torque", symbol="M_a", label=label,
                                   J=J, alpha_s=alpha))  # fmt: skip
            sheet(sum_of_torques, key=f"{prefix}shaft_torque", symbol="M", label="Torque at the shaft of the machine",
                  M_k=without_zeros(parts))  # fmt: skip

        record_phases(sheet, motion, cycle.torque, write)


def _refined(motion: MotionProfile) -> MotionProfile:
    """The same motion with its ramps in small steps."""
    if motion.max_speed == 0:
        return motion
    change = np.abs(motion.speed_end - motion.speed_start) / motion.max_speed
    return split(motion, np.maximum(np.ceil(change * SPEED_STEPS), 1).astype(int))


def consistent(machine: FluidMachine, others: tuple[str, ...]) -> None:
    """Refuse a machine without an operating point, or one whose friction takes more than its torque.

    ``others`` are needed with the flow where no power is given.
    """
    wanted = ("volume_flow", *others)
    given = [name for name in wanted if getattr(machine, name) is not None]
    if machine.rated_power is None:
        lacking = [name for name in wanted if name not in given]
        if lacking:
            known = "give the power at the shaft, or flow, pressure or head, and efficiency"
            raise refused(machine, lacking[0] if given else "rated_power", f"is missing: {known}")
    power = machine.power(STANDARD_GRAVITY) if machine.rated_power is None else machine.rated_power
    rated = float(torque_of_power(power, machine.rated_speed))
    if rated < machine.friction_torque:
        raise refused(machine, "friction_torque", f"must be below the torque of the operating point, {rated:.4g} N m")
