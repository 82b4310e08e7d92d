"""A `hard-cases` block: the whole table. It has an id, and a title if one is wanted.

```hard-cases
id: hard-cases
```
"""

from __future__ import annotations

from dataclasses import dataclass

from sim.pages.blocks.scene_block import Lesson, SiteIds, load_block
from sim.pages.findings import AuthorError, Finding
from sim.pages.language import mark
from sim.pages.text.fence_scan import Block

KEYS = ("id", "title")
TITLE = mark("Hard cases, run here")


@dataclass(frozen=True, slots=True)
class HardCasesBlock:
    """What an author may choose."""

    id: str
    title: str = TITLE


def read_hard_cases_block(
    block: Block, lesson: Lesson, ids: SiteIds, *, first_line: int
) -> HardCasesBlock:
    """Read it, or raise `AuthorError`."""
    source = load_block(block, lesson.file, first_line=first_line)
    plain = source.plain
    for key in plain:
        if key not in KEYS:
            place, message = source.key_place((key,)), f"unknown key “{key}”"
            raise AuthorError(
                [Finding(lesson.file, *place, "unknown-key", message, ", ".join(KEYS))]
            )
    identity = plain.get("id")
    if not isinstance(identity, str):
        finding = Finding(lesson.file, *source.place(()), "required", "an id is needed", "id: hard")
        raise AuthorError([finding])
    ids.claim(identity, Finding(lesson.file, *source.place(("id",)), "id", ""))
    return HardCasesBlock(identity, str(plain.get("title") or TITLE))
