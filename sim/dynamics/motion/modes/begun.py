"""The first derivatives of everything in a row, as its power series has them.

Blocks of bodies whose contacts are locked move as one; what presses in such a contact follows from
the two sides of its block (`shares`).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from sim.dynamics.motion.modes.shares import Swings
from sim.dynamics.motion.power_series.series import SettledRow, is_rounding


@dataclass(slots=True)
class Begun:
    """Derivatives just now: four of each overlap, from o on; three of each N; two of each v, a on.

    They are those of the series, factorials taken out.
    """

    over: list[list[float]]
    force: list[list[float]]
    bodies: list[list[float]]


TERMS = 3
"""Derivatives of forces."""


def begun_of(row: SettledRow, found: Swings) -> Begun:
    """Of a settled row."""
    steady, branches = row.steady, row.branches
    over = [[o, r] for o, r in zip(row.overlaps, row.rates, strict=True)]
    force: list[list[float]] = [[] for _ in over]
    bodies: list[list[float]] = [[] for _ in steady]
    loaded = any(steady)
    contacts = [
        (branch.kappa, branch.gamma, branch.rest, o, push)
        for branch, o, push in zip(branches, over, force, strict=True)
    ]
    locked = [branch.locked for branch in branches]
    held = [k for k, one in enumerate(locked) if one]
    moving = list(zip(bodies, found.block, [None, *over], [False, *locked], strict=True))
    for n in range(TERMS):
        for kappa, gamma, rest, o, push in contacts:
            pressed = o[n] if n else o[0] - rest
            push.append(kappa * pressed + gamma * o[n + 1])
        for k in held:
            force[k][n] = _held(k, n, found, force, steady)
        before = size_before = 0.0  # of the body on the left
        for own, block, beside, is_locked in moving:
            left = force[block.left][n] if block.left is not None else 0.0
            right = force[block.right][n] if block.right is not None else 0.0
            outside = block.load(steady) if loaded and n == 0 else 0.0
            a, size = (left - right + outside) * block.inverse, 0.0
            own.append(a)
            if loaded:  # the size of all that adds up to an acceleration
                size = (abs(left) + abs(right) + abs(outside)) * block.inverse
            if beside is not None:
                relative = before - a
                if is_locked or (loaded and is_rounding(relative, size_before + size)):
                    relative = 0.0
                beside.append(relative)
            before, size_before = a, size
    return Begun(over, force, bodies)


def _held(k: int, n: int, found: Swings, force: list[list[float]], steady: list[float]) -> float:
    """N, or its n-th derivative, in a gap that is locked."""
    block, f = found.block[k], found.left_mass[k]
    left = force[block.left][n] if block.left is not None else 0.0
    right = force[block.right][n] if block.right is not None else 0.0
    push = (1.0 - f) * left + f * right
    if n == 0:
        before = math.fsum([steady[i] for i in block.bodies if i <= k])
        after = math.fsum([steady[i] for i in block.bodies if i > k])
        push += (1.0 - f) * before - f * after
    return push
