"""What each cart is braked by evenly: long pieces of its motion that are parabolas.

Friction brakes both carts at one time, as a contact does; it is told apart by being even and long.
"""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING

from sim.measured.events.change_points import change_points
from sim.measured.events.grid import Grid, coarse

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

LONG = 0.4
"""s. A push of bumpers is no even parabola for so long; magnets that push for half a second are
several."""


def braked(grid: Grid) -> Floats:
    """m/s². Of each cart (rows) in each cell, what friction gives where it brakes both; else 0."""
    import numpy as np

    x, wide = coarse(grid)
    found = np.zeros_like(grid.a)
    for cart in (0, 1):
        edges = [min(k * wide, len(grid.t)) for k in change_points(x[cart], grid.rounded[cart])]
        for low, high in itertools.pairwise(edges):
            if grid.step * (high - low) < LONG or high - low < 4:
                continue
            tau = grid.t[low:high] - grid.t[low]
            bend, slope, _ = np.polyfit(tau, grid.x[cart, low:high], 2)
            if bend * (slope + bend * tau[-1]) < 0.0:  # slower, not faster, at the middle
                found[cart, low:high] = 2.0 * bend
    return np.where(np.all(found != 0.0, axis=0), found, 0.0)
