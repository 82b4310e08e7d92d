"""push, in the program in plain Python."""

from __future__ import annotations

from sim.effects.plain_model import Piece, Row
from sim.effects.where import carts_of
from sim.scene.effects import Effect
from sim.scene.model import Scene


def _rows(effect: Effect, scene: Scene) -> list[Row]:
    n = effect.numbers
    (cart,) = carts_of(effect, scene)
    return [(cart, n["force"], n["from"], n.get("until", scene.until))]


PIECE = Piece(
    name="pushes",
    says="cart, force in N, from when to when",
    rows=_rows,
    force="""\
    for i, size, start, stop in pushes:
        pushed = min(stop, t + dt) - max(start, t)  # s of this step
        force[i] += size * max(pushed, 0.0) / dt
""",
)
