"""Which solver takes which phase of a run, and why: always the cheapest one that is exact.

tier 0   free flight            x = x0 + v t
tier 1   one contact at a time  closed form of the pair
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise

from sim.dynamics.finished import Run
from sim.dynamics.record import Solved
from sim.scene.effects import KINDS
from sim.scene.model import Scene

MOST_PHASES = 60
"""Phases told one by one. A longer plan ends in one entry for the rest: nobody reads a thousand."""

SOLVERS = ("free-flight", "pair-contact", "coupled-contacts")
FLIGHT = "nothing touches and no effect acts: every cart keeps its velocity, x = x₀ + v t is exact"
REST = "further flights and contacts of the same kinds"


@dataclass(frozen=True, slots=True)
class Phase:
    """One phase of the plan; times in s."""

    begin: float
    until: float
    tier: int
    solver: str
    why: str
    packages: tuple[str, ...] = ()


def plan(run: Run) -> tuple[Phase, ...]:
    """The phases of a run in order of time, without holes."""
    scene = run.scene
    solved = sorted(run.record.solved, key=lambda part: (part.begin, part.gaps))
    marks = sorted({0.0, run.t} | {t for part in solved for t in (part.begin, part.end)})
    phases: list[Phase] = []
    upcoming, live = 0, []
    for begin, end in pairwise(marks):
        while upcoming < len(solved) and solved[upcoming].begin <= begin:
            live.append(solved[upcoming])
            upcoming += 1
        live = [part for part in live if part.end > begin]
        phase = _phase(scene, begin, end, sorted(live, key=lambda part: part.gaps))
        if phases and phases[-1].why == phase.why:
            phases[-1] = replace(phases[-1], until=end)  # one more step of the same solver
            continue
        if len(phases) == MOST_PHASES:
            tier = max(earlier.tier for earlier in phases)
            phases.append(Phase(begin, run.t, tier, SOLVERS[tier], REST))
            break
        phases.append(phase)
    return tuple(phases)


def _phase(scene: Scene, begin: float, end: float, live: list[Solved]) -> Phase:
    if not live:
        return Phase(begin, end, 0, SOLVERS[0], FLIGHT)
    together = [part for part in live if len(part.gaps) > 1]
    if together:
        gaps = sorted(gap for part in together for gap in part.gaps)
        return Phase(
            begin,
            end,
            2,
            SOLVERS[2],
            f"{_pairs(scene, gaps)} are in contact at the same time and share carts: a power "
            "series of order 26 in short steps, exact to rounding",
        )
    gaps = sorted(gap for part in live for gap in part.gaps)
    laws = sorted({contact.law for gap in gaps if (contact := scene.contacts[gap]) is not None})
    return Phase(
        begin,
        end,
        1,
        SOLVERS[1],
        f"only {_pairs(scene, gaps)} in contact, and nobody else can reach them before it ends: "
        f"the law {' and '.join(laws)} has a closed form, exact",
    )


def _pairs(scene: Scene, gaps: list[int]) -> str:
    return " and ".join(f"{a} with {b}" for a, b in map(scene.names_at, gaps))


def packages(phases: tuple[Phase, ...]) -> tuple[str, ...]:
    """What the page of this scene has to carry beside the standard library."""
    return tuple(sorted({name for phase in phases for name in phase.packages}))


def not_simulated(scene: Scene) -> tuple[str, ...]:
    """Effects that this program knows and this scene does not call for."""
    listed = {effect.kind for effect in scene.effects}
    return tuple(kind for kind in KINDS if kind not in listed)
