"""Two hands that push two resting carts at one time are no explosion.

With a sensor at each end of the track no place tells whether the carts were together when both
began to move. The readings do: a motion sensor gives how far its cart is from it. Carts that an
explosion parts come closer to their sensors; carts that both go away from them meet.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from sim.measured.events.contacts import NEAR, Contact
from sim.measured.events.stretch import STILL

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from sim.measured.events.grid import Grid

    Bools = NDArray[np.bool_]

DISTANT = 0.1
"""m. No motion sensor reads less; what counts from the cart's own start begins with 0."""


def by_hands(grid: Grid, found: Sequence[Contact]) -> list[Contact]:
    """The candidates at which both carts set out from rest, away from their sensors."""
    import numpy as np

    if float(np.min(grid.x)) < DISTANT:
        return []
    return [one for one in found if _set_out(grid, one)]


def _set_out(grid: Grid, one: Contact) -> bool:
    before = (grid.t <= one.begin) & (grid.t >= one.begin - NEAR)
    after = (grid.t >= one.end) & (grid.t <= one.end + NEAR)
    before[0] = after[-1] = True  # at least one cell
    pairs = zip(_usual(grid, before), _usual(grid, after), strict=True)
    return all(abs(first) < STILL * last for first, last in pairs)


def _usual(grid: Grid, cells: Bools) -> list[float]:
    """m/s. Of each cart."""
    import numpy as np

    return [float(np.median(v[cells])) for v in grid.v]
