"""Impacts without a duration that come in rounds at one instant: some shrink, some have no end.

A round is the same gaps in the same order. Its relative speeds are a linear map of those of the
round before; whatever it begins with, the greatest eigenvalue remains (`collapse`).
"""

from __future__ import annotations

import math
from collections import defaultdict
from dataclasses import dataclass, field

from sim.dynamics.state.body import Gap
from sim.dynamics.state.clock import NEVER, Time, elapsed

LONGEST_ROUND = 60
"""Impacts. Of six bodies that collapse most rounds have a dozen."""

LONGEST_OF_COLLAPSES = 500
"""The same of a round in which some collapse: a heavy one presses light ones to a wall."""

COLLAPSE = 0x10FFFF
"""Stands among the gaps that were hit for a collapse of some of them: no gap has this number."""

ROUNDS = 4
"""That are compared: the same gaps in the same order."""

SAME_RATIO = 1e-7
"""Relative. What is left of all but the greatest eigenvalue; it fades from round to round."""

REST_COMES = 1.2 * math.log(1e-12)
"""Over ln e: blows in one gap after which a ball would have come to rest by itself, see `impacts`,
and a fifth more. Whatever still hops then does so by rounding."""

SELDOM = 16
"""Impacts at one instant between two looks for rounds. For rounds with collapses it is also the
part of those so far that must have come since: a look costs as much as the round is long."""

ENDLESS = 1000
"""Impacts at one instant. Rounds that then come again with the same speeds to the last bit, as of a
cart without room between two walls that take nothing, have no end and no limit."""


@dataclass(slots=True)
class Hits:
    """Impacts without a duration at one instant: in which gap, and how fast [m/s]."""

    time: Time = NEVER
    gaps: list[int] = field(default_factory=list)
    speeds: list[float] = field(default_factory=list)
    begun: int = 0  # of them, before those that came since the last collapse
    looked: int = 0  # of them, when rounds were looked for
    looked_far: int = 0  # of them, when rounds with collapses were looked for
    blows: defaultdict[int, int] = field(default_factory=lambda: defaultdict(int))
    """In the whole run, by gap."""
    endless: bool = False  # the same round for ever

    def often(self, gap: Gap) -> bool:
        """One blow more in this gap: are there so many that rounding may have the say?"""
        self.blows[gap.index] += 1
        e = gap.contact.restitution or 0.0
        return e < 1.0 and (e == 0.0 or self.blows[gap.index] > REST_COMES / math.log(e))

    def note(self, gap: Gap, now: Time, instant: float) -> None:
        """Another one; those of an earlier instant are forgotten."""
        if elapsed(self.time, now) > instant:
            self.forget()
        self.time = now
        self.gaps.append(gap.index)
        self.speeds.append(-gap.rate)

    def forget(self) -> None:
        """What comes next is no round of these."""
        self.gaps.clear()
        self.speeds.clear()
        self.begun = self.looked = self.looked_far = 0

    def collapse(self) -> None:
        """The rounds that were found end here. They may themselves be a part of longer ones."""
        self.gaps.append(COLLAPSE)
        self.speeds.append(self.speeds[-1])
        self.begun = self.looked = len(self.gaps)

    def rounds(self) -> tuple[int, int] | None:
        """First and last gap of those that are hit in rounds for ever; None where none are."""
        count = len(self.gaps)
        if count < self.looked + SELDOM:
            return None
        self.looked = count
        if (p := self._round(count - self.begun, LONGEST_ROUND)) is None:
            if not self.begun or count < self.looked_far * (1 + 1 / SELDOM):
                return None
            self.looked_far = count
            if (p := self._round(count, LONGEST_OF_COLLAPSES)) is None:
                return None
        hit = [one for one in self.gaps[-p:] if one != COLLAPSE]
        return min(hit), max(hit)

    def _round(self, count: int, longest: int) -> int | None:
        """Impacts of the shortest round that the last `count` ones end with, and that shrinks."""
        count = min(count, ROUNDS * longest)
        tail = "".join(map(chr, self.gaps[-count:]))
        for p in range(2, count // ROUNDS + 1):
            if tail[-ROUNDS * p : -p] == tail[-(ROUNDS - 1) * p :]:
                if self._shrink(p):
                    return p
                own = self.speeds[-ROUNDS * p :]
                if len(self.gaps) > ENDLESS and own == own[-p:] * ROUNDS:
                    self.endless = True  # whatever longer rounds were before these
        return None

    def _shrink(self, p: int) -> bool:
        now, before, earlier = (
            self.speeds[len(self.speeds) - (k + 1) * p : len(self.speeds) - k * p] for k in range(3)
        )
        if min(before) <= 0.0 or min(earlier) <= 0.0:
            return False
        q = now[0] / before[0]
        ratios = [
            a / b for a, b in (*zip(now, before, strict=True), *zip(before, earlier, strict=True))
        ]
        return q < 1.0 - SAME_RATIO and all(abs(one - q) <= SAME_RATIO * q for one in ratios)
