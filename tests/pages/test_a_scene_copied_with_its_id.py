"""A scene copied with its id is one mistake, though questions name the id it should have."""

from __future__ import annotations

import pytest

from sim.pages.blocks.scene_block import Lesson, SiteIds
from sim.pages.checks.lessons import check_lesson

SCENE = """\
```scene
id: {id}
carts: {{A: {{mass: 1 kg, position: 0.4 m, velocity: 0.5 m/s}}}}
until: 2 s
```

"""
ASKED = """\
```question
id: {kind}-how
ask: How fast?
scene: two
{keys}
```
"""
KINDS = {"reading": "quantity: v.A\nat: end\ntolerance: 0.01 m/s", "drawn": ""}


def errors(*ids: str, kind: str) -> list[str]:
    scenes = "".join(SCENE.format(id=name) for name in ids)
    asked = ASKED.format(kind=kind, keys=f"type: {kind}\n{KINDS[kind]}")
    found = check_lesson(scenes + asked, Lesson("lesson.md"), SiteIds())
    return [one.code for one in found if one.severity == "error"]


@pytest.mark.parametrize("kind", KINDS)
def test_a_question_that_names_a_scene_copied_with_its_id_has_no_mistake(kind: str) -> None:
    assert errors("one", "one", kind=kind) == ["id-taken"]
    assert errors("one", "three", kind=kind)[:1] == ["no-such-scene"]


@pytest.mark.parametrize(
    ("above", "clash"),
    [
        ("## Two carts {: #one }", True),
        ("## Two carts {: .more #one data-minutes=8 }", True),
        ("## Two carts { #one }", True),
        ("## Two carts {: #one-text }", False),
        ("```text\n## Two carts {: #one }\n```", False),
        ("## One", False),
    ],
)
@pytest.mark.parametrize("file", ["lesson.md", "worksheets/ms/lesson.md"])
def test_an_id_that_a_heading_has_too_is_told_at_its_block(
    above: str, clash: bool, file: str
) -> None:
    text = f"# A\n\n{above}\n\n{SCENE.format(id='one')}"
    found = check_lesson(text, Lesson(file), SiteIds())
    line = text.split("\n").index("```scene") + 2
    assert [(one.code, one.line) for one in found] == ([("id-taken", line)] if clash else [])
