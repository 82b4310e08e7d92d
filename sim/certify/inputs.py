"""What a certificate takes for given: the scene's doubles, or what their tolerances allow.

A gap stands in a scene twice: rounded once from the decimals, and as the difference of places that
are doubles themselves. `wide` takes both and what is between, which costs an ulp or two and holds
either reading; where that leaves the order of events open, the gap of the scene alone is taken, so
that what touches on paper touches here.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from sim.certify.band import Spans
from sim.certify.loads import Burst, Load, bursts, loads, springs
from sim.certify.numbers.arithmetic import arb
from sim.certify.numbers.balls import Ball, between, exact
from sim.certify.oscillation import Line
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
    springs: dict[int, list[Line]]
    bursts: list[Burst]


NOTHING = (Fraction(0), Fraction(0))


def inputs(scene: Scene, spans: Spans, *, wide: bool) -> Inputs:
    """Read a scene; raises NotProvableError where an effect has no bound."""
    masses = [_number(spans, cart.name, "mass", cart.mass) for cart in scene.carts]
    return Inputs(
        scene,
        masses,
        [_number(spans, cart.name, "position", cart.position) for cart in scene.carts],
        [exact(cart.velocity) for cart in scene.carts],
        [_gap(scene, spans, k, wide=wide) for k in range(len(scene.gaps))],
        loads(scene, masses),
        springs(scene),
        bursts(scene),
    )


def _number(spans: Spans, name: str, key: str, value: float) -> Ball:
    low, high = spans.get(f"{name}.{key}", NOTHING)
    middle = Fraction(value)
    return exact(value) if low == high == 0 else between(middle + low, middle + high)


def _gap(scene: Scene, spans: Spans, k: int, *, wide: bool) -> Ball:
    if scene.contacts[k] is None:
        return arb(0)
    given = Fraction(scene.gaps[k])
    low = high = given
    if wide and given != 0:
        other = _from_places(scene, k)
        low, high = min(given, other), max(given, other)
    edges = [("track.length", Fraction(1))] if k == len(scene.carts) else []
    for place, cart in enumerate(scene.carts[max(k - 1, 0) : k + 1]):
        to_the_left = k > 0 and place == 0
        edges.append((f"{cart.name}.position", Fraction(-1 if to_the_left else 1)))
        edges.append((f"{cart.name}.length", Fraction(-1, 2)))
    for key, factor in edges:  # the gap grows by so much of what an input grows
        ends = sorted(factor * end for end in spans.get(key, NOTHING))
        low, high = low + ends[0], high + ends[1]
    return between(low, high)


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
