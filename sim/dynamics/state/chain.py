"""The row of one run: who stands beside whom, who pushes whom, and how far each moves."""

from __future__ import annotations

import math
from functools import cached_property

from sim.dynamics.state.body import Body, Gap
from sim.dynamics.state.clock import Time, elapsed
from sim.dynamics.state.loads import Forces
from sim.laws.contact_law import ContactLaw
from sim.laws.lookup import contact_law
from sim.scene.model import Contact, Scene


class Chain:
    """Bodies and gaps of one run."""

    def __init__(self, scene: Scene, forces: Forces | None) -> None:
        self.scene, count = scene, len(scene.carts)
        self.bodies = [
            Body((k,), cart.mass, cart.position, cart.velocity, k, k + 1)
            for k, cart in enumerate(scene.carts)
        ]
        row = [None, *self.bodies, None]
        self.gaps: list[Gap | None] = []
        known: Contact | None = None
        law: ContactLaw | None = None
        for k, contact in enumerate(scene.contacts):
            if contact is None:
                self.gaps.append(None)
                continue
            if contact is not known:
                known, law = contact, contact_law(contact)
            left, right = row[k] or _wall(scene, 0), row[k + 1] or _wall(scene, count)
            gap = Gap(k, left, right, scene.gaps[k], scene.approaches[k], contact, law)
            if forces is not None:
                gap.links = forces.links[k]
            self.gaps.append(gap)

    @cached_property
    def length(self) -> float:
        """m. Of the longest cart; of carts without one the least room, 0.2 m where all touch."""
        rooms = [room for room in self.scene.gaps if 0.0 < room < math.inf]
        return max(cart.length for cart in self.scene.carts) or min(rooms, default=0.2)

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
        if gap.spent and gap.law is not None:
            gap.spent = gap.room + gap.law.resting_overlap(gap.memory) < 0.0


def _wall(scene: Scene, gap: int) -> Body:
    """What stands at one end, where it is not open."""
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


def place(body: Body, now: Time) -> None:
    """Bring a body's position to `now`; walls stay."""
    if body.carts:
        body.x += moved(body, body.time, now)
        body.time = now


def velocity(body: Body, now: Time) -> float:
    """m/s at `now`."""
    return body.v if body.motion is None else body.motion.velocity(body, now)
