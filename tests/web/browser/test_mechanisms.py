"""Every mechanism that is registered, chosen on the first page: its form, its drawing, and no error of the browser."""

from typing import TYPE_CHECKING

import pytest

from app.engine.mechanisms import mechanisms
from app.web.form_models import border

if TYPE_CHECKING:
    from playwright.sync_api import Page

KINDS = list(mechanisms())
CONTROLS = "input:not([type=hidden]), select, textarea"


def choose(page: "Page", kind: str) -> None:
    """Open the workbench of a mechanism from its card, with the keyboard."""
    page.goto("/")
    page.locator(f'.cards a[href="/workbench/{kind}"]').press("Enter")
    page.wait_for_url(f"**/workbench/{kind}")
    page.wait_for_load_state("networkidle")


@pytest.mark.parametrize("kind", KINDS)
def test_a_mechanism_shows_its_form(page: "Page", complaints: list[str], kind: str) -> None:
    model = mechanisms()[kind]
    choose(page, kind)
    assert page.locator("h1").inner_text() == model.title
    required = [border(name, info) for name, info in model.model_fields.items() if info.is_required()]
    assert required
    for name in required:
        # an entry, a list with its first row, or a choice between parts
        entry = page.locator(f'[name="mechanism.{name}"], [name^="mechanism.{name}."]').locator("visible=true")
        assert entry.count() >= 1, name
    unlabelled = page.locator("#axis").evaluate(
        f"form => [...form.querySelectorAll('{CONTROLS}')].filter((one) => !one.labels?.length).map((one) => one.name)"
    )
    assert unlabelled == []
    needed = page.locator(".needed-list a")
    assert needed.count() >= len(required)
    for target in needed.evaluate_all("links => links.map((link) => link.hash)"):
        assert page.locator(target).count() == 1, target
    assert complaints == []


@pytest.mark.parametrize("kind", KINDS)
def test_a_mechanism_shows_its_drawing(page: "Page", complaints: list[str], kind: str) -> None:
    choose(page, kind)
    drawing = page.locator("figure.drawing > svg")
    assert drawing.count() == 1
    box = drawing.bounding_box()
    assert box is not None
    assert min(box["width"], box["height"]) > 100
    shape = "[...drawing.querySelectorAll('path, rect, circle, line, polygon, ellipse')]"
    drawn = drawing.evaluate(f"drawing => {shape}.filter((one) => one.getBoundingClientRect().width > 0).length")
    assert drawn > 5
    # its letters are symbols of the form, and stand inside of it
    symbols = drawing.locator("[data-symbol]")
    letters = symbols.evaluate_all("all => all.map((one) => one.dataset.symbol)")
    entries = page.locator("#axis [data-symbol]").evaluate_all("all => all.map((one) => one.dataset.symbol)")
    assert len(set(letters) & set(entries)) >= 3
    outside = symbols.evaluate_all(
        """(all, [x, y, width, height]) => all.filter((one) => {
          const box = one.getBoundingClientRect();
          return box.left < x - 1 || box.top < y - 1 || box.right > x + width + 1 || box.bottom > y + height + 1;
        }).map((one) => one.dataset.symbol)""",
        [box["x"], box["y"], box["width"], box["height"]],
    )
    assert outside == []
    assert page.locator("figure.drawing svg title").text_content()
    assert complaints == []


def test_every_mechanism_has_its_card(page: "Page", complaints: list[str]) -> None:
    page.goto("/")
    links = page.locator(".cards a").evaluate_all("all => all.map((one) => one.getAttribute('href'))")
    assert sorted(links) == sorted(f"/workbench/{kind}" for kind in KINDS)
    pictures = page.locator(".cards img")
    assert pictures.count() == len(KINDS)
    for index in range(len(KINDS)):
        pictures.nth(index).scroll_into_view_if_needed()
    page.wait_for_function("() => [...document.querySelectorAll('.cards img')].every((one) => one.naturalWidth > 0)")
    assert complaints == []
