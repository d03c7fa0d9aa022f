"""A real browser for the tests of the pages: the system's Chromium, driven by Playwright."""

import sys
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from app.settings import PROJECT_ROOT

if TYPE_CHECKING:
    from playwright.sync_api import Browser, ConsoleMessage, Page, Response

ARGUMENTS = [
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--disable-dev-shm-usage",
]
WAIT_MS = 15_000


def find_chromium() -> Path:
    """The browser that ``tools/ensure_chromium.py`` finds; fails the test with its advice where there is none."""
    tools = str(PROJECT_ROOT / "tools")
    if tools not in sys.path:
        sys.path.append(tools)
    import ensure_chromium

    found = ensure_chromium.find()
    if found is None:
        pytest.fail(ensure_chromium.ADVICE, pytrace=False)
    return Path(found)


@pytest.fixture(scope="session")
def chromium() -> "Iterator[Browser]":
    """One headless Chromium per worker process."""
    from playwright.sync_api import sync_playwright

    executable = find_chromium()
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=executable, args=ARGUMENTS)
        yield browser
        browser.close()


@pytest.fixture
def page(chromium: "Browser", live_server: str) -> "Iterator[Page]":
    """A fresh page (own cookies, 1280 x 900, English) whose relative addresses lead to ``live_server``.

    The test fails when a script of the page throws.
    """
    context = chromium.new_context(base_url=live_server, viewport={"width": 1280, "height": 900}, locale="en-GB")
    context.set_default_timeout(WAIT_MS)
    new_page = context.new_page()
    script_errors: list[str] = []
    new_page.on("pageerror", lambda error: script_errors.append(str(error)))
    yield new_page
    context.close()
    assert not script_errors, f"a script of the page failed: {script_errors}"


@pytest.fixture
def complaints(page: "Page") -> list[str]:
    """What the browser writes on its console as an error or a warning, and what it does not find."""
    found: list[str] = []

    def note(message: "ConsoleMessage") -> None:
        if message.type in ("error", "warning"):
            found.append(message.text)

    def missing(response: "Response") -> None:
        if response.status >= 400:
            found.append(f"{response.status} {response.url}")

    page.on("console", note)
    page.on("response", missing)
    return found


@pytest.fixture
def page_without_scripts(chromium: "Browser", live_server: str) -> "Iterator[Page]":
    """Like ``page`` with JavaScript switched off."""
    context = chromium.new_context(base_url=live_server, java_script_enabled=False, locale="en-GB")
    context.set_default_timeout(WAIT_MS)
    yield context.new_page()
    context.close()
