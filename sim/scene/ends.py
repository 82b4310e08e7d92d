"""What stands at the ends of a track: a wall, or something that is named and drawn in its place.

The motion does not know what it is: how hard it is and how far it gives way, the contact says.
"""

from __future__ import annotations

from sim.scene.model import Track
from sim.scene.said import said, template

SIDES = ("left", "right")
"""Names of the two ends, as bodies."""

OPEN, WALL = "open", "wall"

THINGS = {
    "foam": template("the foam"),
    "spring": template("the spring"),
    "board": template("the board"),
}
WHAT = (WALL, *THINGS)
"""What an end of a track can be, by the name that an author writes."""


def what_is(side: str, track: Track) -> str:
    """By the name that an author writes."""
    return track.left_is if side == "left" else track.right_is


def named_ends(track: Track) -> dict[str, str]:
    """`left_is` and `right_is`, where something else than a wall stands there."""
    found = {f"{side}_is": what_is(side, track) for side in SIDES}
    return {key: what for key, what in found.items() if what != WALL}


def thing_at(name: str, track: Track) -> str:
    """What a sentence calls an end of the track that is no wall; "" for walls and for carts.

    Of two ends with one name each says on which side it is.
    """
    what = what_is(name, track) if name in SIDES else WALL
    if what == WALL:
        return ""
    thing = said(THINGS[what])
    if track.left_is != track.right_is:
        return thing
    if name == "left":
        return said("{thing} on the left", thing=thing)
    return said("{thing} on the right", thing=thing)


def body_name(name: str, track: Track) -> str:
    """A cart is called by its name; the two ends of the track have words of their own."""
    walls = {"left": said("the left wall"), "right": said("the right wall")}
    return thing_at(name, track) or walls.get(name, name)


def wall_or_name(name: str, track: Track) -> str:
    """The same where one wall need not be told from the other."""
    return thing_at(name, track) or (said("the wall") if name in SIDES else name)
