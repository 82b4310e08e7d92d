"""Carts in a row, whose contacts share them: chosen, and random from a seed."""

from __future__ import annotations

import random


def row(velocities, *, gap=0.0, masses=None, law="paper", e=1, k=500, until=5, **track):
    """Plain values of carts in a row, the first one at 0.5 m."""
    masses = masses or [1] * len(velocities)
    carts = {
        f"C{n}": {"mass": m, "position": f"{0.5 + n * (0.2 + gap):.12g}", "velocity": v}
        for n, (m, v) in enumerate(zip(masses, velocities, strict=True))
    }
    contact = {"law": law, "restitution": e, "stiffness": k}
    return {"carts": carts, "contact": contact, "until": until, "track": track}


def scenes(count, seed):
    dice = random.Random(seed)
    for _ in range(count):
        n = dice.choice([3, 4])
        yield row(
            [f"{dice.uniform(-1.5, 1.5):.3f}" for _ in range(n)],
            gap=round(dice.uniform(0.005, 0.05), 3),
            masses=[f"{dice.uniform(0.2, 3):.2f}" for _ in range(n)],
            e=f"{dice.uniform(0.3, 1):.2f}",
            k=dice.choice([50, 300, 2000]),
            until=0.6,
            left="wall",
            right="wall",
            length=f"{0.5 + n * 0.25 + 0.05:.3f}",
        )
