"""How sure a student is: a question of its own, for example after a discussion."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Self

from sim.lesson.mark import Mark, is_empty
from sim.lesson.question import CERTAINTY, Common, Question
from sim.scene.problem import Path, Problem


@dataclass(frozen=True, slots=True, kw_only=True)
class Confidence(Question):
    """The value is guess, think or sure. There is no right answer."""

    KIND: ClassVar[str] = "confidence"
    SAYS: ClassVar[str] = "say how sure you are"
    MARKED: ClassVar[bool] = False

    @classmethod
    def read(
        cls, table: Mapping[str, Any], common: Common, path: Path, problems: list[Problem]
    ) -> Self:
        """It needs nothing of its own, and has no answer to be sure of or to find."""
        for name in ("sure", "hints"):
            if name in table:
                message = (
                    "this question itself asks how sure a student is, and has no answer to find"
                )
                problems.append(Problem((*path, name), "unknown-key", message, f"remove {name}"))
        return cls(common=common)

    @classmethod
    def from_key(cls, row: Mapping[str, Any], common: Common) -> Self:
        """It needs nothing of its own."""
        del row
        return cls(common=common)

    def asked(self) -> dict[str, Any]:
        """The three words."""
        return {"options": list(CERTAINTY), "marks": 0}

    def key(self) -> dict[str, Any]:
        """No key."""
        return {"feedback": []}

    def meaning(self) -> dict[str, Any]:
        """The question alone."""
        return {}

    def mark(self, value: object, own: float | None = None) -> Mark:
        """Nothing to mark."""
        del own
        if is_empty(value):
            return Mark("empty", 0, 0)
        return Mark("open" if value in CERTAINTY else "unclear", None, 0)
