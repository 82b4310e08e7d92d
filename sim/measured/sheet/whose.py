"""Whose place or force a column holds, where its head is all that says so: x_A, “Force on B”.

More ways of writing than in sim.measured.sheet.heads, for what has no unit of velocity beside it.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from sim.measured.sheet.heads import SIDEWAYS, WORDS, longest_first, owner, quantity_of
from sim.measured.units import kind_of_unit

_LOWER = "a-zà-ÿа-я"
_FORCE_WORD = re.compile(
    rf"(?<![^\W_])(?:force|kraft|fuerza|forza|força|daya|сила|力)(?-i:(?![{_LOWER}]))", re.I
)
_ON_ONE = re.compile(r"(?<![^\W_])(?:on|auf|sur|sobre|pada)\s+(?P<who>\w{1,12})", re.I)
_OF = re.compile(r"[\s_.,:-]*(?:(?:of|von|de|ch)\s+)?", re.I)
_F = re.compile(
    r"(?:(?P<before>.{1,24}?)[\s_.,:-]+)?"
    r"f(?:[\s_.,:-]+(?P<who>[a-z0-9]{1,8})|(?P<glued>[a-z]?\d{1,2}|[a-z]))?",
    re.I,
)
_POSITION = re.compile(
    r"(?:position|place|pos|ort|x)[\s_.:-]*(?:of\s+)?(?P<behind>[a-z0-9]{0,8})"
    r"|(?P<before>[a-z][a-z0-9]{0,8})[\s_.-]+(?:position|pos|x)|(?P<point>p\d{1,2})x"
    r"|(?P<long>.{1,24}?)(?:[\s_.,:-]+(?:position|place|pos|ort)|:\s*[xs])",
    re.I,
)
_NOT_POSITION = re.compile(r"xx|x\W?(speed|vel)", re.I)
_VELOCITY_WORD = re.compile(
    rf"(?<![^\W_])(?:{longest_first(WORDS['vel'])}|{longest_first(WORDS['acc'])})"
    rf"(?-i:(?![{_LOWER}]))",
    re.I,
)
_VELOCITY_LETTER = re.compile(r"v[\s_.-]\w{1,12}|a_\w{1,12}|[vV]\d{1,2}|v[A-Z]|.+[\s_:.]v|v_\{x\}")
_NO_PLACE_OF_TRACKS = re.compile(
    r"[vapLKθωα]|[θωα]_\{[rva]\}|[vap]_\{[xy]\}|pixel_?\{?[xy]\}?|step|frame"
)
"""What Tracker offers beside x, y and r, as its tables name it: speeds without a sign too."""


def force_on(name: str) -> str | None:
    """The cart that a force acts on, "" where the head does not say; None: it is no force."""
    if word := _FORCE_WORD.search(name):
        if one := _ON_ONE.search(name):
            return one["who"]
        behind = _OF.sub("", name[word.end() :], count=1).strip(" _.,:-")
        return behind or owner(name[: word.start()].strip(" _.,:-")) or ""
    if not (match := _F.fullmatch(name)):
        return None
    return match["who"] or match["glued"] or owner(match["before"] or "") or ""


def is_force(name: str, unit: str) -> bool:
    """Whether a column holds forces, by its name or its unit."""
    return force_on(name) is not None or kind_of_unit(unit) == "force"


def place_of(name: str) -> str | None:
    """The cart whose place it is, "" where the head does not say; None: it is no place."""
    match = _POSITION.fullmatch(name)
    if not match or _NOT_POSITION.match(name):
        return None
    if match["behind"] is not None:
        return match["behind"]
    whose = owner(match["before"] or match["point"] or match["long"])
    return None if whose is None or whose.lower() in SIDEWAYS else whose


def are_velocities(names: Sequence[str]) -> bool:
    """Whether heads without a unit are velocities or accelerations: one names it, or all have its
    letter, which alone may be a cart's."""
    words = any(_VELOCITY_WORD.search(name) for name in names)
    return words or all(_VELOCITY_LETTER.fullmatch(name) for name in names)


def no_place_of_tracks(names: Sequence[str]) -> bool:
    """Whether heads under names of tracks are quantities of Tracker that are no places."""
    return all(_NO_PLACE_OF_TRACKS.fullmatch(name) for name in names)


def is_named(name: str, unit: str, track: str) -> bool:
    """Whether anything says whose this column is, its track or its head."""
    return bool(track) or _whose(name, unit) != ""


def _whose(name: str, unit: str) -> str | None:
    """The cart that a column is of; "" and None where its head does not say."""
    whose = place_of(name)
    whose = force_on(name) if whose is None else whose
    if whose is None:
        what, told = quantity_of(name, unit if kind_of_unit(unit) == "length" else "")
        whose = told if what == "pos" and told else None
    return whose


def cart_names(heads: Sequence[tuple[str, str, str]]) -> list[str]:
    """What the carts are called: by their track, by their column, or A and B. `heads`: name, unit
    and track of each column."""
    found = []
    for name, unit, track in heads:
        whose = _whose(name, unit)
        found.append((track or (name if whose is None else whose)).strip())
    if (
        len(found) == 2
        and found.count("2") == 1
        and not any(one[:1].isdecimal() for one in found if one != "2")
    ):
        return ["1", "2"] if found[1] == "2" else ["2", "1"]  # “Force” and “Force 2”
    found = [name or "AB"[k] for k, name in enumerate(found)]
    if len(found) == 2 and found[0] == found[1]:
        found = [f"{name} {k}" for k, name in enumerate(found, 1)]
    return found
