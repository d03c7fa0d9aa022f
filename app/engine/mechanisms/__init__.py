"""All mechanisms, found by importing every module of this package: a new one needs no registration."""

import importlib
import pkgutil
from collections.abc import Mapping

from app.engine.mechanisms.base import Mechanism
from app.engine.mechanisms.load import Load, Statics


def mechanisms() -> Mapping[str, type[Mechanism]]:
    """Every mechanism by its kind, in alphabetical order of the kinds."""
    for module in pkgutil.iter_modules(__path__):
        importlib.import_module(f"{__name__}.{module.name}")
    base: type[Mechanism] = Mechanism  # type: ignore[type-abstract]
    found = {cls.model_fields["kind"].default: cls for cls in _descendants(base) if "kind" in cls.model_fields}
    return dict(sorted((kind, cls) for kind, cls in found.items() if isinstance(kind, str)))


def _descendants(base: type[Mechanism]) -> set[type[Mechanism]]:
    direct = set(base.__subclasses__())
    return direct | {deeper for child in direct for deeper in _descendants(child)}


__all__ = ["Load", "Mechanism", "Statics", "mechanisms"]
