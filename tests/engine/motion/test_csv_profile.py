"""Profiles read from a table: met exactly, without invented acceleration, and refused with line and column."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.engine.errors import MotionError
from app.engine.motion import CsvProfile, LinearMove, MotionProfile, Moves
from app.engine.sheet import Sheet


def solve(text: str, **values: object) -> MotionProfile:
    return CsvProfile.model_validate({"text": text, **values}).solve(Sheet())


def refused(text: str) -> str:
    with pytest.raises(MotionError) as caught:
        solve(text)
    assert caught.value.field == "text"
    return caught.value.message


def table(header: str, *columns: object) -> str:
    rows = zip(*(np.asarray(column, dtype=float).tolist() for column in columns), strict=True)
    return "\n".join([header, *(";".join(repr(value) for value in row) for row in rows)])


def at(found: MotionProfile, times: object) -> object:
    """Position of a profile at any time: exact inside segments of constant acceleration."""
    border = np.concatenate(([0.0], np.cumsum(found.duration)))
    k = np.clip(np.searchsorted(border, times, side="right") - 1, 0, len(found.duration) - 1)
    t = times - border[k]
    return found.position[k] + found.speed_start[k] * t + found.acceleration[k] * t**2 / 2


def test_speeds_run_straight_between_the_rows():
    found = solve("time [ms];speed [m/min]\n0;0\n500;30\n1500;30\n2000;0\n2500;0", hold="brake")
    assert found.duration == pytest.approx([0.5, 1.0, 0.5, 0.5])
    assert found.speed_end == pytest.approx([0.5, 0.5, 0.0, 0.0])
    assert found.label == (
        "forward: accelerating", "forward: constant speed", "forward: decelerating", "standstill, brake holds",
    )  # fmt: skip
    assert found.braked.tolist() == [False, False, False, True]


def test_decimal_commas_blank_lines_and_further_columns():
    found = solve(
        "\ufeffTime [s]; Position [mm] ;payload [kg];force [kN]\n0;0;20;0\n\n1,0;10;20;0,5\n2.0;20;5;0\n3;30;5;0;\n"
    )
    assert found.position[-1] == pytest.approx(0.03)
    assert found.payload.tolist() == [20, 20, 20, 20, 5, 5]
    assert found.process_force.tolist() == [0, 0, 500, 500, 0, 0]


def test_the_unit_makes_it_rotary():
    found = solve("time [s];position [rev];inertia [kg cm2];torque [N m]\n0;0;1;2\n1;1;1;2\n2;2;1;2")
    assert found.kind == "rotary"
    assert found.position[-1] == pytest.approx(4 * np.pi)
    assert (found.payload[0], found.process_force[0]) == pytest.approx((1e-4, 2.0))
    assert solve("time [s];speed [rpm]\n0;0\n1;60\n2;0").max_speed == pytest.approx(2 * np.pi)


def test_a_sampled_trapezoid_is_found_again():
    # 1 m with 0.5 m/s and 1 m/s2, sampled every 0.1 s, standing for 0.5 s before and after: corners fall on samples
    move = Moves.si(moves=[LinearMove.si(distance=1.0, speed=0.5, acceleration=1.0)]).solve(Sheet())
    times = np.arange(36) * 0.1
    positions = np.where(times < 0.5, 0.0, np.where(times > 3.0, 1.0, at(move, np.clip(times - 0.5, 0.0, 2.5))))
    found = solve(table("time [s];position [m]", times, positions))
    assert np.abs(found.acceleration).max() == pytest.approx(1.0, rel=1e-9)
    assert found.max_speed == pytest.approx(0.5, rel=1e-9)
    effective = (found.acceleration**2 * found.duration).sum()
    assert effective == pytest.approx(1.0, rel=1e-9)  # 1 m/s2 for twice 0.5 s
    assert (found.mean_speed != 0)[found.duration.cumsum() < 0.45].sum() == 0


def test_a_sine_is_met_ever_better():
    # s = sin(t): acceleration 1 at most
    errors = []
    for count in (40, 80):
        times = np.linspace(0.0, 2 * np.pi, count)
        found = solve(table("time [s];position [m]", times, np.sin(times)))
        errors.append(abs(np.abs(found.acceleration).max() - 1.0))
    assert errors[1] < errors[0] < 0.15


def test_a_reversal_is_a_border_of_segments():
    found = solve("time [s];speed [m/s]\n0;1\n1;-1\n2;1")
    assert found.duration == pytest.approx([0.5, 0.5, 0.5, 0.5])
    assert found.direction.tolist() == [1, -1, -1, 1]


rows = st.lists(st.tuples(st.floats(0.01, 2.0), st.floats(-1.0, 1.0)), min_size=2, max_size=30)


@given(rows)
@settings(max_examples=50, deadline=None)
def test_every_position_is_met(steps: list[tuple[float, float]]):
    times = np.concatenate(([0.0], np.cumsum([step for step, _ in steps])))
    positions = np.array([0.0, *(place for _, place in steps)])
    if not np.diff(positions).any():
        positions = positions + np.arange(len(positions))
    found = solve(table("time [s];position [m]", times, positions))
    assert at(found, times) - positions[0] == pytest.approx(positions - positions[0], abs=1e-7)
    assert found.cycle_time == pytest.approx(times[-1])
    assert (found.speed_start * found.speed_end >= 0).all()
    assert (found.speed_start[1:] == found.speed_end[:-1]).all()
    assert (found.duration > 0).all()


HEAD = "time [s];position [mm]\n"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "the table is empty: give a header such as time [s];position [mm], and rows"),
        (HEAD + "0;0\n1;1", "the table has 2 rows; 3 to 20000 are needed"),
        (HEAD + "0;0\n1;abc\n2;3", "line 3, column 2 (position): 'abc' is not a number"),
        (HEAD + "0;0\n1;nan\n2;3", "line 3, column 2 (position): 'nan' is not a plausible number"),
        (HEAD + "0;0\n1;1e400\n2;3", "line 3, column 2 (position): '1e400' is not a plausible number"),
        (HEAD + "0;0\n1\n2;3", "line 3: 1 columns instead of 2"),
        (HEAD + "0;0\n1;2;3\n2;3", "line 3: 3 columns instead of 2"),
        (HEAD + "0;0\n1;1\n\n1;2\n0.5;3", "line 5: the time does not increase; line 6: the time does not increase"),
        (HEAD + "0;5\n1;5\n2;5", "the axis never moves"),
        ("time;position [mm]\n", "line 1, column 1: time needs a unit, such as time [s]"),
        ("time [mm];position [mm]\n", "line 1, column 1: 'mm' is no unit of time; give for instance s"),
        ("time [s];position [kg]\n", "line 1, column 2: 'kg' is no unit of position; give for instance m or deg"),
        ("time [s];place [mm]\n", "line 1, column 2: 'place' is none of the columns time, position, speed, payload, "
                                  "force, inertia, torque"),
        ("time [s];force [N]\n", "line 1: there must be either a column position or a column speed"),
        ("time [s];position [m];speed [m/s]\n", "line 1: there must be either a column position or a column speed"),
        ("position [mm];force [N]\n", "line 1: there is no column time [s]"),
        ("time [s];position [mm];torque [N m]\n", "line 1: linear and rotary columns are mixed"),
        ("time [s];time [s];position [mm]\n", "line 1: the column time stands twice"),
        ("time [s];position [mm];payload [kg]\n0;0;1\n1;1;-2\n2;2;1", "line 3, column 3 (payload): '-2' is negative"),
    ],
)  # fmt: skip
def test_a_wrong_table_is_refused_with_its_place(text: str, message: str):
    assert refused(text) == message


def test_only_the_first_errors_are_listed():
    message = refused(HEAD + "\n".join("x;1" for _ in range(20)))
    assert message.count("is not a number") == 5
    assert message.endswith("; and 15 more")


def test_too_many_rows_are_refused():
    assert refused(HEAD + "\n".join(f"{k};0" for k in range(20_001))).startswith("the table has 20001 rows")
