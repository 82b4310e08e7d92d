"""Instants that remember from which earlier one they were found.

t₂ = t₁ + τ as balls forgets that t₂ − t₁ is τ: both are wide by what t₁ is wide, and a contact that
lasts τ would seem to last τ ± that. So an instant keeps its parent and the step from it, and a
difference is the sum of the steps wherever one leads to the other, or both come from a third.
"""

from __future__ import annotations

from fractions import Fraction

from sim.certify.numbers.balls import Ball, exact, is_zero, lower, upper

MOST_BACK = 12
"""Steps that are followed. Beyond them the balls themselves are subtracted, which holds too."""


class Instant:
    """A time in s from the start of the run."""

    __slots__ = ("_ends", "ball", "parent", "step")

    def __init__(self, ball: Ball, parent: Instant | None = None, step: Ball = None) -> None:
        self.ball, self.parent, self.step = ball, parent, step
        self._ends: tuple[Fraction, Fraction] | None = None

    def ends(self) -> tuple[Fraction, Fraction]:
        """s. Its bounds, exactly; reckoned once."""
        if self._ends is None:
            self._ends = lower(self.ball), upper(self.ball)
        return self._ends

    def after(self, tau: Ball) -> Instant:
        """τ s later; the very same instant where no time passes."""
        return self if is_zero(tau) else Instant(self.ball + tau, self, tau)

    def minus(self, other: Instant) -> Ball:
        """s. How much later than the other this is."""
        if self is other:
            return exact(0.0)
        mine, theirs = self._line(), other._line()
        for instant, since in mine:
            for earlier, until in theirs:
                if instant is earlier:
                    return since - until
        return self.ball - other.ball

    def _line(self) -> list[tuple[Instant, Ball]]:
        """This instant and those before it, with the time from each of them to here."""
        found: list[tuple[Instant, Ball]] = [(self, exact(0.0))]
        one, total = self, exact(0.0)
        while one.parent is not None and len(found) < MOST_BACK:
            total, one = total + one.step, one.parent
            found.append((one, total))
        return found


def instant(t: float) -> Instant:
    """Exactly this double."""
    return Instant(exact(t))
