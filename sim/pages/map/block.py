"""A `map` block of a lesson: from its text to a described map, or to the author's mistakes.

The scene is written out in the block, stands in a file, or is another block of the page:

    ```map
    id: mass-map
    of: light-meets-heavy
    over: [{set: A.mass, from: 0.5 kg, to: 5 kg}]
    show: v.A
    ```
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from sim.pages.blocks.scene_block import (
    Lesson,
    Places,
    SiteIds,
    load_block,
    with_scene_file,
)
from sim.pages.findings import AuthorError, Finding
from sim.pages.text.fence_scan import Block
from sim.pages.text.page_scenes import page_scenes
from sim.pages.text.yaml.source import Source
from sim.scene import SceneError
from sim.scene.fence.map import Map, read_map


@dataclass(frozen=True, slots=True)
class MapBlock:
    """A map block that makes sense; `plain`: its values with those of its scene."""

    map: Map
    plain: Mapping[str, Any]
    places: Places


def read_map_block(
    block: Block, lesson: Lesson, ids: SiteIds, *, first_line: int, blocks: Sequence[Block]
) -> MapBlock:
    """The described map of `block`; raises `AuthorError`. `blocks`: all of the page."""
    source = load_block(block, lesson.file, first_line=first_line)
    if "of" in source.plain:
        plain, places = _with_scene_block(source, lesson, first_line, blocks)
    else:
        plain, places = with_scene_file(source, lesson)
    try:
        described = read_map(plain)
    except SceneError as error:
        raise AuthorError(places.finding(problem) for problem in error.problems) from None
    ids.claim(described.id, Finding(lesson.file, *source.place(("id",)), "id", ""))
    return MapBlock(described, plain, places)


def _with_scene_block(
    source: Source, lesson: Lesson, first_line: int, blocks: Sequence[Block]
) -> tuple[dict[str, Any], Places]:
    """The map's keys, joined with those of the scene that `of` names."""

    def refuse(code: str, message: str, hint: str, key: str = "of") -> AuthorError:
        place = source.key_place((key,))
        return AuthorError([Finding(lesson.file, *place, code, message, hint)])

    wanted = source.plain["of"]
    scenes = page_scenes(blocks, lesson, first_line=first_line)
    scene = scenes.get(str(wanted))
    if scene is None:
        names = ", ".join(scenes) or "none that can be read"
        raise refuse(
            "no-such-scene",
            f"there is no scene “{str(wanted)[:40]}” on this page",
            f"scenes on this page: {names}",
        )
    if scene.fence.predict is not None:
        raise refuse(
            "tells-the-answer",
            f"the scene “{wanted}” asks for a prediction, and a map of it would give it away",
            "write the map's scene out, with other numbers, or remove predict",
        )
    own = dict(source.plain)
    theirs = {key: value for key, value in scene.fence.plain.items() if key != "title"}
    if twice := sorted(set(own) & {*theirs, "file"}):
        raise refuse(
            "twice",
            f"“{twice[0]}” stands here and in the scene “{wanted}”",
            "remove one of them",
            twice[0],
        )
    return {**theirs, **own}, Places(lesson.file, source)
