"""Why a run ended, in a word and in a sentence."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True, slots=True)
class Outcome:
    """How a run ended. `sentence` is for people."""

    kind: Literal["reached-end", "came-to-rest", "too-many-events", "refused"]
    sentence: str


class UnsolvedError(ValueError):
    """A scene that cannot be solved exactly here. Never a wrong answer instead.

    `time` [s] and `bodies` say where; `hint` says what would help.
    """

    def __init__(self, message: str, hint: str, time: float, bodies: tuple[str, ...]) -> None:
        super().__init__(message)
        self.message, self.hint, self.time, self.bodies = message, hint, time, bodies
