"""Which solver takes which phase of a run, and why: always the cheapest one that is exact.

tier 0   flight                 x = x0 + v t, a parabola, or another closed form of one cart
tier 1   one contact at a time  closed form of the pair
tier 2   several at once        power series of order 26, exact to rounding
tier 3   what has no series     an adaptive method of order 8 with located events (scipy)
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise

from sim.dynamics.report import reasons
from sim.dynamics.result.finished import Run
from sim.dynamics.result.record import Solved
from sim.scene.effects import kinds
from sim.scene.model import Scene
from sim.scene.said import said

MOST_PHASES = 60
"""Phases told one by one. A longer plan ends in one entry for the rest: nobody reads a thousand."""

SOLVERS = ("free-flight", "pair-contact", "power-series", "adaptive")
REST = said("further flights and contacts of the same kinds")


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
    solved = sorted(run.record.solved, key=lambda part: (part.begin, part.gaps))
    known = run.t if run.record.solved_all else max(part.end for part in solved)
    marks = {0.0, known} | {t for part in solved for t in (part.begin, part.end) if t <= known}
    phases: list[Phase] = []
    upcoming, live = 0, []
    for begin, end in pairwise(sorted(marks)):
        while upcoming < len(solved) and solved[upcoming].begin <= begin:
            live.append(solved[upcoming])
            upcoming += 1
        live = [part for part in live if part.end > begin]
        phase = _phase(run, begin, end, live)
        if phases and phases[-1].why == phase.why:
            phases[-1] = replace(phases[-1], until=end)  # one more step of the same solver
            continue
        if len(phases) == MOST_PHASES:
            break
        phases.append(phase)
    if not phases:
        phases.append(_phase(run, 0.0, run.t, []))
    if phases[-1].until < run.t:
        tier = max(phase.tier for phase in phases)
        found = tuple(sorted({name for phase in phases for name in phase.packages}))
        phases.append(Phase(phases[-1].until, run.t, tier, SOLVERS[tier], REST, found))
    return tuple(phases)


def _phase(run: Run, begin: float, end: float, live: list[Solved]) -> Phase:
    """The highest tier at work names the phase; every part says why it is solved as it is."""
    scene = run.scene
    tier = max((part.solver.tier for part in live), default=0)
    solver = SOLVERS[tier]
    flying = [part for part in live if part.solver.tier == 0]
    if tier == 0 and flying:
        solver = "flight"
    ordered = sorted(live, key=lambda part: (-part.solver.tier, part.gaps))
    why = reasons.why(scene, ordered, frozenset(run.solvers))
    found = {name for part in live for name in reasons.packages(part.solver)}
    return Phase(begin, end, tier, solver, why, tuple(sorted(found)))


def packages(phases: tuple[Phase, ...]) -> tuple[str, ...]:
    """What the page of this scene has to carry beside the standard library."""
    return tuple(sorted({name for phase in phases for name in phase.packages}))


def not_simulated(scene: Scene) -> tuple[str, ...]:
    """Effects that this program knows and this scene does not call for."""
    listed = {effect.kind for effect in scene.effects}
    return tuple(kind for kind in kinds() if kind not in listed)
