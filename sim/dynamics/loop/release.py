"""The exploder at work: two carts that are latched together, and the instant that parts them."""

from __future__ import annotations

import math

from sim.dynamics.loop import contacts
from sim.dynamics.result.ledger import Ledger
from sim.dynamics.result.record import Record
from sim.dynamics.state.body import Body, Gap
from sim.dynamics.state.chain import Chain
from sim.dynamics.state.clock import ZERO, Time
from sim.effects.forces import EnergyRelease

TOUCHING = 1e-12
"""m. Room that rounding leaves between two carts that touch."""


def latch(chain: Chain, release: EnergyRelease, record: Record) -> None:
    """Two that touch at the start with one velocity stay together until they are set free."""
    gap = chain.gaps[release.gap]
    if gap is not None and gap.room <= 0.0 and gap.rate == 0.0 and not gap.joined:
        contacts.merge(chain, gap, ZERO, record)


def set_free(
    chain: Chain, gap: Gap, release: EnergyRelease, now: Time, record: Record, ledger: Ledger
) -> bool:
    """½ mu w'² = ½ mu w² + E for the speed of separation w. False where the two do not touch."""
    if gap.joined:
        split(chain, gap, now, record)
    elif gap.touching is None:
        if gap.room > TOUCHING:
            record.idle_bursts.append((gap.index, now[0], gap.room))
            return False
        gap.rate = gap.right.v - gap.left.v  # others may have pushed them since it was known
    else:  # what their bumpers still hold is no part of the energy
        if gap.law is not None:
            ledger.dissipate(gap.law.stored(-gap.room, -gap.rate, gap.memory))
            contacts.tell_separation(gap, now, contacts.contact_force(gap), record)
        gap.touching = None
    left, right, mu = gap.left, gap.right, gap.mu
    left.held = right.held = False  # that they start is told by the release itself
    before = (left.v, right.v)
    apart = math.sqrt(gap.rate * gap.rate + 2.0 * release.energy / mu)
    impulse = mu * (apart - gap.rate)
    centre = contacts.common_velocity(left, right)
    a, b = contacts.shares(left, right, mu)
    left.v, right.v = centre - a * apart, centre + b * apart
    gap.rate, gap.time = apart, now
    ledger.work(release.kind, release.energy)
    contacts.outside(left, right, impulse, ledger)
    record.event("release", gap, now, before, (left.v, right.v), impulse, None)
    for other in chain.neighbours(gap):
        if other is not None and not other.joined:
            other.rate = other.right.v - other.left.v
            if other.law is None and other.rate != 0.0:
                other.touching = None  # it rested; now it opens, or is struck
    return True


def split(chain: Chain, gap: Gap, now: Time, record: Record) -> None:
    """One body becomes two, left and right of a gap that held it together."""
    one = gap.left
    offsets = dict(zip(one.carts, record.offsets(one), strict=True))
    left = tuple(cart for cart in one.carts if cart < gap.index)
    right = tuple(cart for cart in one.carts if cart >= gap.index)
    other = Body(right, 0.0, one.x + offsets[right[0]], one.v, gap.index, one.right, one.time)
    one.carts, one.right = left, gap.index
    for body in (one, other):
        body.mass = _mass(chain, body, record)
        for cart in body.carts:
            chain.bodies[cart] = body
        for index in range(body.carts[0], body.carts[-1] + 2):
            near = chain.gaps[index]
            if near is None or near is gap:
                continue
            if near.joined:
                near.left = near.right = body
            elif index == body.left:
                near.right = body
            elif index == body.right:
                near.left = body
    gap.left, gap.right, gap.joined, gap.rate = one, other, False, 0.0
    record.part(gap, now)


def _mass(chain: Chain, body: Body, record: Record) -> float:
    """kg. Infinite where the body sticks to a wall."""
    for index, cart in ((0, 0), (len(chain.gaps) - 1, len(chain.bodies) - 1)):
        gap = chain.gaps[index]
        if gap is not None and gap.joined and cart in body.carts:
            return math.inf
    return math.fsum(record.scene.carts[cart].mass for cart in body.carts)
