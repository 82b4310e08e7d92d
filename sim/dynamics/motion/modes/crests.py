"""When is a quantity of a row that swings (`started`) greatest?

Modes beat: of several crests in one phase a later one may be the highest. The search goes by steps
in which the quantity, by a bound on its second derivative, cannot come above the highest value so
far; where it is about to, it looks for the crest, and goes on from there.
"""

from __future__ import annotations

import math
from operator import mul

from sim.dynamics.motion.modes.falls import UndecidedError, look, searched, slow
from sim.dynamics.motion.modes.started import Started, Swinging
from sim.dynamics.motion.safe_step import safe_step

AS_GREAT = 1e-13
"""Relative. A later crest that is higher by no more is the same: the first is told."""

NOTHING_WITHIN = 0.01
"""Radians of the fastest mode. Two crests are not so close."""

LOOKS = 3000
"""A phase has some tens of radians: two looks or so at each."""


def greatest(q: Started, growth: Started, swings: Swinging, h: float, pace: float) -> float:
    """s. When q is greatest in [0, h], the first of equal ones; `growth` is q', `pace` in 1/s."""
    poly, fast = slow(q, swings, h, 1.0, 0.0)
    best, when = q.first, 0.0
    end, _ = look(poly, fast, h)
    if end > best:
        best, when = end, h
    bends = [
        (size * own, z.real)
        for size, own, z in zip(swings.sizes, q.shape.size, swings.rates, strict=True)
    ]
    here, rate, t, least = q.first, q.slope, 0.0, NOTHING_WITHIN / pace
    for _ in range(LOOKS):
        bound = math.fsum([size * math.exp(decay * t) for size, decay in bends])
        step = safe_step(max(best - here, 0.0) + AS_GREAT * abs(best), -rate, bound)
        if step < least and rate > 0.0:
            top = _crest(growth, swings, h, t)
            if top is None:
                break  # it grows on to the end
            if (found := look(poly, fast, top)[0]) > best + AS_GREAT * abs(best):
                best, when = found, top
            t = top
        t += max(step, least)
        if t >= h:
            break
        here, rate = look(poly, fast, t)
    return when


def _crest(growth: Started, swings: Swinging, h: float, t: float) -> float | None:
    """s. Where the growth, positive at t, falls to zero; None: not up to h."""
    try:
        turns = sum(map(mul, swings.sizes, growth.shape.size))
        return searched(growth, swings, h, 1.0, 0.0, t, turns)
    except UndecidedError:
        return t  # it is flat for long: any place there is as high
