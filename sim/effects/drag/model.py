"""drag, in the program in plain Python."""

from __future__ import annotations

from sim.effects.plain_model import Piece, Row
from sim.effects.where import carts_of
from sim.scene.effects import Effect
from sim.scene.model import Scene


def _rows(effect: Effect, scene: Scene) -> list[Row]:
    n = effect.numbers
    return [(i, n["linear"], n["quadratic"]) for i in carts_of(effect, scene)]


PIECE = Piece(
    name="drags",
    says="cart, drag per speed, drag per speed squared",
    rows=_rows,
    force="""\
    for i, linear, quadratic in drags:
        force[i] -= linear * v[i] + quadratic * v[i] * abs(v[i])
""",
)
