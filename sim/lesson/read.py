"""From plain values to a question, or to every problem in them."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from sim.lesson import keys
from sim.lesson.kinds.arrange import Matching, Ordering
from sim.lesson.kinds.choice import Multiple, Single
from sim.lesson.kinds.idea import Idea
from sim.lesson.kinds.interactions import Interactions
from sim.lesson.kinds.number import Number
from sim.lesson.kinds.options import ELSEWHERE
from sim.lesson.kinds.run import Drawn, Reading
from sim.lesson.kinds.sure import Confidence
from sim.lesson.kinds.table import Table
from sim.lesson.kinds.unformatted import unformatted
from sim.lesson.kinds.words import Long, Short
from sim.lesson.problems import LessonError
from sim.lesson.question import COMMON_KEYS, Question, read_common
from sim.scene.problem import Path, Problem, did_you_mean, meant
from sim.scene.tables import mapping, unknown_keys

KINDS: dict[str, type[Question]] = {
    kind.KIND: kind
    for kind in (
        Single, Multiple, Number, Short, Long, Ordering, Matching, Confidence, Reading, Drawn,
        Idea, Table, Interactions,
    )
}  # fmt: skip

_ELSEWHERE = {
    Single: ELSEWHERE, Multiple: ELSEWHERE, Short: {"answer": "accept: [zero, 0 N]"},
    Number: {"unit": "a unit stands behind its number: answer: 0.25 m/s"},
}  # fmt: skip
"""What authors look for under a key that a kind has not, and how it is said."""

_WORTH = ("points", "point", "score", "worth")
"""What others call `marks`; “points” is nearer to `hints`."""

_CALLED = {
    "essay": "long", "paragraph": "long", "text": "short", "shortanswer": "short",
    "truefalse": "single", "trueorfalse": "single", "boolean": "single",
    "numerical": "number", "numeric": "number",
}  # fmt: skip
"""What others call a type, and what it is called here."""


def read_question(plain: object) -> Question:
    """The question that `plain` describes; raises LessonError with every problem."""
    problems: list[Problem] = []
    question = collect_question(plain, (), problems)
    if problems or question is None:
        raise LessonError(problems)
    return question


def collect_question(plain: object, path: Path, problems: list[Problem]) -> Question | None:
    """The question at `path`, or None; what is wrong is added to `problems`."""
    table = mapping(plain, path, problems, "a question is a table of keys: id, type, ask, …")
    if table is None:
        return None
    kind = _kind(table, path, problems)
    before = len(problems)
    common = read_common(table, path, problems)
    if kind is None:
        problems += _misspelt(table, path)
        return None
    known = (*keys.names(COMMON_KEYS), *keys.names(kind.KEYS))
    a_list = _missing_list(kind, table)
    elsewhere = (
        _ask(table, known) | dict.fromkeys(_WORTH, meant("marks")) | _ELSEWHERE.get(kind, {})
    )
    unknown_keys(table, known, path, problems, a_list=a_list, elsewhere=elsewhere)
    question = kind.read(table, common, path, problems)
    _marks_for_nothing(kind, table, path, problems)
    unformatted({name: table[name] for name in table if name in known}, path, problems)
    return question if len(problems) == before else None


def _misspelt(table: Mapping[str, Any], path: Path) -> list[Problem]:
    """Keys that are nearly those of every question, where the type of this one is not known."""
    common = keys.names(COMMON_KEYS)
    of_any = {name for kind in KINDS.values() for name in keys.names(kind.KEYS)}
    strange = {name: table[name] for name in table if name not in of_any}
    found: list[Problem] = []
    unknown_keys(strange, common, path, found)
    missing = {meant(name) for name in common if name not in table}
    return [problem for problem in found if problem.hint in missing]


def _ask(table: Mapping[str, Any], known: tuple[str, ...]) -> dict[str, str]:
    """The hint for the only sentence under a key that nobody knows, where `ask` is missing."""
    strange = {name: entry for name, entry in table.items() if name not in known}
    said = [name for name, entry in strange.items() if isinstance(entry, str) and " " in entry]
    return {said[0]: meant("ask")} if len(said) == 1 and "ask" not in table else {}


def _marks_for_nothing(
    kind: type[Question], table: Mapping[str, Any], path: Path, problems: list[Problem]
) -> None:
    """A problem where marks would be given for nothing."""
    if "marks" in table and not kind.MARKED:
        message = f"nothing is right or wrong in a question of type {kind.KIND}"
        problems.append(Problem((*path, "marks"), "unknown-key", message, "remove marks"))


def _missing_list(kind: type[Question], table: Mapping[str, Any]) -> str:
    """The only list that this type needs and has not; empty: none, or several."""
    needed = [key.name for key in kind.KEYS if key.required and key.schema.get("type") == "array"]
    missing = [name for name in needed if name not in table]
    return missing[0] if len(missing) == 1 else ""


def _kind(table: Mapping[str, Any], path: Path, problems: list[Problem]) -> type[Question] | None:
    name = table.get("type")
    kind = KINDS.get(name) if isinstance(name, str) else None
    if kind is None:
        hint = did_you_mean(name or "", KINDS, f"type: one of {', '.join(KINDS)}")
        if re.search(r"choice|^mc$|^mcq$", str(name), re.IGNORECASE):  # others call both so
            hint = "type: single where one option is right, type: multiple where several are"
        if called := _CALLED.get(re.sub(r"[\W_]", "", str(name)).lower()):
            hint = f"type: {called}"
        given = name is not None
        message = f"there is no type “{str(name)[:40]}”" if given else "type is missing"
        if given and not isinstance(name, str):
            message, hint = "type is one word", "type: single"
        where = (*path, "type") if "type" in table else path
        problems.append(Problem(where, "unknown-type" if given else "missing", message, hint))
    return kind
