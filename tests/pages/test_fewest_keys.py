"""A question of every kind with the keys that it needs and no other."""

from __future__ import annotations

import pytest

from sim.lesson.read import KINDS
from sim.pages.blocks.scene_block import Lesson, SiteIds
from sim.pages.checks.lessons import check_lesson
from tests.web.question.question_site import questions_page

SCENE = """```scene
id: light-meets-heavy
carts:
  A: {mass: 1 kg, position: 0.4 m, velocity: 0.6 m/s}
  B: {mass: 1 kg, position: 1 m}
until: 1 s
predict: {arrows: [A-B]}
```
"""
RUBRIC = "rubric: {1: a reason, 0: none}"
NEEDED = {
    "short": [RUBRIC],
    "long": [RUBRIC],
    "matching": ["pairs: [{left: a, right: b}, {left: c, right: d}]"],
    "interactions": ["contact: [[book, table], [table, Earth]]"],
}
"""Where one key of several is needed, or an example shows one row of two."""


@pytest.mark.parametrize("kind", KINDS)
def test_a_question_of_the_fewest_keys_is_found_right_and_makes_a_page(kind: str) -> None:
    given = {key.name: key.example for key in KINDS[kind].KEYS if key.required}
    given |= dict(line.split(": ", 1) for line in NEEDED.get(kind, []))
    keys = [f"{name}: {example}" for name, example in given.items()]
    block = "\n".join(["```question", "id: q", f"type: {kind}", "ask: What?", *keys, "```"])
    text = f"# A lesson\n\n{SCENE}\n{block}\n"
    assert check_lesson(text, Lesson("a.md", (), ()), SiteIds()) == []
    page, _ = questions_page("a", text)
    assert f'data-type="{kind}"' in page
