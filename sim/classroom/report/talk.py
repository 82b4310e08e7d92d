"""What to talk about first: wrong answers of one belief, and questions that all missed.

A wrong answer that a student is sure of is a belief; one that is guessed is a gap. So sure wrong
answers count twice. Wrong options of a question that go with one belief are counted together where
only one can be chosen, and a belief is named once, with the other questions that show it. The order
is a suggestion for the next lesson, no statistic. A question that nobody had right counts each
student once: no wrong answer is shared there, and all of them need it. Questions that nobody came
to stand together and last: an hour that ended early says nothing of what a class believes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from sim.classroom.report.sentences import begins
from sim.classroom.show.prose import prose
from sim.scene.said import commas, counted, listed_or, said

FEWEST = 2
"""Students who chose wrong answers of one belief, before it is worth a talk in class."""

MOST = 3

SEVERAL = frozenset({"multiple", "interactions"})
"""Kinds of questions in which a student gives several of the answers that are counted."""

LONGEST = 80
"""Characters of an option that are said: enough to know it again."""


@dataclass(frozen=True, slots=True)
class _Chosen:
    """Wrong answers to one item that go together: one option, or all of one belief."""

    item: dict[str, Any]
    choices: tuple[dict[str, Any], ...]

    @property
    def count(self) -> int:
        return sum(int(choice["count"]) for choice in self.choices)

    @property
    def sure(self) -> int:
        return sum(int(choice.get("sure") or 0) for choice in self.choices)

    @property
    def weight(self) -> int:
        return self.count + self.sure

    @property
    def belief(self) -> str:
        return str(self.choices[0].get("belief") or "")

    def sentence(self, also: Sequence[_Talk]) -> str:
        """How many chose what, how sure they were, what they may think, and where else."""
        text = said("{question}: {count} of {answered} chose {answer}", question=self.item["label"],
                    count=f"{self.count}", answered=f"{self.item['answered']}",
                    answer=listed_or([_answer(choice) for choice in self.choices]))  # fmt: skip
        if self.sure:
            text = said("{sentence}, {count} of them sure", sentence=text, count=f"{self.sure}")
        says = self.choices[0].get("says")
        if not says:
            return said("{sentence}.", sentence=text)
        text = said("{sentence}; students who choose it often think: “{belief}”", sentence=text,
                    belief=says)  # fmt: skip
        if not also:
            return text
        others = commas([other.item["label"] for other in also])
        return said("{sentence} Also in: {questions}.", sentence=text, questions=others)


@dataclass(frozen=True, slots=True)
class _Missed:
    """A question that nobody answered, or that nobody who answered had right."""

    item: dict[str, Any]
    belief = ""

    @property
    def count(self) -> int:
        return int(self.item["answered"] or self.item["n"])

    @property
    def weight(self) -> int:
        return self.count

    def sentence(self, also: Sequence[_Talk]) -> str:
        """That nobody had it, with of how many."""
        question = self.item["label"]
        if not self.item["answered"]:
            return counted("{question}: the one student did not answer it.",
                           "{question}: none of {n} students answered it.",
                           n=self.count, question=question)  # fmt: skip
        return counted("{question}: the one who answered did not have it right.",
                       "{question}: none of {n} who answered had it right.",
                       n=self.count, question=question)  # fmt: skip


_Talk = _Chosen | _Missed


def talk_rows(items: Sequence[dict[str, Any]]) -> list[dict[str, Any]]:
    """At most three questions of a form, the most urgent first, each for another belief."""
    found = [one for item in items if (one := _most_urgent(item))]
    reached = [one for one in found if one.item["answered"]]
    urgent = sorted(reached, key=lambda one: -one.weight)
    rows: dict[str, list[_Talk]] = {}
    for one in urgent:
        rows.setdefault(one.belief or f"item {one.item['id']}", []).append(one)
    first = list(rows.values())[:MOST]
    told = [{"id": one.item["id"], "sentence": one.sentence(also)} for one, *also in first]
    return [*told, *_not_reached([one for one in found if not one.item["answered"]])][:MOST]


def _not_reached(missed: Sequence[_Talk]) -> list[dict[str, Any]]:
    """One row for all questions that nobody answered."""
    if not missed:
        return []
    first, *more = missed
    if not more:
        return [{"id": first.item["id"], "sentence": first.sentence(())}]
    labels = commas([one.item["label"] for one in missed])
    sentence = counted("{questions}: the one student answered none of them.",
                       "{questions}: none of {n} students answered any of them.",
                       n=max(one.count for one in missed), questions=labels)  # fmt: skip
    return [{"id": first.item["id"], "sentence": sentence}]


def _most_urgent(item: dict[str, Any]) -> _Talk | None:
    """What a question is talked about for: a shared wrong answer, or that nobody had it."""
    shared = max(_groups(item), key=lambda one: one.weight, default=None)
    if shared and shared.count >= FEWEST:
        return shared
    missed = _Missed(item)
    had = item["right"] or item["partly"] or item["unread"]
    return missed if item["worth"] and not had and missed.count >= FEWEST else None


def _groups(item: dict[str, Any]) -> list[_Chosen]:
    """The wrong answers of an item by belief; one by one where several can be chosen at once."""
    together: dict[str, list[dict[str, Any]]] = {}
    for choice in item["choices"] if item["worth"] else ():
        if choice.get("correct", False) or not choice["count"]:
            continue
        alone = item["type"] in SEVERAL or not choice.get("belief")
        name = f"option {choice['option']}" if alone else f"belief {choice['belief']}"
        together.setdefault(name, []).append(choice)
    return [_Chosen(item, tuple(choices)) for choices in together.values()]


def _answer(choice: dict[str, Any]) -> str:
    """The letter of an option and how its text begins; a number as it was typed."""
    words = prose(choice["text"])
    if not words:
        label: str = choice["label"]
        return label
    return said("{letter} (“{text}”)", letter=choice["label"], text=begins(words, LONGEST))
