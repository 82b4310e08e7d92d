"""Whether two carts that seem to stick keep their distance afterwards.

A velocity at the contact is told at the end of a bent curve; the distance of both marks, once the
carts are clear of the contact, needs no curve: carts that stick keep it, whatever brakes them.

    x_B − x_A = distance + w τ ,   e = w/u ,   u the approach
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from sim.measured.events.brakes import Side
from sim.measured.events.correlated import inflation
from sim.measured.events.outcome import HALF, STUCK
from sim.measured.rounding import step_of

OPENS = 0.02
"""e that must lie below the whole interval of a parting: of 40 made pairs that stick none reaches
0.01, of weighed pairs on an air track none 0.001 (marks turn, tape gives way)."""

BENT = 4.0
"""Standard deviations from which the distance is said to grow along a curve."""


@dataclass(frozen=True, slots=True)
class Together:
    """m/s. How fast the distance grows after a contact, and its 95 % interval."""

    value: float
    low: float
    high: float

    def opens(self, approach: float) -> bool:
        """Whether they surely part."""
        return self.low > OPENS * approach

    def below(self, approach: float) -> float | None:
        """What e is below; None where that is as small as of carts that stick."""
        e = self.high / approach
        return e if e > STUCK else None


def together(sides: Sequence[Side], scale: float = 0.0) -> Together | None:
    """From the sides after the contact; None where too few instants are common to both. `scale`:
    m/s, by what the velocities of two sensors may differ though the carts go together."""
    import numpy as np

    (tau, a), other = sides[2], sides[3]
    kept = (tau >= other[0][0]) & (tau <= other[0][-1])
    if int(kept.sum()) < 4:
        return None
    tau = tau[kept] - float(np.mean(tau[kept]))
    gap = np.interp(tau + float(np.mean(sides[2][0][kept])), *other) - a[kept]
    found: list[tuple[float, float]] = []
    for degree in (1, 2):
        numbers = np.polyfit(tau, gap, degree)
        left = gap - np.polyval(numbers, tau)
        free = max(len(tau) - degree - 1, 1)
        noise = float(left @ left) / free * inflation([left])[1]
        basis = np.vander(tau, degree + 1)
        sd = np.sqrt(noise * np.diag(np.linalg.inv(basis.T @ basis)))
        found.append((float(numbers[-2]), float(sd[-2])))
    bend, unsure = float(numbers[0]), float(sd[0])
    rounded = math.hypot(*(step_of(x) for _, x in sides[2:])) / float(np.ptp(tau))
    value, half = found[0][0], math.hypot(HALF * found[0][1], rounded, scale)
    low, high = value - half, value + half
    if abs(bend) > BENT * unsure:  # they part sooner or later: at either end
        ends = [found[1][0] + 2.0 * bend * float(tau[k]) for k in (0, -1)]
        low, high = min(low, *ends), max(high, *ends)
    return Together(value, low, high)
