"""Plastic impacts (e = 0) side by side at one instant: where they end, however they are ordered.

An impact in gap i takes its approach u_i and adds to those of the gaps beside it, for it slows the
body that they meet. So approaches that are none of them below nought stay so, whichever gap is
struck next; each impact takes energy, so in the limit all are nought: one velocity. A gap beside
them that opens is struck if, and only if, it closes at that velocity; then it belongs to them.

Followed one by one, a cart of 1 kg that presses two of a gram against a wall would take a million
impacts to rest: each takes a thousandth of its velocity.
"""

from __future__ import annotations

from sim.dynamics.loop.first_struck import touches
from sim.dynamics.loop.pair_laws import centre_velocity
from sim.dynamics.state.body import Gap
from sim.dynamics.state.chain import Chain, velocity
from sim.dynamics.state.clock import Time


def row_of(chain: Chain, block: list[Gap], now: Time) -> list[Gap]:
    """The gaps, from left to right, of all bodies that end with one velocity when `block` is hit.

    Empty where one of them gives something back, or is held by something else. The bodies of the
    block are up to date.
    """
    row = list(block)
    if not all(map(_is_plastic, row)):
        return []
    while (near := _closes(chain, row, now)) is not None:
        if not _is_plastic(near):
            return []
        row = [near, *row] if near.index < row[0].index else [*row, near]
    return row if len(row) > len(block) else []


def _is_plastic(gap: Gap) -> bool:
    free = gap.law is None and not gap.joined and gap.solver is None
    return free and gap.contact.restitution == 0.0


def _closes(chain: Chain, row: list[Gap], now: Time) -> Gap | None:
    """A gap beside the row that touches, and closes when the row has its common velocity."""
    bodies = [row[0].left, *(gap.right for gap in row)]
    v = centre_velocity([(body.mass, velocity(body, now)) for body in bodies])
    before, after = chain.neighbours(row[0])[0], chain.neighbours(row[-1])[1]
    if before is not None and touches(before, now) and velocity(before.left, now) >= v:
        return before
    if after is not None and touches(after, now) and velocity(after.right, now) <= v:
        return after
    return None
