"""Steps that follow a tolerance through written laws, in plain Python; events located.

    y' = f(y) by the pair of orders 5 and 4 of Dormand & Prince, seven evaluations a step

The difference of the two is the error of the step; it decides whether the step is taken and how
long the next one is. A touch or a separation is looked for on the quintic through places,
velocities and accelerations at both ends, and the step is taken again up to there.
Source: Dormand & Prince, J. Comput. Appl. Math. 6 (1980) 19; Hairer, Nørsett & Wanner II.4.
"""

from __future__ import annotations

import math

from sim.dynamics.result.outcome import UnsolvedError
from sim.dynamics.stepping.falls import Along, State, first_falls
from sim.dynamics.stepping.located import Key
from sim.dynamics.stepping.pairs import PerCart
from sim.dynamics.stepping.sided import OwnSteps
from sim.mine.field import WrittenField
from sim.scene.model import Scene
from sim.scene.said import said

NODES = (0.0, 1 / 5, 3 / 10, 4 / 5, 8 / 9, 1.0, 1.0)
ROWS: tuple[tuple[float, ...], ...] = (
    (),
    (1 / 5,),
    (3 / 40, 9 / 40),
    (44 / 45, -56 / 15, 32 / 9),
    (19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729),
    (9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656),
    (35 / 384, 0.0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84),
)
FIFTH = (*ROWS[6], 0.0)
DIFFERENCE = (71 / 57600, 0.0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40)
"""The weights of the fifth order less those of the fourth."""

RTOL = 1e-9
"""Error of one step, relative to the greatest closing speed, or to that of pairs in touch now."""

QUICK = 0.01
"""s. A way counts as small beside that speed times this."""

FIRST = 1e-6
"""s. The first step into a contact: its force is not known there yet."""

PARTS = 40
"""Steps of a run in which nothing touches, at least."""

MOST_CALLS = 400_000
"""Questions to the laws in one run: some seconds."""

SHORTEST = 1e-13
"""Of the run. A law that asks for shorter steps has no values that belong together."""


def longer(error: float) -> float:
    """By how much the next step may be longer; an error beyond all numbers is a large one."""
    if not error < math.inf:
        return 0.2
    return min(5.0, max(0.2, 0.9 * error**-0.2)) if error > 0.0 else 5.0


class EmbeddedStepper(OwnSteps):
    """`method` is not used: the steps are those of this module."""

    def __init__(
        self, scene: Scene, rtol: float = RTOL, *, right_first: bool = False,
        most_calls: int = MOST_CALLS,
    ) -> None:  # fmt: skip
        self.right_first, self.rtol, self.most_calls = right_first, rtol, most_calls
        super().__init__(scene)
        closing = [abs(w) for w in scene.approaches if math.isfinite(w)]
        own = [abs(cart.velocity) for cart in scene.carts]
        self.speed = max([*closing, 1e-3] if any(closing) else [*own, 1e-3])
        self.longest = scene.until / PARTS
        self.next = min(self.longest, FIRST) if self._touching() else self.longest

    def make_field(self, scene: Scene, lanes: int) -> WrittenField:
        """With the laws of the scene."""
        self.own = WrittenField(scene, right_first=self.right_first)
        return self.own

    def length(self, t: float) -> float:
        """s. What the error of the last one allows."""
        return self.next

    def changed(self) -> None:
        """A contact that has just begun is tried carefully."""
        self.next = FIRST if self._touching() else self.longest

    def spent(self) -> bool:
        """Too many questions."""
        return self.own.calls > self.most_calls

    def lost(self, t: float) -> UnsolvedError:
        """A law without values that belong together; `WrongLawError` where more can be said."""
        self._look(self.s, self.v, stuck=True)
        return UnsolvedError(
            said("the steps became too short: the law has no values that belong together here"),
            said("a force changes little when overlap and rate change little"),
            t,
            (),
        )

    def _touching(self) -> bool:
        return any(mode != "apart" for mode in (self.field.modes or {}).values())

    def part(self, t: float, h: float) -> tuple[float, list[Key]]:
        """At most h, as the error allows, or up to the first event."""
        s, v = self.s, self.v
        while True:
            s1, v1, a0, a1, error = self._tried(t, h, s, v)
            factor = longer(error)
            if error <= 1.0:
                break
            h *= factor
            if h < SHORTEST * self.field.scene.until or self.spent():
                raise self.lost(t)
        self._look(s1, v1)
        dense = _quintic(s, v, a0, s1, v1, a1, h)
        first, keys = first_falls(self.located, t, h, (s, v), (s1, v1), dense)
        if not keys:
            self.next = min(self.longest, h * factor)
            self._told(t, h, s1, v1)
            return h, []
        if first > 0.0:
            if self.field.keep is not None:
                self.field.keep.clear()
            s1, v1, *_ = self._tried(t, first, s, v)
            self._told(t, first, s1, v1)
        return first, keys

    def _tried(
        self, t: float, h: float, s: PerCart, v: PerCart
    ) -> tuple[PerCart, PerCart, PerCart, PerCart, float]:
        """Places, velocities, accelerations at both ends, and the error (1: just allowed)."""
        field, count = self.field, range(len(s))
        if field.keep is not None:
            field.keep.clear()
        us: list[PerCart] = []
        ks: list[PerCart] = []
        x, u = s, v
        for node, row in zip(NODES, ROWS, strict=True):
            if row:
                x = [
                    s[k] + h * sum(c * one[k] for c, one in zip(row, us, strict=True))
                    for k in count
                ]
                u = [
                    v[k] + h * sum(c * one[k] for c, one in zip(row, ks, strict=True))
                    for k in count
                ]
            us.append(u)
            ks.append(field.accelerations(t + node * h, x, u, h))
        small = self.rtol * max(self.speed, self._closing(s, v), self._closing(x, u))
        error = max(
            abs(h * _sum(DIFFERENCE, part, k)) / size
            for k in count
            for part, size in ((us, small * QUICK), (ks, small))
        )
        return x, u, ks[0], ks[-1], error

    def _closing(self, s: PerCart, v: PerCart) -> float:
        """m/s. The fastest pair that touches."""
        rates = (self.field.overlap(pair, s, v) for pair, _ in self.own.written)
        return max((abs(rate) for d, rate in rates if d > 0.0), default=0.0)

    def _look(self, s: PerCart, v: PerCart, *, stuck: bool = False) -> None:
        for pair, force in self.own.written:
            force.look_at(*self.field.overlap(pair, s, v), self.speed, stuck=stuck)

    def _told(self, t: float, h: float, s: PerCart, v: PerCart) -> None:
        self.s, self.v = s, v
        if self.seen is not None:
            self.tell(t + h, h, FIFTH)


def _sum(weights: tuple[float, ...], stages: list[PerCart], k: int) -> float:
    return float(sum(c * stage[k] for c, stage in zip(weights, stages, strict=True)))


def _quintic(
    s: PerCart, v: PerCart, a: PerCart, s1: PerCart, v1: PerCart, a1: PerCart, h: float
) -> Along:
    """Places and velocities inside of a step of h."""
    parts = []
    for x0, u0, k0, x1, u1, k1 in zip(s, v, a, s1, v1, a1, strict=True):
        p = x1 - x0 - h * u0 - 0.5 * h * h * k0
        q = h * (u1 - u0 - h * k0)
        r = h * h * (k1 - k0)
        third, fourth = 10 * p - 4 * q + 0.5 * r, -15 * p + 7 * q - r
        fifth = 6 * p - 3 * q + 0.5 * r
        parts.append((x0, h * u0, 0.5 * h * h * k0, third, fourth, fifth))

    def at(tau: float) -> State:
        z = tau / h
        places = [
            c0 + z * (c1 + z * (c2 + z * (c3 + z * (c4 + z * c5))))
            for c0, c1, c2, c3, c4, c5 in parts
        ]
        rates = [
            (c1 + z * (2 * c2 + z * (3 * c3 + z * (4 * c4 + z * 5 * c5)))) / h
            for _, c1, c2, c3, c4, c5 in parts
        ]
        return places, rates

    return at
