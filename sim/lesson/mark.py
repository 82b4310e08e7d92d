"""What marking says about one answer."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

Verdict = Literal["right", "partly", "wrong", "open", "empty", "unclear"]
"""open: a person has to read it. unclear: it cannot be understood, so it is not wrong either."""


@dataclass(frozen=True, slots=True)
class Mark:
    """`marks` of `of`, None where a person marks. `shown` names the feedback texts that fit.

    `beliefs` are the tags behind the chosen wrong answers. One item is no diagnosis: they say what
    students who choose this answer often think.
    """

    verdict: Verdict
    marks: int | None
    of: int
    shown: tuple[str, ...] = ()
    beliefs: tuple[str, ...] = ()

    def as_row(self) -> dict[str, Any]:
        """The form of the shared vectors in tests/marking."""
        return {
            "verdict": self.verdict,
            "marks": self.marks,
            "of": self.of,
            "shown": list(self.shown),
            "beliefs": list(self.beliefs),
        }


def is_empty(value: object) -> bool:
    """Whether nothing has been answered yet."""
    if isinstance(value, str):
        return not value.strip()
    return value is None or (isinstance(value, (list, tuple, Mapping)) and not value)


def all_or_nothing(
    right: bool,
    some: bool,
    of: int,
    *,
    shown: tuple[str, ...] = (),
    beliefs: tuple[str, ...] = (),
) -> Mark:
    """The mark of an item that gives its marks only as a whole."""
    if right:
        return Mark("right", of, of, (*shown, "explain"))
    return Mark("partly" if some else "wrong", 0, of, shown, beliefs)
