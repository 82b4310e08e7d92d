"""Reading tables of keys: the checks that every part of a description shares."""

from __future__ import annotations

import re
from collections.abc import Mapping
from fractions import Fraction
from itertools import pairwise
from typing import Any

from sim.scene.fields import Field
from sim.scene.problem import Path, Problem, did_you_mean, meant, nearest
from sim.scene.quantity import exact

_NO_KEY = re.compile(r"[\s.!?…’'A-Z]")
_AFTER_COMMA = re.compile(r"\d+(\s?[^\s\d].*)?")
"""What {mass: 0,5 kg} leaves behind: a key “5 kg” without a value."""
_WHOLE = re.compile(r"[-−+]?\d+")
_EQUALS = re.compile(r"([\w.-]+)\s*=\s*(.+)")


def mapping(
    value: object, path: Path, problems: list[Problem], hint: str
) -> Mapping[str, Any] | None:
    """`value` if it is a table of keys, else None and a problem."""
    if isinstance(value, Mapping):
        return value
    a_list = isinstance(value, (list, tuple))
    shown = "nothing" if value is None else "a list" if a_list else f"“{str(value)[:40]}”"
    problems.append(Problem(path, "not-a-table", f"expected keys here, found {shown}", hint))
    return None


def unknown_keys(
    table: Mapping[str, Any],
    known: tuple[str, ...],
    path: Path,
    problems: list[Problem],
    *,
    a_list: str = "",
    elsewhere: Mapping[str, str] | None = None,
) -> None:
    """One problem for each key of `table` that is not in `known`. `a_list`: the one key whose list
    is missing: an unknown list is meant to be that one, whatever it is called. `elsewhere`: hints
    for what is said in another way here."""
    empty = ""  # the known key above that has nothing: what belongs below it may stand too far left
    for key in table:
        if key in known:
            empty = key if table[key] is None else ""
            continue
        if _is_after_comma(key, table):
            problems.append(_decimal_comma(key, table, path))
        else:
            listed = f"known keys: {', '.join(known)}"
            home = empty or _home_of(table[key], table, known)
            further = f"what belongs to “{home}:” begins two spaces further right"
            hint = (elsewhere or {}).get(key) or did_you_mean(
                key, known, further if home else listed
            )
            if a_list and isinstance(table[key], (list, tuple)):
                hint = meant(a_list)
            if (cut := _cut_text(key, table)) and not nearest(key, known):
                hint = f"a text with a comma in it goes in quotes: {cut}"
            if ":" in str(key):
                hint = f"write a space after the colon: {str(key).replace(':', ': ', 1)}"
            if wrote := _EQUALS.fullmatch(str(key)):
                hint = f"write a colon and a space: {wrote[1]}: {wrote[2]}"
            problems.append(Problem((*path, key), "unknown-key", f"unknown key “{key}”", hint))


def _decimal_comma(rest: str, table: Mapping[str, Any], path: Path) -> Problem:
    """Of the number that a comma cut in two, at its own key; of what is none, where the rest is."""
    code, said_of = "decimal-comma", "a comma begins the next key here"
    key = next(one for one, then in pairwise((None, *table)) if then == rest)
    whole = "" if key is None else str(table[key])
    if not _WHOLE.fullmatch(whole):
        hint = "write decimals with a point: 0.5 kg"
        return Problem((*path, rest), code, f"“,{rest}”: {said_of}", hint)
    hint = f"write a point for the decimals: {key}: {whole}.{rest}"
    return Problem((*path, str(key)), code, f"“{whole},{rest}”: {said_of}", hint)


def _cut_by_comma(key: str, table: Mapping[str, Any]) -> bool:
    """Whether the value of `key` is only what stood before a decimal comma: {mass: 0,5 kg}."""
    return any(one == key and _is_after_comma(then, table) for one, then in pairwise(table))


def _cut_text(key: str, table: Mapping[str, Any]) -> str:
    """The text that a comma before `key` cut in two, whole and in quotes: {text: No, never.}; "":
    it is a key. A key is one word of small letters."""
    for one, then in pairwise(table):
        if then == key and table[then] is None and isinstance(table[one], str):
            told = one == "text" or _NO_KEY.search(str(then))
            return f'{one}: "{table[one]}, {then}"' if told else ""
    return ""


def _is_after_comma(key: str, table: Mapping[str, Any]) -> bool:
    return table[key] is None and _AFTER_COMMA.fullmatch(str(key)) is not None


def _home_of(entry: Any, table: Mapping[str, Any], known: tuple[str, ...]) -> str:
    """The known key above whose entries look like this one, which stands beside it; "": none."""
    if not isinstance(entry, Mapping):
        return ""
    for key in known:
        inside = table.get(key)
        if isinstance(inside, Mapping) and any(
            isinstance(other, Mapping) and other.keys() & entry.keys() for other in inside.values()
        ):
            return key
    return ""


def number(
    field: Field, table: Mapping[str, Any], path: Path, problems: list[Problem]
) -> Fraction | None:
    """The field's exact value in `table`, its default, or None and a problem (optional: None)."""
    value = table.get(field.key)
    if _cut_by_comma(field.key, table):
        return None  # what was left over is told as an unknown key
    if value is None:
        if field.key in table:
            problems.append(
                Problem(
                    (*path, field.key),
                    "missing",
                    f"{field.key} has no value",
                    f"for example {field.key}: {field.dimension.example}",
                )
            )
            return None
        if field.default is not None:
            return exact(field.default)
        if not field.optional:
            problems.append(
                Problem(
                    path,
                    "missing",
                    f"{field.key} is missing",
                    f"for example {field.key}: {field.dimension.example}",
                )
            )
        return None
    result = field.read(value, (*path, field.key))
    if isinstance(result, Problem):
        problems.append(result)
        return None
    return result
