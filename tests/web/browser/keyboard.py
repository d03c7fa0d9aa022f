"""A reader without a mouse, who must always see where they are."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from playwright.sync_api import Page

MOST_TABS = 400
"""More steps than any form of this page needs."""
PAUSE_MS = 350
"""Longer than the page waits behind a letter before it calculates."""

LINE_PX = 24
"""Of a long text the browser shows the line that is typed into."""

STOP = """() => {
  const one = document.activeElement;
  if (one === null || one === document.body) return null;
  const held = one.matches("summary") && !one.parentElement.open ? one.parentElement : null;
  const [box] = one.getClientRects();
  const frame = one.closest(".workbench-result")?.getBoundingClientRect();
  const top = Math.max(0, frame?.top ?? 0), bottom = Math.min(innerHeight, frame?.bottom ?? innerHeight);
  const end = box && (one.matches("textarea") ? Math.min(box.bottom, box.top + LINE) : box.bottom);
  const inside = box && box.top >= top - 1 && end <= bottom + 1;
  const across = box && box.height > bottom - top && box.top < bottom && box.bottom > top;
  const place = (one.closest(".field") ?? one).getBoundingClientRect();
  const hit = box && document.elementFromPoint(box.left + box.width / 2, (box.top + end) / 2);
  return {
    tag: one.tagName,
    name: one.name ?? "",
    value: one.value ?? "",
    key: [one.id, one.name, one.name ? "" : one.textContent.trim().slice(0, 40)].filter(Boolean).join(" "),
    folded: held ? [...held.querySelectorAll("[name]")].map((inner) => inner.name) : [],
    seen: Boolean(inside || across) && box.left >= -1 && box.right <= innerWidth + 1,
    below: hit && hit !== one && !one.contains(hit) ? (hit.className || hit.textContent.trim()) : "",
    box: [place.left, place.top + scrollY, place.right, place.bottom + scrollY],
  };
}""".replace("LINE", str(LINE_PX))
"""The element that has the focus, or null."""


@dataclass(frozen=True)
class Stop:
    """Where the focus is."""

    tag: str
    name: str
    value: str
    key: str
    """Tells it apart from the others, and names it in a message."""
    folded: list[str]
    """Controls of the closed group that it would open."""
    seen: bool
    """Whether it lies in the window whole, or fills it; of a long text its first line."""
    below: str
    """What lies over its middle, empty: nothing."""
    box: list[float]
    """Left, top, right and bottom on the page, of an entry with its label."""


class Keyboard:
    """Tab, Shift+Tab, Enter, arrow keys and letters. Pages move without animation, as the reader has asked for."""

    def __init__(self, page: "Page") -> None:
        page.emulate_media(reduced_motion="reduce")
        self._page = page
        self._keys = page.keyboard
        self._typed = False

    def stop(self) -> Stop | None:
        """Where the focus is; fails where it cannot be seen."""
        found = self._page.evaluate(STOP)
        if found is None:
            return None
        stop = Stop(**found)
        assert stop.seen, f"{stop.key} has the focus outside of the window"
        return stop

    def tab(self, *, back: bool = False) -> Stop | None:
        """The next stop, or the one before; None: the page leaves the focus to the browser."""
        self._keys.press("Shift+Tab" if back else "Tab")
        return self.stop()

    def press(self, key: str) -> None:
        """Press a key where the focus is."""
        self._keys.press(key)

    def skip_to_content(self) -> None:
        """Take the first link of the page."""
        self._keys.press("Tab")
        assert self._page.evaluate("document.activeElement.hash") == "#main"
        self._keys.press("Enter")

    def walk(self, until: Callable[[Stop], bool], *, back: bool = False) -> Iterator[Stop]:
        """Every stop from here up to the wanted one, which is the last."""
        for _ in range(MOST_TABS):
            stop = self.tab(back=back)
            if stop is None:
                continue
            yield stop
            if until(stop):
                return
        raise AssertionError("Tab does not lead there")

    def reach(self, name: str, value: str = "") -> None:
        """Tab forward to a control; a closed group around it is opened on the way."""
        stop = self.stop()
        for _ in range(MOST_TABS):
            if stop is not None and stop.name == name and value in ("", stop.value):
                return
            if stop is not None and name in stop.folded:
                self._keys.press("Enter")
            stop = self.tab()
        raise AssertionError(f"Tab does not lead to {name}")

    def reach_element(self, selector: str, between: str = "() => true") -> None:
        """Tab forward to an element that is no entry; at every stop wait until ``between`` holds."""
        matches = "selector => document.activeElement.matches(selector)"
        for _ in self.walk(lambda _: bool(self._page.evaluate(matches, selector))):
            self._page.wait_for_function(between)

    def pause(self) -> None:
        """Look up until what was typed is calculated."""
        self._page.wait_for_timeout(PAUSE_MS if self._typed else 0)
        self._typed = False
        self._page.wait_for_function("() => document.querySelector('[data-calculating]').hidden")

    def choose(self, name: str, value: str) -> None:
        """Choose by arrow keys; the focus stays where it is while the form is rebuilt."""
        self.reach(name)
        self.pause()
        for key in self._presses(name, value):
            if self._page.evaluate("document.activeElement.matches('[data-rebuild]')"):
                with self._page.expect_response("**/form"):
                    self._keys.press(key)
                self._page.wait_for_function("() => document.querySelector('[data-calculating]').hidden")
            else:
                self._keys.press(key)
                self._typed = True
            stop = self.stop()
            assert stop is not None
            assert stop.name == name
        assert self._page.evaluate("document.activeElement.value") == value

    def _presses(self, name: str, value: str) -> Iterator[str]:
        control = self._page.locator(f'[name="{name}"]')
        values = control.evaluate("one => [...one.options].map((option) => option.value)")
        steps = values.index(value) - values.index(control.input_value())
        yield from ["ArrowDown" if steps > 0 else "ArrowUp"] * abs(steps)

    def add(self, name: str) -> None:
        """Add a row to a list; the focus goes into it."""
        self.reach("add", name)
        self.pause()
        with self._page.expect_response("**/form"):
            self._keys.press("Enter")
        self._page.wait_for_function("wanted => document.activeElement.name?.startsWith(wanted)", arg=f"{name}.")

    def type(self, name: str, text: str) -> None:
        """Type into an empty entry."""
        self.reach(name)
        self._keys.type(text)
        self._typed = True

    def fill(self, wanted: Mapping[str, str]) -> None:
        """Enter every value where Tab comes to its control; rows are added where a list has too few."""
        left = dict(wanted)
        stop = self.stop()
        for _ in range(MOST_TABS):
            if stop is not None:
                self._fill_here(stop, left)
            if not left:
                return
            stop = self.tab()
        raise AssertionError(f"Tab does not lead to {', '.join(sorted(left))}")

    def _fill_here(self, stop: Stop, left: dict[str, str]) -> None:
        if stop.name == "add" and any(name.startswith(f"{stop.value}.") for name in left):
            self.add(stop.value)
            found = self.stop()
            assert found is not None
            stop = found
        if any(name in left for name in stop.folded):
            self._keys.press("Enter")
        if stop.name not in left:
            return
        text = left.pop(stop.name)
        if stop.tag == "SELECT":
            self.choose(stop.name, text)
        else:
            self.type(stop.name, text)
