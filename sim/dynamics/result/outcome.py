"""Why a run ended, in a word and in a sentence."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from sim.scene.model import Scene
from sim.scene.said import said


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


def refuse_written(scene: Scene) -> None:
    """A law in a file has no closed form, and nobody knows its two sides to be equal."""
    if scene.written:
        raise UnsolvedError(
            said("a law of your own is followed by its own solver, and by no other"),
            said(
                "run the scene as it is: no other solver, and so no cost, can be compared with it"
            ),
            0.0,
            (),
        )
