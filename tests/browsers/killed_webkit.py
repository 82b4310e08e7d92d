"""WebKit that is killed while a reader types, and what it has lost: `make bench AREA=answers`.

It needs what `_kept_window.py` names; where that is missing nothing is measured, and it says so.
"""

from __future__ import annotations

import json
import os
import random
import signal
import subprocess
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from tests.web.question.killed_browser import pause

from .webdriver import soon
from .webkit import screen

SYSTEM_PYTHON = "/usr/bin/python3"
GI = "import gi; gi.require_version('WebKit2', '4.1'); from gi.repository import WebKit2"
PROGRAM = Path(__file__).with_name("_kept_window.py")
PATIENCE = 30.0  # s until a page's store is open
BOX = "document.querySelector('#why textarea')"
READY = f"{BOX} && !{BOX}.readOnly && document.readyState === 'complete'"


def has_webkit() -> bool:
    """Whether the system's Python has the parts of Debian that open such a window."""
    asked = [SYSTEM_PYTHON, "-c", GI]
    return subprocess.run(asked, capture_output=True, check=False).returncode == 0


@dataclass(frozen=True)
class _Window:
    process: subprocess.Popen[str]

    def ask(self, expression: str) -> Any:
        assert self.process.stdin
        assert self.process.stdout
        self.process.stdin.write(expression + "\n")
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())

    def kill(self) -> None:
        """The window, its page's process and the one that writes to the disk, all at once."""
        os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()


@contextmanager
def _opened(display: str, profile: Path, file: Path) -> Iterator[_Window]:
    command = [SYSTEM_PYTHON, str(PROGRAM), str(profile), file.as_uri()]
    env = {**os.environ, "DISPLAY": display, "GDK_BACKEND": "x11", "HOME": str(profile)}
    with subprocess.Popen(
        command, env=env, text=True, start_new_session=True,
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
    ) as process:  # fmt: skip
        window = _Window(process)
        soon(lambda: window.ask(READY) is True, PATIENCE, "an open store in WebKit")
        yield window
        window.kill()


def lost_in_webkit(profile: Path, file: Path, delays: Sequence[float]) -> list[str]:
    """As `lost_answers` for the other browsers; the seconds begin with the last key."""
    written, lost = "", []
    dice = random.Random(len(delays))
    with screen() as display:
        for k, delay in enumerate((*delays, None)):
            with _opened(display, profile, file) as window:
                if (found := window.ask(f"{BOX}.value")) != written:
                    lost.append(f"{written!r}: {found!r}")
                if delay is None:
                    break
                written = f"{k}: kept at {delay} s"
                window.ask(f"{BOX}.select() ?? {BOX}.focus()")
                between = pause(k, dice)
                for key in written:
                    window.ask(f"document.execCommand('insertText', false, {json.dumps(key)})")
                    time.sleep(between)
                time.sleep(delay)
    return lost
