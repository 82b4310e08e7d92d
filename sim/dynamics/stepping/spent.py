"""Bumpers that a release has parted while they overlap: they push no more until pressed again.

What they held is warm then (`sim/effects/release`). They are silent while their overlap d [m] falls
towards the one at which they would rest; pressed again before that, they get back what they hold.
"""

from __future__ import annotations

from sim.dynamics.stepping.field import Field
from sim.dynamics.stepping.pairs import Pair, PerCart
from sim.laws.lookup import contact_law


def part(field: Field, pair: Pair, s: PerCart, v: PerCart) -> float:
    """From now on they are silent; returns J that they held, and keep."""
    d, rate = field.overlap(pair, s, v)
    if pair.force is None or d <= 0.0:
        return 0.0
    field.spent.add(pair.gap)
    return stored(pair, d, rate, field.memory[pair.gap])


def reserves(field: Field, pair: Pair, s: PerCart, v: PerCart) -> tuple[float, float]:
    """m/s and m, both positive while they are silent: how fast they open, and how far they may."""
    law = contact_law(pair.contact)
    d, rate = field.overlap(pair, s, v)
    rest = 0.0 if law is None else law.resting_overlap(field.memory[pair.gap])
    return -rate, d - rest


def end(field: Field, pair: Pair, s: PerCart, v: PerCart, *, pressed: bool) -> float:
    """They push as ever again, `pressed` or at no overlap; returns J that they get back."""
    field.spent.discard(pair.gap)
    d, rate = field.overlap(pair, s, v)
    return stored(pair, d, rate, field.memory[pair.gap]) if pressed else 0.0


def stored(pair: Pair, d: float, rate: float, memory: float) -> float:
    """J that a contact would give back."""
    law = contact_law(pair.contact)
    return law.stored(d, rate, memory) if law is not None and d > 0.0 else 0.0
