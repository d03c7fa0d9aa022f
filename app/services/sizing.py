"""Sizing one axis: request in, every number of the calculation out. Pure but for the catalogue rows it names."""

from collections import Counter
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

from app.engine.drives.base import DriveResult, Given
from app.engine.drives.parts import Part, parts_of
from app.engine.drives.servo import ServoDriveModel, ServoResult
from app.engine.errors import EngineError
from app.engine.mechanisms.load import Load
from app.engine.motion.profile import MotionProfile
from app.engine.optimum import OptimumResult, optimum
from app.engine.products import Product
from app.engine.sheet import Check, Sheet, Verdict
from app.services.catalogue import CatalogueCache, CatalogueTables
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


@dataclass(frozen=True)
class Parts:
    """The products that were checked, by role; a role that is not chosen is not there."""

    products: Mapping[str, Product] = field(default_factory=dict)

    @property
    def motor(self) -> Any:
        """The motor; None where none was chosen."""
        return self.products.get("motor")

    @property
    def gear_unit(self) -> Any:
        """The gear unit; None where none was chosen."""
        return self.products.get("gear_unit")

    @property
    def servo_drive(self) -> Any:
        """The servo drive; None where none was chosen."""
        return self.products.get("servo_drive")

    def chosen(self) -> Iterator[tuple[str, Product]]:
        """Each chosen product with its role."""
        yield from self.products.items()


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
    drive: DriveResult
    optimum: OptimumResult | None
    sheet: Sheet
    headlines: tuple[Headline, ...]
    catalogue_version: str
    """Identifies the catalogue the parts came from; empty where none was needed."""
    editions: Mapping[str, str]
    """Catalogue editions of the chosen parts: key and citation."""
    engine_version: str = ENGINE_VERSION

    @property
    def asked(self) -> SizingRequest:
        """What was asked, read."""
        return self.typed.request

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

    @property
    def catalogue(self) -> CatalogueCache:
        """The catalogue that products are named from."""
        return self._catalogue

    def size(self, raw: Any) -> Sizing:
        """Calculate a request as it was typed. Raises InvalidInputError with the path of every refused value."""
        return self.calculate(read_sizing(raw))

    def calculate(self, typed: Typed) -> Sizing:
        """Calculate a parsed request. Raises InvalidInputError."""
        request, tables = typed.request, CatalogueTables(self._catalogue)
        sheet = Sheet(tables=tables)
        with refusals(typed.raw):
            parts = self.parts(request)
            demand = demand_of(request, sheet)
            with located("drive"), sheet.section("Drive"):
                given = Given(demand.load, demand.profile, parts.products, request.environment)
                result = request.drive.check(given, sheet)
            best = _optimum(request, demand, parts, result, sheet)
        return Sizing(
            typed=typed, parts=parts, profile=demand.profile, load=demand.load, drive=result, optimum=best,
            sheet=sheet, headlines=tuple(_headlines(demand.load, result, sheet)),
            catalogue_version=self._catalogue_version(request, tables), editions=self._editions(parts),
        )  # fmt: skip

    def parts(self, request: SizingRequest) -> Parts:
        """The products that a request names. Raises InvalidInputError for an unknown one, at its id."""
        found: dict[str, Product] = {}
        for role, part in parts_of(request.drive):
            found[role] = part.typed or self._named(role, part)
        return Parts(found)

    def _named(self, role: str, part: Part) -> Product:
        try:
            return self._catalogue.snapshot().product(part.product_type, str(part.id))
        except NotFoundError as error:
            raise InvalidInputError([FieldError(("drive", role, "id"), error.message, part.id)]) from error

    def _catalogue_version(self, request: SizingRequest, tables: CatalogueTables) -> str:
        named = tables.used or any(part.id is not None for _, part in parts_of(request.drive))
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
    if profile.own_ramps and not request.drive.own_ramps:
        problem = f"leaves the ramps to a line-fed motor; {request.drive.title.lower()} needs moves with their own"
        raise EngineError(problem, field=("motion", "kind"))
    with located("mechanism"), sheet.section(request.mechanism.title):
        load = request.mechanism.load(profile, request.environment, sheet)
    if request.drive.own_ramps and not load.states and load.cycle.max_speed > 0:
        what = request.mechanism.title.lower()
        problem = (
            f"works against a steady torque, but that of a {what} keeps changing; take an inverter-fed or servo drive"
        )
        raise EngineError(problem, field=("drive", "kind"))
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
    request: SizingRequest, demand: Demand, parts: Parts, drive: DriveResult, sheet: Sheet
) -> OptimumResult | None:
    if request.optimum is None or not isinstance(request.drive, ServoDriveModel):
        return None
    assert isinstance(drive, ServoResult)
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


def _headlines(load: Load, drive: DriveResult, sheet: Sheet) -> Iterator[Headline]:
    """The mechanism's headline results, then the drive's."""
    steps = {step.key: step for step in sheet.steps}
    for key in dict.fromkeys([*load.results, *drive.headlines]):
        step = steps.get(key)
        if step is not None:
            yield Headline(key, step.label, step.symbol, step.value, step.unit)
