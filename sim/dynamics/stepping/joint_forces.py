"""The forces that keep carts together in a stepped run, from what m a leaves over."""

from __future__ import annotations

from typing import Any, Protocol

from sim.dynamics.stepping.regrouped import at_wall

Rub = dict[tuple[str, int], float]
"""N of friction, by (kind, cart)."""

WALLS = "walls"
"""Their name in the account of momentum."""


class Joined(Protocol):
    """Carts of which some move as one body."""

    mass: list[float]
    bodies: list[list[int]]
    joined: set[int]
    held: set[int]


def joint_forces(row: Joined, total: list[Any], rub: Rub, a: list[Any]) -> dict[int, float]:
    """N in every joined gap; `total` [N] is all else that acts on each cart, `rub` the friction."""
    others = list(total)
    for (_, k), friction in rub.items():
        others[k] += friction
    found: dict[int, float] = {}
    for body in row.bodies:
        rest = [row.mass[k] * a[k] - others[k] for k in body]
        push = 0.0
        if body[0] == 0 and 0 in row.joined:  # held by the left wall: summed from the right
            for k, needed in zip(reversed(body), reversed(rest), strict=True):
                push += needed
                found[k] = push
        else:
            for k, needed in zip(body, rest, strict=True):
                push -= needed
                found[k + 1] = push
    return {gap: push for gap, push in found.items() if gap in row.joined}


def from_walls(row: Joined, total: list[Any]) -> Rub:
    """N on carts that stick to a wall: it takes up all else. Held bumpers tell theirs."""
    stuck = row.joined - row.held
    return {
        (WALLS, k): -total[k]
        for body in row.bodies
        if at_wall(body, stuck, len(row.mass))
        for k in body
    }
