"""Blocks that are checked by themselves: what each kind is read with, and what must run in it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from sim.pages.blocks.bake import bake
from sim.pages.blocks.scene_block import Lesson, SiteIds
from sim.pages.classroom.evidence import evidence_block
from sim.pages.cost.block import read_cost_block
from sim.pages.findings import AuthorError
from sim.pages.hard_cases.block import read_hard_cases_block
from sim.pages.law.block import read_law_block
from sim.pages.map.bake import bake_map
from sim.pages.map.block import read_map_block
from sim.pages.measured.block import read_measured_block
from sim.pages.picture.block import read_picture_block
from sim.pages.text.fence_scan import Block


@dataclass(frozen=True, slots=True)
class Around:
    """What a block may name or must not repeat. `blocks`: all of its lesson."""

    lesson: Lesson
    ids: SiteIds
    blocks: Sequence[Block]


def _map(block: Block, around: Around) -> None:
    """A map must have values."""
    read = read_map_block(block, around.lesson, around.ids, first_line=1, blocks=around.blocks)
    run = bake_map(read.map, read.plain)
    if isinstance(run, list):
        raise AuthorError(map(read.places.finding, run))


def _law(block: Block, around: Around) -> None:
    """What a reader begins with must run."""
    read = read_law_block(block, around.lesson, around.ids, first_line=1)
    run = bake(read.fence.plain)
    if isinstance(run, list):
        raise AuthorError(map(read.finding, run))


def _cost(block: Block, around: Around) -> None:
    read_cost_block(block, around.lesson, around.ids, first_line=1)


def _hard_cases(block: Block, around: Around) -> None:
    read_hard_cases_block(block, around.lesson, around.ids, first_line=1)


def _evidence(block: Block, around: Around) -> None:
    evidence_block(block, around.lesson, first_line=1)


def _measured(block: Block, around: Around) -> None:
    read_measured_block(block, around.lesson, around.ids, first_line=1)


def _picture(block: Block, around: Around) -> None:
    read_picture_block(block, around.lesson, first_line=1)


CHECKS: dict[str, Callable[[Block, Around], None]] = {
    "map": _map,
    "cost": _cost,
    "hard-cases": _hard_cases,
    "evidence": _evidence,
    "measured": _measured,
    "law": _law,
    "picture": _picture,
}
"""By the name of the block; each raises `AuthorError`. All other kinds depend on the items before
them in the lesson."""
