"""Impacts without a duration, and carts that stay together."""

from __future__ import annotations

import itertools
import math
from collections.abc import Collection

from sim.dynamics.loop.collapse import either_first, one_velocity
from sim.dynamics.loop.pair_laws import common_velocity, outside, velocities_after
from sim.dynamics.motion.locked import impulses
from sim.dynamics.result.ledger import Ledger
from sim.dynamics.result.record import Record
from sim.dynamics.state.body import Body, Gap
from sim.dynamics.state.chain import Chain, component
from sim.dynamics.state.clock import Time, elapsed
from sim.dynamics.state.flips import UNDECIDED
from sim.dynamics.state.touching import Touching
from sim.laws.rounding import LAST_BITS

STILL = 1e-30
"""Of the fastest approach so far. Impacts that follow each other at one instant, ever slower by a
constant factor, never end; once their approach speed is this small, the two go on together. It is
far below the last bit of any velocity, so no cart that moves is stopped by it."""

AT_REST = 1e-12
"""Of the fastest approach so far. Impacts under a force that presses on come ever faster and ever
slower; there are infinitely many before a finite time. Below this speed the two stay in contact:
what is left out of the energy is 1e-24 of it, of the time 1e-12."""

AT_REST_IN_CONTACT = 1e-8
"""The same where one of the two is in a contact with somebody else: its place is known to 1e-16
only, and below this speed that decides the next impact. 1e-16 of the energy is left out."""


def rests(gap: Gap, fastest: float, *, in_contact: bool) -> bool:
    """Would this impact leave so little speed that the two stay in contact, if they are pressed?"""
    small = AT_REST_IN_CONTACT if in_contact else AT_REST
    return (gap.contact.restitution or 0.0) * -gap.rate <= small * fastest


PLACE = 1e-15
"""Of where the two are. A hop that is no higher is one of rounding errors, which have no end."""


def hops_within_rounding(gap: Gap, now: Time) -> bool:
    """Would the two, hit again under what presses them together, part by less than rounding?

    A hop from speed u that took dt was u dt/4 high; the next one is e² times that.
    """
    e, since = gap.contact.restitution or 0.0, elapsed(gap.changed, now)
    if since <= 0.0:  # hit twice at one instant: that is no hop
        return False
    hop = 0.25 * e * e * -gap.rate * since
    return hop <= PLACE * max(abs(gap.left.x), abs(gap.right.x))


def instant(
    gap: Gap, now: Time, record: Record, ledger: Ledger, fastest: float, *, stays: bool = False
) -> None:
    """An impulse without duration. `fastest` [m/s]: the greatest approach so far.

    `stays`: the two go on together, in contact, while something presses them together.
    """
    left, right = gap.left, gap.right
    e, u, mu = gap.contact.restitution or 0.0, -gap.rate, gap.mu
    if stays or u < STILL * fastest:
        e = 0.0
    before = (left.v, right.v)
    left.v, right.v = velocities_after(left, right, e)
    if e == 0.0 and u < STILL * fastest:
        together = common_velocity(left, right)
        left.v = right.v = together if abs(together) > STILL * fastest else 0.0
    impulse = mu * (1.0 + e) * u
    gap.room, gap.rate, gap.time = 0.0, e * u, now
    ledger.dissipate(0.5 * mu * u * u * (1.0 - e) * (1.0 + e))
    outside(left, right, impulse, ledger)
    record.event("contact", gap, now, before, (left.v, right.v), impulse, None)
    if stays:
        gap.touching = Touching(now, before)
    if record.keep_motion:
        for body in (left, right):
            if body.carts:
                record.piece(body)


def side_by_side(
    chain: Chain, block: list[Gap], stay: Collection[Gap], now: Time, record: Record, ledger: Ledger
) -> None:
    """Impacts in neighbouring gaps at once: each is left with its own −e u (`locked.impulses`).

    Two that would go on for ever, whichever came first, end as that does: with one velocity.
    """
    bodies = [block[0].left, *(gap.right for gap in block)]
    before = [body.v for body in bodies]
    e = [0.0 if gap in stay else gap.contact.restitution or 0.0 for gap in block]
    if either_first(chain, block, now):
        e = [0.0, 0.0]
    found = impulses([1.0 / body.mass for body in bodies], [-gap.rate for gap in block], e)
    for body, left, right in zip(bodies, [0.0, *found], [*found, 0.0], strict=True):
        body.v += (left - right) / body.mass
    for gap, p, one in zip(block, found, e, strict=True):
        ledger.dissipate(0.5 * p * -gap.rate * (1.0 - one))
        outside(gap.left, gap.right, p, ledger)
        gap.room, gap.rate, gap.time = 0.0, -one * gap.rate, now
    for together, own in itertools.groupby(block, lambda gap: gap.rate == 0.0):
        if together:
            side = list(own)
            one_velocity([side[0].left, *(gap.right for gap in side)], ledger)
    for k, (gap, p) in enumerate(zip(block, found, strict=True)):
        after = (gap.left.v, gap.right.v)
        record.event("contact", gap, now, (before[k], before[k + 1]), after, p, None)
        if gap in stay and not gap.contact.joins:
            gap.touching = Touching(now, (before[k], before[k + 1]))
    for gap in block:
        if gap.contact.joins:
            merge(chain, gap, now, record)
    for body in dict.fromkeys(body for gap in block for body in (gap.left, gap.right)):
        if body.carts:
            record.piece(body)


GRAZE = 3e-8
"""Of the speed that its springs give a pair. Rounding moves the place where two turn round by 1e-16
of their way: the speed there is the root of that."""


def grazes(gap: Gap) -> bool:
    """Do two with velcro, drawn by springs, come just so near that they touch, and turn round?"""
    if not (gap.contact.joins and gap.links) or gap.flips:
        return False
    force = abs(math.fsum(link.force(gap.room, 0.0) for link in gap.links))
    stiff = math.fsum(link.bounds(gap.room)[0] for link in gap.links if link.linear)
    return stiff > 0.0 and -gap.rate <= GRAZE * force / math.sqrt(stiff * gap.mu)


def graze(chain: Chain, gap: Gap, ledger: Ledger) -> None:
    """As at the start of a run: velcro does not hold what touches at rest without being pressed.

    They go on with one velocity. Pressed together they touch again at that instant: then it holds.
    """
    one_velocity([gap.left, gap.right], ledger)
    for other in (gap, *chain.neighbours(gap)):
        if other is not None and other.member and not other.joined:
            other.rate = other.right.v - other.left.v


def _is_hit_by_rounding(gap: Gap) -> bool:
    """Do two that springs hold, and that touch, move alike after impacts in turn at one instant?"""
    if gap.room != 0.0 or gap.joined or not gap.links or gap.flips < UNDECIDED:
        return False
    fastest = max(abs(gap.left.v), abs(gap.right.v))  # rounding leaves so much per impact
    return abs(gap.right.v - gap.left.v) <= LAST_BITS * gap.flips * fastest


def rest_together(chain: Chain, gap: Gap, ledger: Ledger) -> None:
    """Bodies that rest against each other by `instant` contacts get one velocity, next to a wall 0.

    What one impact among them leaves of velocity is too little to part them (`AT_REST`).
    """
    _, gaps = component(chain, gap.left if gap.left.carts else gap.right)
    resting = [
        other
        for other in gaps
        if other.law is None and (other.touching is not None or _is_hit_by_rounding(other))
    ]
    here = resting.index(gap)
    first = last = here
    while first > 0 and resting[first - 1].right is resting[first].left:
        first -= 1
    while last + 1 < len(resting) and resting[last + 1].left is resting[last].right:
        last += 1
    group = [resting[first].left, *(other.right for other in resting[first : last + 1])]
    one_velocity(group, ledger)
    for other in resting[first : last + 1]:
        other.rate = 0.0


def join(chain: Chain, gap: Gap, now: Time, record: Record, ledger: Ledger) -> None:
    """The two stay together: from now on they are one body."""
    left, right = gap.left, gap.right
    u, mu = -gap.rate, gap.mu
    centre = common_velocity(left, right)
    before = (left.v, right.v)
    ledger.dissipate(0.5 * mu * u * u)
    outside(left, right, mu * u, ledger)
    record.event("contact", gap, now, before, (centre, centre), mu * u, None)
    one = merge(chain, gap, now, record)
    one.v = centre
    record.piece(one)


def merge(chain: Chain, gap: Gap, now: Time, record: Record) -> Body:
    """The bodies of a gap become one; a wall makes it immovable."""
    left, right = gap.left, gap.right
    record.join(gap, now)
    gap.turn += 1
    gap.joined, gap.rate = True, 0.0
    one = left if left.carts else right
    if left.carts and right.carts:
        one.carts, one.mass, one.right = (
            left.carts + right.carts,
            left.mass + right.mass,
            right.right,
        )
        one.held = left.held and right.held  # one that comes along has not started by itself
        beyond = chain.gaps[right.right]
        if beyond is not None:
            beyond.left = one
        for cart in right.carts:
            chain.bodies[cart] = one
        for index in range(right.carts[0], right.carts[-1] + 2):
            near = chain.gaps[index]
            if near is not None and near.joined and near.left is right:
                near.left = near.right = one
    else:  # stuck to a wall
        one.mass = math.inf
    one.time = now
    gap.left = gap.right = one
    return one
