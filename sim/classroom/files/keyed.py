"""Questions made again from a teacher's key file, so that the files of a class can be marked.

A key file holds every question as data. Here it becomes the question itself: what marks a practice
form in the lesson and what marks an exam here is then the same code.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from sim.lesson.key_file import FORMAT, KIND
from sim.lesson.mark import Mark
from sim.lesson.question import Common, Question
from sim.lesson.read import KINDS

MOST_CHARACTERS = 5_000_000
MOST_ITEMS = 500
LONGEST_TITLE = 200


class KeyFileError(ValueError):
    """This is no key file that can be used; the message is for the teacher."""


@dataclass(frozen=True, slots=True, kw_only=True)
class KeyedItem:
    """A question with what the teacher reads beside it.

    `optional`: it stands in a part for who has time, and gives no marks.
    """

    question: Question
    hash: str
    ask: str
    texts: Mapping[str, str]
    beliefs: Mapping[str, str]
    rubric: Mapping[str, str]
    optional: bool = False
    seen: dict[str, Mark] = field(default_factory=dict, repr=False, compare=False)

    def mark(self, value: object, own: float | None = None) -> Mark:
        """Marks an answer; equal choices of thousands of students share one mark."""
        if not isinstance(value, str) or len(value) > 2 or own is not None:
            return self.question.mark(value, own)
        if value not in self.seen:
            self.seen[value] = self.question.mark(value)
        return self.seen[value]

    @property
    def worth(self) -> int:
        """The most marks; 0 where there is nothing to mark."""
        return 0 if self.optional else self.question.mark(None).of


@dataclass(frozen=True, slots=True, kw_only=True)
class KeyedForm:
    """The items of one form of a lesson by id, in their order. `title`: for people, or empty."""

    site: str
    lesson: str
    title: str
    form: str
    hash: str
    options: tuple[tuple[str, int], ...]
    items: Mapping[str, KeyedItem]
    plain: Mapping[str, Any]

    def as_file(self) -> str:
        """A key file of this form alone."""
        content = {"format": FORMAT, "kind": KIND, "site": self.site, "lesson": self.lesson,
                   "title": self.title}  # fmt: skip
        return json.dumps({**content, "forms": [self.plain]}, ensure_ascii=False)


def read_key_file(text: str) -> tuple[KeyedForm, ...]:
    """The forms in a key file; raises `KeyFileError`."""
    if len(text) > MOST_CHARACTERS:
        raise KeyFileError("this file is too large to be a key file")
    try:
        content = json.loads(text.removeprefix("\ufeff"))
    except (ValueError, RecursionError):
        raise KeyFileError("this file is damaged, or it is no key file") from None
    if not isinstance(content, dict) or content.get("kind") != KIND:
        raise KeyFileError("this is no key file; `carts key` writes them")
    if content.get("format") != FORMAT:
        raise KeyFileError("this key file comes from another version of Newton's Carts")
    try:
        return tuple(_form(part, content) for part in content["forms"])
    except (KeyError, TypeError, ValueError, AttributeError, IndexError, OverflowError):
        raise KeyFileError("this key file is damaged: write it again with `carts key`") from None


def _form(part: Mapping[str, Any], content: Mapping[str, Any]) -> KeyedForm:
    rows = part["items"]
    if len(rows) > MOST_ITEMS:
        raise ValueError
    return KeyedForm(
        site=str(content["site"]),
        lesson=str(content["lesson"]),
        title=str(content.get("title", ""))[:LONGEST_TITLE],
        form=str(part["form"]),
        hash=str(part["hash"]),
        options=tuple((str(name), int(count)) for name, count in part["options"]),
        items={str(row["id"]): keyed_item(row) for row in rows},
        plain=part,
    )


def keyed_item(row: Mapping[str, Any]) -> KeyedItem:
    """One item of a key file; raises KeyError, TypeError or ValueError where it is damaged."""
    common = Common(
        id=str(row["id"]),
        ask=str(row["ask"]),
        marks=int(row["marks"]),
        sure=bool(row.get("sure")),
        topics=tuple(map(str, row.get("topics", ()))),
        explain=str(row.get("explain", "")),
        idea=str(row.get("idea", "")),
    )
    return KeyedItem(
        question=KINDS[str(row["type"])].from_key(row, common),
        hash=str(row["hash"]),
        ask=common.ask,
        texts={str(k): str(v) for k, v in row.get("texts", {}).items()},
        beliefs={str(k): str(v) for k, v in row.get("beliefs", {}).items()},
        rubric={str(k): str(v) for k, v in row.get("rubric", {}).items()},
        optional=row.get("optional") is True,
    )
