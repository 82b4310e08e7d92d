"""What a stepping method does at the end of a step: memories, impacts, joints, exploders.

As a game engine does it: a touch is noticed when two carts overlap at the end of a step. Contacts
without duration then get their impulse until no pair closes any more, those that close fastest
first and equally fast ones at once, as in the exact run; carts that overlap are not moved apart. A
latch or an exploder acts at the end of the step it falls in.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from typing import Any

from sim.dynamics.motion.hit_in_turn import at_once_for_ever
from sim.dynamics.motion.impact import rebound
from sim.dynamics.motion.locked import impulses
from sim.dynamics.stepping import spent
from sim.dynamics.stepping.field import Field
from sim.dynamics.stepping.pairs import Pair, PerCart
from sim.effects.forces import TOUCHING, EnergyRelease, LooseForce
from sim.laws.rounding import AS_FAST

SWEEPS = 20
"""Impulses in each gap at one instant, at most."""


@dataclass(frozen=True, slots=True)
class Blow:
    """An impulse without duration [N s], and the velocities around it."""

    release: str  # kind of the effect that set it free; empty: a contact
    pair: Pair
    before: tuple[float, float]
    after: tuple[float, float]
    impulse: float
    warmed: float  # J
    let_go: LooseForce | None = None  # then nothing has happened yet
    fixed: tuple[bool, bool] = (False, False)  # sides that stuck to a wall by then

    @property
    def sides(self) -> tuple[int | None, int | None]:
        """The carts that took the impulse; None: a wall did, by itself or through a cart on it."""
        left, right = self.fixed
        return (None if left else self.pair.left), (None if right else self.pair.right)


class Impacts:
    """Watches one field between its steps."""

    def __init__(self, field: Field) -> None:
        self.field = field
        self.remembering = [p for p in field.pairs if p.force is not None and p.force.remembers]
        self.sudden = [p for p in field.pairs if p.force is None]
        self.releases = list(field.releases)
        self.springs = [release for release in self.releases if release.spring is not None]
        self.loosens = bool(self.springs)
        self.watches = bool(self.sudden or self.releases)
        self.blows: list[Blow] = []
        self.spilled = 0.0  # J that parted bumpers kept, less what pressed ones got back

    def latch(self, s: PerCart, v: PerCart) -> None:
        """Exploders hold together what touches with one velocity at the start."""
        for release in self.releases:
            pair = self.field.pair_at.get(release.gap)
            if pair is not None:
                d, rate = self.field.overlap(pair, s, v)
                if d >= 0.0 and rate == 0.0:
                    self.field.join(pair.gap)

    def remember(self, s: PerCart, v: PerCart) -> None:
        """How far each bumper has been pressed in since it was clear."""
        field = self.field
        for pair in self.remembering:
            d, _ = field.overlap(pair, s, v)
            field.memory[pair.gap] = _remembered(d, field.memory[pair.gap])

    def settle(self, t: Any, s: PerCart, v: PerCart) -> None:
        """At the end of a step; velocities in `v` are changed in place."""
        field = self.field
        self.remember(s, v)
        if not self.watches:
            return
        if field.spent and field.modes is None:
            for pair in [field.pair_at[gap] for gap in sorted(field.spent)]:
                opens, over = spent.reserves(field, pair, s, v)
                if min(opens, over) <= 0.0:
                    self.spilled -= spent.end(field, pair, s, v, pressed=over > 0.0)
        for pair in field.pairs if self.loosens else ():
            if pair.loose:
                self.fall_off(pair, s, v)
        while self.releases and self.releases[0].time <= t:
            self.set_free(self.releases.pop(0), s, v)
        self.strike([pair for pair in self.sudden if field.overlap(pair, s, v)[0] >= 0.0], s, v)

    def strike(self, touching: list[Pair], s: PerCart, v: PerCart) -> None:
        """Impulses between those that touch, from left to right, until none of them closes."""
        for _ in range(SWEEPS * len(touching)):
            speeds = [self._closes(pair, s, v) for pair in touching]
            least = max(speeds) * (1.0 - AS_FAST)
            if least <= 0.0:
                return
            block: list[Pair] = []
            for pair, speed in zip(touching, speeds, strict=True):
                if speed < least:
                    continue
                if block and self._body(block[-1].right, v)[1] is not self._body(pair.left, v)[1]:
                    self.strike_at_once(block, v, alone=False)
                    block = []
                block.append(pair)
            self.strike_at_once(block, v, alone=len(touching) == 2)

    def _closes(self, pair: Pair, s: PerCart, v: PerCart) -> float:
        """m/s, above 0 where it does."""
        joined = pair.gap in self.field.joined
        return 0.0 if joined else float(self.field.overlap(pair, s, v)[1])

    def strike_at_once(self, block: list[Pair], v: PerCart, *, alone: bool) -> None:
        """One impact, or several side by side; velcro makes two bodies one.

        `alone`: nobody else touches these; then two may be hit in turn for ever.
        """
        sides = [self._body(block[0].left, v), *(self._body(pair.right, v) for pair in block)]
        e = [pair.contact.restitution or 0.0 for pair in block]
        found: list[float] = []
        if len(block) == 1:
            (m1, _, v1), (m2, _, v2) = sides
            out = list(rebound(m1, m2, v1, v2, e[0]))
        else:
            closing = [a[2] - b[2] for a, b in itertools.pairwise(sides)]
            inverse = [1.0 / side[0] for side in sides]
            joins = any(pair.contact.joins for pair in block)
            if alone and not joins and at_once_for_ever(inverse, closing, e):
                e = [0.0, 0.0]
            found = impulses(inverse, closing, e)
            pushes = zip(sides, [0.0, *found], [*found, 0.0], strict=True)
            out = [speed + (left - right) / m for (m, _, speed), left, right in pushes]
        for k, pair in enumerate(block):
            mu = 1.0 / (1.0 / sides[k][0] + 1.0 / sides[k + 1][0])
            u, w = sides[k][2] - sides[k + 1][2], out[k + 1] - out[k]
            impulse = found[k] if found else mu * (u + w)
            around = (sides[k][2], sides[k + 1][2]), (out[k], out[k + 1])
            warmed = 0.5 * impulse * (u - w)
            fixed = sides[k][0] == math.inf, sides[k + 1][0] == math.inf
            self.blows.append(Blow("", pair, *around, impulse, warmed, fixed=fixed))
        for (_, carts, _), speed in zip(sides, out, strict=True):
            for k in carts:
                v[k] = speed
        for pair in block:
            if pair.contact.joins:
                self.field.join(pair.gap)

    def set_free(self, release: EnergyRelease, s: PerCart, v: PerCart) -> None:
        """½ mu w'² = ½ mu w² + E, where the two touch; or from now on a spring is between them."""
        field = self.field
        pair = field.pair_at[release.gap]
        d, _ = field.overlap(pair, s, v)
        if pair.gap in field.joined:
            field.join(pair.gap, part=True)
            field.held.discard(pair.gap)
        elif d < -TOUCHING:
            return
        (m1, left, v1), (m2, right, v2) = self._body(pair.left, v), self._body(pair.right, v)
        mu = 1.0 / (1.0 / m1 + 1.0 / m2)
        if release.spring is not None:
            spring = release.spring.placed(-d)
            pair.links, pair.loose = (*pair.links, spring), (*pair.loose, spring)
            self.springs.remove(release)
            now = (v1, v2)
            self.blows.append(Blow(release.kind, pair, now, now, 0.0, 0.0, spring))
            return
        if pair.gap not in field.spent:
            self.spilled += spent.part(field, pair, s, v)
        apart = math.sqrt((v2 - v1) ** 2 + 2.0 * release.energy / mu)
        change = apart - (v2 - v1)
        out = v1 - mu / m1 * change, v2 + mu / m2 * change
        for body, speed in ((left, out[0]), (right, out[1])):
            for k in body:
                v[k] = speed
        warmed = 0.5 * mu * (v1 - v2 + apart) * (v1 - v2 - apart)
        fixed = m1 == math.inf, m2 == math.inf
        around = (v1, v2), out
        self.blows.append(Blow(release.kind, pair, *around, mu * change, warmed, fixed=fixed))

    def fall_off(self, pair: Pair, s: PerCart, v: PerCart, *, now: bool = False) -> None:
        """Springs that have their full length push no more; `now`: the longest has it."""
        d, _ = self.field.overlap(pair, s, v)
        length = max(-d, min(spring.reach for spring in pair.loose) if now else -d)
        gone = [spring for spring in pair.loose if spring.reach <= length]
        pair.loose = tuple(spring for spring in pair.loose if spring not in gone)
        pair.links = tuple(link for link in pair.links if link not in gone)

    @property
    def latched(self) -> float:
        """J in springs that nobody has let go."""
        return math.fsum(release.energy for release in self.springs)

    def _body(self, cart: int | None, v: PerCart) -> tuple[float, list[int], float]:
        """Mass, carts and velocity of the body of a cart; a wall is infinite."""
        if cart is None:
            return math.inf, [], 0.0
        body = next(body for body in self.field.bodies if cart in body)
        if self.field.fixed(body):
            return math.inf, body, 0.0
        return sum(self.field.mass[k] for k in body), body, v[cart]


def _remembered(d: Any, memory: Any) -> Any:
    """The greatest overlap since it was clear."""
    if isinstance(d, float):
        return max(d, memory) if d > 0.0 else 0.0
    import numpy as np

    return np.where(d > 0.0, np.maximum(d, memory), 0.0)
