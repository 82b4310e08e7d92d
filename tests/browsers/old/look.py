"""What a lesson does in an old browser, as a student meets it."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from .pipe import Pipe, browser

SETTLED = 40.0  # s in which Python starts, or has failed, on a machine that others use too
SOON = 3.0  # s after which nobody may still believe that a page works which does not
TYPED = "kept in an old browser"
FIELD = 'document.querySelector("carts-question textarea:not([readonly], :disabled)")'
TELLS = """[...document.querySelectorAll("[role=alert], .carts-note")].some((note) =>
  note.textContent.trim() && note.offsetHeight)"""
READABLE = 'document.body.innerText.length > 2000 && document.querySelector("svg") !== null'
STATE = 'document.documentElement.dataset.python || ""'
CAN_PLAY = 'document.querySelector("carts-scene .carts-play:enabled") !== null'
PLAYS = """(async () => {
  const button = document.querySelector("carts-scene .carts-play:enabled");
  if (!button) return false;
  button.click();
  await new Promise((done) => setTimeout(done, 1500));
  return button.closest("carts-scene").time > 0;
})()"""
WRITE = f"""(() => {{
  const box = {FIELD};
  if (!box) return false;
  box.value = "{TYPED}";
  box.dispatchEvent(new Event("input", {{ bubbles: true }}));
  return true;
}})()"""
SAVED = """[...document.querySelectorAll("carts-question .carts-q-saved")].some((its) =>
  its.textContent === "Saved")"""
THERE = f"""[...document.querySelectorAll("carts-question textarea")].some((box) =>
  box.value === "{TYPED}")"""


def look(program: Path, lesson: Path, free: Path) -> dict[str, bool]:
    """What works: readable, told (if Python is not live), live, plays, kept.

    `free`: a page with a scene that plays at once, without a prediction before it.
    """
    with tempfile.TemporaryDirectory() as profile, browser(program, Path(profile)) as page:
        page.ask("Page.navigate", url=lesson.as_uri())
        _until(page, "document.readyState === 'complete'", SOON)
        told = _until(page, TELLS, SOON)
        _until(page, f"['ready', 'failed'].includes({STATE})", SETTLED if not told else SOON)
        live = page.run(STATE) == "ready"
        kept = bool(page.run(WRITE)) and _until(page, SAVED, SETTLED)
        if kept:
            page.ask("Page.navigate", url=lesson.as_uri())
            kept = _until(page, THERE, SETTLED)
        readable = bool(page.run(READABLE))
        page.ask("Page.navigate", url=free.as_uri())
        plays = bool(_until(page, CAN_PLAY, SETTLED) and page.run(PLAYS))
        return {
            "readable": readable, "told": bool(told), "live": live,
            "plays": plays, "kept": bool(kept),
        }  # fmt: skip


def _until(page: Pipe, script: str, seconds: float) -> Any:
    return _look(lambda: page.run(script), seconds)


def _look(see: Callable[[], Any], seconds: float) -> Any:
    end = time.monotonic() + seconds
    while not (value := see()) and time.monotonic() < end:
        time.sleep(0.1)
    return value
