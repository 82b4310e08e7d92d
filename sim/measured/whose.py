"""Whose place or force a column holds, where its head is all that says so: x_A, “Force on B”.

More ways of writing than in sim.measured.heads, for what has no unit of velocity beside it.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from sim.measured.heads import SIDEWAYS, WORDS, longest_first, owner, quantity_of
from sim.measured.table import Column

_FORCE_WORD = re.compile(
    r"(?<![^\W_])(?:force|kraft|fuerza|forza|força|daya|сила|力)(?-i:(?![a-zà-ÿа-я]))", re.I
)
_FORCE = re.compile(
    r"(?:.*\W)?f(?:[\s_.-]+(?P<who>[a-z0-9]{1,8})|(?P<glued>[a-z]?\d{1,2}|[a-z]))?", re.I
)
_ON = re.compile(r"[\s_.,:-]*(?:(?:on|of|auf|von|sur|de|sobre|en|pada|ch)\s+)?", re.I)
_POSITION = re.compile(
    r"(?:position|place|pos|ort|x)[\s_.-]*(?:of\s+)?(?P<behind>[a-z0-9]{0,8})"
    r"|(?P<before>[a-z][a-z0-9]{0,8})[\s_.-]+(?:position|pos|x)"
    r"|(?P<long>.{1,24}?)(?:[\s_.,:-]+(?:position|place|pos|ort)|:\s*x)",
    re.I,
)
_NOT_POSITION = re.compile(r"xx|x\W?(speed|vel)", re.I)
_VELOCITY = re.compile(
    rf"(?:{longest_first(WORDS['vel'])}|{longest_first(WORDS['acc'])})[\s_.,-]+\w{{1,12}}"
    r"|(?-i:v[\s_.-]\w{1,12}|a_\w{1,12}|v\d{1,2})",
    re.I,
)


def force_on(name: str) -> str | None:
    """The cart that a force acts on, "" where the head does not say; None: it is no force."""
    if word := _FORCE_WORD.search(name):
        return _ON.sub("", name[word.end() :], count=1).strip(" _.,:-")
    match = _FORCE.fullmatch(name)
    return (match["who"] or match["glued"] or "") if match else None


def place_of(name: str) -> str | None:
    """The cart whose place it is, "" where the head does not say; None: it is no place."""
    match = _POSITION.fullmatch(name)
    if not match or _NOT_POSITION.match(name):
        return None
    if match["behind"] is not None:
        return match["behind"]
    whose = owner(match["before"] or match["long"])
    return None if whose is None or whose.lower() in SIDEWAYS else whose


def is_velocity(name: str) -> bool:
    """Whether a head without a unit can be nothing but a velocity or an acceleration of a cart."""
    return _VELOCITY.fullmatch(name) is not None


def cart_names(columns: Sequence[Column]) -> list[str]:
    """What the carts are called: by their track, by their column, or A and B."""
    found = []
    for column in columns:
        whose = place_of(column.name)
        whose = force_on(column.name) if whose is None else whose
        if whose is None:
            what, whose = quantity_of(column.name, "")
            whose = whose if what == "pos" else column.name
        found.append((column.track or whose).strip())
    if sorted(found) == ["", "2"]:
        return ["1", "2"]  # “Force” and “Force 2”
    found = [name or "AB"[k] for k, name in enumerate(found)]
    if len(found) == 2 and found[0] == found[1]:
        found = [f"{name} {k}" for k, name in enumerate(found, 1)]
    return found
