"""What the engine refuses, and at which field.

::

    EngineError (ValueError)
    +-- RangeError        a value outside the range in which a formula or a model holds
    +-- MotionError       a move that cannot be
    +-- UnitError         a text that is no number with a unit of the wanted dimension

The engine knows nothing of HTTP: ``app.web.errors`` decides what becomes of these.
"""


class EngineError(ValueError):
    """An input that the engine refuses; ``field`` is the path of the input it belongs to, outermost name first."""

    def __init__(self, message: str, *, field: str | tuple[str | int, ...] = ()) -> None:
        super().__init__(message)
        self.message = message
        self.path: tuple[str | int, ...] = (field,) if isinstance(field, str) else field

    @property
    def field(self) -> str:
        """Path of the field as one dotted name, empty where the error belongs to no single field."""
        return ".".join(str(part) for part in self.path)

    def at(self, *outer: str | int) -> "EngineError":
        """Return the same error with its path lengthened by the names of what contains the field."""
        return type(self)(self.message, field=(*outer, *self.path))


class RangeError(EngineError):
    """A value outside the range in which a formula or a model holds."""


class MotionError(EngineError):
    """A move that cannot be carried out as described."""


class UnitError(EngineError):
    """A text that is no number, or a number with a unit of another dimension."""
