"""Cells of a table for spreadsheets, safe against formulas. The same as sim/web/src/answers/csv.js.

A text that a spreadsheet could take for a formula begins with an apostrophe; numbers stay numbers.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterable, Sequence

# A formula may begin with these, also as wide letters, and behind marks that nobody sees. A text
# that begins with a space, a tab or a new line is suspect too. A % alone is a unit.
_RISKY = re.compile(
    r"\s|(?!%\Z)[\u200b-\u200f\u202a-\u202e\u2060-\u2069\ufeff\"']*[=+\-@|%\uff1d\uff0b\uff0d\uff20]"
)


def csv_cell(value: object) -> str:
    """One cell, quoted unless it is a number."""
    if isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value):
        return repr(value)
    return '"' + safe_text(as_text(value)).replace('"', '""') + '"'


def as_text(value: object) -> str:
    """What stands for a value in a cell: a text as it is, nothing for None, the rest as JSON."""
    if isinstance(value, str):
        return value
    return "" if value is None else json.dumps(value, ensure_ascii=False, separators=(",", ":"))


def safe_text(text: str) -> str:
    """The text as it may stand in a table: an apostrophe before what could be a formula."""
    text = text.replace("\0", "")
    return f"'{text}" if _RISKY.match(text) else text


def csv_text(columns: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    """A whole table with a byte order mark, so that Excel reads it as UTF-8."""
    lines = [",".join(columns), *(",".join(map(csv_cell, row)) for row in rows)]
    return "\ufeff" + "\r\n".join(lines) + "\r\n"
