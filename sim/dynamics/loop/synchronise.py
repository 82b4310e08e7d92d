"""What touches belongs together: settling a component at an instant, and forming it anew.

A component is a row of bodies whose neighbours touch or are linked. One free body is a flight
(tier 0), one contact between bodies free otherwise a closed form (tier 1), all else a cluster (tier
2). Whenever something happens to one of them, all solvers involved are settled: bodies and gaps are
brought to that instant, and what the solvers did is booked.
"""

from __future__ import annotations

from sim.dynamics.loop.contacts import outside
from sim.dynamics.motion import work_accounting as booking
from sim.dynamics.motion.coupled_group import Cluster
from sim.dynamics.motion.flight import Flight
from sim.dynamics.motion.linear_pair import PairPhase
from sim.dynamics.motion.pair_contact import PairContact
from sim.dynamics.result.ledger import Ledger
from sim.dynamics.result.record import Record
from sim.dynamics.state.chain import Body, Gap
from sim.dynamics.state.clock import Time, elapsed, later
from sim.dynamics.state.touching import Peak


def settle(bodies: list[Body], gaps: list[Gap], now: Time, record: Record, ledger: Ledger) -> None:
    """Bring these bodies and the gaps between them to `now`; afterwards nothing moves them.

    The gaps go on touching. `bodies` are whole components, walls left out.
    """
    motions = [*(body.motion for body in bodies), *(gap.solver for gap in gaps)]
    solvers = {id(motion): motion for motion in motions if motion is not None}
    pairs = {id(gap.solver): gap for gap in gaps}
    moved = [
        (body, body.motion.shift(body, body.time, now), body.motion.velocity(body, now))
        if body.motion is not None
        else (body, body.v * elapsed(body.time, now), body.v)
        for body in bodies
    ]
    for solver in solvers.values():
        if isinstance(solver, Flight):
            booking.flight(ledger, solver, solver.body.mass, elapsed(solver.begun, now))
        elif isinstance(solver, PairContact):
            _settle_pair(pairs[id(solver)], solver, now, record, ledger)
        else:
            _settle_step(solver, now, record, ledger)
        record.finished(solver, now[0])
    for body, shift, v in moved:
        body.x, body.v, body.time, body.motion = body.x + shift, v, now, None
    for gap in gaps:
        gap.solver = None


def _settle_pair(gap: Gap, solver: PairContact, now: Time, record: Record, ledger: Ledger) -> None:
    touching, law = gap.touching, gap.law
    assert touching is not None and law is not None
    tau = elapsed(solver.begun, now)
    d, v, a, _ = solver.at(tau)
    if record.keep_events:
        when, force, rate = solver.peak()
        if when > tau:
            when, force, rate = tau, -solver.mu * a, v
        touching.see(peak_of(gap, solver, when, force, rate))
    impulse = solver.mu * (solver.u - v)
    touching.impulse += impulse
    outside(gap.left, gap.right, impulse, ledger)
    deepest = solver.deepest_until(tau)
    record.depth(gap, deepest)
    memory = law.remember(deepest, solver.memory)
    given = 0.5 * solver.mu * (solver.u - v) * (solver.u + v)
    before = law.stored(solver.d0, solver.u, solver.memory)
    ledger.warm(given + before - law.stored(d, v, memory))
    gap.memory = memory
    gap.room, gap.rate, gap.time = -d, -v, now


def peak_of(gap: Gap, solver: PairContact, tau: float, force: float, rate: float) -> Peak:
    """The greatest force of one closed form, as part of its contact's story."""
    touching = gap.touching
    assert touching is not None
    change = solver.u - rate
    a, b = solver.shares
    after = (gap.left.v - a * change, gap.right.v + b * change)
    return Peak(later(solver.begun, tau), force, touching.impulse + solver.mu * change, after)


def _settle_step(solver: Cluster | PairPhase, now: Time, record: Record, ledger: Ledger) -> None:
    t = elapsed(solver.begun, now)
    solver.book(ledger, t)
    for k, gap in enumerate(solver.members):
        touching, law = gap.touching, gap.law
        over, rate = solver.over(k, t)
        if touching is not None:
            if record.keep_events:
                _see_peaks(solver, k, t, gap)
            impulse = solver.impulse(k, t)
            touching.impulse += impulse
            outside(gap.left, gap.right, impulse, ledger)
            ledger.warm(solver.warmed(k, t))
            if law is not None:
                deepest = solver.deepest(k, t)
                record.depth(gap, deepest)
                gap.memory = law.remember(deepest, gap.memory)
        gap.room, gap.rate, gap.time = -over, -rate, now
        if touching is None and gap.room >= 0.0:
            gap.memory = 0.0


def _see_peaks(solver: Cluster | PairPhase, k: int, t: float, gap: Gap) -> None:
    """The greatest force in the step: at its ends, or where it stops growing."""
    touching = gap.touching
    assert touching is not None
    for when in solver.greatest(k, t):
        after = solver.velocities(k, when)
        impulse = touching.impulse + solver.impulse(k, when)
        force = solver.contact_force(k, when)
        touching.see(Peak(later(solver.begun, when), force, impulse, after))
