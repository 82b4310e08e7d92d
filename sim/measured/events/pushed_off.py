"""Two hands that push two resting carts at one time are no explosion.

With a sensor at each end of the track no place tells whether the carts were together when both
began to move. The readings do: a motion sensor gives how far its cart is from it. Carts that an
explosion parts come closer to their sensors; carts that both go away from them meet.

Whatever the sensors count from: carts that part do not meet again unless one has turned round, and
what stops a cart does not let it go on. Where both set out from rest, and later push each other
with neither turned, one slowed and one still going its way, hands had pushed them first.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from sim.measured.events.contacts import COMPARABLE, NEAR, Contact
from sim.measured.events.outcome import AT_REST
from sim.measured.events.stretch import STILL

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from sim.measured.events.grid import Grid

    Bools = NDArray[np.bool_]

DISTANT = 0.1
"""m. No motion sensor reads less; what counts from the cart's own start begins with 0."""


def by_hands(grid: Grid, found: Sequence[Contact]) -> list[Contact]:
    """The candidates at which both carts set out from rest, away from their sensors or to meet."""
    import numpy as np

    distant = float(np.min(grid.x)) >= DISTANT
    return [
        one for k, one in enumerate(found)
        if (speeds := _set_out(grid, one))
        and ((distant and min(speeds) > 0.0) or any(_meet(grid, one, c) for c in found[k + 1:]))
    ]  # fmt: skip


def _set_out(grid: Grid, one: Contact) -> list[float] | None:
    """m/s. How fast each goes after it; None unless both had been at rest."""
    before, after = _beside(grid, one)
    still = all(abs(a) < STILL * abs(b) for a, b in zip(before, after, strict=True))
    return after if still else None


def _meet(grid: Grid, first: Contact, later: Contact) -> bool:
    """Whether two that set out at the first push each other at the later one."""
    meanwhile = (grid.t >= first.end) & (grid.t <= later.begin)
    if later.strength < COMPARABLE * first.strength or not meanwhile.any():
        return False
    if any(float(v[meanwhile].min()) * float(v[meanwhile].max()) <= 0.0 for v in grid.v):
        return False
    pairs = list(zip(*_beside(grid, later), strict=True))
    greatest = max(abs(v) for pair in pairs for v in pair)
    goes_on = any(min(a * b, b * b) > (AT_REST * greatest) ** 2 for a, b in pairs)
    return goes_on and any(abs(b) < abs(a) or a * b < 0.0 for a, b in pairs)


def _beside(grid: Grid, one: Contact) -> tuple[list[float], list[float]]:
    """m/s. Both velocities just before it and just after it."""
    before = (grid.t <= one.begin) & (grid.t >= one.begin - NEAR)
    after = (grid.t >= one.end) & (grid.t <= one.end + NEAR)
    before[0] = after[-1] = True  # at least one cell
    return _usual(grid, before), _usual(grid, after)


def _usual(grid: Grid, cells: Bools) -> list[float]:
    """m/s. Of each cart."""
    import numpy as np

    return [float(np.median(v[cells])) for v in grid.v]
