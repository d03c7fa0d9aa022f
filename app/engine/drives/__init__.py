"""All kinds of drive, found by importing every module of this package: a new one needs no registration."""

import importlib
import pkgutil
from collections.abc import Mapping

from app.engine.drives.base import DriveModel

DEFAULT_KIND = "servo"
"""Kind of a drive that is not told otherwise."""


def drives() -> Mapping[str, type[DriveModel]]:
    """Every kind of drive by its tag: the default first, the others in alphabetical order."""
    for module in pkgutil.iter_modules(__path__):
        importlib.import_module(f"{__name__}.{module.name}")
    base: type[DriveModel] = DriveModel  # type: ignore[type-abstract]
    found = {cls.model_fields["kind"].default: cls for cls in _descendants(base)}
    named = {kind: cls for kind, cls in found.items() if isinstance(kind, str)}
    return dict(sorted(named.items(), key=lambda item: (item[0] != DEFAULT_KIND, item[0])))


def _descendants(base: type[DriveModel]) -> set[type[DriveModel]]:
    direct = set(base.__subclasses__())
    return direct | {deeper for child in direct for deeper in _descendants(child)}


__all__ = ["DEFAULT_KIND", "DriveModel", "drives"]
