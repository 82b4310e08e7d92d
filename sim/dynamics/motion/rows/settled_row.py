"""All that acts on a settled row at the beginning of a step, in the order of its bodies."""

from __future__ import annotations

from sim.dynamics.motion import stick_slip
from sim.dynamics.motion.guards import push_now
from sim.dynamics.motion.power_series.series import SettledRow
from sim.dynamics.state.body import Body, Gap
from sim.laws.branch import Branch


def row_of(
    bodies: list[Body], gaps: list[Gap], branches: list[Branch], quadratic: list[float]
) -> SettledRow:
    """All that acts at the beginning of a step; `quadratic` is signed."""
    return SettledRow(
        inverse=[0.0 if body.held else 1.0 / body.mass for body in bodies],
        speeds=[body.v for body in bodies],
        overlaps=[-gap.room for gap in gaps],
        rates=[-gap.rate for gap in gaps],
        branches=branches,
        links=[gap.links for gap in gaps],
        steady=[_steady(i, bodies, gaps, branches) for i in range(len(bodies))],
        linear=[body.load.linear for body in bodies],
        quadratic=quadratic,
    )


def _steady(i: int, bodies: list[Body], gaps: list[Gap], branches: list[Branch]) -> float:
    """N on body i besides its neighbours and drag: constant in the step."""
    body = bodies[i]
    force = body.load.steady
    if body.load.kinetic and body.sliding:
        between = 0.0
        for k, sign in ((i - 1, 1.0), (i, -1.0)):
            if 0 <= k < len(gaps):
                between += sign * push_now(gaps[k], branches[k])
        force += stick_slip.friction(body, body.load.steady + between)
    return force
