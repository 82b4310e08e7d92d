"""How far numbers are from the truth, where they are numbers at all.

A run that blew up ends with NaN, which is greater than nothing: left to `max` it would count as no
error. It counts as an endless one.
"""

from __future__ import annotations

import math
from collections.abc import Iterable


def endless(value: float) -> float:
    """The same; infinity for what is no number."""
    return math.inf if math.isnan(value) else value


def far(got: Iterable[float], true: Iterable[float]) -> float:
    """The greatest difference of a cart."""
    return max(endless(float(abs(a - b))) for a, b in zip(got, true, strict=True))
