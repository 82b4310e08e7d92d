"""When a number is not given: the reason, in words for the teacher."""

from __future__ import annotations

import math
from collections.abc import Sequence

FEWEST = 5
"""Students. Below, answers are listed and nothing is computed from them."""

FEW = 10
"""Students. Below, counts and dots stand in the place of percentages."""

ENOUGH_FOR_ITEMS = 20
"""Students. Below, nothing is said about how well an item tells students apart."""


class RefusalError(ValueError):
    """This statistic has no honest value for these numbers; the message says why."""


def numbers(values: Sequence[float], what: str = "marks") -> tuple[float, ...]:
    """The values as floats; refuses what is missing, not a number or endless."""
    found = tuple(math.nan if value is None else float(value) for value in values)
    missing = sum(not math.isfinite(value) for value in found)
    if missing:
        raise RefusalError(f"{missing} of {len(found)} {what} are missing or are no numbers")
    return found


def at_least(count: int, needed: int, who: str = "students") -> None:
    """Refuses a group that is too small."""
    if count < needed:
        raise RefusalError(f"{count} {who}: at least {needed} are needed")
