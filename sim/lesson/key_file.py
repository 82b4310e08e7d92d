"""The teacher's key file: what marks the answers of a lesson, kept apart from the pages.

`{"format": 1, "kind": "newtons-carts-key", site, lesson, title, forms: [{form, hash, options,
items}]}`; an item has the texts, the key, the rubric, the beliefs behind wrong answers, the
feedback on them and the note.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from typing import Any

from sim.lesson.beliefs import BELIEFS
from sim.lesson.form import Form, radix
from sim.lesson.kinds.known_words import AS_WRITTEN
from sim.lesson.kinds.words import Long, Short
from sim.lesson.question import Question

FORMAT = 1
KIND = "newtons-carts-key"


def key_file(
    site: str,
    lesson: str,
    worksheet: Iterable[Question],
    forms: Iterable[Form],
    *,
    title: str = "",
    optional: Collection[str] = (),
) -> dict[str, Any]:
    """The key of one lesson: its own questions as the form “worksheet”, then its forms.

    `title` is what people call the lesson; `optional`: own questions in parts for who has time.
    """
    own = tuple(worksheet)
    parts = [_part("worksheet", "", own, optional)] if own else []
    parts += [_part(form.form, form.hash, form.items) for form in forms]
    head = {"format": FORMAT, "kind": KIND, "site": site, "lesson": lesson}
    return head | ({"title": title} if title else {}) | {"forms": parts}


def _part(
    name: str, digest: str, items: tuple[Question, ...], optional: Collection[str] = ()
) -> dict[str, Any]:
    return {
        "form": name,
        "hash": digest,
        "options": [[item.id, radix(item)] for item in items],
        "items": [
            item_key(item) | ({"optional": True} if item.id in optional else {}) for item in items
        ],
    }


def item_key(item: Question) -> dict[str, Any]:
    """Everything that a teacher needs to mark and discuss one question."""
    key = item.data(key=True)
    beliefs = sorted(set(_beliefs(key["key"])))
    row: dict[str, Any] = {
        **key,
        "ask": item.common.ask,
        "texts": item.texts(),
        "beliefs": {tag: BELIEFS[tag] for tag in beliefs},
        "topics": list(item.common.topics),
    }
    if item.common.note:
        row["note"] = item.common.note
    if item.common.explain:
        row["explain"] = item.common.explain
    if said := item.feedback():
        row["feedback"] = said
    if isinstance(item, Short) and item.accept:
        row[AS_WRITTEN] = True
    if isinstance(item, Long) and item.rubric:
        row["rubric"] = {str(marks): text for marks, text in item.rubric.items()}
    return row


def _beliefs(key: Mapping[str, Any]) -> Iterable[str]:
    yield from (key.get("beliefs") or {}).values()
    yield from (wrong["belief"] for wrong in key.get("wrong", []) if wrong["belief"])
