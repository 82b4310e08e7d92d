"""Carts that stick together meet others as one: a contact's damper is that of the bodies.

    N = k d + c d'        c = 2 ζ(e) sqrt(k μ)        μ = m₁ m₂/(m₁ + m₂) of all that sticks

A law that somebody wrote is asked as ever. Two that a pressed bumper keeps together (`held`) stay
two: nothing but its force joins them.
"""

from __future__ import annotations

import math

from sim.dynamics.stepping.pairs import Pair, reduced_mass
from sim.laws.lookup import contact_law


def regroup(pairs: list[Pair], mass: list[float], stuck: set[int]) -> None:
    """The forces of all contacts, when what sticks together has changed; `stuck`: gaps."""
    for pair in pairs:
        if pair.gap in stuck:
            continue
        mu = reduced_mass(_left(pair.left, mass, stuck), _right(pair.right, mass, stuck))
        if mu != pair.mu and mu < math.inf:
            pair.mu = mu
            if (law := contact_law(pair.contact)) is not None:
                pair.force = law.stepping(mu)


def _left(cart: int | None, mass: list[float], stuck: set[int]) -> float:
    """kg, of a cart and of what sticks to its left."""
    if cart is None:
        return math.inf
    return mass[cart] + (_left(cart - 1 if cart else None, mass, stuck) if cart in stuck else 0.0)


def _right(cart: int | None, mass: list[float], stuck: set[int]) -> float:
    """kg, of a cart and of what sticks to its right."""
    if cart is None:
        return math.inf
    beyond = cart + 1 if cart + 1 < len(mass) else None
    return mass[cart] + (_right(beyond, mass, stuck) if cart + 1 in stuck else 0.0)
