"""The exploder at work: two carts that are latched together, and what parts them.

That is one instant, or a spring that lies between the two from then on: a link, until it falls off.
"""

from __future__ import annotations

import math

from sim.dynamics.loop import contacts, impacts, pair_laws
from sim.dynamics.result.ledger import Ledger
from sim.dynamics.result.record import Record
from sim.dynamics.state.body import Body, Gap
from sim.dynamics.state.chain import Chain
from sim.dynamics.state.clock import ZERO, Time
from sim.dynamics.state.touching import Loose
from sim.effects.forces import TOUCHING, EnergyRelease, LooseForce


def latch(chain: Chain, release: EnergyRelease, record: Record, ledger: Ledger) -> None:
    """Two that touch at the start with one velocity stay together until they are set free.

    Bumpers that overlap hold their energy meanwhile, as those of any overlap at the start do.
    """
    gap = chain.gaps[release.gap]
    if gap is not None and gap.room <= 0.0 and gap.rate == 0.0 and not gap.joined:
        if gap.law is not None:
            gap.memory = gap.law.remember(-gap.room, gap.memory)
        impacts.merge(chain, gap, ZERO, record)
        ledger.stored_initial += held(gap)


def held(gap: Gap) -> float:
    """J in the bumpers of a gap whose bodies a latch keeps together; 0 elsewhere."""
    if not gap.joined or gap.law is None:
        return 0.0
    return gap.law.stored(-gap.room, 0.0, gap.memory)


def set_free(
    chain: Chain, gap: Gap, release: EnergyRelease, now: Time, record: Record, ledger: Ledger
) -> bool:
    """½ mu w'² = ½ mu w² + E for the speed of separation w. False where the two do not touch."""
    if gap.joined:  # what the latch kept squeezed is no part of the energy either
        ledger.dissipate(held(gap))
        split(chain, gap, now, record)
        gap.spent = gap.law is not None and gap.room < 0.0
    elif gap.touching is None:
        gap.rate = gap.right.v - gap.left.v  # others may have pushed them since it was known
        if gap.room > TOUCHING:
            record.idle_bursts.append((gap.index, now[0], gap.room))
            return False
    elif release.spring is None:  # what their bumpers still hold is no part of the energy
        if gap.law is not None:
            ledger.dissipate(gap.law.stored(-gap.room, -gap.rate, gap.memory))
            contacts.tell_separation(gap, now, contacts.contact_force(gap), record)
            gap.spent = gap.room < 0.0
        gap.touching = None
    if release.spring is not None:
        _let_go(gap, release, release.spring.placed(gap.room), now, record)
        return True
    left, right, mu = gap.left, gap.right, gap.mu
    left.held = right.held = False  # that they start is told by the release itself
    before = (left.v, right.v)
    apart = math.sqrt(gap.rate * gap.rate + 2.0 * release.energy / mu)
    impulse = mu * (apart - gap.rate)
    centre = pair_laws.common_velocity(left, right)
    a, b = pair_laws.shares(left, right, mu)
    left.v, right.v = centre - a * apart, centre + b * apart
    gap.rate, gap.time = apart, now
    ledger.work(release.kind, release.energy)
    pair_laws.outside(left, right, impulse, ledger)
    record.event("release", gap, now, before, (left.v, right.v), impulse, None)
    for other in chain.neighbours(gap):
        if other is not None and not other.joined:
            other.rate = other.right.v - other.left.v
            if other.law is None and other.rate != 0.0:
                other.touching = None  # it rested; now it opens, or is struck
    return True


def _let_go(
    gap: Gap, release: EnergyRelease, spring: LooseForce, now: Time, record: Record
) -> None:
    """From now on the spring pushes; what bumpers hold they give back beside it."""
    if gap.law is None:
        gap.touching = None  # an impact that rested
    gap.time = now
    speeds = (gap.left.v, gap.right.v)
    loose = Loose(release, spring, now, speeds)
    gap.links, gap.loose = (*gap.links, spring), (*gap.loose, loose)
    record.let_go.append(loose)
    record.event("release", gap, now, speeds, speeds, 0.0, spring.strongest)


SPENT = 1e-9
"""Of its force when it was let go. A spring that pushes no more than that has its full length."""


def fall_off(gap: Gap, now: Time, record: Record) -> int:
    """Loose springs that have their full length push no more. Returns the number of events told."""
    shares = [one.link.force(gap.room, 0.0) / one.link.strongest for one in gap.loose]
    least = max(SPENT, min(shares))
    spent = [one for one, part in zip(gap.loose, shares, strict=True) if part <= least]
    for one in spent:
        out = (gap.left.v, gap.right.v)
        one.ended = now[0]
        record.event("separate", gap, now, one.before, out, one.impulse, 0.0)
    gap.loose = tuple(one for one in gap.loose if one not in spent)
    gap.links = tuple(link for link in gap.links if all(link is not one.link for one in spent))
    return len(spent)


def split(chain: Chain, gap: Gap, now: Time, record: Record) -> None:
    """One body becomes two, left and right of a gap that held it together."""
    one = gap.left
    offsets = dict(zip(one.carts, record.offsets(one), strict=True))
    left = tuple(cart for cart in one.carts if cart < gap.index)
    right = tuple(cart for cart in one.carts if cart >= gap.index)
    other = Body(right, 0.0, one.x + offsets[right[0]], one.v, gap.index, one.right, one.time)
    one.carts, one.right, other.held = left, gap.index, one.held
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
