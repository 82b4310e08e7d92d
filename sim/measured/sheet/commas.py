"""Commas that part the columns, and commas within the numbers, in one file.

Tracker and some spreadsheets write so where a language has a decimal comma and nobody chose another
sign between the columns: 1,000000E−2,−1,498701E1 under the names t, x. Where every line of numbers
comes out under its names once whole and decimal part are joined, it can be read in one way only.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

Cells = tuple[str, ...]

MINUS = "\u2212\u2010\u2011\u2013\uff0d"
"""Signs that programs and keyboards write for a minus, beside that of ASCII."""

_SIGN = f"[+\\-{MINUS}]"
_WHOLE = re.compile(rf"{_SIGN}?\d{{1,9}}", re.ASCII)
_DECIMALS = re.compile(rf"\d+(?:[eE]{_SIGN}?\d{{1,3}})?", re.ASCII)


def with_decimal_commas(rows: Sequence[Cells]) -> list[Cells]:
    """The rows with whole and decimal parts joined where that is certain, else as they are."""
    first = next((k for k, row in enumerate(rows) if _is_parts(row)), 0)
    columns = max((len(row) for row in rows[:first]), default=0)  # of the names, no units alone
    told = [_joined(row) for row in rows[first:]] if columns else []
    certain = told and all(told) and max(len(row or ()) for row in told) == columns
    return [*rows[:first], *(row or () for row in told)] if certain else list(rows)


def _is_parts(row: Cells) -> bool:
    """Whether a row has nothing but parts of numbers in it, two at least."""
    return sum(_DECIMALS.fullmatch(cell) is not None for cell in row) >= 2 and all(
        not cell or _WHOLE.fullmatch(cell) or _DECIMALS.fullmatch(cell) for cell in row
    )


def _joined(row: Cells) -> Cells | None:
    """Each whole part with the decimal part behind it; None where one of them is missing."""
    parts, made = iter(row), list[str]()
    for cell in parts:
        number = cell and _number(cell, parts)
        if number is None:
            return None
        made.append(number)
    return tuple(made)


def _number(whole: str, parts: Iterator[str]) -> str | None:
    decimals = next(parts, "")
    good = _WHOLE.fullmatch(whole) and _DECIMALS.fullmatch(decimals)
    return f"{whole},{decimals}" if good else None
