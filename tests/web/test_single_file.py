"""One scene as one file: live in both browsers, alone in a folder, with nothing to load."""

from __future__ import annotations

import os
import re
from pathlib import Path

import pytest
from click.testing import CliRunner

from sim.cli.single import command
from tests.web.boot_site import ROOT
from tests.web.conftest import OpenPage
from tests.web.widget_site import live, on_scene

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
    assert not re.search(r'(?:src|href)="(?!data:)', out.read_text(encoding="utf-8"))
    page = live(open_page(out), "light-meets-heavy")
    before = on_scene(page, "return el.trajectory.v.A.at(-1)", name="light-meets-heavy")
    on_scene(page, "await el.set({ 'A.mass': 3 })", name="light-meets-heavy")
    after = on_scene(page, "return el.trajectory.v.A.at(-1)", name="light-meets-heavy")
    assert before != after


def test_a_lesson_with_mistakes_or_several_scenes_says_so(tmp_path: Path) -> None:
    lesson = tmp_path / "two.md"
    lesson.write_text(LESSON, encoding="utf-8")
    code, said = write([str(lesson), "--scene", "first-one"])
    assert code == 1
    assert "two.md:16:" in said
    code, said = write(["worksheets/newtons-third-law.md"])
    assert code == 2
    assert "--scene third-equal | " in said
    code, said = write(["worksheets/test-forces-and-motion.md"])
    assert code == 2
    assert "no scene" in said
