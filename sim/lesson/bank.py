"""A bank: questions kept apart from lessons, from which forms draw; and named forms."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from sim.lesson import keys
from sim.lesson.keys import PROSE, TEXTS, Key
from sim.lesson.problems import LessonError
from sim.lesson.question import Question
from sim.lesson.read import collect_question
from sim.scene.fence.presentation import ID
from sim.scene.problem import Path, Problem, did_you_mean
from sim.scene.tables import mapping, unknown_keys

BANK_KEYS = (
    Key("title", "what the bank is about", "Forces and motion", PROSE, True),
    Key("note", "for the teacher", '"Our own items, not validated."', PROSE),
    Key("items", "the questions, with the keys of a question block", "[{id: …, type: single, …}]",
        {"type": "array", "items": {"type": "object"}, "minItems": 1}, True),
    Key("forms", "forms by name: the ids of their items, in order", "{test-15: [pod, table]}",
        {"type": "object", "additionalProperties": TEXTS}),
)  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class Bank:
    """Items by id in the order of the file, and forms as lists of ids."""

    title: str
    note: str
    items: Mapping[str, Question]
    forms: Mapping[str, tuple[str, ...]]


def read_bank(plain: object) -> Bank:
    """The bank that `plain` describes; raises LessonError with every problem."""
    problems: list[Problem] = []
    hint = "title: Forces and motion\n  items:\n    - {id: …, type: single, ask: …}"
    table = mapping(plain, (), problems, hint)
    if table is None:
        raise LessonError(problems)
    unknown_keys(table, keys.names(BANK_KEYS), (), problems)
    title = keys.needed(table, "title", (), problems, "title: Forces and motion")
    items = _items(table, problems, hint)
    forms = _forms(table, items, problems)
    note = keys.text(table, "note", (), problems) or ""
    if problems:
        raise LessonError(problems)
    return Bank(title=title, note=note, items=items, forms=forms)


def _items(table: Mapping[str, Any], problems: list[Problem], hint: str) -> dict[str, Question]:
    listed = table.get("items")
    if not isinstance(listed, (list, tuple)) or not listed:
        where: Path = ("items",) if "items" in table else ()
        problems.append(Problem(where, "not-a-list", "items lists the questions", hint))
        return {}
    items: dict[str, Question] = {}
    for k, entry in enumerate(listed):
        question = collect_question(entry, ("items", k), problems)
        if question is None:
            continue
        if question.KIND in ("reading", "drawn"):
            message = f"a question of type {question.KIND} needs a scene on its page"
            problems.append(
                Problem(("items", k, "type"), "needs-scene", message, "put it into a lesson")
            )
        if question.id in items:
            message = f"id: “{question.id}” is used twice in this bank"
            problems.append(
                Problem(("items", k, "id"), "id-taken", message, "every item needs its own")
            )
        items[question.id] = question
    return items


def _forms(
    table: Mapping[str, Any], items: Mapping[str, Question], problems: list[Problem]
) -> dict[str, tuple[str, ...]]:
    listed = table.get("forms")
    if listed is None:
        return {}
    rows = mapping(listed, ("forms",), problems, "forms:\n    test-15: [pod, table]") or {}
    forms = {}
    for name, value in rows.items():
        path: Path = ("forms", name)
        if not ID.fullmatch(str(name)):
            message = f"“{str(name)[:40]}” cannot be the name of a form"
            problems.append(Problem(path, "bad-name", message, "small letters, digits, hyphens"))
        forms[str(name)] = keys.texts({"items": value}, "items", path, problems, "[pod, table]")
        known_items(forms[str(name)], items, path, problems)
    return forms


def known_items(
    ids: tuple[str, ...], items: Mapping[str, Question], path: Path, problems: list[Problem]
) -> None:
    """One problem for each id that the bank does not have, or that stands there twice."""
    for k, identity in enumerate(ids):
        if items and identity not in items:
            hint = did_you_mean(identity, items, "look at the ids in the bank")
            message = f"the bank has no item “{identity[:40]}”"
            problems.append(Problem((*path, k), "unknown-item", message, hint))
        elif identity in ids[:k]:
            message = f"“{identity}” stands there twice"
            problems.append(Problem((*path, k), "twice", message, "keep one of them"))
