"""What a judge has found, as values."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from sim.scene.said import said


@dataclass(frozen=True, slots=True)
class Verdict:
    """On one law. `amount` is of the worst trial, `limit` what still counts as nought.

    `scene`: the worst one, plain, where the law is broken; `sentence`: what is seen there.
    """

    check: str
    says: str
    holds: bool
    amount: float
    limit: float
    sentence: str
    scene: Mapping[str, Any] | None


@dataclass(frozen=True, slots=True)
class Judgement:
    """All six, and what it took: scenes, and questions to the law."""

    file: str
    seed: int
    scenes: int
    calls: int
    verdicts: tuple[Verdict, ...]

    @property
    def holds(self) -> bool:
        """Was nothing found?"""
        return all(verdict.holds for verdict in self.verdicts)

    @property
    def sentence(self) -> str:
        """For a reader. A search proves what it finds, and nothing where it finds nothing."""
        tried = {"scenes": str(self.scenes), "calls": str(self.calls)}
        broken = sum(not verdict.holds for verdict in self.verdicts)
        if broken:
            return said(
                "In {scenes} scenes ({calls} questions) the law breaks {count} of 6.",
                **tried, count=str(broken),
            )  # fmt: skip
        return said(
            "In {scenes} scenes ({calls} questions) no counterexample was found. "
            "That is no proof: a search can only find what is wrong.",
            **tried,
        )
