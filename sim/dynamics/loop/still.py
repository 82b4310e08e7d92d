"""Bodies that forces act on though nothing moves: held by static friction, or stuck to a wall.

Momentum is F Δt whether a body moves or not, and what holds it gives −F Δt back. No motion books
that, so it is booked here, each time that such a body is settled; work there is none.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

from sim.dynamics.result.ledger import Ledger
from sim.dynamics.state.body import Body, Still
from sim.dynamics.state.clock import Time, elapsed
from sim.dynamics.state.loads import Forces
from sim.effects.forces import FRICTION


def begin(bodies: Iterable[Body], now: Time, forces: Forces) -> None:
    """Note what acts from now on, on those of them that rest."""
    for body in bodies:
        if not body.carts:
            continue
        if body.mass == math.inf:
            found, by = forces.load(body.carts).forces, "walls"
        elif body.motion is None and body.v == 0.0:
            found, by = body.load.forces, FRICTION if body.held else ""
        else:
            continue
        if found:
            body.still = Still(now, found, by)


def book(body: Body, now: Time, ledger: Ledger) -> None:
    """N s by name since then, and as much back by what holds the body, if anything has to."""
    still = body.still
    assert still is not None
    time = elapsed(still.since, now)
    for one in still.forces:
        impulse = one.steady * time
        if impulse:
            ledger.push_from_outside(impulse, one.kind)
            if still.by:
                ledger.push_from_outside(-impulse, still.by)
    body.still = None
