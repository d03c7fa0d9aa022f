"""The criteria of the servo rule sets for all candidates at once: the same rules as in the check of one drive.

Every demand is brought to the form that :mod:`app.engine.candidates` evaluates in blocks. A test holds both to the
same numbers.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from app.engine.candidates import (
    ColumnTerm,
    EnvelopeTerm,
    GearArrays,
    Missing,
    MotorArrays,
    ProductTerm,
    RowsTerm,
    TableTerm,
    Term,
    known,
    reciprocal,
)
from app.engine.cycle import BoolArray, CycleHull, Envelope, FloatArray, IndexArray
from app.engine.drives.limits import ServoLimits
from app.engine.drives.rules import ServoRules, brake_needed
from app.engine.environment import Environment
from app.engine.formulas.efficiency import regenerative_factor, through_stage
from app.engine.formulas.servo import (
    lachman_dynamic_torque,
    lachman_friction_torque,
    lachman_motor_inertia,
    lachman_motor_speed,
    lachman_peak_torque,
)
from app.engine.mechanisms.load import Load

MANY_LINES = 24
"""Lines of an envelope from which on it is looked up instead of drawn line by line."""
_POINTS_AT_ONCE = 256


@dataclass
class ServoTerms:
    """All checks of one selection: what makes them up, and where they cannot be made."""

    load: Load
    motors: MotorArrays
    gears: GearArrays
    rules: ServoRules
    environment: Environment
    terms: list[Term] = field(default_factory=list)
    missing: dict[str, Missing] = field(default_factory=dict)
    unasked: dict[str, BoolArray] = field(default_factory=dict)
    """Checks that lack an input of the user, not a datum of the catalogue: columns for which they are not made."""

    @cached_property
    def hull(self) -> CycleHull:
        """Outermost points of the cycle and its opposite."""
        return CycleHull((self.load.cycle,) if self.load.opposite is None else (self.load.cycle, self.load.opposite))

    @cached_property
    def with_brake(self) -> bool:
        """Whether the motors need a holding brake."""
        return brake_needed(self.load, self.rules)

    @cached_property
    def rotor_unknown(self) -> BoolArray:
        """Motors whose rotor inertia is not known."""
        return np.isnan(self.motors.rotor_with_brake if self.with_brake else self.motors.rotor)

    @cached_property
    def rotor(self) -> FloatArray:
        """J_M of every motor [kg m2], 0 where it is not known."""
        return known(self.motors.rotor_with_brake if self.with_brake else self.motors.rotor)

    @cached_property
    def complete(self) -> FloatArray:
        """1 for columns whose torques on the motor shaft are known, else 0: takes the others out of a sum."""
        return np.where(self.gears.incomplete, 0.0, 1.0)

    @cached_property
    def inertia(self) -> FloatArray:
        """J_x: gear unit and coupling on the motor shaft [kg m2]."""
        return (known(self.gears.inertia) + self.rules.coupling_inertia) * self.complete

    @cached_property
    def external(self) -> FloatArray:
        """External inertia on the motor shaft [kg m2], 0 where it is not known."""
        cycles = self.hull.cycles
        load = max(cycle.inertia for cycle in cycles) / self.gears.ratio**2
        return (load * self.complete) + self.inertia

    @cached_property
    def slope(self) -> FloatArray:
        """Motor acceleration per acceleration of the output shaft: the ratio, 0 where torques are not known."""
        return self.gears.ratio * self.complete

    @cached_property
    def factors(self) -> dict[int, FloatArray]:
        """p_s by direction of power: torque on the motor shaft per torque at the output; 0 where it is not known."""
        eta = np.where(self.gears.incomplete, 1.0, self.gears.efficiency)
        share = self.complete / self.gears.ratio
        back = regenerative_factor(eta, self.environment.regeneration)
        return {1: share / eta, -1: share * back, 0: share}

    def one_torque(self, torque: float, speed: float) -> FloatArray:
        """One torque of the output shaft on the motor shaft of every column; only its direction of power counts."""
        eta = np.where(self.gears.incomplete, 1.0, self.gears.efficiency)
        passed = through_stage(np.full(eta.shape, torque), speed, eta, self.environment.regeneration)
        found: FloatArray = passed / self.gears.ratio * self.complete
        return found

    def add(self, term: Term, rows: BoolArray | None = None, columns: BoolArray | None = None) -> None:
        """Add a term; ``rows`` and ``columns`` are where its check cannot be made."""
        self.terms.append(term)
        if rows is not None or columns is not None:
            none = np.zeros(len(self.motors), dtype=bool), np.zeros(self.gears.ratio.size, dtype=bool)
            self.missing[term.key] = Missing(none[0] if rows is None else rows, none[1] if columns is None else columns)

    def product(
        self, key: str, rows: FloatArray, columns: FloatArray, missing: BoolArray, lacking: BoolArray | None = None
    ) -> None:
        """Add a check of one column demand against one row limit, given as its reciprocal."""
        self.add(ProductTerm(key, rows[:, None], (columns[None, :],)), missing, lacking)


def servo_terms(
    load: Load, motors: MotorArrays, gears: GearArrays, rules: ServoRules, environment: Environment
) -> ServoTerms:
    """Prepare all checks of the rule set for one load; checks of the gear unit alone come first."""
    made = ServoTerms(load, motors, gears, rules, environment)
    _add_gear_checks(made)
    if rules.rule_set == "lachman":
        _add_lachman(made)
    else:
        _add_usual(made)
    return made


def _add_gear_checks(made: ServoTerms) -> None:
    gears, sums = made.gears, made.load.cycle.sums
    mean_torque = (sums.torque3_angle / sums.angle) ** (1 / 3) if sums.angle > 0 else 0.0
    demands = (
        ("gear_acceleration_torque", made.hull.max_torque, gears.acceleration_torque),
        ("gear_nominal_torque", mean_torque, gears.nominal_torque),
        ("gear_mean_input_speed", gears.ratio * (sums.angle / sums.time), gears.nominal_input_speed),
        ("gear_max_input_speed", gears.ratio * made.hull.max_speed, gears.max_input_speed),
    )
    for key, demand, limit in demands:
        made.add(ColumnTerm(key, demand * reciprocal(limit)), columns=np.isnan(limit))
    _add_emergency(made)


def _add_emergency(made: ServoTerms) -> None:
    key, gears, motors = "gear_emergency_torque", made.gears, made.motors
    limit, factor = gears.emergency_torque, made.rules.emergency_stop_factor
    asked_by_brake = np.zeros(len(motors), dtype=bool)
    if factor is not None:
        made.add(ColumnTerm(key, factor * made.hull.max_torque * reciprocal(limit)))
    if made.with_brake:
        columns = gears.ratio * reciprocal(limit)
        made.add(ProductTerm(key, known(motors.brake_torque)[:, None], (columns[None, :],)))
        asked_by_brake = np.isnan(motors.brake_torque)
    if factor is None and not made.with_brake:
        made.unasked[key] = gears.has_gear
        return
    none = np.zeros(len(motors), dtype=bool)
    pairs = (asked_by_brake, gears.has_gear) if factor is None else (None, None)
    made.missing[key] = Missing(none, np.isnan(limit), *pairs)


def _add_usual(made: ServoTerms) -> None:
    motors, gears, rules = made.motors, made.gears, made.rules
    limit = motors.permitted_speed(rules)
    made.product("speed", reciprocal(limit), gears.ratio * made.hull.max_speed, np.isnan(limit))
    least = np.where(made.rotor_unknown, np.nan, made.rotor) * rules.inertia_ratio_limit
    made.product("inertia_ratio", reciprocal(least), made.external, made.rotor_unknown, gears.incomplete)
    _add_holding(made)
    _add_peak(made)
    _add_effective(made)


def _add_holding(made: ServoTerms) -> None:
    if made.with_brake:
        held = abs(made.load.statics.holding) * made.rules.holding_reserve / made.gears.ratio
        limit = made.motors.brake_torque
        made.product("holding_brake", reciprocal(limit), held, np.isnan(limit))


def _add_effective(made: ServoTerms) -> None:
    """sum(M_k^2 dt) as a polynomial in J_M whose coefficients belong to the gear unit, over the square of S1."""
    sums, p, q, J_x = made.load.cycle.sums, made.factors, made.slope, made.inertia
    squares = p[1] ** 2 * sums.driving_torque2 + p[-1] ** 2 * sums.returning_torque2 + p[0] ** 2 * sums.holding_torque2
    mixed = 2 * q * (p[1] * sums.driving_torque_alpha + p[-1] * sums.returning_torque_alpha)
    rotor = q**2 * sums.alpha2
    columns = np.stack((squares + (mixed + rotor * J_x) * J_x, mixed + 2 * rotor * J_x, rotor)) / sums.time
    table, unknown = _continuous(made, sums.angle / sums.time)
    J_M = made.rotor
    rows = np.where(made.rotor_unknown, 0.0, 1.0)[:, None] * np.stack((np.ones_like(J_M), J_M, J_M**2), axis=1)
    term = TableTerm("effective_torque", rows, columns, table, made.gears.ratios[1])
    made.add(term, unknown | made.rotor_unknown, made.gears.incomplete)


def _continuous(made: ServoTerms, speed: float) -> tuple[FloatArray, BoolArray]:
    """Reciprocal square of S1 at a speed of the output shaft, shape (motors, ratios), and which motors lack it."""
    table = made.motors.continuous.table(made.gears.ratios[0] * speed)
    unknown: BoolArray = np.asarray(np.isnan(table).any(axis=1))
    return reciprocal(table) ** 2, unknown


def _add_peak(made: ServoTerms) -> None:
    scale = made.rules.peak_reserve * reciprocal(made.motors.flat_peak) * ~made.rotor_unknown
    lines: list[FloatArray] = []
    for direction, envelope in _relevant(made.hull.envelopes).items():
        p = made.factors[direction]
        if envelope.torque.size > MANY_LINES and p[made.complete > 0].min(initial=1.0) > 0:
            made.add(_looked_up(made, envelope, p, scale))
            continue
        for T, alpha in zip(envelope.torque, envelope.acceleration, strict=True):
            lines.append(np.stack((p * T + made.inertia * made.slope * alpha, made.slope * alpha)))
    if not lines:
        lines.append(np.zeros((2, made.gears.ratio.size)))
    rows = np.stack((scale, scale * made.rotor), axis=1)
    unknown = made.motors.peak_unknown | made.rotor_unknown
    made.add(ProductTerm("peak_torque", rows, tuple(lines)), unknown, made.gears.incomplete)
    if made.motors.curved.size:
        made.add(_on_curves(made, "peak_torque", _peak_on_curve))


def _relevant(envelopes: dict[int, Envelope]) -> dict[int, Envelope]:
    """The envelopes without lines that a driving line exceeds for every drive (driving has the largest p)."""
    driving = envelopes[1]
    found = {1: driving}
    for direction in (-1, 0):
        T, alpha = envelopes[direction].torque, envelopes[direction].acceleration
        beaten = (driving.torque[:, None] >= np.maximum(T, 0.0)) & (driving.acceleration[:, None] >= alpha)
        keep = ~beaten.any(axis=0) & ((T > 0) | (alpha > 0))
        found[direction] = Envelope(T[keep], alpha[keep])
    return found


def _looked_up(made: ServoTerms, envelope: Envelope, p: FloatArray, scale: FloatArray) -> EnvelopeTerm:
    T, alpha = envelope.torque, envelope.acceleration
    corners = np.concatenate(([0.0], np.diff(T) / -np.diff(alpha)))
    return EnvelopeTerm(
        key="peak_torque",
        scale=scale,
        rotor=made.rotor,
        inertia=made.inertia,
        factor=p,
        slope=np.divide(made.slope, p, out=np.zeros_like(p), where=p > 0),
        corners=corners,
        heights=T + alpha * corners,
        last=(float(T[-1]), float(alpha[-1])),
    )


def _on_curves(made: ServoTerms, key: str, use: Callable[[ServoTerms, int], FloatArray]) -> RowsTerm:
    """Utilisations of the motors with a peak curve, all gear units."""
    place: IndexArray = np.full(len(made.motors), -1, dtype=np.intp)
    place[made.motors.curved] = np.arange(made.motors.curved.size)
    used = np.array([use(made, int(row)) for row in made.motors.curved])
    return RowsTerm(key, place, used * ~made.rotor_unknown[made.motors.curved][:, None])


def _peak_on_curve(made: ServoTerms, row: int) -> FloatArray:
    """Largest share of its peak curve that one motor uses at any segment end, shape (g,).

    Over a curve that only bends down, the corners of the hull are enough; where it bends up, or the speed leaves it,
    all points are looked at.
    """
    limit = made.motors.limits[row]
    inside = made.gears.ratio * made.hull.max_speed <= limit.motor.peak_curve[-1][0]
    found: FloatArray = np.zeros(made.gears.ratio.size)
    for columns, points in ((inside, made.hull.vertices), (~inside, made.hull.points)):
        chosen = np.flatnonzero(columns)
        cloud = points if _bends_down(limit) else made.hull.points
        for direction, rows in cloud.items() if chosen.size else ():
            for start in range(0, len(rows), _POINTS_AT_ONCE):
                used = _use_of_points(made, row, direction, rows[start : start + _POINTS_AT_ONCE], chosen)
                found[chosen] = np.maximum(found[chosen], used)
    return made.rules.peak_reserve * found


def _use_of_points(made: ServoTerms, row: int, direction: int, points: FloatArray, columns: IndexArray) -> FloatArray:
    T, alpha, omega = (points[:, k, None] for k in range(3))
    inertia = (made.rotor[row] + made.inertia[columns]) * made.slope[columns]
    torque = np.abs(made.factors[direction][columns] * T + inertia * alpha)
    available = made.motors.limits[row].peak(made.gears.ratio[columns] * omega)
    return np.asarray((torque * reciprocal(available)).max(axis=0))


def _bends_down(limit: ServoLimits) -> bool:
    """Whether the peak curve, flat before its first point, is nowhere convex."""
    curve = np.array(limit.motor.peak_curve)
    slopes = np.concatenate(([0.0], np.diff(curve[:, 1]) / np.diff(curve[:, 0])))
    starts_at_standstill = curve[0, 0] == 0
    return bool((np.diff(slopes[1:] if starts_at_standstill else slopes) <= 0).all())


def _add_lachman(made: ServoTerms) -> None:
    motors, gears = made.motors, made.gears
    limit = motors.permitted_speed(made.rules)
    demanded = lachman_motor_speed(gears.ratio * made.hull.max_speed)
    made.product("motor_speed", reciprocal(limit), demanded, np.isnan(limit))
    rotor = np.where(made.rotor_unknown, np.nan, made.rotor)
    least = lachman_motor_inertia(made.external)
    made.product("motor_inertia", reciprocal(rotor), least, made.rotor_unknown, gears.incomplete)
    _add_holding(made)
    _add_lachman_continuous(made)
    _add_lachman_dynamic(made)


def _add_lachman_continuous(made: ServoTerms) -> None:
    """M_1 against S1 at standstill, M_2 at rapid speed, M_3 at working speed, each with the tolerance."""
    statics, tolerance = made.load.statics, 1 + made.rules.continuous_tolerance
    friction = lachman_friction_torque(made.one_torque(statics.friction, 1.0), made.rules.friction_share)
    steady = np.maximum(np.abs(made.one_torque(statics.forward, 1.0)), np.abs(made.one_torque(statics.backward, -1.0)))
    stall = made.motors.continuous.stall
    made.product("friction_torque", reciprocal(stall), friction / tolerance, np.isnan(stall), made.gears.incomplete)
    demands = (
        ("rest_torque", steady, statics.rapid_speed),
        ("working_torque", made.one_torque(abs(statics.working), 1.0), statics.working_speed),
    )
    for key, demand, speed in demands:
        table, unknown = _continuous(made, speed)
        columns = (demand / tolerance)[None, :] ** 2
        made.add(TableTerm(key, None, columns, table, made.gears.ratios[1]), unknown, made.gears.incomplete)


def _add_lachman_dynamic(made: ServoTerms) -> None:
    """1.2 * ((J_M + J_ext) * epsilon + M_P) against the peak torque."""
    epsilon = made.slope * made.hull.max_acceleration
    working = made.one_torque(abs(made.load.statics.working), 1.0)
    still = lachman_peak_torque(lachman_dynamic_torque(made.external, epsilon, working))
    per_rotor = lachman_peak_torque(epsilon)
    scale = reciprocal(made.motors.flat_peak) * ~made.rotor_unknown
    rows = np.stack((scale, scale * made.rotor), axis=1)
    term = ProductTerm("dynamic_peak_torque", rows, (np.stack((still, per_rotor)),))
    made.add(term, made.motors.peak_unknown | made.rotor_unknown, made.gears.incomplete)

    def on_curve(case: ServoTerms, row: int) -> FloatArray:
        available = case.motors.limits[row].peak(case.gears.ratio * case.hull.max_speed)
        return np.asarray((still + per_rotor * case.rotor[row]) * reciprocal(available))

    if made.motors.curved.size:
        made.add(_on_curves(made, "dynamic_peak_torque", on_curve))
