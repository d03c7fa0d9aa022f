"""Values at the border: units, decimal signs, ranges, names; and everything that must be refused there."""

import math
from typing import Annotated, Any, Literal

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from app.engine.errors import UnitError
from app.engine.quantity import Declared, Option, Quantity, from_si, parse_number, si_factor, to_si, unit_suffix


class Wheel(Declared):
    """A model with every kind of field."""

    diameter: Annotated[float, Quantity("mm", symbol="D", gt=0, le=5, about="wheel diameter")]
    friction: Annotated[
        float, Quantity("1", symbol="c", ge=0, lt=1, default=0.003, about="rim friction", source="SEW 2001, 17.1")
    ]
    speed: Annotated[float | None, Quantity("rpm", about="highest speed", default=None)]
    count: Annotated[int, Option(about="number of wheels", default=4, ge=1, le=8)]
    bearing: Annotated[
        Literal["ball", "plain"], Option(about="bearing", default="ball", labels={"ball": "Ball bearing"})
    ]
    name: str = ""


class Axle(Declared):
    """A model that contains others."""

    wheel: Wheel
    spares: tuple[Wheel, ...] = ()


def reason(values: dict[str, Any], model: type[Declared] = Wheel) -> dict[str, str]:
    """Field -> message of a refused input."""
    with pytest.raises(ValidationError) as caught:
        model.model_validate(values)
    return {".".join(map(str, error["loc"])): error["msg"] for error in caught.value.errors()}


# Factors from the definitions of the units: 1 in = 25.4 mm, 1 lb = 0.45359237 kg, g_n = 9.80665 m/s2.
@pytest.mark.parametrize(
    ("text", "unit", "si"),
    [
        (250, "mm", 0.25), (250.5, "mm", 0.2505), ("250", "mm", 0.25), (" 250 mm ", "mm", 0.25), ("0.25m", "mm", 0.25),
        ("9.84 in", "mm", 9.84 * 0.0254), ("12 µm", "mm", 12e-6), ("12 \u03bcm", "mm", 12e-6), ("12 um", "mm", 12e-6),
        ("2,5", "mm", 0.0025), ("1 234,5", "mm", 1.2345), ("1.234,5 mm", "mm", 1.2345), ("1,234.5 mm", "mm", 1.2345),
        ("\u22125 mm", "mm", -0.005), ("1e3", "mm", 1.0), (".5", "mm", 0.0005), ("5.", "mm", 0.005),
        ("5\u00a0mm", "mm", 0.005), ("1\u202f234", "mm", 1.234),
        ("30 m/min", "m/s", 0.5), ("30 m / min", "m/s", 0.5), ("1.8 km/h", "m/s", 0.5),
        ("1 m/s²", "m/s2", 1.0), ("1 m/s^2", "m/s2", 1.0), ("1 m/s2", "m/s2", 1.0), ("1 m s-2", "m/s2", 1.0),
        (1500, "rpm", 50 * math.pi), ("1500 1/min", "rpm", 50 * math.pi), ("1500 min-1", "rpm", 50 * math.pi),
        ("1500 min⁻¹", "rpm", 50 * math.pi), ("1500/min", "rpm", 50 * math.pi), ("1500 RPM", "rpm", 50 * math.pi),
        ("1500 U/min", "rpm", 50 * math.pi), ("25 Hz", "rpm", 50 * math.pi), ("25 1/s", "rpm", 50 * math.pi),
        ("157 rad/s", "rpm", 157.0), ("9000 °/s", "rpm", 50 * math.pi),
        ("25 Hz", "Hz", 25.0), ("25 1/s", "Hz", 25.0), ("1500 1/min", "Hz", 25.0),
        ("5 Nm", "N m", 5.0), ("5 N m", "N m", 5.0), ("5 N·m", "N m", 5.0), ("5 N*m", "N m", 5.0),
        ("5 kNm", "N m", 5000.0),
        ("5 Ncm", "N m", 0.05), ("10 lbf in", "N m", 10 * 0.45359237 * 9.80665 * 0.0254), ("5 Nm/rad", "N m/rad", 5.0),
        ("5 Nm/arcmin", "N m/arcmin", 5 * 60 * 180 / math.pi), ("12 kg cm²", "kg cm2", 0.0012),
        ("12 kgcm2", "kg cm2", 0.0012), ("12 kg·cm^2", "kg m2", 0.0012), ("423.6 N/µm", "N/um", 4.236e8),
        ("30°", "deg", math.pi / 6), ("30 deg", "deg", math.pi / 6), ("30", "deg", math.pi / 6),
        ("0.5 rad", "deg", 0.5),
        ("3 arcmin", "deg", 3 * math.pi / 10800), ("20 °C", "degC", 293.15), (20, "degC", 293.15),
        ("293 K", "degC", 293.0),
        ("5 %", "1", 0.05), (92, "%", 0.92), ("0.8", "1", 0.8), ("3 t", "kg", 3000.0), ("1 kp", "N", 9.80665),
        ("1 PS", "W", 735.49875), ("210 GPa", "Pa", 2.1e11), ("10 mm/rev", "m/rad", 0.01 / (2 * math.pi)),
    ],
)  # fmt: skip
def test_a_border_value_is_converted(text: object, unit: str, si: float) -> None:
    assert Quantity(unit).to_si(text) == pytest.approx(si, rel=1e-9)


@pytest.mark.parametrize(
    "text",
    ["", "  ", "abc", "mm", "nan", "NaN", "inf", "-inf", "Infinity", "1.2.3", "1,2,3", "1 2", "--5", "5 5 mm", "1e5.5"],
)
def test_a_text_without_a_number_is_refused(text: str) -> None:
    with pytest.raises(UnitError):
        Quantity("mm").to_si(text)


@pytest.mark.parametrize("value", [True, False, None, [1], {"a": 1}, b"5", 5j])
def test_what_is_neither_number_nor_text_is_refused(value: object) -> None:
    with pytest.raises(UnitError, match="not a number"):
        Quantity("mm").to_si(value)


@pytest.mark.parametrize(
    "value", [math.nan, math.inf, -math.inf, 10**400, "1e400", "-1e400", "1e308 km", 1e400, "9" * 59 + "e9"]
)
def test_what_is_not_finite_is_refused(value: object) -> None:
    with pytest.raises(UnitError):
        Quantity("km").to_si(value)


@pytest.mark.parametrize(
    ("text", "unit"),
    [
        ("12 kg", "mm"), ("1 m/s", "mm"), ("5 mm", "1"), ("5 m^2", "mm"), ("5 %", "mm"), ("1 g", "m/s2"),
        ("10 mm/rev", "mm"),  # a lead per turn is no length: 1.59 mm would be a silent mistake
        ("5 rpm", "Hz"), ("5 rad", "1"), ("5 N m/rad", "N m"), ("5 kHz", "rpm"), ("3 deg", "%"),
    ],
)  # fmt: skip
def test_a_unit_of_another_dimension_is_refused(text: str, unit: str) -> None:
    with pytest.raises(UnitError, match="does not measure the same thing"):
        Quantity(unit).to_si(text)


@pytest.mark.parametrize(
    "unit",
    [
        "foo", "m**9**9**9", "m^999999999", "m^9", "(m)", "m)", "m;import os", "__class__", "m.real", "lambda", "m\x00",
        "1/2", "/2", "m//s", "[length]", "{m}", "m" * 50, "delta_degC", "м", "米", "m'", "exp(m)", "m^^2",
        "m s s s s^5",
    ],
)  # fmt: skip
def test_a_nonsense_unit_is_refused(unit: str) -> None:
    with pytest.raises(UnitError):
        Quantity("mm").to_si(f"5 {unit}")


@pytest.mark.parametrize(
    "text",
    [
        "1" * 1_000_000, "1 000" * 200_000, "5 " + "m " * 500_000, "5 m" + "^2" * 300_000, " " * 1_000_000 + "x",
        "1" + "." * 500_000, "5 " + "(" * 400_000, "5 " + "a/" * 400_000 + "!",
    ],
)  # fmt: skip
def test_an_endless_text_is_refused_at_once(text: str) -> None:
    """Each of these takes minutes or more where a pattern or the unit parser is let loose on it."""
    with pytest.raises(UnitError):
        Quantity("mm").to_si(text)


@given(st.text(max_size=61))
def test_any_text_is_a_finite_number_or_refused(text: str) -> None:
    try:
        value = Quantity("mm").to_si(text)
    except UnitError:
        return
    assert math.isfinite(value)


@given(st.text(alphabet="mkgsNrad/*^- .,²³µ°%0123456789e", max_size=30))
def test_any_unit_like_text_is_a_finite_number_or_refused(text: str) -> None:
    try:
        value = Quantity("N m").to_si(f"5 {text}")
    except UnitError:
        return
    assert math.isfinite(value)


def test_a_message_shows_what_was_typed_but_never_much_of_it() -> None:
    with pytest.raises(UnitError) as caught:
        Quantity("mm").to_si("x" * 1000)
    assert len(str(caught.value)) < 100


@pytest.mark.parametrize("unit", ["mm", "rpm", "kg cm2", "N/um", "degC", "%", "deg", "1", "N m/arcmin", "m/s2"])
@given(value=st.floats(-1e9, 1e9))
def test_a_value_survives_the_way_in_and_out(unit: str, value: float) -> None:
    assert from_si(to_si(value, unit), unit) == pytest.approx(value, rel=1e-10, abs=1e-9)


@pytest.mark.parametrize("value", [1500.0, 0.1, 250.0, 3000.0, 20.0, 1e-6])
@pytest.mark.parametrize("unit", ["mm", "rpm", "kg cm2", "N/um", "%", "deg"])
def test_a_round_number_stays_round(value: float, unit: str) -> None:
    assert from_si(to_si(value, unit), unit) == value


@pytest.mark.parametrize("unit", ["foo", "?", "mm mm mm foo"])
def test_a_declaration_with_an_unknown_unit_is_refused(unit: str) -> None:
    with pytest.raises(UnitError):
        Quantity(unit)


def test_the_factor_of_a_temperature_has_an_offset() -> None:
    assert si_factor("degC") == (pytest.approx(1.0), pytest.approx(273.15))
    assert si_factor("1") == (1.0, 0.0)


@pytest.mark.parametrize(
    ("text", "value"),
    [("1.5", 1.5), ("1,5", 1.5), ("1 234,5", 1234.5), ("1,234.5", 1234.5), ("1.234.567,8", 1234567.8), ("−2", -2.0)],
)
def test_a_decimal_comma_is_a_decimal_point(text: str, value: float) -> None:
    assert parse_number(text) == value


def test_a_number_is_read_in_the_unit_of_its_name() -> None:
    wheel = Wheel.model_validate({"diameter_mm": "250", "friction": "0,004", "speed_rpm": "25 Hz"})
    assert (wheel.diameter, wheel.friction) == (0.25, 0.004)
    assert wheel.speed == pytest.approx(50 * math.pi)


def test_a_declared_name_carries_its_unit_at_the_border_only() -> None:
    assert [Wheel.border_name(name) for name in Wheel.model_fields] == [
        "diameter_mm", "friction", "speed_rpm", "count", "bearing", "name",
    ]  # fmt: skip
    assert reason({"diameter": 0.25}) == {
        "diameter_mm": "Field required", "diameter": "Extra inputs are not permitted",
    }  # fmt: skip


@pytest.mark.parametrize(
    ("unit", "suffix"),
    [("mm", "_mm"), ("1", ""), ("N m", "_nm"), ("kg cm2", "_kgcm2"), ("m/s2", "_m_s2"), ("%", "_percent")],
)
def test_a_suffix_follows_from_the_unit(unit: str, suffix: str) -> None:
    assert unit_suffix(unit) == suffix


def test_unknown_keys_are_refused() -> None:
    assert reason({"diameter_mm": 250, "diameter_cm": 25}) == {"diameter_cm": "Extra inputs are not permitted"}


@pytest.mark.parametrize(
    ("value", "message"),
    [
        (0, "must be greater than 0 mm"), (-1, "must be greater than 0 mm"), (5000.1, "must be at most 5000 mm"),
        ("6 m", "must be at most 5000 mm"),
        ("x", "'x' is not a number; give a number in mm, or a number with its unit"),
        (math.nan, "is not a finite number; give a number in mm, or a number with its unit"),
        ("1e400", "is not a finite number; give a number in mm, or a number with its unit"),
        ("3 kg", "'kg' does not measure the same thing as 'mm'; give a number in mm, or a number with its unit"),
        (None, "is not a number; give a number in mm, or a number with its unit"),
    ],
)  # fmt: skip
def test_a_refused_value_says_why_at_its_field(value: object, message: str) -> None:
    assert reason({"diameter_mm": value}) == {"diameter_mm": message}


def test_the_borders_of_a_range_belong_to_it_as_declared() -> None:
    assert Wheel.model_validate({"diameter_mm": 5000, "friction": 0}).diameter == 5
    assert reason({"diameter_mm": 1, "friction": 1}) == {"friction": "must be less than 1"}
    assert reason({"diameter_mm": 1, "friction": -1e-9}) == {"friction": "must be at least 0"}


def test_an_input_without_unit_says_so() -> None:
    message = reason({"diameter_mm": 1, "friction": "x"})["friction"]
    assert message.endswith("give a number in no unit (a plain number), or a number with its unit")


def test_every_refused_field_is_named_in_nested_models_too() -> None:
    found = reason({"wheel": {"diameter_mm": -1}, "spares": [{"diameter_mm": 1}, {"diameter_mm": "x"}]}, Axle)
    assert set(found) == {"wheel.diameter_mm", "spares.1.diameter_mm"}


def test_an_error_does_not_repeat_the_input() -> None:
    with pytest.raises(ValidationError) as caught:
        Wheel.model_validate({"diameter_mm": "secret" * 5})
    assert "input_value" not in str(caught.value)


def test_a_program_builds_in_si() -> None:
    wheel = Wheel.si(diameter=0.25, speed=157.0)
    assert (wheel.diameter, wheel.speed) == (0.25, 157.0)
    assert Axle.si(wheel=wheel, spares=[{"diameter": 0.5}]).spares[0].diameter == 0.5
    assert Wheel.si(diameter="250 mm").diameter == 0.25


@pytest.mark.parametrize("value", [math.nan, math.inf, -1.0, 5.1, 10**400, True, None])
def test_a_program_is_held_to_the_range_too(value: object) -> None:
    with pytest.raises(ValidationError):
        Wheel.si(diameter=value)


@given(st.floats(1e-6, 5.0), st.floats(0, 0.999), st.one_of(st.none(), st.floats(-1e4, 1e4)))
def test_a_model_survives_the_way_out_and_in(diameter: float, friction: float, speed: float | None) -> None:
    wheel = Wheel.si(diameter=diameter, friction=friction, speed=speed)
    dumped = wheel.model_dump(by_alias=True)
    back = Wheel.model_validate(dumped)
    assert back.diameter == pytest.approx(diameter, rel=1e-10)
    assert (back.speed is None) == (speed is None)
    assert Wheel.model_validate(back.model_dump(by_alias=True)) == back
    assert Wheel.model_validate_json(wheel.model_dump_json(by_alias=True)) == back


def test_a_dump_by_name_is_si() -> None:
    wheel = Wheel.si(diameter=0.25)
    assert wheel.model_dump()["diameter"] == 0.25
    assert wheel.model_dump(by_alias=True)["diameter_mm"] == 250.0
    assert wheel.model_dump(by_alias=True)["speed_rpm"] is None


def test_a_model_cannot_be_changed() -> None:
    with pytest.raises(ValidationError):
        Wheel.si(diameter=0.25).diameter = 0.3  # type: ignore[misc]


def test_defaults_that_were_taken_are_known() -> None:
    wheel = Wheel.model_validate({"diameter_mm": 250, "count": 4})
    taken = {name: value for name, _, value in wheel.defaults_taken()}
    assert taken == {"friction": 0.003, "bearing": "ball"}  # count was confirmed, an empty speed is no value
    confirmed = Wheel.model_validate({"diameter_mm": 250, "friction": 0.003, "count": 4, "bearing": "ball"})
    assert list(confirmed.defaults_taken()) == []


def test_the_schema_tells_all_about_a_quantity() -> None:
    schema = Wheel.model_json_schema(by_alias=True)
    diameter, friction = schema["properties"]["diameter_mm"], schema["properties"]["friction"]
    assert schema["required"] == ["diameter_mm"]
    assert (diameter["x-unit"], diameter["x-symbol"], diameter["description"]) == ("mm", "D", "wheel diameter")
    assert diameter["anyOf"][0] == {"type": "number", "exclusiveMinimum": 0.0, "maximum": 5000.0}
    assert diameter["anyOf"][1] == {"type": "string", "minLength": 1, "maxLength": 60}
    assert friction["x-source"] == "SEW 2001, 17.1"
    assert friction["default"] == 0.003
    assert {"type": "null"} in schema["properties"]["speed_rpm"]["anyOf"]
    assert schema["properties"]["bearing"]["x-labels"] == {"ball": "Ball bearing"}
    assert (schema["properties"]["count"]["minimum"], schema["properties"]["count"]["maximum"]) == (1, 8)
    assert schema["additionalProperties"] is False


@pytest.mark.parametrize("count", [0, 9, 2.5, "many"])
def test_a_count_out_of_range_is_refused(count: object) -> None:
    assert set(reason({"diameter_mm": 1, "count": count})) == {"count"}


def test_an_annotation_that_is_only_text_is_refused() -> None:
    with pytest.raises(TypeError, match="evaluated annotations"):
        type("Late", (Declared,), {"__annotations__": {"a": "float"}, "__module__": __name__})
