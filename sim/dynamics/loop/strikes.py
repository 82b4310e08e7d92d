"""Impacts without a duration in a run: what they come to, and what earlier ones say of them.

A block is one gap, or gaps side by side that are struck at once (`first_struck`).
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection

from sim.dynamics.loop import collapse, impacts, rounds
from sim.dynamics.result.ledger import Ledger
from sim.dynamics.result.record import Record
from sim.dynamics.state import flips
from sim.dynamics.state.body import Gap
from sim.dynamics.state.chain import Chain
from sim.dynamics.state.clock import Time


class Strikes:
    """All impacts of one run. `instant` [s]: what is closer together happens at one instant."""

    def __init__(
        self,
        chain: Chain,
        record: Record,
        ledger: Ledger,
        instant: float,
        counts: defaultdict[str, int],
    ) -> None:
        self.chain, self.record, self.ledger = chain, record, ledger
        self.instant, self.counts = instant, counts
        self.fastest = 0.0  # m/s, greatest approach so far
        self.hits = rounds.Hits()

    @property
    def parts(self) -> float:
        """m/s. What opens faster parts, and is not struck: no impact pulls."""
        return impacts.AT_REST * self.fastest

    def see(self, gap: Gap) -> None:
        """An approach: is it the greatest so far?"""
        self.fastest = max(self.fastest, -gap.rate)

    def stay(self, block: list[Gap], now: Time, *, in_contact: bool) -> list[Gap]:
        """Which of them go on together, in contact, while something presses them together?"""
        return [
            gap
            for gap in block
            if impacts.rests(gap, self.fastest, in_contact=in_contact)
            or (self.hits.often(gap) and impacts.hops_within_rounding(gap, now))
        ]

    def run_of(self, block: list[Gap], now: Time) -> list[Gap]:
        """The gaps of all bodies that this impact leaves with one velocity; often none."""
        return collapse.run_of(self.chain, block, now, self.instant, self.hits)

    def is_plain(self, gap: Gap) -> bool:
        """Do the two part, and has this gap not been hit again and again at one instant?"""
        return not gap.contact.joins and gap.flips + 1 < flips.UNDECIDED

    def alone(self, gap: Gap, now: Time) -> None:
        """A plain impact of two that are free, or settled."""
        self.counts[gap.contact.law] += 1
        self.fastest = max(self.fastest, -gap.rate)
        flips.note(gap, now, self.instant)
        impacts.instant(gap, now, self.record, self.ledger, self.fastest)

    def at_once(self, block: list[Gap], now: Time, stay: Collection[Gap] = ()) -> None:
        """The impact in a block of bodies that are free, or settled; those of `stay` go on so."""
        self._jump(block, now)
        for gap in block:
            self.counts[gap.contact.law] += 1
            if gap.rate > 0.0:
                gap.rate = 0.0  # no impact pulls
            elif not gap.contact.joins:
                self.fastest = max(self.fastest, -gap.rate)
            if not gap.contact.joins:
                flips.note(gap, now, self.instant)
        gap = block[0]
        if len(block) > 1:
            impacts.side_by_side(self.chain, block, stay, now, self.record, self.ledger)
        elif gap.contact.joins:
            impacts.join(self.chain, gap, now, self.record, self.ledger)
        else:
            stays = gap in stay
            impacts.instant(gap, now, self.record, self.ledger, self.fastest, stays=stays)

    def _jump(self, block: list[Gap], now: Time) -> None:
        """Where an approach is more than rounding, nothing at this time was an alternation."""
        for gap in block:
            if gap.rate < 0.0 and not collapse.is_over(self.chain, gap, now, self.instant):
                moves = -gap.rate > impacts.AT_REST * self.fastest
                for other in (gap, *self.chain.neighbours(gap)):
                    if other is not None:
                        flips.jump(other, now, moves=moves)
                for body in (gap.left, gap.right):
                    flips.jump(body, now, moves=moves)
