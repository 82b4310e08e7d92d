"""A `cost` block: which scenes a reader can compare methods on. Each is a scene file.

```cost
id: what-accuracy-costs
scenes: [paper-two-carts.yml, off-the-wall.yml]
breaks: true
```

`breaks`: with the map of where methods break.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import PurePosixPath
from typing import Any

from sim.pages.blocks.scene_block import Lesson, SiteIds, load_block, with_scene_file
from sim.pages.findings import AuthorError, Finding
from sim.pages.language import mark
from sim.pages.text.fence_scan import Block
from sim.pages.text.yaml.source import Source
from sim.scene import SceneError, read_scene
from sim.scene.fence.presentation import FENCE_KEYS

KEYS = ("id", "title", "scenes", "breaks")
USUAL_TITLE = mark("What accuracy costs")


@dataclass(frozen=True, slots=True)
class CostBlock:
    """`scenes`: plain values by the name of their file, the one that is shown first in front."""

    id: str
    title: str
    scenes: Mapping[str, Mapping[str, Any]]
    names: Mapping[str, str]
    breaks: bool = False


def read_cost_block(block: Block, lesson: Lesson, ids: SiteIds, *, first_line: int) -> CostBlock:
    """Read it, or raise `AuthorError`."""
    source = load_block(block, lesson.file, first_line=first_line)
    plain = source.plain
    for key in plain:
        if key not in KEYS:
            place = source.key_place((key,))
            raise _refuse(lesson, place, "unknown-key", f"unknown key “{key}”", ", ".join(KEYS))
    identity, listed = plain.get("id"), plain.get("scenes")
    if not isinstance(identity, str) or not isinstance(listed, (list, tuple)) or not listed:
        raise _refuse(
            lesson, source.place(()), "required", "id and scenes are needed", "scenes: [file.yml]"
        )
    scenes: dict[str, Mapping[str, Any]] = {}
    names: dict[str, str] = {}
    for k, file in enumerate(listed):
        values = _scene(source, lesson, file, k)
        stem = PurePosixPath(str(file)).stem
        scenes[stem], names[stem] = values, str(values.get("title") or stem)
    ids.claim(identity, Finding(lesson.file, *source.place(("id",)), "id", ""))
    breaks = plain.get("breaks", False)
    if not isinstance(breaks, bool):
        raise _refuse(lesson, source.place(("breaks",)), "type", "breaks is true or false", "true")
    title = str(plain.get("title") or USUAL_TITLE)
    return CostBlock(identity, title, scenes, names, breaks)


def _scene(source: Source, lesson: Lesson, file: Any, k: int) -> Mapping[str, Any]:
    """The plain values of one scene file, without what only a lesson needs."""
    place = source.place(("scenes", k))
    asked = Source({"file": file}, {("file",): place}, {("file",): place})
    values, places = with_scene_file(asked, lesson)
    plain = {key: value for key, value in values.items() if key not in FENCE_KEYS}
    try:
        read_scene(plain)
    except SceneError as error:
        raise AuthorError(places.finding(problem) for problem in error.problems) from None
    return plain


def _refuse(
    lesson: Lesson, place: tuple[int, int], code: str, message: str, hint: str
) -> AuthorError:
    return AuthorError([Finding(lesson.file, *place, code, message, hint)])
