"""Steps that cannot jump over a zero.

A quantity g > 0 that changes at the rate g', with |g''| <= A, cannot be zero before

    h = 2 g / (−g' + sqrt(g'² + 2 A g))       because g(t + h) >= g + g' h − A h²/2

Repeated, these steps close in on the first zero and on no later one. Where it is crossed with speed
they become Newton's steps and converge quadratically; a near miss only costs more of them.
"""

from __future__ import annotations

import math

SAFE_STEPS = 400
"""Steps of the guarded search. Ten do for a crossing; only a near miss takes more, and ends."""

SLACK = 1.0 + 1e-9
"""Relative. A bound on the second derivative is itself computed: a little more keeps it one."""


def safe_step(here: float, rate: float, bound: float) -> float:
    """Longest time in which `here` >= 0, changing at `rate`, cannot fall below zero.

    `bound` is one on its second derivative. inf where it never can.
    """
    root = math.sqrt(rate * rate + 2.0 * bound * here)
    if rate > 0.0:
        return (rate + root) / bound if bound > 0.0 else math.inf
    return 2.0 * here / (root - rate) if root > rate else math.inf
