"""The catalogue as use cases see it: engine records ready to calculate with, and tables to browse.

The records of a catalogue are read once and kept until another catalogue is loaded; they belong to the object that the
application made, not to the module.
"""

import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

from sqlalchemy.orm import Session

from app.catalog.filters import ProductFilter
from app.catalog.repository import CatalogRepository
from app.engine.candidates import GearArrays, MotorArrays
from app.engine.products import (
    BrakingResistor,
    GearUnit,
    InductionMotor,
    Inverter,
    MotorBrake,
    Product,
    ServoDrive,
    ServoGearUnit,
    ServoMotor,
)
from app.engine.tables import Table
from app.services.errors import NotFoundError

RECHECK_SECONDS = 2.0
"""A catalogue loaded by another process is noticed within this time."""

_WORDS: dict[type[Product], str] = {
    ServoMotor: "servo motor",
    ServoGearUnit: "servo gear unit",
    ServoDrive: "servo drive",
    InductionMotor: "induction motor",
    GearUnit: "gear unit",
    MotorBrake: "motor brake",
    Inverter: "inverter",
    BrakingResistor: "braking resistor",
}
"""What the engine's types are called, for the reader."""

OTHER_TYPES: tuple[type[Product], ...] = (InductionMotor, GearUnit, MotorBrake, Inverter, BrakingResistor)
"""Products beside those of servo drives."""


@dataclass(frozen=True)
class CatalogueSnapshot:
    """All servo products of one catalogue version, in SI, in the order of the catalogue."""

    version: str
    motors: tuple[ServoMotor, ...]
    gear_units: tuple[ServoGearUnit, ...]
    servo_drives: tuple[ServoDrive, ...]
    editions: Mapping[str, str]
    """Edition key (``maker:edition``) and citation."""
    others: Mapping[type[Product], tuple[Product, ...]] = field(default_factory=dict)
    """Products of every other type."""
    tables: Mapping[str, Table] = field(default_factory=dict)
    """Tabulated charts by key."""

    def products(self, product_type: type[Product]) -> Sequence[Product]:
        """All products of a type, in the order of the catalogue."""
        servo: dict[type[Product], Sequence[Product]] = {
            ServoMotor: self.motors,
            ServoGearUnit: self.gear_units,
            ServoDrive: self.servo_drives,
        }
        return servo[product_type] if product_type in servo else self.others.get(product_type, ())

    @cached_property
    def _by_id(self) -> dict[type[Product], dict[str, Product]]:
        return {kind: {product.id: product for product in self.products(kind)} for kind in _WORDS}

    @cached_property
    def motor_arrays(self) -> MotorArrays:
        """All motors, ready for the selection."""
        return MotorArrays.from_records(self.motors)

    @cached_property
    def gear_arrays(self) -> GearArrays:
        """All gear units, ready for the selection."""
        return GearArrays.from_records(self.gear_units)

    def product(self, product_type: type[Product], product_id: str) -> Product:
        """One product by type and id. Raises NotFoundError."""
        found = self._by_id[product_type].get(product_id)
        if found is None:
            raise NotFoundError(f"names no {_WORDS[product_type]} of the catalogue that is loaded")
        return found

    def editions_of(self, product_ids: Sequence[str]) -> dict[str, str]:
        """The editions that products come from, by key, with their citations."""
        keys = {":".join(product_id.split(":")[1:3]) for product_id in product_ids}
        return {key: self.editions[key] for key in sorted(keys) if key in self.editions}


class CatalogueCache:
    """Hands out the newest snapshot; safe to use from several threads. ``sessions`` opens a session for reading."""

    def __init__(self, sessions: Callable[[], Session], clock: Callable[[], float] = time.monotonic) -> None:
        self._sessions = sessions
        self._clock = clock
        self._lock = threading.Lock()
        self._checked = float("-inf")
        self._snapshot: CatalogueSnapshot | None = None

    @property
    def known_version(self) -> str:
        """Version of the catalogue if it was looked at just now, else empty; never waits for the database."""
        snapshot = self._snapshot
        recent = self._clock() - self._checked <= RECHECK_SECONDS
        return snapshot.version if snapshot is not None and recent else ""

    def snapshot(self) -> CatalogueSnapshot:
        """The products of the catalogue that is loaded; read again only after another one was loaded."""
        with self._lock:
            if self._snapshot is None or self._clock() - self._checked > RECHECK_SECONDS:
                self._snapshot = self._newest(self._snapshot)
                self._checked = self._clock()
            return self._snapshot

    def matching(self, motors: ProductFilter, gear_units: ProductFilter) -> "CatalogueSnapshot":
        """A snapshot of only those motors and gear units that the filters admit."""
        whole = self.snapshot()
        with self._sessions() as session:
            repository = CatalogRepository(session)
            return replace(
                whole,
                motors=tuple(repository.servo_motors(motors)),
                gear_units=tuple(repository.servo_gear_units(gear_units)),
            )

    def _newest(self, known: CatalogueSnapshot | None) -> CatalogueSnapshot:
        with self._sessions() as session:
            repository = CatalogRepository(session)
            version = repository.catalogue_version()
            if known is not None and known.version == version:
                return known
            return CatalogueSnapshot(
                version=version,
                motors=tuple(repository.servo_motors()),
                gear_units=tuple(repository.servo_gear_units()),
                servo_drives=tuple(repository.servo_drives()),
                editions={edition.key: edition.citation for edition in repository.editions()},
                others={kind: tuple(repository.products(kind)) for kind in OTHER_TYPES},
                tables=repository.tables(),
            )


class CatalogueTables(Mapping[str, Table]):
    """The tabulated charts of the newest catalogue, read only when one is looked up; one object per calculation."""

    def __init__(self, catalogue: CatalogueCache) -> None:
        self._catalogue = catalogue
        self.used = False
        """Whether anything was looked up, so that the result depends on the catalogue."""

    def _tables(self) -> Mapping[str, Table]:
        self.used = True
        return self._catalogue.snapshot().tables

    def __getitem__(self, key: str) -> Table:
        return self._tables()[key]

    def __iter__(self) -> Iterator[str]:
        return iter(self._tables())

    def __len__(self) -> int:
        return len(self._tables())


def edition_lines(snapshot: CatalogueSnapshot) -> list[dict[str, str]]:
    """Editions in use, as they are stored with a saved project."""
    return [{"key": key, "citation": citation} for key, citation in snapshot.editions.items()]
