"""What a touch and a separation do to the two bodies. Each law of nature is applied once, here.

two carts  v' = V + e (V − v)  (see `impact`)        a wall  v' = −e v
"""

from __future__ import annotations

import math

from sim.dynamics.chain import Body, Chain, Gap
from sim.dynamics.clock import Time, elapsed, later
from sim.dynamics.contact import PairContact
from sim.dynamics.impact import outgoing
from sim.dynamics.ledger import Ledger
from sim.dynamics.record import Record


def common_velocity(left: Body, right: Body) -> float:
    """m/s, of the common centre of mass; 0 with a wall."""
    if math.inf in (left.mass, right.mass):
        return 0.0
    return (left.mass * left.v + right.mass * right.v) / (left.mass + right.mass)


def velocities_after(left: Body, right: Body, e: float) -> tuple[float, float]:
    """m/s, after an impact with restitution e."""
    if left.mass == math.inf:
        return 0.0, -e * right.v
    if right.mass == math.inf:
        return -e * left.v, 0.0
    return outgoing(left.mass, right.mass, left.v, right.v, e)


def shares(left: Body, right: Body, mu: float) -> tuple[float, float]:
    """mu/mA and mu/mB; nought for a wall."""
    return mu / left.mass, mu / right.mass


def outside(left: Body, right: Body, impulse: float, ledger: Ledger) -> None:
    """A wall pushes from outside: book its impulse."""
    if left.mass == math.inf:
        ledger.push_from_outside(impulse)
    elif right.mass == math.inf:
        ledger.push_from_outside(-impulse)


def instant(gap: Gap, now: Time, record: Record, ledger: Ledger) -> None:
    """An impulse without duration."""
    left, right = gap.left, gap.right
    e, u, mu = gap.contact.restitution or 0.0, -gap.rate, gap.mu
    before = (left.v, right.v)
    left.v, right.v = velocities_after(left, right, e)
    impulse = mu * (1.0 + e) * u
    gap.room, gap.rate, gap.time = 0.0, e * u, now
    ledger.warm(0.5 * mu * u * u * (1.0 - e) * (1.0 + e))
    outside(left, right, impulse, ledger)
    record.event("contact", gap, now, before, (left.v, right.v), impulse, None)
    for body in (left, right):
        if body.carts:
            record.piece(body)


def join(chain: Chain, gap: Gap, now: Time, record: Record, ledger: Ledger) -> None:
    """The two stay together: from now on they are one body."""
    left, right = gap.left, gap.right
    u, mu = -gap.rate, gap.mu
    centre = common_velocity(left, right)
    before = (left.v, right.v)
    ledger.warm(0.5 * mu * u * u)
    outside(left, right, mu * u, ledger)
    record.event("contact", gap, now, before, (centre, centre), mu * u, None)
    record.join(gap, now)
    gap.turn += 1
    gap.joined = True
    one = left if left.carts else right
    if left.carts and right.carts:
        one.carts, one.mass, one.right = (
            left.carts + right.carts,
            left.mass + right.mass,
            right.right,
        )
        beyond = chain.gaps[right.right]
        if beyond is not None:
            beyond.left = one
        for k, body in enumerate(chain.bodies):
            if body is right:
                chain.bodies[k] = one
    else:  # stuck to a wall
        one.mass = math.inf
    one.v, one.time = centre, now
    gap.left = gap.right = one
    record.piece(one)


def touch(gap: Gap, now: Time, record: Record) -> PairContact:
    """A contact of finite duration begins."""
    assert gap.law is not None
    left, right, mu = gap.left, gap.right, gap.mu
    overlap = max(0.0, -gap.room)
    fresh = overlap == 0.0
    contact = PairContact(
        gap=gap.index,
        law=gap.law,
        mu=mu,
        begun=now,
        d0=overlap,
        u=-gap.rate,
        memory=gap.memory,
        velocity=common_velocity(left, right),
        shares=shares(left, right, mu),
        figures=gap.figures(mu) if fresh else None,
    )
    left.contact = right.contact = gap.touching = contact
    before = (left.v, right.v)
    record.event("contact", gap, now, before, before, 0.0, contact.first_force())
    for body in (left, right):
        if body.carts:
            record.piece(body)
        else:
            body.contact = None  # a wall can be in two contacts: it does not move in either
    return contact


def _peak(gap: Gap, contact: PairContact, until: float, record: Record) -> None:
    """The event of greatest force, if it comes within `until` s of the contact."""
    tau, force, rate = contact.peak()
    if tau > until or force <= 0.0:
        return
    before = (gap.left.v, gap.right.v)
    change = contact.u - rate
    after = (before[0] - contact.shares[0] * change, before[1] + contact.shares[1] * change)
    when = later(contact.begun, tau)
    record.event("peak", gap, when, before, after, contact.mu * change, force)


def separate(gap: Gap, now: Time, record: Record, ledger: Ledger) -> None:
    """The force of a finite contact has become zero."""
    contact = gap.touching
    assert contact is not None and gap.law is not None
    left, right, mu = gap.left, gap.right, contact.mu
    speed, overlap = contact.out()
    before = (left.v, right.v)
    _peak(gap, contact, math.inf, record)
    e = contact.figures.e if contact.figures is not None else None
    if e is not None:
        out = velocities_after(left, right, e)
    else:
        a, b = contact.shares
        out = contact.velocity - a * speed, contact.velocity + b * speed
    for body, share, v in ((left, contact.shares[0], out[0]), (right, -contact.shares[1], out[1])):
        if body.carts:
            body.x += contact.velocity * contact.duration + share * (overlap - contact.d0)
            body.v, body.time, body.contact = v, now, None
    impulse = mu * (contact.u + speed)
    deepest = contact.greatest_overlap()
    gap.memory = gap.law.remember(deepest, contact.memory) if overlap > 0.0 else 0.0
    gap.room, gap.rate, gap.time, gap.touching = -overlap, speed, now, None
    stored = gap.law.stored(contact.d0, contact.u, contact.memory)
    if e is not None:
        ledger.warm(0.5 * mu * contact.u * contact.u * (1.0 - e) * (1.0 + e))
    else:
        ledger.warm(0.5 * mu * (contact.u - speed) * (contact.u + speed) + stored)
    outside(left, right, impulse, ledger)
    record.depth(gap, contact, deepest)
    record.finished(contact, now[0])
    after = (left.v, right.v)
    record.event("separate", gap, now, before, after, impulse, contact.last_force())
    for body in (left, right):
        if body.carts:
            record.piece(body)


def unfinished(gap: Gap, end: Time, record: Record, ledger: Ledger) -> None:
    """The run ends while this contact lasts: book what has happened so far."""
    contact = gap.touching
    assert contact is not None and gap.law is not None
    tau = elapsed(contact.begun, end)
    _peak(gap, contact, tau, record)
    d, v, _, _ = contact.at(tau)
    deepest = contact.deepest_until(tau)
    stored = gap.law.stored(d, v, gap.law.remember(deepest, contact.memory))
    begun = gap.law.stored(contact.d0, contact.u, contact.memory)
    ledger.stored_final += stored
    ledger.warm(0.5 * contact.mu * (contact.u - v) * (contact.u + v) + begun - stored)
    outside(gap.left, gap.right, contact.mu * (contact.u - v), ledger)
    record.depth(gap, contact, deepest)
    record.finished(contact, end[0])
