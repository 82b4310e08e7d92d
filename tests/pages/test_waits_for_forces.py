"""`after: SCENE.forces`: a question that opens when the hidden forces of a scene are found."""

from __future__ import annotations

import re
from pathlib import Path

import markdown
import pytest

from sim.pages.blocks.extension import CartsExtension
from sim.pages.blocks.scene_block import Lesson, SiteIds
from sim.pages.checks.lessons import check_lesson
from sim.pages.text.lesson_list import lessons_in
from tests.conftest import ROOT

SCENE = """\
```scene
id: one
carts: {A: {mass: 1 kg, position: 0.4 m, velocity: 0.5 m/s}}
until: 2 s
```
"""


def html(text: str) -> str:
    return markdown.markdown(text, extensions=["pymdownx.superfences", CartsExtension()])


def test_a_question_waits_for_found_forces_only_where_a_scene_hides_them() -> None:
    options = "options: [{text: a, correct: true}, b]"
    asked = f"\n```question\nid: why\ntype: single\nask: Why?\nafter: one.forces\n{options}\n```\n"
    hidden = SCENE.replace("id: one\n", "id: one\nforces: hidden\nshow: [v]\n")
    assert 'data-after="one" data-found' in html(hidden + asked)
    found = check_lesson(SCENE + asked, Lesson("lesson.md"), SiteIds())
    assert [(one.code, one.line) for one in found if one.severity == "error"] == [
        ("nothing-to-find", SCENE.count("\n") + 6)
    ]
    missing = check_lesson(SCENE + asked.replace("one.", "two."), Lesson("lesson.md"), SiteIds())
    assert "after: there is no scene “two” on this page" in [one.message for one in missing]


LESSONS = [path for path in lessons_in(ROOT / "worksheets") if path.parent.name == "worksheets"]


@pytest.mark.parametrize("lesson", LESSONS, ids=lambda path: path.stem)
def test_our_lessons_ask_for_forces_only_where_a_question_is_about_them(lesson: Path) -> None:
    """Elsewhere `forces: none` shows none and asks nobody for one."""
    text = lesson.read_text(encoding="utf-8")
    scenes = re.findall(r"^```scene\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    hiding = [re.findall(r"^id: (.+)$", one, re.MULTILINE)[0] for one in scenes
              if "\nforces: hidden\n" in one]  # fmt: skip
    assert [name for name in hiding if f"\nafter: {name}.forces\n" not in text] == []
