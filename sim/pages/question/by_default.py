"""What the defaults of the format do on a page, for an author whose lesson is older than they are.

A scene of a lesson is watched before it is known, and a question below a scene with a prediction
waits until that scene was watched, unless the author says otherwise. Text does not wait.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from sim.pages.blocks.scene_block import SceneBlock
from sim.pages.findings import Finding
from sim.pages.question.block import QuestionBlock
from sim.pages.question.on_page import PageItems
from sim.pages.text.fence_scan import Block
from sim.pages.text.held_back import first_told
from sim.pages.text.lesson_places import LESSONS
from sim.scene.problem import Problem

CODE = "default"
TEXT = "default-text"


def watched_by_default(scene: SceneBlock) -> list[Finding]:
    """That the run of a scene is watched before it is known, if no `watch` says so."""
    fence, file = scene.fence, scene.places.file
    lesson = LESSONS in file.split("/")[:-1]
    if "watch" in scene.places.source.plain or not (fence.predict or lesson):
        return []
    told = f"“{fence.id}” is watched before it is known; “watch: free” shows everything at once"
    return [scene.places.finding(Problem(("id",), CODE, "")).as_hint(told)]


def waits_by_default(question: QuestionBlock, items: PageItems) -> list[Finding]:
    """That a question waits for a scene, if no `after` says so. `items`: what stands above it."""
    scene = items.gate(question.question)
    if question.question.common.after or not scene:
        return []
    told = f"opens when “{scene}” was watched; “after: none” opens it at once"
    return [question.places.finding(Problem(("id",), CODE, "")).as_hint(told)]


def open_by_default(
    lines: Sequence[str], blocks: Iterable[Block], own: Block, scene: str, file: str
) -> list[Finding]:
    """The first text that a student reads below a prediction before its run was watched.

    `lines` of the whole lesson, with its `blocks`; `own`: that of the scene with this id.
    """
    prose = list(lines)
    for block in blocks:
        prose[block.start : block.end] = [""] * (block.end - block.start)
    if (at := first_told(prose[own.end :])) is None:
        return []
    told = f"read before “{scene}” was watched; “!!! after” above it holds text back"
    return [Finding(file, own.end + at + 1, 1, TEXT, told, severity="hint")]
