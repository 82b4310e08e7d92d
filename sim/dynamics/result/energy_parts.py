"""Where the energy of a run is at every sample: the account of `ledger`, spread over time.

    start + given by pushes and releases  =  in motion + stored + warmed

Stored energy is a function of the state: springs and magnets by their own formulas, a force that
stores it in a cart's place −F (x − x0), and what squeezed bumpers will give back: e² N²/(2 k) for
`bumper`, k d²/2 for the laws with a damper, 2 K d^2.5/5 for hertz. A steady force that stores
nothing has given F times the way that its cart went meanwhile. What is left over is warm. Only
scenes with effects need this, and only a reader who opens the ledger asks for it.
"""

from __future__ import annotations

import math
from array import array
from dataclasses import dataclass
from itertools import pairwise

from sim.dynamics.result.finished import Run
from sim.dynamics.result.ledger import kinetic
from sim.dynamics.result.trajectory import Trajectory, sample
from sim.effects.forces import Acting, BodyForce, acting
from sim.laws.lookup import contact_law
from sim.scene.effects import kinds
from sim.scene.model import Contact, Scene

TOUCH = 1e-12
"""m. An overlap below that is rounding."""

ROUNDING = 1e-14
"""Of the forces of springs between two. What is left beside them of a force is none."""

Parts = dict[str, "array[float]"]


def energy_parts(run: Run, samples: Trajectory) -> Parts:
    """Columns in J by name, one value per sample: of `bumpers`, `spring`, `magnets`, `incline`,
    `push`, `release` those that the scene has, and `warmed`."""
    scene, columns = run.scene, samples.columns
    account = _Account(run)
    names = account.names
    found: Parts = {name: array("d") for name in (*names, "warmed")}
    at_first = dict.fromkeys(names, 0.0) | account.stored(
        [c.position for c in scene.carts], [c.velocity for c in scene.carts], 0.0, {}, before=True
    )
    whole = math.fsum([kinetic(scene, [c.velocity for c in scene.carts]), *at_first.values()])
    pairs = {gap: ("F", "-".join(scene.names_at(gap))) for gap in range(len(scene.contacts))}
    times = columns[("t",)]
    for k, t in enumerate(times):
        x = [columns[("x", c.name)][k] for c in scene.carts]
        v = [columns[("v", c.name)][k] for c in scene.carts]
        forces = {gap: columns[key][k] for gap, key in pairs.items() if key in columns}
        first_of_two = k + 1 < len(times) and times[k + 1] == t
        stored = account.stored(x, v, t, forces, before=first_of_two)
        given = account.given(x, t, before=first_of_two)
        for name in names:
            found[name].append(stored[name] if name in stored else given[name])
        kept = [kinetic(scene, v), *stored.values()]
        found["warmed"].append(math.fsum([whole, *given.values(), *(-one for one in kept)]))
    return found


@dataclass(frozen=True, slots=True)
class _Given:
    """A steady force [N] on a cart, from `begin` to `end` s, between two of its places [m]."""

    kind: str
    cart: int
    force: float
    begin: float
    end: float
    start: float
    stop: float

    def work(self, x: list[float], t: float) -> float:
        """J up to t."""
        return self.force * ((x[self.cart] if t < self.end else self.stop) - self.start)


class _Account:
    """What does not change in a run: who stores energy, and who brings it when."""

    def __init__(self, run: Run) -> None:
        self.scene = scene = run.scene
        self.acting = acting(scene)
        lasting = any(contact is not None and contact.stiffness for contact in scene.contacts)
        listed = {effect.kind for effect in scene.effects}
        of = {name: [e for e in scene.effects if e.kind == name] for name in listed}
        known = {name: kind for name, kind in kinds().items() if name in listed}
        in_gaps, in_places = (
            [k for k, kind in known.items() if any(kind.keeps(e) == way for e in of[k])]
            for way in ("gap", "place")
        )
        self.giving = [name for name, kind in known.items() if kind.gives]
        self.storing = [*(["bumpers"] if lasting else []), *in_gaps, *in_places]
        self.names = tuple(dict.fromkeys((*self.storing, *self.giving)))
        self.joints = run.record.joints
        self.heights, self.pushes = _body_forces(run, self.acting)
        happened = {(e.t, e.bodies) for e in run.record.events if e.kind == "release"}
        every = [release for effect in self.acting for release in effect.releases()]
        self.releases = [
            release
            for release in every
            if release.spring is None and (release.time, scene.names_at(release.gap)) in happened
        ]
        let_go = {one.of.index: one for one in run.record.let_go}
        self.springs = [
            (release, let_go.get(release.index)) for release in every if release.spring is not None
        ]

    def stored(
        self, x: list[float], v: list[float], t: float, forces: dict[int, float], *, before: bool
    ) -> dict[str, float]:
        """J by kind at t s. `forces` [N] by gap: all that a pair does to each other, links too.

        `before`: this is the first of two samples at a jump.
        """
        scene = self.scene
        found = dict.fromkeys(self.storing, 0.0)
        for gap, contact in enumerate(scene.contacts):
            room, rate = _room(scene, x, v, gap)
            between = 0.0
            for one in self.acting:
                link = one.pair_force(gap)
                if link is not None:
                    near = room if link.linear else max(room, TOUCH)
                    found[one.kind] += link.energy(near)
                    between += link.force(near, rate)
            for release, loose in self.springs:
                if release.gap != gap:
                    continue
                if loose is None or t < loose.begun[0]:
                    found[release.kind] += release.energy
                elif t <= loose.ended:
                    found[release.kind] += loose.link.energy(room)
                    between += loose.link.force(room, rate)
            if contact is not None and contact.stiffness and self._latched(gap, t, before=before):
                found["bumpers"] += _squeezed(contact, -room, math.inf)
            elif contact is not None and contact.stiffness:
                own = forces.get(gap, math.inf) - between
                found["bumpers"] += _squeezed(contact, -room, own, ROUNDING * abs(between))
        for cart, force in self.heights:
            found[force.kind] -= force.steady * (x[cart] - scene.carts[cart].position)
        return found

    def _latched(self, gap: int, t: float, *, before: bool) -> bool:
        """Does an exploder's latch hold these bumpers as they are? Their force is not told then."""
        ends = (joint.end for joint in self.joints if joint.gap == gap)
        return any(t < end or (t == end and before) for end in ends)

    def given(self, x: list[float], t: float, *, before: bool) -> dict[str, float]:
        """J by kind up to t; `before`: this is the first of two samples at a jump."""
        found = dict.fromkeys(self.giving, 0.0)
        for one in self.pushes:
            if t > one.begin:
                found[one.kind] += one.work(x, t)
        for release in self.releases:
            if t > release.time or (t == release.time and not before):
                found[release.kind] += release.energy
        return found


def _body_forces(
    run: Run, effects: tuple[Acting, ...]
) -> tuple[list[tuple[int, BodyForce]], list[_Given]]:
    """Steady forces by cart: those whose work is stored, and those that bring energy."""
    stored: list[tuple[int, BodyForce]] = []
    given: list[_Given] = []
    for effect in effects:
        kind = kinds()[effect.kind]
        times = sorted({0.0, *effect.switches(), math.inf})
        for k in range(len(run.scene.carts)):
            for begin, end in pairwise(times):
                one = effect.body_force(k, begin)
                if one is None or not one.steady:
                    continue
                if kind.stores:
                    stored.append((k, one))
                    continue
                if not kind.gives:
                    raise ValueError(f"{kind.name} brings energy: it needs gives or stores")
                start, stop = (sample(run, min(t, run.t))[0][k] for t in (begin, end))
                given.append(_Given(kind.name, k, one.steady, begin, end, start, stop))
    return stored, given


def _room(scene: Scene, x: list[float], v: list[float], gap: int) -> tuple[float, float]:
    """m and m/s: room between the bodies of a gap, and how fast it grows."""
    count = len(scene.carts)
    left = x[gap - 1] + scene.carts[gap - 1].length / 2 if gap else 0.0
    right = x[gap] - scene.carts[gap].length / 2 if gap < count else scene.track.length or 0.0
    return right - left, (v[gap] if gap < count else 0.0) - (v[gap - 1] if gap else 0.0)


def _squeezed(contact: Contact, overlap: float, force: float, least: float = 0.0) -> float:
    """J. What the bumpers of a pair give back; infinite force: not known, as at the start.

    Parted ones that overlap have no force; `least` [N] is what rounding may leave of it.
    """
    law = contact_law(contact)
    if law is None or overlap <= TOUCH:
        return 0.0
    return law.stored_under(overlap, force if abs(force) > least else 0.0)
