"""What a slide on a crank asks at each angle: from the course of the crank to the load cycle at its shaft."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np

from app.engine.cycle import LoadCycle
from app.engine.diagram import Diagram, series
from app.engine.errors import EngineError
from app.engine.formulas import crank as formulas
from app.engine.formulas.conversion import acceleration_torque, linear_speed, sum_of_torques, torque_of_force
from app.engine.formulas.duty import effective_torque
from app.engine.formulas.efficiency import RegenerationModel, record_stage, through_stage
from app.engine.formulas.inertia import linear_mass_inertia
from app.engine.formulas.resistance import acceleration_force, sum_of_forces
from app.engine.formulas.servo import signed_power
from app.engine.mechanisms.guided_axis import without_zeros
from app.engine.mechanisms.load import Statics
from app.engine.mechanisms.phases import record_phases
from app.engine.motion.profile import FloatArray, MotionProfile, joined
from app.engine.sheet import Sheet

ANGLE_STEP = np.pi / 180
"""Angle over which the torque counts as constant: halving it moves no result by more than 0.1 % [rad]"""
SLIVER = 1e-3
"""Share of a piece that is cut off at either end of a segment."""
LEAST_RAMP_STEPS = 32
MOST_STEPS = 20_000
"""Beyond so many, whole turns at constant speed are counted once and last longer instead."""
MOST_FOLLOWED = 200_000
"""So many pieces are computed at most: about 550 turns of ramps."""
TURN = 2 * np.pi
CRAWLING = 1e-6
"""Share of the highest speed at which no inertia is felt."""


@dataclass(frozen=True)
class Course:
    """The motion of the crank in small pieces, with the angle in the middle of each; arrays have shape (n,)."""

    motion: MotionProfile
    angle: FloatArray
    speed: FloatArray
    """Speed at that angle [rad/s]"""


def followed(motion: MotionProfile, start: float, sheet: Sheet) -> Course:
    """Cut a motion of the crank finely; ``start`` is its angle at the beginning.

    A motion that runs on at one speed is one turn; whole turns of very long motions are counted once and weighted.
    """
    speed = float(motion.speed_start[0])
    if len(motion.duration) == 1 and speed and motion.acceleration[0] == 0 and not motion.own_ramps:
        sheet.decide("One turn stands for all", "the crank runs on at constant speed")
        return _cut(motion.segment(0, TURN / abs(speed)), start)
    turned = np.abs(np.diff(motion.position))
    in_ramps = float(turned[motion.acceleration != 0].sum())
    whole = np.minimum(turned[motion.acceleration == 0], 2 * TURN).sum()
    if (in_ramps + whole) / ANGLE_STEP > MOST_FOLLOWED:
        message = f"the crank makes {in_ramps / TURN:.0f} turns in its ramps, too many to follow angle by angle"
        raise EngineError(f"{message}: shorten the ramps, or describe a part of the cycle")
    if turned.sum() / ANGLE_STEP > MOST_STEPS:
        sheet.decide("Turns at constant speed are computed once and weighted", "the cycle has very many turns")
        return _weighted(motion, start)
    if abs(np.remainder(float(motion.position[-1]) + np.pi, TURN) - np.pi) > 1e-6:
        sheet.decide("Only the first cycle is computed", "the crank does not come back to where it began, so the next "
                     "cycle differs; describe whole turns to have all of them")  # fmt: skip
    return _cut(motion, start)


def _cut(motion: MotionProfile, start: float) -> Course:
    """Cut every segment into equal angles, with a sliver at either end, where torques are often largest."""
    turned = np.diff(motion.position)
    courses = [_cut_one(motion, k, float(turned[k])) for k in range(len(turned))]
    pieces = joined([one for one, _ in courses])
    inside = np.concatenate([angles for _, angles in courses])
    before = np.repeat(start + motion.position[:-1], [len(angles) for _, angles in courses])
    speed = np.sign(pieces.mean_speed) * np.sqrt((pieces.speed_start**2 + pieces.speed_end**2) / 2)
    return Course(pieces, before + inside, speed)


def _cut_one(motion: MotionProfile, k: int, turned: float) -> tuple[MotionProfile, FloatArray]:
    """Segment ``k``, which turns the crank by ``turned``, in pieces; and the angle in the middle of each [rad]."""
    v_0, v_1, time = float(motion.speed_start[k]), float(motion.speed_end[k]), float(motion.duration[k])
    if turned == 0:
        return motion.segment(k, time), np.zeros(1)
    count = max(int(np.ceil(abs(turned) / ANGLE_STEP - 1e-9)), 1)
    borders = [np.linspace(0.0, 1.0, count + 1), np.array([SLIVER / count, 1 - SLIVER / count])]
    if v_0 != v_1:  # near standstill a small angle takes long
        t = np.linspace(0.0, 1.0, LEAST_RAMP_STEPS + 1)
        borders.append((2 * v_0 * t + (v_1 - v_0) * t**2) / (v_0 + v_1))
    shares = np.unique(np.round(np.concatenate(borders), 9))
    speeds = np.sign(turned) * np.sqrt(v_0**2 + (v_1**2 - v_0**2) * shares)
    times = 2 * turned * shares[1:] / (v_0 + speeds[1:])
    duration = np.diff(times, prepend=0.0)
    count = len(duration)
    whole = motion.segment(k, time)
    pieces = replace(
        whole, duration=duration, speed_start=speeds[:-1], speed_end=speeds[1:], label=whole.label * count,
        payload=np.repeat(whole.payload, count), process_force=np.repeat(whole.process_force, count),
        direction=np.repeat(whole.direction, count), braked=np.repeat(whole.braked, count), at_speed_only=None,
    )  # fmt: skip
    return pieces, (shares[:-1] + shares[1:]) / 2 * turned


def _weighted(motion: MotionProfile, start: float) -> Course:
    """Each segment at constant speed as its whole turns, counted once but lasting longer, and what is left of it."""
    courses = []
    for k, (turned, angle) in enumerate(zip(np.abs(np.diff(motion.position)), start + motion.position, strict=False)):
        time, turns = float(motion.duration[k]), float(np.floor(turned / TURN))
        if turns < 2 or motion.acceleration[k] != 0:
            courses.append(_cut(motion.segment(k, time), float(angle)))
            continue
        once = _cut(motion.segment(k, TURN / abs(float(motion.mean_speed[k]))), float(angle))
        rest = time - turns * float(once.motion.duration.sum())
        courses.append(replace(once, motion=replace(once.motion, duration=once.motion.duration * turns)))
        if rest > 1e-9 * time:
            courses.append(_cut(motion.segment(k, rest), float(angle)))
    angles, speeds = (np.concatenate([getattr(one, name) for one in courses]) for name in ("angle", "speed"))
    return Course(joined([one.motion for one in courses]), angles, speeds)


@dataclass(frozen=True, kw_only=True)
class Slide:
    """All that the crank moves; pairs hold the value of the empty and of the loaded stroke."""

    radius: float
    rod: float
    turning_inertia: float
    """Crank, and the rod's part that turns with it [kg m2]"""
    unbalance: float
    """Of crank and rod, towards the crank pin [kg m]"""
    gravity: float
    slope: float
    efficiency: float
    loaded: Literal["both", "inward", "outward"]
    masses: tuple[float, float]
    """[kg]"""
    weights: tuple[float, float]
    """Along the slideway, against inward motion [N]"""
    frictions: tuple[float, float]
    """Unsigned [N]"""
    process_force: float
    """Against the motion on the loaded stroke [N]"""

    def transmission(self, phi: Any) -> Any:
        """Travel per radian at an angle [m/rad]."""
        return formulas.crank_transmission(phi, self.radius, self.rod)

    def is_loaded(self, phi: Any, way: Any) -> Any:
        """Whether the goods are moved: by the direction in which the slide goes (``way``), at rest by the angle."""
        inward = np.where(way == 0, self.transmission(phi) >= 0, way > 0)
        if self.loaded == "both":
            return np.ones_like(inward, dtype=bool)
        return inward if self.loaded == "inward" else ~inward

    def forces(self, phi: Any, omega: Any, alpha: Any) -> tuple[Any, Any, Any, Any]:
        """(moved mass, its acceleration, weight, friction and process force) at an angle; signed positive inward."""
        A = self.transmission(phi)
        way = np.sign(np.where(np.abs(A) < 1e-12 * self.radius, 0.0, A) * omega)
        loaded = self.is_loaded(phi, way)
        mass, weight = np.where(loaded, self.masses[1], self.masses[0]), np.where(loaded, *self.weights[::-1])
        against = np.where(loaded, self.frictions[1] + self.process_force, self.frictions[0]) * way
        a = formulas.crank_slide_acceleration(phi, omega, alpha, A, self.radius, self.rod)
        return mass, a, weight, against

    def net_torque(self, phi: Any, omega: Any, alpha: Any) -> Any:
        """Torque at the crank without losses, without the parts that only turn [N m]."""
        mass, a, weight, against = self.forces(phi, omega, alpha)
        return torque_of_force(acceleration_force(mass, a) + weight + against, self.transmission(phi))

    def torque(self, phi: Any, omega: Any, alpha: Any, model: RegenerationModel) -> Any:
        """Torque at the crank with losses [N m]."""
        passed = through_stage(self.net_torque(phi, omega, alpha), omega, self.efficiency, model)
        return passed + acceleration_torque(self.turning_inertia, alpha) + self.weight_torque(phi)

    def weight_torque(self, phi: Any) -> Any:
        """Torque that lifts crank and rod themselves [N m]."""
        return formulas.crank_weight_torque(self.unbalance, self.gravity, phi, self.slope)

    def inertia(self, payload: float) -> float:
        """Largest inertia at the crank over the turn [kg m2]."""
        angles = np.linspace(0.0, TURN, 721)
        A, loaded = self.transmission(angles), self.is_loaded(angles, np.zeros_like(angles))
        moved = linear_mass_inertia(np.where(loaded, self.masses[1], self.masses[0]), A)
        return float(moved.max()) + self.turning_inertia + payload

    def cycle(self, course: Course, model: RegenerationModel) -> LoadCycle:
        """The load cycle at the crank shaft."""
        motion = course.motion
        torque = (
            self.torque(course.angle, course.speed, motion.acceleration, model)
            + acceleration_torque(motion.payload, motion.acceleration)
            + motion.process_force * motion.direction
        )
        return LoadCycle(
            duration=motion.duration, speed_start=motion.speed_start, speed_end=motion.speed_end,
            torque=np.where(motion.braked, 0.0, torque), braked=motion.braked, label=motion.label,
            inertia=self.inertia(float(motion.payload.max())),
        )  # fmt: skip

    def statics(self, course: Course, model: RegenerationModel) -> Statics:
        """Largest torques over a whole turn: steady, forward and backward, holding wherever the crank may stand."""
        motion = course.motion
        angles = np.concatenate([np.linspace(0.0, TURN, 721), course.angle])
        A, omega = self.transmission(angles), motion.max_speed
        # at the highest speed the inertia of the slide counts most, at the lowest what it hides of the other forces
        forward, backward = (
            float(
                max(np.abs(self.torque(angles, way * speed, 0.0, model)).max() for speed in (omega, CRAWLING * omega))
            )
            for way in (1.0, -1.0)
        )
        rubbing = float(np.abs(A * max(self.frictions)).max())
        working = (motion.process_force != 0) & (motion.mean_speed != 0)
        process = float(np.abs(motion.process_force[motion.mean_speed == 0]).max(initial=0.0))
        held = float(np.abs(A * max(self.weights, key=abs) + self.weight_torque(angles)).max())
        largest = float(np.abs(motion.process_force[working]).max(initial=0.0)) + forward
        ends = np.maximum(np.abs(motion.speed_start), np.abs(motion.speed_end))
        return Statics(
            # it drives and is driven by turns: as if it drove, which asks for more through any further losses
            friction=rubbing, forward=forward, backward=-backward, holding=held + process,
            working=largest, rapid_speed=omega, working_speed=float(ends[working].max()) if working.any() else omega,
        )  # fmt: skip

    def diagrams(self, omega: float, model: RegenerationModel) -> tuple[Diagram, ...]:
        """Torque, and speed of the slide, over one turn at the highest speed."""
        angles = np.linspace(0.0, TURN, 721)
        share = self.radius / self.rod
        v = formulas.crank_speed_approximate(omega, angles, self.radius, share)
        a = formulas.crank_acceleration_approximate(omega, angles, self.radius, share)
        mass, _, weight, against = self.forces(angles, omega, 0.0)
        rough = (acceleration_force(mass, a) + weight + against) * v / omega if omega else np.zeros_like(angles)
        torque = Diagram("crank_torque", "Torque over the angle of the crank", "Angle", "deg", "Torque", "N m", (
            series("with losses", angles, self.torque(angles, omega, 0.0, model)),
            series("without losses", angles, self.net_torque(angles, omega, 0.0), "second"),
            series("approximate formulas, without losses", angles, rough, "limit"),
        ))  # fmt: skip
        speed = Diagram("crank_speed", "Speed of the slide over the angle", "Angle", "deg", "Speed", "m/s", (
            series("exact", angles, omega * self.transmission(angles)),
            series("approximate formula", angles, v, "second"),
        ))  # fmt: skip
        return torque, speed

    def record(self, sheet: Sheet, course: Course, cycle: LoadCycle, model: RegenerationModel) -> None:
        """Write the largest torque of each phase, with its angle and its parts."""
        motion = course.motion

        def write(k: int, prefix: str) -> None:
            phi, omega, alpha = float(course.angle[k]), float(course.speed[k]), float(motion.acceleration[k])
            mass, _, weight, against = (float(one) for one in self.forces(phi, omega, alpha))
            label = "Travel per radian at the angle of the largest torque"
            A = sheet(formulas.crank_transmission, key=f"{prefix}transmission", label=label, phi=phi, r=self.radius,
                      l=self.rod)  # fmt: skip
            sheet(linear_speed, key=f"{prefix}slide_speed", label="Speed of the slide there", omega=omega, A=A)
            a = sheet(formulas.crank_slide_acceleration, key=f"{prefix}slide_acceleration", phi=phi, omega=omega,
                      alpha_s=alpha, A=A, r=self.radius, l=self.rod)  # fmt: skip
            inertial = sheet(acceleration_force, key=f"{prefix}inertia_force", m=mass, a=a)
            parts = without_zeros([inertial, weight, against])
            label = "Force on the slide: inertia, weight, friction, process"
            F = sheet(sum_of_forces, key=f"{prefix}slide_force", symbol="F_S", label=label, F_k=parts)
            label = "Torque at the crank without losses"
            net = sheet(torque_of_force, key=f"{prefix}crank_torque_ideal", label=label, F=F, A=A)
            label = "Torque at the crank with the losses of the mechanism"
            passed = record_stage(sheet, net, omega, self.efficiency, model, key=f"{prefix}crank_torque", symbol="M",
                                  label=label)  # fmt: skip
            turning = self.turning_inertia + float(motion.payload[k])
            process = float(motion.process_force[k] * motion.direction[k])
            others = [process]
            if self.unbalance:
                others.append(sheet(formulas.crank_weight_torque, key=f"{prefix}weight_torque", U_K=self.unbalance,
                                    g=self.gravity, phi=phi, delta=self.slope))  # fmt: skip
            if alpha and turning:
                label = "Torque that accelerates what only turns"
                others.append(sheet(acceleration_torque, key=f"{prefix}turning_torque", symbol="M_a", label=label,
                                    J=turning, alpha_s=alpha))  # fmt: skip
            if any(others):
                label = "Torque at the crank, all parts"
                sheet(sum_of_torques, key=f"{prefix}crank_torque_total", symbol="M", label=label,
                      M_k=without_zeros([passed, *others]))  # fmt: skip

        record_phases(sheet, motion, cycle.torque, write)
        label = "Effective torque at the crank over the cycle"
        sheet(effective_torque, key="effective_crank_torque", label=label, M_k=cycle.torque, t_k=cycle.duration)
        self._record_extremes(sheet, motion.max_speed, model)

    def _record_extremes(self, sheet: Sheet, omega: float, model: RegenerationModel) -> None:
        """Write the outermost torques of a turn at the highest speed, at their exact angles."""
        for key, words, sign in (("driving", "drives most", 1.0), ("returning", "is driven most", -1.0)):
            phi = angle_of_largest(
                lambda angles: self.net_torque(angles, omega, 0.0) + self.weight_torque(angles), sign
            )
            with sheet.section(f"Constant speed: angle at which the crank {words}"):
                label = "Travel per radian there"
                A = sheet(formulas.crank_transmission, key=f"{key}_transmission", label=label, phi=phi, r=self.radius,
                          l=self.rod)  # fmt: skip
                label = "Torque at the crank without losses"
                F = float(self.net_torque(phi, omega, 0.0)) / A if A else 0.0
                ideal = sheet(torque_of_force, key=f"{key}_torque_ideal", label=label, F=F, A=A)
                label = "Torque at the crank with the losses of the mechanism"
                with_losses = record_stage(sheet, ideal, omega, self.efficiency, model, key=f"{key}_torque", symbol="M",
                                           label=label)  # fmt: skip
                if self.unbalance:
                    lifting = sheet(formulas.crank_weight_torque, key=f"{key}_weight_torque", U_K=self.unbalance,
                                    g=self.gravity, phi=phi, delta=self.slope)  # fmt: skip
                    label = "Torque at the crank, weight of crank and rod included"
                    with_losses = sheet(sum_of_torques, key=f"{key}_torque_total", symbol="M", label=label,
                                        M_k=[with_losses, lifting])  # fmt: skip
                label = f"Power where the crank {words}"
                sheet(signed_power, key=f"{key}_power", label=label, M=with_losses, omega=omega)


def angle_of_largest(function: Callable[[FloatArray], FloatArray], sign: float = 1.0) -> float:
    """Angle of one turn at which ``sign`` * function of the angle is largest, to a thousandth of a degree [rad]."""
    coarse = np.linspace(0.0, TURN, 721)
    near, step = float(coarse[int(np.argmax(sign * function(coarse)))]), float(coarse[1])
    fine = np.linspace(near - step, near + step, 2001)
    return float(fine[int(np.argmax(sign * function(fine)))])
