"""What a reader is told about an input that cannot be used, and where."""

from typing import Annotated, Literal

import pytest
from pydantic import Field

from app.engine.errors import MotionError
from app.engine.quantity import Declared, Option, Quantity
from app.services.errors import InvalidInputError, MalformedInputError
from app.services.reading import MAX_ERRORS, engine_refusal, parse_json, read


class Disc(Declared):
    kind: Literal["disc"] = "disc"
    diameter: Annotated[float, Quantity("mm", gt=0, le=5, about="diameter of the disc")]
    discs: Annotated[int, Option(default=1, ge=1, le=9, about="number of discs")]


class Box(Declared):
    kind: Literal["box"] = "box"
    length: Annotated[float, Quantity("mm", gt=0, about="length")]
    guided: Annotated[bool, Option(default=False, about="guided")]


class Load(Declared):
    body: Annotated[Disc | Box, Field(discriminator="kind")]
    bodies: tuple[Annotated[Disc | Box, Field(discriminator="kind")], ...] = ()
    model: Annotated[Literal["fine", "coarse"], Option(default="fine", about="model")]


HOW = "give a number in mm, or a number with its unit"


def disc(diameter: object, **more: object) -> dict[str, object]:
    return {"body": {"kind": "disc", "diameter_mm": diameter, **more}}


GOOD = {"kind": "disc", "diameter_mm": 250}


def refused(raw: object) -> list[tuple[str, str]]:
    with pytest.raises(InvalidInputError) as caught:
        read(Load, raw)
    return [(error.name, error.message) for error in caught.value.errors]


@pytest.mark.parametrize(
    ("raw", "expected"),
    [
        ({"body": {"kind": "disc"}}, ("body.diameter_mm", "is missing: give diameter of the disc in mm")),
        (disc(0), ("body.diameter_mm", "must be greater than 0 mm")),
        (disc(True), ("body.diameter_mm", f"is not a number; {HOW}")),
        (disc("2 kg"), ("body.diameter_mm", f"'kg' does not measure the same thing as 'mm'; {HOW}")),
        (disc(3, diametre_mm=2), ("body.diametre_mm", "is not known here; did you mean diameter_mm?")),
        ({"body": {"kind": "ball"}}, ("body.kind", "is none of 'disc', 'box'")),
        ({"body": {"diameter_mm": 3}}, ("body.kind", "is missing: say which kind")),
        ({"body": [1]}, ("body", "must be an object with named values")),
        ({"body": GOOD, "model": "rough"}, ("model", "must be 'fine' or 'coarse'")),
        ({"body": GOOD, "bodies": {}}, ("bodies", "must be a list")),
        ({"body": GOOD, "bodies": [GOOD, {"kind": "box"}]}, ("bodies.1.length_mm", "is missing: give length in mm")),
        ({"body": {"kind": "box", "length_mm": 1, "guided": "maybe"}}, ("body.guided", "must be true or false")),
        ({"body": {**GOOD, "discs": 1.5}}, ("body.discs", "must be a whole number")),
        ({"body": {**GOOD, "discs": 10}}, ("body.discs", "must be less than or equal to 9")),
        ({}, ("body", "is missing")),
        ([], ("", "must be an object with named values")),
        (None, ("", "must be an object with named values")),
    ],
)  # fmt: skip
def test_each_mistake_is_told_at_its_place(raw: object, expected: tuple[str, str]):
    assert refused(raw) == [expected]


def test_what_was_typed_stays_with_the_error():
    with pytest.raises(InvalidInputError) as caught:
        read(Load, {"body": {"kind": "disc", "diameter_mm": " 1,5x "}})
    (error,) = caught.value.errors
    assert error.value == " 1,5x "
    assert error.pointer == "/body/diameter_mm"


def test_all_mistakes_are_told_at_once():
    raw = {"body": {"kind": "disc", "diameter_mm": -1, "discs": "x"}, "model": 1}
    assert [name for name, _ in refused(raw)] == ["body.diameter_mm", "body.discs", "model"]


def test_endless_mistakes_are_cut_off():
    assert len(refused({"body": GOOD, "bodies": [{"kind": "disc"}] * 1000})) == MAX_ERRORS


def test_a_pointer_escapes_what_json_pointers_escape():
    with pytest.raises(InvalidInputError) as caught:
        read(Load, {"body": GOOD, "a/b~c": 1})
    assert caught.value.errors[0].pointer == "/a~1b~0c"


def test_errors_of_a_part_are_told_with_the_path_of_the_whole():
    with pytest.raises(InvalidInputError) as caught:
        read(Load, {})
    assert caught.value.within("axes", 2, "request").errors[0].name == "axes.2.request.body"


def test_what_the_engine_refuses_keeps_its_place_and_value():
    error = MotionError("0.5 m/s2 for 4 s covers at most 2 m", field=("moves", 0, "distance_mm")).at("motion")
    found = engine_refusal(error, {"motion": {"moves": [{"distance_mm": "3 m"}]}}).errors
    assert [(e.name, e.message, e.value) for e in found] == [
        ("motion.moves.0.distance_mm", "0.5 m/s2 for 4 s covers at most 2 m", "3 m")
    ]


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        (b"{", "EOF while parsing an object"),
        (b"", "EOF while parsing a value"),
        (b'{"a": NaN}', "expected value"),
        (b'{"a": -Infinity}', "invalid number"),
        (b'{"a": 1, "a": 2}', "'a' is given twice in one object"),
        (b'{"a": "\\u0000"}', "a text holds a NUL character"),
        (b'{"a": "\\ud800"}', "hex escape"),
        (b'[["\\u0000"]]', "a text holds a NUL character"),
        (b'"\xff"', "invalid unicode"),
        (b"[" * 100_000, "recursion limit"),
        (b"9" * 5000, "number out of range"),
    ],
)
def test_what_is_no_json_is_refused_with_the_reason(data: bytes, reason: str):
    with pytest.raises(MalformedInputError) as caught:
        parse_json(data)
    assert reason in caught.value.message


def test_a_backslash_before_zeros_is_no_nul():
    assert parse_json(b'"\\\\u0000"') == "\\u0000"


def test_a_number_beyond_floats_is_refused_at_its_field_not_as_json():
    raw = parse_json(b'{"body": {"kind": "disc", "diameter_mm": 1e400}}')
    assert refused(raw) == [
        ("body.diameter_mm", "is not a finite number; give a number in mm, or a number with its unit")
    ]
