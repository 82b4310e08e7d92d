"""A hint for the author of a scene: an effect listed in vain, or one that is missed much."""

from __future__ import annotations

from typing import Protocol

from sim.pages.findings import Finding
from sim.scene.model import Scene
from sim.scene.problem import Problem


class Placed(Protocol):
    """Knows the lines of an author's text."""

    def finding(self, problem: Problem) -> Finding:
        """The problem where it stands."""


def relevance_hints(scene: Scene, places: Placed) -> list[Finding]:
    """At most one, and no error: the scene is as its author wants it. The scene can be run."""
    from sim.dynamics.relevance.ranking import hint, ranked_effects  # only who checks computes it
    from sim.dynamics.result.outcome import UnsolvedError

    try:
        told = hint(ranked_effects(scene))
    except UnsolvedError:
        return []
    if not told:
        return []
    return [places.finding(Problem(("effects",), "relevance", "")).as_hint(told)]
