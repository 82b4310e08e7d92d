"""Readings of a free cart that smoothing took for its contact.

A contact is looked for in velocities that are means over a few readings, so it seems to begin that
much too early and to end too late. Of a device that reads 20 times a second this can be all that a
cart had between a hand and the contact. Where too few readings of a side are left, those towards
the contact are taken as long as each lies where the straight line through the others leads:

    var(x − line) = s² (1 + 1/n + τ² / Σ τ_k²) ,   τ from the middle of the n others
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from sim.measured.rounding import EVEN, step_of
from sim.measured.scatter import noise_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Kept = NDArray[np.bool_]

LEAST = 3
"""Readings that tell a line, and by which one sees that it is one."""

OFF = 4.0
"""Standard deviations. What lies farther off is pushed."""

SMOOTHED = 1 / 6
"""Of a contact's span, at most, from each side: the rest is no smoothing."""


def nearer(t: Floats, x: Floats, kept: Kept, span: tuple[float, float], *, after: bool) -> Kept:
    """`kept` readings of one side, with those towards the contact that the same line tells.

    `span`: from and until in s of the contact as it seems.
    """
    import numpy as np

    found = kept.copy()
    own = np.flatnonzero(kept)
    if len(own) < LEAST:
        return found
    noise = max(noise_of(x), EVEN * step_of(x))
    begin, end = span
    reach = SMOOTHED * (end - begin)
    towards = range(own[0] - 1, -1, -1) if after else range(own[-1] + 1, len(t))
    for k in towards:
        into = end - t[k] if after else t[k] - begin
        if into > reach or not _on_line(t[found], x[found], t[k], x[k], noise):
            break
        found[k] = True
    return found


def _on_line(t: Floats, x: Floats, at: float, place: float, noise: float) -> bool:
    tau = t - t.mean()
    squares = float(tau @ tau)
    slope = float(tau @ x) / squares
    away = at - float(t.mean())
    sd = noise * math.sqrt(1.0 + 1.0 / len(t) + away * away / squares)
    return abs(place - float(x.mean()) - slope * away) <= OFF * sd
