"""Screw formulas against figures that makers of ball screws print."""

import math

import pytest

from app.engine.formulas.screw import (
    buckling_force,
    critical_screw_speed,
    lead_angle,
    permissible_axial_force,
    permissible_screw_speed,
    thread_efficiency,
)
from app.engine.mechanisms.screw_shaft import MOUNTINGS

E_MAKER, RHO_STEEL = 2.06e11, 7850.0

# Printed by THK (selection of ball screws): n [1/min] = factor * d_r [mm] / l [mm]^2 * 1e7, with 0.8 contained
THK_SPEED = {"fixed_free": 3.4, "supported_supported": 9.7, "fixed_supported": 15.1, "fixed_fixed": 21.9}
# Printed by THK: F [N] = factor * d_r [mm]^4 / l [mm]^2 * 1e4, with 0.5 contained; 1.3 is rounded from 1.25
THK_BUCKLING = {"fixed_free": 1.25, "fixed_supported": 10.0, "fixed_fixed": 20.0}


@pytest.mark.parametrize(("mounting", "factor"), THK_SPEED.items())
def test_permissible_speed_as_makers_print_it(mounting: str, factor: float):
    root, length = 0.0178, 1.2
    critical = critical_screw_speed(MOUNTINGS[mounting].eigenvalue, root, length, E_MAKER, RHO_STEEL)
    speed = permissible_screw_speed(0.8, critical) * 60 / (2 * math.pi)
    assert speed == pytest.approx(factor * 17.8 / 1200**2 * 1e7, rel=0.015)  # factors are printed with two digits


@pytest.mark.parametrize(("mounting", "factor"), THK_BUCKLING.items())
def test_permissible_compression_as_makers_print_it(mounting: str, factor: float):
    force = permissible_axial_force(buckling_force(MOUNTINGS[mounting].buckling, E_MAKER, 0.0178, 1.2), 2.0)
    assert force == pytest.approx(factor * 17.8**4 / 1200**2 * 1e4, rel=0.005)


def test_worked_example_of_a_maker_for_buckling():
    # MISUMI, selection of ball screws: d_r 12.5 mm, 820 mm, fixed-supported: 3630 N with the factor rounded to 10
    force = permissible_axial_force(buckling_force(2.0, E_MAKER, 0.0125, 0.820), 2.0)
    assert force == pytest.approx(3630, rel=0.005)


def test_a_thread_without_friction_loses_nothing_and_a_self_locking_one_more_than_half():
    phi = lead_angle(0.005, 0.03)
    assert thread_efficiency(phi, 0.0) == pytest.approx(1.0)
    assert thread_efficiency(phi, math.tan(phi)) < 0.5
