"""What touches belongs together: settling a component at an instant, and forming it anew.

A component is a run of neighbouring gaps that all touch. One gap alone is a closed form (tier 1),
several are a cluster (tier 2). Whenever something happens to one of them, all solvers involved are
settled: bodies and gaps are brought to that instant, and what the solvers did is booked.
"""

from __future__ import annotations

import math

from sim.dynamics.chain import Body, Chain, Gap
from sim.dynamics.clock import Time, elapsed, later
from sim.dynamics.cluster import Cause, Cluster
from sim.dynamics.contact import PairContact
from sim.dynamics.laws import Bumper, Paper
from sim.dynamics.ledger import Ledger
from sim.dynamics.record import Record
from sim.dynamics.resolve import common_velocity, outside, shares, tell_separation
from sim.dynamics.series import first_fall, integral, slope, value
from sim.dynamics.touching import Peak


def around(chain: Chain, gap: Gap) -> list[Gap]:
    """The touching gaps connected with `gap` through shared bodies, from left to right."""
    found = [gap] if gap.touching is not None else []
    body = gap.left
    while body.carts and (other := chain.gaps[body.left]) is not None and other.touching:
        found.insert(0, other)
        body = other.left
    body = gap.right
    while body.carts and (other := chain.gaps[body.right]) is not None and other.touching:
        found.append(other)
        body = other.right
    return found


def bodies_of(gaps: list[Gap]) -> list[Body]:
    """The bodies of these gaps, walls left out, each once, from left to right."""
    found: list[Body] = []
    for gap in gaps:
        for body in (gap.left, gap.right):
            if body.carts and not any(body is other for other in found):
                found.append(body)
    return found


def settle(gaps: list[Gap], now: Time, record: Record, ledger: Ledger) -> None:
    """Bring every solver of these gaps to `now` and take it away; the gaps go on touching."""
    solvers: list[PairContact | Cluster] = []
    for gap in gaps:
        assert gap.touching is not None
        if not any(gap.touching.solver is solver for solver in solvers):
            solvers.append(gap.touching.solver)
    moved = [
        (body, body.motion.shift(body, body.time, now), body.motion.velocity(body, now))
        for body in bodies_of(gaps)
        if body.motion is not None
    ]
    for solver in solvers:
        own = [gap for gap in gaps if gap.touching and gap.touching.solver is solver]
        before = math.fsum(_stored(gap) for gap in own)
        if isinstance(solver, PairContact):
            _settle_pair(own[0], solver, now, record, ledger)
        else:
            _settle_cluster(own, solver, now, record, ledger)
        ledger.warm(before - math.fsum(_stored(gap) for gap in own))
        record.finished(solver, tuple(gap.index for gap in own), now[0])
    for body, shift, v in moved:
        ledger.warm(0.5 * body.mass * (body.v - v) * (body.v + v) if body.mass < math.inf else 0.0)
        body.x, body.v, body.time, body.motion = body.x + shift, v, now, None


def _stored(gap: Gap) -> float:
    assert gap.law is not None
    return gap.law.stored(-gap.room, -gap.rate, gap.memory)


def _settle_pair(gap: Gap, solver: PairContact, now: Time, record: Record, ledger: Ledger) -> None:
    touching = gap.touching
    assert touching is not None and gap.law is not None
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
    gap.memory = gap.law.remember(deepest, solver.memory)
    gap.room, gap.rate, gap.time = -d, -v, now


def peak_of(gap: Gap, solver: PairContact, tau: float, force: float, rate: float) -> Peak:
    """The greatest force of one closed form, as part of its contact's story."""
    touching = gap.touching
    assert touching is not None
    change = solver.u - rate
    a, b = solver.shares
    after = (gap.left.v - a * change, gap.right.v + b * change)
    return Peak(later(solver.begun, tau), force, touching.impulse + solver.mu * change, after)


def _settle_cluster(
    gaps: list[Gap], solver: Cluster, now: Time, record: Record, ledger: Ledger
) -> None:
    t = elapsed(solver.begun, now)
    for k, gap in enumerate(gaps):
        touching, law = gap.touching, gap.law
        assert touching is not None and law is not None
        if record.keep_events:
            _see_peaks(solver, k, t, gap)
        impulse = value(integral(solver.force_of[k]), t)
        touching.impulse += impulse
        outside(gap.left, gap.right, impulse, ledger)
        over, rate = value(solver.over[k], t), value(slope(solver.over[k]), t)
        deepest = max(-gap.room, over)
        if -gap.rate > 0.0 > rate and (turn := first_fall(slope(solver.over[k]), t)) is not None:
            deepest = max(deepest, value(solver.over[k], turn))
        record.depth(gap, deepest)
        gap.memory = law.remember(deepest, gap.memory)
        gap.room, gap.rate, gap.time = -over, -rate, now


def _see_peaks(solver: Cluster, k: int, t: float, gap: Gap) -> None:
    """The greatest force in the step: at its ends, or where it stops growing."""
    touching = gap.touching
    assert touching is not None
    force = solver.force_of[k]
    growth = slope(force)
    turn = first_fall(growth, t) if value(growth, t) < 0.0 else None
    for when in (0.0, t) if turn is None else (0.0, turn, t):
        after = (value(solver.speed[k], when), value(solver.speed[k + 1], when))
        impulse = touching.impulse + value(integral(force), when)
        touching.see(Peak(later(solver.begun, when), value(force, when), impulse, after))


def leave_branch(gap: Gap, cause: Cause, now: Time, record: Record, ledger: Ledger) -> None:
    """A settled gap has come to the end of a branch of its law."""
    law = gap.law
    assert law is not None and gap.touching is not None
    gap.touching.pressing = cause == "climb"
    if cause == "climb":
        gap.room = -gap.memory
        return
    if cause == "turn":
        gap.rate, gap.memory = 0.0, -gap.room
        return
    ledger.warm(_stored(gap))
    if isinstance(law, Paper) or law.e == 1.0:
        gap.room = 0.0
    elif isinstance(law, Bumper):
        gap.room = -law.resting_overlap(gap.memory)
    if gap.room >= 0.0:
        gap.memory = 0.0
    tell_separation(gap, now, 0.0, record)


def form(gaps: list[Gap], now: Time, record: Record) -> list[PairContact | Cluster]:
    """New solvers for touching gaps that are settled at `now`; `gaps` from left to right."""
    solvers: list[PairContact | Cluster] = []
    run: list[Gap] = []
    for gap in [*gaps, None]:
        if gap is not None and (not run or run[-1].right is gap.left):
            run.append(gap)
            continue
        if run:
            solvers.append(_solver(run, now, record))
        run = [gap] if gap is not None else []
    return solvers


def _solver(run: list[Gap], now: Time, record: Record) -> PairContact | Cluster:
    solver: PairContact | Cluster
    if len(run) == 1:
        gap = run[0]
        assert gap.law is not None
        solver = PairContact(
            gap=gap.index,
            law=gap.law,
            mu=gap.mu,
            begun=now,
            d0=-gap.room,
            u=-gap.rate,
            memory=gap.memory,
            velocity_of_centre=common_velocity(gap.left, gap.right),
            shares=shares(gap.left, gap.right, gap.mu),
            figures=None,
        )
    else:
        solver = Cluster(run, now)
    for gap in run:
        assert gap.touching is not None
        gap.touching.solver = solver
    for body in bodies_of(run):
        body.motion = solver
        record.piece(body)
    return solver
