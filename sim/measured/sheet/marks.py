"""Rows that programs mark: remarks, limits of axes, and heads behind a mark.

    # t x1 x2                           numpy: the heads behind a sign
    MIN=0 <tab> 0                       CASSY: limits and decimals of each column,
    DEF="t / s" <tab> "s_A1 / m"        and then the heads
    |-------|-----:|                    Markdown: a rule between heads and numbers

What is left is a row of heads as any other (`head_rows`).
"""

from __future__ import annotations

import re
from dataclasses import replace

from sim.measured.sheet.cells import CellRow

_LIMITS = re.compile(r"(?:MIN|MAX|SCALE|DEC)=\S*")
_HEADS = "DEF="
_RULE = re.compile(r"[-=+:]{3,}")


def is_remark(row: CellRow) -> bool:
    """A column of running numbers may be called “#”: its row goes on."""
    first = row.cells[0] if row.cells else ""
    if any(row.cells) and all(_RULE.fullmatch(cell) for cell in row.cells if cell):
        return True
    if first.lower().startswith("sep=") or _LIMITS.fullmatch(first):  # “sep=”: Excel's
        return True
    return first.startswith(("#", "%", "//")) and not (first == "#" and len(row.cells) > 2)


def without_marks(row: CellRow, width: int) -> CellRow:
    """A row above numbers of so many columns, without what says that it holds the heads."""
    first, *others = row.cells or ("",)
    if first == "#" and len(others) == width:
        return replace(row, cells=tuple(others))
    if first.startswith(_HEADS):
        return replace(row, cells=(first.removeprefix(_HEADS).strip('"'), *others))
    return row
