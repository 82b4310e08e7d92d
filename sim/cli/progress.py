"""A run with a line on the terminal that says how far it is, where that takes long."""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from typing import Any

from sim.cli.scene_file import unsolved
from sim.dynamics.loop.run import run
from sim.dynamics.result.finished import Run
from sim.dynamics.result.outcome import UnsolvedError
from sim.scene import Scene

QUIET = 0.5
"""s. What is over before that says nothing."""

AGAIN = 0.1
"""s between two lines."""

PATIENCE = 3.0
"""s. What takes longer than that says so once, also where nobody sees a line being rewritten."""

BAR = 30
"""Signs."""

Write = Callable[[str], None]


@contextmanager
def still_computing() -> Iterator[None]:
    """While a command computes: one line on standard error once that has taken PATIENCE.

    A clock of its own, since a scene of very unequal masses or stiffnesses may take a minute
    without an event that could tell how far it is.
    """
    told = sys.stderr
    over = "\r" if told.isatty() else ""  # another line of progress may stand there

    def tell() -> None:
        told.write(f"{over}Still computing after {PATIENCE:g} s. Ctrl+C ends it.\n")
        told.flush()

    timer = threading.Timer(PATIENCE, tell)
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()


def run_on_terminal(name: str, scene: Scene, **options: Any) -> Run:
    """Run the scene of file `name`; what cannot be solved ends the command with 1."""
    try:
        with still_computing(), line() as write:
            return run(scene, progress=write and _of_run(write, scene.until), **options)
    except UnsolvedError as error:
        unsolved(name, error)


def _of_run(write: Write, until: float) -> Callable[[float, int], None]:
    return lambda t, events: write(f"t = {t:.4g} of {until:.4g} s, {events} events")


@contextmanager
def pages_on_terminal(config: Any) -> Iterator[None]:
    """While the generator with these settings runs: a bar for the pages that are made."""
    plugin = config.plugins["carts"]
    with line() as write:
        if write:
            plugin.progress = partial(_write_bar, write)
        try:
            yield
        finally:
            plugin.progress = None


def _write_bar(write: Write, done: int, of: int) -> None:
    full = BAR * done // max(of, done, 1)
    write(f"[{'#' * full}{'.' * (BAR - full)}] {100 * done // max(of, done, 1)} %")


@contextmanager
def line() -> Iterator[Write | None]:
    """On a terminal: one line on standard error, written anew, gone at the end. Else nothing."""
    if not sys.stderr.isatty():
        yield None
        return
    due = time.monotonic() + QUIET
    written = 0

    def write(text: str) -> None:
        nonlocal due, written
        if time.monotonic() < due:
            return
        sys.stderr.write("\r" + text.ljust(written))
        sys.stderr.flush()
        due, written = time.monotonic() + AGAIN, max(written, len(text))

    try:
        yield write
    finally:
        if written:
            sys.stderr.write("\r" + " " * written + "\r")
            sys.stderr.flush()
