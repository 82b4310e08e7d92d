"""What bumpers keep for good, step by step, and what they get back where they are pressed again.

A bumper that remembers warms as it is pressed further in than ever. One that may only push lets go
while it still overlaps: what the overlap holds then lies idle, and counts as warm until the two are
clear; pressed again before that, they have it back.
"""

from __future__ import annotations

from sim.dynamics.result.ledger import Ledger
from sim.dynamics.stepping import spent
from sim.dynamics.stepping.pairs import PerCart
from sim.dynamics.stepping.stepper import Stepper


class Bumpers:
    """Of a run, from its start with forces `push` [N]: what overlapped before is no part of it."""

    def __init__(self, run: Stepper, ledger: Ledger, push: PerCart) -> None:
        self.field, self.ledger = run.field, ledger
        self._held: dict[int, float] = {}  # what a law gave back at the step before
        self._idle: dict[int, float] = {}  # J of overlaps that do not push
        for pair in self.field.pairs:
            if pair.force is not None:
                d, rate = self.field.overlap(pair, run.s, run.v)
                self._held[pair.gap] = pair.force.settle(
                    0.0, push[pair.gap], self.field.memory[pair.gap],
                    spent.stored(pair, d, rate, 0.0),
                )[1]  # fmt: skip

    def step(self, s: PerCart, v: PerCart, push: PerCart, impulses: list[float]) -> None:
        """A step ended with these forces [N]; `impulses` [N s] were given in it."""
        field = self.field
        for pair in field.pairs:
            gap, force = pair.gap, pair.force
            if force is None:
                continue
            d, rate = field.overlap(pair, s, v)
            stored, held = spent.stored(pair, d, rate, 0.0), self._held.get(gap, 0.0)
            told = gap in field.spent  # by the release
            if not force.remembers:  # let go at the end of this step, or at that of the one before
                held = 0.0 if told else stored if impulses[gap] and not push[gap] else held
            warm, self._held[gap] = force.settle(held, push[gap], field.memory[gap], stored)
            idle = self._idle.pop(gap, 0.0)
            if push[gap] or impulses[gap]:
                warm -= idle
            elif not (told or force.remembers or gap in field.joined):
                self._idle[gap] = stored
            if warm:
                self.ledger.dissipate(warm)
