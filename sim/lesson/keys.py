"""Tables of keys: what each is called, what it means, what it holds. Validator, reference page and
JSON Schemas are made from them."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from sim.scene.problem import Path, Problem
from sim.scene.prose import PROSE, PROSES
from sim.scene.tables import mapping, unknown_keys

__all__ = ["NUMBER_OR_TEXT", "PROSE", "PROSES", "TEXT", "TEXTS", "Key"]

MOST_WHOLE = 600
"""Of minutes, marks and questions. More is a slip of the hand: a form has fewer questions, and no
lesson lasts ten hours."""

TEXT: Mapping[str, Any] = {"type": "string", "minLength": 1}
NUMBER_OR_TEXT: Mapping[str, Any] = {"type": ["number", "string"]}
TEXTS: Mapping[str, Any] = {"anyOf": [TEXT, {"type": "array", "items": TEXT}]}


def one_of(*words: str) -> Mapping[str, Any]:
    """The JSON Schema of a choice between words."""
    return {"enum": list(words)}


@dataclass(frozen=True, slots=True)
class Key:
    """One key of a block: its name, meaning, an example as an author writes it, its JSON Schema."""

    name: str
    says: str
    example: str
    schema: Mapping[str, Any] = field(default_factory=lambda: TEXT)
    required: bool = False


def names(keys: tuple[Key, ...]) -> tuple[str, ...]:
    """The names of the keys, in their order."""
    return tuple(key.name for key in keys)


def text(
    table: Mapping[str, Any], name: str, path: Path, problems: list[Problem], *, hint: str = ""
) -> str | None:
    """The text under `name`, stripped; None where there is none. A number stays as written."""
    value = table.get(name)
    if value is None and name not in table:
        return None
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return str(value)
    if isinstance(value, str) and value.strip():
        return value.strip()
    if isinstance(value, bool):
        hint = f'put the word in quotes: {name}: "{str(value).lower()}"'
    problems.append(Problem((*path, name), "not-text", f"{name} must be a text", hint))
    return None


def needed(
    table: Mapping[str, Any], name: str, path: Path, problems: list[Problem], hint: str
) -> str:
    """The text under `name`, or an empty text and a problem."""
    found = text(table, name, path, problems, hint=hint)
    if found is None and name not in table:
        problems.append(Problem(path, "missing", f"{name} is missing", hint))
    return found or ""


def tables(
    table: Mapping[str, Any],
    name: str,
    known: tuple[Key, ...],
    path: Path,
    problems: list[Problem],
    hint: str,
) -> Iterator[tuple[Path, Mapping[str, Any]]]:
    """The tables of a list that may be left out, each with the place where it stands."""
    listed = table.get(name, [])
    if not isinstance(listed, (list, tuple)):
        problems.append(Problem((*path, name), "not-a-list", f"{name} is a list", hint))
        return
    for k, entry in enumerate(listed):
        here = (*path, name, k)
        row = mapping(entry, here, problems, hint)
        if row is not None:
            unknown_keys(row, names(known), here, problems)
            yield here, row


def texts(
    table: Mapping[str, Any], name: str, path: Path, problems: list[Problem], hint: str
) -> tuple[str, ...]:
    """One text or a list of texts; empty where there is none."""
    value = table.get(name)
    if value is None and name not in table:
        return ()
    here = (*path, name)
    listed = value if isinstance(value, (list, tuple)) else [value]
    found = []
    for k, item in enumerate(listed):
        text = ""
        if isinstance(item, (str, int, float)):  # as it was written
            text = str(item).lower() if isinstance(item, bool) else str(item).strip()
        if not text:
            message, should = f"{name} lists texts", cut_by_colon(item) or hint
            if item is None:
                message = "YAML reads null, ~ and an empty place as nothing"
                should = 'a word goes in quotes: "null"'
            place = (*here, k) if listed is value else here
            problems.append(Problem(place, "not-text", message, should))
            return ()
        found.append(text)
    return tuple(found)


def cut_by_colon(entry: object) -> str:
    """The hint for a text of a list that YAML reads as a key and its value; "": it is none."""
    if not isinstance(entry, Mapping) or len(entry) != 1:
        return ""
    ((before, after),) = entry.items()
    if isinstance(after, bool) or not isinstance(after, (str, int, float)):
        return ""
    whole = f"{before}: {after}"
    quoted = f"'{whole}'" if re.search(r'["\\]', whole) else f'"{whole}"'
    return f"a text with a colon in it goes in quotes: {quoted}"


def choice(
    table: Mapping[str, Any], name: str, words: tuple[str, ...], path: Path, problems: list[Problem]
) -> str:
    """One of `words`; the first is the default."""
    value = table.get(name, words[0])
    if value not in words:
        problems.append(
            Problem(
                (*path, name),
                "not-a-choice",
                f"{name} is {' or '.join(words)} (got {str(value)[:40]})",
                f"{name}: {words[0]}",
            )
        )
        return words[0]
    return str(value)


def flag(
    table: Mapping[str, Any], name: str, path: Path, problems: list[Problem], *, default: bool
) -> bool:
    """true or false."""
    value = table.get(name, default)
    if not isinstance(value, bool):
        problems.append(
            Problem((*path, name), "not-a-choice", f"{name} is true or false", f"{name}: true")
        )
        return default
    return value


def whole(
    table: Mapping[str, Any], name: str, path: Path, problems: list[Problem], *, default: int
) -> int:
    """A whole number from 1 to `MOST_WHOLE`."""
    value = table.get(name, default)
    if isinstance(value, bool) or not isinstance(value, int) or not 1 <= value <= MOST_WHOLE:
        message = f"{name} is a whole number from 1 to {MOST_WHOLE}"
        problems.append(Problem((*path, name), "out-of-range", message, f"{name}: 2"))
        return default
    return value
