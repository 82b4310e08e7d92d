"""Questions made again from a teacher's key file, so that the files of a class can be marked.

A key file holds every question as data. Here it becomes the question itself: what marks a practice
form in the lesson and what marks an exam here is then the same code.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from sim.classroom.refusal import RefusalError
from sim.lesson.key_file import FORMAT, KIND
from sim.lesson.kinds.arrange import Matching, Ordering
from sim.lesson.kinds.choice import Multiple, Option, Single
from sim.lesson.kinds.idea import Idea
from sim.lesson.kinds.interactions import Interactions
from sim.lesson.kinds.links import Known, Link
from sim.lesson.kinds.number import Number, Wrong
from sim.lesson.kinds.run import Drawn, Reading
from sim.lesson.kinds.sure import Confidence
from sim.lesson.kinds.table import Open, Table
from sim.lesson.kinds.words import Long, Short
from sim.lesson.mark import Mark
from sim.lesson.question import Common, Question

MOST_CHARACTERS = 5_000_000
MOST_ITEMS = 500
LONGEST_TITLE = 200
CHOSEN: dict[str, type[Single | Idea]] = {kind.KIND: kind for kind in (Single, Multiple, Idea)}
"""Kinds in which options are chosen; in an idea none of them is right."""


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
    except (KeyError, TypeError, ValueError, AttributeError, IndexError):
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
        question=_question(row, common),
        hash=str(row["hash"]),
        ask=common.ask,
        texts={str(k): str(v) for k, v in row.get("texts", {}).items()},
        beliefs={str(k): str(v) for k, v in row.get("beliefs", {}).items()},
        rubric={str(k): str(v) for k, v in row.get("rubric", {}).items()},
        optional=row.get("optional") is True,
    )


def _question(row: Mapping[str, Any], common: Common) -> Question:
    kind, key, texts = str(row["type"]), row["key"], row.get("texts", {})
    said = {str(k): str(v) for k, v in row.get("feedback", {}).items()}
    if kind in CHOSEN:
        options = tuple(
            Option(
                id=str(name),
                text=str(texts.get(f"option-{name}", "")),
                correct=name in key["correct"],
                belief=str(key["beliefs"].get(name, "")),
                feedback=said.get(f"option-{name}", ""),
            )
            for name in row["options"]
        )
        return CHOSEN[kind](common=common, options=options)
    if kind == "number":
        wrong = tuple(
            Wrong(
                value=float(w["value"]),
                tolerance=float(w["tolerance"]),
                belief=w["belief"],
                feedback=said.get(f"wrong-{k}", ""),
            )
            for k, w in enumerate(key["wrong"])
        )
        units = {str(name): float(factor) for name, factor in row["units"].items()}
        return Number(
            common=common, answer=float(key["answer"]), tolerance=float(key["tolerance"]),
            unit=str(row["unit"]), units=units, wrong=wrong,
        )  # fmt: skip
    if kind in ("short", "long"):
        rubric = {int(marks): str(text) for marks, text in row.get("rubric", {}).items()}
        rubric = rubric or {common.marks: ""}
        if kind == "long":
            return Long(common=common, rubric=rubric)
        known = tuple(
            (tuple(w["texts"]), str(w["belief"]), said.get(f"wrong-{k}", ""))
            for k, w in enumerate(key["wrong"])
        )
        return Short(common=common, rubric=rubric, accept=tuple(key["accept"]), wrong=known)
    if kind == "ordering":
        return Ordering(common=common, order=tuple(texts[f"line-{k}"] for k in key["order"]))
    if kind == "matching":
        return _matching(row, common)
    if kind == "table":
        return _table(row, common)
    if kind == "interactions":
        return _interactions(row, common)
    if kind == "reading":
        return Reading(
            common=common, scene=str(row["scene"]), quantity=str(row["quantity"]),
            at=row["at"], unit=str(row["unit"]), units={}, per=float(row["per"]),
            tolerance=float(key["tolerance"]), relative=bool(key["relative"]),
        )  # fmt: skip
    if kind == "confidence":
        return Confidence(common=common)
    if kind == "drawn":
        return Drawn(common=common, scene=str(row["scene"]))
    raise ValueError(kind)


def _table(row: Mapping[str, Any], common: Common) -> Table:
    """Heads, given cells, and the interval of each other one."""
    cells, asked = row["key"]["cells"], row["cells"]

    def cell(name: str, given: str | None) -> str | Open:
        if given is not None:
            return given
        right = cells[name]
        unit = str(asked[name]["unit"])
        return Open(float(right["answer"]), float(right["tolerance"]), unit, {})

    rows = tuple(
        tuple(cell(f"{r}-{c}", given) for c, given in enumerate(line, start=1))
        for r, line in enumerate(row["rows"], start=1)
    )
    plot = (int(row["plot"][0]) - 1, int(row["plot"][1]) - 1) if row["plot"] else None
    return Table(common=common, columns=tuple(row["columns"]), rows=rows, plot=plot)


def _interactions(row: Mapping[str, Any], common: Common) -> Interactions:
    """The boxes, the right links, and the beliefs behind invented ones."""
    objects, key = tuple(map(str, row["objects"])), row["key"]

    def ends(told: Mapping[str, Any]) -> tuple[int, int]:
        a, b = told["between"]
        return objects.index(a), objects.index(b)

    return Interactions(
        common=common,
        objects=objects,
        links=tuple(Link(*ends(link), link["by"]) for link in key["links"]),
        focus=tuple(objects.index(name) for name in row["focus"]),
        wrong=tuple(
            Known(*ends(told), tuple(told["by"]), "", str(told["belief"])) for told in key["wrong"]
        ),
    )


def _matching(row: Mapping[str, Any], common: Common) -> Matching:
    """The pairs in their order, then what belongs to nothing."""
    pairs, texts = row["key"]["pairs"], row["texts"]
    letters = [pairs[number] for number in row["left"]]
    others = [letter for letter in row["right"] if letter not in letters]
    question = Matching(
        common=common,
        left=tuple(texts[f"left-{number}"] for number in row["left"]),
        right=tuple(texts[f"right-{letter}"] for letter in (*letters, *others)),
    )
    if question.key()["pairs"] != pairs:
        raise RefusalError("the letters of this item are not those of the page")
    return question
