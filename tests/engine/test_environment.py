"""Surroundings: what goes beyond the ratings is said, never guessed."""

from typing import Any

import pytest

from app.engine.environment import Environment
from app.engine.sheet import Sheet, Verdict


@pytest.mark.parametrize(
    ("values", "keys"),
    [
        ({}, []),
        ({"ambient_temperature_degc": 40, "altitude_m": 1000}, []),
        ({"ambient_temperature_degc": 55}, ["ambient_temperature"]),
        ({"ambient_temperature_degc": 40.1, "altitude_m": 2500}, ["ambient_temperature", "altitude"]),
    ],
)
def test_what_ratings_do_not_cover_is_not_checked(values: dict[str, Any], keys: list[str]):
    sheet = Sheet()
    Environment.model_validate(values).check(sheet)
    assert [check.key for check in sheet.checks] == keys
    assert {check.verdict for check in sheet.checks} <= {Verdict.NOT_CHECKED}
    assert all("derating" in check.missing for check in sheet.checks)
