"""What a settled cluster does at the end of its step: each end has its own consequence.

apart   the contact is over                      touch   a linked pair's contact begins
turn    the bumper springs back                  clear   its bumper forgets
climb   the bumper is pressed further            halt    the body stands still for a moment
                                                 slip    it begins to slide
"""

from __future__ import annotations

from sim.dynamics.loop import contacts as resolve
from sim.dynamics.motion.coupled_group import Cluster
from sim.dynamics.motion.linear_pair import PairPhase
from sim.dynamics.motion.polynomial import value
from sim.dynamics.result.ledger import Ledger
from sim.dynamics.result.record import Record
from sim.dynamics.state.chain import Gap
from sim.dynamics.state.clock import Time, elapsed


def leave(cluster: Cluster | PairPhase, now: Time, record: Record, ledger: Ledger) -> int:
    """Carry out all that ended the step, but for touches without a duration (`struck`).

    Returns the number of events that it told.
    """
    happened = 0
    for cause, k in cluster.ends:
        if isinstance(cluster, Cluster) and cause == "halt":
            _halt(cluster, k)
        elif isinstance(cluster, Cluster) and cause == "slip":
            _slip(cluster, k, now)
        elif cause == "touch":
            happened += _touch(cluster.members[k], now, record, ledger)
        elif cause == "clear":
            cluster.members[k].room = cluster.members[k].memory = 0.0
        elif cluster.members[k].touching is not None:  # else it came apart at the same instant
            if cause == "climb":
                _climb(cluster.members[k])
            elif cause == "turn":
                _turn(cluster.members[k])
            else:
                happened += _apart(cluster.members[k], now, record, ledger)
    return happened


def _climb(gap: Gap) -> None:
    assert gap.touching is not None
    gap.touching.pressing = True
    gap.room = -gap.memory


def _turn(gap: Gap) -> None:
    assert gap.touching is not None
    gap.touching.pressing = False
    gap.rate, gap.memory = 0.0, -gap.room


def _apart(gap: Gap, now: Time, record: Record, ledger: Ledger) -> int:
    law = gap.law
    if law is None:  # an instant contact that rested: nothing to tell
        gap.touching = None
        return 0
    ledger.warm(law.stored(-gap.room, -gap.rate, gap.memory))
    gap.room = -law.left_over(-gap.room, gap.memory)
    last = law.last_force(gap.mu, -gap.rate)
    if gap.room >= 0.0:
        gap.room = gap.memory = 0.0
    resolve.tell_separation(gap, now, last, record)
    return 1


def _touch(gap: Gap, now: Time, record: Record, ledger: Ledger) -> int:
    """Of a pair that a spring holds: the contact begins at its resting overlap."""
    if gap.law is None:
        gap.room = 0.0
        return 0
    if not is_push(gap):
        gap.room = -gap.law.resting_overlap(gap.memory) if gap.memory else 0.0
    resolve.touch(gap, now, record, ledger)
    return 2


def struck(cluster: Cluster | PairPhase) -> list[Gap]:
    """Linked pairs that touch at the end of the step by a law without a duration."""
    touched = [cluster.members[k] for cause, k in cluster.ends if cause == "touch"]
    return [gap for gap in touched if gap.law is None]


def _halt(cluster: Cluster, k: int) -> None:
    """Body k, and all whose contacts are locked to it, have v = 0: they differ by rounding only."""
    bodies, branches = cluster.bodies, cluster.branches
    gaps = cluster.members
    first, last = k, k
    while first > 0 and branches[first - 1].locked and gaps[first - 1].rate == 0.0:
        first -= 1
    while last < len(branches) and branches[last].locked and gaps[last].rate == 0.0:
        last += 1
    for body in bodies[first : last + 1]:
        body.v = 0.0


def _slip(cluster: Cluster, k: int, now: Time) -> None:
    body = cluster.bodies[k]
    others = value(cluster.other_force(k), elapsed(cluster.begun, now))
    body.slips = 1 if others > 0.0 else -1


def is_push(gap: Gap) -> bool:
    """Does the gap touch because an overlap that is left begins to push again?"""
    return gap.room < 0.0 and gap.law is not None and gap.law.recontacts
