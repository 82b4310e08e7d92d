"""A browser behind WebDriver (W3C), over the standard library: for the engine that Playwright's
wheel does not drive as Debian has it, WebKitGTK.

Only what the tests of lessons need: go somewhere, ask the page, press and type as a reader does.
"""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.error import HTTPError
from urllib.request import Request, urlopen

ELEMENT = "element-6066-11e4-a52e-4f735466cecf"  # the key that the standard gives to elements
HEARD = 120.0
"""s after which the driver itself is taken for dead; a page has its own patience."""
STEP = 0.05  # s between two looks at a page
CENTRE = """const it = document.querySelector(arguments[0]);
  return (async () => {
    for (let same = 0, last = 0, k = 0; same < 3 && k < 200; k += 1) {
      it.scrollIntoView({ block: "center", behavior: "instant" });
      await new Promise(requestAnimationFrame);
      const { y } = it.getBoundingClientRect();
      same = y === last ? same + 1 : 0;
      last = y;
    }
  })()"""


class DriverError(Exception):
    """What the driver refused, in its own words."""


@dataclass(frozen=True)
class Session:
    """A browser's window: `address` of the session at its driver, folder of its downloads."""

    address: str
    downloads: Path

    @classmethod
    def start(cls, driver: str, capabilities: dict[str, Any], downloads: Path) -> Session:
        """A new window. `driver`: address of the driver. Raises DriverError."""
        asked = {"capabilities": {"alwaysMatch": capabilities}}
        made = _ask("POST", f"{driver}/session", asked)
        return cls(f"{driver}/session/{made['sessionId']}", downloads)

    def go(self, url: str) -> None:
        """Open a page and wait until it is loaded."""
        self._post("url", {"url": url})

    def reload(self) -> None:
        self._post("refresh", {})

    def run(self, script: str, *arguments: Any) -> Any:
        """The value that a function's body returns in the page; a promise is waited for."""
        return self._post("execute/sync", {"script": script, "args": list(arguments)})

    def wait(self, script: str, seconds: float, *arguments: Any) -> Any:
        """The first true value of the function's body. Raises TimeoutError."""
        return soon(lambda: self.run(script, *arguments), seconds, script)

    def click(self, css: str) -> None:
        """Press an element when the page has come to rest with it in the middle."""
        self.run(CENTRE, css)
        self._post(f"element/{self._find(css)}/click", {})

    def type(self, css: str, text: str) -> None:
        self._post(f"element/{self._find(css)}/value", {"text": text})

    def fresh(self) -> None:
        """Go on in a new window of the same browser, with what it has kept."""
        made = self._post("window/new", {"type": "window"})
        _ask("DELETE", f"{self.address}/window")
        self._post("window", {"handle": made["handle"]})

    def close(self) -> None:
        _ask("DELETE", self.address)

    def _find(self, css: str) -> str:
        found = self._post("element", {"using": "css selector", "value": css})
        return str(found[ELEMENT])

    def _post(self, command: str, body: dict[str, Any]) -> Any:
        return _ask("POST", f"{self.address}/{command}", body)


def soon(look: Callable[[], Any], seconds: float, what: str) -> Any:
    """The first true value of `look`. Raises TimeoutError, in the words `what`."""
    end = time.monotonic() + seconds
    while not (value := look()):
        if time.monotonic() > end:
            raise TimeoutError(f"not within {seconds:g} s: {what}")
        time.sleep(STEP)
    return value


def _ask(method: str, address: str, body: dict[str, Any] | None = None) -> Any:
    sent = None if body is None else json.dumps(body).encode()
    request = Request(address, sent, {"Content-Type": "application/json"}, method=method)
    try:
        with urlopen(request, timeout=HEARD) as response:
            return json.load(response)["value"]
    except HTTPError as refused:
        told = json.load(refused)["value"]
        raise DriverError(f"{told['error']}: {told['message']}") from None
