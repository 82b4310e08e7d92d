"""Ids of blocks that something else on their page has too, found when the page is made.

Headings of which nobody said an id leave it to the block; what is left are ids that somebody wrote
behind a heading, and names that a block gives to its parts.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from sim.pages.blocks.scene_block import SiteIds
from sim.pages.checks.heading_ids import of_a_heading
from sim.pages.findings import Finding
from sim.pages.language import language_folder

_OURS = re.compile(
    r'<carts-(?:scene|map|cost|hard|measured|law|question|quiz|challenge)\b[^>]*\sid="([^"]+)"'
)


def ids_twice(html: str, file: str, ids: SiteIds) -> Iterator[Finding]:
    """Each at the line of its block, where `ids` knows it."""
    blocks = _OURS.findall(html)
    folder = language_folder(file)
    for block in blocks:
        if html.count(f' id="{block}"') == 1:
            continue
        owner = next((name for name in blocks if block.startswith(f"{name}-")), "")
        place = ids.used.get(f"{folder}/{block}" if folder else block, "").rpartition(":")
        line = int(place[2]) if place[0] == file else 1
        if owner:
            told = f"id: “{block}” is also what “{owner}” calls a part of its own"
            hint = f"give one of the two blocks another id, for example {block}-1"
            yield Finding(file, line, 1, "id-taken", told, hint)
        else:
            yield of_a_heading(block, file, line)
