"""The view of a sheet, and the page fragment made of it."""

from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree

import jinja2
import pytest

import app.engine.formulas  # noqa: F401  (registers every formula)
from app.engine.formula import registered
from app.engine.sheet import Check, Sheet, Verdict
from app.reports.sheet_view import BAR_END, DecisionView, SheetView, StepView, anchor, overall, sheet_view
from tests.reports.examples import sample_effective_torque, sample_rolling_resistance, sample_sheet

TEMPLATES = Path(__file__).parents[2] / "templates"


@pytest.fixture(scope="module")
def view() -> SheetView:
    return sheet_view(sample_sheet())


def render(view: SheetView) -> ElementTree.Element:
    """The fragment as a page would include it; parsed strictly, so it is well-formed too."""
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(TEMPLATES), autoescape=True, undefined=jinja2.StrictUndefined
    )
    environment.globals["_"] = str
    return ElementTree.fromstring(environment.get_template("partials/sheet/sheet.html").render(sheet_view=view))


def text_of(element: ElementTree.Element) -> str:
    return " ".join("".join(element.itertext()).split())


def by_id(page: ElementTree.Element, identifier: str) -> ElementTree.Element:
    found = [element for element in page.iter() if element.get("id") == identifier]
    assert len(found) == 1, identifier
    return found[0]


def test_steps_and_decisions_stand_in_the_order_of_the_calculation(view: SheetView) -> None:
    resistance, cycle = view.sections
    assert (resistance.title, cycle.title) == ("Resistance", "Cycle")
    kinds = [type(item) for item in resistance.items]
    assert kinds == [StepView, DecisionView, StepView]


def test_a_section_that_is_opened_again_is_continued() -> None:
    sheet = Sheet()
    for title in ("A", "B", "A"):
        with sheet.section(title):
            sheet.decide(f"in {title}", "")
    assert [(section.title, len(section.items)) for section in sheet_view(sheet).sections] == [("A", 2), ("B", 1)]


def test_a_step_tells_its_value_inputs_and_formula(view: SheetView) -> None:
    step = view.sections[0].items[0]
    assert isinstance(step, StepView)
    assert (step.anchor, step.value, step.label) == (
        "step-sample_rolling_resistance", "32.177 N", "Resistance of a wheeled load",
    )  # fmt: skip
    assert step.summary == ""
    given = {item.symbol_text: (item.meaning, item.value) for item in step.inputs}
    assert given["m"] == ("mass", "400 kg")
    assert given["μ_L"][1] == "0.005"
    assert [line.count("<math ") for line in step.lines] == [1, 1]
    assert "&lt;dry&gt;" in step.notes[0]
    assert "Raises" not in "".join(step.notes)


def test_a_label_of_its_own_leaves_the_summary_to_the_details(view: SheetView) -> None:
    back = view.sections[0].items[2]
    assert isinstance(back, StepView)
    assert (back.anchor, back.label, back.symbol_text, back.value) == (
        "step-back",
        "Torque going back",
        "M_b",
        "−1.8 N·m",
    )
    assert back.summary == "Torque before a stage, by direction of power."


def test_the_first_clause_of_a_summary_heads_a_step() -> None:
    sheet = Sheet()
    sheet(registered()["ramp_distance"], v=0.5, t_A=0.2)
    step = sheet_view(sheet).sections[0].items[0]
    assert isinstance(step, StepView)
    assert step.label == "Distance from standstill to a speed, or back"
    assert step.summary.startswith("Distance from standstill to a speed, or back; holds for")


@pytest.mark.parametrize(
    ("key", "shown"), [("friction", "0.003"), ("mount", "fixed free"), ("horizontal", "yes"), ("wheel", "250 mm")]
)
def test_an_assumption_is_shown_whatever_its_kind(view: SheetView, key: str, shown: str) -> None:
    assert {item.key: item.value for item in view.assumptions}[key] == shown


def test_what_is_assumed_of_every_move_is_one_line() -> None:
    sheet = Sheet()
    for move in range(3):
        sheet.assume(f"moves.{move}.profile", "course of the speed", value="trapezoid")
    sheet.assume("moves.3.profile", "course of the speed", value="s_curve")
    view = sheet_view(sheet)
    assert [(item.value, item.count) for item in view.assumptions] == [("trapezoid", 3), ("s curve", 1)]
    assert "course of the speed × 3" in text_of(render(view))


def test_details_may_be_left_out() -> None:
    step = sheet_view(sample_sheet(), notes=False).sections[0].items[0]
    assert isinstance(step, StepView)
    assert (step.inputs, step.notes) == ((), ())


@pytest.mark.parametrize(
    ("value", "shown"),
    [
        (None, ""),
        (3, "3"),
        (False, "no"),
        ("", "–"),
        ([1.5, 2.0], "1.5; 2"),
        (("a_b", "c"), "a b; c"),
        ({"x"}, "{'x'}"),
    ],
)
def test_an_assumed_value_of_any_kind_has_words(value: object, shown: str) -> None:
    sheet = Sheet()
    sheet.assume("key", "text", value=value)
    assert sheet_view(sheet).assumptions[0].value == shown


def test_checks_have_a_verdict_in_words_and_a_bar(view: SheetView) -> None:
    shown = {check.key: check for check in view.checks}
    assert [shown[key].verdict for key in ("torque", "peak", "speed", "shaft")] == [
        "ok",
        "tight",
        "fails",
        "not_checked",
    ]
    assert shown["torque"].utilisation == "44.7 %"  # 2.236 / 5
    assert shown["torque"].bar == pytest.approx(44.72 / BAR_END, abs=0.06)
    assert shown["torque"].step_anchor == "step-sample_effective_torque"
    assert (shown["speed"].demanded, shown["speed"].permitted) == ("3000 rpm", "1500 rpm")
    assert (shown["speed"].utilisation, shown["speed"].bar) == ("200 %", 100)
    assert (shown["shaft"].permitted, shown["shaft"].utilisation, shown["shaft"].bar) == ("–", "–", 0)
    assert shown["shaft"].missing == "permitted radial force"
    assert len({check.icon for check in view.checks}) == 4
    assert view.counts == {"ok": 1, "tight": 1, "fails": 1, "not_checked": 1}
    assert view.verdict == "fails"


@pytest.mark.parametrize("permitted", [0.0, -1.0])
def test_a_demand_that_meets_nothing_permitted_fills_the_bar(permitted: float) -> None:
    sheet = Sheet()
    sheet.check("key", "name", 1.0, permitted, "N", "")
    check = sheet_view(sheet).checks[0]
    assert (check.utilisation, check.bar, check.verdict) == ("∞", 100, "fails")


@pytest.mark.parametrize(
    ("verdicts", "worst"),
    [
        ([], Verdict.NOT_CHECKED),
        ([Verdict.OK, Verdict.OK], Verdict.OK),
        ([Verdict.TIGHT, Verdict.OK], Verdict.TIGHT),
        ([Verdict.NOT_CHECKED, Verdict.NOT_CHECKED], Verdict.NOT_CHECKED),
        ([Verdict.NOT_CHECKED, Verdict.OK], Verdict.OK),
        ([Verdict.FAILS, Verdict.NOT_CHECKED], Verdict.FAILS),
    ],
)
def test_the_worst_verdict_counts(verdicts: list[Verdict], worst: Verdict) -> None:
    assert overall(verdicts) == worst


def test_every_text_is_translated() -> None:
    seen: set[str] = set()

    def translate(text: str) -> str:
        seen.add(text)
        return text.upper()

    view = sheet_view(sample_sheet(), translate)
    assert view.sections[0].title == "RESISTANCE"
    assert view.checks[0].name == "EFFECTIVE TORQUE"
    assert view.checks[0].verdict_word == "HOLDS"
    assert {"rim friction", "Rolling friction only", "mass", "permitted radial force", "otherwise"} <= seen
    assert view.checks[0].verdict == "ok"


def test_an_empty_text_is_never_looked_up() -> None:
    """To gettext the empty text is the header of the catalogue: it would land in the page."""
    sheet = sample_sheet()
    sheet.decide("decision", "")

    def translate(text: str) -> str:
        assert text
        return text

    assert sheet_view(sheet, translate) == sheet_view(sheet)


def test_anchors_suit_an_address() -> None:
    assert anchor("step", "a#2 b/ü") == "step-a-2-b"


def test_the_page_shows_every_part(view: SheetView) -> None:
    page = render(view)
    assert "32.177 N" in text_of(by_id(page, "step-sample_rolling_resistance"))
    assert "the rail is level & <dry>" in text_of(page)
    assert "data sheet <p. 3>" in text_of(by_id(page, "check-torque"))
    assert "tight" in text_of(by_id(page, "check-peak"))
    assert "Missing: permitted radial force" in text_of(by_id(page, "check-shaft"))
    assert "250 mm" in text_of(by_id(page, "assumption-wheel"))


def test_every_identifier_is_unique_and_every_link_leads_somewhere(view: SheetView) -> None:
    page = render(view)
    identifiers = [identifier for element in page.iter() if (identifier := element.get("id"))]
    assert len(identifiers) == len(set(identifiers))
    targets = [str(element.get("href")) for element in page.iter("a")]
    assert [target for target in targets if target.startswith("#")] == ["#step-sample_effective_torque"]
    assert all(target[1:] in identifiers for target in targets if target.startswith("#"))
    assert "/formulas#formula-sample_effective_torque" in targets


def test_an_empty_sheet_says_so() -> None:
    shown = text_of(render(sheet_view(Sheet())))
    assert "Nothing was checked." in shown
    assert "Nothing was assumed" in shown


HOSTILE = "<script>alert('x')</script>&\"{{ 7*7 }}"


def hostile_sheet() -> Sheet:
    sheet = Sheet()
    with sheet.section(HOSTILE):
        sheet(sample_effective_torque, M_k=[1.0], t_k=[1.0], key=HOSTILE, symbol=HOSTILE, label=HOSTILE)
        sheet.decide(HOSTILE, HOSTILE)
        sheet.check(HOSTILE, HOSTILE, 1.0, None, "N", HOSTILE, missing=HOSTILE)
    sheet.assume(HOSTILE, HOSTILE, value=HOSTILE, symbol=HOSTILE, source=HOSTILE)
    return sheet


def test_no_text_becomes_markup() -> None:
    page = render(sheet_view(hostile_sheet()))
    assert not list(page.iter("script"))
    assert text_of(page).count(HOSTILE) >= 8
    assert "49" not in text_of(page)


@pytest.mark.parametrize("make", [sample_sheet, hostile_sheet, Sheet])
def test_a_view_is_the_same_each_time(make: Callable[[], Sheet]) -> None:
    assert sheet_view(make()).checks == sheet_view(make()).checks
    assert ElementTree.tostring(render(sheet_view(make()))) == ElementTree.tostring(render(sheet_view(make())))


def test_a_check_may_name_the_key_of_its_step() -> None:
    sheet = Sheet()
    sheet(sample_rolling_resistance, m=1.0, g=9.81, D=1.0, mu_L=0.0, d=0.1, f=0.0, c=0.1, key="drag")
    sheet.checks.append(Check("c", "Drag", 1.0, 2.0, "N", "", formula="drag"))
    assert sheet_view(sheet).checks[0].step_anchor == "step-drag"
