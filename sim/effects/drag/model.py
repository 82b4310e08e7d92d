"""drag, in the program in plain Python."""

from __future__ import annotations

import math

from sim.effects.plain_model import Piece, Row
from sim.effects.where import carts_of
from sim.scene.effects import Effect
from sim.scene.model import Scene


def _rows(effect: Effect, scene: Scene) -> list[Row]:
    n = effect.numbers
    return [(i, n["linear"], n["quadratic"]) for i in carts_of(effect, scene)]


def _shortest(effect: Effect, scene: Scene) -> float:
    """In which the lightest cart would lose the speed that the fastest one has at the start."""
    n, carts = effect.numbers, [scene.carts[i] for i in carts_of(effect, scene)]
    fastest = max(abs(cart.velocity) for cart in scene.carts)
    held = n["linear"] + n["quadratic"] * fastest
    return min(cart.mass for cart in carts) / held if held else math.inf


PIECE = Piece(
    name="drags",
    says="cart, drag per speed, drag per speed squared",
    rows=_rows,
    force="""\
    for i, linear, quadratic in drags:
        force[i] -= linear * v[i] + quadratic * v[i] * abs(v[i])
""",
    shortest=_shortest,
)
