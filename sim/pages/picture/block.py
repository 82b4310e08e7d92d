"""A `picture` block: the carts of a scene at one instant, drawn when the site is built.

```picture
of: newtons-third-law.md
scene: third-wall
at: 0.8 s
```

In place of `of` and `scene` a picture may name a scene file: `file: push-a-train.yml`. Forces are
not drawn, for a card is seen before the run that it leads to, but with `forces: shown`.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

from sim.pages.blocks.scene_block import (
    Lesson,
    SceneBlock,
    SiteIds,
    found_in,
    load_block,
    read_scene_block,
)
from sim.pages.findings import AuthorError, Finding
from sim.pages.text.author_text import author_text
from sim.pages.text.fence_scan import Block, scan
from sim.pages.text.page_scenes import page_scenes
from sim.pages.text.plain_lines import lines_of
from sim.pages.text.yaml.source import Source
from sim.scene.quantity import TIME, QuantityError, read_quantity

KEYS = ("of", "scene", "file", "at", "forces")
FORCES = ("none", "shown")
_EXAMPLE = "of: newtons-third-law.md, and below it scene: third-wall"


@dataclass(frozen=True, slots=True)
class PictureBlock:
    """The scene, and the instant of its run in s."""

    scene: SceneBlock
    at: float


def read_picture_block(block: Block, lesson: Lesson, *, first_line: int) -> PictureBlock:
    """Read it; raises `AuthorError` with what is wrong."""
    source = load_block(block, lesson.file, first_line=first_line)

    def refuse(key: str, code: str, message: str, hint: str) -> AuthorError:
        place = source.key_place((key,)) if key in source.plain else source.place(())
        return AuthorError([Finding(lesson.file, *place, code, message, hint)])

    if unknown := sorted(set(source.plain) - set(KEYS)):
        listed = ", ".join(KEYS)
        raise refuse(unknown[0], "unknown-key", f"unknown key “{unknown[0]}”", f"keys: {listed}")
    if ("file" in source.plain) == ("of" in source.plain):
        raise refuse("file", "missing", "a picture shows one scene: of a page, or a file", _EXAMPLE)
    if "file" in source.plain:
        scene = _of_file(block, lesson, first_line, source)
    else:
        path = found_in(str(source.plain["of"]), _lesson_folders(lesson), (".md",))
        if path is None:
            raise refuse("of", "no-such-file", f"there is no page “{source.plain['of']}”", _EXAMPLE)
        blocks = scan(lines_of(author_text(path, path.name)))
        scenes = page_scenes(blocks, Lesson(path.as_posix(), (path.parent,)))
        wanted = str(source.plain.get("scene"))
        if wanted not in scenes:
            names = ", ".join(scenes) or "none that can be read"
            message = f"there is no scene “{wanted}” on that page"
            raise refuse("scene", "no-such-scene", message, f"scenes on it: {names}")
        scene = scenes[wanted]
    try:
        at = float(read_quantity(source.plain.get("at", 0), TIME))
    except QuantityError as error:
        raise refuse("at", "not-a-time", f"at: {error}", "at: 0.8 s") from None
    if not 0 <= at <= scene.fence.scene.until:
        message = f"the run lasts from 0 to {scene.fence.scene.until:g} s"
        raise refuse("at", "out-of-range", message, "at: 0 s")
    if at > 0 and scene.fence.predict is not None:
        message = "the scene asks for a prediction, and this instant would give it away"
        raise refuse("at", "tells-the-answer", message, "remove at: the picture shows the start")
    forces = source.plain.get("forces", FORCES[0])
    if forces not in FORCES:
        raise refuse("forces", "not-a-choice", "forces is shown or none", "forces: shown")
    if forces == "shown" and scene.fence.forces != "shown":
        message = "the scene does not show its forces, and this picture would give them away"
        raise refuse("forces", "tells-the-answer", message, "remove forces")
    # What readers work is not there: neither its tools, nor the room that its sliders would need.
    fence = replace(scene.fence, forces=forces, opened=(), controls=())
    return PictureBlock(replace(scene, fence=fence), at)


def _lesson_folders(lesson: Lesson) -> list[Path]:
    """Where a page is looked for: beside this one, and among the lessons."""
    own, *others = lesson.scene_folders or (Path(),)
    return [own, *(folder.parent for folder in others if folder.name == "scenes")]


def _of_file(block: Block, lesson: Lesson, first_line: int, source: Source) -> SceneBlock:
    """The scene of the file, read as a scene block would read it."""
    body = "\n".join(("id: picture", f"file: {source.plain['file']}"))
    plain = Block("scene", "", block.start, block.end, block.indent, body, block.body_indent, True)
    return read_scene_block(plain, lesson, SiteIds(), first_line=first_line)
