"""Where a polynomial has its crest, from its slope.

In a step of a series there is one at most; but what falls at both ends may have risen in between,
and what rises at both may have been higher before. Most have not: where the slope at the two ends
exceeds what the bound on its own slope can make of it, nothing more is looked at.
"""

from __future__ import annotations

from sim.dynamics.motion.power_series.polynomial import Poly, first_fall, shifted, size, slope


def crest(growth: Poly, h: float, last: float) -> float | None:
    """Where the slope `growth`, which is `last` at h, falls through zero in (0, h); else None."""
    if last >= 0.0:
        if growth[0] > 0.0 and growth[0] + last < h * size(slope(growth), h):
            return first_fall(growth, h)
        return None
    top = first_fall(growth, h)
    if top != 0.0 or growth[0] + last + h * size(slope(growth), h) <= 0.0:
        return top or None
    low = first_fall([-c for c in growth], h)  # it falls first: does it rise again?
    if not low:
        return None
    risen = shifted(growth, low)
    risen[0] = 0.0  # but for rounding
    top = first_fall(risen, h - low)
    return low + top if top else None
