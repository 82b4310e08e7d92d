"""The bare formula: what one isolated impact of two carts comes to. Nothing is stepped.

    V = (m1 v1 + m2 v2) / (m1 + m2)     v' = V + e (V − v)     u = v1 − v2

    law paper:   duration sqrt(pi² + ln² e) sqrt(mu/k)         mu = m1 m2 / (m1 + m2)

V is computed as the heavier cart's velocity plus a small change, and the rounding errors of u
and V are carried along, so that the outcome is off by at most 4e-16 of the larger of the speeds.
Written with V, a million elastic collisions keep their energy a hundred times better than with
the impulse (1 + e) mu u. This is the floor of the cost: all that a run does besides (events,
ledger, plan) is measured against it.
"""

from __future__ import annotations

import math


def outgoing(m1: float, m2: float, v1: float, v2: float, e: float) -> tuple[float, float]:
    """v1' and v2' [m/s] after an impact with restitution e; masses in kg."""
    u = v1 - v2
    part = v1 - u
    lost = (v1 - (u + part)) + (part - v2)  # what rounding took from u (two-sum)
    if m1 > m2:
        change = m2 * u / (m1 + m2)
        more = m2 * lost / (m1 + m2)
        centre = v1 - change
        part = centre - v1
        rest = (v1 - (centre - part)) - (change + part) - more
        return centre + (rest - e * (change + more)), centre + (rest + e * (u - change + lost))
    change = m1 * u / (m1 + m2)
    more = m1 * lost / (m1 + m2)
    centre = v2 + change
    part = centre - v2
    rest = (v2 - (centre - part)) + (change - part) + more
    return centre + (rest - e * (u - change + lost)), centre + (rest + e * (change + more))


def rebound(m1: float, m2: float, v1: float, v2: float, e: float) -> tuple[float, float]:
    """The same of two of which one may be a wall, or stick to one: infinite mass, at rest."""
    if m1 == math.inf:
        return 0.0, -e * v2
    if m2 == math.inf:
        return -e * v1, 0.0
    return outgoing(m1, m2, v1, v2, e)


def impact(
    m1: float, m2: float, v1: float, v2: float, e: float, k: float
) -> tuple[float, float, float]:
    """v1', v2' [m/s] and duration [s] of an impact under the law `paper`, for 0 < e <= 1."""
    a, b = outgoing(m1, m2, v1, v2, e)
    decrement = math.log(e)
    mu = m1 * m2 / (m1 + m2)
    return a, b, math.sqrt((math.pi * math.pi + decrement * decrement) * mu / k)
