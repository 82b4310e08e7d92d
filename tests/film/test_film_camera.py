"""Films that cannot be read, and the camera of a hosted page."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.film.collision import QUICK, Filmed, filmed
from tests.film.film_bench import MADE, STARTS, benches, choose, film, set_up
from tests.film.maker import Stage
from tests.web.conftest import OpenPage
from tests.web.site.pages_of import listen

__all__ = ["benches", "film"]  # fixtures

pytestmark = pytest.mark.browser


@pytest.mark.one_browser
def test_what_cannot_be_read_is_said_with_the_way_out(
    benches: Path, open_page: OpenPage, film: Filmed
) -> None:
    page = open_page(benches / "empty.html")
    stage = Stage(width=160, height=96)
    moving = filmed(MADE, stage, 10, codec="libx265", kind="mp4", options=QUICK)
    for name, content, reason in (
        ("phone.mov", moving.content, "cannot decode this film (HEVC)"),
        ("notes.mp4", b"t;x\n0;1\n" * 400, "This is no film in MP4, MOV or WebM."),
        ("half.mp4", film.content[: len(film.content) // 2], "the file may be damaged"),
    ):
        choose(page, name, content)
        said = page.locator(".carts-film-say")
        expect(said).to_contain_text(reason, timeout=STARTS)
        expect(said).to_contain_text("Tracker")
        expect(page.locator(".carts-film-follow")).to_be_disabled()


CAMERA = """() => {
  const canvas = document.createElement("canvas");
  const pen = canvas.getContext("2d");
  let k = 0;
  setInterval(() => {
    pen.fillStyle = "#777";
    pen.fillRect(0, 0, canvas.width, canvas.height);
    pen.fillStyle = "#d22";
    pen.fillRect((k += 1), 60, 20, 20);
  }, 20);
  navigator.mediaDevices.getUserMedia = async () => canvas.captureStream(30);
}"""


@pytest.mark.one_browser
def test_on_a_hosted_page_the_camera_films_and_following_can_be_cancelled(
    benches: Path,
    open_page: OpenPage,
    site_server: Callable[[Path], str],
    film: Filmed,
) -> None:
    page = open_page(f"{site_server(benches)}/empty.html")
    heard = listen(page)
    page.evaluate(CAMERA)
    page.locator(".carts-measured-camera").click()
    stop = page.locator(".carts-film-stop")
    expect(stop).to_have_text("Start filming")
    stop.click()
    expect(stop).to_have_text("Stop filming")
    page.wait_for_timeout(400)
    stop.click()
    said = page.locator(".carts-film-say")
    expect(said).to_have_text("Click on the mark of cart A.", timeout=STARTS)
    expect(page.locator("video")).to_have_count(0)
    choose(page, "our carts.mp4", film.content)
    expect(page.locator(".carts-film")).to_have_count(1)
    expect(said).to_have_text("Click on the mark of cart A.", timeout=STARTS)
    for key, time in (("End", film.times[-1]), ("Home", 0.0)):
        page.locator(".carts-film-time").press(key)
        expect(page.locator(".carts-film-clock")).to_have_text(f"{time:.3f} s")
    set_up(page, film)
    # Pressed before the worker is half through.
    page.evaluate(
        """() => { document.querySelector(".carts-film-follow").click();
        document.querySelector(".carts-film-cancel").click(); }"""
    )
    expect(said).to_have_text("Cancelled. Nothing was read.", timeout=STARTS)
    expect(page.locator(".carts-film-follow")).to_be_enabled()
    assert heard == []
