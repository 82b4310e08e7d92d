"""What a run of a world breaks: momentum and energy that no body gave, observers who disagree.

In ours each of the three is nought. Momentum and energy are the entries under the world's name in
the accounts of its run. For the third the scene is run once more as seen from a train: all
velocities less the train's, u. Galilei: afterwards they are less by u too, whatever acts.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from sim.dynamics.result.outcome import UnsolvedError
from sim.dynamics.result.trajectory import Trajectory
from sim.scene.model import Scene
from sim.scene.said import said
from sim.worlds.describe import World
from sim.worlds.follow import WorldRun, follow

NOISE = 1e-4
"""Of all momentum or energy in play. What is less came from located steps, and is called nought."""

TRAIN = 0.5
"""m/s, to the right."""


@dataclass(frozen=True, slots=True)
class Broken:
    """What no body gave, and what two observers say of one cart's velocity at the end."""

    momentum: float  # N s
    most: float  # N s, the largest that was there without a giver at any time
    energy: float  # J
    slower: bool  # is there less momentum than at the start?
    observers: tuple[str, float, float] | None  # cart, m/s on the ground, m/s told from the train

    @property
    def sentences(self) -> list[str]:
        """For a reader; at least one."""
        found = []
        if self.momentum:
            found.append(_momentum(self.momentum, gone=self.slower))
        elif self.most:
            found.append(
                said(
                    "For a while {amount} of momentum were there that no body gave.",
                    amount=f"{abs(self.most):.3g} N s",
                )
            )
        if self.energy:
            found.append(_energy(self.energy))
        if self.observers is not None:
            cart, ground, train = self.observers
            found.append(
                said(
                    "Two observers disagree: on the ground {cart} ends with {ground}; "
                    "from a train the same world gives it {train}.",
                    cart=cart,
                    ground=_speed(ground),
                    train=_speed(train),
                )
            )
        return found or [said("What runs into it goes on as if nothing were there.")]


def _momentum(value: float, *, gone: bool) -> str:
    size = f"{abs(value):.2g} N s"
    if gone:
        return said("{amount} of momentum are gone, and nobody has them.", amount=size)
    return said("{amount} of momentum came from nowhere.", amount=size)


def _energy(value: float) -> str:
    size = f"{abs(value):.2g} J"
    if value > 0.0:
        return said("{amount} of energy came from nowhere.", amount=size)
    return said("{amount} of energy are gone, and nothing has become warm.", amount=size)


def _speed(v: float) -> str:
    text = f"{v:.2f}".replace("-0.00", "0.00")
    return f"{text} m/s".replace("-", "\N{MINUS SIGN}")


def broken(done: WorldRun) -> Broken:
    """What a run has broken."""
    books, name = done.run.ledger, done.world.kind.name
    scale_p = math.fsum(c.mass * abs(u) for c, u in zip(done.scene.carts, done.run.v, strict=True))
    scale_p += math.fsum(cart.mass * abs(cart.velocity) for cart in done.scene.carts)
    scale_e = abs(books.energy_initial) + abs(books.energy_final) + abs(books.warmed)
    return Broken(
        momentum=_beyond(books.impulses.get(name, 0.0), scale_p),
        most=_beyond(_most(done.samples, name), scale_p),
        energy=_beyond(books.works.get(name, 0.0), scale_e),
        slower=abs(books.momentum_final) < abs(books.momentum_initial),
        observers=_observers(done.scene, done.world, done),
    )


def _beyond(value: float, scale: float) -> float:
    return value if abs(value) > NOISE * scale else 0.0


def _most(samples: Trajectory, name: str) -> float:
    """N s. The largest sum of impulses from nowhere, by trapezia through the samples."""
    times = samples.columns[("t",)]
    forces = [column for key, column in samples.columns.items() if key[:2] == ("E", name)]
    total = most = 0.0
    for k in range(1, len(times)):
        mean = math.fsum(column[k - 1] + column[k] for column in forces) / 2.0
        total += mean * (times[k] - times[k - 1])
        most = total if abs(total) > abs(most) else most
    return most


def _observers(scene: Scene, world: World, seen: WorldRun) -> tuple[str, float, float] | None:
    """Where walls stand the ground is not like the train, and in ours no world moves."""
    if not world.kind.moves or "wall" in (scene.track.left, scene.track.right):
        return None
    carts = tuple(replace(cart, velocity=cart.velocity - TRAIN) for cart in scene.carts)
    try:
        other = follow(replace(scene, carts=carts), world)
    except UnsolvedError:
        return None
    pairs = zip(scene.carts, seen.run.v, other.run.v, strict=True)
    told = [(cart.name, v, u + TRAIN) for cart, v, u in pairs]
    worst = max(told, key=lambda one: abs(one[1] - one[2]))
    fastest = max(abs(TRAIN), *(abs(v) for v in seen.run.v))
    return worst if abs(worst[1] - worst[2]) > NOISE * fastest else None
