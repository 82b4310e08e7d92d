"""release, in the program in plain Python."""

from __future__ import annotations

from sim.effects.plain_model import Piece, Row
from sim.effects.where import pair_of
from sim.scene.effects import Effect
from sim.scene.model import Scene


def _rows(effect: Effect, scene: Scene) -> list[Row]:
    n = effect.numbers
    return [(n["at"], *pair_of(effect, scene), n["energy"])]


PIECE = Piece(
    name="releases",
    says="when, left, right, energy in J",
    rows=_rows,
    after="""\
    for when, left, right, energy in releases:
        k = [row[:2] for row in contacts].index((left, right))
        if t - dt <= when < t and gap(left, right) < 1e-6:
            stuck.discard(k)
            s = -approach(left, right)
            more = sqrt(s * s + 2 * energy * light(left, right)) - s
            kick(left, right, more / light(left, right))


for k, (left, right, *_) in enumerate(contacts):  # a latch holds what is to be released
    latched = any((left, right) == (a, b) for _, a, b, _ in releases)
    if latched and gap(left, right) <= 1e-12 and approach(left, right) == 0:
        stuck.add(k)
""",
    joins=True,
)
