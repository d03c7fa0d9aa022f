"""Inertia of bodies against integration and against one another."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.engine.formulas.inertia import (
    cuboid_inertia,
    cylinder_mass,
    hollow_cylinder_inertia,
    linear_mass_inertia,
    parallel_axis_inertia,
    point_mass_inertia,
    referred_inertia,
    solid_cylinder_inertia,
)


@settings(max_examples=30, deadline=None)
@given(D=st.floats(0.02, 2.0), share=st.floats(0.0, 0.99), rho=st.floats(1000, 20000))
def test_a_hollow_cylinder_is_one_solid_less_another(D: float, share: float, rho: float):
    bore = D * share
    outer, inner = cylinder_mass(D, 0.3, rho), cylinder_mass(bore, 0.3, rho)
    difference = solid_cylinder_inertia(outer, D) - solid_cylinder_inertia(inner, bore)
    assert hollow_cylinder_inertia(outer - inner, D, bore) == pytest.approx(difference, rel=1e-9)


def test_a_cuboid_equals_the_sum_of_its_grains():
    m, b, l = 12.0, 0.3, 0.4
    grid = 400
    x = (np.arange(grid) + 0.5) / grid - 0.5
    grains = (x[:, None] * b) ** 2 + (x[None, :] * l) ** 2
    assert cuboid_inertia(m, b, l) == pytest.approx(m * grains.mean(), rel=1e-4)


def test_two_halves_moved_apart_by_steiner_make_the_whole():
    # a bar 0.1 x 0.8 cut in the middle: each half 0.1 x 0.4, its centre 0.2 from the axis
    half = parallel_axis_inertia(cuboid_inertia(3.0, 0.1, 0.4), 3.0, 0.2)
    assert 2 * half == pytest.approx(cuboid_inertia(6.0, 0.1, 0.8))


@settings(max_examples=30, deadline=None)
@given(m=st.floats(0.1, 1e4), A=st.floats(1e-4, 1.0), i=st.floats(0.5, 200), omega=st.floats(0.1, 500))
def test_referred_inertia_holds_the_same_kinetic_energy(m: float, A: float, i: float, omega: float):
    energy = m * (A * omega) ** 2 / 2
    assert linear_mass_inertia(m, A) * omega**2 / 2 == pytest.approx(energy)
    fast = i * omega
    assert referred_inertia(linear_mass_inertia(m, A), i) * fast**2 / 2 == pytest.approx(energy)


def test_a_thin_ring_is_a_mass_at_one_radius():
    assert hollow_cylinder_inertia(2.0, 0.6, 0.6) == pytest.approx(point_mass_inertia(2.0, 0.3))
