"""A run with a line on the terminal that says how far it is, where that takes long."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from sim.cli.scene_file import fail, shown_name
from sim.dynamics.finished import Run
from sim.dynamics.outcome import UnsolvedError
from sim.dynamics.run import run
from sim.pages.findings import Finding
from sim.scene import Scene

QUIET = 0.5
"""s. A run that is over before that says nothing."""

AGAIN = 0.1
"""s between two lines."""


def run_on_terminal(name: str, scene: Scene, **options: Any) -> Run:
    """Run the scene of file `name`; what cannot be solved ends the command with 1."""
    try:
        with _line(scene.until) as progress:
            return run(scene, progress=progress, **options)
    except UnsolvedError as error:
        fail([Finding(shown_name(name), 1, 1, "unsolved", error.message, error.hint)])


@contextmanager
def _line(until: float) -> Iterator[Callable[[float, int], None] | None]:
    """On a terminal: one line on standard error, written anew, gone at the end. Else nothing."""
    if not sys.stderr.isatty():
        yield None
        return
    due = time.monotonic() + QUIET
    written = 0

    def progress(t: float, events: int) -> None:
        nonlocal due, written
        if time.monotonic() < due:
            return
        text = f"t = {t:.4g} of {until:.4g} s, {events} events"
        sys.stderr.write("\r" + text.ljust(written))
        sys.stderr.flush()
        due, written = time.monotonic() + AGAIN, max(written, len(text))

    try:
        yield progress
    finally:
        if written:
            sys.stderr.write("\r" + " " * written + "\r")
            sys.stderr.flush()
