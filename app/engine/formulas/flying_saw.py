"""Flying saw: a carriage that runs with the material while it cuts, returns, and catches up with the next mark."""

from app.engine.formula import formula, sqrt
from app.engine.units import Metre, MetrePerSecond, MetrePerSecond2, Second


@formula(symbol="x_m", unit="mm", source="derived: the next mark comes one cut length behind the last cut")
def mark_ahead(v_F: MetrePerSecond, t: Second, s: Metre, L: Metre) -> Metre:
    """Way by which the next mark is ahead of the saw when the saw is back at its start; negative: it has yet to come.

    ``v_F`` feed of the material, ``t`` time from the end of the cut until the saw is back, ``s`` way from the start to
    the end of the cut, ``L`` length that is cut off.

    >>> round(mark_ahead(0.2, 2.0, 0.8, 1.0), 9)
    0.2
    """
    return v_F * t + s - L


@formula(symbol="x_g", unit="mm", source="derived: ways of saw and material in the ramps 0 to v and v to v_F")
def catch_up_gain(v: MetrePerSecond, v_F: MetrePerSecond, a: MetrePerSecond2) -> Metre:
    """Way that the saw gains on the material while it starts and while it slows down to the feed.

    ``v`` highest speed of the saw while it catches up, ``v_F`` feed, ``a`` acceleration and deceleration.

    >>> round(catch_up_gain(0.5, 0.2, 1.0), 9)  # 0.125 - 0.1 + 0.045
    0.07
    """
    return v**2 / (2 * a) - v_F * v / a + (v - v_F) ** 2 / (2 * a)


@formula(symbol="v_g", unit="m/s", source="derived: the gain of the ramps alone equals the way to catch up")
def catch_up_speed(x_m: Metre, v_F: MetrePerSecond, a: MetrePerSecond2) -> MetrePerSecond:
    """Highest speed of the saw that catches up with the mark by its ramps alone.

    ``x_m`` way by which the mark is ahead, at least -v_F^2 / (2 a), ``v_F`` feed, ``a`` acceleration and deceleration.

    >>> round(catch_up_speed(0.07, 0.2, 1.0), 9)
    0.5
    """
    return v_F + sqrt(v_F**2 / 2 + a * x_m)


@formula(symbol="t_g", unit="s", source="SEW 2001, 8.4; derived: ramps, and what they do not gain at constant speed")
def catch_up_time(v: MetrePerSecond, v_F: MetrePerSecond, a: MetrePerSecond2, x_m: Metre, x_g: Metre) -> Second:
    """Time from the start of the saw until it runs with its mark.

    ``v`` highest speed of the saw, ``v_F`` feed, ``a`` acceleration and deceleration, ``x_m`` way by which the mark is
    ahead, ``x_g`` way that is gained in the ramps.

    >>> round(catch_up_time(0.5, 0.2, 1.0, 0.1, 0.07), 9)
    0.9
    """
    return v / a + (x_m - x_g) / (v - v_F) + (v - v_F) / a


@formula(symbol="s_y", unit="mm", source="derived: the saw is where its mark is")
def synchronous_start(x_m: Metre, v_F: MetrePerSecond, t_g: Second) -> Metre:
    """Position of the saw from which it runs with the material.

    ``x_m`` way by which the mark was ahead at the start, ``v_F`` feed, ``t_g`` time to catch up.

    >>> round(synchronous_start(0.2, 0.2, 1.176393202), 9)
    0.43527864
    """
    return x_m + v_F * t_g


@formula(symbol="t_y", unit="s", source="derived: way with the material over its speed")
def synchronous_time(s: Metre, s_y: Metre, v_F: MetrePerSecond) -> Second:
    """Time for which the saw runs with the material.

    ``s`` way from the start to the end of the cut, ``s_y`` position where it begins to run with the material, ``v_F``
    feed.

    >>> round(synchronous_time(0.8, 0.4352786405, 0.2), 9)
    1.823606798
    """
    return (s - s_y) / v_F
