"""Impulses of force sensors, and what the rounding of their readings leaves unknown."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence

from sim.measured.rounding import EVEN

QUIET = 0.1
"""Share of the greatest force below which a sensor counts as not pushed."""

Z = 1.96  # half a 95 % interval in standard deviations, for many readings


def _pushed(values: Sequence[float]) -> list[int]:
    top = max(map(abs, values))
    return [k for k, value in enumerate(values) if abs(value) > QUIET * top]


def rounded(a: Sequence[float], ratio: float, steps: tuple[float, float]) -> float:
    """Half of the ratio's interval that rounding leaves: each reading errs by its own, and the zero
    by the same in all that are pushed."""
    mean = sum(a) / len(a)
    square = sum((x - mean) ** 2 for x in a)
    alike = sum(a[k] - mean for k in _pushed(a)) / square
    sd = EVEN * math.hypot(steps[1], ratio * steps[0])
    return Z * sd * math.hypot(1.0 / math.sqrt(square), alike)


def widths(t: Sequence[float]) -> list[float]:
    """s. How long each reading stands for (trapezoids)."""
    steps = [0.0, *(b - a for a, b in itertools.pairwise(t)), 0.0]
    return [0.5 * (a + b) for a, b in itertools.pairwise(steps)]


def impulse(values: Sequence[float], widths: Sequence[float]) -> float:
    """N s."""
    return math.fsum(value * width for value, width in zip(values, widths, strict=True))


def impulse_sd(
    noise: float, widths: Sequence[float], values: Sequence[float], step: float
) -> float:
    """N s. Of the noise of each reading, and of a zero that is rounded to this step."""
    zero = EVEN * step * math.fsum(widths[k] for k in _pushed(values))
    return math.hypot(noise * math.sqrt(math.fsum(width * width for width in widths)), zero)
