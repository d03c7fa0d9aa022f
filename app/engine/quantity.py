"""Quantities are declared once: unit, symbol, meaning, range, default and where the default comes from.

A model that derives from :class:`Declared` holds SI values in its attributes. At the border (JSON key, form field, CSV
header) each name carries its customary unit, and a value is converted here and nowhere else::

    class Wheel(Declared):
        diameter: Annotated[float, Quantity("mm", symbol="D", gt=0, le=5, about="wheel diameter")]

    Wheel.model_validate({"diameter_mm": 250}).diameter        # 0.25
    Wheel.model_validate({"diameter_mm": "9.84 in"}).diameter  # 0.249936
    Wheel.si(diameter=0.25).model_dump(by_alias=True)          # {"diameter_mm": 250.0}
"""

import inspect
import math
import operator
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache, cached_property
from typing import Any, ClassVar, Self, get_args

import pint
from pydantic import (
    BaseModel,
    ConfigDict,
    Field,
    GetCoreSchemaHandler,
    GetJsonSchemaHandler,
    SerializationInfo,
    ValidationInfo,
)
from pydantic.fields import FieldInfo
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema, PydanticCustomError, PydanticUndefined, core_schema

from app.engine.errors import UnitError

NUMBER_PATTERN = r"[-+]?(?:\d+(?:[ \u00a0\u202f]\d{3})*(?:[.,]\d*)*|[.,]\d+)(?:[eE][-+]?\d+)?"
_NUMBER_WITH_UNIT = re.compile(rf"^\s*(?P<number>{NUMBER_PATTERN})\s*(?P<unit>[^\d\s.,].*?|1\s*/.*?)?\s*$")
_LONGEST_TEXT = 60
# What a reader may type as a unit: names, small powers, products, quotients; nothing that pint would have to compute.
_UNIT_TEXT = re.compile(r"^(1?\s*/\s*)?[A-Za-z%°]+(\^?-?[1-4])?(\s*[ */]\s*[A-Za-z%°]+(\^?-?[1-4])?)*$")
_SUPERSCRIPTS = str.maketrans(
    {"¹": "1", "²": "2", "³": "3", "⁴": "4", "⁻": "-", "−": "-", "·": " ", "×": " ", "µ": "u", "μ": "u", "Ω": "ohm"}
)
_COMPACT = {
    "Nm": "N m", "mNm": "mN m", "kNm": "kN m", "Ncm": "N cm", "kgm2": "kg m2", "kgcm2": "kg cm2", "Ws": "W s",
    "PS": "metric_horsepower", "kp": "kgf", "U": "rev",
}  # fmt: skip
_ANGLES = {
    "radian", "degree", "arcminute", "arcsecond", "turn", "rev", "revolutions_per_minute", "revolutions_per_second",
}  # fmt: skip
"""Units of angle and rotational speed. To pint an angle has no dimension: "10 mm/rev" would pass for 1.59 mm."""
_TURNS = {
    "1/min": "rpm",
    "min-1": "rpm",
    "r/min": "rpm",
    "U/min": "rpm",
    "RPM": "rpm",
    "/min": "rpm",
    "1/s": "rev/s",
    "s-1": "rev/s",
    "Hz": "rev/s",
}


@cache
def _registry() -> pint.UnitRegistry[float]:
    registry: pint.UnitRegistry[float] = pint.UnitRegistry(on_redefinition="ignore")
    registry.define("rev = 2 * pi * radian")
    return registry


def _pint_expression(unit: str) -> str:
    """Spell one of our units (``kg cm2``, ``N m/arcmin``) for pint: a space multiplies, a trailing digit is a power."""
    text = unit.translate(_SUPERSCRIPTS).replace("°C", "degC").replace("°", "deg").replace("%", "percent").strip()
    text = re.sub(r"[A-Za-z]+\d?", lambda word: _COMPACT.get(word[0], word[0]), text)
    text = f"1{text}" if text.startswith("/") else text
    text = re.sub(r"([A-Za-z])\^?(-?\d)", r"\1**\2", text)
    return re.sub(r"\s*/\s*", "/", text).replace(" ", "*") or "dimensionless"


@cache
def si_factor(unit: str) -> tuple[float, float]:
    """Scale and offset that turn a value in ``unit`` into SI: ``si = value * scale + offset`` (offset only for °C)."""
    if unit == "1":
        return 1.0, 0.0
    try:
        zero, one = (_registry().Quantity(v, _pint_expression(unit)).to_base_units().magnitude for v in (0.0, 1.0))
    except (pint.PintError, AttributeError, TypeError, ValueError, AssertionError) as error:
        raise UnitError(f"{unit!r} is not a known unit") from error
    return one - zero, zero


def to_si(value: float, unit: str) -> float:
    """Convert a number in ``unit`` to SI.

    >>> to_si(250.0, "mm")
    0.25
    """
    scale, offset = si_factor(unit)
    return value * scale + offset


def from_si(value: float, unit: str) -> float:
    """Convert an SI number to ``unit``, rounded to 12 significant digits so that 1500 rpm reads 1500.

    >>> from_si(to_si(1500.0, "rpm"), "rpm")
    1500.0
    """
    scale, offset = si_factor(unit)
    return float(f"{(value - offset) / scale:.12g}")


def unit_suffix(unit: str) -> str:
    """Name part that carries a unit across the border.

    >>> [unit_suffix(u) for u in ("mm", "1", "m/s2", "N m", "kg cm2", "N/um", "%", "deg")]
    ['_mm', '', '_m_s2', '_nm', '_kgcm2', '_n_um', '_percent', '_deg']
    """
    if unit == "1":
        return ""
    text = unit.replace("%", "percent").replace(" ", "").replace("/", "_").lower()
    return f"_{text}"


def parse_number(text: str) -> float:
    """Read a decimal number written with a point or a comma; blanks may group digits.

    Raises UnitError when the text is no finite number.

    >>> [parse_number(t) for t in ("1.5", "1,5", "1 234,5", "1,234.5")]
    [1.5, 1.5, 1234.5, 1234.5]
    """
    compact = re.sub(r"[\s\u00a0\u202f]", "", text).replace("−", "-")
    last = max(compact.rfind("."), compact.rfind(","))
    if last >= 0:
        head = re.sub(r"[.,]", "", compact[:last])
        separators = re.findall(r"[.,]", compact[:last])
        if compact[last] in separators:
            raise UnitError(f"{text!r} has more than one decimal sign")
        compact = f"{head}.{compact[last + 1 :]}"
    try:
        return float(compact)
    except ValueError as error:
        raise UnitError(f"{text!r} is not a number") from error


def _angle_power(unit: Any) -> float:
    """Power of the angle in a unit: 1 for rpm, -1 for N m/rad, 0 for Hz."""
    known = _registry().parse_unit_name
    return sum(
        float(str(power))
        for name, power in pint.util.to_units_container(unit).items()
        if any(base in _ANGLES for _, base, _ in known(name))
    )


def _same_kind(given: str, wanted: str) -> str:
    """Spell ``given`` for pint, reading 1/min and Hz as turns where a rotational speed is wanted."""
    if "rpm" in wanted:
        given = _TURNS.get(given.replace(" ", "").translate(_SUPERSCRIPTS).replace("^", ""), given)
    return _pint_expression(given)


def _convert_text(text: str, unit: str) -> float:
    spelt = text.translate(_SUPERSCRIPTS).replace("**", "^") if len(text) <= _LONGEST_TEXT else ""
    match = _NUMBER_WITH_UNIT.match(spelt)
    if match is None:
        raise UnitError(f"{text.strip()[:60]!r} is not a number")
    number = parse_number(match["number"])
    given = match["unit"]
    if given is None:
        return to_si(number, unit)
    if _UNIT_TEXT.match(given) is None:
        raise UnitError(f"{given[:30]!r} is not a known unit")
    registry = _registry()
    try:
        quantity = registry.Quantity(number, _same_kind(given, unit))
        wanted = registry.Unit(_pint_expression(unit if unit != "1" else ""))
        if _angle_power(quantity.units) != _angle_power(wanted):
            raise pint.DimensionalityError(quantity.units, wanted)
        return float(quantity.to(wanted).to_base_units().magnitude)
    except pint.DimensionalityError as error:
        raise UnitError(f"{given!r} does not measure the same thing as {unit!r}") from error
    except (
        pint.PintError,
        AttributeError,
        TypeError,
        ValueError,
        AssertionError,
        OverflowError,
        RecursionError,
    ) as error:
        raise UnitError(f"{given[:30]!r} is not a known unit") from error


@dataclass(frozen=True, kw_only=True)
class Declaration:
    """What every input declares about itself beside its type.

    ``about`` is the meaning in a few words, ``default`` the value taken when nothing is given (SI), ``source`` where
    that default comes from, ``group`` the heading it stands under in a form.
    """

    symbol: str = ""
    about: str = ""
    default: Any = PydanticUndefined
    source: str = ""
    group: str = ""
    label: str = ""


@dataclass(frozen=True, kw_only=True)
class Option(Declaration):
    """A choice, flag, count or text: an input without a unit. ``labels`` names the choices for the reader."""

    labels: dict[Any, str] = field(default_factory=dict, hash=False)
    ge: int | None = None
    le: int | None = None

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        schema = handler(source)
        if self.ge is not None or self.le is not None:
            schema = core_schema.chain_schema([schema, core_schema.int_schema(ge=self.ge, le=self.le)])
        return schema

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        found = handler(schema)
        bounds = {"minimum": self.ge, "maximum": self.le}
        found = {**found, **{key: value for key, value in bounds.items() if value is not None}}
        labels = {"" if choice is None else str(choice): words for choice, words in self.labels.items()}
        extra = {"x-labels": labels, "x-symbol": self.symbol, "x-source": self.source, "description": self.about}
        return {**found, **{key: value for key, value in extra.items() if value}}


@dataclass(frozen=True, init=False)
class Quantity(Declaration):
    """A number with a unit: ``unit`` is the customary one at the border, ``default`` and the four bounds are SI."""

    unit: str = "1"
    gt: float | None = None
    ge: float | None = None
    lt: float | None = None
    le: float | None = None

    def __init__(
        self,
        unit: str,
        /,
        *,
        gt: float | None = None,
        ge: float | None = None,
        lt: float | None = None,
        le: float | None = None,
        **about: Any,
    ) -> None:
        super().__init__(**about)
        for name, value in (("unit", unit), ("gt", gt), ("ge", ge), ("lt", lt), ("le", le)):
            object.__setattr__(self, name, value)
        si_factor(unit)

    @cached_property
    def suffix(self) -> str:
        """What the border name ends in, e.g. ``_mm``."""
        return unit_suffix(self.unit)

    def to_si(self, value: object) -> float:
        """Turn what stands at the border (a number in ``unit``, or a text with or without a unit) into SI.

        Raises UnitError when it is neither, not finite, or of another dimension; the range is not looked at.
        """
        if isinstance(value, bool) or not isinstance(value, (int, float, str)):
            raise UnitError("is not a number")
        try:
            si = _convert_text(value, self.unit) if isinstance(value, str) else to_si(float(value), self.unit)
        except OverflowError as error:
            raise UnitError("is too large for a number") from error
        if not math.isfinite(si):
            raise UnitError("is not a finite number")
        return si

    def from_si(self, value: float) -> float:
        """Turn an SI value into the customary unit."""
        return from_si(value, self.unit)

    def validate(self, value: object, info: ValidationInfo) -> float:
        """Validator of every field: border value (SI value, with ``context={"si": True}``) to SI within the range."""
        is_si = (info.context or {}).get("si") and isinstance(value, (int, float)) and not isinstance(value, bool)
        try:
            si = _SI.to_si(value) if is_si else self.to_si(value)
        except UnitError as error:
            raise PydanticCustomError(
                "quantity", "{reason}; give a number in {unit}, or a number with its unit",
                {"reason": error.message, "unit": self.shown_unit},
            ) from error  # fmt: skip
        self._check_range(si)
        return si

    @property
    def shown_unit(self) -> str:
        """The unit in words that fit a sentence."""
        return "no unit (a plain number)" if self.unit == "1" else self.unit

    def _check_range(self, si: float) -> None:
        bounds = (
            ("greater_than", "greater than", self.gt, operator.gt),
            ("greater_than_equal", "at least", self.ge, operator.ge),
            ("less_than", "less than", self.lt, operator.lt),
            ("less_than_equal", "at most", self.le, operator.le),
        )
        for code, words, limit, holds in bounds:
            if limit is not None and not holds(si, limit):
                shown = f"{self.from_si(limit):g}" + ("" if self.unit == "1" else f" {self.unit}")
                raise PydanticCustomError(
                    f"quantity_{code}", "must be {words} {limit}", {"words": words, "limit": shown}
                )

    def _serialize(self, value: float | None, info: SerializationInfo) -> float | None:
        return self.from_si(value) if value is not None and info.by_alias else value

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        shown = core_schema.plain_serializer_function_ser_schema(self._serialize, info_arg=True)
        number = core_schema.with_info_plain_validator_function(self.validate, serialization=shown)
        return core_schema.nullable_schema(number) if type(None) in get_args(source) else number

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        names = {"gt": "exclusiveMinimum", "ge": "minimum", "lt": "exclusiveMaximum", "le": "maximum"}
        bounds = {names[k]: self.from_si(v) for k in names if (v := getattr(self, k)) is not None}
        choices: list[JsonSchemaValue] = [
            {"type": "number", **bounds},
            {"type": "string", "minLength": 1, "maxLength": _LONGEST_TEXT},
        ]
        if schema["type"] == "nullable":
            choices.append({"type": "null"})
        found: JsonSchemaValue = {"anyOf": choices, "x-unit": self.unit}
        extra = {"x-symbol": self.symbol, "x-source": self.source, "description": self.about}
        return {**found, **{key: value for key, value in extra.items() if value}}


_SI = Quantity("1")


def declaration(info: FieldInfo) -> Declaration | None:
    """The Quantity or Option in a field's annotation, if it has one."""
    return next((item for item in info.metadata if isinstance(item, Declaration)), None)


def in_shown_order(model: type[BaseModel]) -> list[tuple[str, FieldInfo]]:
    """Fields of a model by attribute: in order of declaration, what its base brings along last."""
    last = model.shown_last if issubclass(model, Declared) else frozenset()
    return sorted(model.model_fields.items(), key=lambda field: field[0] in last)


class Declared(BaseModel):
    """Base of every input model: names carry units at the border, attributes are SI, nothing unknown is accepted."""

    model_config = ConfigDict(extra="forbid", frozen=True, hide_input_in_errors=True)

    title: ClassVar[str] = ""
    shown_last: ClassVar[frozenset[str]] = frozenset()
    """Attributes that stand behind all others wherever inputs are listed: what a base class brings along."""

    def __init_subclass__(cls, **kwargs: Any) -> None:
        """Give each declared field its border name and its default before pydantic collects the fields."""
        for name, annotation in inspect.get_annotations(cls).items():
            if isinstance(annotation, str):
                raise TypeError(f"{cls.__name__}.{name}: declarations need evaluated annotations")
            found = next((m for m in getattr(annotation, "__metadata__", ()) if isinstance(m, Declaration)), None)
            if found is None:
                continue
            options: dict[str, Any] = {"description": found.about or None}
            if isinstance(found, Quantity):
                options["alias"] = name + found.suffix
            given = cls.__dict__.get(name, found.default)
            setattr(cls, name, Field(given, **options) if given is not PydanticUndefined else Field(**options))
        super().__init_subclass__(**kwargs)

    @classmethod
    def si(cls, **values: Any) -> Self:
        """Build from SI values under attribute names, for programs; ``model_validate`` takes border values."""
        return cls.model_validate(values, by_alias=False, by_name=True, context={"si": True})

    @classmethod
    def declarations(cls) -> Iterator[tuple[str, FieldInfo, Declaration]]:
        """Yield (attribute, field, declaration) of every declared field in the order in which they are shown."""
        for name, info in in_shown_order(cls):
            found = declaration(info)
            if found is not None:
                yield name, info, found

    @classmethod
    def border_name(cls, attribute: str) -> str:
        """Name of an attribute at the border, e.g. ``diameter`` -> ``diameter_mm``."""
        return cls.model_fields[attribute].alias or attribute

    def defaults_taken(self) -> Iterator[tuple[str, Declaration, Any]]:
        """Yield (attribute, declaration, value) of each declared default that the user has not confirmed.

        An input that is left empty (None, no text, no entries) takes nothing, so there is nothing to confirm.
        """
        for name, _, found in self.declarations():
            value = getattr(self, name)
            if name not in self.model_fields_set and value not in (None, "", ()):
                yield name, found, value
