"""A stage between the drive's output shaft and the mechanism's own shaft: chain, belt or open gear wheels.

The load cycle of the mechanism's shaft becomes one at the stage's input shaft, which is the drive's output shaft.
"""

from dataclasses import dataclass, replace

import numpy as np

from app.engine.cycle import LoadCycle
from app.engine.formulas.conversion import (
    acceleration_torque,
    speed_before_ratio,
    sum_of_torques,
    torque_before_ratio,
)
from app.engine.formulas.efficiency import RegenerationModel, record_stage, through_stage
from app.engine.formulas.inertia import referred_inertia, sum_of_inertias
from app.engine.mechanisms.load import Load, LoadState, Statics
from app.engine.mechanisms.phases import largest
from app.engine.sheet import Sheet

STAGE = "Stage before the mechanism"
"""Heading of the inputs of such a stage"""
CHAIN_EFFICIENCY = 0.9
CHAIN_SOURCE = "SEW 2001, 17.1: chain or toothed belt on rolling bearings, lower value"


@dataclass(frozen=True)
class Stage:
    """One stage of constant ratio."""

    ratio: float
    """i = input / output speed"""
    efficiency: float
    input_inertia: float
    """On the input shaft, before the losses of the stage [kg m2]"""

    def load(self, behind: Load, model: RegenerationModel) -> Load:
        """What the load behind the stage asks of its input shaft."""
        opposite = None if behind.opposite is None else self.cycle(behind.opposite, model)
        return replace(
            behind,
            cycle=self.cycle(behind.cycle, model),
            statics=self.statics(behind.statics, model),
            opposite=opposite,
            states=tuple(self.state(one) for one in behind.states),
        )

    def state(self, behind: LoadState) -> LoadState:
        """A state of load at the input shaft.

        What sits on the shaft between a stage with losses and the mechanism is counted among what the losses of both
        act on.
        """
        before = behind.front_inertia if self.efficiency == 1 else 0.0
        turning = behind.travel is None and behind.permissible_acceleration is not None
        return replace(
            behind,
            torque=float(torque_before_ratio(behind.torque, self.ratio)),
            process_torque=behind.process_torque / self.ratio,
            inertia=float(referred_inertia(behind.inertia + behind.front_inertia - before, self.ratio)),
            front_inertia=float(referred_inertia(before, self.ratio)) + self.input_inertia,
            speed=float(speed_before_ratio(behind.speed, self.ratio)),
            efficiency=behind.efficiency * self.efficiency,
            travel=None if behind.travel is None else behind.travel / self.ratio,
            permissible_acceleration=(behind.permissible_acceleration or 0.0) * self.ratio
            if turning
            else behind.permissible_acceleration,
            curve=tuple((speed * self.ratio, torque / self.ratio) for speed, torque in behind.curve),
        )

    def cycle(self, behind: LoadCycle, model: RegenerationModel) -> LoadCycle:
        """Load cycle at the input shaft."""
        passed = through_stage(behind.torque, behind.mean_speed, self.efficiency, model)
        own = acceleration_torque(self.input_inertia, speed_before_ratio(behind.acceleration, self.ratio))
        return replace(
            behind,
            speed_start=speed_before_ratio(behind.speed_start, self.ratio),
            speed_end=speed_before_ratio(behind.speed_end, self.ratio),
            torque=np.where(behind.braked, 0.0, torque_before_ratio(passed, self.ratio) + own),
            inertia=float(referred_inertia(behind.inertia, self.ratio) + self.input_inertia),
        )

    def statics(self, behind: Statics, model: RegenerationModel) -> Statics:
        """Static torques at the input shaft."""

        def through(torque: float, speed: float) -> float:
            return float(torque_before_ratio(through_stage(torque, speed, self.efficiency, model), self.ratio))

        return Statics(
            friction=behind.friction / self.ratio,
            forward=through(behind.forward, 1.0),
            backward=through(behind.backward, -1.0),
            holding=behind.holding / self.ratio,
            # unsigned, so its direction is not known here: as if it drove, which is the larger value
            working=through(behind.working, 1.0),
            rapid_speed=behind.rapid_speed * self.ratio,
            working_speed=behind.working_speed * self.ratio,
        )

    def record(self, sheet: Sheet, behind: LoadCycle, model: RegenerationModel) -> None:
        """Write inertia, highest speed and the largest torque at the input shaft."""
        with sheet.section(STAGE):
            inertia = sheet(
                referred_inertia,
                key="inertia_before_stage",
                symbol="J_1",
                label="Load inertia referred to the input of the stage",
                J=behind.inertia,
                i=self.ratio,
            )
            if self.input_inertia:
                sheet(
                    sum_of_inertias,
                    key="load_inertia_at_stage_input",
                    symbol="J_L1",
                    label="Load inertia at the input of the stage, with its own parts",
                    J_k=[inertia, self.input_inertia],
                )
            sheet(
                speed_before_ratio,
                key="stage_input_speed",
                symbol="n_1",
                label="Highest speed at the input of the stage",
                omega=behind.max_speed,
                i=self.ratio,
            )
            self._record_torque(sheet, behind, largest(self.cycle(behind, model).torque), model)

    def _record_torque(self, sheet: Sheet, behind: LoadCycle, k: int, model: RegenerationModel) -> None:
        passed = record_stage(
            sheet,
            float(behind.torque[k]),
            float(behind.mean_speed[k]),
            self.efficiency,
            model,
            key="torque_with_losses_of_stage",
            symbol="M_eta2",
            label=f"Largest torque with the losses of the stage ({behind.label[k]})",
        )
        before = sheet(
            torque_before_ratio,
            key="stage_input_torque",
            symbol="M_1",
            label="Largest torque at the input of the stage",
            M=passed,
            i=self.ratio,
        )
        alpha = float(speed_before_ratio(behind.acceleration[k], self.ratio))
        if self.input_inertia and alpha:
            own = sheet(
                acceleration_torque,
                key="stage_input_parts_torque",
                symbol="M_a1",
                label="Torque that accelerates what sits on the input shaft",
                J=self.input_inertia,
                alpha_s=alpha,
            )
            sheet(
                sum_of_torques,
                key="stage_input_torque_total",
                symbol="M_1",
                label="Largest torque at the input of the stage, with its own parts",
                M_k=[before, own],
            )


def assume_usual_efficiency(sheet: Sheet) -> float:
    """The usual efficiency of a stage, taken as an assumption where none is given."""
    sheet.assume(
        "mechanism.stage_efficiency", "Efficiency of the stage before the mechanism", value=CHAIN_EFFICIENCY,
        symbol="eta_2", source=CHAIN_SOURCE,
    )  # fmt: skip
    return CHAIN_EFFICIENCY
