"""Gear unit of a servo drive: a heavy motor needs a support of its own."""

import pytest

from app.engine.drives.rules import ServoRules
from app.engine.gear import check_gear_unit
from app.engine.sheet import Sheet
from tests.engine.drives.cases import cycle, gear, load, motor


@pytest.mark.parametrize(
    ("stages", "mass", "supported"),
    [(1, 12.0, False), (1, 12.1, True), (2, 7.5, False), (2, 7.6, True), (None, 50.0, False), (1, None, False)],
)
def test_a_heavy_motor_needs_a_support(stages: int | None, mass: float | None, supported: bool):
    """SEW 2001, 6.3: more than 4 times the mass of a single-stage unit of 3 kg, 2.5 times that of a two-stage one."""
    sheet = Sheet()
    demand = load(cycle((1, 0, 10, 5, False), (1, 10, 0, -5, False)))
    check_gear_unit(demand, gear(stages=stages), motor(mass=mass), ServoRules.model_validate({}), False, sheet)
    assert ("The motor needs a support of its own" in [one.text for one in sheet.decisions]) == supported
