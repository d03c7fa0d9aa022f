"""Several axes on one supply: each sized by itself, then joined on a common DC link."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any

import numpy as np
from pydantic import Field, StringConstraints

from app.engine.dc_link import AxisPower, common_cycles, power_diagram
from app.engine.diagram import Diagram
from app.engine.drives.servo import ServoResult
from app.engine.products import BrakingResistor
from app.engine.quantity import Declared, Option, Quantity
from app.engine.sheet import Sheet, Verdict
from app.engine.supply import AxisModule, SupplyAxis, SupplyRules, record_supply
from app.services.errors import FieldError, InvalidInputError, NotFoundError
from app.services.reading import read
from app.services.requests import SizingRequest
from app.services.sizing import Headline, Sizing, SizingService, refusals

HEADLINES = ("supply_peak_current", "supply_mean_current", "supply_peak_power", "mean_braking_power", "braking_peak",
             "permitted_ambient")  # fmt: skip
ONLY_SERVO = "needs a servo drive: only servo axes stand on a supply module"


class AxisOnSupply(Declared):
    """One axis, when its cycle begins, and its axis module."""

    sizing: SizingRequest
    start: Annotated[
        float,
        Quantity("s", symbol="t_0", ge=0, le=1e6, default=0.0, source="all start together",
                 about="start of this axis after the first one"),
    ]  # fmt: skip
    module: AxisModule | None = None


class MultiAxisRequest(Declared):
    """Several axes on one supply."""

    name: Annotated[Annotated[str, StringConstraints(max_length=200)], Option(default="", about="name")]
    axes: Annotated[list[AxisOnSupply], Field(min_length=1, max_length=20)]
    supply: SupplyRules = Field(default_factory=lambda: SupplyRules.model_validate({}))


@dataclass(frozen=True)
class MultiAxis:
    """Several axes on one supply, calculated."""

    request: MultiAxisRequest
    raw: Mapping[str, Any]
    sizings: tuple[Sizing, ...]
    sheet: Sheet
    diagrams: tuple[Diagram, ...]

    @property
    def asked(self) -> MultiAxisRequest:
        """What was asked, read."""
        return self.request

    @property
    def headlines(self) -> tuple[Headline, ...]:
        """Results shown before all others."""
        steps = {step.key: step for step in self.sheet.steps}
        return tuple(
            Headline(key, steps[key].label, steps[key].symbol, steps[key].value, steps[key].unit)
            for key in HEADLINES if key in steps
        )  # fmt: skip

    @property
    def verdict(self) -> Verdict:
        """The worst of all checks that could be made."""
        found = {check.verdict for check in self.sheet.checks}
        order = (Verdict.FAILS, Verdict.TIGHT, Verdict.OK)
        return next((one for one in order if one in found), Verdict.NOT_CHECKED)


class MultiAxisService:
    """Sizes several axes and their common supply."""

    def __init__(self, sizing: SizingService) -> None:
        self._sizing = sizing
        self._catalogue = sizing.catalogue

    def size(self, raw: Any) -> MultiAxis:
        """Calculate a request as it was typed. Raises InvalidInputError with the path of every refused value."""
        request, sheet = read(MultiAxisRequest, raw), Sheet()
        sizings = tuple(self._axis(index, axis["sizing"]) for index, axis in enumerate(raw["axes"]))
        powers = [_power(index, sizing, request.axes[index].start) for index, sizing in enumerate(sizings)]
        common = common_cycles(powers)
        if common is None:
            times = ", ".join(f"{one.name}: {one.cycle_time:.4g} s" for one in powers)
            message = f"the longest cycle must be a whole multiple of the others ({times})"
            raise InvalidInputError([FieldError(("axes",), message, None)])
        sheet.assume_defaults(request.supply, "supply.")
        axes = [_supply_axis(index, sizings[index], common[index], request) for index in range(len(sizings))]
        with refusals(raw):
            record_supply(axes, request.supply, self._resistor(request), sheet)
        return MultiAxis(request, raw, sizings, sheet, (power_diagram(common),))

    def _axis(self, index: int, raw: Any) -> Sizing:
        try:
            return self._sizing.size(raw)
        except InvalidInputError as error:
            prefix = ("axes", index, "sizing")
            raise InvalidInputError(
                [FieldError((*prefix, *one.path), one.message, one.value) for one in error.errors]
            ) from error

    def _resistor(self, request: MultiAxisRequest) -> BrakingResistor | None:
        choice = request.supply.braking_resistor
        if choice is None:
            return None
        found = choice.typed
        if found is None:
            try:
                found = self._catalogue.snapshot().product(BrakingResistor, str(choice.id))
            except NotFoundError as error:
                path = ("supply", "braking_resistor", "id")
                raise InvalidInputError([FieldError(path, error.message, choice.id)]) from error
        assert isinstance(found, BrakingResistor)
        return found


def _power(index: int, sizing: Sizing, start: float) -> AxisPower:
    """Power of one axis over its cycle. Raises InvalidInputError where it is no servo axis, or its data lack."""
    drive, path = sizing.drive, ("axes", index, "sizing", "drive")
    if not isinstance(drive, ServoResult):
        raise InvalidInputError([FieldError((*path, "kind"), ONLY_SERVO, sizing.asked.drive.kind)])
    points = drive.cycle
    if points is None or points.torque is None:
        message = "its efficiency and inertia must be known on a common supply"
        raise InvalidInputError([FieldError((*path, "gear_unit"), message, None)])
    slows = np.abs(points.speed_end) < np.abs(points.speed_start)
    name = sizing.asked.name or f"axis {index + 1}"
    return AxisPower(
        name=name, time=points.time, start=points.torque * points.speed_start, end=points.torque * points.speed_end,
        label=points.label, ramp=tuple(bool(one) for one in slows), shift=start,
    )  # fmt: skip


def _supply_axis(index: int, sizing: Sizing, power: AxisPower, request: MultiAxisRequest) -> SupplyAxis:
    """One axis as the supply sees it. Raises InvalidInputError where its currents are not known."""
    drive, path = sizing.drive, ("axes", index, "sizing", "drive")
    assert isinstance(drive, ServoResult)
    currents = drive.currents
    if currents.peak is None or currents.effective is None or not sizing.sheet.has("mean_torque"):
        message = f"its currents are not known: {currents.missing or 'motor'}"
        raise InvalidInputError([FieldError((*path, "motor"), message, None)])
    constant = _torque_constant(sizing)
    return SupplyAxis(
        name=power.name, power=power, peak_current=currents.peak, effective_current=currents.effective,
        mean_torque=sizing.sheet.value("mean_torque"), torque_constant=constant, module=request.axes[index].module,
    )  # fmt: skip


def _torque_constant(sizing: Sizing) -> float:
    if sizing.sheet.has("torque_constant"):
        return sizing.sheet.value("torque_constant")
    return float(sizing.parts.motor.torque_constant)
