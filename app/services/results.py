"""Results as plain values for JSON, built lean: the shapes are those of
``app.web.api.models``, and a test holds them together."""

import math
from typing import Any

import numpy as np
from pydantic_core import to_json

from app.engine.cycle import LoadCycle
from app.engine.drives.base import DriveModel
from app.engine.drives.parts import roles_of
from app.engine.products import Product
from app.engine.quantity import from_si, si_factor
from app.engine.sheet import Assumption, Check, Sheet, Step
from app.services.calculation import Calculation
from app.services.examples import Example, ExampleRow
from app.services.multi_axis import MultiAxis
from app.services.selection import Explanation, RankedCandidate, SelectionOutcome
from app.services.sizing import Parts, Sizing
from app.services.version import ENGINE_VERSION

LISTED_VALUES = 12
"""An array put into a formula is listed up to this many values."""


def sizing_json(sizing: Sizing) -> bytes:
    """The answer to a sizing."""
    deciding = sizing.deciding_check
    return to_json({
        "engine_version": sizing.engine_version,
        "catalogue": {"version": sizing.catalogue_version, "editions": dict(sizing.editions)},
        "request": sizing.typed.raw,
        "verdict": str(sizing.verdict),
        "counts": {str(verdict): count for verdict, count in sizing.counts.items()},
        "deciding_check": deciding.key if deciding else None,
        "headlines": [
            {"key": h.key, "label": h.label, "symbol": h.symbol, "value": from_si(h.value, h.unit), "unit": h.unit,
             "value_si": h.value}
            for h in sizing.headlines
        ],
        "parts": parts_dict(sizing.parts, sizing.typed.request.drive),
        "checks": [check_dict(check) for check in sizing.sheet.checks],
        **_sheet_dict(sizing.sheet),
        "load_cycle": load_cycle_dict(sizing.load.cycle),
    })  # fmt: skip


def calculation_json(calculation: Calculation) -> bytes:
    """The answer to a calculation with formulas."""
    return to_json({"engine_version": ENGINE_VERSION, "steps": [_step_dict(step) for step in calculation.sheet.steps]})


def multi_axis_json(found: MultiAxis) -> bytes:
    """The answer to several axes on one supply."""
    return to_json({
        "engine_version": ENGINE_VERSION, "verdict": str(found.verdict),
        "headlines": [
            {"key": h.key, "label": h.label, "symbol": h.symbol, "value": from_si(h.value, h.unit), "unit": h.unit,
             "value_si": h.value}
            for h in found.headlines
        ],
        "axes": [{"name": one.asked.name, "verdict": str(one.verdict)} for one in found.sizings],
        "checks": [check_dict(check) for check in found.sheet.checks],
        **_sheet_dict(found.sheet),
    })  # fmt: skip


def selection_json(outcome: SelectionOutcome) -> bytes:
    """The answer to a selection."""
    found = outcome.selection
    return to_json({
        "items": [_candidate_dict(ranked) for ranked in outcome.candidates],
        "total": found.admitted, "limit": outcome.request.limit, "offset": outcome.request.offset,
        "evaluated": found.evaluated, "admitted": found.admitted, "rejected": outcome.rejected,
        "rejected_by": found.rejected, "ranking": outcome.request.ranking,
        "catalogue": {"version": outcome.catalogue_version, "editions": dict(outcome.editions)},
        "engine_version": outcome.engine_version,
    })  # fmt: skip


def _candidate_dict(ranked: RankedCandidate) -> dict[str, Any]:
    candidate = ranked.candidate
    return {
        "rank": ranked.rank, "motor": part_dict(ranked.motor), "gear_unit": part_dict(ranked.gear_unit),
        "ratio": ranked.gear_unit.ratio if ranked.gear_unit else 1.0,
        "utilisation": finite(candidate.utilisation), "deciding_check": candidate.deciding,
        "mass_kg": finite(candidate.mass), "rated_torque_nm": finite(candidate.rated_torque),
        "inertia_ratio": finite(candidate.inertia_ratio),
        "utilisations": {key: finite(used) for key, used in candidate.utilisations.items()},
        "not_checked": list(candidate.not_checked),
    }  # fmt: skip


def explanation_json(found: Explanation) -> bytes:
    """The answer to the question why a candidate was admitted or rejected."""
    return to_json({
        "motor": part_dict(found.parts.motor), "gear_unit": part_dict(found.parts.gear_unit),
        "verdict": str(found.drive.verdict),
        "checks": [check_dict(check) for check in found.drive.checks],
        "servo_drives": [
            {"servo_drive": part_dict(one.drive), "peak_current": finite(one.peak),
             "continuous_current": finite(one.continuous), "verdict": str(one.verdict)}
            for one in found.suggestions
        ],
    })  # fmt: skip


def _sheet_dict(sheet: Sheet) -> dict[str, Any]:
    return {
        "steps": [_step_dict(step) for step in sheet.steps],
        "assumptions": [_assumption_dict(assumption) for assumption in sheet.assumptions],
        "decisions": [{"section": d.section, "text": d.text, "reason": d.reason} for d in sheet.decisions],
    }


def _step_dict(step: Step) -> dict[str, Any]:
    return {
        "key": step.key, "section": step.section, "label": step.label, "symbol": step.symbol,
        "value": step.shown_value, "unit": step.unit, "value_si": step.value, "formula": step.formula.name,
        "source": step.formula.source, "inputs": {name: _plain(value) for name, value in step.inputs.items()},
    }  # fmt: skip


def check_dict(check: Check) -> dict[str, Any]:
    """One check, numbers in its unit."""
    return {
        "key": check.key, "name": check.name, "section": check.section, "verdict": str(check.verdict),
        "utilisation": finite(check.utilisation), "demanded": shown(check.demanded, check.unit),
        "permitted": shown(check.permitted, check.unit), "unit": check.unit, "source": check.source,
        "formula": check.formula, "missing": check.missing,
    }  # fmt: skip


def _assumption_dict(assumption: Assumption) -> dict[str, Any]:
    value = assumption.value
    if isinstance(value, float):
        value = shown(value, assumption.unit)
    return {
        "key": assumption.key, "text": assumption.text, "symbol": assumption.symbol, "value": value,
        "unit": assumption.unit, "source": assumption.source,
    }  # fmt: skip


def part_dict(product: Product | None) -> dict[str, Any] | None:
    """What names a product."""
    if product is None:
        return None
    return {name: getattr(product, name) or "" for name in ("id", "manufacturer", "series", "model", "source")}


def parts_dict(parts: Parts, drive: DriveModel) -> dict[str, Any]:
    """Every part that this kind of drive has; None where none was chosen."""
    return {role: part_dict(parts.products.get(role)) for role in roles_of(type(drive))}


def load_cycle_dict(cycle: LoadCycle) -> dict[str, Any]:
    """The load cycle as columns."""
    rpm = si_factor("rpm")[0]
    return {
        "duration_s": cycle.duration.tolist(),
        "speed_start_rpm": (cycle.speed_start / rpm).tolist(),
        "speed_end_rpm": (cycle.speed_end / rpm).tolist(),
        "torque_nm": cycle.torque.tolist(),
        "braked": cycle.braked.tolist(),
        "label": list(cycle.label),
        "inertia_kgm2": float(cycle.inertia),
    }


def finite(value: float | None) -> float | None:
    """JSON knows no infinity: None in its place."""
    return value if value is not None and math.isfinite(value) else None


def shown(value: float | None, unit: str) -> float | None:
    """An SI value in the unit in which it is shown."""
    return None if value is None or not math.isfinite(value) else from_si(value, unit)


def _plain(value: Any) -> Any:
    """A value that was put into a formula, without numpy."""
    if isinstance(value, np.ndarray):
        flat = value.ravel()
        listed: list[Any] = flat[:LISTED_VALUES].tolist()
        return listed if flat.size <= LISTED_VALUES else [*listed, f"... {flat.size} values"]
    return value.item() if isinstance(value, np.generic) else value


def example_dict(example: Example) -> dict[str, Any]:
    """A worked example, recomputed."""
    file = example.file
    return {
        "id": file.id, "title": file.title, "source": file.source, "summary": file.summary,
        "requests": file.requests, "rows": [example_row_dict(row) for row in example.rows],
    }  # fmt: skip


def example_row_dict(row: ExampleRow) -> dict[str, Any]:
    """One number of an example."""
    return {
        "name": row.name, "symbol": row.symbol, "unit": row.unit, "printed": row.printed,
        "expected": finite(row.expected), "computed": finite(row.computed), "deviation": finite(row.deviation),
        "tolerance": row.tolerance, "status": row.status, "produced": row.produced, "reason": row.reason,
        "note": row.note,
    }  # fmt: skip
