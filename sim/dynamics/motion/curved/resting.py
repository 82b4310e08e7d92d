"""A row with contacts of spheres at rest: by the tangents of their forces where they are.

Near its place of rest a curved force N(o) is its tangent, N'(o) (o − o0), and what is left of that
is of the second order in a way that is itself rounding (`rest.QUIET`). So statics answers for it as
for a spring: a damped row comes to rest as e^(−t), and takes no steps from then on.
"""

from __future__ import annotations

import math

from sim.dynamics.motion.curved_field import curved
from sim.dynamics.motion.power_series.series import REACH, step_length
from sim.dynamics.motion.power_series.step import Step
from sim.dynamics.motion.rest import at_rest
from sim.dynamics.motion.rows.settled_row import row_of
from sim.dynamics.state.body import Body, Gap
from sim.laws.branch import Branch

LOOK_CLOSER = 1e-9
"""Of the speed at which the deepest overlap would swing. Slower rows may be at rest."""


def resting_step(
    bodies: list[Body], gaps: list[Gap], branches: list[Branch], limit: float
) -> Step | None:
    """The step of a row at rest; None where it is not."""
    if any(gap.touching is None and not gap.links for gap in gaps):
        return None
    if any(gap.room >= 0.0 for gap in gaps if curved(gap) is not None):
        return None  # without overlap the tangent is flat
    tangents = [tangent(gap, branch) for gap, branch in zip(gaps, branches, strict=True)]
    stiffest = max(branch.kappa / gap.mu for gap, branch in zip(gaps, tangents, strict=True))
    deepest = max(abs(gap.room) for gap in gaps)
    slow = LOOK_CLOSER * math.sqrt(stiffest) * deepest
    if any(abs(gap.rate) > slow for gap in gaps):
        return None
    length = step_length(row_of(bodies, gaps, tangents, [0.0] * len(bodies)))
    return at_rest(bodies, gaps, tangents, REACH / length, limit)


def tangent(gap: Gap, branch: Branch) -> Branch:
    """Of a contact of spheres: N'(o) by the power of its law, with the damping just now."""
    if (law := curved(gap)) is None:
        return branch
    over, power = -gap.room, law.grows[0] - 1.0  # the energy goes with one power more
    force = law.force(gap.mu, over, 0.0)
    kappa = power * force / over
    return Branch(kappa, law.force(gap.mu, over, 1.0) - force, over - over / power)
