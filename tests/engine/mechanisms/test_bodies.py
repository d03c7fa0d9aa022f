"""Bodies that turn, and what stands between any mechanism and its drive."""

from typing import Any

import pytest
from pydantic import TypeAdapter

from app.engine.environment import Environment
from app.engine.mechanisms.ball_screw import BallScrew
from app.engine.mechanisms.bodies import AnyBody
from app.engine.mechanisms.rotary_load import RotaryLoad
from app.engine.motion.constant import ConstantRotation
from app.engine.motion.moves import Moves
from app.engine.sheet import Sheet
from tests.engine.mechanisms.laws import loaded, written
from tests.sizing_requests import SCREW_AXIS

BODY: TypeAdapter[Any] = TypeAdapter(AnyBody)


def inertia(**values: Any) -> float:
    found: float = BODY.validate_python(values).record_inertia(Sheet(), "J", "body")
    return found


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ({"shape": "sphere", "mass_kg": 10, "diameter_mm": 200}, 0.04),  # 2/5 * 10 * 0.01
        ({"shape": "spherical_shell", "mass_kg": 10, "diameter_mm": 200}, 2 / 3 * 0.1),
        ({"shape": "rod", "mass_kg": 12, "length_mm": 1000}, 1.0),  # m l^2 / 12
        ({"shape": "rod", "mass_kg": 12, "length_mm": 1000, "offset_mm": 500}, 4.0),  # about its end: m l^2 / 3
        ({"shape": "upright_disc", "mass_kg": 16, "diameter_mm": 1000}, 1.0),
        ({"shape": "cylinder", "mass_kg": 8, "diameter_mm": 1000}, 1.0),
        ({"shape": "given", "inertia_kgm2": 3}, 3.0),
        ({"shape": "given", "inertia_kgm2": 3, "ratio": 2}, 0.75),  # geared down to half the speed
        ({"shape": "point", "mass_kg": 2, "radius_mm": 500, "ratio": 0.5}, 2.0),  # at twice the speed
    ],
)
def test_inertia_by_hand(body: dict[str, Any], expected: float):
    assert inertia(**body) == pytest.approx(expected)


def test_a_geared_body_does_not_rest_on_the_bearing_of_the_axis():
    table = {"bodies": [{"shape": "cylinder", "mass_kg": 100, "diameter_mm": 1000}], "bearing_diameter_mm": 500}
    geared = table | {"bodies": [*table["bodies"], {"shape": "point", "mass_kg": 50, "radius_mm": 10, "ratio": 3}]}
    motion = ConstantRotation.model_validate({"speed_rpm": 10}).solve(Sheet())
    frictions = [written(RotaryLoad.model_validate(one), motion).value("friction_torque") for one in (table, geared)]
    assert frictions[0] == frictions[1]


def screw(**other: Any) -> BallScrew:
    return BallScrew.model_validate({k: v for k, v in SCREW_AXIS["mechanism"].items() if k != "kind"} | other)


def moves() -> Any:
    return Moves.model_validate({k: v for k, v in SCREW_AXIS["motion"].items() if k != "kind"}).solve(Sheet())


def test_further_bodies_add_their_inertia_to_any_mechanism():
    """A body on the drive's output shaft is accelerated before all losses."""
    bare = loaded(screw(), moves()).cycle
    with_disc = loaded(screw(further_bodies=[{"shape": "given", "inertia_kgm2": 0.002}]), moves()).cycle
    assert with_disc.inertia - bare.inertia == pytest.approx(0.002)
    assert with_disc.torque - bare.torque == pytest.approx(0.002 * bare.acceleration)


def test_a_stage_before_any_mechanism():
    bare, staged = loaded(screw(), moves()), loaded(screw(stage_ratio=2, stage_efficiency=0.9), moves())
    assert staged.cycle.speed_end == pytest.approx(2 * bare.cycle.speed_end)
    driving = bare.cycle.power_direction > 0
    assert staged.cycle.torque[driving] == pytest.approx(bare.cycle.torque[driving] / 2 / 0.9)
    returning = bare.cycle.power_direction < 0
    assert staged.cycle.torque[returning] == pytest.approx(bare.cycle.torque[returning] / 2 * 0.9)


def test_a_stage_without_efficiency_takes_the_usual_one_as_an_assumption():
    sheet = Sheet()
    screw(stage_ratio=2).load(moves(), Environment.si(), sheet)
    assert [one.value for one in sheet.assumptions if one.key == "mechanism.stage_efficiency"] == [0.9]
