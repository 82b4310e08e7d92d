"""Why a phase is solved as it is, in words for teachers."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, cast

from sim.dynamics.motion.courses import Fading, Slowing
from sim.dynamics.motion.drag_course import Driven
from sim.dynamics.motion.flight import Flight
from sim.dynamics.result.record import Solved
from sim.dynamics.state.body import Motion
from sim.effects.forces import FRICTION
from sim.scene.model import Scene
from sim.scene.said import listed, said, template
from sim.scene.track import body_name

if TYPE_CHECKING:
    from sim.dynamics.motion.coupled_group import CoupledGroup
    from sim.dynamics.motion.linear_pair import LinearPair
    from sim.dynamics.motion.modes.group import ModalGroup

    InRows = CoupledGroup | LinearPair | ModalGroup

FLIGHT = said(
    "nothing touches and no effect acts: every cart keeps its velocity, x = x₀ + v t is exact"
)
NOTHING_CHANGES = said(
    "nothing touches and no force is left over: every cart keeps its velocity, exact"
)
AT_ONCE = said("an impact takes no time, it is one formula")
STUCK = said("carts that stick together move as one")

FORMS: dict[type, str] = {
    Fading: said("linear drag fades exponentially, exact"),
    Slowing: said("quadratic drag slows as 1/t, x is a logarithm, exact"),
    Driven: said("drag beside other forces: v is a tangent or a hyperbolic tangent, exact"),
}
PARABOLA = said("constant forces, x = x₀ + v t + ½ a t² is exact")


def why(scene: Scene, parts: list[Solved], used: frozenset[str]) -> str:
    """One sentence per kind of solver at work; `used` are the names of all solvers of the run."""
    rows = [p.solver for p in parts if p.solver.name != ALONE and not isinstance(p.solver, Flight)]
    sentences = [
        *_clusters(scene, [cast("InRows", s) for s in rows]),
        *_pairs(scene, [p.solver.gaps[0] for p in parts if p.solver.name == ALONE]),
        *_flights(scene, [p.solver for p in parts if isinstance(p.solver, Flight)]),
    ]
    if sentences:
        return _one_after_the_other(sentences)
    sudden = [contact for contact in scene.contacts if contact is not None and contact.law in used]
    sentences = [NOTHING_CHANGES if scene.effects else FLIGHT]
    sentences += [AT_ONCE] if any(not contact.joins for contact in sudden) else []
    sentences += [STUCK] if any(contact.joins for contact in sudden) else []
    return _one_after_the_other(sentences)


def _one_after_the_other(sentences: Sequence[str]) -> str:
    *first, last = sentences
    if not first:
        return last
    return said("{first}; {last}", first=_one_after_the_other(first), last=last)


ALONE = "pair-contact"


def _pairs(scene: Scene, gaps: list[int]) -> list[str]:
    if not gaps:
        return []
    gaps = sorted(gaps)
    laws = sorted({contact.law for gap in gaps if (contact := scene.contacts[gap]) is not None})
    return [
        said(
            "only {pairs} in contact, and nobody else touches them meanwhile: "
            "one formula gives the contact, exact (law: {law})",
            pairs=_names(scene, gaps),
            law=listed(laws),
        )
    ]


def _clusters(scene: Scene, solvers: list[InRows]) -> list[str]:
    found = []
    for solver in solvers:
        touching = [
            gap.index
            for gap, touches in zip(solver.members, solver.touched, strict=True)
            if touches
        ]
        linked = [gap.index for gap, own in zip(solver.members, solver.linked, strict=True) if own]
        acting = sorted({force.kind for load in solver.loads for force in load.forces})
        acting += [FRICTION] if any(load.grips for load in solver.loads) else []
        causes: list[str] = []
        if touching:
            causes.append(said("{pairs} in contact", pairs=_names(scene, touching)))
        if linked:
            kinds = sorted({kind for own in solver.linked for kind in own})
            pairs = _names(scene, linked)
            causes.append(said("{links} between {pairs}", links=_effects(kinds), pairs=pairs))
        if acting:
            causes.append(_effects(acting))
        together = _with_commas(causes)
        if len(causes) > 1 or len(touching) > 1:
            together = said("{causes} at the same time", causes=together)
        found.append(
            said(METHODS[SWINGS if solver.name == SWINGS else solver.tier], causes=together)
        )
    return list(dict.fromkeys(found))


SWINGS = "modes"

METHODS = {
    1: template("{causes}: all of it is linear, an oscillation about its place of rest, exact"),
    SWINGS: template(
        "{causes}: all of it is linear, a sum of damped oscillations about the place of rest, exact"
    ),
    2: template("{causes}: a power series of order 26 in short steps, exact to rounding"),
    3: template(
        "{causes}: an adaptive method of order 8 with located events, "
        "because this law has no series"
    ),
}


def _with_commas(causes: Sequence[str]) -> str:
    *first, last = causes
    return said("{first}, {last}", first=_with_commas(first), last=last) if first else last


def _effects(names: Sequence[str]) -> str:
    return listed([said(name) for name in names])


def _flights(scene: Scene, solvers: list[Flight]) -> list[str]:
    found: list[str] = []
    for form in (None, *FORMS):
        own = [
            s for s in solvers if (s.course.sparse if form is None else isinstance(s.course, form))
        ]
        if not own:
            continue
        kinds = sorted({force.kind for solver in own for force in solver.load.forces})
        kinds += [FRICTION] if any(solver.load.grips for solver in own) else []
        names = dict.fromkeys(n for s in own for n in _carts(scene, s))
        found.append(
            said(
                "{forces} on {carts}, touched by nobody: {how}",
                forces=_effects(kinds),
                carts=listed(list(names)),
                how=PARABOLA if form is None else FORMS[form],
            )
        )
    return found


def _carts(scene: Scene, solver: Flight) -> list[str]:
    return [scene.carts[k].name for k in solver.carts]


def _names(scene: Scene, gaps: list[int]) -> str:
    pairs = ([body_name(name, scene.track) for name in scene.names_at(gap)] for gap in gaps)
    return listed([said("{a} with {b}", a=a, b=b) for a, b in pairs])


def packages(solver: Motion) -> tuple[str, ...]:
    """What the solver needs beside the standard library."""
    return ("numpy", "scipy") if solver.tier == 3 else ()
