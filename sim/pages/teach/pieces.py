"""A lesson's text as pieces: blocks of ours, and the Markdown between them. Nothing is lost.

The pieces put together are the text, to the last character: line ends of any kind, a missing one at
the end, tabs. Lines are counted as `carts check` counts them.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from sim.pages.text.fence_scan import Block, after_front_matter, scan
from sim.pages.text.plain_lines import lines_of


@dataclass(frozen=True, slots=True)
class Piece:
    """Characters `start` to `end` of the text, from line `line` (counted from 1) on.

    `kind`: "block", "text" or "top" (front matter). `block` is None but for a block.
    """

    kind: str
    start: int
    end: int
    line: int
    block: Block | None = None


@dataclass(frozen=True, slots=True)
class Lines:
    """The lines of a text, and where each begins."""

    lines: tuple[str, ...]
    starts: tuple[int, ...]

    @classmethod
    def of(cls, text: str) -> Lines:
        """The lines without their ends."""
        ended = lines_of(text, keepends=True)
        starts = [0]
        for line in ended:
            starts.append(starts[-1] + len(line))
        return cls(tuple(lines_of(text)), tuple(starts))

    def offset(self, line: int, col: int) -> int:
        """Where in the text a place is; line and column counted from 0."""
        return self.starts[min(line, len(self.starts) - 1)] + col


def pieces(text: str) -> tuple[Piece, ...]:
    """The pieces of a lesson, in their order."""
    return tuple(_pieces(Lines.of(text)))


def blocks(text: str) -> list[Block]:
    """The blocks of a lesson, as `carts check` sees them."""
    return list(scan(lines_of(text)))


def _pieces(rows: Lines) -> Iterator[Piece]:
    done = after_front_matter(rows.lines)
    if done:
        yield Piece("top", 0, rows.starts[done], 1)
    for block in scan(rows.lines):
        if block.start > done:
            yield Piece("text", rows.starts[done], rows.starts[block.start], done + 1)
        end = rows.starts[block.end]
        yield Piece("block", rows.starts[block.start], end, block.start + 1, block)
        done = block.end
    if rows.starts[-1] > rows.starts[done]:
        yield Piece("text", rows.starts[done], rows.starts[-1], done + 1)
