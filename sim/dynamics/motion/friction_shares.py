"""What presses two carts together that lie still, held by static friction and by their bumper.

Statics alone does not say: each cart could hold itself, or lean on the next. Here static friction
on a group of locked carts shares their load as it can bear it, so that all of them slip at once:

    f_i = −total · static_i / Σ static        N_k = N_(k−1) + others_k + f_k

Without it nothing would press a locked pair: it would come apart, and be pressed again at once.
"""

from __future__ import annotations

from sim.dynamics.motion.power_series.series import Expansion
from sim.dynamics.state.body import Body
from sim.laws.branch import Branch


def share(
    bodies: list[Body], branches: list[Branch], steady: list[float], found: Expansion
) -> None:
    """Fill in the forces of locked gaps inside groups of held carts."""
    for group in held_groups(bodies, branches):
        _group(bodies, group, steady, found)


def held_groups(bodies: list[Body], branches: list[Branch]) -> list[range]:
    """Neighbours that static friction holds and whose contacts are locked, two and more."""
    groups, first = [], 0
    for last, body in enumerate(bodies):
        if not (body.carts and body.held):
            first = last + 1
            continue
        if last < len(branches) and branches[last].locked and _holds(bodies, last + 1):
            continue
        if last > first:
            groups.append(range(first, last + 1))
        first = last + 1
    return groups


def _holds(bodies: list[Body], i: int) -> bool:
    return i < len(bodies) and bool(bodies[i].carts) and bodies[i].held


def _group(bodies: list[Body], group: range, steady: list[float], found: Expansion) -> None:
    first, last = group[0], group[-1]
    static = [bodies[i].load.static for i in group]
    for n in range(len(found.bodies[first])):
        others = [0.0] * len(group)
        for i in group:
            others[i - first] = steady[i] if n == 0 else 0.0
            others[i - first] += _push(found, i - 1, n, inside=first <= i - 1 < last)
            others[i - first] -= _push(found, i, n, inside=first <= i < last)
        for k, push in enumerate(pushes(others, static), first):
            found.force[k][n] = push


def pushes(others: list[float], static: list[float]) -> list[float]:
    """N in each gap between neighbours that are held; of each, all other forces and μ_s N."""
    total, bears = sum(others), sum(static)
    found, push = [], 0.0
    for other, own in zip(others[:-1], static, strict=False):
        push += other - total * own / bears
        found.append(push)
    return found


def _push(found: Expansion, k: int, n: int, *, inside: bool) -> float:
    """The n-th coefficient of what gap k pushes; of a gap inside the group only its links."""
    if not 0 <= k < len(found.force):
        return 0.0
    pull = found.pull[k][n] if found.pull[k] else 0.0
    return pull if inside else pull + found.force[k][n]
