"""magnets, in the program in plain Python."""

from __future__ import annotations

from sim.effects.plain_model import Piece, Row
from sim.effects.where import pair_of
from sim.scene.effects import Effect
from sim.scene.model import Scene


def _rows(effect: Effect, scene: Scene) -> list[Row]:
    n = effect.numbers
    return [(*pair_of(effect, scene), n["strength"], n["power"])]


PIECE = Piece(
    name="magnets",
    says="left, right, strength C, power n",
    rows=_rows,
    force="""\
    for left, right, strength, power in magnets:
        push_apart(force, left, right, strength / max(gap(left, right), 1e-6) ** power)
""",
)
