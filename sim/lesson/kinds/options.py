"""The answers that stand there to be chosen, and the belief behind a wrong one."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from sim.lesson import keys
from sim.lesson.beliefs import BELIEFS
from sim.lesson.keys import PROSE, Key
from sim.lesson.kinds.pictures import alike, places
from sim.scene.problem import Path, Problem, did_you_mean, nearest
from sim.scene.tables import unknown_keys

LETTERS = "abcdefghijkl"
_ID = re.compile(r"[a-z0-9][a-z0-9-]{0,31}", re.ASCII)
OPTION_KEYS = (
    Key("text", "the answer, in Markdown", "They are equal.", PROSE, True),
    Key("correct", "this answer is right", "true", {"type": "boolean"}),
    Key("belief", "tag of the belief behind a wrong answer", "bigger-pushes-more",
        {"enum": sorted(BELIEFS)}),
    Key("feedback", "shown to who chose it", "Compare the two arrows.", PROSE),
    Key("id", "name of the answer; default: its letter", "b"),
)  # fmt: skip
_NAMES = keys.names(OPTION_KEYS)
_HINT = "options:\n    - {text: They are equal., correct: true}\n    - {text: A pushes harder.}"
RIGHT = "add correct: true to what is right: {text: They are equal., correct: true}"
ELSEWHERE = dict.fromkeys(("answer", "correct", "right"), RIGHT)
OPTIONS = Key(
    "options",
    "the answers, in the order in which they stand there: A, B, C …",
    "[{text: They are equal., correct: true}, {text: A pushes harder.}]",
    {
        "type": "array",
        "minItems": 2,
        "maxItems": len(LETTERS),
        "items": {
            "anyOf": [
                PROSE,
                {
                    "type": "object",
                    "properties": {key.name: key.schema for key in OPTION_KEYS},
                    "required": ["text"],
                    "additionalProperties": False,
                },
            ]
        },
    },
    True,
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Option:
    """One answer to choose."""

    id: str
    text: str
    correct: bool = False
    belief: str = ""
    feedback: str = ""


def texts_of(options: Iterable[Option]) -> dict[str, str]:
    """The text of each option, by the name of its place in the page."""
    return {f"option-{option.id}": option.text for option in options}


def beliefs_of(options: Iterable[Option]) -> dict[str, str]:
    """The belief behind each option that has one, by its id."""
    return {option.id: option.belief for option in options if option.belief}


def read_options(
    table: Mapping[str, Any], path: Path, problems: list[Problem]
) -> tuple[Option, ...]:
    """The options of a question; empty with a problem if they cannot be used."""
    here = (*path, "options")
    listed = table.get("options")
    if "options" not in table:
        problems.append(Problem(path, "missing", "options is missing", _HINT))
        return ()
    if not isinstance(listed, (list, tuple)) or not 2 <= len(listed) <= len(LETTERS):
        message = f"options lists 2 to {len(LETTERS)} answers"
        problems.append(Problem(here, "not-a-list", message, _HINT))
        return ()
    options: list[Option] = []
    for k, entry in enumerate(listed):
        option = _option(entry, LETTERS[k], (*here, k), problems)
        if option is None:
            return ()
        if any(option.id == other.id for other in options):
            message = f"two options have the id “{option.id}”"
            problems.append(Problem((*here, k), "id-taken", message, "each needs its own"))
        options.append(option)
    alike([option.text for option in options], places(here, options), problems)
    return tuple(options)


def _option(entry: object, letter: str, path: Path, problems: list[Problem]) -> Option | None:
    table = {"text": entry} if isinstance(entry, (str, int)) else entry
    if not isinstance(table, Mapping):
        problems.append(Problem(path, "not-a-table", "an option is a text or a table", _HINT))
        return None
    if len(table) == 1 and not any(nearest(str(key), _NAMES) for key in table):
        hint = keys.cut_by_colon(table) or _HINT
        problems.append(Problem(path, "not-a-table", "an option is a text or a table", hint))
        return None
    unknown_keys(table, _NAMES, path, problems, elsewhere=ELSEWHERE)
    belief = read_belief(table, path, problems)
    correct = keys.flag(table, "correct", path, problems, default=False)
    if correct and belief:
        message = "a right answer has no belief behind it"
        problems.append(Problem((*path, "belief"), "twice", message, "remove one of the two"))
    identity = keys.text(table, "id", path, problems) or letter
    if not _ID.fullmatch(identity):
        message = f"“{identity[:40]}” cannot be an id"
        problems.append(Problem((*path, "id"), "bad-name", message, "id: equal"))
    return Option(
        id=identity,
        text=keys.needed(table, "text", path, problems, "text: They are equal."),
        correct=correct,
        belief=belief,
        feedback=keys.text(table, "feedback", path, problems) or "",
    )


def options_of_key(row: Mapping[str, Any]) -> tuple[Option, ...]:
    """The options again, from the row of their question in a key file."""
    key, texts, said = row["key"], row["texts"], row.get("feedback", {})
    return tuple(
        Option(
            id=str(name),
            text=str(texts.get(f"option-{name}", "")),
            correct=name in key["correct"],
            belief=str(key["beliefs"].get(name, "")),
            feedback=str(said.get(f"option-{name}", "")),
        )
        for name in row["options"]
    )


def read_belief(table: Mapping[str, Any], path: Path, problems: list[Problem]) -> str:
    """The belief tag of a wrong answer, one of `BELIEFS`; empty where there is none."""
    belief = keys.text(table, "belief", path, problems) or ""
    if belief and belief not in BELIEFS:
        hint = did_you_mean(belief, BELIEFS, f"one of: {', '.join(sorted(BELIEFS))}")
        message = f"there is no belief “{belief[:40]}”"
        problems.append(Problem((*path, "belief"), "unknown-belief", message, hint))
    return belief
