"""When a number is not given: the reason, in words for the teacher."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from sim.scene.said import Said, counted, said

FEWEST = 5
"""Students. Below, answers are listed and nothing is computed from them."""

FEW = 10
"""Students. Below, counts and dots stand in the place of percentages."""

ENOUGH_FOR_ITEMS = 20
"""Students. Below, nothing is said about how well an item tells students apart."""


class RefusalError(ValueError):
    """This statistic has no honest value for these numbers; the message says why."""


def numbers(values: Sequence[float]) -> tuple[float, ...]:
    """The values as floats; refuses what is missing, not a number or endless."""
    found = tuple(math.nan if value is None else float(value) for value in values)
    missing = sum(not math.isfinite(value) for value in found)
    if missing:
        raise RefusalError(said("{missing} of {all} marks are missing or are no numbers",
                                missing=str(missing), all=str(len(found))))  # fmt: skip
    return found


def of_students(n: int, needed: int) -> Said:
    """That there are too few students."""
    return counted(
        "1 student: at least {needed} are needed", "{n} students: at least {needed} are needed",
        n=n, needed=f"{needed}",
    )  # fmt: skip


def at_least(count: int, needed: int, says: Callable[[int, int], Said] = of_students) -> None:
    """Refuses a group that is too small; `says`: the sentence of how many are there and needed."""
    if count < needed:
        raise RefusalError(says(count, needed))
