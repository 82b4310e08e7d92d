"""A film in a lesson is written as a picture is, and played by the browser."""

from __future__ import annotations

import shutil
import zipfile
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from playwright.sync_api import Page, expect

from sim.cli import main
from sim.pages.offline.files import listed
from sim.pages.runtime import default_cache
from tests.film.maker import Stage, encoded, frames
from tests.web.conftest import OpenPage
from tests.web.runtime.boot_site import ROOT

LESSON = """# A bump

![One cart runs into another](bump.webm)

<video src="bump.webm" controls width="160"></video>
"""
PLAYED = """async (film) => {
  film.muted = true;
  await film.play();
  while (film.currentTime < 0.2) await new Promise((done) => setTimeout(done, 20));
  return [film.videoWidth, film.videoHeight];
}"""


@pytest.fixture(scope="module")
def root(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A teacher's folder, built, with the lesson as one file in `alone`."""
    folder = tmp_path_factory.mktemp("films")
    stage, times = (
        Stage(width=160, height=96, radius=5.0, scale=80.0),
        [0.04 * n for n in range(25)],
    )
    motion = [np.linspace(0.4, 0.8, 25), np.full(25, 1.4)]
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("CARTS_CACHE", str(default_cache(ROOT)))
        patch.chdir(folder)
        assert CliRunner().invoke(main, ["new", "fork"]).exit_code == 0
        lessons = folder / "fork" / "worksheets"
        (lessons / "first-lesson.md").unlink()
        (lessons / "bump.md").write_text(LESSON, encoding="utf-8")
        film = encoded(frames(stage, times, motion), times, stage)
        (lessons / "bump.webm").write_bytes(film)
        patch.chdir(folder / "fork")
        for command in (["build"], ["pack", "--single", "--out", "../alone.zip"]):
            done = CliRunner().invoke(main, command)
            assert done.exit_code == 0, done.output
    with zipfile.ZipFile(folder / "alone.zip") as archive:
        archive.extractall(folder / "alone")
    return folder


def plays(page: Page, film: str) -> bool:
    shown = page.locator(film)
    shown.scroll_into_view_if_needed()
    return bool(shown.evaluate(PLAYED) == [160, 96])


@pytest.mark.browser
def test_a_film_beside_its_lesson_plays_from_disk(
    open_page: OpenPage, browser_name: str, root: Path
) -> None:
    page = open_page(root / "fork" / "site" / "worksheets" / "bump.html", folder=root)
    assert plays(page, ".carts-film-shown video")
    assert plays(page, "video[width]")
    expect(page.locator(".carts-film-words")).to_contain_text("One cart runs into another")
    expect(page.get_by_role("link", name="The film as a file")).to_have_attribute(
        "href", "bump.webm"
    )
    if browser_name == "firefox":
        return  # it has no print to be emulated
    page.emulate_media(media="print")
    expect(page.locator(".carts-film-shown video")).to_be_hidden()


@pytest.mark.browser
def test_in_a_lesson_of_one_file_its_films_are_inside(
    open_page: OpenPage, root: Path, tmp_path: Path
) -> None:
    alone = shutil.copy(root / "alone" / "bump.html", tmp_path)
    page = open_page(Path(alone))
    assert plays(page, ".carts-film-shown video")
    assert plays(page, "video[width]")
    assert page.locator(".carts-film-words").inner_text() == "One cart runs into another"


def test_a_hosted_site_keeps_no_films_for_later(root: Path) -> None:
    """A tablet that keeps the whole site at the first visit would fetch hundreds of megabytes."""
    kept = listed(root / "fork" / "site")
    assert "worksheets/bump.html" in kept
    assert not [name for name in kept if name.endswith(".webm")]
