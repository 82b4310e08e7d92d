"""The calendar of a run: one prediction per gap and per body, and what comes from outside.

A prediction that an event has overtaken is void: its `turn` is no longer that of its gap or body,
and it is skipped when its time comes. Adding one costs log N.
"""

from __future__ import annotations

import heapq
import math

from sim.dynamics.state.body import Body, Gap
from sim.dynamics.state.clock import UNSEEN, Time, later


class Calendar:
    """Entries are (hi, lo, key, turn), the time being hi + lo.

    key: −1 − k for a body whose first cart is k; a gap's index, of a touch; from `moved` on that of
    a gap whose motion ends, so that at one instant all touches come before; from `outside` on, what
    comes from outside.
    """

    def __init__(self, gaps: int) -> None:
        self.entries: list[tuple[float, float, int, int]] = []
        self._turns = 0
        self.moved, self.outside = gaps, 2 * gaps

    def gap(self, gap: Gap, now: Time, dt: float) -> None:
        """The gap's next event is in dt s; inf: there is none in sight."""
        gap.turn += 1
        if dt != math.inf and not gap.joined:
            gap.due = hi, lo = later(now, dt)
            key = gap.index if gap.solver is None else gap.index + self.moved
            heapq.heappush(self.entries, (hi, lo, key, gap.turn))
        else:
            gap.due = UNSEEN

    def unforeseen(self, gap: Gap) -> None:
        """Nothing is foreseen for the gap, nor what was."""
        gap.turn += 1
        gap.due = UNSEEN

    def body(self, body: Body, now: Time, dt: float) -> None:
        """The body's own motion ends in dt s."""
        self.void(body)
        if dt != math.inf:
            hi, lo = later(now, dt)
            heapq.heappush(self.entries, (hi, lo, -1 - body.carts[0], body.turn))

    def void(self, body: Body) -> None:
        """What was predicted for the body's own motion no longer holds.

        Turns of bodies are counted together: one that splits off may get a key that another had.
        """
        self._turns += 1
        body.turn = self._turns

    def from_outside(self, number: int, t: float) -> None:
        """Burst or switch `number` happens at t s."""
        heapq.heappush(self.entries, (t, 0.0, self.outside + number, 0))
