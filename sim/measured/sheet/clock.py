"""Times of day and dates in cells: 10:17:33.250, 2026-11-23T10:17:33,25, 23.11.2026 10:17:33; and
17:33.3, as Excel shows a time with a fraction.

They become seconds. Days are counted modulo a thousand, so that a millisecond keeps its place in a
float; a recording lasts seconds, and only differences count.
"""

from __future__ import annotations

import datetime
import re

DAY = 86_400.0  # s
DAYS = 1000

_CLOCK = re.compile(
    r"(?:(?P<y>\d{4})[-/.](?P<m>\d{1,2})[-/.](?P<d>\d{1,2})[T ]+"
    r"|(?P<dd>\d{1,2})[-/.](?P<mm>\d{1,2})[-/.](?P<yy>\d\d(?:\d\d)?)[T ,]+)?"
    r"(?:(?P<hour>\d{1,2}):|(?=\d\d:\d\d[.,]))(?P<minute>\d{2}):(?P<second>\d{2}(?:[.,]\d{1,9})?)"
    r"(?:\s*(?P<half>[AaPp])\.?[Mm]\.?)?(?:Z|[+-]\d{2}:?\d{2})?",
    re.ASCII,
)


def seconds_of(cell: str) -> float | None:
    """s since some midnight; None where a cell is no time of day."""
    match = _CLOCK.fullmatch(cell.strip())
    if match is None:
        return None
    hour, minute = int(match["hour"] or 0), int(match["minute"])
    second = float(match["second"].replace(",", "."))
    if match["half"]:
        hour = hour % 12 + (12 if match["half"] in "pP" else 0)
    if hour > 24 or minute > 59 or second >= 61.0:
        return None
    return _day(match) * DAY + 3600.0 * hour + 60.0 * minute + second


def _day(match: re.Match[str]) -> int:
    year, month, day = (match[a] or match[b] for a, b in (("y", "yy"), ("m", "mm"), ("d", "dd")))
    if year is None:
        return 0
    try:
        return datetime.date(int(year), int(month), int(day)).toordinal() % DAYS
    except ValueError:  # 11/23/2026: the month stands first
        try:
            return datetime.date(int(year), int(day), int(month)).toordinal() % DAYS
        except ValueError:
            return 0
