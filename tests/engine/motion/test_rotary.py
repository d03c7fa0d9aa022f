"""Formulas of straight motion under the symbols of rotation."""

import ast

import pytest

from app.engine.formula import registered
from app.engine.formulas import motion
from app.engine.motion.rotary import SYMBOLS, UNITS, rotary

FORMULAS = [formula for formula in registered().values() if formula.topic == "motion"]


def test_the_library_has_formulas_of_motion():
    assert len(FORMULAS) > 20


@pytest.mark.parametrize("linear", FORMULAS, ids=lambda formula: formula.name)
def test_the_rotary_reading_computes_the_same(linear):
    turned = rotary(linear)
    numbers = {name: 0.3 + 0.1 * index for index, name in enumerate(linear.parameters)}
    assert turned(**{SYMBOLS.get(name, name): value for name, value in numbers.items()}) == linear(**numbers)
    assert not set(turned.parameters.values()) & set(UNITS)
    assert turned.si_unit not in UNITS
    names = {node.id for node in ast.walk(turned.body.result) if isinstance(node, ast.Name)}
    assert not names & set(SYMBOLS)


def test_the_original_keeps_its_symbols():
    rotary(motion.least_speed)
    names = {node.id for node in ast.walk(motion.least_speed.body.result) if isinstance(node, ast.Name)}
    assert {"s", "t"} <= names
    assert rotary(motion.least_speed).body.intermediates.keys() == {"kappa"}
