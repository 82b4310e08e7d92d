"""A row at rest under a constant load: its forces by statics, and no steps until the load changes.

Bodies that touch and lie still (or share one constant acceleration) keep their overlaps. With x_i
the small way from here to the exact place of rest, and blocks of bodies whose contacts are locked
moving as one,

    (kappa_L + kappa_R) x_i − kappa_L x_(i−1) − kappa_R x_(i+1) = F_i + N_L − N_R
    N = kappa (o − rest) in a contact that gives, whatever the balance takes in a locked one

a tridiagonal, positive definite system (Thomas's algorithm). A row counts as at rest when what is
left of its motion, in rates and in ways still to go, is QUIET of the speed that the load itself
would give it, and when every contact presses there: then this is the one solution of the
complementarity problem of the row (all contacts carry), and it holds as long as the load does.
Springs and magnets across the gaps take part with their stiffness. Without an anchor (a wall, a
cart that static friction holds) the row's common acceleration is taken out first.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass

from sim.dynamics.motion.step import Step
from sim.dynamics.state.body import Body, Gap
from sim.laws.branch import Branch

QUIET = 3e-13
"""Of the speed o W that the overlaps o under the load would swing with, W the fastest rate."""

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

    `fastest` [1/s] bounds the rates of its oscillations.
    """
    if not _may_rest(bodies, gaps) or not 0.0 < fastest < math.inf:
        return None
    balance, common = _balance(bodies, gaps, branches)
    moved = _displacements(balance)
    if moved is None:
        return None
    over = [-gap.room + a - b for gap, a, b in zip(gaps, moved, moved[1:], strict=False)]
    quiet = QUIET * fastest * max(abs(o) for o in over)
    if not _is_quiet(bodies, gaps, moved, fastest, quiet, anchored=any(balance.fixed)):
        return None
    across = [
        math.fsum(link.force(-o, 0.0) for link in g.links) for g, o in zip(gaps, over, strict=True)
    ]
    contact = _contacts(balance, branches, over, across)
    if contact is None or min(contact) <= PRESSES * max(contact):
        return None
    total = math.fsum(b.mass for b in bodies if b.mass < math.inf)
    v = 0.0 if any(balance.fixed) else math.fsum(b.mass * b.v for b in bodies) / total
    a = [0.0 if fixed else common for fixed in balance.fixed]
    for body in bodies:
        body.v = v
    steady = [body.load.steady for body in bodies]
    return Step(
        bodies, gaps, branches, limit, [[o, 0.0] for o in over], [[n] for n in contact],
        [[p] if gap.links else [] for gap, p in zip(gaps, across, strict=True)],
        [[v, one] for one in a], [[0.0, v, 0.5 * one] for one in a], steady, short=False,
    )  # fmt: skip


def _may_rest(bodies: list[Body], gaps: list[Gap]) -> bool:
    """Do all touch, by laws with linear branches, and does nobody slide?"""
    free = not any(body.held or body.mass == math.inf for body in bodies)
    for body in bodies:
        load = body.load
        if not body.held and (load.grips or (free and (load.linear or load.quadratic))):
            return False
    return bool(gaps) and all(
        gap.touching is not None and (gap.law is None or gap.law.linear) for gap in gaps
    )


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


def _blocks(balance: Balance) -> list[range]:
    """Bodies whose contacts are locked, together."""
    blocks, first = [], 0
    for k, locked in enumerate(balance.locked):
        if not locked:
            blocks.append(range(first, k + 1))
            first = k + 1
    blocks.append(range(first, len(balance.force)))
    return blocks


def _displacements(balance: Balance) -> list[float] | None:
    """m. The way of each body to its place of rest; None where nothing gives."""
    blocks = _blocks(balance)
    still = [any(balance.fixed[i] for i in block) for block in blocks]
    if not any(still):
        still[0] = True  # only differences count
    ratio, right = [0.0], [0.0]
    for j, block in enumerate(blocks):
        before = balance.stiff[block[0] - 1] if block[0] > 0 else 0.0
        after = balance.stiff[block[-1]] if block[-1] < len(balance.stiff) else 0.0
        known = math.fsum(balance.force[i] for i in block)
        known += math.fsum(
            (balance.push[i - 1] if i > 0 else 0.0)
            - (balance.push[i] if i < len(balance.push) else 0.0)
            for i in block
        )
        pivot = before + after - before * ratio[-1]
        if still[j]:
            ratio.append(0.0)
            right.append(0.0)
        elif pivot <= 0.0:
            return None
        else:
            ratio.append(after / pivot)
            right.append((known + before * right[-1]) / pivot)
    moved = [0.0] * len(balance.force)
    x = 0.0
    for j in range(len(blocks) - 1, -1, -1):
        x = right[j + 1] + ratio[j + 1] * x
        for i in blocks[j]:
            moved[i] = x
    return moved


def _is_quiet(
    bodies: list[Body],
    gaps: list[Gap],
    moved: list[float],
    fastest: float,
    quiet: float,
    *,
    anchored: bool,
) -> bool:
    """Is nothing left of the motion?"""
    rates = max(abs(gap.rate) for gap in gaps)
    ways = max(abs(a - b) for a, b in itertools.pairwise(moved)) * fastest
    speeds = max(abs(body.v) for body in bodies) if anchored else 0.0
    return max(rates, ways, speeds) <= quiet


def _contacts(
    balance: Balance, branches: list[Branch], over: list[float], across: list[float]
) -> list[float] | None:
    """N of each contact at rest; None where a locked block is held from both sides."""
    push = [
        0.0 if branch.locked else branch.force(o, 0.0)
        for branch, o in zip(branches, over, strict=True)
    ]
    total = [p + a for p, a in zip(push, across, strict=True)]
    for block in _blocks(balance):
        anchors = [i for i in block if balance.fixed[i]]
        if len(anchors) > 1:
            return None
        turn = anchors[0] if anchors else block[-1]
        for i in range(block[0], turn):  # from the left: N_right = N_left + F
            total[i] = (total[i - 1] if i > 0 else 0.0) + balance.force[i]
        for i in range(block[-1], turn, -1):  # from the right
            total[i - 1] = (total[i] if i < len(total) else 0.0) - balance.force[i]
    return [t - a for t, a in zip(total, across, strict=True)]
