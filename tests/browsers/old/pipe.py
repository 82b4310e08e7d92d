"""A browser of any age behind its debugging pipe: file descriptors 3 and 4, messages ended by 0.

Playwright's own commands are newer than these browsers; the few used here are the oldest.
"""

from __future__ import annotations

import json
import os
import select
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

FLAGS = (
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run",
    "--remote-debugging-pipe", "--window-size=1280,900",
)  # fmt: skip
ANSWERED = 60.0  # s; a browser that says nothing for so long is dead


@dataclass
class Pipe:
    """Commands to a page and their results, in turn."""

    out: int
    into: int
    session: str = ""
    _last: int = 0
    _rest: bytes = field(default=b"")

    def ask(self, method: str, **parameters: Any) -> dict[str, Any]:
        """The result of a command. Raises TimeoutError, or RuntimeError in the browser's words."""
        self._last += 1
        message: dict[str, Any] = {"id": self._last, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.out, json.dumps(message).encode() + b"\0")
        while (heard := self._next()).get("id") != self._last:
            pass
        if "error" in heard:
            raise RuntimeError(heard["error"]["message"])
        return dict(heard["result"])

    def run(self, script: str) -> Any:
        """The value of an expression in the page; a promise is waited for."""
        asked = {"expression": script, "returnByValue": True, "awaitPromise": True}
        result = self.ask("Runtime.evaluate", **asked)
        return result["result"].get("value")

    def _next(self) -> dict[str, Any]:
        while b"\0" not in self._rest:
            if not select.select([self.into], [], [], ANSWERED)[0]:
                raise TimeoutError(f"the browser said nothing in {ANSWERED:g} s")
            self._rest += os.read(self.into, 1 << 16)
        message, _, self._rest = self._rest.partition(b"\0")
        return dict(json.loads(message))


@contextmanager
def browser(program: Path, profile: Path) -> Iterator[Pipe]:
    """An empty page of a browser; it is ended afterwards."""
    its_in, our_out = os.pipe()
    our_in, its_out = os.pipe()

    def at_three_and_four() -> None:
        low, high = os.dup(its_in), os.dup(its_out)  # not 3 or 4 themselves, whatever they are
        os.dup2(low, 3)
        os.dup2(high, 4)

    command = [str(program), *FLAGS, f"--user-data-dir={profile}", "about:blank"]
    with subprocess.Popen(
        command, preexec_fn=at_three_and_four, close_fds=False,  # noqa: PLW1509 - no other thread
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    ) as process:  # fmt: skip
        os.close(its_in)
        os.close(its_out)
        try:
            yield _attached(Pipe(our_out, our_in))
        finally:
            process.terminate()
            os.close(our_out)
            os.close(our_in)


def _attached(pipe: Pipe) -> Pipe:
    """Steer the first page, once it is there."""
    end = time.monotonic() + ANSWERED
    while time.monotonic() < end:
        for target in pipe.ask("Target.getTargets")["targetInfos"]:
            if target["type"] == "page":
                its = {"targetId": target["targetId"], "flatten": True}
                pipe.session = pipe.ask("Target.attachToTarget", **its)["sessionId"]
                return pipe
        time.sleep(0.1)
    raise TimeoutError("the browser has no page")
