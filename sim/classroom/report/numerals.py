"""Numbers as they are written in a report, in every language alike."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

from sim.scene.notation import number
from sim.scene.said import counted


def signed(value: float, places: int = 2) -> str:
    """The same with its sign."""
    text = number(value, places)
    return text if text.startswith("−") or float(text) == 0 else f"+{text}"


def mean_and_sd(row: Mapping[str, float] | None) -> str:
    """`mean ± sd` on one line, or a dash where too few students have one."""
    if not row or "mean" not in row:
        return "–"
    return "\N{NO-BREAK SPACE}±\N{NO-BREAK SPACE}".join(number(row[k]) for k in ("mean", "sd"))


def students(count: int) -> str:
    """1 student, 2 students."""
    return counted("1 student", "{n} students", n=count)


def runs(count: int) -> str:
    """1 run, 2 runs."""
    return counted("1 run", "{n} runs", n=count)


def in_order(name: str) -> tuple[str, str]:
    """What names are sorted by: FOX-2 before FOX-10, as cards are handed out; FOX-02 is another."""
    return re.sub("[0-9]+", lambda digits: digits[0].zfill(9), name.upper()), name


def numbers(found: Iterable[int]) -> str:
    """1, 2, 5."""
    return ", ".join(map(str, found))
