"""A browser that is killed loses no answer that it called saved: 5 times, Firefox 3 times.

`make bench AREA=answers` kills at random times after the last key, whatever the page says.
"""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path

import pytest
from playwright.sync_api import BrowserContext, Page, Playwright, expect

from tests.web.conftest import CONTEXT, LAUNCH
from tests.web.question.question_site import question_site, ready

pytestmark = pytest.mark.browser

__all__ = ["question_site"]  # a fixture

DELAYS = (0.0, 0.0, 0.05, 0.5, 1.5)  # s


def started(driver: Playwright, name: str, profile: Path) -> BrowserContext:
    launcher = getattr(driver, name)
    return launcher.launch_persistent_context(str(profile), **LAUNCH[name], **CONTEXT[name])


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


def opened(driver: Playwright, name: str, profile: Path, file: Path) -> tuple[BrowserContext, Page]:
    for lock in ("SingletonLock", "SingletonCookie", "SingletonSocket", "lock", ".parentlock"):
        (profile / lock).unlink(missing_ok=True)  # a dead browser's
    context = started(driver, name, profile)
    page = context.new_page()
    page.goto(file.as_uri())
    return context, ready(page)


def lost_answers(
    driver: Playwright, name: str, profile: Path, file: Path, delays: Sequence[float], *, told: bool
) -> list[str]:
    """Type, kill the browser so many seconds later, look again, and so on; what was not kept.

    `told`: the seconds begin when the page says “Saved”; else with the last key.
    """
    written, lost = "", []
    for k, delay in enumerate((*delays, None)):
        context, page = opened(driver, name, profile, file)
        box = page.locator("#why textarea")
        try:
            expect(box).to_have_value(written, timeout=3000)
        except AssertionError:
            lost.append(written)
        if delay is None:
            context.close()
            break
        written = f"{k}: kept at {delay} s"
        box.fill("")
        box.press_sequentially(written)
        if told:
            expect(page.locator("#why .carts-q-saved")).to_have_text("Saved")
        time.sleep(delay)
        kill(profile)
        with suppress(Exception):  # it is dead, which is what is wanted
            context.close()
    return lost


def test_no_answer_is_lost_when_the_browser_is_killed(
    driver: Playwright, browser_name: str, question_site: Path, tmp_path: Path
) -> None:
    file = question_site / "kinds.html"
    delays = DELAYS if browser_name == "chromium" else DELAYS[:3]  # Firefox takes 6 s to start
    assert lost_answers(driver, browser_name, tmp_path, file, delays, told=True) == []
