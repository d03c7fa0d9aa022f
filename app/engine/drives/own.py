"""Motors and gear units that the user types from a data sheet, beside those of the catalogue."""

from collections.abc import Iterator
from typing import Annotated, Any, Literal

from pydantic import field_validator
from pydantic_core import PydanticCustomError

from app.engine.products import Product, ServoGearUnit, ServoMotor
from app.engine.quantity import Declaration, Declared, Option, Quantity

_SOURCE = "own input"
_NO_ASSUMPTIONS = {"name", "kind", "continuous_curve", "peak_curve"}
"""Inputs whose default decides nothing."""
WEAKENING_POINTS = 24
"""Straight pieces of a curve of constant power: exact within 0.1 % up to three times rated speed."""


class OwnProduct(Declared):
    """A product as its data sheet prints it."""

    def product(self) -> Product:
        """The product as a record of the engine, in SI."""
        raise NotImplementedError

    def defaults_taken(self) -> Iterator[tuple[str, Declaration, Any]]:
        """As in the base, without those that decide nothing."""
        yield from (found for found in super().defaults_taken() if found[0] not in _NO_ASSUMPTIONS)


def _speed(symbol: str, about: str) -> Any:
    return Quantity("rpm", symbol=symbol, gt=0, le=1e4, default=None, about=about, group="Own motor")


def _torque(symbol: str, about: str, group: str = "Own motor") -> Any:
    return Quantity("N m", symbol=symbol, gt=0, le=1e7, default=None, about=about, group=group)


def _current(symbol: str, about: str) -> Any:
    return Quantity("A", symbol=symbol, gt=0, le=1e5, default=None, about=about, group="Own motor")


def _inertia(symbol: str, about: str) -> Any:
    return Quantity("kg cm2", symbol=symbol, gt=0, le=1e4, default=None, about=about, group="Own motor")


class CurvePoint(Declared):
    """One point of a limit curve."""

    speed: Annotated[float, Quantity("rpm", symbol="n", ge=0, le=1e4, about="speed")]
    torque: Annotated[float, Quantity("N m", symbol="M", ge=0, le=1e7, about="torque")]


class OwnServoMotor(OwnProduct):
    """A servo motor as its data sheet prints it; what is left empty is not checked."""

    name: Annotated[str, Option(default="own motor", about="name of the motor", group="Own motor")]
    kind: Annotated[
        Literal["sync", "async"],
        Option(default="sync", source="usual servo motor", about="kind of servo motor", group="Own motor",
               labels={"sync": "synchronous: peak torque up to the highest speed",
                       "async": "asynchronous: above rated speed the peak torque falls with the speed"}),
    ]  # fmt: skip
    rated_speed: Annotated[float | None, _speed("n_N", "rated speed")]
    max_speed: Annotated[float | None, _speed("n_max", "highest permitted speed")]
    stall_torque: Annotated[float | None, _torque("M_0", "continuous torque at standstill")]
    rated_torque: Annotated[float | None, _torque("M_N", "continuous torque at rated speed")]
    peak_torque: Annotated[float | None, _torque("M_max", "peak torque")]
    rotor_inertia: Annotated[float | None, _inertia("J_M", "rotor inertia without brake")]
    rotor_inertia_with_brake: Annotated[float | None, _inertia("J_MB", "rotor inertia with holding brake")]
    brake_torque: Annotated[float | None, _torque("M_B", "holding torque of the built-in brake")]
    stall_current: Annotated[float | None, _current("I_0", "current at stall torque (rms)")]
    rated_current: Annotated[float | None, _current("I_N", "current at rated torque (rms)")]
    peak_current: Annotated[float | None, _current("I_max", "current at peak torque (rms)")]
    torque_constant: Annotated[
        float | None,
        Quantity("N m/A", symbol="k_T", gt=0, le=1e4, default=None, about="torque per ampere (rms)", group="Own motor"),
    ]
    mass: Annotated[
        float | None, Quantity("kg", symbol="m_M", gt=0, le=1e5, default=None, about="mass", group="Own motor")
    ]
    continuous_curve: Annotated[
        tuple[CurvePoint, ...], Option(default=(), about="points of the continuous (S1) curve", group="Own motor")
    ]
    peak_curve: Annotated[
        tuple[CurvePoint, ...], Option(default=(), about="points of the peak curve", group="Own motor")
    ]

    @field_validator("continuous_curve", "peak_curve")
    @classmethod
    def _one_torque_per_speed(cls, points: tuple[CurvePoint, ...]) -> tuple[CurvePoint, ...]:
        if len({point.speed for point in points}) < len(points):
            raise PydanticCustomError("curve", "two points of the curve have the same speed")
        return points

    def product(self) -> ServoMotor:
        """The motor as a product record, curve points by rising speed."""
        values = {name: getattr(self, name) for name in type(self).model_fields if name != "name"}
        for curve in ("continuous_curve", "peak_curve"):
            values[curve] = tuple(sorted((point.speed, point.torque) for point in values[curve]))
        values["peak_curve"] = values["peak_curve"] or self._weakened_peak()
        return ServoMotor(id="own", manufacturer="", series="", model=self.name, source=_SOURCE, **values)

    def _weakened_peak(self) -> tuple[tuple[float, float], ...]:
        """Peak curve of an asynchronous motor in field weakening: constant power above rated speed; else empty."""
        n_N, n_max, peak = self.rated_speed, self.max_speed, self.peak_torque
        if self.kind == "sync" or n_N is None or n_max is None or peak is None or n_max <= n_N:
            return ()
        steps = [n_N * (n_max / n_N) ** (k / WEAKENING_POINTS) for k in range(WEAKENING_POINTS + 1)]
        return ((0.0, peak), *((n, peak * n_N / n) for n in steps))


class OwnGearUnit(OwnProduct):
    """A gear unit as its data sheet prints it; what is left empty is not checked."""

    name: Annotated[str, Option(default="own gear unit", about="name of the gear unit", group="Own gear unit")]
    ratio: Annotated[
        float, Quantity("1", symbol="i", gt=0, le=1e5, about="ratio of motor to output speed", group="Own gear unit")
    ]
    efficiency: Annotated[
        float,
        Quantity(
            "1",
            symbol="eta_G",
            gt=0,
            le=1,
            default=0.95,
            source="usual for planetary gear units of one or two stages",
            about="efficiency",
            group="Own gear unit",
        ),
    ]
    inertia: Annotated[
        float,
        Quantity(
            "kg cm2",
            symbol="J_G",
            ge=0,
            le=1e4,
            default=0.0,
            source="no inertia given",
            about="inertia referred to the motor shaft",
            group="Own gear unit",
        ),
    ]
    backlash: Annotated[
        float | None,
        Quantity("arcmin", symbol="phi_G", ge=0, le=0.1, default=None, about="backlash at the output",
                 group="Own gear unit"),
    ]  # fmt: skip
    nominal_torque: Annotated[float | None, _torque("T_2N", "nominal output torque", "Own gear unit")]
    acceleration_torque: Annotated[float | None, _torque("T_2B", "permitted acceleration torque", "Own gear unit")]
    emergency_torque: Annotated[float | None, _torque("T_2Not", "permitted emergency torque", "Own gear unit")]
    nominal_input_speed: Annotated[
        float | None,
        Quantity(
            "rpm", symbol="n_1N", gt=0, le=1e4, default=None, about="permitted mean input speed", group="Own gear unit"
        ),
    ]
    max_input_speed: Annotated[
        float | None,
        Quantity(
            "rpm", symbol="n_1max", gt=0, le=1e4, default=None, about="highest input speed", group="Own gear unit"
        ),
    ]
    mass: Annotated[
        float | None, Quantity("kg", symbol="m_G", gt=0, le=1e5, default=None, about="mass", group="Own gear unit")
    ]

    def product(self) -> ServoGearUnit:
        """The gear unit as a product record."""
        values = {name: getattr(self, name) for name in type(self).model_fields if name != "name"}
        return ServoGearUnit(id="own", manufacturer="", series="", model=self.name, source=_SOURCE, **values)
