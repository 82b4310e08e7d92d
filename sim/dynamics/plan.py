"""Which solver takes which phase of a run, and why: always the cheapest one that is exact.

tier 0   free flight            x = x0 + v t
tier 1   one contact at a time  closed form of the pair
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

from sim.dynamics.run import Run
from sim.scene.effects import KINDS
from sim.scene.model import Scene

MOST_PHASES = 60
"""Phases told one by one. A longer plan ends in one entry for the rest: nobody reads a thousand."""

FLIGHT = "nothing touches and no effect acts: every cart keeps its velocity, x = x0 + v t is exact"
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
    spans: dict[tuple[float, float], list[int]] = {}
    for contact, begin, end in run.record.contacts:
        spans.setdefault((begin, end), []).append(contact.gap)
    marks = sorted({0.0, run.t} | {t for span in spans for t in span})
    phases: list[Phase] = []
    active = sorted(spans)
    first = 0
    for begin, end in pairwise(marks):
        while first < len(active) and active[first][1] <= begin:
            first += 1
        touching = sorted(
            gap
            for span in active[first:]
            if span[0] <= begin and span[1] >= end
            for gap in spans[span]
        )
        phases.append(_phase(scene, begin, end, touching))
        if len(phases) == MOST_PHASES and end < run.t:
            tier = max(phase.tier for phase in phases)
            solver = "pair-contact" if tier else "free-flight"
            phases.append(Phase(end, run.t, tier, solver, REST))
            break
    return tuple(phases)


def _phase(scene: Scene, begin: float, end: float, touching: list[int]) -> Phase:
    if not touching:
        return Phase(begin, end, 0, "free-flight", FLIGHT)
    pairs = " and ".join(f"{a} with {b}" for a, b in map(scene.names_at, touching))
    contact = scene.contacts[touching[0]]
    law = "" if contact is None else contact.law
    return Phase(
        begin,
        end,
        1,
        "pair-contact",
        f"only {pairs} in contact, and nobody else can reach them before it ends: "
        f"the {law} law has a closed form, exact",
    )


def packages(phases: tuple[Phase, ...]) -> tuple[str, ...]:
    """What the page of this scene has to carry beside the standard library."""
    return tuple(sorted({name for phase in phases for name in phase.packages}))


def not_simulated(scene: Scene) -> tuple[str, ...]:
    """Effects that this program knows and this scene does not call for."""
    listed = {effect.kind for effect in scene.effects}
    return tuple(kind for kind in KINDS if kind not in listed)
