"""What one more right digit costs: one number for a method, out of its measured rows.

The error of a method of order p falls as the step to the power p, so a digit more takes 10^(1/p)
times as many steps. What a method really pays is measured: the line through its rows in the figure,
log time against log error, by least squares. Rows that are wrong altogether, or that are as right
as doubles can be, say nothing about it and are left out.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

NEAR, FAR = 1e-13, 0.3
"""Of the scene's greatest speed, or way: between them an error is one that a step decides about."""

Measured = tuple[str, float, float | None]
"""Method, time as a ratio, error of v [m/s] or of x [m]."""


def one_more_digit(rows: Iterable[Measured], whole: float) -> dict[str, float]:
    """Times the time for ten times less error, by method; `whole`: what NEAR and FAR are parts of.

    A method with fewer than two rows that count is left out, and one that does not get better.
    """
    by_method: dict[str, list[tuple[float, float]]] = {}
    for method, time, error in rows:
        if error is not None and NEAR * whole < error < FAR * whole:
            by_method.setdefault(method, []).append((-math.log10(error), math.log10(time)))
    found = {method: _slope(points) for method, points in by_method.items() if len(points) > 1}
    return {method: 10.0**slope for method, slope in found.items() if 0.0 < slope < math.inf}


def _slope(points: list[tuple[float, float]]) -> float:
    """Decades of time for a digit."""
    n = len(points)
    digits, times = math.fsum(d for d, _ in points) / n, math.fsum(t for _, t in points) / n
    spread = math.fsum((d - digits) ** 2 for d, _ in points)
    if spread == 0.0:
        return math.inf
    return math.fsum((d - digits) * (t - times) for d, t in points) / spread
