"""Selecting motor and gear unit: every candidate of the catalogue judged by every check, the best ones listed."""

import difflib
from collections import OrderedDict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from threading import Lock
from typing import Any

from app.catalog.filters import ProductFilter
from app.engine.candidates import GearArrays, MotorArrays
from app.engine.drives.servo import ServoDriveModel, ServoResult, check_servo
from app.engine.inverter import DriveSuggestion, suggest_drives
from app.engine.products import Product, ServoGearUnit, ServoMotor
from app.engine.selection import DIRECT, Candidate, Selection, select
from app.engine.sheet import Sheet
from app.services.catalogue import CatalogueCache
from app.services.errors import CatalogueEmptyError, FieldError, InvalidInputError, NotFoundError
from app.services.requests import SelectionFilter, SelectionRequest, Typed, read_selection
from app.services.sizing import Demand, Parts, SizingService, demand_of, located, refusals
from app.services.version import ENGINE_VERSION

KEPT_CHOICES = 16
"""So many filtered sets of products are kept as arrays."""
SUGGESTED_DRIVES = 5
_TYPES: dict[str, type[Product]] = {"motor": ServoMotor, "gear_unit": ServoGearUnit}


@dataclass(frozen=True)
class Choice:
    """The products that are searched, ready for the engine."""

    motors: MotorArrays
    gear_units: GearArrays


@dataclass(frozen=True)
class RankedCandidate:
    """One admitted candidate with its place, from 1."""

    rank: int
    motor: ServoMotor
    gear_unit: ServoGearUnit | None
    candidate: Candidate


@dataclass(frozen=True, kw_only=True)
class SelectionOutcome:
    """What was found for one axis."""

    typed: Typed
    request: SelectionRequest
    demand: Demand
    selection: Selection
    candidates: tuple[RankedCandidate, ...]
    catalogue_version: str
    editions: Mapping[str, str]
    """Catalogue editions of the listed products: key and citation."""
    engine_version: str = ENGINE_VERSION

    @property
    def rejected(self) -> int:
        """How many candidates fail a check."""
        return self.selection.evaluated - self.selection.admitted


@dataclass(frozen=True)
class Explanation:
    """Why one candidate was admitted or rejected: all its checks, with every step behind them."""

    parts: Parts
    drive: ServoResult
    sheet: Sheet
    suggestions: tuple[DriveSuggestion, ...]
    """Servo drives that carry its currents, closest fit first."""


class SelectionService:
    """Searches the catalogue that is loaded."""

    def __init__(self, catalogue: CatalogueCache, sizing: SizingService) -> None:
        self._catalogue = catalogue
        self._sizing = sizing
        self._choices: OrderedDict[tuple[str, SelectionFilter], Choice] = OrderedDict()
        self._lock = Lock()

    def select(self, raw: Any) -> SelectionOutcome:
        """Evaluate every candidate and list the best ones. Raises InvalidInputError and CatalogueEmptyError."""
        typed = read_selection(raw)
        request = typed.selection
        with refusals(raw):
            parts = self._sizing.parts(request)
            rules = _servo(request)
            demand = demand_of(request, Sheet())
            choice = self._choice(request, parts)
            with located("drive"):
                found = select(
                    demand.load,
                    choice.motors,
                    choice.gear_units,
                    rules,
                    request.environment,
                    include_direct=request.filters.direct and parts.gear_unit is None,
                    ranking=request.ranking,
                    limit=request.limit,
                    offset=request.offset,
                    require_all=request.demand_all_checks,
                )
        ranked = tuple(_ranked(found, choice))
        snapshot = self._catalogue.snapshot()
        listed = [product.id for one in ranked for product in (one.motor, one.gear_unit) if product is not None]
        return SelectionOutcome(
            typed=typed, request=request, demand=demand, selection=found, candidates=ranked,
            catalogue_version=snapshot.version, editions=snapshot.editions_of(listed),
        )  # fmt: skip

    def explain(self, raw: Any, motor_id: str, gear_unit_id: str | None) -> Explanation:
        """All checks of one motor with one gear unit (None: direct), whether it was admitted or not.

        ``own`` names what the request itself describes. Raises InvalidInputError for an unknown product, at
        ``motor_id`` or ``gear_unit_id``.
        """
        typed = read_selection(raw)
        request, sheet = typed.selection, Sheet()
        with refusals(raw):
            given = self._sizing.parts(request)
            motor = self._product("motor", motor_id, given)
            gear = None if gear_unit_id is None else self._product("gear_unit", gear_unit_id, given)
            rules = _servo(request)
            demand = demand_of(request, sheet)
            with located("drive"), sheet.section("Drive"):
                result = check_servo(demand.load, motor, gear, given.servo_drive, rules, request.environment, sheet)
        roles = {"motor": motor, "gear_unit": gear, "servo_drive": given.servo_drive}
        parts = Parts({role: product for role, product in roles.items() if product is not None})
        drives = suggest_drives(result.currents, self._catalogue.snapshot().servo_drives)
        return Explanation(parts, result, sheet, tuple(drives[:SUGGESTED_DRIVES]))

    def products(self) -> tuple[tuple[ServoMotor, ...], tuple[ServoGearUnit, ...]]:
        """Every motor and gear unit of the catalogue that is loaded."""
        snapshot = self._catalogue.snapshot()
        return snapshot.motors, snapshot.gear_units

    def _product(self, role: str, product_id: str, given: Parts) -> Any:
        own: Product | None = given.products.get(role)
        if own is not None and own.id == product_id:
            return own
        try:
            return self._catalogue.snapshot().product(_TYPES[role], product_id)
        except NotFoundError as error:
            raise InvalidInputError([FieldError((f"{role}_id",), error.message, product_id)]) from error

    def _choice(self, request: SelectionRequest, parts: Parts) -> Choice:
        """The products to search: those named in the request, else those that the filters admit."""
        if parts.motor is not None and (parts.gear_unit is not None or not request.filters.geared):
            return Choice(MotorArrays.from_records([parts.motor]), _gears(parts.gear_unit))
        admitted = self._admitted(request.filters)
        motors = admitted.motors if parts.motor is None else MotorArrays.from_records([parts.motor])
        gears = admitted.gear_units if parts.gear_unit is None else _gears(parts.gear_unit)
        return Choice(motors, gears)

    def _admitted(self, filters: SelectionFilter) -> Choice:
        snapshot = self._catalogue.snapshot()
        if not snapshot.motors:
            raise CatalogueEmptyError("The catalogue holds no servo motors: run drivewright load-catalog.")
        key = (snapshot.version, filters)
        with self._lock:
            kept = self._choices.get(key)
        if kept is None:
            kept = self._read(filters)
            with self._lock:
                self._choices[key] = kept
                while len(self._choices) > KEPT_CHOICES:
                    self._choices.popitem(last=False)
        return kept

    def _read(self, filters: SelectionFilter) -> Choice:
        snapshot = self._catalogue.snapshot()
        _known("manufacturers", filters.manufacturers, {motor.manufacturer for motor in snapshot.motors})
        _known("series", filters.series, {motor.series for motor in snapshot.motors})
        _known("gear_manufacturers", filters.gear_manufacturers, {gear.manufacturer for gear in snapshot.gear_units})
        _known("gear_series", filters.gear_series, {gear.series for gear in snapshot.gear_units})
        found = self._catalogue.matching(
            ProductFilter(manufacturers=filters.manufacturers, series=filters.series, voltage=filters.voltage),
            ProductFilter(manufacturers=filters.gear_manufacturers, series=filters.gear_series),
        )
        gears = [gear for gear in found.gear_units if _admits(filters, gear)] if filters.geared else []
        return Choice(MotorArrays.from_records(found.motors), GearArrays.from_records(gears))


def choose(raw: Mapping[str, Any], motor_id: str, gear_unit_id: str | None) -> dict[str, Any]:
    """A sizing request with one candidate chosen; everything else stays as typed. ``own`` parts stay, too."""
    drive = dict(raw.get("drive") or {})
    if motor_id != "own":
        drive["motor"] = {"id": motor_id}
    if gear_unit_id is None:
        drive.pop("gear_unit", None)
    elif gear_unit_id != "own":
        drive["gear_unit"] = {"id": gear_unit_id}
    only_selection = set(SelectionRequest.model_fields) - {"name", "notes", "mechanism", "motion", "environment",
                                                           "drive", "optimum"}  # fmt: skip
    return {**{name: value for name, value in raw.items() if name not in only_selection}, "drive": drive}


def _servo(request: SelectionRequest) -> ServoDriveModel:
    """The servo drive that candidates are sought for. Raises InvalidInputError for another kind."""
    if isinstance(request.drive, ServoDriveModel):
        return request.drive
    message = "candidates are ranked for servo drives; parts of this kind of drive are named one by one"
    raise InvalidInputError([FieldError(("drive", "kind"), message, request.drive.kind)])


def _gears(gear: ServoGearUnit | None) -> GearArrays:
    return GearArrays.from_records([] if gear is None else [gear])


def _admits(filters: SelectionFilter, gear: ServoGearUnit) -> bool:
    if filters.max_ratio is not None and gear.ratio > filters.max_ratio:
        return False
    return filters.max_backlash is None or (gear.backlash is not None and gear.backlash <= filters.max_backlash)


def _known(name: str, wanted: Sequence[str], known: Iterable[str]) -> None:
    """Refuse a name that the catalogue does not hold, with the one that may have been meant."""
    names = set(known)
    errors = []
    for index, one in enumerate(wanted):
        if one not in names:
            near = difflib.get_close_matches(one, sorted(filter(None, names)), n=1)
            meant = f"; did you mean {near[0]}?" if near else ""
            errors.append(FieldError(("filters", name, index), f"is not in the catalogue{meant}", one))
    if errors:
        raise InvalidInputError(errors)


def _ranked(found: Selection, choice: Choice) -> Iterable[RankedCandidate]:
    for place, candidate in enumerate(found.candidates):
        gear = None if candidate.gear == DIRECT else choice.gear_units.records[candidate.gear]
        yield RankedCandidate(found.offset + place + 1, choice.motors.records[candidate.motor], gear, candidate)
