"""Do both carts change their velocity in step?

If nothing but the other cart pushes, m_A a_A = −m_B a_B at every instant: each velocity's share of
its whole change, n = (v − v before)/(v after − v before), is the same curve for both. That needs no
mass, no sign and no zero. A hand, an end stop or a sensor that loses its cart shows as a lag.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from sim.measured.events.grid import Grid

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

JUDGED, FEWEST = 40, 8
"""Cells before the contact that the noise is judged by, at most and at least."""


@dataclass(frozen=True, slots=True)
class StepMatch:
    """`lag`: s, how much later the first cart changes; `apart`: root mean square of n_A − n_B,
    `surely`: the same beyond the noise of both; `cells`: how many cells of the grid tell it.
    `unsure`: s, standard deviation of the lag by the noise of the velocities before and after."""

    lag: float
    unsure: float
    apart: float
    surely: float
    cells: int


def in_step(grid: Grid, begin: float, end: float) -> StepMatch:
    """Both curves compared between two times."""
    import numpy as np

    last = len(grid.t) - 1
    low = max(int(np.searchsorted(grid.t, begin - 1e-9)) - 1, 0)
    high = min(int(np.searchsorted(grid.t, end - 1e-9)) + 1, last)
    shares, noise = [], 0.0
    for v in grid.v:
        change = float(v[high] - v[low]) or 1e-12
        shares.append((v[low : high + 1] - v[low]) / change)
        noise += (_noise(v[max(0, low - JUDGED) : low]) / change) ** 2
    left = shares[0] - shares[1]
    lag = -float(np.sum(left)) * grid.step
    apart = float(np.mean(left**2))
    # Half of the time the share is told by the velocity before, half of it by that after.
    unsure = (high - low) * grid.step * (noise / 2.0) ** 0.5
    return StepMatch(lag, unsure, apart**0.5, max(apart - noise, 0.0) ** 0.5, high - low + 1)


def _noise(v: Floats) -> float:
    """m/s. What a straight line leaves of the velocities before; 0 where they are too few."""
    import numpy as np

    if len(v) < FEWEST:
        return 0.0
    k = np.arange(len(v))
    return float(np.std(v - np.polyval(np.polyfit(k, v, 1), k)))
