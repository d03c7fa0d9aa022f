"""The parts of a drive as a request names them: a product of the catalogue, or one typed from its data sheet."""

from collections.abc import Iterator
from typing import Annotated, Any, ClassVar, get_args

from pydantic import Field, StringConstraints, model_validator
from pydantic_core import PydanticCustomError

from app.engine.drives.own import OwnGearUnit, OwnProduct, OwnServoMotor
from app.engine.formulas.induction import synchronous_speed
from app.engine.mechanisms.guided_axis import refused
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
    Winding,
)
from app.engine.quantity import Declared, Option, Quantity, from_si

ProductId = Annotated[str, StringConstraints(min_length=1, max_length=200)]
_SOURCE = "own input"


class Part(Declared):
    """A product: out of the catalogue, or typed from its data sheet. Exactly one of the two.

    A part that may be typed has a field ``own`` whose model makes the product record.
    """

    product_type: ClassVar[type[Product]]
    """What the catalogue is asked for."""

    id: Annotated[ProductId | None, Option(default=None, about="identifier of a product of the catalogue")]

    @model_validator(mode="after")
    def _exactly_one(self) -> "Part":
        if (self.id is None) == (getattr(self, "own", None) is None):
            own = "own" in type(self).model_fields
            raise PydanticCustomError(
                "part", 'give either "id" or "own" (values of a data sheet)' if own else 'give the "id" of a product'
            )
        return self

    @property
    def typed(self) -> Product | None:
        """The product that was typed; None where one of the catalogue is named."""
        own: OwnProduct | None = getattr(self, "own", None)
        return None if own is None else own.product()


class MotorChoice(Part):
    """A servo motor: ``{"id": ...}`` or ``{"own": {...}}``."""

    product_type: ClassVar[type[Product]] = ServoMotor
    own: OwnServoMotor | None = None


class GearUnitChoice(Part):
    """A servo gear unit: ``{"id": ...}`` or ``{"own": {...}}``."""

    product_type: ClassVar[type[Product]] = ServoGearUnit
    own: OwnGearUnit | None = None


class ServoDriveChoice(Part):
    """A servo drive: ``{"id": ...}``."""

    product_type: ClassVar[type[Product]] = ServoDrive


def _q(unit: str, symbol: str, about: str, le: float, group: str, **more: Any) -> Any:
    return Quantity(unit, symbol=symbol, gt=0, le=le, default=None, about=about, group=group, **more)


_WINDING, _MOTOR, _BRAKE, _GEAR, _INV, _RES = (
    "Winding", "Own motor", "Own brake", "Own gear unit", "Own inverter", "Own braking resistor",
)  # fmt: skip


def not_below(synchronous: float, frequency: float, poles: int) -> str:
    """What is wrong with a rated speed that is not below the synchronous speed [rad/s]; ``frequency`` in Hz."""
    rpm = from_si(synchronous, "rpm")
    return f"must be below the synchronous speed, {rpm:.5g} rpm with {poles} poles at {frequency:g} Hz"


class OwnWinding(Declared):
    """Rated data of one winding as its data sheet prints them."""

    poles: Annotated[int, Option(ge=2, le=96, about="number of poles (4 for 1500 rpm at 50 Hz)", symbol="2p")]
    rated_power: Annotated[float, Quantity("kW", symbol="P_N", gt=0, le=5e7, about="rated power", group=_WINDING)]
    rated_speed: Annotated[float, Quantity("rpm", symbol="n_N", gt=0, le=1e4, about="rated speed", group=_WINDING)]
    run_up_torque_ratio: Annotated[
        float | None, _q("1", "M_H/M_N", "mean run-up torque over rated torque", 15, _WINDING)
    ]
    run_up_torque: Annotated[float | None, _q("N m", "M_H", "mean run-up torque, instead of the ratio", 1e6, _WINDING)]
    no_load_starting_frequency: Annotated[
        float | None, _q("1/h", "Z_0", "permitted starts per hour without load", 1e3, _WINDING)
    ]
    breakdown_torque_ratio: Annotated[
        float | None, _q("1", "M_K/M_N", "breakdown torque over rated torque", 15, _WINDING)
    ]
    starting_torque_ratio: Annotated[
        float | None, _q("1", "M_A/M_N", "starting torque over rated torque", 15, _WINDING)
    ]
    rated_torque: Annotated[float | None, _q("N m", "M_N", "rated torque; empty: from power and speed", 1e7, _WINDING)]
    rated_current: Annotated[float | None, _q("A", "I_N", "rated current", 1e5, _WINDING)]
    power_factor: Annotated[float | None, _q("1", "cos phi", "power factor", 1, _WINDING)]
    efficiency: Annotated[float | None, _q("1", "eta_M", "efficiency at rated load", 1, _WINDING)]
    starting_current_ratio: Annotated[
        float | None, _q("1", "I_A/I_N", "starting current over rated current", 20, _WINDING)
    ]
    voltage: Annotated[float | None, _q("V", "U_N", "rated voltage", 2e4, _WINDING)]
    frequency: Annotated[
        float,
        Quantity("Hz", symbol="f_1", gt=0, le=1000, default=50.0, source="mains of 50 Hz",
                 about="rated frequency", group=_WINDING),
    ]  # fmt: skip

    @model_validator(mode="after")
    def _slower_than_its_field(self) -> "OwnWinding":
        synchronous = float(synchronous_speed(self.frequency, self.poles))
        if self.rated_speed >= synchronous:
            raise refused(self, "rated_speed", not_below(synchronous, self.frequency, self.poles))
        return self


class OwnInductionMotor(OwnProduct):
    """An induction motor as its data sheet prints it; what is left empty is not checked."""

    name: Annotated[str, Option(default="own motor", about="name of the motor", group=_MOTOR)]
    rotor_inertia: Annotated[float | None, _q("kg m2", "J_M", "rotor inertia without brake", 1e5, _MOTOR)]
    rotor_inertia_with_brake: Annotated[float | None, _q("kg m2", "J_MB", "rotor inertia with brake", 1e5, _MOTOR)]
    mass: Annotated[float | None, _q("kg", "m_M", "mass", 1e5, _MOTOR)]
    windings: Annotated[
        list[OwnWinding],
        Field(min_length=1, max_length=2),
        Option(about="windings: one, or two of a pole-changing motor"),
    ]

    def product(self) -> InductionMotor:
        """The motor as a product record, the low-speed winding first."""
        made = [Winding(**{name: getattr(one, name) for name in OwnWinding.model_fields}) for one in self.windings]
        return InductionMotor(
            id="own", manufacturer="", series="", model=self.name, source=_SOURCE, mass=self.mass,
            rotor_inertia=self.rotor_inertia, rotor_inertia_with_brake=self.rotor_inertia_with_brake,
            windings=tuple(sorted(made, key=lambda one: -one.poles)),
        )  # fmt: skip


class InductionMotorChoice(Part):
    """An induction motor: ``{"id": ...}`` or ``{"own": {...}}``."""

    product_type: ClassVar[type[Product]] = InductionMotor
    own: OwnInductionMotor | None = None


class OwnBrake(OwnProduct):
    """A motor brake as its data sheet prints it."""

    name: Annotated[str, Option(default="own brake", about="name of the brake", group=_BRAKE)]
    torque: Annotated[float, Quantity("N m", symbol="M_B", gt=0, le=1e6, about="braking torque", group=_BRAKE)]
    application_time_dc: Annotated[
        float | None, _q("ms", "t_2", "application time, cut off in the AC and DC circuit", 10, _BRAKE)
    ]
    application_time_ac: Annotated[
        float | None, _q("ms", "t_2AC", "application time, cut off in the AC circuit", 10, _BRAKE)
    ]
    work_until_adjustment: Annotated[float | None, _q("MJ", "W_N", "braking work until readjustment", 1e12, _BRAKE)]
    max_work_per_operation: Annotated[float | None, _q("J", "W_max", "permitted work of one braking", 1e9, _BRAKE)]

    def product(self) -> MotorBrake:
        """The brake as a product record."""
        values = {name: getattr(self, name) for name in type(self).model_fields if name != "name"}
        return MotorBrake(id="own", manufacturer="", series="", model=self.name, source=_SOURCE, **values)


class MotorBrakeChoice(Part):
    """A motor brake: ``{"id": ...}`` or ``{"own": {...}}``."""

    product_type: ClassVar[type[Product]] = MotorBrake
    own: OwnBrake | None = None


class OwnIndustrialGearUnit(OwnProduct):
    """An industrial gear unit as its data sheet prints it; what is left empty is not checked."""

    name: Annotated[str, Option(default="own gear unit", about="name of the gear unit", group=_GEAR)]
    ratio: Annotated[
        float, Quantity("1", symbol="i", gt=0, le=1e5, about="ratio of motor to output speed", group=_GEAR)
    ]
    efficiency: Annotated[
        float,
        Quantity("1", symbol="eta_G", gt=0, le=1, default=0.95, group=_GEAR, about="efficiency",
                 source="SEW 2001, 6: helical gear units lose about 2 % in each stage"),
    ]  # fmt: skip
    kind: Annotated[str | None, Option(default=None, about="design: helical, worm, bevel, planetary ...", group=_GEAR)]
    max_output_torque: Annotated[
        float | None, _q("N m", "M_amax", "permitted output torque at service factor 1", 1e7, _GEAR)
    ]
    permissible_overhung_load: Annotated[
        float | None, _q("N", "F_Ra", "permitted overhung load at the middle of the shaft end", 1e8, _GEAR)
    ]
    inertia: Annotated[
        float,
        Quantity("kg m2", symbol="J_G", ge=0, le=1e3, default=0.0, source="no inertia given",
                 about="inertia referred to the motor shaft", group=_GEAR),
    ]  # fmt: skip
    backlash: Annotated[float | None, _q("arcmin", "phi_G", "backlash at the output", 1, _GEAR)]
    max_input_speed: Annotated[float | None, _q("rpm", "n_emax", "highest input speed", 1e4, _GEAR)]
    mass: Annotated[float | None, _q("kg", "m_G", "mass", 1e5, _GEAR)]

    def product(self) -> GearUnit:
        """The gear unit as a product record."""
        values = {name: getattr(self, name) for name in type(self).model_fields if name != "name"}
        return GearUnit(id="own", manufacturer="", series="", model=self.name, source=_SOURCE, **values)


class IndustrialGearUnitChoice(Part):
    """An industrial gear unit: ``{"id": ...}`` or ``{"own": {...}}``."""

    product_type: ClassVar[type[Product]] = GearUnit
    own: OwnIndustrialGearUnit | None = None


class OwnInverter(OwnProduct):
    """A frequency inverter as its data sheet prints it."""

    name: Annotated[str, Option(default="own inverter", about="name of the inverter", group=_INV)]
    rated_current: Annotated[float | None, _q("A", "I_N", "rated output current", 1e5, _INV)]
    motor_power: Annotated[float | None, _q("kW", "P_N", "recommended motor power", 1e8, _INV)]
    overload_current: Annotated[float | None, _q("A", "I_max", "overload current", 1e5, _INV)]
    overload_time: Annotated[float | None, _q("s", "t_ov", "how long the overload current may flow", 3600, _INV)]
    min_braking_resistance: Annotated[
        float | None, _q("ohm", "R_min", "lowest permitted braking resistance", 1e5, _INV)
    ]

    def product(self) -> Inverter:
        """The inverter as a product record."""
        values = {name: getattr(self, name) for name in type(self).model_fields if name != "name"}
        return Inverter(id="own", manufacturer="", series="", model=self.name, source=_SOURCE, **values)


class InverterChoice(Part):
    """A frequency inverter: ``{"id": ...}`` or ``{"own": {...}}``."""

    product_type: ClassVar[type[Product]] = Inverter
    own: OwnInverter | None = None


class DutyRating(Declared):
    """Permitted power of a braking resistor at one duty."""

    duty: Annotated[float, Quantity("%", symbol="ED", gt=0, le=1, about="duty")]
    power: Annotated[float, Quantity("kW", symbol="P", gt=0, le=1e8, about="permitted power")]


class OwnBrakingResistor(OwnProduct):
    """A braking resistor as its data sheet prints it."""

    name: Annotated[str, Option(default="own resistor", about="name of the braking resistor", group=_RES)]
    resistance: Annotated[float | None, _q("ohm", "R", "resistance", 1e5, _RES)]
    duty_cycle_time: Annotated[
        float,
        Quantity("s", symbol="t_ED", gt=0, le=3600, default=120.0, source="SEW 2001, 9.2: 120 s",
                 about="time that the duty refers to", group=_RES),
    ]  # fmt: skip
    peak_power: Annotated[float | None, _q("kW", "P_max", "peak power", 1e8, _RES)]
    ratings: Annotated[list[DutyRating], Field(min_length=1, max_length=12), Option(about="permitted power by duty")]

    def product(self) -> BrakingResistor:
        """The resistor as a product record, ratings by rising duty."""
        points = tuple(sorted((one.duty, one.power) for one in self.ratings))
        return BrakingResistor(
            id="own", manufacturer="", series="", model=self.name, source=_SOURCE, resistance=self.resistance,
            ratings=points, duty_cycle_time=self.duty_cycle_time, peak_power=self.peak_power,
        )  # fmt: skip


class BrakingResistorChoice(Part):
    """A braking resistor: ``{"id": ...}`` or ``{"own": {...}}``."""

    product_type: ClassVar[type[Product]] = BrakingResistor
    own: OwnBrakingResistor | None = None


def roles_of(model: type[Declared]) -> tuple[str, ...]:
    """Every part that a drive model has, whether chosen or not: the names of its fields."""
    return tuple(
        name
        for name, info in model.model_fields.items()
        if any(isinstance(one, type) and issubclass(one, Part) for one in get_args(info.annotation))
    )


def parts_of(model: Declared) -> Iterator[tuple[str, Part]]:
    """The parts that a drive model names, by role (the field's name)."""
    for name in type(model).model_fields:
        value = getattr(model, name)
        if isinstance(value, Part):
            yield name, value
