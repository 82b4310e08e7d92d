"""What follows when a motion ends: each end has its own consequence.

apart   the contact is over                      touch   a linked pair's contact begins
turn    the bumper springs back                  clear   its bumper forgets
climb   the bumper is pressed further            halt    the body stands still for a moment
off     a loose spring falls off                 slip    it begins to slide
nearest a pair that never touches turns round
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from sim.dynamics.loop import contacts, impacts, release
from sim.dynamics.loop.collapse import one_velocity
from sim.dynamics.loop.first_struck import fastest_of
from sim.dynamics.loop.rooms import resting
from sim.dynamics.motion.guards import branch_of, push_now
from sim.dynamics.result.ledger import Ledger
from sim.dynamics.result.record import Record
from sim.dynamics.state import flips
from sim.dynamics.state.body import Body, End, Gap, Motion
from sim.dynamics.state.chain import Chain
from sim.dynamics.state.clock import Time
from sim.laws.branch import Cause


def carry_out_ends(
    motion: Motion, now: Time, record: Record, ledger: Ledger, instant: float, least: float
) -> int:
    """Carry out all that ended a settled motion, but for touches without a duration (`struck`).

    Changes that are closer together than `instant` [s] happen at once; approaches slower than
    `least` [m/s] are nothing. Returns the number of events that it told.
    """
    happened = 0
    for one in dict.fromkeys(_changing(motion, end) for end in motion.ends):
        flips.note(one, now, instant)
    for end in motion.ends:
        if end.cause == "apart" and motion.locked(end.k) and motion.members[end.k].rate == 0.0:
            _go_on_alike(motion.members[end.k], ledger)
        if end.cause == "halt":
            _halt(motion, end.k)
        elif end.cause == "slip":
            motion.bodies[end.k].slips = end.direction
        else:
            gap = motion.members[end.k]
            if end.cause == "touch" and end_negligible_approach(gap, least, ledger):
                gap.room = -resting(gap)
            else:
                happened += _in_gap(end.cause, gap, now, record, ledger)
    return happened


def _changing(motion: Motion, end: End) -> Body | Gap:
    return motion.bodies[end.k] if end.cause in ("halt", "slip") else motion.members[end.k]


def _in_gap(cause: Cause, gap: Gap, now: Time, record: Record, ledger: Ledger) -> int:
    if cause == "touch":
        return _touch(gap, now, record, ledger)
    if cause == "off":
        return release.fall_off(gap, now, record)
    if cause == "nearest":
        return _nearest(gap, now, record)
    if cause == "clear" and gap.spent:
        _forgets_its_release(gap)
    elif cause == "clear":
        gap.room = gap.memory = 0.0
    elif gap.touching is None:
        pass  # it came apart at the same instant
    elif cause == "climb":
        gap.touching.pressing, gap.room = True, -gap.memory
    elif cause == "turn":
        gap.touching.pressing = False
        gap.memory = -gap.room
        if not _parts_already(gap):
            _turns_round(gap)
    else:
        return _apart(gap, now, record, ledger)
    return 0


NOTHING = 1e-20
"""Of the longest cart. What moves no further than that in all the run shows in no place; beside
what moves further it is far below the last bit of a velocity."""


def end_negligible_approach(gap: Gap, least: float, ledger: Ledger) -> bool:
    """Whether an approach slower than `least` [m/s] is over. If so, both get one velocity and the
    rate is set to 0.

    Where a spring's place of rest is the very edge of a contact, each touch leaves a part of the
    speed of the one before, for ever: no overlap at rest says what is small beside it. What presses
    the two together does so still, and they touch again at once, without an approach.
    """
    if not 0.0 < -gap.rate <= least:
        return False
    one_velocity([gap.left, gap.right], ledger)
    gap.rate = 0.0
    return True


def _turns_round(gap: Gap) -> None:
    """Two do not move against each other; where one stands (a wall does) the other does: with a
    velocity that rounding left it would slide on where friction can hold it."""
    gap.rate = 0.0
    if gap.left.v == 0.0 or gap.right.v == 0.0:
        gap.left.v = gap.right.v = 0.0


def _go_on_alike(gap: Gap, ledger: Ledger) -> None:
    """Two that were held together part with one velocity: they differ by rounding only, and would
    open a room of rounding, to touch again late or soon."""
    _turns_round(gap)
    one_velocity([gap.left, gap.right], ledger)


def _forgets_its_release(gap: Gap) -> None:
    """Its bumpers no longer overlap by more than they would at rest."""
    assert gap.law is not None
    gap.spent, gap.room = False, -gap.law.resting_overlap(gap.memory)
    if gap.room == 0.0:
        gap.memory = 0.0


TURNS = 1e-13
"""Of the speed that a bumper gets from its greatest overlap: what rounding leaves of a rate at the
turn. More of it is the bodies' own, and stays the gap's too, or the account would not close."""


def _parts_already(gap: Gap) -> bool:
    """Was it pressed further by rounding alone, and springs back at once, faster than rounding?"""
    law = gap.law
    assert law is not None
    speed = gap.memory * math.sqrt(law.steepest / gap.mu)
    return law.e > 0.0 and gap.rate > TURNS * speed


def _apart(gap: Gap, now: Time, record: Record, ledger: Ledger) -> int:
    law = gap.law
    if law is None:  # an instant contact that rested: nothing to tell
        gap.touching = None
        return 0
    ledger.dissipate(law.stored(-gap.room, -gap.rate, gap.memory))
    gap.room = -law.residual_overlap(-gap.room, gap.memory)
    last = law.last_force(gap.mu, -gap.rate)
    if gap.room >= 0.0:
        gap.room = gap.memory = 0.0
    contacts.tell_separation(gap, now, last, record)
    return 1


def _touch(gap: Gap, now: Time, record: Record, ledger: Ledger) -> int:
    """Of a pair that a spring holds: the contact begins at its resting overlap."""
    if gap.law is None:
        gap.room = 0.0
        return 0
    if not is_push(gap):
        gap.room = -gap.law.resting_overlap(gap.memory) if gap.memory else 0.0
    contacts.touch(gap, now, record, ledger)
    return 2


def _nearest(gap: Gap, now: Time, record: Record) -> int:
    """Two that never touch turn round: their greatest force. No impulse: it begins nowhere."""
    _turns_round(gap)
    speeds = (gap.left.v, gap.right.v)
    record.event("peak", gap, now, speeds, speeds, 0.0, push_now(gap, branch_of(gap)))
    return 1


def struck(
    motion: Motion, beside: Sequence[Gap], chain: Chain, ledger: Ledger, now: Time
) -> list[list[Gap]]:
    """Linked pairs that touch at the end of the motion by a law without a duration.

    Those that turn round where they touch do so here, and are not struck. Of several that close,
    pairs without links `beside` them too, the fastest are (`first_struck`); the others touch still
    when the row has formed anew. Where none closes, all come to rest against each other.
    """
    touched = [motion.members[end.k] for end in motion.ends if end.cause == "touch"]
    found = []
    for gap in touched:
        if gap.law is not None:
            continue
        if impacts.grazes(gap):
            impacts.graze(chain, gap, ledger)
        else:
            found.append(gap)
    found = sorted([*found, *beside], key=lambda gap: gap.index)
    closing = fastest_of(found, now) if len(found) > 1 else []
    return closing or [[gap] for gap in found]


def _halt(motion: Motion, k: int) -> None:
    """Body k, and all whose contacts are locked to it, have v = 0: they differ by rounding only."""
    gaps = motion.members
    first, last = k, k
    while first > 0 and motion.locked(first - 1) and gaps[first - 1].rate == 0.0:
        first -= 1
    while last < len(gaps) and motion.locked(last) and gaps[last].rate == 0.0:
        last += 1
    for body in motion.bodies[first : last + 1]:
        body.v, body.slips = 0.0, 0
    for gap in gaps:
        if gap.left.v == 0.0 and gap.right.v == 0.0:
            gap.rate = 0.0  # else a rate that rounding left would set the one that halts going


def is_push(gap: Gap) -> bool:
    """Does the gap touch because an overlap that is left begins to push again?"""
    return gap.room < 0.0 and gap.law is not None and (gap.law.recontacts or gap.spent)
