"""One scene as one file: live in both browsers, alone in a folder, with nothing to load."""

from __future__ import annotations

import os
import re
import shutil
import zipfile
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from playwright.sync_api import expect

from sim.cli import main
from sim.cli.single import command
from sim.pages.runtime import default_cache
from tests.film.maker import Stage, encoded, frames
from tests.web.conftest import OpenPage
from tests.web.runtime.boot_site import ROOT
from tests.web.scene.given.widget_site import live, on_scene

LESSON = """# Two scenes

```scene
id: first-one
carts:
  A: {mass: 0.5 kg, position: 0.4 m, velocity: 0.6 m/s}
  B: {mass: 1 kg, position: 1.3 m}
until: 3 s
controls:
  - {set: A.mass, from: 0.5 kg, to: 4 kg, step: 0.1 kg}
```

```scene
id: second-one
carts:
  A: {mass: 0.5 kg, position: 0.4 m, velocity: oops}
until: 3 s
```
"""

WAITS = """# It waits

```scene
id: hits
carts:
  A: {mass: 1 kg, position: 0.4 m, velocity: 0.6 m/s}
  B: {mass: 1 kg, position: 1.3 m}
until: 3 s
predict:
  choice: [A comes to rest, A goes on]
```

```question
id: told
type: single
ask: Who came to rest?
options: [{text: A did, correct: true}, {text: B did}]
after: hits
```

!!! after "What was it?"

    The striking cart stands.
"""


def write(arguments: list[str]) -> tuple[int, str]:
    before = Path.cwd()
    os.chdir(ROOT)
    try:
        result = CliRunner().invoke(command, arguments)
    finally:
        os.chdir(before)
    return result.exit_code, result.output


@pytest.mark.browser
def test_a_file_alone_in_a_folder_is_a_live_scene(open_page: OpenPage, tmp_path: Path) -> None:
    out = tmp_path / "alone" / "one.html"
    out.parent.mkdir()
    code, said = write(["tests/scenes/light-meets-heavy.yml", "--out", str(out)])
    assert code == 0, said
    assert not re.search(r'(?:src|href)="(?!data:|#)', out.read_text(encoding="utf-8"))
    page = live(open_page(out), "light-meets-heavy")
    before = on_scene(page, "return el.trajectory.v.A.at(-1)", name="light-meets-heavy")
    on_scene(page, "await el.set({ 'A.mass': 3 })", name="light-meets-heavy")
    after = on_scene(page, "return el.trajectory.v.A.at(-1)", name="light-meets-heavy")
    assert before != after


@pytest.fixture(scope="module")
def alone(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the one-file lessons of a new site, and one more that reads films."""
    folder = tmp_path_factory.mktemp("single")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("CARTS_CACHE", str(default_cache(ROOT)))
        patch.chdir(folder)
        made = CliRunner().invoke(main, ["new", "fork"])
        assert made.exit_code == 0, made.output
        lessons = folder / "fork" / "worksheets"
        ours = (ROOT / "worksheets" / "real-carts.md").read_text(encoding="utf-8")
        block = re.search(r"^```measured\n.*?^```\n", ours, re.DOTALL | re.MULTILINE)
        assert block is not None
        (lessons / "film.md").write_text(f"# A film\n\n{block[0]}", encoding="utf-8")
        (lessons / "waits.md").write_text(WAITS, encoding="utf-8")
        shutil.copytree(ROOT / "worksheets" / "data", lessons / "data")
        patch.chdir(folder / "fork")
        packed = CliRunner().invoke(main, ["pack", "--single", "--out", "../lessons.zip"])
        assert packed.exit_code == 0, packed.output
    with zipfile.ZipFile(folder / "lessons.zip") as archive:
        archive.extractall(folder / "alone")
    return folder / "alone"


@pytest.mark.one_browser
@pytest.mark.browser
def test_what_waits_for_a_run_waits_in_one_file_too(open_page: OpenPage, alone: Path) -> None:
    page = open_page(alone / "waits.html")
    question = page.locator("#told")
    expect(question.locator(".carts-q-waits")).to_be_visible()
    expect(question.get_by_text("Who came to rest?")).to_be_hidden()
    expect(page.get_by_text("The striking cart stands.")).to_be_hidden()
    expect(page.locator("carts-scene")).to_have_attribute("data-state", "live", timeout=60_000)
    expect(page.locator(".carts-watchdog")).to_have_count(0)


@pytest.mark.browser
@pytest.mark.one_browser
def test_a_lesson_of_real_carts_alone_in_a_folder_reads_its_film(
    open_page: OpenPage, alone: Path
) -> None:
    page = open_page(alone / "film.html")
    film = page.locator("carts-measured").first
    expect(film).to_have_attribute("data-state", "live", timeout=60_000)
    expect(film.locator(".carts-measured-figures path").first).to_be_attached()
    # What reads films, elsewhere a script of its own, is in the file too.
    stage, times = Stage(width=160, height=96, radius=5.0, scale=80.0), [0.0, 0.04, 0.08]
    motion = [np.full(3, 0.4), np.full(3, 1.4)]
    content = encoded(frames(stage, times, motion), times, stage)
    chosen = {"name": "carts.webm", "mimeType": "video/webm", "buffer": content}
    film.locator(".carts-measured-film-file").set_input_files([chosen])  # type: ignore[list-item]
    said = film.locator(".carts-film-say")
    expect(said).to_have_text("Click on the mark of cart A.", timeout=60_000)


def test_a_lesson_with_mistakes_or_several_scenes_says_so(tmp_path: Path) -> None:
    lesson = tmp_path / "two.md"
    lesson.write_text(LESSON, encoding="utf-8")
    code, said = write([str(lesson), "--scene", "first-one"])
    assert code == 1
    assert "two.md:16:" in said
    code, said = write(["worksheets/newtons-third-law.md"])
    assert code == 2
    assert "--scene third-pushed-along | " in said
    code, said = write(["worksheets/test-forces-and-motion.md"])
    assert code == 2
    assert "no scene" in said
