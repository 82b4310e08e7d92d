"""What of a row's motion is rounding: velocities that no longer fit its rates, drag that is faint.

A row is told twice, by the velocities of its bodies and by the rates of its gaps. Both are exact to
rounding of what they were when they were greatest; while a row fades, that of the rates fades with
them, for each is a series of its own. What is left of the velocities, w = v_right − v_left − rate,
does not: it is a constant of the equations. Drag of it, b w, would hold a spring strained by b w/k
for ever, and such a row has neither modes nor rest.

A row at the very edge of its contacts, which no load presses, has no place of rest beside which
what is left would be small: it fades for ever, and touches and parts on the way. But once no
velocity and no acceleration takes a body anywhere in all the run, the row is over.

Drag of v² beside linear drag, b v + c v², is linear where c v is less than the last bit of b; and
where it takes less than the last bit of the momentum m v in all the time that is left.
"""

from __future__ import annotations

import itertools
import math

from sim.dynamics.motion.guards import branch_of, push_now
from sim.dynamics.motion.power_series.step import Step
from sim.dynamics.state.body import Body, Gap

MISFIT = 1e-3
"""Of the greatest velocity in a row. Rounding of its present velocities is a trillionth of that."""

FAINT = 2.0**-53
"""Half the last bit of 1: what is less beside a number is not seen in their sum."""


def told_by_rates(bodies: list[Body], gaps: list[Gap]) -> None:
    """Velocities that are little else than rounding of greater ones follow from the rates.

    The row keeps its momentum; beside what stands fast it has none. A body that friction has just
    stopped stands, whatever rounding left of the rates: they would set it going, to stop again.
    """
    misfit = max((abs(g.right.v - g.left.v - g.rate) for g in gaps), default=0.0)
    if misfit <= MISFIT * max(abs(body.v) for body in bodies):
        return
    relative = [0.0, *itertools.accumulate(gap.rate for gap in gaps)]
    fixed = [i for i, body in enumerate(bodies) if body.mass == math.inf or _stands(body)]
    if fixed:
        whole = -relative[fixed[0]]
    else:
        own = [b.mass * (b.v - r) for b, r in zip(bodies, relative, strict=True)]
        whole = math.fsum(own) / math.fsum(body.mass for body in bodies)
    for i, (body, r) in enumerate(zip(bodies, relative, strict=True)):
        body.v = 0.0 if i in fixed else whole + r


def _stands(body: Body) -> bool:
    return body.held or (body.v == 0.0 and body.load.static > 0.0)


def is_faint(bodies: list[Body], fastest: list[float], time: float) -> bool:
    """Does drag of v² do less than rounding, up to these speeds [m/s] and for so long [s]?

    c v² <= FAINT b v at every instant, or c v² t <= FAINT m v in all the time.
    """
    return all(
        body.load.quadratic * v * time <= FAINT * (body.load.linear * time + body.mass)
        for body, v in zip(bodies, fastest, strict=True)
        if body.load.quadratic
    )


def nothing_left(bodies: list[Body], gaps: list[Gap], limit: float, nothing: float) -> Step | None:
    """The row that stays as it is for `limit` s, as one step; None where it still moves.

    `nothing` [m/s]: slower than that it gets nowhere in the run. No faster may its forces make it.
    """
    if any(abs(gap.rate) > nothing for gap in gaps) or any(abs(b.v) > nothing for b in bodies):
        return None
    branches = [branch_of(gap) for gap in gaps]
    if any(branch.locked for branch in branches) or any(body.load.grips for body in bodies):
        return None
    push = [push_now(gap, branch) for gap, branch in zip(gaps, branches, strict=True)]
    for body, left, right in zip(bodies, [0.0, *push], [*push, 0.0], strict=True):
        if (abs(left) + abs(right) + abs(body.load.steady)) * limit > body.mass * nothing:
            return None
    for body in bodies:
        body.v = 0.0
    across = [math.fsum(link.force(gap.room, 0.0) for link in gap.links) for gap in gaps]
    return Step(
        bodies, gaps, branches, limit, [[-gap.room, 0.0] for gap in gaps],
        [[n - p] for n, p in zip(push, across, strict=True)],
        [[p] if gap.links else [] for gap, p in zip(gaps, across, strict=True)],
        [[0.0, 0.0] for _ in bodies], [[0.0, 0.0, 0.0] for _ in bodies],
        [body.load.steady for body in bodies], short=False,
    )  # fmt: skip
