"""What a law may ask for. A function names what it wants, and gets that and nothing else.

    def force(overlap, rate, mass_self, mass_other): ...

It is asked once for each of the two bodies (a wall is not asked), at every instant at which they
overlap, and answers with the force in N on the body that asks (`self`): positive away from the
other one. A law that must not care who asks simply does not ask for it.
"""

from __future__ import annotations

from collections.abc import Mapping

ARGUMENTS: Mapping[str, str] = {
    "overlap": "m, how far the two are pressed into each other, never below 0",
    "rate": "m/s, how fast the overlap grows; below 0 while they move apart",
    "mass_self": "kg, of the body that asks",
    "mass_other": "kg, of the other body; inf for a wall",
    "reduced_mass": "kg, of the pair; at a wall the mass of the cart",
    "velocity_self": "m/s, of the body that asks; + is to the right",
    "velocity_other": "m/s, of the other body",
    "time": "s, since the start of the run",
    "stiffness": "the number of that name in the scene's contact",
    "restitution": "the number of that name in the scene's contact",
    "name_self": "the name of the body that asks, a text",
    "name_other": "the name of the other body",
    "side": 'where the body that asks stands: "left" or "right" of the other',
}
"""Names of arguments, with their unit and what they are; numbers are in SI."""

PLACES = {name: place for place, name in enumerate(ARGUMENTS)}
"""Where each stands in the row of values that a pair makes for one side."""
