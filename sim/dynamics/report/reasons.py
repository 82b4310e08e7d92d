"""Why a phase is solved as it is, in words for teachers."""

from __future__ import annotations

from sim.dynamics.motion.coupled_group import Cluster
from sim.dynamics.motion.flight import Fading, Flight, Slowing
from sim.dynamics.motion.linear_pair import PairPhase
from sim.dynamics.motion.pair_contact import PairContact
from sim.dynamics.result.record import Solved
from sim.dynamics.state.chain import Motion
from sim.effects.forces import FRICTION
from sim.scene.model import Scene

FLIGHT = "nothing touches and no effect acts: every cart keeps its velocity, x = x₀ + v t is exact"
NOTHING_CHANGES = "nothing touches and no force is left over: every cart keeps its velocity, exact"
AT_ONCE = "; an impact takes no time, it is one formula"
STUCK = "; carts that stick together move as one"

FORMS: dict[type, str] = {
    Fading: "linear drag fades exponentially, exact",
    Slowing: "quadratic drag slows as 1/t, x is a logarithm, exact",
}
PARABOLA = "constant forces, x = x₀ + v t + ½ a t² is exact"


def why(scene: Scene, parts: list[Solved], used: frozenset[str]) -> str:
    """One sentence per kind of solver at work; `used` are the names of all solvers of the run."""
    sentences = [
        *_clusters(scene, [p.solver for p in parts if isinstance(p.solver, (Cluster, PairPhase))]),
        *_pairs(scene, [p.solver for p in parts if isinstance(p.solver, PairContact)]),
        *_flights(scene, [p.solver for p in parts if isinstance(p.solver, Flight)]),
    ]
    if sentences:
        return "; ".join(sentences)
    text = NOTHING_CHANGES if scene.effects else FLIGHT
    sudden = [contact for contact in scene.contacts if contact is not None and contact.law in used]
    text += AT_ONCE if any(not contact.joins for contact in sudden) else ""
    return text + (STUCK if any(contact.joins for contact in sudden) else "")


def _pairs(scene: Scene, solvers: list[PairContact]) -> list[str]:
    if not solvers:
        return []
    gaps = sorted(solver.gap for solver in solvers)
    laws = sorted({contact.law for gap in gaps if (contact := scene.contacts[gap]) is not None})
    return [
        f"only {_names(scene, gaps)} in contact, and nobody else can reach them before it ends: "
        f"the law {' and '.join(laws)} has a closed form, exact"
    ]


def _clusters(scene: Scene, solvers: list[Cluster | PairPhase]) -> list[str]:
    found = []
    for solver in solvers:
        touching = [
            gap.index
            for gap, touches in zip(solver.members, solver.touched, strict=True)
            if touches
        ]
        linked = [gap.index for gap in solver.members if gap.links]
        acting = sorted({force.kind for load in solver.loads for force in load.forces})
        acting += [FRICTION] if any(load.grips for load in solver.loads) else []
        causes = []
        if touching:
            causes.append(f"{_names(scene, touching)} in contact")
        if linked:
            kinds = sorted({link.kind for gap in solver.members for link in gap.links})
            causes.append(f"{' and '.join(kinds)} between {_names(scene, linked)}")
        if acting:
            causes.append(f"{' and '.join(acting)}")
        at_once = " at the same time" if len(causes) > 1 or len(touching) > 1 else ""
        found.append(f"{', '.join(causes)}{at_once}: {METHODS[solver.tier]}")
    return list(dict.fromkeys(found))


METHODS = {
    1: "all of it is linear, an oscillation about its place of rest, exact",
    2: "a power series of order 26 in short steps, exact to rounding",
    3: "an adaptive method of order 8 with located events, because this law has no series",
}


def _flights(scene: Scene, solvers: list[Flight]) -> list[str]:
    found = []
    for form in (None, Fading, Slowing):
        own = [
            s for s in solvers if (s.course.sparse if form is None else isinstance(s.course, form))
        ]
        if not own:
            continue
        kinds = sorted({force.kind for solver in own for force in solver.load.forces})
        kinds += [FRICTION] if any(solver.load.grips for solver in own) else []
        names = " and ".join(dict.fromkeys(n for s in own for n in _carts(scene, s)))
        text = PARABOLA if form is None else FORMS[form]
        found.append(f"{' and '.join(kinds)} on {names}, touched by nobody: {text}")
    return found


def _form(solver: Flight) -> type | None:
    return None if solver.course.sparse else type(solver.course)


def _carts(scene: Scene, solver: Flight) -> list[str]:
    return [scene.carts[k].name for k in solver.carts]


def _names(scene: Scene, gaps: list[int]) -> str:
    return " and ".join(f"{a} with {b}" for a, b in map(scene.names_at, gaps))


def packages(solver: Motion) -> tuple[str, ...]:
    """What the solver needs beside the standard library."""
    return ("numpy", "scipy") if solver.tier == 3 else ()
