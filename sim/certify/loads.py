"""Forces on single carts that are constant for a time: what of the effects has a closed form here.

    incline    m g sin θ                      friction   μ m g cos θ, θ of all inclines under it
    push       its force, from ≤ t < until

An effect that is not among them has no bound, and says so.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from flint import arb

from sim.certify.balls import ZERO, Ball, NotProvableError, exact
from sim.scene.model import Scene


@dataclass(slots=True)
class Load:
    """On one cart, in N: what always acts, and what friction can do sliding and at rest."""

    steady: Ball = ZERO
    kinetic: Ball = ZERO
    static: Ball = ZERO
    pushes: list[tuple[float, float, Ball]] = field(default_factory=list)  # s, s, N

    def force(self, now: Ball) -> Ball:
        """N without friction, just after `now`, which is exact where a push begins or ends."""
        total = self.steady
        for begin, end, push in self.pushes:
            if now >= begin and now < end:
                total = total + push
            elif not (now < begin or now >= end):
                raise NotProvableError("an event comes as a push begins or ends")
        return total


def loads(scene: Scene, masses: list[Ball]) -> list[Load]:
    """One for each cart; raises where an effect has no bound."""
    found = [Load() for _ in scene.carts]
    angles = [arb(0) for _ in scene.carts]
    gravity = exact(scene.gravity)
    for effect in scene.effects:
        if effect.kind == "incline":
            angle = exact(effect.numbers["angle"])
            for k, cart in enumerate(scene.carts):
                if cart.name in effect.carts:
                    angles[k] = angles[k] + angle
                    found[k].steady = found[k].steady + masses[k] * gravity * angle.sin()
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
            raise NotProvableError(f"{effect.kind} has no bound yet")
    return found
