"""magnets, in the program in plain Python."""

from __future__ import annotations

from sim.effects.plain_model import Piece, Row
from sim.effects.where import pair_of
from sim.scene.effects import Effect
from sim.scene.model import Scene

NEAREST = "1e-6"
"""m, as the program writes it. Where one of its steps went through the gap, or nearly, the force is
that of this gap: finite, and large enough to part the two again."""


def _rows(effect: Effect, scene: Scene) -> list[Row]:
    n = effect.numbers
    return [(*pair_of(effect, scene), n["strength"], n["power"])]


PIECE = Piece(
    name="magnets",
    says="left, right, strength C, power n",
    rows=_rows,
    force=f"""\
    for left, right, strength, power in magnets:
        push_apart(force, left, right, strength / max(gap(left, right), {NEAREST}) ** power)
""",
)
