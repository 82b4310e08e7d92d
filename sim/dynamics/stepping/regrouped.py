"""Carts that stick together meet others as one: a contact's damper is that of the bodies.

    N = k d + c d'        c = 2 ζ(e) sqrt(k μ)        μ = m₁ m₂/(m₁ + m₂) of all that sticks

A law that somebody wrote is asked as ever. Two that a pressed bumper keeps together (`held`) stay
two: nothing but its force joins them.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from sim.dynamics.stepping.pairs import Pair
from sim.laws.contact_law import reduced_mass
from sim.laws.lookup import contact_law


def regroup(pairs: list[Pair], mass: list[float], stuck: set[int]) -> None:
    """The forces of all contacts, when what sticks together has changed; `stuck`: gaps."""
    behind = {
        k: math.inf if at_wall(body, stuck, len(mass)) else sum(mass[i] for i in body)
        for body in bodies_of(len(mass), stuck)
        for k in body
    }
    for pair in pairs:
        if pair.gap in stuck:
            continue
        sides = (math.inf if k is None else behind[k] for k in (pair.left, pair.right))
        mu = reduced_mass(*sides)
        if mu != pair.mu and mu < math.inf:
            pair.mu = mu
            if (law := contact_law(pair.contact)) is not None:
                pair.force = law.stepping(mu)


def bodies_of(count: int, joined: set[int]) -> list[list[int]]:
    """The carts of each body, from left to right; the bodies of `joined` gaps are one."""
    bodies = [[0]]
    for k in range(1, count):
        if k in joined:
            bodies[-1].append(k)
        else:
            bodies.append([k])
    return bodies


def at_wall(body: Sequence[int], joined: set[int], count: int) -> bool:
    """Is a body joined to a wall?"""
    return (0 in joined and body[0] == 0) or (count in joined and body[-1] == count - 1)
