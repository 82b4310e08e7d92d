"""mover-pushes-more: the one that moves, or acts, pushes harder.

    N_on_A : N_on_B = |v_B| : |v_A|    when they touch; where both stand, by what acts on each

Nothing pushes back on a cart that runs into one at rest. The law names a velocity: who moves along
sees other pushes than who stands still.
"""

from __future__ import annotations

from sim.scene.said import template
from sim.worlds.describe import WorldKind
from sim.worlds.force import Impossible, Two, parts

KIND = WorldKind(
    name="mover-pushes-more",
    belief="mover-pushes-more",
    says=template("the one that moves pushes harder"),
    nothing=template(
        "With these values nothing breaks: both are equally fast, or never push each other. "
        "Change a velocity."
    ),
    place=30,
    needs="pair",
    moves=True,
)


class MoverPushesMore(Impossible):
    """The push on each goes with how fast the other moves."""

    def shares(self, masses: Two, v: Two, outside: Two) -> Two:
        """(|v_B|, |v_A|), 1 on average."""
        if v == (0.0, 0.0):
            return parts(outside[1], outside[0])
        return parts(v[1], v[0])


act = MoverPushesMore
