"""Effects as balls: what is constant for a time, and what is linear in place and velocity.

`sim.effects.constant` and `sim.effects.linear` say which. Another effect has no bound here, and
says so.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from sim.certify.instants import Instant, instant
from sim.certify.numbers.arithmetic import arb
from sim.certify.numbers.balls import ZERO, Ball, NoBoundError, NotProvableError, exact, is_zero
from sim.certify.oscillation import Line
from sim.effects.constant import Constant, constant_of
from sim.effects.linear import linear_of
from sim.effects.where import gap_of
from sim.scene.model import Scene
from sim.scene.said import said


@dataclass(slots=True)
class Load:
    """On one cart: its slope, m/s², and what friction can do sliding and at rest, N.

    Carts on the same slope share one ball: their accelerations differ by nought, exactly.
    """

    mass: Ball
    slope: Ball = ZERO
    kinetic: Ball = ZERO
    static: Ball = ZERO
    pushes: list[tuple[float, float, Ball]] = field(default_factory=list)  # s, s, N
    drag: Ball = ZERO  # kg/s
    even: bool = True  # is friction the same, sliding and at rest?

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
                raise NotProvableError(said("an event comes as a push begins or ends"))
        return total


def loads(scene: Scene, masses: list[Ball]) -> list[Load]:
    """One for each cart; raises where an effect has no bound."""
    found = [Load(mass) for mass in masses]
    gravity, on_each = exact(scene.gravity), _on_each(scene)
    angles = _slopes(scene, found, on_each)
    for load, constants, angle in zip(found, on_each, angles, strict=True):
        for one in constants:
            if one.friction:
                press = load.mass * gravity * angle.cos()
                kinetic, static = map(exact, one.friction)
                load.even = load.even and one.friction[0] == one.friction[1]
                load.kinetic = load.kinetic + kinetic * press
                load.static = load.static + static * press
            if one.push:
                begin, end, force = one.push
                load.pushes.append((begin, end, exact(force)))
    for effect in scene.effects:
        one_linear = linear_of(effect)
        if one_linear is not None and one_linear.drag is not None:
            for cart, load in zip(scene.carts, found, strict=True):
                if cart.name in effect.carts:
                    load.drag = load.drag + exact(one_linear.drag)
    return found


def springs(scene: Scene) -> dict[int, list[Line]]:
    """By gap: N = k (o + L) + c o′, o the overlap of the edges."""
    found: dict[int, list[Line]] = {}
    for effect in scene.effects:
        one = linear_of(effect)
        if one is not None and one.spring is not None:
            k, length, c = map(exact, one.spring)
            found.setdefault(gap_of(effect, scene), []).append(Line(k, c, -length))
    return found


@dataclass(frozen=True, slots=True)
class Burst:
    """An energy that is set free between the two at a gap, at once or by a spring."""

    gap: int
    energy: Ball  # J
    when: Instant
    stiffness: Ball  # N/m; None: at once


def bursts(scene: Scene) -> list[Burst]:
    """In the order of their times."""
    found = []
    for effect in scene.effects:
        one = linear_of(effect)
        if one is not None and one.release is not None:
            energy, t, stiffness = one.release
            k = None if stiffness is None else exact(stiffness)
            found.append(Burst(gap_of(effect, scene), exact(energy), instant(t), k))
    return sorted(found, key=lambda burst: burst.when.ends())


def _on_each(scene: Scene) -> list[list[Constant]]:
    """What acts on each cart, in the order of the effects."""
    on_each: list[list[Constant]] = [[] for _ in scene.carts]
    for effect in scene.effects:
        one = constant_of(effect)
        if one is None:
            if linear_of(effect) is not None:
                continue
            raise NoBoundError(said("{what} has no bound yet", what=effect.kind))
        for cart, constants in zip(scene.carts, on_each, strict=True):
            if cart.name in effect.carts:
                constants.append(one)
    return on_each


def _slopes(scene: Scene, found: list[Load], on_each: list[list[Constant]]) -> list[Ball]:
    """rad. The angle under each cart, one at most; its slope is g sin θ."""
    gravity = exact(scene.gravity)
    shared: dict[float | None, tuple[Ball, Ball]] = {None: (arb(0), ZERO)}
    angles = []
    for load, constants in zip(found, on_each, strict=True):
        under = next((one.angle for one in constants if one.angle is not None), None)
        if under not in shared:
            angle = exact(under or 0.0)
            shared[under] = angle, gravity * angle.sin()
        angle, load.slope = shared[under]
        angles.append(angle)
    return angles
