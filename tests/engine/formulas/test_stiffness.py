"""Stiffness formulas against their definitions."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.engine.formulas.stiffness import (
    damping_coefficient,
    natural_frequency,
    series_stiffness,
    stiffness_held_at_both_ends,
    stiffness_held_at_one_end,
    torsion_stiffness_at_nut,
)

STIFFNESSES = st.lists(st.floats(1e6, 1e10), min_size=1, max_size=6)


def test_a_screw_held_at_both_ends_is_two_springs_side_by_side_with_the_nut_in_the_middle():
    E, S, length = 2.1e11, 1.9635e-3, 1.0
    half = stiffness_held_at_one_end(E, S, length / 2)
    assert stiffness_held_at_both_ends(E, S, length) == pytest.approx(2 * half)


def test_torsion_equals_the_work_of_twisting_the_shaft():
    # F on the nut twists the shaft by F k_s x / (G J_k); the nut gives way by k_s times that angle
    G, D, h, x, F = 8e10, 0.04, 0.01, 0.7, 1000.0
    k_s, J_k = h / (2 * math.pi), math.pi * D**4 / 32
    way = k_s * (F * k_s * x / (G * J_k))
    assert torsion_stiffness_at_nut(G, D, h, x) == pytest.approx(F / way)


@settings(max_examples=30, deadline=None)
@given(STIFFNESSES)
def test_springs_in_series_are_softer_than_the_softest(stiffness: list[float]):
    k = series_stiffness(stiffness)
    assert k <= min(stiffness) * (1 + 1e-12)
    assert k >= min(stiffness) / len(stiffness) * (1 - 1e-12)


def test_frequency_and_damping_belong_together():
    # b / (2 m omega_0) is the damping ratio by definition
    k, m, xi = 4.0e8, 400.0, 0.1
    omega_0 = 2 * math.pi * natural_frequency(k, m)
    assert damping_coefficient(xi, k, m) / (2 * m * omega_0) == pytest.approx(xi)
