"""Whether two carts that seem to stick keep their distance afterwards.

A velocity at the contact is told at the end of a bent curve; the distance of both marks, once the
carts are clear of the contact, needs no curve: carts that stick keep it, whatever brakes them.

    x_B − x_A = distance + w τ ,   e = w/u ,   u the approach

A sensor may lose its cart there. Whoever saw that they stayed together may say so: then one
velocity after the contact is that of both.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

from sim.measured.events.brakes import Side, solved
from sim.measured.events.outcome import HALF, STUCK
from sim.measured.events.sides import FEWEST, Speeds

OPENS = 0.02
"""e that must lie below the whole interval of a parting: of 40 made pairs that stick none reaches
0.01, of weighed pairs on an air track none 0.001 (marks turn, tape gives way)."""


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

    (tau, a), (other, b) = sides[2:]
    kept = (tau >= other[0]) & (tau <= other[-1])
    if int(kept.sum()) < FEWEST:
        return None
    gap = tau[kept], np.interp(tau[kept], other, b) - a[kept]
    numbers, covariance, _ = solved([gap, gap], "nothing")
    half = math.hypot(HALF * float(covariance[1, 1]) ** 0.5, scale)
    return Together(float(numbers[1]), float(numbers[1]) - half, float(numbers[1]) + half)


def seen_by_one(speeds: Speeds, lost: int) -> Speeds:
    """The velocities of carts that stayed together, where the sensor of the one `lost` it."""
    import numpy as np

    of_both = np.eye(4)
    of_both[lost + 2] = of_both[3 - lost]
    v, rows = of_both @ speeds.v, of_both @ np.array(speeds.covariance) @ of_both.T
    covariance = tuple(tuple(map(float, row)) for row in rows)
    return replace(speeds, v=tuple(map(float, v)), covariance=covariance)  # type: ignore[arg-type]
