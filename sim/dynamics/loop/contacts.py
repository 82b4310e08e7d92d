"""What a touch and a separation do to the two bodies. Each law of nature is applied once, here.

two carts  v' = V + e (V − v)  (see `impact`)        a wall  v' = −e v
"""

from __future__ import annotations

import math

from sim.dynamics.motion.guards import branch_of, force_now
from sim.dynamics.motion.impact import outgoing
from sim.dynamics.motion.pair_contact import PairContact
from sim.dynamics.result.ledger import Ledger
from sim.dynamics.result.record import Record
from sim.dynamics.state.body import Body, Gap
from sim.dynamics.state.chain import Chain, component
from sim.dynamics.state.clock import ZERO, Time, later
from sim.dynamics.state.touching import Peak, Touching


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
    for body in (left, right):
        if body.carts:
            record.piece(body)


def rest_together(chain: Chain, gap: Gap, ledger: Ledger) -> None:
    """Bodies that rest against each other by `instant` contacts get one velocity, next to a wall 0.

    What one impact among them leaves of velocity is too little to part them (`AT_REST`).
    """
    _, gaps = component(chain, gap.left if gap.left.carts else gap.right)
    resting = [other for other in gaps if other.law is None and other.touching is not None]
    here = resting.index(gap)
    first = last = here
    while first > 0 and resting[first - 1].right is resting[first].left:
        first -= 1
    while last + 1 < len(resting) and resting[last + 1].left is resting[last].right:
        last += 1
    group = [resting[first].left, *(other.right for other in resting[first : last + 1])]
    movers = [body for body in group if body.mass < math.inf]
    fixed = len(movers) < len(group)  # a wall is among them, or a cart that sticks to one
    momentum = math.fsum(body.mass * body.v for body in movers)
    together = 0.0 if fixed else momentum / math.fsum(body.mass for body in movers)
    for body in movers:
        ledger.dissipate(0.5 * body.mass * (body.v - together) * (body.v + together))
        body.v = together
    if fixed:
        ledger.push_from_outside(-momentum)
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
        beyond = chain.gaps[right.right]
        if beyond is not None:
            beyond.left = one
        for k, body in enumerate(chain.bodies):
            if body is right:
                chain.bodies[k] = one
        for near in chain.gaps:
            if near is not None and near.joined and near.left is right:
                near.left = near.right = one
    else:  # stuck to a wall
        one.mass = math.inf
    one.time = now
    gap.left = gap.right = one
    return one


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
            ledger.dissipate(-stored)


def touch(gap: Gap, now: Time, record: Record, ledger: Ledger) -> None:
    """A contact of finite duration begins between two settled bodies; nothing moves it yet."""
    left, right = gap.left, gap.right
    assert gap.law is not None
    gap.room = min(gap.room, 0.0)
    gap.memory = gap.law.remember(-gap.room, gap.memory)
    reclaim(gap, now, ledger)
    gap.touching = Touching(now, (left.v, right.v))
    if not record.keep_events:
        record.counts["contact"] += 1
        return
    speeds = (left.v, right.v)
    record.event("contact", gap, now, speeds, speeds, 0.0, contact_force(gap))


def contact_force(gap: Gap) -> float:
    """N. The force of a touching gap just now, by the branch of its law that holds."""
    return force_now(gap, branch_of(gap))


def pair_contact(gap: Gap, now: Time) -> PairContact:
    """The closed form that moves a touching gap whose bodies are free otherwise.

    From first touch the outcome comes from the law's figures.
    """
    assert gap.law is not None and gap.touching is not None
    fresh = gap.room == 0.0 and gap.touching.begun == now and gap.touching.impulse == 0.0
    return PairContact(
        bodies=[gap.left, gap.right],
        members=[gap],
        law=gap.law,
        mu=gap.mu,
        begun=now,
        d0=-gap.room,
        u=-gap.rate,
        memory=gap.memory,
        velocity_of_centre=common_velocity(gap.left, gap.right),
        shares=shares(gap.left, gap.right, gap.mu),
        figures=gap.figures(gap.mu) if fresh and gap.rate < 0.0 else None,
    )


def separate_pair(
    gap: Gap, contact: PairContact, now: Time, record: Record, ledger: Ledger
) -> None:
    """The force of a contact that was a closed form to its end has become zero."""
    touching, law = gap.touching, gap.law
    assert touching is not None and law is not None
    left, right, mu = gap.left, gap.right, contact.mu
    speed, overlap = contact.out()
    if record.keep_events:
        tau, force, impulse, velocities = contact.peak_until(math.inf)
        when = later(contact.begun, tau)
        touching.see(Peak(when, force, touching.impulse + impulse, velocities))
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
        ledger.dissipate(0.5 * mu * contact.u * contact.u * (1.0 - e) * (1.0 + e))
    else:
        ledger.dissipate(0.5 * mu * (contact.u - speed) * (contact.u + speed) + stored)
    gap.memory = law.remember(deepest, contact.memory) if overlap > 0.0 else 0.0
    gap.room, gap.rate, gap.time = -overlap, speed, now
    outside(left, right, impulse, ledger)
    record.finished(contact, now[0])
    last_force = contact.last_force() if record.keep_events else 0.0
    tell_separation(gap, now, last_force, record)
    for body in (left, right):
        if body.carts:
            record.piece(body)


def tell_separation(gap: Gap, now: Time, last_force: float, record: Record) -> None:
    """The events at the end of a contact; the gap is free from here on."""
    touching = gap.touching
    assert touching is not None
    gap.solver = None
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
