"""Marks of random classes, and how near a statistic of them must be to its oracle."""

from __future__ import annotations

import random

CLASSES = 1_000
NEAR = 1e-12


def classes() -> list[tuple[list[float], list[float]]]:
    """Marks before and after of random classes; some easy, some hard, many ties."""
    dice = random.Random(7)
    made = []
    for _ in range(CLASSES):
        of, n = dice.randint(2, 15), dice.randint(5, 60)
        before = [float(sum(dice.random() < 0.4 for _ in range(of))) for _ in range(n)]
        after = [float(min(of, max(0, b + dice.randint(-2, 3)))) for b in before]
        made.append((before, after))
    return made


RANDOM = classes()


def same(mine: float, theirs: float) -> bool:
    """Equal to 1e-12 of the number, or of 1 where it is smaller."""
    return abs(mine - theirs) <= NEAR * max(1.0, abs(theirs))
