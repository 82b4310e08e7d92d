"""What a certificate takes for given: the scene's doubles, or what their tolerances allow.

A gap stands in a scene twice: rounded once from the decimals, and as the difference of places that
are doubles themselves. `wide` takes both and what is between, which costs an ulp or two and holds
either reading; where that leaves the order of events open, the gap of the scene alone is taken, so
that what touches on paper touches here.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from flint import arb

from sim.certify.balls import Ball, between, exact
from sim.certify.loads import Load, loads
from sim.scene.model import Scene


@dataclass(frozen=True, slots=True)
class Inputs:
    """Balls by cart and by gap, from left to right; None for the gap of an open side."""

    scene: Scene
    masses: list[Ball]
    places: list[Ball]
    velocities: list[Ball]
    gaps: list[Ball]
    loads: list[Load]


def inputs(scene: Scene, *, wide: bool) -> Inputs:
    """Read a scene; raises NotProvableError where an effect has no bound."""
    masses = [_number(scene, cart.name, "mass", cart.mass) for cart in scene.carts]
    return Inputs(
        scene,
        masses,
        [_number(scene, cart.name, "position", cart.position) for cart in scene.carts],
        [exact(cart.velocity) for cart in scene.carts],
        [_gap(scene, k, wide=wide) for k in range(len(scene.gaps))],
        loads(scene, masses),
    )


def _half(scene: Scene, name: str, key: str) -> Fraction:
    return scene.tolerances.get(f"{name}.{key}", Fraction(0))


def _number(scene: Scene, name: str, key: str, value: float) -> Ball:
    half = _half(scene, name, key)
    middle = Fraction(value)
    return exact(value) if half == 0 else between(middle - half, middle + half)


def _gap(scene: Scene, k: int, *, wide: bool) -> Ball:
    if scene.contacts[k] is None:
        return arb(0)
    given = Fraction(scene.gaps[k])
    low = high = given
    if wide and given != 0:
        other = _from_places(scene, k)
        low, high = min(given, other), max(given, other)
    half = Fraction(0)
    for cart in scene.carts[max(k - 1, 0) : k + 1]:
        half += _half(scene, cart.name, "position") + _half(scene, cart.name, "length") / 2
    if k == len(scene.carts):
        half += _half(scene, "track", "length")
    return between(low - half, high + half)


def _from_places(scene: Scene, k: int) -> Fraction:
    """The gap of the places as doubles, exactly."""
    edges = [
        (
            Fraction(c.position) - Fraction(c.length) / 2,
            Fraction(c.position) + Fraction(c.length) / 2,
        )
        for c in scene.carts
    ]
    left = edges[k - 1][1] if k > 0 else Fraction(0)
    right = edges[k][0] if k < len(edges) else Fraction(scene.track.length or 0.0)
    return right - left
