"""own-mass-own-force: the force on a thing goes with its own mass.

    N_on_A : N_on_B = m_A : m_B        their mean is the push N of the contact law

So both change their velocity by the same amount, whatever they are.
"""

from __future__ import annotations

from sim.scene.said import template
from sim.worlds.describe import WorldKind
from sim.worlds.force import Impossible, Two, parts

KIND = WorldKind(
    name="own-mass-own-force",
    belief="own-mass-own-force",
    says=template("the heavier one feels the larger force"),
    nothing=template(
        "With these values nothing breaks: the two are alike, or never push each other. "
        "Change a mass or a velocity."
    ),
    place=20,
    needs="pair",
)


class OwnMassOwnForce(Impossible):
    """The push on each goes with its own mass."""

    def shares(self, masses: Two, v: Two, outside: Two) -> Two:
        """(m_A, m_B), 1 on average."""
        return parts(masses[0], masses[1])


act = OwnMassOwnForce
