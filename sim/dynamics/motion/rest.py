"""A row at rest under a constant load: its forces by statics, and no steps until the load changes.

Bodies that touch and lie still (or share one constant acceleration) keep their overlaps. Blocks of
bodies whose contacts are locked move as one. At rest

    N_(i+1) = N_i + F_i ,     N = kappa (o − rest) in a contact that gives,

whatever the balance takes in a locked one: from an open end all forces follow one by one; between
two ends that stand fast the strains add up to nought. A row counts as at rest when what is left of
its motion, in rates and in ways still to go, is QUIET of the speed that the load itself
would give it, and when every contact presses there: then this is the one solution of the
complementarity problem of the row (all contacts carry), and it holds as long as the load does.
Springs and magnets across the gaps take part with their stiffness. Without an anchor (a wall, a
cart that static friction holds) the row's common acceleration is taken out first. Air
is an anchor where no load drives the row through it: it rests when nobody moves in it any more.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from sim.dynamics.motion.friction_shares import pushes
from sim.dynamics.motion.power_series.step import Step
from sim.dynamics.state.body import Body, Gap
from sim.laws.branch import Branch
from sim.laws.rounding import LAST_BITS

QUIET = 3e-13
"""Of the speed o W that the overlaps o under the load would swing with, W the fastest rate."""

NEARLY = 2.0
"""Of what counts as quiet. More than that moves, whatever the places of rest."""

PRESSES = 1e-9
"""Of the greatest contact force in the row. A contact that carries less may be about to part."""


@dataclass(frozen=True, slots=True)
class Balance:
    """A row with its load: force on each body, stiffness of each gap, its forces just now."""

    force: list[float]  # N, besides contacts and links
    stiff: list[float]  # N/m, contact and links
    push: list[float]  # N, contact and links; 0 of a locked contact
    fixed: list[bool]
    locked: list[bool]


def at_rest(
    bodies: list[Body], gaps: list[Gap], branches: list[Branch], fastest: float, limit: float
) -> Step | None:
    """The step of a row at rest, `limit` s long; None where it is not at rest.

    `fastest` [1/s] bounds the rates of its oscillations; 0 where all contacts are locked, and
    nothing can swing.
    """
    swings = 0.0 < fastest < math.inf
    if not _may_rest(bodies, gaps, branches) or not (swings or all(b.locked for b in branches)):
        return None
    touch = [gap.touching is not None for gap in gaps]
    quiet = _quiet([-gap.room for gap in gaps], touch)
    if max(abs(gap.rate) for gap in gaps) > NEARLY * fastest * quiet:
        return None  # overlaps at rest are those of now, as near as it takes
    balance, common = _balance(bodies, gaps, branches)
    in_air = any(body.load.linear or body.load.quadratic for body in bodies)
    strained, stands = strains(balance), in_air or any(balance.fixed)
    if strained is None or (stands and common != 0.0):
        return None
    over = [-gap.room - e for gap, e in zip(gaps, strained, strict=True)]
    quiet = fastest * _quiet(over, touch)
    if not _is_quiet(bodies, gaps, strained, fastest, quiet, stands=stands):
        return None
    across = [
        math.fsum(link.force(-o, 0.0) for link in g.links) for g, o in zip(gaps, over, strict=True)
    ]
    contact = _contacts(balance, branches, over, across, [body.load.static for body in bodies])
    if contact is None:
        return None
    pressing = [n for n, own in zip(contact, touch, strict=True) if own]
    if pressing and min(pressing) <= PRESSES * max(pressing):
        return None
    total = math.fsum(b.mass for b in bodies if b.mass < math.inf)
    v = 0.0 if stands else math.fsum(b.mass * b.v for b in bodies) / total
    a = [0.0 if fixed else common for fixed in balance.fixed]
    for body in bodies:
        body.v = v
    steady = [body.load.steady for body in bodies]
    return Step(
        bodies, gaps, branches, limit, [[o, 0.0] for o in over], [[n] for n in contact],
        [[p] if gap.links else [] for gap, p in zip(gaps, across, strict=True)],
        [[v, one] for one in a], [[0.0, v, 0.5 * one] for one in a], steady, short=False,
    )  # fmt: skip


def _may_rest(bodies: list[Body], gaps: list[Gap], branches: list[Branch]) -> bool:
    """Do all touch, by forces with a stiffness, and does nobody slide?"""
    fixed = [body.held or body.mass == math.inf for body in bodies]
    for block in blocks([branch.locked for branch in branches]):
        if any(fixed[i] for i in block):
            continue  # a wall or static friction holds all of them
        if any(bodies[i].load.static or bodies[i].load.kinetic for i in block):
            return False
    return bool(gaps) and all(
        (gap.touching is not None and (branch.locked or branch.kappa > 0.0))
        or (gap.touching is None and bool(gap.links) and gap.room > 0.0)
        for gap, branch in zip(gaps, branches, strict=True)
    )


def _quiet(over: list[float], touch: list[bool]) -> float:
    """m. By how little overlaps may miss their place of rest."""
    return max((QUIET if t else LAST_BITS) * abs(o) for o, t in zip(over, touch, strict=True))


def _balance(bodies: list[Body], gaps: list[Gap], branches: list[Branch]) -> tuple[Balance, float]:
    """Forces just now at no speed, and the acceleration that all share."""
    fixed = [body.held or body.mass == math.inf for body in bodies]
    force = [body.load.steady for body in bodies]
    common = 0.0
    if not any(fixed):
        common = math.fsum(force) / math.fsum(body.mass for body in bodies)
        force = [f - body.mass * common for f, body in zip(force, bodies, strict=True)]
    stiff, push = [], []
    for gap, branch in zip(gaps, branches, strict=True):
        linked = math.fsum(link.force(gap.room, 0.0) for link in gap.links)
        stiff.append(branch.kappa + math.fsum(link.bounds(gap.room)[0] for link in gap.links))
        push.append((0.0 if branch.locked else branch.force(-gap.room, 0.0)) + linked)
    return Balance(force, stiff, push, fixed, [branch.locked for branch in branches]), common


def blocks(locked: list[bool]) -> list[range]:
    """Bodies whose contacts are locked, together: `locked` of each gap between them."""
    found, first = [], 0
    for k, one in enumerate(locked):
        if not one:
            found.append(range(first, k + 1))
            first = k + 1
    found.append(range(first, len(locked) + 1))
    return found


def segments(balance: Balance) -> list[tuple[list[range], list[int | None]]]:
    """Blocks that move, up to the next ones that do not, and the gaps before and behind each.

    None stands for an open end.
    """
    rows, found = blocks(balance.locked), []
    own: list[range] = []
    for block in [*rows, None]:
        if block is not None and not any(balance.fixed[i] for i in block):
            own.append(block)
            continue
        if own:
            first, last = own[0][0] - 1, own[-1][-1]
            ends = [*(one[0] - 1 for one in own[1:]), last if last < len(balance.stiff) else None]
            found.append((own, [first if first >= 0 else None, *ends]))
        own = []
    return found


def strains(balance: Balance) -> list[float] | None:
    """m. By how much each gap is pressed more than at its place of rest; None where nothing gives.

    What each push is at rest follows from the forces, from an open end on or, between two bodies
    that do not move, up to a number that makes the strains add up to nought. No differences of
    ways: a stiff contact beside a soft spring keeps its figures.
    """
    found = [0.0] * len(balance.stiff)
    for own, near in segments(balance):
        inside = [k for k in near if k is not None]
        if any(balance.stiff[k] <= 0.0 for k in inside):
            return None
        sums = [0.0]
        for block in own:
            sums.append(math.fsum([sums[-1], *(balance.force[i] for i in block)]))
        if near[0] is None:
            first = 0.0
        elif near[-1] is None:
            first = -sums[-1]
        else:
            gives = [1.0 / balance.stiff[k] for k in inside]
            more = [
                (balance.push[k] - total) * give
                for k, total, give in zip(inside, sums, gives, strict=True)
            ]
            first = math.fsum(more) / math.fsum(gives)
        for k, total in zip(near, sums, strict=True):
            if k is not None:
                found[k] = (balance.push[k] - (first + total)) / balance.stiff[k]
    return found


def _is_quiet(
    bodies: list[Body],
    gaps: list[Gap],
    strained: list[float],
    fastest: float,
    quiet: float,
    *,
    stands: bool,
) -> bool:
    """Is nothing left of the motion?"""
    rates = max(abs(gap.rate) for gap in gaps)
    ways = max(map(abs, strained)) * fastest
    speeds = max(abs(body.v) for body in bodies) if stands else 0.0
    return max(rates, ways, speeds) <= quiet


def _contacts(
    balance: Balance,
    branches: list[Branch],
    over: list[float],
    across: list[float],
    static: list[float],
) -> list[float] | None:
    """N of each contact at rest; None where a locked block is held by a wall and otherwise too.

    `static` [N]: what friction can hold each body with; it shares the load of those that it holds
    together (`friction_shares`).
    """
    push = [
        0.0 if branch.locked else branch.force(o, 0.0)
        for branch, o in zip(branches, over, strict=True)
    ]
    total = [p + a for p, a in zip(push, across, strict=True)]
    for block in blocks(balance.locked):
        anchors = [i for i in block if balance.fixed[i]]
        if len(anchors) > 1:
            if any(static[i] == 0.0 for i in block):
                return None
            _share(block, balance.force, static, total)
            continue
        turn = anchors[0] if anchors else block[-1]
        for i in range(block[0], turn):  # from the left: N_right = N_left + F
            total[i] = (total[i - 1] if i > 0 else 0.0) + balance.force[i]
        for i in range(block[-1], turn, -1):  # from the right
            total[i - 1] = (total[i] if i < len(total) else 0.0) - balance.force[i]
    return [t - a for t, a in zip(total, across, strict=True)]


def _share(block: range, force: list[float], static: list[float], total: list[float]) -> None:
    """Fill in what presses together the carts of a block that friction holds, each of them."""
    first, last = block[0], block[-1]
    others = force[first : last + 1]
    others[0] += total[first - 1] if first > 0 else 0.0
    others[-1] -= total[last] if last < len(total) else 0.0
    total[first:last] = pushes(others, static[first : last + 1])
