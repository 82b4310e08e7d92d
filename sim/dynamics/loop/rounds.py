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

ROUNDS = 4
"""That are compared: the same gaps in the same order."""

SAME_RATIO = 1e-7
"""Relative. What is left of all but the greatest eigenvalue; it fades from round to round."""

REST_COMES = 1.2 * math.log(1e-12)
"""Over ln e: blows in one gap after which a ball would have come to rest by itself, see `impacts`,
and a fifth more. Whatever still hops then does so by rounding."""

SELDOM = 16
"""Impacts at one instant between two looks for rounds."""

ENDLESS = 1000
"""Impacts at one instant. Rounds that then come again with the same speeds to the last bit, as of a
cart without room between two walls that take nothing, have no end and no limit."""


@dataclass(slots=True)
class Hits:
    """Impacts without a duration at one instant: in which gap, and how fast [m/s]."""

    time: Time = NEVER
    gaps: list[int] = field(default_factory=list)
    speeds: list[float] = field(default_factory=list)
    looked: int = 0  # of them, when rounds were looked for
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
        self.looked = 0

    def rounds(self) -> tuple[int, int] | None:
        """First and last gap of those that are hit in rounds for ever; None where none are."""
        count = len(self.gaps)
        if count < self.looked + SELDOM:
            return None
        self.looked = count
        for p in range(2, min(LONGEST_ROUND, count // ROUNDS) + 1):
            last = self.gaps[-p:]
            if all(self.gaps[count - (k + 1) * p : count - k * p] == last for k in range(ROUNDS)):
                if self._shrink(p):
                    return min(last), max(last)
                own = self.speeds[-ROUNDS * p :]
                self.endless = count > ENDLESS and own == own[-p:] * ROUNDS
                return None
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
