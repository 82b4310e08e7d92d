"""incline, in the program in plain Python."""

from __future__ import annotations

import math

from sim.effects.plain_model import Piece, Row
from sim.effects.where import carts_of
from sim.scene.effects import Effect
from sim.scene.model import Scene


def _rows(effect: Effect, scene: Scene) -> list[Row]:
    n = effect.numbers
    return [(i, scene.gravity * math.sin(n["angle"])) for i in carts_of(effect, scene)]


PIECE = Piece(
    name="slopes",
    says="cart, acceleration down the slope in m/s²",
    rows=_rows,
    force="""\
    for i, a in slopes:
        force[i] += mass[i] * a
""",
)
