"""magnets, in the program in plain Python."""

from __future__ import annotations

import math

from sim.effects.magnets.force import MagnetForce
from sim.effects.plain_model import Piece, Row
from sim.effects.where import gap_of, pair_of
from sim.scene.effects import Effect
from sim.scene.model import Scene

NEAREST = "1e-6"
"""m, as the program writes it. Where one of its steps went through the gap, or nearly, the force is
that of this gap: finite, and large enough to part the two again."""


def _rows(effect: Effect, scene: Scene) -> list[Row]:
    n = effect.numbers
    return [(*pair_of(effect, scene), n["strength"], n["power"])]


def _shortest(effect: Effect, scene: Scene) -> float:
    """A quarter swing, 1/w² = mu/steepest, where the fastest two of the start turn round."""
    n, strength = effect.numbers["power"], effect.numbers["strength"]
    bodies = [scene.carts[i] for i in pair_of(effect, scene) if i is not None]
    mu = 1.0 / math.fsum(1.0 / body.mass for body in bodies)
    speeds = [0.0, *(cart.velocity for cart in scene.carts)]
    in_play = 0.5 * mu * (max(speeds) - min(speeds)) ** 2 / strength  # of C
    room = scene.gaps[gap_of(effect, scene)]
    if n == 1:
        nearest = room * math.exp(-in_play)
    else:
        nearest = room * (1.0 + (n - 1) * in_play * room ** (n - 1)) ** (1 / (1 - n))
    steepest, _ = MagnetForce(strength, n, 0.0).bounds(max(nearest, float(NEAREST)))
    return 0.5 * math.pi * math.sqrt(mu / steepest)


PIECE = Piece(
    name="magnets",
    says="left, right, strength C, power n",
    rows=_rows,
    force=f"""\
    for left, right, strength, power in magnets:
        push_apart(force, left, right, strength / max(gap(left, right), {NEAREST}) ** power)
""",
    shortest=_shortest,
)
