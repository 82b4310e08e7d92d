"""Integrals of the square and the cube of a polynomial: what drag of v² takes in a step.

Multiplied out, the cube has three times the order of the series: two thousand products. Gauss and
Legendre's rule with n nodes is exact up to order 2n − 1 and, for the sine of a whole step (REACH of
`series`: its cube swings through 6), good to (6/2)^2n/(2n)!, which is 1e-17 for n = 14. Where the
series converges only within a radius, a step is CONVERGED of it: the error falls as 18^−2n. All
terms are positive where the speed keeps its sign: the sum is good to its last bits.
"""

from __future__ import annotations

import math
from functools import cache

from sim.dynamics.motion.power_series.polynomial import Poly, value

NODES = 14

NEWTON = 8
"""Steps to a zero of Legendre's polynomial: three double the figures that the guess has."""


@cache
def nodes() -> tuple[tuple[float, float], ...]:
    """Places in (0, 1) and their weights, which add up to 1."""
    found = []
    for k in range(NODES):
        x = -math.cos(math.pi * (k + 0.75) / (NODES + 0.5))
        for _ in range(NEWTON):
            before, here = 1.0, x
            for n in range(2, NODES + 1):
                before, here = here, ((2 * n - 1) * x * here - (n - 1) * before) / n
            slope = NODES * (x * here - before) / (x * x - 1.0)
            x -= here / slope
        found.append((0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope)))
    return tuple(found)


def square_and_cube(p: Poly, h: float) -> tuple[float, float]:
    """Integrals of p² and of p³ over [0, h]."""
    squares, cubes = [], []
    for place, weight in nodes():
        v = value(p, place * h)
        squares.append(weight * v * v)
        cubes.append(squares[-1] * v)
    return h * math.fsum(squares), h * math.fsum(cubes)
