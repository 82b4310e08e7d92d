"""Signals: what is linear in the state of a row, as a series within one piece of time."""

from __future__ import annotations

from dataclasses import dataclass
from math import comb, perm

from sim.certify.numbers.balls import ZERO, Ball, is_zero

DERIVATIVES = 4
"""Of a signal: itself, its slope, and the two that a slope's own zeros need."""


@dataclass(frozen=True, slots=True)
class Signal:
    """Σ terms τᵏ + tail: a linear function of the state, within one piece; tails: 0 ± a bound."""

    terms: tuple[Ball, ...]
    tails: tuple[Ball, ...]

    def at(self, tau: Ball) -> Ball:
        """Its value; `tau` [s] counts from the beginning of the piece."""
        total = self.terms[-1]
        for one in self.terms[-2::-1]:
            total = total * tau + one
        return total + self.tails[0]

    def slope(self) -> Signal:
        """Its derivative."""
        terms = tuple(k * one for k, one in enumerate(self.terms) if k)
        return Signal(terms, self.tails[1:])

    def begun(self, reach: Ball) -> Signal:
        """Without the power τᶻ that is a factor of all of it, exactly: the same zeros, but for 0.

        What is left out, R, falls towards 0 with τⁿ⁺¹ and more: R/τᶻ and its derivatives, by
        Leibniz' rule, are greatest at `reach`.
        """
        z = next((k for k, one in enumerate(self.terms[:-DERIVATIVES]) if not is_zero(one)), 0)
        if not z:
            return self
        tails = [
            sum(
                (
                    comb(r, j) * perm(z + j - 1, j) * self.tails[r - j] / reach ** (z + j)
                    for j in range(r + 1)
                ),
                ZERO,
            )
            for r in range(len(self.tails))
        ]
        return Signal(self.terms[z:], tuple(tails))


def total(signals: list[tuple[int, Signal]], constant: Ball) -> Signal:
    """constant + Σ sign × signal, of one piece."""
    length = len(signals[0][1].terms)
    terms = [sum((sign * one.terms[n] for sign, one in signals), ZERO) for n in range(length)]
    terms[0] = terms[0] + constant
    tails = zip(*(one.tails for _, one in signals), strict=True)
    return Signal(tuple(terms), tuple(sum(parts, ZERO) for parts in tails))
