"""What a touch and a separation do to the two bodies. Each law of nature is applied once, here.

two carts  v' = V + e (V − v)  (see `impact`)        a wall  v' = −e v
"""

from __future__ import annotations

import math

from sim.dynamics.chain import Body, Chain, Gap
from sim.dynamics.clock import ZERO, Time, later
from sim.dynamics.contact import PairContact
from sim.dynamics.impact import outgoing
from sim.dynamics.ledger import Ledger
from sim.dynamics.record import Record
from sim.dynamics.touching import Peak, Touching


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


STILL = 1e-30
"""Of the fastest cart at the start. Impacts that follow each other at one instant, ever slower by a
constant factor, never end; once their approach speed is this small, the two go on together. It is
far below the last bit of any velocity, so no cart that moves is stopped by it."""


def instant(gap: Gap, now: Time, record: Record, ledger: Ledger, fastest: float) -> None:
    """An impulse without duration. `fastest` [m/s]: the greatest speed at the start."""
    left, right = gap.left, gap.right
    e, u, mu = gap.contact.restitution or 0.0, -gap.rate, gap.mu
    if u < STILL * fastest:
        e = 0.0
    before = (left.v, right.v)
    left.v, right.v = velocities_after(left, right, e)
    if e == 0.0 and u < STILL * fastest:
        together = common_velocity(left, right)
        left.v = right.v = together if abs(together) > STILL * fastest else 0.0
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


def reclaim(gap: Gap, now: Time, ledger: Ledger) -> None:
    """A contact begins with an overlap: its spring holds energy already.

    At the start of the run that belongs to the beginning; later it was booked as warmed when the
    pair separated with this overlap, and comes back from there.
    """
    if gap.room < 0.0 and gap.law is not None:
        stored = gap.law.stored(-gap.room, -gap.rate, gap.memory)
        if now == ZERO:
            ledger.stored_initial += stored
        else:
            ledger.warm(-stored)


def touch(gap: Gap, now: Time, record: Record, ledger: Ledger) -> PairContact:
    """A contact of finite duration begins between two free bodies."""
    assert gap.law is not None
    left, right, mu = gap.left, gap.right, gap.mu
    overlap = max(0.0, -gap.room)
    contact = PairContact(
        gap=gap.index,
        law=gap.law,
        mu=mu,
        begun=now,
        d0=overlap,
        u=-gap.rate,
        memory=gap.memory,
        velocity_of_centre=common_velocity(left, right),
        shares=shares(left, right, mu),
        figures=gap.figures(mu) if overlap == 0.0 else None,
    )
    gap.room = -overlap
    reclaim(gap, now, ledger)
    gap.touching = Touching(now, (left.v, right.v), contact)
    record.event(
        "contact",
        gap,
        now,
        (left.v, right.v),
        (left.v, right.v),
        0.0,
        contact.first_force() if record.keep_events else 0.0,
    )
    for body in (left, right):
        if body.carts:  # a wall can be in two contacts: it does not move in either
            body.motion = contact
            record.piece(body)
    return contact


def touch_among_others(gap: Gap, now: Time, record: Record, ledger: Ledger) -> None:
    """A contact begins while one of the two is in another one: settled, but not formed yet."""
    assert gap.law is not None
    left, right = gap.left, gap.right
    gap.room = min(gap.room, 0.0)
    placeholder = PairContact(
        gap=gap.index,
        law=gap.law,
        mu=gap.mu,
        begun=now,
        d0=max(0.0, -gap.room),
        u=-gap.rate,
        memory=gap.memory,
        velocity_of_centre=common_velocity(left, right),
        shares=shares(left, right, gap.mu),
        figures=gap.figures(gap.mu),
    )
    reclaim(gap, now, ledger)
    gap.touching = Touching(now, (left.v, right.v), placeholder)
    record.event(
        "contact",
        gap,
        now,
        (left.v, right.v),
        (left.v, right.v),
        0.0,
        placeholder.first_force() if record.keep_events else 0.0,
    )


def separate_pair(gap: Gap, now: Time, record: Record, ledger: Ledger) -> None:
    """The force of a contact that was a closed form to its end has become zero."""
    touching, law = gap.touching, gap.law
    assert touching is not None and law is not None
    contact = touching.solver
    assert isinstance(contact, PairContact)
    left, right, mu = gap.left, gap.right, contact.mu
    speed, overlap = contact.out()
    if record.keep_events:
        tau, force, rate = contact.peak()
        change = contact.u - rate
        a, b = contact.shares
        velocities = (left.v - a * change, right.v + b * change)
        when = later(contact.begun, tau)
        touching.see(Peak(when, force, touching.impulse + mu * change, velocities))
    e = contact.figures.e if contact.figures is not None else None
    if e is not None:
        out = velocities_after(left, right, e)
    else:
        a, b = contact.shares
        out = contact.velocity_of_centre - a * speed, contact.velocity_of_centre + b * speed
    for body, share, v in ((left, contact.shares[0], out[0]), (right, -contact.shares[1], out[1])):
        if body.carts:
            shift = contact.velocity_of_centre * contact.duration
            body.x += shift + share * (overlap - contact.d0)
            body.v, body.time, body.motion = v, now, None
    impulse = mu * (contact.u + speed)
    touching.impulse += impulse
    deepest = contact.greatest_overlap()
    record.depth(gap, deepest)
    stored = law.stored(contact.d0, contact.u, contact.memory)
    if e is not None:
        ledger.warm(0.5 * mu * contact.u * contact.u * (1.0 - e) * (1.0 + e))
    else:
        ledger.warm(0.5 * mu * (contact.u - speed) * (contact.u + speed) + stored)
    gap.memory = law.remember(deepest, contact.memory) if overlap > 0.0 else 0.0
    gap.room, gap.rate, gap.time = -overlap, speed, now
    outside(left, right, impulse, ledger)
    record.finished(contact, (gap.index,), now[0])
    last_force = contact.last_force() if record.keep_events else 0.0
    tell_separation(gap, now, last_force, record)
    for body in (left, right):
        if body.carts:
            record.piece(body)


def tell_separation(gap: Gap, now: Time, last_force: float, record: Record) -> None:
    """The events at the end of a contact; the gap is free from here on."""
    touching = gap.touching
    assert touching is not None
    tell_peak(gap, record)
    out = (gap.left.v, gap.right.v)
    record.event("separate", gap, now, touching.before, out, touching.impulse, last_force)
    gap.touching = None


def tell_peak(gap: Gap, record: Record) -> None:
    """The event of greatest force, once a contact is over or the run is."""
    touching = gap.touching
    assert touching is not None
    if not record.keep_events:
        record.counts["peak"] += 1
    elif touching.peak is not None and touching.peak.force > 0.0:
        peak = touching.peak
        record.event("peak", gap, peak.time, touching.before, peak.after, peak.impulse, peak.force)
