"""What touches belongs together: bringing all of it to one instant.

A component is a row of bodies whose neighbours touch or are linked. One free body is a flight
(tier 0), one contact between bodies free otherwise a closed form (tier 1), all else a group (tier
2). Whenever something happens to one of them, all motions involved are settled: bodies and gaps are
brought to that instant, and what the motions did is booked.
"""

from __future__ import annotations

from sim.dynamics.loop import still
from sim.dynamics.loop.pair_laws import outside
from sim.dynamics.motion.coupled_group import CoupledGroup
from sim.dynamics.result.ledger import Ledger
from sim.dynamics.result.record import Record
from sim.dynamics.state.body import Body, Gap, GapRecord, Motion
from sim.dynamics.state.chain import Chain, component
from sim.dynamics.state.clock import Time, elapsed, later
from sim.dynamics.state.touching import Peak

TIER_OF_SERIES = 2


def components(
    chain: Chain, bodies: list[Body], now: Time, record: Record, ledger: Ledger
) -> tuple[list[Body], list[Gap]]:
    """Settle the components of these bodies; the free gaps around them are brought to `now`.

    Returns all their bodies and member gaps, from left to right.
    """
    row: dict[Body, None] = {}  # by identity, in order
    gaps: list[Gap] = []
    for body in bodies:
        if body.carts and body not in row:
            more, between = component(chain, body)
            row |= dict.fromkeys(more)
            gaps += between
    for body in row:
        for index in (body.left, body.right):
            other = chain.gaps[index]
            if other is not None and other.solver is None:
                chain.advance(other, now)
    settle(list(row), gaps, now, record, ledger)
    return list(row), gaps


def settle(
    bodies: list[Body],
    gaps: list[Gap],
    now: Time,
    record: Record,
    ledger: Ledger,
    *,
    peaks: bool = False,
) -> None:
    """Bring these bodies and the gaps between them to `now`; afterwards nothing moves them.

    The gaps go on touching. `bodies` are whole components, walls left out; `peaks`: greatest forces
    are asked for also where no event is kept.
    """
    for body in bodies:
        if body.motion is not None and body.motion.tier > TIER_OF_SERIES:
            _cut(body.motion, now)
    motions: dict[int, Motion] = {}
    moved = []
    for body in bodies:
        motion = body.motion
        if motion is None:
            moved.append((body, body.v * elapsed(body.time, now), body.v))
        else:
            motions[id(motion)] = motion
            moved.append((body, motion.shift(body, body.time, now), motion.velocity(body, now)))
    for gap in gaps:
        if gap.solver is not None:
            motions[id(gap.solver)] = gap.solver
    for motion in motions.values():
        t = elapsed(motion.begun, now)
        motion.book(ledger, t)
        for gap, part in zip(
            motion.members, motion.parts(t, peaks=peaks or record.keep_events), strict=True
        ):
            _settle_gap(motion, gap, part, now, record, ledger)
        record.finished(motion, now[0])
    for body in bodies:
        if body.still is not None:
            still.book(body, now, ledger)
    for body, shift, v in moved:
        body.x, body.v, body.time, body.motion = body.x + shift, v, now, None
    for gap in gaps:
        gap.solver = None


def _cut(motion: Motion, now: Time) -> None:
    """What is integrated is done again up to now: in the middle of a step it is less exact."""
    assert isinstance(motion, CoupledGroup)
    cut = motion.until(now)
    for body in motion.bodies:
        if body.motion is motion:
            body.motion = cut
    for gap in motion.members:
        gap.solver = cut


def _settle_gap(
    motion: Motion, gap: Gap, part: GapRecord, now: Time, record: Record, ledger: Ledger
) -> None:
    touching = gap.touching
    if touching is not None:
        for when, force, impulse, after in part.peaks:
            moment = later(motion.begun, when)
            touching.see(Peak(moment, force, touching.impulse + impulse, after))
        touching.impulse += part.impulse
        outside(gap.left, gap.right, part.impulse, ledger)
        ledger.dissipate(part.dissipated)
        if gap.law is not None:
            record.depth(gap, part.deepest)
            gap.memory = gap.law.remember(part.deepest, gap.memory)
    for one in gap.loose:
        one.impulse += one.link.impulse(elapsed(motion.begun, now), part.summed)
    gap.room, gap.rate, gap.time = -part.over, -part.rate, now
    if touching is None and gap.room >= 0.0:
        gap.memory = 0.0
