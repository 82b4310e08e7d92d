"""friction, in the program in plain Python."""

from __future__ import annotations

from sim.effects.friction.force import support_of
from sim.effects.plain_model import Piece, Row
from sim.effects.where import carts_of
from sim.scene.effects import Effect
from sim.scene.model import Scene


def _rows(effect: Effect, scene: Scene) -> list[Row]:
    n = effect.numbers
    low = n["coefficient"]
    high = n.get("static", low)
    presses = [(i, support_of(i, scene)) for i in carts_of(effect, scene)]
    return [(i, low * press, high * press) for i, press in presses]


PIECE = Piece(
    name="rough",
    says="cart, friction while it slides and at most at rest, in N",
    rows=_rows,
    move="""\
    before = list(v)
    for i in range(len(names)):
        if not free(i):
            continue
        carts = team(i)
        total, m = sum(force[j] for j in carts), sum(mass[j] for j in carts)
        slide = sum(kinetic for j, kinetic, static in rough if j in carts)
        hold = sum(static for j, kinetic, static in rough if j in carts)
        if before[i] == 0 and abs(total) <= hold:
            continue  # the track holds it
        way = before[i] or total
        v[i] = before[i] + (total - copysign(slide, way)) / m * dt
        if v[i] * before[i] < 0:
            v[i] = 0.0  # friction stops a cart; it does not turn it round
    for i in range(len(names)):
        x[i] += (v[i] if free(i) else 0.0) * dt
    t += dt
""",
)
