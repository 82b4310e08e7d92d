"""Where the energy of a run is at every sample: the account of `ledger`, spread over time.

    start + given by pushes and releases  =  in motion + stored + warmed

Stored energy is a function of the state: springs and magnets by their own formulas, height
−m g sin(angle) (x − x0), and what squeezed bumpers will give back: e² N²/(2 k) for `bumper`, k d²/2
for the laws with a damper, 2 K d^2.5/5 for hertz. A push is constant, so it has given F times the
way that its cart went meanwhile. What is left over is warm. Only scenes with effects need this, and
only a reader who opens the ledger asks for it.
"""

from __future__ import annotations

import math
from array import array

from sim.dynamics.effects import Acting, acting
from sim.dynamics.finished import Run
from sim.dynamics.ledger import kinetic
from sim.dynamics.trajectory import Trajectory, sample
from sim.scene import Scene
from sim.scene.model import Contact

TOUCH = 1e-12
"""m. An overlap below that is rounding."""

Parts = dict[str, "array[float]"]


def energy_parts(run: Run, samples: Trajectory) -> Parts:
    """Columns in J by name, one value per sample: of `bumpers`, `spring`, `magnets`, `incline`,
    `push`, `release` those that the scene has, and `warmed`."""
    scene, columns = run.scene, samples.columns
    account = _Account(run)
    names = account.names
    found: Parts = {name: array("d") for name in (*names, "warmed")}
    at_first = dict.fromkeys(names, 0.0) | account.stored(
        [c.position for c in scene.carts], [c.velocity for c in scene.carts], {}
    )
    whole = math.fsum([kinetic(scene, [c.velocity for c in scene.carts]), *at_first.values()])
    pairs = {gap: ("F", "-".join(scene.names_at(gap))) for gap in range(len(scene.contacts))}
    times = columns[("t",)]
    for k, t in enumerate(times):
        x = [columns[("x", c.name)][k] for c in scene.carts]
        v = [columns[("v", c.name)][k] for c in scene.carts]
        forces = {gap: columns[key][k] for gap, key in pairs.items() if key in columns}
        stored = account.stored(x, v, forces)
        first_of_two = k + 1 < len(times) and times[k + 1] == t
        given = account.given(x, t, before=first_of_two)
        for name in names:
            found[name].append(stored[name] if name in stored else given[name])
        kept = [kinetic(scene, v), *stored.values()]
        found["warmed"].append(math.fsum([whole, *given.values(), *(-one for one in kept)]))
    return found


class _Account:
    """What does not change in a run: which kinds there are, where pushes begin and end."""

    def __init__(self, run: Run) -> None:
        self.scene = scene = run.scene
        self.acting: tuple[Acting, ...] = acting(scene)
        kinds = {effect.kind for effect in scene.effects}
        lasting = any(contact is not None and contact.stiffness for contact in scene.contacts)
        order = ("spring", "magnets", "incline", "push", "release")
        self.names = (*(["bumpers"] if lasting else []), *(k for k in order if k in kinds))
        number = {cart.name: i for i, cart in enumerate(scene.carts)}
        self.pushes = []
        for effect in scene.effects:
            if effect.kind == "push":
                begin = effect.numbers.get("from", 0.0)
                end = effect.numbers.get("until", math.inf)
                ways = [sample(run, min(t, run.t))[0] for t in (begin, end)]
                i = number[effect.carts[0]]
                self.pushes.append((i, effect.numbers["force"], begin, end, ways[0][i], ways[1][i]))
        happened = {
            (event.t, event.bodies) for event in run.record.events if event.kind == "release"
        }
        self.releases = [
            (at, effect.numbers["energy"])
            for effect in scene.effects
            if effect.kind == "release"
            and ((at := effect.numbers.get("at", 0.0)), effect.between) in happened
        ]

    def stored(self, x: list[float], v: list[float], forces: dict[int, float]) -> dict[str, float]:
        """J by kind. `forces` [N] by gap: all that a pair does to each other, links too."""
        scene = self.scene
        found = {name: 0.0 for name in self.names if name not in ("push", "release")}
        for gap, contact in enumerate(scene.contacts):
            room, rate = _room(scene, x, v, gap)
            between = 0.0
            for one in self.acting:
                link = one.link(gap)
                if link is not None:
                    found[one.kind] += link.energy(max(room, TOUCH))
                    between += link.force(max(room, TOUCH), rate)
            if contact is not None and contact.stiffness:
                found["bumpers"] += _squeezed(contact, -room, forces.get(gap, math.inf) - between)
        for effect in scene.effects:
            if effect.kind == "incline":
                down = scene.gravity * math.sin(effect.numbers["angle"])
                for cart, place in zip(scene.carts, x, strict=True):
                    if cart.name in effect.carts:
                        found["incline"] -= cart.mass * down * (place - cart.position)
        return found

    def given(self, x: list[float], t: float, *, before: bool) -> dict[str, float]:
        """J by kind up to t; `before`: this is the first of two samples at a jump."""
        found = {name: 0.0 for name in self.names if name in ("push", "release")}
        for i, force, begin, end, start, stop in self.pushes:
            if t > begin:
                found["push"] += force * ((x[i] if t < end else stop) - start)
        for at, energy in self.releases:
            if t > at or (t == at and not before):
                found["release"] += energy
        return found


def _room(scene: Scene, x: list[float], v: list[float], gap: int) -> tuple[float, float]:
    """m and m/s: room between the bodies of a gap, and how fast it grows."""
    count = len(scene.carts)
    left = x[gap - 1] + scene.carts[gap - 1].length / 2 if gap else 0.0
    right = x[gap] - scene.carts[gap].length / 2 if gap < count else scene.track.length or 0.0
    return right - left, (v[gap] if gap < count else 0.0) - (v[gap - 1] if gap else 0.0)


def _squeezed(contact: Contact, overlap: float, force: float) -> float:
    """J. What the bumpers of a pair give back; infinite force: not known, as at the start."""
    stiffness = contact.stiffness or 0.0
    if overlap <= TOUCH or force <= 0.0:
        return 0.0
    if contact.law == "hertz":
        return 0.4 * stiffness * float(overlap**2.5)
    if contact.law != "bumper":
        return 0.5 * stiffness * overlap**2
    push = min(force, stiffness * overlap)
    return ((contact.restitution or 0.0) * push) ** 2 / (2.0 * stiffness)
