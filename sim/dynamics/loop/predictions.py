"""What is foreseen: when each gap closes, asked anew around everything that changes."""

from __future__ import annotations

from dataclasses import dataclass

from sim.dynamics.loop.calendar import Calendar
from sim.dynamics.loop.detect import next_touch, touch_in_motion
from sim.dynamics.state.body import Body, Gap
from sim.dynamics.state.chain import Chain, velocity
from sim.dynamics.state.clock import Time


@dataclass(frozen=True, slots=True)
class Predictions:
    """Entries of the calendar for the gaps of a row, up to the end of the run."""

    chain: Chain
    calendar: Calendar
    end: Time

    def gap(self, gap: Gap, now: Time, own_separation: bool = False) -> None:
        """When does this gap close? The gap is up to date."""
        if gap.left.motion is None and gap.right.motion is None:
            self.calendar.gap(gap, now, next_touch(gap, own_separation))
        else:
            self.calendar.gap(gap, now, touch_in_motion(gap, now, self.end, own_separation))

    def bring_around(self, gap: Gap, now: Time) -> None:
        """Bring the neighbouring gaps up to date before the bodies of `gap` change."""
        for other in self.chain.neighbours(gap):
            if other is not None and other.solver is None:
                self.chain.advance(other, now)

    def around(self, gap: Gap, now: Time) -> None:
        """The bodies of `gap` have changed: their other neighbours may touch at another time."""
        for other in self.chain.neighbours(gap):
            if other is None or other.solver is not None:
                continue
            left, right = other.left, other.right
            if left.motion is None and right.motion is None:
                other.rate = right.v - left.v
                self.calendar.gap(other, now, next_touch(other))
            else:
                other.rate = velocity(right, now) - velocity(left, now)
                self.gap(other, now)

    def members(self, bodies: list[Body], gaps: list[Gap], now: Time) -> None:
        """Void what was predicted for member gaps; predict every free gap of these bodies."""
        found: dict[int, Gap] = {}
        for body in bodies:
            for index in (body.left, body.right):
                other = self.chain.gaps[index]
                if other is not None:
                    found[index] = other
        for gap in found.values():
            solver = gap.solver
            if solver is not None and gap is not solver.members[0]:
                gap.turn += 1  # the group's events stand under its first gap
            elif solver is None and not gap.joined:
                mine = gap in gaps
                if not mine:
                    gap.rate = velocity(gap.right, now) - velocity(gap.left, now)
                self.gap(gap, now, own_separation=mine)
