"""Forces of a row that moves as a sum of modes: of its contacts, of its springs, on its bodies.

A contact that gives pushes with kappa (o − rest) + gamma o'. One that is locked pushes with what
its body needs beside all else: N_right = N_left + F − m a − b v, summed from a free end of the
bodies that are locked together, or from both ends to the one among them that does not move.
"""

from __future__ import annotations

import math

from sim.dynamics.motion.modes.modal_sum import ModalSum, plus
from sim.dynamics.motion.modes.state import ModalState
from sim.dynamics.motion.power_series.series import SettledRow
from sim.dynamics.state.body import Body, Gap
from sim.dynamics.state.loads import Load
from sim.effects.forces import at_touch

NOTHING = ModalSum(0.0, ())


def contact_sums(
    bodies: list[Body], gaps: list[Gap], row: SettledRow, state: ModalState
) -> tuple[list[ModalSum], list[ModalSum]] | None:
    """N of each contact and of the springs across each gap; None where statics does not tell."""
    across = [_linked(gap, over) for gap, over in zip(gaps, state.over, strict=True)]
    contact = []
    for branch, over in zip(row.branches, state.over, strict=True):
        at_rest = ModalSum(-branch.kappa * branch.rest, ())
        push = plus((branch.kappa, over), (branch.gamma, over.slope), (1.0, at_rest))
        contact.append(NOTHING if branch.locked else push)
    total = [plus((1.0, n), (1.0, a)) for n, a in zip(contact, across, strict=True)]
    first = 0
    for k, branch in enumerate(row.branches):
        if branch.locked and (k == 0 or not row.branches[k - 1].locked):
            first = k
        if branch.locked and (k + 1 == len(gaps) or not row.branches[k + 1].locked):
            block = range(first, k + 2)
            if not _hold(block, bodies, row, state, total):
                return None
    for k, branch in enumerate(row.branches):
        if branch.locked:
            contact[k] = plus((1.0, total[k]), (-1.0, across[k]))
    return contact, across


def _linked(gap: Gap, over: ModalSum) -> ModalSum:
    if not gap.links:
        return NOTHING
    stiff = math.fsum([link.bounds(gap.room)[0] for link in gap.links])
    damp = math.fsum([link.bounds(gap.room)[1] for link in gap.links])
    return plus((stiff, over), (damp, over.slope), (1.0, ModalSum(at_touch(gap.links), ())))


def _hold(
    block: range, bodies: list[Body], row: SettledRow, state: ModalState, total: list[ModalSum]
) -> bool:
    """Fill in the locked gaps of a block."""
    still = [i for i in block if row.inverse[i] == 0.0]
    if len(still) > 1 or any(bodies[i].held for i in block):
        return False
    turn = still[0] if still else block[-1]
    for i in range(block[0], turn):
        before = total[i - 1] if i > 0 else NOTHING
        total[i] = plus((1.0, before), (1.0, _needed(i, bodies, row, state)))
    for i in range(block[-1], turn, -1):
        after = total[i] if i < len(total) else NOTHING
        total[i - 1] = plus((1.0, after), (-1.0, _needed(i, bodies, row, state)))
    return True


def _needed(i: int, bodies: list[Body], row: SettledRow, state: ModalState) -> ModalSum:
    """F − m a − b v of a body."""
    speed = state.speed[i]
    steady = ModalSum(row.steady[i], ())
    return plus((1.0, steady), (-bodies[i].mass, speed.slope), (-row.linear[i], speed))


def others(i: int, load: Load, contact: list[ModalSum], across: list[ModalSum]) -> ModalSum:
    """N on body i from its neighbours and all that is steady: what static friction balances."""
    parts = [(1.0, ModalSum(load.steady, ()))]
    for k, sign in ((i - 1, 1.0), (i, -1.0)):
        if 0 <= k < len(contact):
            parts += [(sign, contact[k]), (sign, across[k])]
    return plus(*parts)
