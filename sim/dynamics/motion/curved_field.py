"""The equations of a row in which some contact has a curved law: f(y) for an adaptive method.

    y = overlaps, their rates, velocities, displacements, impulses and losses of the contacts,
        integrals of the squares of the rates; of v², v|v| and |v|³ where there is drag;
        impulses of springs and magnets where there are any

All that does not change within a step is looked up once.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from sim.dynamics.motion.friction_shares import held_groups, pushes
from sim.dynamics.motion.locked import hold_now
from sim.dynamics.motion.power_series.series import SettledRow
from sim.dynamics.state.body import Body, Gap
from sim.laws.contact_law import ContactLaw

Field = Callable[[list[float]], list[float]]


def curved(gap: Gap) -> ContactLaw | None:
    """The law of a gap that touches by one without linear branches."""
    law = gap.law
    return law if law is not None and not law.linear and gap.touching is not None else None


def dragged(bodies: list[Body]) -> list[int]:
    """Places of the bodies that drag slows."""
    return [i for i, body in enumerate(bodies) if body.load.linear or body.load.quadratic]


def linked(gaps: list[Gap]) -> list[int]:
    """Places of the gaps that springs or magnets act across."""
    return [k for k, gap in enumerate(gaps) if gap.links]


def field_of(bodies: list[Body], gaps: list[Gap], row: SettledRow) -> Field:
    """f(y)."""
    count, last = len(gaps), 2 * len(gaps) + len(bodies)
    between = [_push(gap, row, k) for k, gap in enumerate(gaps)]
    links = [(k, [link.force for link in gaps[k].links]) for k in linked(gaps)]
    locked = [branch.locked for branch in row.branches]
    held = any(locked)
    groups = [
        (group, [bodies[i].load.static for i in group])
        for group in held_groups(bodies, row.branches)
    ]
    slowed = dragged(bodies)
    drags = [(i, bodies[i].load.linear, bodies[i].load.quadratic) for i in slowed]

    def f(y: list[float]) -> list[float]:
        over, rate, v = y[:count], y[count : 2 * count], y[2 * count : last]
        push, loss = [], []
        for one, d, s in zip(between, over, rate, strict=True):
            force, lost = one(d, s)
            push.append(force)
            loss.append(lost)
        outside = list(row.steady)
        for i, linear, quadratic in drags:
            outside[i] -= (linear + quadratic * abs(v[i])) * v[i]
        pulls = []
        for k, forces in links:
            pull = math.fsum([force(-over[k], -rate[k]) for force in forces])
            outside[k] -= pull
            outside[k + 1] += pull
            pulls.append(pull)
        if held:
            hold_now(row.branches, push, row.inverse, outside)
        for group, static in groups:  # none of them moves: friction says what presses them
            others = [outside[i] for i in group]
            others[0] += push[group[0] - 1] if group[0] > 0 else 0.0
            others[-1] -= push[group[-1]] if group[-1] < count else 0.0
            push[group[0] : group[-1]] = pushes(others, static)
        a = []
        before = 0.0
        for i, inv in enumerate(row.inverse):
            after = push[i] if i < count else 0.0
            a.append((before - after + outside[i]) * inv)
            before = after
        relative = [0.0 if locked[k] else a[k] - a[k + 1] for k in range(count)]
        squares = [r * r for r in rate]
        for i in slowed:
            squares += [v[i] * v[i], v[i] * abs(v[i]), abs(v[i]) ** 3]
        return [*rate, *relative, *a, *v, *push, *loss, *squares, *pulls]

    return f


def _push(gap: Gap, row: SettledRow, k: int) -> Callable[[float, float], tuple[float, float]]:
    """N and W at overlap and rate."""
    law, mu, branch = curved(gap), gap.mu, row.branches[k]
    if law is None:
        return lambda d, s: (branch.force(d, s), branch.gamma * s * s)
    force, lost = law.force, law.dissipated
    return lambda d, s: (force(mu, d, s), lost(mu, d, s))
