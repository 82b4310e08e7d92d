"""The scenes of a page, for blocks that show one of them otherwise: maps, pictures."""

from __future__ import annotations

from collections.abc import Iterable

from sim.pages.blocks.scene_block import Lesson, SceneBlock, SiteIds, read_scene_block
from sim.pages.findings import AuthorError
from sim.pages.text.fence_scan import Block


def page_scenes(
    blocks: Iterable[Block], lesson: Lesson, *, first_line: int = 1
) -> dict[str, SceneBlock]:
    """The good scenes of the page by id; the others are reported where they stand."""
    found = {}
    for block in blocks:
        if block.name == "scene":
            try:
                scene = read_scene_block(block, lesson, SiteIds(), first_line=first_line)
            except AuthorError:
                continue
            found[scene.fence.id] = scene
    return found
