"""Forces on single carts that are constant for a time: what of the effects has a closed form here.

    incline    m g sin θ                      friction   μ m g cos θ, θ of all inclines under it
    push       its force, from ≤ t < until

An effect that is not among them has no bound, and says so.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from flint import arb

from sim.certify.balls import ZERO, Ball, NoBoundError, NotProvableError, exact, is_zero
from sim.scene.model import Scene


@dataclass(slots=True)
class Load:
    """On one cart: its slope, m/s², and what friction can do sliding and at rest, N.

    Carts on the same slopes share one ball: their accelerations differ by nought, exactly.
    """

    mass: Ball
    slope: Ball = ZERO
    kinetic: Ball = ZERO
    static: Ball = ZERO
    pushes: list[tuple[float, float, Ball]] = field(default_factory=list)  # s, s, N

    def force(self, now: Ball) -> Ball:
        """N without friction, just after `now`, which is exact where a push begins or ends."""
        total = self.pushed(now)
        return total if is_zero(self.slope) else total + self.mass * self.slope

    def pushed(self, now: Ball) -> Ball:
        """N, of pushes alone."""
        total = ZERO
        for begin, end, push in self.pushes:
            if now >= begin and now < end:
                total = total + push
            elif not (now < begin or now >= end):
                raise NotProvableError("an event comes as a push begins or ends")
        return total


def loads(scene: Scene, masses: list[Ball]) -> list[Load]:
    """One for each cart; raises where an effect has no bound."""
    found = [Load(mass) for mass in masses]
    gravity = exact(scene.gravity)
    angles = _slopes(scene, found)
    for effect in scene.effects:
        acts = [k for k, cart in enumerate(scene.carts) if cart.name in effect.carts]
        if effect.kind == "friction":
            low = effect.numbers["coefficient"]
            high = max(low, effect.numbers.get("static", low))
            for k in acts:
                press = masses[k] * gravity * angles[k].cos()
                found[k].kinetic = found[k].kinetic + exact(low) * press
                found[k].static = found[k].static + exact(high) * press
        elif effect.kind == "push":
            end = effect.numbers.get("until", math.inf)
            force = exact(effect.numbers["force"])
            found[acts[0]].pushes.append((effect.numbers["from"], end, force))
        elif effect.kind != "incline":
            raise NoBoundError(f"{effect.kind} has no bound yet")
    return found


def _no_slope() -> dict[tuple[float, ...], tuple[Ball, Ball]]:
    return {(): (arb(0), ZERO)}


def _slopes(scene: Scene, found: list[Load]) -> list[Ball]:
    """rad. The angle under each cart; its slope is the sum of g sin θ of all inclines."""
    gravity, shared = exact(scene.gravity), _no_slope()
    angles = []
    for k, cart in enumerate(scene.carts):
        under = tuple(
            effect.numbers["angle"]
            for effect in scene.effects
            if effect.kind == "incline" and cart.name in effect.carts
        )
        if under not in shared:
            parts = [exact(angle) for angle in under]
            slope = gravity * sum((angle.sin() for angle in parts), arb(0))
            shared[under] = sum(parts, arb(0)), slope
        angle, found[k].slope = shared[under]
        angles.append(angle)
    return angles
