"""Under which heading a block stands, and whether that part of a lesson is for who has time.

A part is optional from a heading of the first or second level with the class `more`, as in
`## Magnets {: .more }`, up to the next of these levels; the page's script marks the same parts.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

from sim.pages.text.fence_scan import Block
from sim.pages.text.plain_lines import without_code

HEADING = re.compile(r" {0,3}(?P<signs>#{1,6})\s")
_TITLE = re.compile(r"# +(.+?)(?: *\{:[^}]*\})? *")
OPTIONAL = "more"  # the class of such a heading
_MORE = re.compile(rf"\{{:?[^}}]*(?<![\w-])\.{OPTIONAL}(?![\w-])[^}}]*\}}\s*$")
_PARTS = 2  # the lowest level that divides a lesson into parts


@dataclass(frozen=True, slots=True)
class Section:
    """`level`: of the heading above. `new`: whether that stands below the block before."""

    level: int = 1
    optional: bool = False
    new: bool = True


def title_of(lines: Sequence[str]) -> str:
    """The first heading of the first level; empty where there is none."""
    seen = zip(lines, _without_code(lines), strict=True)
    found = (_TITLE.fullmatch(line) for line, plain in seen if _TITLE.fullmatch(plain))
    return next((title[1] for title in found if title), "")


def in_sections(lines: Sequence[str], blocks: Iterable[Block]) -> Iterator[tuple[Block, Section]]:
    """Each block of these lines with the section that it stands in."""
    section, done, plain = Section(), 0, _without_code(lines)
    for block in blocks:
        section = replace(section, new=done == 0)
        for line in plain[done : block.start]:
            if heading := HEADING.match(line):
                level = len(heading["signs"])
                more = bool(_MORE.search(line)) if level <= _PARTS else section.optional
                section = Section(level, more)
        yield block, section
        done = block.end


def _without_code(lines: Sequence[str]) -> list[str]:
    """A line of a program that begins with # is no heading."""
    return without_code("\n".join(lines)).split("\n") if lines else []
