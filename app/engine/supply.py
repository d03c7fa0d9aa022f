"""Electronics of several servo axes: axis modules, supply module, braking resistor, heat sink."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, Literal

import numpy as np

from app.engine.dc_link import AxisPower, net_segments, returned_segments, returning_time, worst_phase
from app.engine.drives.parts import BrakingResistorChoice
from app.engine.formulas import electronics as formulas
from app.engine.formulas import resistor as braking
from app.engine.formulas.duty import duty_share
from app.engine.formulas.motion import sum_of_times
from app.engine.products import BrakingResistor
from app.engine.quantity import Declared, Option, Quantity
from app.engine.resistor import Braking, PowerSegment, check_chopper, check_resistor
from app.engine.sheet import Sheet

_SUPPLY, _LOSSES, _SINK = "Supply module", "Losses", "Heat sink"


class AxisModule(Declared):
    """The axis module of one axis."""

    rated_current: Annotated[float, Quantity("A", symbol="I_N", gt=0, le=1e5, about="rated current of the axis module")]
    peak_factor: Annotated[
        float,
        Quantity("1", symbol="k_I", ge=1, le=10, default=1.5, source="SEW 2001, 16.5", about="peak current over rated"),
    ]
    width: Annotated[
        float | None, Quantity("1", symbol="TE", gt=0, le=100, default=None, about="width in units of the rack")
    ]


class SupplyRules(Declared):
    """Supply module, losses and heat sink."""

    supply_current: Annotated[
        float | None,
        Quantity("A", symbol="I_NM", gt=0, le=1e5, default=None, group=_SUPPLY, about="rated current of the supply"),
    ]
    supply_peak_factor: Annotated[
        float,
        Quantity("1", symbol="k_NM", ge=1, le=10, default=2.0, source="SEW 2001, 16.5: twice for 5 s", group=_SUPPLY,
                 about="peak current of the supply over rated"),
    ]  # fmt: skip
    supply_width: Annotated[
        float | None,
        Quantity("1", symbol="TE_NM", gt=0, le=100, default=None, group=_SUPPLY, about="width in units of the rack"),
    ]
    chopper_limit: Annotated[
        float | None,
        Quantity("kW", symbol="P_BRC", gt=0, le=1e8, default=None, group=_SUPPLY, about="power of the braking chopper"),
    ]
    axis_losses: Annotated[
        float,
        Quantity("W/A", symbol="k_MA", ge=0, le=1e4, default=14.0, source="SEW 2001, 16.5", group=_LOSSES,
                 about="losses of an axis module per ampere"),
    ]  # fmt: skip
    supply_losses: Annotated[
        float,
        Quantity("W/A", symbol="k_MP", ge=0, le=1e4, default=2.0, source="SEW 2001, 16.5", group=_LOSSES,
                 about="losses of the supply module per ampere"),
    ]  # fmt: skip
    base_losses: Annotated[
        float,
        Quantity("W", symbol="P_V0", ge=0, le=1e5, default=12.0, source="SEW 2001, 16.5", group=_LOSSES,
                 about="losses of the switched-mode supply without axes"),
    ]  # fmt: skip
    losses_per_axis: Annotated[
        float,
        Quantity("W", symbol="P_V1", ge=0, le=1e5, default=13.0, source="SEW 2001, 16.5", group=_LOSSES,
                 about="losses of the switched-mode supply per axis"),
    ]  # fmt: skip
    thermal_resistance: Annotated[
        float | None,
        Quantity("K/W", symbol="R_KK", gt=0, le=100, default=None, group=_SINK, about="thermal resistance"),
    ]
    sink_temperature: Annotated[
        float,
        Quantity("degC", symbol="theta_max", ge=273.15, le=500, default=353.15, source="SEW 2001, 16.5: 80 degC",
                 group=_SINK, about="permitted temperature of the heat sink"),
    ]  # fmt: skip
    ambient_temperature: Annotated[
        float,
        Quantity("degC", symbol="theta_amb", ge=233.15, le=373.15, default=313.15, source="IEC 60034-1: 40 degC",
                 group=_SINK, about="ambient air of the cabinet"),
    ]  # fmt: skip
    exchange: Annotated[
        Literal["none", "shared"],
        Option(default="none", source="on the safe side", group=_SUPPLY, about="energy between the axes",
               labels={"none": "all that is returned goes to the resistor",
                       "shared": "one axis takes what another returns"}),
    ]  # fmt: skip
    braking_resistor: BrakingResistorChoice | None = None


@dataclass(frozen=True, kw_only=True)
class SupplyAxis:
    """One axis on the supply."""

    name: str
    power: AxisPower
    peak_current: float
    effective_current: float
    mean_torque: float
    torque_constant: float
    module: AxisModule | None


def record_supply(
    axes: Sequence[SupplyAxis], rules: SupplyRules, resistor: BrakingResistor | None, sheet: Sheet
) -> None:
    """Write and check axis modules, supply, DC link, braking resistor and heat sink."""
    means = [_record_module(number, axis, sheet) for number, axis in enumerate(axes, start=1)]
    with sheet.section(_SUPPLY):
        peak = sheet(formulas.sum_of_currents, key="supply_peak_current", label="Peak current of all axes at once",
                     I_k=[axis.peak_current for axis in axes])  # fmt: skip
        mean = sheet(formulas.sum_of_currents, key="supply_mean_current", label="Mean current of all axes", I_k=means)
        limit = rules.supply_current
        missing = "" if limit is not None else "rated current of the supply module"
        allowed = None if limit is None else limit * rules.supply_peak_factor
        sheet.check("supply_peak_current", "Supply module: peak current", peak, allowed, "A", "supply: data sheet",
                    formula="sum_of_currents", missing=missing)  # fmt: skip
        sheet.check("supply_mean_current", "Supply module: mean current", mean, limit, "A", "supply: data sheet",
                    formula="sum_of_currents", missing=missing)  # fmt: skip
        widths = [rules.supply_width, *(axis.module.width if axis.module else None for axis in axes)]
        if all(width is not None for width in widths):
            sheet(formulas.module_width, n_k=widths)
    _record_link(axes, sheet)
    _record_resistor(axes, rules, resistor, sheet)
    _record_heat(axes, rules, sheet)


def _record_module(number: int, axis: SupplyAxis, sheet: Sheet) -> float:
    """Mean current of one axis [A]."""
    with sheet.section(f"Axis module: {axis.name}"):
        mean = sheet(formulas.mean_current, key=f"axis_{number}_mean_current", M_mean=axis.mean_torque,
                     k_T=axis.torque_constant)  # fmt: skip
        if axis.module is None:
            sheet.decide(f"No axis module is checked: {axis.name}", "none is given")
            return mean
        rated = axis.module.rated_current
        sheet.check(f"axis_{number}_peak_current", f"Axis module: peak current: {axis.name}", axis.peak_current,
                    rated * axis.module.peak_factor, "A", "axis module: data sheet")  # fmt: skip
        sheet.check(f"axis_{number}_mean_current", f"Axis module: mean current: {axis.name}", mean, rated, "A",
                    "axis module: data sheet", formula="mean_current")  # fmt: skip
    return mean


def _record_link(axes: Sequence[SupplyAxis], sheet: Sheet) -> None:
    """Power that all axes take, at once and on average, and the worst phase between them."""
    powers = [axis.power for axis in axes]
    with sheet.section("DC link"):
        peaks = [max(float(one.start.max()), float(one.end.max()), 0.0) for one in powers]
        label = "Largest power of every axis at the same instant"
        sheet(braking.sum_of_powers, key="supply_peak_power", symbol="P_peak", label=label, P_k=peaks)
        taken = [_taken(one) for one in powers]
        sheet(formulas.mean_motoring_power, W_k=taken, t_cyc=powers[0].cycle_time)
        net = net_segments(powers)
        label = "Largest power of all axes with these starts"
        sheet(braking.sum_of_powers, key="net_peak_power", symbol="P_net", label=label,
              P_k=[max(max(one.start, one.end) for one in net)])  # fmt: skip
        placed, worst = worst_phase(powers)
        label = "Largest power of all axes in the worst phase between them"
        sheet(braking.sum_of_powers, key="worst_peak_power", symbol="P_worst", label=label, P_k=[worst])
        shifts = ", ".join(f"{one.name}: {one.shift:.3g} s" for one in placed[1:])
        if shifts:
            sheet.decide(f"Worst phase: {shifts} later than {placed[0].name}", "found by shifting the axes")


def _taken(axis: AxisPower) -> float:
    """Energy that an axis takes in a cycle, what it returns not counted [J]."""
    mirrored = [PowerSegment(s.label, s.duration, -s.start, -s.end) for s in axis.segments()]
    parts = [part for one in mirrored if (part := one.returned()) is not None]
    return sum((part.start + part.end) / 2 * part.duration for part in parts)


def _record_resistor(
    axes: Sequence[SupplyAxis], rules: SupplyRules, resistor: BrakingResistor | None, sheet: Sheet
) -> None:
    """Energy that all axes return: each alone, with overlap in time, and exchanged; both methods of the handbook."""
    powers, cycle = [axis.power for axis in axes], axes[0].power.cycle_time
    with sheet.section("Braking resistor"):
        parts = [[p for s in one.segments() if (p := s.returned()) is not None and p.duration > 0] for one in powers]
        if not any(parts):
            sheet.decide("No braking resistor is needed", "no axis returns power")
            return
        for number, own in enumerate(parts, start=1):
            for place, part in enumerate(own, start=1):
                sheet(braking.braking_energy, key=f"axis_{number}_energy_{place}", P_1=part.start,
                      label=f"Energy returned: {part.label}", P_2=part.end, t=part.duration)  # fmt: skip
        energies = [float(braking.braking_energy(p.start, p.end, p.duration)) for own in parts for p in own]
        energy = sheet(braking.braking_energy_of_cycle, W_k=energies)
        alone = sheet(sum_of_times, key="braking_time_one_after_another", symbol="t_B", t_k=[
            p.duration for own in parts for p in own], label="Time of braking, one after another")  # fmt: skip
        sheet(duty_share, key="braking_duty_one_after_another", t_on=alone, t_cyc=cycle)
        sheet(braking.mean_braking_power, key="mean_power_one_after_another", W_c=energy, t_on=alone)
        overlap = sheet(sum_of_times, key="braking_time", symbol="t_B", t_k=[returning_time(powers)],
                        label="Time in which at least one axis returns power")  # fmt: skip
        duty = sheet(duty_share, key="braking_duty", t_on=overlap, t_cyc=cycle)
        mean = sheet(braking.mean_braking_power, W_c=energy, t_on=overlap)
        sheet(braking.mean_braking_power, key="braking_power_over_cycle", label="Mean over the whole cycle",
              W_c=energy, t_on=cycle)  # fmt: skip
        tops = [max((max(p.start, p.end) for p in own), default=0.0) for own in parts]
        for number, top in enumerate(tops, start=1):
            sheet(braking.peak_braking_power, key=f"axis_{number}_braking_peak", P=-top)
        peak = sheet(braking.sum_of_powers, key="braking_peak", symbol="P_peak", P_k=tops,
                     label="Largest braking power of every axis at the same instant")  # fmt: skip
        _record_ramp_method(parts, sheet)
        found = Braking(energy, overlap, duty, mean, peak, tuple(returned_segments(powers)))
        if rules.exchange == "shared":
            found = _exchanged(powers, cycle, sheet) or found
        if resistor is None:
            check_chopper(sheet, found.peak, rules.chopper_limit)
        else:
            check_resistor(sheet, found, resistor, cycle_time=cycle, chopper_limit=rules.chopper_limit)


def _record_ramp_method(parts: Sequence[Sequence[PowerSegment]], sheet: Sheet) -> None:
    """The second method of the handbook: the mean powers of the strongest ramp of each axis, added up."""
    means = []
    for number, own in enumerate(parts, start=1):
        ramps = [(p.start + p.end) / 2 for p in own if p.ramp]
        if ramps:
            label = "Mean power of the strongest braking ramp"
            means.append(sheet(braking.sum_of_powers, key=f"axis_{number}_ramp_power", label=label, P_k=[max(ramps)]))
    if means:
        sheet(braking.sum_of_powers, key="ramp_method_power", P_k=means)


def _exchanged(powers: Sequence[AxisPower], cycle: float, sheet: Sheet) -> Braking | None:
    """What is left for the resistor when one axis takes what another returns."""
    net = tuple(net_segments(powers))
    left = [p for s in net if (p := s.returned()) is not None]
    if not left:
        sheet.decide("No braking resistor is needed with these starts", "other axes take all that is returned")
        return None
    energies = [float(braking.braking_energy(p.start, p.end, p.duration)) for p in left]
    energy = sheet(braking.braking_energy_of_cycle, key="net_braking_energy", W_k=energies,
                   label="Energy left for the resistor")  # fmt: skip
    time = sum(p.duration for p in left)
    mean = sheet(braking.mean_braking_power, key="net_braking_power", W_c=energy, t_on=time)
    return Braking(energy, time, time / cycle, mean, max(max(p.start, p.end) for p in left), net)


def _record_heat(axes: Sequence[SupplyAxis], rules: SupplyRules, sheet: Sheet) -> None:
    with sheet.section(_SINK):
        switched = sheet(formulas.switch_mode_losses, P_1=rules.base_losses, P_2=rules.losses_per_axis, n_M=len(axes))
        losses = [
            sheet(formulas.module_losses, key=f"axis_{number}_losses", label=f"Losses of the axis module: {axis.name}",
                  k_V=rules.axis_losses, I=axis.effective_current)
            for number, axis in enumerate(axes, start=1)
        ]  # fmt: skip
        supply = sheet(formulas.module_losses, key="supply_losses", label="Losses of the supply module",
                       k_V=rules.supply_losses, I=float(np.sum([axis.effective_current for axis in axes])))  # fmt: skip
        total = sheet(formulas.heat_sink_losses, P_k=[supply, *losses], P_1=switched, k_s=0.5)
        if rules.thermal_resistance is None:
            sheet.decide("No heat sink is checked", "its thermal resistance is not given")
            return
        rise = sheet(formulas.heat_sink_rise, P=total, R_th=rules.thermal_resistance)
        limit = sheet(formulas.permitted_ambient, theta_2=rules.sink_temperature, d_theta=rise)
        sheet.check("ambient_temperature", "Ambient air of the heat sink", rules.ambient_temperature, limit, "degC",
                    "SEW 2001, 16.5", formula="permitted_ambient")  # fmt: skip
