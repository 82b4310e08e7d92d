"""spring, in the program in plain Python."""

from __future__ import annotations

import math

from sim.effects.plain_model import Piece, Row
from sim.effects.where import pair_of
from sim.scene.effects import Effect
from sim.scene.model import Scene


def _rows(effect: Effect, scene: Scene) -> list[Row]:
    n = effect.numbers
    return [(*pair_of(effect, scene), n["stiffness"], n["length"], n["damping"])]


def _shortest(effect: Effect, scene: Scene) -> float:
    """A quarter swing of the lightest two, or in which their damper takes their speed."""
    half, n = min(cart.mass for cart in scene.carts) / 2, effect.numbers
    swing = 0.5 * math.pi * math.sqrt(half / n["stiffness"])
    return min(swing, half / n["damping"]) if n["damping"] else swing


PIECE = Piece(
    name="springs",
    says="left, right, stiffness, natural length, damping",
    rows=_rows,
    force="""\
    for left, right, stiffness, length, damping in springs:
        pull = stiffness * (gap(left, right) - length) - damping * approach(left, right)
        push_apart(force, left, right, -pull)
""",
    shortest=_shortest,
)
