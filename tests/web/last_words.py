"""What a page says of itself when its test fails: on another machine nobody can look at it."""

from __future__ import annotations

import time

from playwright.sync_api import Error, Page

LONGEST = 300  # signs of one line
# Python's state, then every part of the page that has one, and what it tells its reader.
STATES = """() => [
  `Python: ${document.documentElement.dataset.python ?? "not asked for"}`,
  ...[...document.querySelectorAll("[data-state]")].map(
    (one) => `${one.localName}.${one.className} #${one.id}: ${one.dataset.state}`),
  ...[...document.querySelectorAll("[role=alert], [role=status]")]
    .filter((one) => one.textContent.trim())
    .map((one) => `${one.role}: ${one.textContent.trim()}`),
]"""


class LastWords:
    """Listens to one page from its first moment, and asks it at the end."""

    def __init__(self, page: Page) -> None:
        self._page = page
        self._heard: list[str] = []
        opened = time.monotonic()

        def hear(kind: str, text: str) -> None:
            self._heard.append(f"{time.monotonic() - opened:6.1f} s  {kind}: {text}"[:LONGEST])

        page.on("console", lambda said: hear(said.type, said.text))
        page.on("pageerror", lambda error: hear("error", str(error)))
        page.on("crash", lambda _: hear("crash", "the page is gone"))

    def tell(self) -> str:
        try:
            states = [str(line)[:LONGEST] for line in self._page.evaluate(STATES)]
        except Error as silent:
            states = [f"it does not answer: {silent.message[:LONGEST]}"]
        return "\n".join([self._page.url, *states, *self._heard])
