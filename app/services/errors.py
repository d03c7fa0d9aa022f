"""What a use case refuses, in the reader's words and without HTTP.

::

    ServiceError
    +-- InvalidInputError       something given cannot be used: one FieldError for each place
    +-- MalformedInputError     what was given is no JSON at all
    +-- NotFoundError           a link, product, revision, example ... that does not exist
    +-- ForbiddenError          a link that may look but not change
    +-- ConflictError           someone else saved in the meantime
    +-- CatalogueEmptyError     there are no products to choose from
"""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

Path = tuple[str | int, ...]


@dataclass(frozen=True)
class FieldError:
    """One refused value: where it stands, why it cannot be used, and what was typed (unchanged)."""

    path: Path
    """Border names from the outside in, e.g. ``("motion", "moves", 0, "distance_mm")``; empty: the whole input."""
    message: str
    """Continues a sentence that begins with the name of the field: ``must be greater than 0 mm``."""
    value: Any = None

    @property
    def name(self) -> str:
        """The path as one dotted name: ``motion.moves.0.distance_mm``."""
        return ".".join(str(part) for part in self.path)

    @property
    def pointer(self) -> str:
        """The path as a JSON pointer (RFC 6901)."""
        return "".join("/" + str(part).replace("~", "~0").replace("/", "~1") for part in self.path)


class ServiceError(Exception):
    """Base of everything a use case refuses; ``message`` is a sentence for the reader."""

    def __init__(self, message: str) -> None:
        super().__init__(message)
        self.message = message


class InvalidInputError(ServiceError):
    """Values that cannot be used, each with its place."""

    def __init__(self, errors: Iterable[FieldError]) -> None:
        self.errors = tuple(errors)
        count = len(self.errors)
        super().__init__("One value cannot be used." if count == 1 else f"{count} values cannot be used.")

    def within(self, *outer: str | int) -> "InvalidInputError":
        """The same errors with their paths lengthened by the names of what contains the input."""
        return InvalidInputError(FieldError((*outer, *e.path), e.message, e.value) for e in self.errors)


class MalformedInputError(ServiceError):
    """What was given cannot be read as JSON."""


class NotFoundError(ServiceError):
    """Something asked for does not exist."""


class ForbiddenError(ServiceError):
    """The link given may look but not change."""


class ConflictError(ServiceError):
    """The version given is not the newest one; ``current`` is."""

    def __init__(self, message: str, current: int) -> None:
        super().__init__(message)
        self.current = current


class CatalogueEmptyError(ServiceError):
    """There are no products of the wanted kind in the database."""
