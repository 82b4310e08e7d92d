"""Contacts of finite duration: what a touch and a separation do to the two bodies."""

from __future__ import annotations

import math

from sim.dynamics.loop.pair_laws import common_velocity, outside, shares, velocities_after
from sim.dynamics.motion.guards import branch_of, force_now
from sim.dynamics.motion.pair_contact import PairContact
from sim.dynamics.result.ledger import Ledger
from sim.dynamics.result.record import Record
from sim.dynamics.state.body import Gap
from sim.dynamics.state.clock import ZERO, Time, elapsed, later
from sim.dynamics.state.touching import Peak, Touching


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
    gap.room, gap.spent = min(gap.room, 0.0), False
    gap.memory = gap.law.remember(-gap.room, gap.memory)
    reclaim(gap, now, ledger)
    gap.touching, gap.stride = Touching(now, (left.v, right.v)), 0.0
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
    """The events at the end of a contact; the gap is free from here on.

    Two at rest in touch, of which one is held back, part before they push: that was no contact.
    """
    touching = gap.touching
    assert touching is not None
    gap.solver = None
    if not touching.has_pushed:
        record.forget_contact(gap)
        gap.touching = None
        return
    tell_peak(gap, record)
    out = (gap.left.v, gap.right.v)
    record.event("separate", gap, now, touching.before, out, touching.impulse, last_force)
    gap.touching = None


def tell_peak(gap: Gap, record: Record, end: Time | None = None, instant: float = 0.0) -> None:
    """The event of greatest force, once a contact is over; or the run is, at `end`: a force that
    still grew within its last `instant` [s] has had none."""
    touching = gap.touching
    assert touching is not None
    if end is None and not record.keep_events:
        record.counts["peak"] += 1
        return
    peak = touching.peak
    if peak is None or not peak.force > 0.0:
        return
    if end is not None and elapsed(peak.time, end) <= instant:
        record.growing[gap.index] = peak.force
        return
    record.event("peak", gap, peak.time, touching.before, peak.after, peak.impulse, peak.force)
