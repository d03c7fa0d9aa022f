"""The report: complete, the same bytes each time, and inert whatever its texts hold."""

import re

import pytest
import typst as typst_compiler

from app.engine.sheet import Sheet
from app.reports.pdf import Chart, Report, Table, report_pdf, report_source
from tests.reports.examples import sample_effective_torque, sample_sheet
from tests.reports.test_sheet_view import hostile_sheet

SVG = (
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 200 80"><path d="M10 70L60 10L190 70" fill="none"/>'
    '<text x="20" y="40" font-size="9">n "1/min" \\ # $</text></svg>'
)


def full_report(title: str = "X axis", sheet: Sheet | None = None) -> Report:
    return Report(
        title=title,
        sheet=sheet or sample_sheet(),
        title_block=(("Axis", "X"), ("Engine version", "0.1.0"), ("Catalogue edition", "example 2001")),
        inputs=(("wheel diameter", "D", "250 mm"), ("bearing friction", "mu_L", "0.005"), ("mounting", "", "fixed")),
        drawing=SVG,
        charts=(Chart("Torque over speed", SVG),),
        tables=(
            Table(
                "Alternatives", ("Motor", "Utilisation"), (("1FT5 106", "84 %"), ("1FT5 108", "60 %")), frozenset({1})
            ),
            Table("Wide", tuple("abcdefgh"), (tuple("12345678"),)),
            Table("Empty", ("a",), ()),
        ),
        warnings=("The brake was not checked.",),
    )


def words(source: str) -> list[str]:
    """All texts of a Typst source."""
    return re.findall(r'"((?:[^"\\]|\\.)*)"', source)


def test_the_same_report_gives_the_same_bytes() -> None:
    first = report_pdf(full_report())
    assert first.startswith(b"%PDF-")
    assert report_pdf(full_report()) == first
    assert b"CreationDate" not in first


def test_everything_is_in_the_report() -> None:
    found = words(report_source(full_report()))
    for text in (
        "X axis", "Engine version", "Catalogue edition", "250 mm", "Effective torque", "44.7 %", "✓ holds", "✗ fails",
        "Radial force: permitted radial force", "Torque over speed", "1FT5 106", "rim friction", "fixed free",
        "Resistance of a wheeled load", "Rolling friction only", "the rail is level & <dry>", "Resistance", "Cycle",
        "The brake was not checked.", "32.177", "Verdict", "fails (1 holds, 1 tight, 1 fails, 1 not checked)",
    ):  # fmt: skip
        assert text in found, text
    assert "Empty" not in found


def test_a_report_has_as_many_pages_as_it_needs() -> None:
    sheet = Sheet()
    for number in range(200):
        sheet.decide(f"decision {number}", "reason")
    few, many = (
        typst_compiler.compile(report_source(Report("a", made)).encode(), format="svg") for made in (Sheet(), sheet)
    )
    assert not isinstance(few, list)
    assert isinstance(many, list)
    assert len(many) > 4


def test_a_line_wider_than_the_page_is_fitted_to_it() -> None:
    sheet = Sheet()
    values = [1.2345e-7 * (n + 1) for n in range(5)]
    sheet(sample_effective_torque, M_k=values, t_k=values)
    assert "fitted[$ = sqrt(" in report_source(Report("a", sheet))
    assert "fitted[$ F_F" not in report_source(full_report())
    assert report_pdf(Report("a", sheet)).startswith(b"%PDF-")


HOSTILE = '#panic("x") $ ] ) " \\" \\ @ref <label> [*b*] // /* `raw` \u0000 \u202e {{ }} \n\n= Heading'


def test_no_text_becomes_code() -> None:
    report = Report(
        HOSTILE, hostile_sheet(), ((HOSTILE, HOSTILE),), ((HOSTILE, HOSTILE, HOSTILE),), SVG, (Chart(HOSTILE, SVG),),
        (Table(HOSTILE, (HOSTILE, HOSTILE), ((HOSTILE, HOSTILE),)),), (HOSTILE,), "en",
    )  # fmt: skip
    assert report_pdf(report).startswith(b"%PDF-")


def test_a_title_in_another_script_is_set() -> None:
    assert report_pdf(Report("升降机 подъём řízení ölçüm", Sheet())).startswith(b"%PDF-")


def test_headings_are_translated() -> None:
    source = report_source(full_report(), lambda text: {"Checks": "Nachweise", "Page": "Seite"}.get(text, text))
    assert "Nachweise" in words(source)
    assert "Seite" in words(source)
    assert "Checks" not in words(source)


def test_a_drawing_that_is_no_svg_is_refused() -> None:
    with pytest.raises(typst_compiler.TypstError):
        report_pdf(Report("a", Sheet(), drawing="no picture"))
