"""A key of a fence that takes one of some words, or a list of them."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any, TypeGuard

from sim.scene.problem import Problem, did_you_mean, meant, nearest

QUANTITIES = {
    "position": "x", "place": "x", "velocity": "v", "speed": "v", "acceleration": "a", "force": "F",
    "resultant": "R", "net force": "R", "momentum": "p", "forces": "F", "kinetic energy": "energy",
}  # fmt: skip
"""What authors write out of what SHOWS names by a letter."""


def choice(
    key: str, table: Mapping[str, Any], allowed: tuple[str, ...], problems: list[Problem]
) -> str:
    """One of the allowed words, the first where nothing is said."""
    value = table.get(key, allowed[0])
    if value not in allowed:
        hint = did_you_mean(value, allowed, f"{key}: {allowed[0]}")
        problems.append(Problem((key,), "not-a-choice", f"{key} is {' or '.join(allowed)}", hint))
    return str(value)


def choices(
    key: str,
    table: Mapping[str, Any],
    default: tuple[str, ...],
    allowed: tuple[str, ...],
    problems: list[Problem],
) -> tuple[str, ...]:
    """Some of the allowed words, each once; the default where nothing is said."""
    value = table.get(key, default)
    listed = value if _is_list(value) else [] if value is None else [value]
    strange = [item for item in listed if item not in allowed]
    if strange or not _is_list(value):
        found = f" (got {', '.join(map(str, strange))})" if strange else ""
        problems.append(
            Problem(
                (key,),
                "not-a-choice",
                f"{key} is a list of {', '.join(allowed)}{found}",
                _meant(key, value, allowed),
            )
        )
        return ()
    return tuple(dict.fromkeys(map(str, value)))


def _meant(key: str, value: object, allowed: tuple[str, ...]) -> str:
    """How a list should look; of a misspelt word, which one was meant, and of several each."""
    written_out = QUANTITIES if key == "show" else {}
    known = (*allowed, *written_out)
    listed = [str(item) for item in value] if _is_list(value) else _apart(value, known)
    close = {item: nearest(item, known) for item in listed}
    right = {item: written_out.get(one, one) for item, one in close.items() if one}
    wrong = [item for item, one in right.items() if item != one]
    if not right or (not wrong and None in close.values()):
        return f"{key}: [{', '.join(allowed[:2])}]"
    if len(wrong) == 1 and (_is_list(value) or len(listed) == 1):
        return meant(right[wrong[0]])
    told = ", ".join(f"{item} is {right[item]}" for item in wrong)
    return f"{told}{': ' * bool(told)}{key}: [{', '.join(dict.fromkeys(right.values()))}]"


def _apart(value: object, known: tuple[str, ...]) -> list[str]:
    """The words of a list that lacks its brackets."""
    parts = re.split(r"\s*[,;]\s*(?:and\s+)?|\s+and\s+", "" if value is None else str(value))
    return [word for part in parts for word in ([part] if part in known else part.split())]


def _is_list(value: object) -> TypeGuard[Sequence[object]]:
    return isinstance(value, (list, tuple))
