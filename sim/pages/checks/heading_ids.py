"""Ids that somebody wrote behind a heading, and that a block of the lesson has too."""

from __future__ import annotations

import re
from collections.abc import Iterator

from sim.pages.blocks.scene_block import SiteIds
from sim.pages.findings import Finding
from sim.pages.text.plain_lines import without_code

_ID = re.compile(r"^ {0,3}#{1,6}[ \t][^\n]*\{:?[^}\n]*?[ \t:{]#([\w-]+)[^}\n]*\}[ \t]*$", re.M)


def heading_ids(text: str, file: str, ids: SiteIds) -> Iterator[Finding]:
    """Each at the line of its block, once all blocks of the lesson `text` are read."""
    written = set(_ID.findall(without_code(text)))
    for name, place in ids.used.items():
        owner, _, line = place.rpartition(":")
        if owner == file and (block := name.rpartition("/")[2]) in written:
            yield of_a_heading(block, file, int(line))


def of_a_heading(block: str, file: str, line: int) -> Finding:
    """That a heading has the id of the block at this line."""
    told = f"id: “{block}” is also the address of a heading on this page"
    hint = f"write another one behind the heading, for example {{: #{block}-text }}"
    return Finding(file, line, 1, "id-taken", told, hint)
