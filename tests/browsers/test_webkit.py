"""Every lesson in WebKitGTK, the engine of Safari and of all browsers on an iPad."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from sim.lesson.answer_file import read_answer_file
from tests.web.runtime.boot_site import build_site

from .visit import LIVE, PATIENCE, Seen, visit
from .webdriver import Session

pytestmark = [pytest.mark.browser, pytest.mark.slow]

EVERY = (path.stem for path in (Path(__file__).parents[2] / "worksheets").glob("*.md"))
LESSONS = sorted(name for name in EVERY if not name.startswith("return-week-"))
RETURN = "return-week-1"  # of three alike
WHOLE = "newtons-first-law"  # a lesson that has all of these
PARTS = {"live", "play", "lock"}
KEPT = {WHOLE, "newtons-third-law", "interactions"}
"""Words, arrows and a diagram are there for whoever comes back: so is what others have of them."""
PICTURE = 'carts-map[data-state="live"]'


def worked(seen: Seen, lesson: str) -> None:
    """The lesson of these parts has them all; a file of answers is taken home from every one."""
    read_answer_file(seen.file)
    assert lesson != WHOLE or seen.done == PARTS


@pytest.mark.parametrize("lesson", [*LESSONS, RETURN])
def test_a_lesson_works_from_disk(site: Path, window: Session, lesson: str) -> None:
    address = (site / "worksheets" / f"{lesson}.html").as_uri()
    worked(visit(window, address, comes_back=lesson in KEPT), lesson)


def test_a_lesson_works_from_a_server(
    hosted_site: Path, window: Session, site_server: Callable[[Path], str]
) -> None:
    """What differs from a disk is how it comes, and not the lesson."""
    address = f"{site_server(hosted_site)}/worksheets/{WHOLE}.html"
    worked(visit(window, address, comes_back=False), WHOLE)


def test_scenes_with_numpy_and_scipy_are_live_from_disk(site: Path, window: Session) -> None:
    window.go((site / "gallery" / "balls.html").as_uri())
    assert window.run("return document.querySelector('[data-packages=\"numpy scipy\"]') !== null")
    window.wait(LIVE, PATIENCE)


def test_a_map_is_computed_anew_from_disk(site: Path, window_for_long: Session) -> None:
    """In a window of its own: the engine once fell over here, after twenty pages in one; and here
    Python computes for long."""
    window_for_long.go((site / "physics" / "map.html").as_uri())
    window_for_long.wait("return document.querySelector('.carts-map-open') !== null", PATIENCE)
    window_for_long.click(".carts-map-open")
    window_for_long.wait(f"return document.querySelector('{PICTURE}') !== null", PATIENCE)


def test_python_starts_from_the_picture_of_its_memory(window: Session, tmp_path: Path) -> None:
    """Three times as fast as without; numbers of functions in it must fit this browser's table."""
    build_site(tmp_path)
    window.fresh()
    window.go((tmp_path / "index.html").as_uri())
    assert (
        window.run("return window.booted.then(({ start, detail }) => start ?? detail)")
        == "snapshot"
    )
