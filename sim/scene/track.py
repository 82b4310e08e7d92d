"""The track: how long it is, which of its ends are open, and what stands at the others.

A wall, or something that is named and drawn in its place. The motion does not know what it is: how
hard it is and how far it gives way, the contact says.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from sim.scene.fields import TRACK_LENGTH
from sim.scene.model import Track
from sim.scene.problem import Problem, did_you_mean
from sim.scene.said import said, template
from sim.scene.tables import mapping, number, unknown_keys

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

HINT = "track: {length: 2.4 m, left: open, right: wall}"
NAMED = tuple(f"{side}_is" for side in SIDES)
KEYS = (TRACK_LENGTH.key, *SIDES, *NAMED)


def read_track(value: object, problems: list[Problem]) -> tuple[Track | None, Fraction | None]:
    """The track, and its exact length in m; None and problems where it makes no sense."""
    table = mapping(value, ("track",), problems, HINT)
    if table is None:
        return None, None
    before = len(problems)
    unknown_keys(table, KEYS, ("track",), problems)
    for side in SIDES:
        if table.get(side, OPEN) not in (OPEN, WALL):
            told = f"{side} must be open or wall (got {table[side]})"
            hint = did_you_mean(table[side], (OPEN, WALL), HINT)
            problems.append(Problem(("track", side), "not-a-choice", told, hint))
        elif f"{side}_is" in table:
            _check_named(side, table, problems)
    length = number(TRACK_LENGTH, table, ("track",), problems)
    if table.get("right") == WALL and length is None and len(problems) == before:
        told = "a wall on the right needs the track's length"
        problems.append(Problem(("track",), "missing", told, HINT))
    if len(problems) > before:
        return None, None
    return Track(
        left=table.get("left", OPEN),
        right=table.get("right", OPEN),
        length=None if length is None else float(length),
        left_is=table.get("left_is", WALL),
        right_is=table.get("right_is", WALL),
    ), length


def _check_named(side: str, table: Mapping[str, Any], problems: list[Problem]) -> None:
    """What stands at an end has a name that is known, and there is something that stands there."""
    key = f"{side}_is"
    what = table[key]
    if what not in WHAT:
        told = f"{key} must be {', '.join(WHAT[:-1])} or {WHAT[-1]} (got {str(what)[:40]})"
        hint = did_you_mean(what, WHAT, f"track: {{right: wall, {key}: foam}}")
        problems.append(Problem(("track", key), "not-a-choice", told, hint))
    elif table.get(side, OPEN) != WALL:
        told = f"{key} says what stands on the {side}, but the track is open there"
        hint = f"track: {{length: 2.4 m, {side}: wall, {key}: {what}}}, or remove {key}"
        problems.append(Problem(("track", key), "no-wall", told, hint))


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
    """A cart is called by its name; the two ends of the track have words of their own. The only
    wall needs no side."""
    if thing := thing_at(name, track):
        return thing
    if name in SIDES and _walls(track) < len(SIDES):
        return said("the wall")
    walls = {"left": said("the left wall"), "right": said("the right wall")}
    return walls.get(name, name)


def _walls(track: Track) -> int:
    """How many ends are walls, by that name."""
    kinds = {"left": track.left, "right": track.right}
    return sum(kinds[side] == WALL == what_is(side, track) for side in SIDES)
