"""The moving state of a run: bodies in a row, the gaps between them, contacts in progress.

    gap 0   body 0   gap 1   body 1   ...   body n−1   gap n      a wall is a body of infinite mass

Gaps and closing speeds are the state; positions are carried along for show. A gap of carts at
x = 1e9 m is as exact as one at the origin. Each body and each gap has its own last time: an event
touches only its neighbourhood, so the cost of an event does not grow with the number of carts.
"""

from __future__ import annotations

import math
from collections.abc import Hashable
from dataclasses import dataclass, field
from functools import lru_cache
from typing import TYPE_CHECKING

from sim.dynamics.motion.coupled_group import Cluster
from sim.dynamics.motion.flight import Flight
from sim.dynamics.motion.linear_pair import PairPhase
from sim.dynamics.motion.pair_contact import PairContact
from sim.dynamics.state.clock import ZERO, Time, elapsed
from sim.dynamics.state.loads import NO_LOAD, Forces, Load
from sim.dynamics.state.touching import Touching
from sim.laws.contact_law import ContactLaw, Figures
from sim.laws.lookup import contact_law
from sim.scene.model import Contact, Scene

if TYPE_CHECKING:
    from sim.effects.forces import PairForce

Solver = PairContact | PairPhase | Cluster
Motion = PairContact | PairPhase | Cluster | Flight


@dataclass(slots=True, eq=False)
class Body:
    """One cart, several that are stuck together, or a wall. `x` is its state at time `time`."""

    carts: tuple[int, ...]  # indices in the scene; empty: a wall
    mass: float  # kg
    x: float  # m, of the first cart's centre
    v: float  # m/s
    left: int  # gap on its left
    right: int  # gap on its right
    time: Time = ZERO
    motion: Motion | None = None  # None: free flight
    load: Load = NO_LOAD  # effects that act on it
    sliding: int = 0  # direction in which friction sees it slide
    held: bool = False  # by static friction
    slips: int = 0  # direction in which it has just overcome static friction
    turn: int = 0  # counts predictions, as those of gaps


@dataclass(slots=True, eq=False)
class Gap:
    """The room between two neighbours, edge to edge; negative: their bumpers overlap."""

    index: int
    left: Body
    right: Body
    room: float  # m, at `time`
    rate: float  # m/s, right velocity minus left
    contact: Contact
    law: ContactLaw | None
    time: Time = ZERO
    memory: float = 0.0  # m, of the bumper
    turn: int = 0  # counts predictions: an older one in the calendar is void
    touching: Touching | None = None
    links: tuple[PairForce, ...] = ()  # springs and magnets across it
    solver: Solver | None = None  # what moves it, while it touches or is linked
    joined: bool = False
    clear_at: Time | None = None  # when its overlap will have cleared, if that is known
    _figures: tuple[float, Figures] | None = field(default=None)

    @property
    def member(self) -> bool:
        """Do its two bodies push or pull each other?"""
        return self.touching is not None or (bool(self.links) and not self.joined)

    @property
    def mu(self) -> float:
        """Reduced mass in kg."""
        a, b = self.left.mass, self.right.mass
        if a == math.inf:
            return b
        return a if b == math.inf else a * b / (a + b)

    def figures(self, mu: float) -> Figures:
        """Those of the gap's law, computed once per reduced mass."""
        if self._figures is None or self._figures[0] != mu:
            assert self.law is not None
            self._figures = (mu, figures_of(self.law, mu))  # type: ignore[arg-type]
        return self._figures[1]


@lru_cache(maxsize=4096)
def figures_of(law: Hashable, mu: float) -> Figures:
    """The same pair meets again and again, in this run and in the next."""
    return law.figures(mu)  # type: ignore[attr-defined, no-any-return]


class Chain:
    """Bodies and gaps of one run."""

    def __init__(self, scene: Scene, forces: Forces | None) -> None:
        count = len(scene.carts)
        self.bodies = [
            Body((k,), cart.mass, cart.position, cart.velocity, k, k + 1)
            for k, cart in enumerate(scene.carts)
        ]
        row = [_wall(scene, 0), *self.bodies, _wall(scene, count)]
        self.gaps: list[Gap | None] = []
        known: Contact | None = None
        law: ContactLaw | None = None
        for k, contact in enumerate(scene.contacts):
            if contact is None:
                self.gaps.append(None)
                continue
            if contact is not known:
                known, law = contact, contact_law(contact)
            left, right = row[k], row[k + 1]
            gap = Gap(k, left, right, scene.gaps[k], scene.approaches[k], contact, law)
            if forces is not None:
                gap.links = forces.links[k]
            self.gaps.append(gap)

    def neighbours(self, gap: Gap) -> tuple[Gap | None, Gap | None]:
        """The gaps beyond the two bodies of `gap`; None beyond a wall or on an open side."""
        left = self.gaps[gap.left.left] if gap.left.carts else None
        right = self.gaps[gap.right.right] if gap.right.carts else None
        return left, right

    def advance(self, gap: Gap, now: Time) -> None:
        """Bring the room of a gap that is not touching to `now`."""
        if gap.left.motion is None and gap.right.motion is None:
            gap.room += gap.rate * elapsed(gap.time, now)
        else:
            gap.room += moved(gap.right, gap.time, now) - moved(gap.left, gap.time, now)
        gap.time = now
        cleared = gap.clear_at is not None and elapsed(gap.clear_at, now) >= 0.0
        if gap.room >= 0.0 or cleared:
            gap.memory, gap.clear_at = 0.0, None


def _wall(scene: Scene, gap: int) -> Body:
    """What stands at one end; on an open side nobody asks."""
    if gap == 0:
        return Body((), math.inf, 0.0, 0.0, -1, 0)
    return Body((), math.inf, scene.track.length or 0.0, 0.0, gap, -1)


def component(chain: Chain, body: Body) -> tuple[list[Body], list[Gap]]:
    """The bodies that push each other with `body` among them, and the gaps between; left to right.

    Walls belong to no component: they do not move.
    """
    bodies: list[Body] = [body]
    gaps: list[Gap] = []
    while (gap := chain.gaps[bodies[0].left]) is not None and gap.member:
        gaps.insert(0, gap)
        if not gap.left.carts:
            break
        bodies.insert(0, gap.left)
    while (gap := chain.gaps[bodies[-1].right]) is not None and gap.member:
        gaps.append(gap)
        if not gap.right.carts:
            break
        bodies.append(gap.right)
    return bodies, gaps


def moved(body: Body, start: Time, end: Time) -> float:
    """m. How far a body goes between two times with no event of its own in between."""
    if body.motion is None:
        return body.v * elapsed(start, end)
    return body.motion.shift(body, start, end)


def velocity(body: Body, now: Time) -> float:
    """m/s at `now`."""
    return body.v if body.motion is None else body.motion.velocity(body, now)
