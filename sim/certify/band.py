"""What tolerances allow: inputs cut into pieces, and their certificates put together again.

A ball forgets that two numbers depend on the same third one: m₁/(m₁ + m₂) for a tolerant m₁ seems
to take both masses as they like. In a piece of the tolerance n times as narrow, what is made up by
that is about n times as small, and the truth still lies in one of the pieces.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

from sim.certify.numbers.balls import Ball

Spans = dict[str, tuple[Fraction, Fraction]]
"""By `cart.key`: how far an input may be from the scene's number, at least and at most, in SI."""

MOST_PIECES = 32
"""Runs in place of one. Where n inputs are tolerant, each is cut into the n-th root of it."""

State = tuple[list[Ball], list[Ball]]
"""Of every cart from left to right: place [m] and velocity [m/s]."""

Seen = dict[float, State]
"""At a time [s]. Within an event's own time: what holds whether it has happened or not."""


def pieces(tolerances: Mapping[str, Fraction]) -> Iterator[Spans]:
    """All of what the inputs allow, piece by piece; of exact inputs one, with nothing in it."""
    each = max(1, int(MOST_PIECES ** (1 / len(tolerances)))) if tolerances else 1
    cuts = [
        [(half * (2 * k - each) / each, half * (2 * k + 2 - each) / each) for k in range(each)]
        for half in tolerances.values()
    ]
    for chosen in itertools.product(*cuts):
        yield dict(zip(tolerances, chosen, strict=True))


def united(many: Sequence[Ball]) -> Ball:
    """The smallest ball around all of them."""
    whole = many[0]
    for one in many[1:]:
        whole = whole.union(one)
    return whole


def united_states(many: Sequence[State]) -> State:
    """Around all of them, cart by cart."""
    places, speeds = (
        [united(balls) for balls in zip(*(one[which] for one in many), strict=True)]
        for which in (0, 1)
    )
    return places, speeds


def united_seen(many: Sequence[Seen]) -> Seen:
    """Where every piece is known."""
    return {
        t: united_states([one[t] for one in many]) for t in many[0] if all(t in one for one in many)
    }
