"""A table as a spreadsheet opens it that writes numbers with a comma.

Where a number is written 0,5, a comma between cells and a point in numbers make texts and dates of
them: there cells are parted by semicolons. Our own readers take both. The page has the same rule:
sim/web/src/shared/spreadsheet.js.
"""

from __future__ import annotations

import re

COMMA, SEMICOLON = ",", ";"
_CELL = re.compile(r'("(?:[^"]|"")*"|[^,\r\n"]*)(,|\r?\n|\Z)')
_NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?", re.ASCII | re.IGNORECASE)


def parted_by(separator: str, csv: str) -> str:
    """The table, which has commas between cells and points in numbers, with this separator."""
    if separator == COMMA:
        return csv
    return _CELL.sub(lambda cell: _written(cell[1]) + (SEMICOLON if cell[2] == COMMA else cell[2]),
                     csv)  # fmt: skip


def _written(cell: str) -> str:
    if _NUMBER.fullmatch(cell):
        return cell.replace(".", ",")
    return f'"{cell}"' if SEMICOLON in cell and not cell.startswith('"') else cell
