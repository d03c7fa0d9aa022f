"""Servo drives (amplifiers): the currents a motor draws for its torques, and which drive carries them."""

from collections.abc import Iterable
from dataclasses import dataclass

from app.engine.drives.rules import CHECK_NAMES
from app.engine.formulas.servo import motor_current, saturated_motor_current, torque_constant
from app.engine.products import ServoDrive, ServoMotor
from app.engine.sheet import Sheet, Verdict, utilisation, verdict

_SOURCE = "servo drive: data sheet"


@dataclass(frozen=True)
class Currents:
    """Currents of one motor over one cycle, rms [A]; None where they are not known."""

    peak: float | None = None
    effective: float | None = None
    missing: str = ""
    """What lacks where they are not known."""


@dataclass(frozen=True)
class DriveSuggestion:
    """One servo drive of the catalogue with its utilisation by the currents of a motor."""

    drive: ServoDrive
    peak: float | None
    """Peak current demanded / available; None: not checked."""
    continuous: float | None
    """Effective / continuous current; None: not checked."""

    @property
    def utilisation(self) -> float:
        """The larger of those that are known; 0 where none is."""
        return max((used for used in (self.peak, self.continuous) if used is not None), default=0.0)

    @property
    def not_checked(self) -> tuple[str, ...]:
        """Keys of the checks that could not be made."""
        named = (("drive_peak_current", self.peak), ("drive_continuous_current", self.continuous))
        return tuple(key for key, used in named if used is None)

    @property
    def verdict(self) -> Verdict:
        """Verdict on the utilisation."""
        return verdict(None if len(self.not_checked) == 2 else self.utilisation)


def _continuous_point(motor: ServoMotor) -> tuple[float, float] | None:
    """Torque and current of the continuous point: at standstill, else at rated speed."""
    for torque, current in ((motor.stall_torque, motor.stall_current), (motor.rated_torque, motor.rated_current)):
        if torque is not None and current:
            return torque, current
    return None


def record_currents(motor: ServoMotor, peak_torque: float, effective_torque: float, sheet: Sheet) -> Currents:
    """Compute peak and effective current on the sheet from the torques [N m] of the motor.

    Torque constant of the data sheet, else torque per current of the continuous point. Above the continuous torque the
    straight line to the peak point counts where the source gives that point, so that saturation is not forgotten.
    """
    point = _continuous_point(motor)
    if motor.torque_constant is None and point is None:
        return Currents(missing="torque constant or rated current of the motor")
    k_T = motor.torque_constant
    if k_T is None and point is not None:
        k_T = sheet(torque_constant, M=point[0], I=point[1])
    effective = sheet(motor_current, key="effective_current", symbol="I_eff", label="Effective motor current",
                      M=effective_torque, k_T=k_T)  # fmt: skip
    label = "Peak motor current"
    if point is not None and motor.peak_torque is not None and motor.peak_current is not None:
        M_a, I_a = point
        if motor.peak_torque > M_a and peak_torque > M_a:
            peak = sheet(saturated_motor_current, key="peak_current", symbol="I_peak", label=label, M=peak_torque,
                         M_a=M_a, I_a=I_a, M_max=motor.peak_torque, I_max=motor.peak_current)  # fmt: skip
            return Currents(peak, effective)
    sheet.assume("drive.motor.saturation", "torque stays proportional to current up to the peak torque",
                 source=motor.source)  # fmt: skip
    return Currents(
        sheet(motor_current, key="peak_current", symbol="I_peak", label=label, M=peak_torque, k_T=k_T), effective
    )


def check_drive(drive: ServoDrive, currents: Currents, sheet: Sheet) -> None:
    """Check peak and continuous current of one servo drive."""
    pairs = (
        ("drive_peak_current", currents.peak, drive.peak_current, "peak current of the servo drive"),
        (
            "drive_continuous_current",
            currents.effective,
            drive.continuous_current,
            "continuous current of the servo drive",
        ),
    )
    for key, demanded, permitted, limit in pairs:
        lacking = [currents.missing or "torques of the motor"] if demanded is None else []
        if permitted is None:
            lacking.append(limit)
        sheet.check(key, CHECK_NAMES[key], demanded, permitted, "A", _SOURCE, missing=", ".join(lacking))


def suggest_drives(currents: Currents, drives: Iterable[ServoDrive]) -> list[DriveSuggestion]:
    """Servo drives that carry both currents, the closest fit first; one whose data lack is listed as not checked."""
    found = []
    for drive in drives:
        suggestion = DriveSuggestion(
            drive, _used(currents.peak, drive.peak_current), _used(currents.effective, drive.continuous_current)
        )
        if suggestion.verdict != Verdict.FAILS:
            found.append(suggestion)
    return sorted(found, key=lambda item: (len(item.not_checked), -item.utilisation, item.drive.name))


def _used(demanded: float | None, permitted: float | None) -> float | None:
    return None if demanded is None or permitted is None else utilisation(demanded, permitted)
