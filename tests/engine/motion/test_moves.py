"""Sequences of moves and turns: what the form takes, the segments that come out, and what the sheet shows."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic import TypeAdapter, ValidationError

from app.engine.errors import MotionError
from app.engine.motion import LinearMove, Motion, MotionProfile, Moves, Turns, motions
from app.engine.sheet import Sheet

MOVE = {"distance_mm": 1000, "speed_m_s": 0.5, "acceleration_m_s2": 1}
"""By hand: 0.5 s up, 1.5 s at 0.5 m/s, 0.5 s down."""
BACK = {**MOVE, "distance_mm": -1000}


def solve(*moves: dict[str, object], **cycle: object) -> tuple[MotionProfile, Sheet]:
    sheet = Sheet()
    return Moves.model_validate({"moves": list(moves), **cycle}).solve(sheet), sheet


def refused(*moves: dict[str, object], **cycle: object) -> tuple[str, str]:
    with pytest.raises(MotionError) as caught:
        solve(*moves, **cycle)
    return caught.value.field, caught.value.message


def test_there_and_back_with_dwells():
    found, sheet = solve({**MOVE, "dwell_s": 1, "hold": "brake"}, {**BACK, "label": "return", "settling_time_s": 0.25})
    assert found.label == (
        "move 1: accelerating", "move 1: constant speed", "move 1: decelerating", "move 1: dwell, brake holds",
        "return: accelerating", "return: constant speed", "return: decelerating", "return: settling",
    )  # fmt: skip
    assert found.duration == pytest.approx([0.5, 1.5, 0.5, 1.0, 0.5, 1.5, 0.5, 0.25])
    assert found.speed_end == pytest.approx([0.5, 0.5, 0, 0, -0.5, -0.5, 0, 0])
    assert found.acceleration == pytest.approx([1, 0, -1, 0, -1, 0, 1, 0])
    assert found.direction.tolist() == [1, 1, 1, 1, -1, -1, -1, -1]
    assert found.braked.tolist() == [False, False, False, True, False, False, False, False]
    assert found.position[-1] == pytest.approx(0.0, abs=1e-12)
    assert sheet.value("cycle_time") == pytest.approx(6.25)
    assert sheet.value("move_2_time") == pytest.approx(2.75)
    assert not [decision for decision in sheet.decisions if "ends" in decision.text]


def test_settling_lies_within_the_given_time():
    found, sheet = solve(
        {"distance_mm": 1000, "time_s": 3, "settling_time_s": 0.5, "acceleration_m_s2": 1}
    )  # motion 2.5 s -> 0.5 m/s
    assert found.cycle_time == pytest.approx(3.0)
    assert sheet.value("move_1_speed") == pytest.approx(0.5)
    assert sheet.value("move_1_motion_time") == pytest.approx(2.5)
    assert sheet.value("move_1_time") == pytest.approx(3.0)


def test_payload_and_process_force_belong_to_their_move():
    found, _ = solve(
        {**MOVE, "payload_kg": 20, "process_force_n": 100, "dwell_s": 1},
        {**BACK, "process_force_n": -50, "process_during": "constant_speed"},
        {**MOVE, "process_force_n": 7, "process_during": "motion_and_standstill", "dwell_s": 1},
    )
    assert found.payload.tolist() == [20, 20, 20, 20, 0, 0, 0, 0, 0, 0, 0]
    assert found.process_force.tolist() == [100, 100, 100, 0, 0, -50, 0, 7, 7, 7, 7]


def test_backward_is_a_negative_distance():
    mirrored, _ = solve({"speed_m_s": 0.5, "time_s": 2.5, "acceleration_m_s2": 1, "backward": True})
    assert mirrored.position[-1] == pytest.approx(-1.0)
    assert solve({**MOVE, "backward": True})[0].position[-1] == pytest.approx(-1.0)
    assert solve({**BACK, "backward": True})[0].position[-1] == pytest.approx(-1.0)


def test_the_cycle_time_leaves_a_pause():
    found, sheet = solve(MOVE, BACK, cycle_time_s=8, pause_hold="brake")
    assert (found.label[-1], found.duration[-1], found.braked[-1]) == ("pause, brake holds", pytest.approx(3.0), True)
    assert sheet.value("cycle_time") == pytest.approx(8.0)
    assert solve(MOVE, pause_s=2)[0].cycle_time == pytest.approx(4.5)
    assert solve(MOVE, BACK, cycle_time_s=5)[0].cycle_time == pytest.approx(5.0)


def test_a_cycle_that_does_not_return_says_where_it_ends():
    _, sheet = solve(MOVE)
    assert sheet.decisions[-1].text == "The cycle ends 1 m from its start"


CYCLES = [
    ([MOVE, BACK], {"cycle_time_s": 4},
     ("cycle_time_s", "the moves and their dwells take 5 s, longer than the cycle of 4 s")),
    ([MOVE], {"cycle_time_s": 4, "pause_s": 1}, ("pause_s", "give either a pause or the time of the whole cycle")),
    ([MOVE, {"distance_mm": 3000, "time_s": 4, "acceleration_m_s2": 0.5}], {},
     ("moves.1.distance_mm", "0.5 m/s2 for 4 s covers at most 2 m, not 3 m")),
    ([{**MOVE, "distance_mm": 0}], {},
     ("moves.0.distance_mm", "a move of no distance is a dwell: give a distance, or a dwell to another move")),
    ([{**MOVE, "time_s": 1, "settling_time_s": 1}], {},
     ("moves.0.settling_time_s", "settling of 1 s leaves nothing of the 1 s for motion")),
    ([{**MOVE, "deceleration_m_s2": 1, "deceleration_ratio": 1}], {},
     ("moves.0.deceleration_ratio", "give either a deceleration or its ratio to the acceleration")),
    ([{**MOVE, "jerk_m_s3": 10}], {},
     ("moves.0.jerk_m_s3", "a trapezoid has no jerk limit: choose the S-curve, or leave this out")),
    ([{**MOVE, "profile": "s_curve"}], {},
     ("moves.0.jerk_m_s3", "an S-curve needs either a jerk or a share of the acceleration time")),
    ([{**MOVE, "profile": "s_curve", "jerk_m_s3": 10, "jerk_share_percent": 10}], {},
     ("moves.0.jerk_m_s3", "an S-curve needs either a jerk or a share of the acceleration time")),
    ([{"distance_mm": 1000, "time_s": 2}], {},
     ("moves.0.optimise", "distance and time do not determine the move: give a speed or an acceleration, or choose "
      "what shall be least: the acceleration or the effective acceleration")),
]  # fmt: skip


@pytest.mark.parametrize(("moves", "cycle", "expected"), CYCLES)
def test_a_cycle_that_cannot_be_is_refused_at_its_field(
    moves: list[dict[str, object]], cycle: dict[str, object], expected: tuple[str, str]
):
    assert refused(*moves, **cycle) == expected


@pytest.mark.parametrize(
    ("move", "field"),
    [
        ({**MOVE, "speed_m_s": -0.5}, "speed_m_s"),
        ({**MOVE, "speed_m_s": "fast"}, "speed_m_s"),
        ({**MOVE, "acceleration_m_s2": float("nan")}, "acceleration_m_s2"),
        ({**MOVE, "distance_mm": "5 kg"}, "distance_mm"),
        ({**MOVE, "payload_kg": -1}, "payload_kg"),
        ({**MOVE, "time_s": "1e400"}, "time_s"),
        ({**MOVE, "hold": "hope"}, "hold"),
        ({**MOVE, "label": "x" * 61}, "label"),
    ],
)
def test_a_wrong_entry_is_refused_at_the_border(move: dict[str, object], field: str):
    with pytest.raises(ValidationError) as caught:
        Moves.model_validate({"moves": [move]})
    assert [error["loc"] for error in caught.value.errors()] == [("moves", 0, field)]


@pytest.mark.parametrize("count", [0, 201])
def test_a_sequence_has_1_to_200_moves(count: int):
    with pytest.raises(ValidationError):
        Moves.model_validate({"moves": [MOVE] * count})


def test_of_many_moves_the_sheet_shows_the_extreme_ones():
    many = [MOVE] * 10
    many[3] = {**MOVE, "acceleration_m_s2": 4}
    many[6] = {"distance_mm": 5000, "speed_m_s": 2, "acceleration_m_s2": 1}
    found, sheet = solve(*many)
    assert {step.key.split("_")[1] for step in sheet.steps if step.key.startswith("move_")} == {"4", "7"}
    assert "2 of 10 moves are written out" in [decision.text for decision in sheet.decisions]
    assert len(found.phases) == 30


def test_turns_read_angles_and_turns():
    # 2 rev at 60 rpm = 1 rev/s with 2 pi rad/s2: 1 s up, 1 s down, each half a turn; 1 rev in 1 s
    sheet = Sheet()
    turn = {"distance_deg": "2 rev", "speed_rpm": 60, "acceleration_rad_s2": 2 * np.pi, "payload_inertia_kgm2": 0.5,
            "process_torque_nm": 3}  # fmt: skip
    found = Turns.model_validate({"moves": [turn]}).solve(sheet)
    assert found.kind == "rotary"
    assert found.duration == pytest.approx([1.0, 1.0, 1.0])
    assert found.position[-1] == pytest.approx(4 * np.pi)
    assert (found.payload[0], found.process_force[0]) == (0.5, 3.0)
    step = next(step for step in sheet.steps if step.key == "move_1_acceleration_distance")
    assert (step.symbol, step.unit, step.shown_value) == ("phi_A", "deg", pytest.approx(180.0))


def test_what_was_not_given_is_said():
    sheet = Sheet()
    motion = Moves.model_validate({"moves": [{**MOVE, "dwell_s": 1}, BACK]})
    motion.solve(sheet)
    sheet.assume_defaults(motion, "motion.")
    assert sorted(item.key for item in sheet.assumptions) == [
        "motion.deceleration", "motion.moves.0.hold", "motion.moves.0.profile", "motion.moves.1.profile",
    ]  # fmt: skip


def test_the_kind_tells_the_motions_apart():
    adapter: TypeAdapter[Motion] = TypeAdapter(Motion)
    assert isinstance(adapter.validate_python({"kind": "moves", "moves": [MOVE]}), Moves)
    straight = ["moves", "constant", "trips", "flying_saw", "csv"]
    assert set(motions()) == {*straight, "turns", "constant_rotation", "rotations"}
    assert list(motions("linear")) == straight
    with pytest.raises(ValidationError):
        adapter.validate_python({"kind": "jump"})


def test_the_border_gives_back_what_it_took():
    given_move = {**MOVE, "label": "out", "jerk_share_percent": 50.0, "profile": "s_curve"}
    assert LinearMove.model_validate(given_move).model_dump(by_alias=True, exclude_unset=True) == given_move


moves = st.fixed_dictionaries(
    {
        "distance_mm": st.floats(1, 1e4) | st.floats(-1e4, -1),
        "speed_m_s": st.floats(0.01, 10),
        "acceleration_m_s2": st.floats(0.1, 50),
    },
    optional={
        "dwell_s": st.floats(0, 10),
        "settling_time_s": st.floats(0, 1),
        "deceleration_ratio": st.floats(0.1, 10),
        "hold": st.sampled_from(["motor", "brake"]),
    },
)


@given(st.lists(moves, min_size=1, max_size=8))
@settings(max_examples=50, deadline=None)
def test_a_profile_is_consistent(sequence: list[dict[str, object]]):
    found, sheet = solve(*sequence)
    distance = sum(float(str(move["distance_mm"])) for move in sequence) / 1000
    longest = max(abs(float(str(move["distance_mm"]))) for move in sequence) / 1000
    assert found.position[-1] == pytest.approx(distance, abs=1e-9 * longest * len(sequence))
    assert found.cycle_time == pytest.approx(sheet.value("cycle_time"), rel=1e-9)
    assert (found.duration > 0).all()
    assert (found.speed_start[1:] == found.speed_end[:-1]).all()
    assert found.speed_start[0] == found.speed_end[-1] == 0
    assert (found.speed_start * found.speed_end >= 0).all()
    moving = found.mean_speed != 0
    assert (np.sign(found.mean_speed[moving]) == found.direction[moving]).all()
    assert not found.braked[moving].any()
