"""Flying saw: the cycle closes, the saw runs with its mark, and what cannot be done is said."""

from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from app.engine.errors import MotionError
from app.engine.formulas import flying_saw as formulas
from app.engine.motion.flying_saw import FlyingSaw
from app.engine.motion.profile import MotionProfile
from app.engine.sheet import Sheet

SAW = {"feed_speed_m_s": 0.2, "cut_length_mm": 1000, "cutting_time_s": 1, "stroke_mm": 800, "acceleration_m_s2": 1,
       "return_time_s": 2}  # fmt: skip
"""SEW 2001, 8.4, with a stroke of 0.8 m."""


def solved(**other: Any) -> tuple[MotionProfile, Sheet]:
    sheet = Sheet()
    values = {name: value for name, value in (SAW | other).items() if value is not None}
    return FlyingSaw.model_validate(values).solve(sheet), sheet


def position_at(motion: MotionProfile, label: str) -> tuple[float, float]:
    """(time, position) at the start of the first segment of that label."""
    k = motion.label.index(label)
    return float(motion.duration[:k].sum()), float(motion.position[k])


def test_the_saw_of_the_handbook_with_its_stop():
    """By hand: stop 0.2 s, 20 mm; return of 820 mm in 2 s at (2 - sqrt(4 - 3.28)) / 2 = 0.575736 m/s; mark at
    0.2 * 2.2 + 0.8 - 1 = 0.24 m."""
    motion, sheet = solved()
    assert sheet.value("stop_distance") == pytest.approx(0.02)
    assert sheet.value("return_speed") == pytest.approx(0.57573593)
    assert sheet.value("mark_ahead") == pytest.approx(0.24)
    assert motion.cycle_time == pytest.approx(5.0)
    assert motion.position[-1] == pytest.approx(0.0, abs=1e-12)


def test_the_handbook_neglects_the_stop():
    """Return in 2 s from standstill to standstill over 0.8 m; then 1.176 s to catch up, 1.824 s with the material."""
    v = 0.5527864045
    ahead = formulas.mark_ahead(0.2, 2.0, 0.8, 1.0)
    time = formulas.catch_up_time(v, 0.2, 1.0, ahead, formulas.catch_up_gain(v, 0.2, 1.0))
    assert time == pytest.approx(1.176393202)
    assert 2 + time + formulas.synchronous_time(
        0.8, formulas.synchronous_start(ahead, 0.2, time), 0.2
    ) == pytest.approx(5)


@settings(max_examples=100, deadline=None, suppress_health_check=[HealthCheck.filter_too_much])
@given(
    feed=st.floats(0.05, 2), length=st.floats(0.3, 6), cut=st.floats(0.05, 2), stroke=st.floats(0.1, 4),
    rate=st.floats(0.3, 10), back=st.floats(0.2, 3),
)  # fmt: skip
def test_the_saw_stays_on_its_mark_and_the_cycle_closes(
    feed: float, length: float, cut: float, stroke: float, rate: float, back: float
):
    try:
        motion, _ = solved(
            feed_speed_m_s=feed, cut_length_mm=1000 * length, cutting_time_s=cut, stroke_mm=1000 * stroke,
            acceleration_m_s2=rate, return_time_s=None, return_speed_m_s=back,
        )  # fmt: skip
    except MotionError:
        assume(False)
    assert motion.cycle_time == pytest.approx(length / feed)
    assert motion.position[-1] == pytest.approx(0.0, abs=1e-9)
    assert float(motion.position.max()) == pytest.approx(stroke + feed**2 / (2 * rate))
    # the mark of this cut passed the end of the stroke one length after the mark before it
    time, position = position_at(motion, "cutting")
    end_time, _ = position_at(motion, "stopping")
    assert position == pytest.approx(stroke - feed * (end_time - time))
    assert np.all(np.abs(motion.speed_end[:-1] - motion.speed_start[1:]) < 1e-9)


def test_without_a_stroke_it_is_as_short_as_the_cut_allows():
    """Ramp and stop of 20 mm each, 0.2 m of cut; it waits 5 - 0.2 - 0.2 - 1 - return."""
    motion, sheet = solved(stroke_mm=None)
    assert float(motion.position.max()) == pytest.approx(0.24)
    assert sheet.value("waiting_time") == pytest.approx(5 - 0.4 - 1 - 2)
    assert motion.label[0] == "waiting for the mark, motor holds"


def test_a_cut_that_pushes_acts_while_it_cuts_only():
    motion, _ = solved(process_force_n=300, payload_kg=5)
    assert [float(f) for f, what in zip(motion.process_force, motion.label, strict=True) if what == "cutting"] == [300]
    assert float((motion.process_force * motion.duration).sum()) == pytest.approx(300)
    assert set(motion.payload) == {5.0}


@pytest.mark.parametrize(
    ("change", "field", "words"),
    [
        ({"cutting_time_s": 3}, "cutting_time_s", "the cut takes longer"),
        ({"return_time_s": 0.5}, "return_time_s", "at least 1.811 s"),
        ({"return_speed_m_s": 1}, "return_time_s", "either the time or the speed"),
        ({"catch_up_speed_m_s": 0.1}, "catch_up_speed_m_s", "must be faster than the material"),
        ({"stroke_mm": None, "return_time_s": 4.5}, "stroke_mm", "give the stroke"),
        (
            {"stroke_mm": 250, "return_time_s": 4, "catch_up_speed_m_s": 0.5},
            "stroke_mm",
            "behind the end of the stroke",
        ),
    ],
)
def test_what_cannot_be_done_is_said_at_its_field(change: dict[str, Any], field: str, words: str):
    with pytest.raises(MotionError, match=words) as caught:
        solved(**change)
    assert caught.value.field == field
