"""Who slides, in which direction, and who is held by static friction.

A body that moves slides in the direction of its velocity. One at rest is held while all other
forces together are at most μ_s N; otherwise it slides where they push it. Bodies whose contact is
locked (a bumper with e = 0 at its greatest overlap, an `instant` contact that rests) move as one:
they are judged together. Next to a wall a locked group cannot slide at all.
"""

from __future__ import annotations

from sim.dynamics.motion.guards import SAME_GRIP, grip, push_now
from sim.dynamics.state.body import Body, Gap
from sim.laws.branch import Branch


def decide(bodies: list[Body], gaps: list[Gap], branches: list[Branch]) -> None:
    """Set `sliding` and `held` of the bodies of one component, as they are just now; those locked
    to a wall get its velocity, nought.

    `bodies` and `gaps` run from left to right; walls among the bodies are left alone.
    """
    pushes: list[float] = []
    group: list[int] = []
    for i, body in enumerate(bodies):
        group.append(i)
        if i < len(gaps) and branches[i].locked:
            continue
        if len(group) == 1 and body.v != 0.0:  # the common case, whatever pushes it
            body.slips, body.held, body.sliding = 0, False, 1 if body.v > 0.0 else -1
        else:
            if not pushes:
                pushes = [push_now(gap, branch) for gap, branch in zip(gaps, branches, strict=True)]
            _judge(bodies, group, gaps, pushes)
        group = []


def _judge(bodies: list[Body], group: list[int], gaps: list[Gap], pushes: list[float]) -> None:
    first, last = group[0], group[-1]
    members = [bodies[i] for i in group]
    total = sum(body.load.steady for body in members if body.carts)
    total += pushes[first - 1] if first > 0 else 0.0
    total -= pushes[last] if last < len(pushes) else 0.0
    fixed = any(not body.carts for body in members) and len(members) > 1
    if fixed and all(gap.rate == 0.0 for gap in gaps[first:last]):
        for body in members:
            body.v = 0.0  # as the wall; they differ by rounding only
    resting = all(body.v == 0.0 for body in members)
    static = sum(body.load.static for body in members)
    slips = next((body.slips for body in members if body.slips), 0)
    begins = any(body.slips and body.changed == body.time for body in members)
    held = resting and static > 0.0 and abs(total) <= _grip(members) and not slips
    for body in members:
        body.slips = body.slips if begins else 0  # whatever else changes at this instant
        body.held = held and body.load.static > 0.0
        if body.held or (fixed and resting):
            body.sliding = 0
        elif body.v != 0.0:
            body.sliding = 1 if body.v > 0.0 else -1
        elif slips:
            body.sliding = slips
        else:
            body.sliding = (total > 0.0) - (total < 0.0)


def _grip(members: list[Body]) -> float:
    """N. What static friction can hold of all these."""
    return sum(grip(body.load) for body in members)


def friction(body: Body, others: float) -> float:
    """N. Kinetic friction on a body; `others`: all other forces on it just now."""
    load = body.load
    if body.v == 0.0 and abs(abs(others) - load.kinetic) <= SAME_GRIP * load.kinetic:
        return -others
    return -body.sliding * load.kinetic
