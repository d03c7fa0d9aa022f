"""Loads, motors and gear units for the tests of the servo check and of the selection."""

import numpy as np
from hypothesis import strategies as st

from app.engine.cycle import LoadCycle
from app.engine.mechanisms.load import Load, Statics
from app.engine.products import ServoGearUnit, ServoMotor

RPM = np.pi / 30


def cycle(*segments: tuple[float, float, float, float, bool], inertia: float = 0.0) -> LoadCycle:
    """Segments as (duration, start speed, end speed, torque, braked)."""
    duration, start, end, torque, braked = zip(*segments, strict=True)
    return LoadCycle(
        duration=np.array(duration, dtype=float),
        speed_start=np.array(start, dtype=float),
        speed_end=np.array(end, dtype=float),
        torque=np.array(torque, dtype=float),
        braked=np.array(braked, dtype=bool),
        label=tuple(f"segment {number}" for number in range(len(segments))),
        inertia=inertia,
    )


def load(of: LoadCycle, opposite: LoadCycle | None = None, **statics: float) -> Load:
    """A load with this cycle; statics that are not named are zero, speeds those of the cycle."""
    names = ("friction", "forward", "backward", "holding", "working")
    values = dict.fromkeys(names, 0.0) | {"rapid_speed": of.max_speed, "working_speed": of.max_speed} | statics
    return Load(cycle=of, statics=Statics(**values), opposite=opposite)


def motor(**values: object) -> ServoMotor:
    """A motor: 10 N m at standstill, 8 N m at 300 rad/s, 30 N m peak, 0.002 kg m2, unless said otherwise."""
    common: dict[str, object] = {
        "stall_torque": 10.0, "rated_torque": 8.0, "rated_speed": 300.0, "max_speed": 400.0, "peak_torque": 30.0,
        "rotor_inertia": 0.002, "mass": 9.0,
    }  # fmt: skip
    return ServoMotor(id="m", manufacturer="Maker", series="S", model="M", source="test", **(common | values))


def gear(**values: object) -> ServoGearUnit:
    """A gear unit: ratio 5, efficiency 0.8, no inertia, unless said otherwise."""
    common: dict[str, object] = {
        "ratio": 5.0, "efficiency": 0.8, "inertia": 0.0, "nominal_torque": 50.0, "acceleration_torque": 80.0,
        "emergency_torque": 160.0, "nominal_input_speed": 300.0, "max_input_speed": 600.0, "mass": 3.0,
    }  # fmt: skip
    return ServoGearUnit(id="g", manufacturer="Maker", series="G", model="G", source="test", **(common | values))


@st.composite
def cycles(draw: st.DrawFn, largest: int = 8) -> LoadCycle:
    """Cycles of speeds of either sign and standstills, torques of either sign, some segments braked."""
    number = st.floats(-50, 50).map(lambda value: round(value, 3))
    found = []
    for _ in range(draw(st.integers(1, largest))):
        duration = round(draw(st.floats(0.01, 3)), 3)
        torque = draw(number)
        kind = draw(st.sampled_from(["moves", "holds", "braked"]))
        if kind == "moves":
            sign = draw(st.sampled_from([-1.0, 1.0]))
            start, end = (sign * round(draw(st.floats(0, 40)), 3) for _ in range(2))
            found.append((duration, start, end, torque, False))
        else:
            found.append((duration, 0.0, 0.0, 0.0 if kind == "braked" else torque, kind == "braked"))
    return cycle(*found, inertia=round(draw(st.floats(0.001, 2)), 4))
