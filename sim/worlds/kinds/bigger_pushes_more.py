"""bigger-pushes-more: of two that push each other the heavier one pushes harder.

    N_on_A : N_on_B = m_B : m_A        their mean is the push N of the contact law

The push on the light one is as many times larger as the other is heavier.
"""

from __future__ import annotations

from sim.scene.said import template
from sim.worlds.describe import WorldKind
from sim.worlds.force import Impossible, Two, parts

KIND = WorldKind(
    name="bigger-pushes-more",
    belief="bigger-pushes-more",
    says=template("the heavier one pushes harder"),
    nothing=template(
        "With these values nothing breaks: the two are alike, or never push each other. "
        "Change a mass or a velocity."
    ),
    place=10,
    needs="pair",
)


class BiggerPushesMore(Impossible):
    """The push on each goes with the mass of the other."""

    def shares(self, masses: Two, v: Two, outside: Two) -> Two:
        """(m_B, m_A), 1 on average."""
        return parts(masses[1], masses[0])


act = BiggerPushesMore
