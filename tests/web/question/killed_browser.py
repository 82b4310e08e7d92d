"""A browser that is killed while a reader types, and what it has lost."""

from __future__ import annotations

import os
import random
import signal
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path

from playwright.sync_api import BrowserContext, Page, Playwright, expect

from tests.web.conftest import CONTEXT, options
from tests.web.question.question_site import ready

SLOWEST_KEYS = 0.2
"""s between two keys of a slow typist; a fast one, and a dictation, has none."""


def started(driver: Playwright, name: str, profile: Path) -> BrowserContext:
    launcher, how = getattr(driver, name), options(name, briefly=True)
    return launcher.launch_persistent_context(str(profile), **how, **CONTEXT[name])


def processes(profile: Path) -> Iterator[int]:
    """The browser that was started with this profile, and nobody else's."""
    for entry in Path("/proc").iterdir():
        if entry.name.isdecimal():
            try:
                command = (entry / "cmdline").read_bytes()
            except OSError:
                continue
            if os.fsencode(profile) in command:
                yield int(entry.name)


def kill(profile: Path) -> None:
    for process in processes(profile):
        try:
            os.kill(process, signal.SIGKILL)
        except ProcessLookupError:
            continue


@contextmanager
def killed_page(
    driver: Playwright, name: str, profile: Path, file: Path, delay: float | None
) -> Iterator[Page]:
    """A page whose browser is killed `delay` s after the block is done; None: it is closed."""
    for lock in ("SingletonLock", "SingletonCookie", "SingletonSocket", "lock", ".parentlock"):
        (profile / lock).unlink(missing_ok=True)  # a dead browser's
    context = started(driver, name, profile)
    page = context.new_page()
    page.goto(file.as_uri())
    yield page
    if delay is not None:
        time.sleep(delay)
        kill(profile)
    with suppress(Exception):  # it is dead, which is what is wanted
        context.close()


def pause(k: int, dice: random.Random) -> float:
    """s between two keys at the k-th kill."""
    return SLOWEST_KEYS * dice.random() if k % 2 else 0.0


def lost_answers(
    driver: Playwright, name: str, profile: Path, file: Path, delays: Sequence[float], *, told: bool
) -> list[str]:
    """Type, kill the browser so many seconds later, look again, and so on; what was not kept,
    and what was there in its place.

    `told`: the seconds begin when the page says “Saved”; else with the last key. Every other time
    the keys come as fast as they can, else with a pause of up to `SLOWEST_KEYS` in between.
    """
    written, lost = "", []
    dice = random.Random(len(delays))
    for k, delay in enumerate((*delays, None)):
        with killed_page(driver, name, profile, file, delay) as page:
            box = ready(page).locator("#why textarea")
            page.locator("#why[data-ready]").wait_for()
            try:
                expect(box).to_have_value(written, timeout=3000)
            except AssertionError:
                lost.append(f"{written!r}: {box.input_value()!r}")
            if delay is None:
                break
            written = f"{k}: kept at {delay} s"
            box.fill("")
            box.press_sequentially(written, delay=1000 * pause(k, dice))
            if told:
                expect(page.locator("#why .carts-q-saved")).to_have_text("Saved")
    return lost
