"""Shapes of answers, for OpenAPI and generated clients. Numbers are in the unit named beside them, or SI where said."""

from typing import Annotated, Any, Generic, Literal, TypeVar

from pydantic import BaseModel, ConfigDict, Field

from app.services.requests import SelectionRequest

T = TypeVar("T")
VerdictName = Literal["ok", "tight", "fails", "not_checked"]


class Answer(BaseModel):
    """Base of all answers."""

    model_config = ConfigDict(from_attributes=True, json_schema_serialization_defaults_required=True)


class Page(Answer, Generic[T]):
    """One page of a list."""

    items: list[T]
    total: int = Field(description="How many there are in all")
    limit: int
    offset: int


# Mechanisms ----------------------------------------------------------------------------------------------------------
class MechanismSummary(Answer):
    """One kind of mechanism."""

    kind: str
    title: str
    summary: str
    drawing: str = Field(description="Address of the drawing that carries the symbols of the fields")
    motion_kind: Literal["linear", "rotary"]


class MechanismDetail(MechanismSummary):
    """One kind of mechanism with its inputs."""

    input_schema: dict[str, Any] = Field(description="JSON schema of its inputs, with x-unit, x-symbol and x-source")
    defaults: dict[str, Any] = Field(description="Default of every input that has one, under its border name")


# Sizing --------------------------------------------------------------------------------------------------------------
class StepAnswer(Answer):
    """One evaluated formula."""

    key: str
    section: str
    label: str
    symbol: str
    value: float = Field(description="In `unit`")
    unit: str
    value_si: float
    formula: str = Field(description="Name in the formula library")
    source: str
    inputs: dict[str, Any] = Field(description="SI values put into the formula, by argument")


class CheckAnswer(Answer):
    """A demand against what is permitted; it holds when demanded <= permitted."""

    key: str
    name: str
    section: str
    verdict: VerdictName
    utilisation: float | None = Field(description="demanded / permitted; null where not checked or nothing permitted")
    demanded: float | None = Field(description="In `unit`")
    permitted: float | None = Field(description="In `unit`")
    unit: str
    source: str
    formula: str
    missing: str = Field(description="What is not known, when the check could not be made")


class AssumptionAnswer(Answer):
    """A value that was not given: what was taken instead, and from where."""

    key: str = Field(description="Path of the input that would confirm or replace it, or a name of its own")
    text: str
    symbol: str
    value: Any = Field(description="In `unit` for a quantity, the choice itself otherwise")
    unit: str
    source: str


class DecisionAnswer(Answer):
    """A branch that was taken, and why."""

    section: str
    text: str
    reason: str


class HeadlineAnswer(Answer):
    """A result that is shown before all others."""

    key: str
    label: str
    symbol: str
    value: float
    unit: str
    value_si: float


class PartAnswer(Answer):
    """A chosen product."""

    id: str = Field(description='Identifier in the catalogue; "own" for values that were typed')
    manufacturer: str
    series: str
    model: str
    source: str


class LoadCycleAnswer(Answer):
    """Load cycle at the output shaft of the drive: one entry per segment."""

    duration_s: list[float]
    speed_start_rpm: list[float]
    speed_end_rpm: list[float]
    torque_nm: list[float]
    braked: list[bool]
    label: list[str]
    inertia_kgm2: float


class CatalogueAnswer(Answer):
    """Which catalogue the parts came from."""

    version: str = Field(description="Changes when another catalogue is loaded; empty where none was needed")
    editions: dict[str, str] = Field(description="Editions of the chosen parts: key and citation")


class SizingAnswer(Answer):
    """One axis, calculated."""

    engine_version: str
    catalogue: CatalogueAnswer
    request: dict[str, Any] = Field(description="The request as it was typed")
    verdict: VerdictName = Field(description="The worst of all checks that could be made; see counts for the others")
    counts: dict[VerdictName, int]
    deciding_check: str | None = Field(description="Key of the check with the highest utilisation")
    headlines: list[HeadlineAnswer]
    parts: dict[str, PartAnswer | None] = Field(
        description="Product of each part of the drive (motor, gear_unit ...); null where none was chosen"
    )
    checks: list[CheckAnswer]
    steps: list[StepAnswer]
    assumptions: list[AssumptionAnswer]
    decisions: list[DecisionAnswer]
    load_cycle: LoadCycleAnswer


class SupplyAxisAnswer(Answer):
    """One axis on a supply."""

    name: str
    verdict: VerdictName


class SupplyAnswer(Answer):
    """Several axes on one supply, calculated."""

    engine_version: str
    verdict: VerdictName
    headlines: list[HeadlineAnswer]
    axes: list[SupplyAxisAnswer]
    checks: list[CheckAnswer]
    steps: list[StepAnswer]
    assumptions: list[AssumptionAnswer]
    decisions: list[DecisionAnswer]


class CalculationAnswer(Answer):
    """Formulas, evaluated."""

    engine_version: str
    steps: list[StepAnswer]


class FigureAnswer(Answer):
    """A Plotly figure."""

    data: list[dict[str, Any]]
    layout: dict[str, Any]


class ChartsAnswer(Answer):
    """Charts of one axis."""

    torque_speed: FigureAnswer | None = Field(description="null where the drive makes its own ramps")
    cycle: FigureAnswer | None = Field(description="null where the drive makes its own ramps")
    diagrams: dict[str, FigureAnswer] = Field(description="Further charts of mechanism and drive by key")


# Selection -----------------------------------------------------------------------------------------------------------
class CandidateAnswer(Answer):
    """One admitted combination of motor and gear unit."""

    rank: int
    motor: PartAnswer
    gear_unit: PartAnswer | None = Field(description="null: the motor drives directly")
    ratio: float
    utilisation: float | None = Field(description="Highest utilisation of all its checks")
    deciding_check: str
    mass_kg: float | None
    rated_torque_nm: float | None
    inertia_ratio: float | None
    utilisations: dict[str, float | None] = Field(description="Utilisation by check; null where it was not checked")
    not_checked: list[str]


class SelectionAnswer(Page[CandidateAnswer]):
    """The admitted candidates, best first; ``total`` counts the admitted ones."""

    evaluated: int
    admitted: int
    rejected: int
    rejected_by: dict[str, int] = Field(description="The rejected ones by the first check that fails")
    ranking: str
    catalogue: CatalogueAnswer
    engine_version: str


class ExplanationRequest(SelectionRequest):
    """A selection, and the candidate whose checks are wanted."""

    motor_id: Annotated[str, Field(min_length=1, max_length=200, description="Motor of the candidate")]
    gear_unit_id: Annotated[str | None, Field(max_length=200, description="Gear unit; null: direct")] = None


class DriveSuggestionAnswer(Answer):
    """A servo drive that carries the currents of a motor."""

    servo_drive: PartAnswer
    peak_current: float | None = Field(description="Utilisation of its peak current")
    continuous_current: float | None = Field(description="Utilisation of its continuous current")
    verdict: VerdictName


class ExplanationAnswer(Answer):
    """Every check of one candidate: why it was admitted or rejected."""

    motor: PartAnswer
    gear_unit: PartAnswer | None
    verdict: VerdictName
    checks: list[CheckAnswer]
    servo_drives: list[DriveSuggestionAnswer] = Field(description="Servo drives that fit, closest fit first")
