"""Sizing one axis: request in, every number of the calculation out. Pure but for the catalogue rows it names."""

from collections import Counter
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from app.engine.drives.servo import ServoResult, check_servo
from app.engine.errors import EngineError
from app.engine.mechanisms.base import Load
from app.engine.motion.profile import MotionProfile
from app.engine.optimum import OptimumResult, optimum
from app.engine.products import Product, ServoDrive, ServoGearUnit, ServoMotor
from app.engine.sheet import Check, Sheet, Verdict
from app.services.catalogue import CatalogueCache
from app.services.errors import FieldError, InvalidInputError, NotFoundError
from app.services.reading import engine_refusal
from app.services.requests import MOTION_WORDS, SizingRequest, Typed, read_sizing
from app.services.version import ENGINE_VERSION

_WORST_FIRST = (Verdict.FAILS, Verdict.TIGHT, Verdict.OK)


@dataclass(frozen=True)
class Headline:
    """A result that is shown before all others; ``value`` is SI, ``unit`` the one it is shown in."""

    key: str
    label: str
    symbol: str
    value: float
    unit: str


@dataclass(frozen=True, kw_only=True)
class Parts:
    """The products that were checked; None where none was chosen."""

    motor: ServoMotor | None = None
    gear_unit: ServoGearUnit | None = None
    servo_drive: ServoDrive | None = None

    def chosen(self) -> Iterator[tuple[str, Product]]:
        """Each chosen product with its role."""
        for role in ("motor", "gear_unit", "servo_drive"):
            found: Product | None = getattr(self, role)
            if found is not None:
                yield role, found


@dataclass(frozen=True)
class Demand:
    """What mechanism and motion ask of the drive, before any product is looked at."""

    profile: MotionProfile
    load: Load


@dataclass(frozen=True, kw_only=True)
class Sizing:
    """One axis, calculated."""

    typed: Typed
    parts: Parts
    profile: MotionProfile
    load: Load
    drive: ServoResult
    optimum: OptimumResult | None
    sheet: Sheet
    headlines: tuple[Headline, ...]
    catalogue_version: str
    """Identifies the catalogue the parts came from; empty where none was needed."""
    editions: Mapping[str, str]
    """Catalogue editions of the chosen parts: key and citation."""
    engine_version: str = ENGINE_VERSION

    @property
    def counts(self) -> dict[Verdict, int]:
        """How many checks came out each way."""
        counted = Counter(check.verdict for check in self.sheet.checks)
        return {verdict: counted.get(verdict, 0) for verdict in Verdict}

    @property
    def verdict(self) -> Verdict:
        """The worst of all checks that could be made; ``not_checked`` where none could. ``counts`` tells the others."""
        found = self.counts
        return next((verdict for verdict in _WORST_FIRST if found[verdict]), Verdict.NOT_CHECKED)

    @property
    def deciding_check(self) -> Check | None:
        """The check with the highest utilisation."""
        made = [check for check in self.sheet.checks if check.utilisation is not None]
        return max(made, key=lambda check: check.utilisation or 0.0, default=None)


class SizingService:
    """Calculates axes against the catalogue that is loaded."""

    def __init__(self, catalogue: CatalogueCache) -> None:
        self._catalogue = catalogue

    def size(self, raw: Any) -> Sizing:
        """Calculate a request as it was typed. Raises InvalidInputError with the path of every refused value."""
        return self.calculate(read_sizing(raw))

    def calculate(self, typed: Typed) -> Sizing:
        """Calculate a parsed request. Raises InvalidInputError."""
        request, sheet = typed.request, Sheet()
        with refusals(typed.raw):
            parts = self.parts(request)
            demand = demand_of(request, sheet)
            with located("drive"), sheet.section("Drive"):
                result = check_servo(
                    demand.load,
                    parts.motor,
                    parts.gear_unit,
                    parts.servo_drive,
                    request.drive,
                    request.environment,
                    sheet,
                )
            best = _optimum(request, demand, parts, result, sheet)
        return Sizing(
            typed=typed, parts=parts, profile=demand.profile, load=demand.load, drive=result, optimum=best,
            sheet=sheet, headlines=tuple(_headlines(demand.load, sheet)),
            catalogue_version=self._catalogue_version(request), editions=self._editions(parts),
        )  # fmt: skip

    def parts(self, request: SizingRequest) -> Parts:
        """The products that a request names. Raises InvalidInputError for an unknown one, at its id."""
        drive = request.drive
        motor: ServoMotor | None = None
        gear: ServoGearUnit | None = None
        amplifier: ServoDrive | None = None
        if drive.motor is not None:
            motor = drive.motor.own.product() if drive.motor.own else self._named("motor", drive.motor.id)
        if drive.gear_unit is not None:
            gear = (
                drive.gear_unit.own.product() if drive.gear_unit.own else self._named("gear_unit", drive.gear_unit.id)
            )
        if drive.servo_drive is not None:
            amplifier = self._named("servo_drive", drive.servo_drive.id)
        return Parts(motor=motor, gear_unit=gear, servo_drive=amplifier)

    def _named(self, role: str, product_id: str | None) -> Any:
        try:
            return self._catalogue.snapshot().product(role, str(product_id))
        except NotFoundError as error:
            raise InvalidInputError([FieldError(("drive", role, "id"), error.message, product_id)]) from error

    def _catalogue_version(self, request: SizingRequest) -> str:
        chosen = (request.drive.motor, request.drive.gear_unit, request.drive.servo_drive)
        named = any(choice is not None and choice.id is not None for choice in chosen)
        return self._catalogue.snapshot().version if named else ""

    def _editions(self, parts: Parts) -> dict[str, str]:
        ids = [product.id for _, product in parts.chosen() if product.id != "own"]
        return self._catalogue.snapshot().editions_of(ids) if ids else {}


def demand_of(request: SizingRequest, sheet: Sheet) -> Demand:
    """Solve the motion and compute the load cycle, each step and each unconfirmed default on ``sheet``."""
    for name in ("mechanism", "motion", "environment", "drive", "optimum"):
        part = getattr(request, name)
        if part is not None:
            sheet.assume_defaults(part, f"{name}.")
    request.environment.check(sheet)
    with located("motion"), sheet.section("Motion"):
        profile = request.motion.solve(sheet)
        if profile.kind != request.mechanism.motion_kind:
            given, needed = MOTION_WORDS[profile.kind], MOTION_WORDS[request.mechanism.motion_kind]
            raise EngineError(f"describes {given}, but {request.mechanism.title} needs {needed}", field="kind")
    with located("mechanism"), sheet.section(request.mechanism.title):
        load = request.mechanism.load(profile, request.environment, sheet)
    return Demand(profile, load)


@contextmanager
def located(part: str) -> Iterator[None]:
    """Prefix the path of what the engine refuses inside with the part of the request that it was computing."""
    try:
        yield
    except EngineError as error:
        raise error.at(part) from error


@contextmanager
def refusals(raw: Any) -> Iterator[None]:
    """Turn what the engine refuses inside into an InvalidInputError with what was typed."""
    try:
        yield
    except EngineError as error:
        raise engine_refusal(error, raw) from error


def _optimum(
    request: SizingRequest, demand: Demand, parts: Parts, drive: ServoResult, sheet: Sheet
) -> OptimumResult | None:
    if request.optimum is None:
        return None
    gear = parts.gear_unit
    on_motor_shaft = (drive.rotor or 0.0) + request.drive.coupling_inertia + ((gear.inertia or 0.0) if gear else 0.0)
    with located("optimum"), sheet.section("Optimum for acceleration"):
        return optimum(
            request.mechanism,
            demand.load,
            demand.profile,
            request.environment,
            request.optimum,
            sheet,
            drive_inertia=on_motor_shaft,
            ratio=gear.ratio if gear else 1.0,
            gear_efficiency=(gear.efficiency or 1.0) if gear else 1.0,
            peak_torque=parts.motor.peak_torque if parts.motor else None,
        )


def _headlines(load: Load, sheet: Sheet) -> Iterator[Headline]:
    """The mechanism's headline results, then the drive's."""
    steps = {step.key: step for step in sheet.steps}
    drive = ("motor_speed_max", "peak_torque", "effective_torque", "mean_speed", "inertia_ratio")
    for key in dict.fromkeys([*load.results, *drive]):
        step = steps.get(key)
        if step is not None:
            yield Headline(key, step.label, step.symbol, step.value, step.unit)
