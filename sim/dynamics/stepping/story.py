"""What happens in a stepped run as its steps show it: touches, greatest forces, separations.

A touch has happened when a step ends with a force in the gap; without a look at events it is told
then, and so is its end, when a step ends without the force. A method that locates events begins a
step where either happens, and that is what it tells. Nothing is put between the ends of steps.
"""

from __future__ import annotations

import dataclasses
import math
from dataclasses import dataclass

from sim.dynamics.result.events import ORDER, Event
from sim.dynamics.result.record import Record
from sim.dynamics.stepping.field import Field
from sim.dynamics.stepping.impacts import Blow
from sim.dynamics.stepping.pairs import Pair, PerCart
from sim.effects.forces import LooseForce

Speeds = tuple[float, float]


@dataclass(slots=True)
class Touch:
    """A contact in progress."""

    before: Speeds
    impulse: float = 0.0  # N s so far
    peak: tuple[float, float, float, Speeds] | None = None  # t, N, N s until then, m/s
    last: float = 0.0  # N
    until: float = 0.0  # s, the end of the last step with a force
    deepest: float = 0.0  # m
    approach: float = 0.0  # m/s


@dataclass(slots=True)
class LetGo:
    """A spring that lies loose in a gap."""

    kind: str
    spring: LooseForce
    before: Speeds
    impulse: float = 0.0  # N s so far


STILL = 1e-9
"""Of the greatest approach so far, and of what the force can give: less is left by rounding."""

SPENT = 1e-6
"""Of its force when it was let go. Steps to where a spring falls off end so near to that."""


def reachable(pair: Pair, d: float) -> float:
    """m/s. What force and room between a pair can give."""
    force = sum(abs(link.force(-d, 0.0)) for link in pair.links)
    return math.sqrt(force * max(-d, 0.0) / pair.mu)


@dataclass(slots=True)
class Story:
    """Collects events of one stepped run into its record."""

    field: Field
    record: Record
    located: bool
    touching: dict[int, Touch] = dataclasses.field(default_factory=dict)
    loose: dict[int, LetGo] = dataclasses.field(default_factory=dict)
    closing: dict[int, float] = dataclasses.field(default_factory=dict)
    """m/s, of pairs that never touch: how fast they have come nearer, at most."""

    def step(
        self,
        t: float,
        h: float,
        old: PerCart,
        v: PerCart,
        s: PerCart,
        push: PerCart,
        impulses: list[float],
        first: PerCart | None,
    ) -> None:
        """A step of h ended at t: velocities before and after it, forces now, impulses in it, and
        the forces with which it began; None where it has no length."""
        for pair in self.field.pairs:
            gap = pair.gap
            if gap in self.loose:
                self._loose(t, pair, s, v)
            if pair.apart:
                self._nearest(t, pair, s, v, push[gap])
            if pair.force is None:
                continue
            touch = self.touching.get(gap)
            if touch is None and (push[gap] or impulses[gap]):
                touch = self._begin(t, h, pair, old, v, push[gap], first)
            if touch is None:
                continue
            if self.located and not (push[gap] or impulses[gap]):
                touch.last *= not pair.force.locks  # which gives nothing back
                self.end(touch.until, pair, old)
                continue
            touch.impulse += impulses[gap]
            d, _ = self.field.overlap(pair, s, v)
            touch.deepest = max(touch.deepest, d)
            if touch.peak is None or push[gap] > touch.peak[1]:
                touch.peak = (t, push[gap], touch.impulse, self._speeds(pair, v))
            touch.until = t
            if push[gap] or self.located:
                touch.last = push[gap]
            if not push[gap]:
                self.end(t, pair, v)

    def _begin(
        self,
        t: float,
        h: float,
        pair: Pair,
        old: PerCart,
        v: PerCart,
        push: float,
        first: PerCart | None,
    ) -> Touch:
        before, after = self._speeds(pair, old), self._speeds(pair, v)
        touch = self.touching[pair.gap] = Touch(before, approach=before[0] - before[1])
        if self.located and first is not None:
            t, after, push = t - h, before, first[pair.gap]
        self._tell(t, "contact", pair, before, after, 0.0, push)
        return touch

    def end(self, t: float, pair: Pair, v: PerCart, *, over: bool = True) -> None:
        """A contact is over; or the run is, in the middle of it."""
        touch = self.touching.pop(pair.gap)
        if touch.deepest > self.record.deepest.get(pair.gap, (0.0, 0.0))[0]:
            self.record.deepest[pair.gap] = (touch.deepest, touch.approach)
        if touch.peak is not None and touch.peak[1] > 0.0 and (over or touch.peak[0] < t):
            when, force, impulse, after = touch.peak
            self._tell(when, "peak", pair, touch.before, after, impulse, force)
        if over:
            now = self._speeds(pair, v)
            self._tell(t, "separate", pair, touch.before, now, touch.impulse, touch.last)

    def _loose(self, t: float, pair: Pair, s: PerCart, v: PerCart) -> None:
        """A spring that pushes no more has fallen off."""
        one = self.loose[pair.gap]
        d, _ = self.field.overlap(pair, s, v)
        if one.spring.force(-d, 0.0) <= SPENT * one.spring.strongest:
            del self.loose[pair.gap]
            self._tell(t, "separate", pair, one.before, self._speeds(pair, v), one.impulse, 0.0)

    def _nearest(self, t: float, pair: Pair, s: PerCart, v: PerCart, push: float) -> None:
        """Two that never touch turn round: their greatest force."""
        d, rate = self.field.overlap(pair, s, v)
        fastest = self.closing.get(pair.gap, 0.0)
        if rate > STILL * max(fastest, reachable(pair, d)):
            self.closing[pair.gap] = max(rate, fastest)
        elif fastest:
            self.closing[pair.gap] = 0.0
            force = push + sum(link.force(-d, -rate) for link in pair.links)
            speeds = self._speeds(pair, v)
            self._tell(t, "peak", pair, speeds, speeds, 0.0, force)

    def blow(self, t: float, blow: Blow) -> None:
        """An impulse without duration, or a spring that is let go."""
        spring = blow.let_go
        if spring is not None:
            self.loose[blow.pair.gap] = LetGo(blow.release, spring, blow.before)
        self._tell(
            t,
            "release" if blow.release else "contact",
            blow.pair,
            blow.before,
            blow.after,
            blow.impulse,
            None if spring is None else spring.strongest,
        )

    def finish(self, t: float, v: PerCart) -> None:
        """The end of the run."""
        for pair in self.field.pairs:
            if pair.gap in self.touching:
                self.end(t, pair, v, over=False)
        self.record.end(t, v)

    def _speeds(self, pair: Pair, v: PerCart) -> Speeds:
        left = 0.0 if pair.left is None else v[pair.left]
        return left, 0.0 if pair.right is None else v[pair.right]

    def _tell(
        self,
        t: float,
        kind: str,
        pair: Pair,
        before: Speeds,
        after: Speeds,
        impulse: float,
        force: float | None,
    ) -> None:
        assert kind in ORDER
        self.record.counts[kind] += 1
        if not self.record.keep_events:
            return
        names = self.field.scene.names_at(pair.gap)
        carts = (pair.left, pair.right)
        was, now = (
            {n: u for n, u, k in zip(names, speeds, carts, strict=True) if k is not None}
            for speeds in (before, after)
        )
        self.record.events.append(Event(t, kind, names, was, now, impulse, force))
