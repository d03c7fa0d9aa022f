"""A reader who is quicker than the server: no choice is lost, and nothing that was typed."""

from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from playwright.sync_api import Page, Route

RAILS = "/workbench/travel_drive?mechanism.vehicle_mass_kg=1500&mechanism.wheel_diameter_mm=250"
MASS = '[name="mechanism.vehicle_mass_kg"]'
KIND = '[name="drive.kind"]'
PAUSE_MS = 600
"""Longer than the page waits behind a letter before it calculates."""


@pytest.fixture
def held(page: "Page") -> "list[Route]":
    """The first request for a new form, which waits until the test lets it go; later ones are not held up."""
    found: list[Route] = []
    page.route("**/form", lambda route: route.continue_() if found else found.append(route))
    page.goto(RAILS)
    page.wait_for_load_state("networkidle")
    return found


def let_go(page: "Page", held: "list[Route]", after_ms: float = 0) -> None:
    """Let the request go that was held up."""
    page.wait_for_timeout(after_ms)
    assert held
    held[0].continue_()


def type_a_zero(page: "Page") -> None:
    """Make 15000 kg of 1500 kg."""
    page.locator(MASS).focus()
    page.keyboard.press("End")
    page.keyboard.type("0")


def press_down(page: "Page", times: int = 1) -> None:
    """Choose the next kind of drive, or the one after it."""
    page.locator(KIND).focus()
    for _ in range(times):
        page.keyboard.press("ArrowDown")


def rebuilt_for(page: "Page", kind: str) -> bool:
    """Wait for the entries of a kind of drive; whether the choice says the same."""
    page.locator(f'details[data-keep^="drive-{kind}-"]').first.wait_for(state="attached")
    return page.locator(KIND).input_value() == kind


def test_a_choice_right_behind_an_entry_is_not_lost(page: "Page", held: "list[Route]") -> None:
    """The calculation that the letter asked for comes due while the form of the choice is on its way."""
    type_a_zero(page)
    press_down(page)
    let_go(page, held, PAUSE_MS)
    assert rebuilt_for(page, "inverter_fed")
    assert page.locator(MASS).input_value() == "15000"


@pytest.mark.parametrize("after_ms", [0, PAUSE_MS])
def test_what_is_typed_while_the_form_is_rebuilt_is_kept(page: "Page", held: "list[Route]", after_ms: float) -> None:
    press_down(page)
    type_a_zero(page)
    let_go(page, held, after_ms)
    assert rebuilt_for(page, "inverter_fed")
    assert page.locator(MASS).input_value() == "15000"
    assert page.evaluate("document.activeElement.name") == "mechanism.vehicle_mass_kg"


def test_the_last_of_two_quick_choices_counts(page: "Page", held: "list[Route]") -> None:
    press_down(page, times=2)
    let_go(page, held, PAUSE_MS)
    assert rebuilt_for(page, "mains")
    assert page.evaluate("document.activeElement.name") == "drive.kind"
