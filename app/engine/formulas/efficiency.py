"""Efficiency acts on the net power that passes a stage, by direction: driving divides, regenerating multiplies.

This is the only place where that rule is spelled; every stage (mechanism, intermediate stage, gear unit) uses it.
"""

from typing import Any, Literal

import numpy as np

from app.engine.formula import formula, maximum
from app.engine.sheet import Sheet
from app.engine.units import KilogramMetre2, NewtonMetre, One

RegenerationModel = Literal["eta", "sew"]


@formula(symbol="eta'", unit="1", source="SEW 2001, 8.1: retrograde efficiency")
def retrograde_efficiency(eta: One) -> One:
    """Efficiency while the load drives the motor, from the efficiency while the motor drives the load.

    The friction loss is taken as the same in both directions. Zero at eta <= 0.5: the stage is self-locking.

    >>> retrograde_efficiency(0.8)
    0.75
    >>> retrograde_efficiency(0.4)
    0.0
    """
    return maximum(2 - 1 / eta, 0)


@formula(symbol="M", unit="N m", source="derived: the stage takes its loss from the driving side")
def driving_stage_torque(T: NewtonMetre, eta: One) -> NewtonMetre:
    """Torque that must be put into a stage while the load absorbs power: divided by the efficiency.

    ``T`` net torque behind the stage, before its ratio; ``eta`` efficiency of the stage, 0 < eta <= 1.

    >>> driving_stage_torque(9.0, 0.9)
    10.0
    """
    return T / eta


@formula(symbol="M", unit="N m", source="derived: the stage takes its loss from what the load returns")
def returning_stage_torque(T: NewtonMetre, eta_r: One) -> NewtonMetre:
    """Torque that arrives through a stage while the load returns power: multiplied by the efficiency.

    ``T`` net torque behind the stage, before its ratio; ``eta_r`` efficiency while the load drives, 0 <= eta_r <= 1.

    >>> returning_stage_torque(-10.0, 0.9)
    -9.0
    """
    return T * eta_r


@formula(symbol="J", unit="kg m2", source="derived: the torque that accelerates an inertia passes the stage")
def driving_stage_inertia(J: KilogramMetre2, eta: One) -> KilogramMetre2:
    """Inertia behind a stage as the driving side feels it while it accelerates it: divided by the efficiency.

    ``J`` inertia behind the stage, referred to the driving side; ``eta`` efficiency of the stage.

    >>> round(driving_stage_inertia(0.0045, 0.9), 6)
    0.005
    """
    return J / eta


@formula(symbol="J", unit="kg m2", source="derived: the torque of an inertia that is slowed down returns power")
def returning_stage_inertia(J: KilogramMetre2, eta_r: One) -> KilogramMetre2:
    """Inertia behind a stage as the driving side feels it while the inertia drives: multiplied by the efficiency.

    ``J`` inertia behind the stage, referred to the driving side; ``eta_r`` efficiency while the load drives.

    >>> round(returning_stage_inertia(0.005, 0.9), 6)
    0.0045
    """
    return J * eta_r


def regenerative_factor(eta: Any, model: RegenerationModel) -> Any:
    """Factor on a torque that returns power through a stage: eta itself, or SEW's eta' (shape of ``eta``)."""
    return retrograde_efficiency(eta) if model == "sew" else eta


def through_stage(torque: Any, speed: Any, eta: Any, model: RegenerationModel) -> Any:
    """Torque (or force) on the driving side of a stage, before its ratio is applied.

    ``torque`` and ``speed`` are signed in the same direction and broadcast: torque * speed > 0 drives (divided by eta),
    < 0 returns power (multiplied), = 0 passes no power (unchanged: holding at standstill).
    """
    power = np.asarray(torque) * np.asarray(speed)
    factor = np.where(power > 0, 1 / np.asarray(eta), np.where(power < 0, regenerative_factor(eta, model), 1.0))
    result = torque * factor
    return result.item() if np.ndim(result) == 0 else result


def record_stage(
    sheet: Sheet,
    torque: float,
    speed: float,
    eta: float,
    model: RegenerationModel,
    *,
    key: str,
    symbol: str,
    label: str,
) -> float:
    """Record on the sheet what :func:`through_stage` does to one torque, and return the result.

    Nothing is recorded at standstill: no power passes, the torque is returned unchanged.
    """
    if torque * speed > 0:
        return sheet(driving_stage_torque, key=key, symbol=symbol, label=label, T=torque, eta=eta)
    if torque * speed < 0:
        eta_r = float(regenerative_factor(eta, model))
        return sheet(returning_stage_torque, key=key, symbol=symbol, label=label, T=torque, eta_r=eta_r)
    return torque


@formula(symbol="eta'", unit="1", source="SEW 2001, 8.1: retrograde efficiency; negative means self-locking")
def friction_retrograde(eta: One) -> One:
    """Efficiency while the load drives, negative where power would have to be put in from the load side, too.

    ``eta`` efficiency while the motor drives. Where it is negative the stage is self-locking, and zero is to be used.

    >>> friction_retrograde(0.4)
    -0.5
    """
    return 2 - 1 / eta
