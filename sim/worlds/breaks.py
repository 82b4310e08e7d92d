"""What a run of a world breaks: momentum and energy that no body gave, observers who disagree.

In ours each of the three is nought. Momentum and energy are the entries under the world's name in
the accounts of its run. For the third the scene is run once more as seen from a train: all
velocities less the train's, u. Galilei: afterwards they are less by u too, whatever acts.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from sim.dynamics.result.outcome import UnsolvedError
from sim.effects.forces import Acting, acting
from sim.scene.model import Scene
from sim.scene.said import said
from sim.worlds.describe import World
from sim.worlds.follow import WorldRun, follow
from sim.worlds.sentences import Way, energy_said, momentum_said, most_said, observers_said, speed

NOISE = 1e-4
"""Of all momentum or energy in play. What is less came from located steps, and is called nought."""

TRAIN = 0.5
"""m/s, to the right."""


@dataclass(frozen=True, slots=True)
class Broken:
    """What no body gave, and what two observers say of one cart's velocity at the end."""

    momentum: float  # N s
    most: float  # N s, the largest that was there without a giver at any time
    way: Way  # whether there was less momentum by it, or more
    energy: float  # J
    observers: tuple[str, float, float] | None  # cart, m/s on the ground, m/s told from the train
    nothing: str  # what to say where nothing breaks

    @property
    def sentences(self) -> list[str]:
        """For a reader; at least one."""
        found = []
        if self.momentum:
            found.append(momentum_said(self.momentum, self.way))
        elif self.most:
            found.append(most_said(self.most))
        if self.energy:
            found.append(energy_said(self.energy))
        if self.observers is not None:
            found.append(observers_said(*self.observers))
        return found or [said(self.nothing)]


def broken(done: WorldRun) -> Broken:
    """What a run has broken."""
    books, name = done.run.ledger, done.world.kind.name
    scale_p = math.fsum(c.mass * abs(u) for c, u in zip(done.scene.carts, done.run.v, strict=True))
    scale_p += math.fsum(cart.mass * abs(cart.velocity) for cart in done.scene.carts)
    scale_e = abs(books.energy_initial) + abs(books.energy_final) + abs(books.warmed)
    most, way = _from_nowhere(done, name, scale_p)
    return Broken(
        momentum=_beyond(books.impulses.get(name, 0.0), scale_p),
        most=_beyond(most, scale_p),
        way=way,
        energy=_beyond(books.works.get(name, 0.0), scale_e),
        observers=_observers(done.scene, done.world, done),
        nothing=done.world.kind.nothing,
    )


def _beyond(value: float, scale: float) -> float:
    return value if abs(value) > NOISE * scale else 0.0


def _from_nowhere(done: WorldRun, name: str, scale: float) -> tuple[float, Way]:
    """N s, the largest sum of impulses from nowhere at any time, by trapezia through the samples;
    and whether they went along with all momentum that was there.

    Start and end do not tell it: a cart that a hand has pushed, and that the world has stopped
    again, has no momentum at either. `both`: they turned all momentum round, or went to both sides
    (before a wall and after it), so that nothing simple can be said of their sum.
    """
    columns = done.samples.columns
    times = columns[("t",)]
    forces = [column for key, column in columns.items() if key[:2] == ("E", name)]
    moving = [(cart.mass, columns["v", cart.name]) for cart in done.scene.carts]
    total = most = along = against = right = left = 0.0
    for k in range(1, len(times)):
        mean = math.fsum(column[k - 1] + column[k] for column in forces) / 2.0
        part = mean * (times[k] - times[k - 1])
        total += part
        most = total if abs(total) > abs(most) else most
        right, left = right + max(part, 0.0), left + max(-part, 0.0)
        if part * math.fsum(mass * (v[k - 1] + v[k]) for mass, v in moving) < 0.0:
            against += abs(part)
        else:
            along += abs(part)
    if min(along, against) > NOISE * scale or min(right, left) > NOISE * scale:
        return most, "both"
    return most, "gone" if against > along else "came"


def _observers(scene: Scene, world: World, seen: WorldRun) -> tuple[str, float, float] | None:
    """Where the ground acts it is not like the train: in ours, too, two would not agree there."""
    if not world.kind.moves or _ground(scene):
        return None
    carts = tuple(replace(cart, velocity=cart.velocity - TRAIN) for cart in scene.carts)
    try:
        other = follow(replace(scene, carts=carts), world)
    except UnsolvedError:
        return None
    pairs = zip(scene.carts, seen.run.v, other.run.v, strict=True)
    told = [(cart.name, v, u + TRAIN) for cart, v, u in pairs]
    worst = max(told, key=lambda one: abs(one[1] - one[2]))
    return worst if speed(worst[1]) != speed(worst[2]) else None  # as a reader compares them


def _ground(scene: Scene) -> bool:
    """Does anything act that stands on the ground: a wall, friction, air at rest?"""
    if "wall" in (scene.track.left, scene.track.right):
        return True
    return any(_holds_on(one, k) for one in acting(scene) for k in range(len(scene.carts)))


def _holds_on(effect: Acting, cart: int) -> bool:
    """Does it slow the cart down as seen from the ground?"""
    if effect.friction(cart) is not None:
        return True
    forces = (effect.body_force(cart, t) for t in (0.0, *effect.switches()))
    return any(force is not None and (force.linear or force.quadratic) for force in forces)
