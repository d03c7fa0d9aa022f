"""Winder and unwinder: a reel whose diameter and inertia change while a web under tension runs on or off."""

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal, Self

import numpy as np
from pydantic import model_validator

from app.engine.cycle import LoadCycle
from app.engine.diagram import Diagram, series
from app.engine.environment import Environment
from app.engine.formulas import winder as formulas
from app.engine.formulas.belt import pulley_transmission
from app.engine.formulas.conversion import (
    acceleration_torque,
    mechanical_power,
    shaft_speed,
    sum_of_torques,
    torque_of_force,
)
from app.engine.formulas.inertia import linear_mass_inertia
from app.engine.formulas.resistance import acceleration_force, sum_of_forces
from app.engine.mechanisms.base import Mechanism
from app.engine.mechanisms.guided_axis import refused, split, without_zeros
from app.engine.mechanisms.load import Load, Statics
from app.engine.mechanisms.phases import record_phases
from app.engine.motion.profile import FloatArray, MotionProfile
from app.engine.quantity import Option, Quantity
from app.engine.sheet import Sheet

REEL, WEB = "Reel", "Web"
DIAMETER_STEP = 5e-4
"""Relative change of the diameter over which it counts as constant."""
RAMP_PIECES = 128
MOST_PIECES = 20_000
"""Beyond so many the pieces become coarser."""


@dataclass(frozen=True)
class _Course:
    """Motion in pieces over which the reel hardly grows; diameters at borders (n + 1,) and in the middle (n,)."""

    motion: MotionProfile
    borders: FloatArray
    diameter: FloatArray

    @property
    def shaft_speeds(self) -> tuple[FloatArray, FloatArray]:
        """Angular speed of the reel at the start and at the end of each piece [rad/s]."""
        radii = pulley_transmission(self.borders)
        return shaft_speed(self.motion.speed_start, radii[:-1]), shaft_speed(self.motion.speed_end, radii[1:])


class Winder(Mechanism):
    """A reel driven at its axis. Its shaft is that axis; the motion is that of the web."""

    title: ClassVar[str] = "Winder"
    summary: ClassVar[str] = "Winding or unwinding a web under tension: the diameter grows, the speed falls."
    drawing: ClassVar[str] = "winder.svg"
    motion_kind: ClassVar[Literal["linear", "rotary"]] = "linear"
    follows_course: ClassVar[bool] = True
    one_way: ClassVar[bool] = True

    kind: Literal["winder"] = "winder"
    core_diameter: Annotated[
        float, Quantity("mm", symbol="D_K", gt=0, le=10, group=REEL, about="diameter of the empty core")
    ]
    full_diameter: Annotated[
        float, Quantity("mm", symbol="D_max", gt=0, le=20, group=REEL, about="largest diameter of the reel")
    ]
    start_diameter: Annotated[
        float | None,
        Quantity("mm", symbol="D_0", gt=0, le=20, default=None, group=REEL,
                 about="diameter at the start; empty: the core when winding, the full reel when unwinding"),
    ]  # fmt: skip
    core_inertia: Annotated[
        float,
        Quantity("kg m2", symbol="J_K", ge=0, le=1e6, default=0.0, source="left out until given", group=REEL,
                 about="inertia of core, chuck and shaft"),
    ]  # fmt: skip
    friction_torque: Annotated[
        float,
        Quantity("N m", symbol="M_f", ge=0, le=1e6, default=0.0, source="none given", group=REEL,
                 about="friction of bearings and brakes of the reel"),
    ]  # fmt: skip
    task: Annotated[
        Literal["wind", "unwind"],
        Option(default="wind", source="winder", group=WEB, about="what the reel does while the web runs forward",
               labels={"wind": "it winds the web on", "unwind": "it lets the web off, and brakes it"}),
    ]  # fmt: skip
    tension: Annotated[
        float, Quantity("N", symbol="F_W", ge=0, le=1e6, group=WEB, about="tension of the web on the core")
    ]
    taper: Annotated[
        float,
        Quantity("%", symbol="k_W", ge=0, le=1, default=0.0, source="constant tension", group=WEB,
                 about="taper: how much the tension falls towards a large diameter"),
    ]  # fmt: skip
    thickness: Annotated[
        float, Quantity("mm", symbol="h", gt=0, le=0.1, group=WEB, about="thickness of the web, air wound in included")
    ]
    width: Annotated[float, Quantity("mm", symbol="b", gt=0, le=20, group=WEB, about="width of the web")]
    density: Annotated[
        float, Quantity("kg/m3", symbol="rho", gt=0, le=2.5e4, group=WEB, about="density of the wound web")
    ]

    @model_validator(mode="after")
    def _diameters_in_order(self) -> Self:
        if self.full_diameter <= self.core_diameter:
            raise refused(self, "full_diameter", "must be larger than the core")
        if self.start_diameter is not None and not self.core_diameter <= self.start_diameter <= self.full_diameter:
            raise refused(self, "start_diameter", "must lie between the core and the full reel")
        return self

    @property
    def _sense(self) -> float:
        """+1 where the reel grows while the web runs forward."""
        return 1.0 if self.task == "wind" else -1.0

    @property
    def _start(self) -> float:
        usual = self.core_diameter if self.task == "wind" else self.full_diameter
        return self.start_diameter or usual

    def load_at_shaft(self, motion: MotionProfile, environment: Environment, sheet: Sheet) -> Load:
        """Load cycle at the axis of the reel, cut where its diameter grows."""
        course = self._course(self._whole_reel(motion, sheet))
        cycle = self._cycle(course)
        self._record_reel(sheet, course)
        self._record_phases(sheet, course, cycle)
        return Load(
            cycle=cycle, statics=self._statics(course),
            results={"web_power": sheet.value("web_power"), "largest_diameter": sheet.value("largest_diameter")},
            diagrams=self._diagrams(course, cycle),
        )  # fmt: skip

    def _whole_reel(self, motion: MotionProfile, sheet: Sheet) -> MotionProfile:
        """A motion that simply runs on lasts until the reel is full or empty."""
        v = float(motion.speed_start[0])
        if not motion.endless or v == 0:
            return motion
        grows = v * self._sense > 0
        start, end = self._start, self.full_diameter if grows else self.core_diameter
        length = abs(float(formulas.reel_length(max(start, end), min(start, end), self.thickness)))
        if length == 0:
            return motion
        sheet.decide(f"The web runs until the reel is {'full' if grows else 'empty'}", "the motion runs on without end")
        return motion.segment(0, length / abs(v))

    def _diameter(self, position: FloatArray) -> FloatArray:
        found = formulas.reel_diameter(self._start, self.thickness, self._sense * position, self.core_diameter)
        return np.asarray(found)

    def _course(self, motion: MotionProfile) -> _Course:
        reached = self._diameter(motion.position)
        growth = np.abs(np.diff(np.log(reached)))
        turning = np.abs(motion.speed_end - motion.speed_start) > 0
        least = np.where(turning & (growth > DIAMETER_STEP / 100), RAMP_PIECES, 1)
        coarser = max(float(growth.sum()) / DIAMETER_STEP / MOST_PIECES, 1.0)
        parts = np.maximum(np.ceil(growth / DIAMETER_STEP / coarser), least).astype(int)
        pieces = split(motion, parts)
        position = pieces.position
        half = (3 * pieces.speed_start + pieces.speed_end) / 8 * pieces.duration
        return _Course(pieces, self._diameter(position), self._diameter(position[:-1] + half))

    def _inertia(self, diameter: Any, payload: Any = 0.0) -> Any:
        """Core, wound web, and what moves with the web, at the axis [kg m2]."""
        web = formulas.reel_inertia(diameter, self.core_diameter, self.width, self.density)
        return self.core_inertia + web + linear_mass_inertia(payload, pulley_transmission(diameter))

    def _tension(self, diameter: Any) -> Any:
        return formulas.tapered_tension(self.tension, self.taper, self.core_diameter, diameter)

    def _cycle(self, course: _Course) -> LoadCycle:
        motion, D = course.motion, course.diameter
        start, end = course.shaft_speeds
        radius = pulley_transmission(D)
        force = (
            self._sense * self._tension(D)
            + motion.process_force * motion.direction
            + acceleration_force(motion.payload, motion.acceleration)
        )
        turned = self._inertia(D)
        torque = (
            torque_of_force(force, radius)
            + self.friction_torque * np.sign(motion.mean_speed)
            + acceleration_torque(turned, (end - start) / motion.duration)
        )
        largest = float(course.borders.max())
        return LoadCycle(
            duration=motion.duration, speed_start=start, speed_end=end, torque=np.where(motion.braked, 0.0, torque),
            braked=motion.braked, label=motion.label,
            inertia=float(self._inertia(largest, float(motion.payload.max()))),
        )  # fmt: skip

    def _record_reel(self, sheet: Sheet, course: _Course) -> None:
        """Write length, diameters, inertia and power; a check where more web runs than the reel holds."""
        motion, grown = course.motion, course.borders
        K = self.core_diameter
        with sheet.section(REEL):
            sheet(formulas.reel_length, key="full_reel_length", label="Length of web on the full reel",
                  D=self.full_diameter, D_K=K, h=self.thickness)  # fmt: skip
            swept = float(motion.position[int(np.argmax(grown))]) * self._sense
            label = "Largest diameter of the cycle"
            D = sheet(formulas.reel_diameter, key="largest_diameter", label=label, D_0=self._start, h=self.thickness,
                      s=swept, D_K=K)  # fmt: skip
            sheet(formulas.reel_inertia, key="largest_reel_inertia", label="Inertia of the web at the largest diameter",
                  D=D, D_K=K, b=self.width, rho=self.density)  # fmt: skip
            sheet(mechanical_power, key="web_power", label="Power of tension and speed of the web", F=self.tension,
                  v=motion.max_speed)  # fmt: skip
            if self.full_diameter * (1 + 1e-9) < D:
                sheet.check("reel_diameter", "Diameter of the reel", D, self.full_diameter, "mm", "given with the reel",
                            formula="reel_diameter")  # fmt: skip
            wound = float(formulas.reel_length(self._start, K, self.thickness))
            taken = max(float((-self._sense * motion.position).max()), 0.0)
            if taken > wound * (1 + 1e-9):
                sheet.check("reel_length", "Web that is left on the reel", taken, wound, "m",
                            "length of web on the reel at the start", formula="reel_length")  # fmt: skip

    def _record_phases(self, sheet: Sheet, course: _Course, cycle: LoadCycle) -> None:
        motion = course.motion

        def write(k: int, prefix: str) -> None:
            D = float(course.diameter[k])
            tension = sheet(formulas.tapered_tension, key=f"{prefix}tension", F_W=self.tension, k_W=self.taper,
                            D_K=self.core_diameter, D=D)  # fmt: skip
            force = [self._sense * tension, float(motion.process_force[k] * motion.direction[k])]
            if motion.acceleration[k] and motion.payload[k]:
                m, a = float(motion.payload[k]), float(motion.acceleration[k])
                force.append(sheet(acceleration_force, key=f"{prefix}web_acceleration_force", m=m, a=a))
            label = "Force of the web, against forward motion"
            F = sheet(sum_of_forces, key=f"{prefix}web_force", symbol="F", label=label, F_k=without_zeros(force))
            A = sheet(pulley_transmission, key=f"{prefix}reel_radius", label="Radius of the reel", d=D)
            label = "Torque of that force at the axis"
            parts = [sheet(torque_of_force, key=f"{prefix}reel_torque", label=label, F=F, A=A)]
            if moving := float(np.sign(motion.mean_speed[k])):
                parts.append(self.friction_torque * moving)
            alpha = float(cycle.acceleration[k])
            if alpha:
                turned = float(self._inertia(D))
                label = "Torque that accelerates reel and core; a growing reel slows down"
                parts.append(sheet(acceleration_torque, key=f"{prefix}accelerating_torque", symbol="M_a", label=label,
                                   J=turned, alpha_s=alpha))  # fmt: skip
            label = "Torque at the axis of the reel"
            sheet(sum_of_torques, key=f"{prefix}shaft_torque", symbol="M", label=label, M_k=without_zeros(parts))

        record_phases(sheet, motion, cycle.torque, write)

    def _statics(self, course: _Course) -> Statics:
        motion = course.motion
        every = np.concatenate((course.borders, course.diameter))
        pull = self._sense * torque_of_force(self._tension(every), pulley_transmission(every))
        widest = float(every.max())
        process = np.abs(torque_of_force(motion.process_force, pulley_transmission(widest)))
        acts = (motion.process_force != 0) & (motion.mean_speed != 0)
        standing = float(process[motion.mean_speed == 0].max(initial=0.0))
        smallest = float(pulley_transmission(course.borders.min()))
        speeds = np.maximum(np.abs(motion.speed_start), np.abs(motion.speed_end))
        # a reel that grows at constant speed of the web is slowed down, a shrinking one speeds up
        drift = float(np.abs(self._drift(course)).max(initial=0.0))
        strongest = float(np.abs(pull).max())
        return Statics(
            friction=self.friction_torque, forward=self._sense * strongest + self.friction_torque + drift,
            backward=self._sense * strongest - self.friction_torque - drift,
            holding=self._sense * (strongest + standing),
            working=strongest + self.friction_torque + float(process[acts].max(initial=0.0)),
            rapid_speed=shaft_speed(motion.max_speed, smallest),
            working_speed=shaft_speed(float(speeds[acts].max()) if acts.any() else motion.max_speed, smallest),
        )  # fmt: skip

    def _drift(self, course: _Course) -> FloatArray:
        """Torque of the slow change of speed in segments at constant speed of the web [N m]."""
        motion = course.motion
        start, end = course.shaft_speeds
        found = acceleration_torque(self._inertia(course.diameter), (end - start) / motion.duration)
        return np.where(motion.acceleration == 0, found, 0.0)

    def _diagrams(self, course: _Course, cycle: LoadCycle) -> tuple[Diagram, ...]:
        """Torque and speed over the diameter in steady winding."""
        D = np.linspace(self.core_diameter, self.full_diameter, 101)
        torque = self._sense * torque_of_force(self._tension(D), pulley_transmission(D))
        speed = shaft_speed(course.motion.max_speed, pulley_transmission(D))
        return (
            Diagram("reel_torque", "Torque over the diameter of the reel", "Diameter", "mm", "Torque", "N m", (
                series("tension and friction", D, torque + self.friction_torque),
                series("in the cycle", course.diameter, cycle.torque, "point"),
            )),
            Diagram("reel_speed", "Speed over the diameter of the reel", "Diameter", "mm", "Speed", "rpm",
                    (series("at the highest speed of the web", D, speed),)),
        )  # fmt: skip
