"""A student's file with its marks, as far as a key is there to mark it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from sim.classroom.files.keyed import KeyedForm, KeyedItem
from sim.classroom.files.marks_file import Given, pseudonym
from sim.classroom.files.reading import Read
from sim.lesson.answer_file import AnswerFile, Item
from sim.lesson.mark import Mark, Verdict, is_empty
from sim.scene.said import said

NO_CODE = "no code word"
"""How a file without one is named where persons are compared; people are told `who`."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Answer:
    """The answer that counts for one item. `foreign`: it answers another wording of it.

    `optional`: in a part for who has time, which gives no marks and is never missing. `item`: as
    it stands in the file, None where nothing does.
    """

    id: str
    type: str
    value: Any
    sure: str
    mark: Mark | None
    foreign: bool = False
    optional: bool = False
    item: Item | None = None

    @property
    def marks(self) -> int:
        """Marks so far: what nobody has marked yet gives none."""
        return (self.mark.marks or 0) if self.mark and not self.optional else 0

    @property
    def worth(self) -> int:
        """The most marks that it could have; 0 without a key."""
        return self.mark.of if self.mark and not self.optional else 0


@dataclass(frozen=True, slots=True, kw_only=True)
class Marked:
    """One student, one form."""

    name: str
    group: str
    file: AnswerFile
    answers: Mapping[str, Answer]

    @property
    def student(self) -> str:
        """Who it is, as it is compared; a file without a code word is a person of its own."""
        return pseudonym(self.file.student) or f"{NO_CODE} {self.name}"

    @property
    def who(self) -> str:
        """Who it is, for people: the code word, or the name of the file that has none."""
        return self.file.student.strip() or said("no code word ({file})", file=self.name)

    @property
    def place(self) -> str:
        """Who it is and which form, for people."""
        return said("{who}, form {form}", who=self.who, form=self.file.form)

    @property
    def key(self) -> tuple[str, str, str, str]:
        """What may occur once: site, lesson, form, student."""
        return self.file.site, self.file.lesson, self.file.form, self.student

    @property
    def foreign(self) -> tuple[str, ...]:
        """Items answered in another wording only: this file cannot be compared with the others."""
        return tuple(a.id for a in self.answers.values() if a.foreign)

    @property
    def foreign_numbers(self) -> tuple[int, ...]:
        """The same, as students number the questions, from 1."""
        return tuple(k for k, a in enumerate(self.answers.values(), 1) if a.foreign)

    @property
    def open(self) -> tuple[str, ...]:
        """Items left open, of those that are worth marks."""
        return tuple(
            a.id
            for a in self.answers.values()
            if a.mark and a.worth and a.mark.verdict == "empty" and not a.foreign
        )

    @property
    def unanswered(self) -> bool:
        """Whether nothing is answered in it, no prediction either."""
        return all(is_empty(item.value) for item in self.file.latest().values())

    @property
    def waiting(self) -> tuple[str, ...]:
        """Answers that a person has to read."""
        return tuple(
            a.id for a in self.answers.values() if a.mark and a.worth and a.mark.marks is None
        )

    def total(self, items: Sequence[str]) -> int:
        """Marks in these items; the key of an earlier text may not have them all."""
        return sum(self.answers[name].marks for name in items if name in self.answers)


class Keys:
    """The keys of a class by site, lesson and form. A lesson in several languages has several.

    A teacher may have made the key from a copy of the lesson, under another site or name: where a
    file's own site gave none, the key counts whose questions are the file's, by their hashes.
    """

    def __init__(self, keys: Iterable[KeyedForm]) -> None:
        self.wordings: dict[tuple[str, str, str], list[KeyedForm]] = {}
        for key in keys:
            self.wordings.setdefault((key.site, key.lesson, key.form), []).append(key)
        self.taken: Counter[int] = Counter()  # by the identity of a key: files that it marked

    @property
    def main(self) -> dict[tuple[str, str, str], KeyedForm]:
        """The key that a report takes its texts from: that of most files so far, else the last one
        given."""
        return {
            name: max(reversed(found), key=lambda key: self.taken[id(key)])
            for name, found in self.wordings.items()
        }

    def of(self, file: AnswerFile) -> KeyedForm | None:
        """The key of a file: the wording that most of its answers belong to, else the last."""
        name = (file.site, file.lesson, file.form)
        if name not in self.wordings and (lent := self._lent(file)):
            self.wordings[name] = lent
        found = self.wordings.get(name, [])
        if len(found) < 2:
            return found[0] if found else None
        key = max(reversed(found), key=lambda key: len(_same(key, file)))
        self.taken[id(key)] += 1
        return key

    def _lent(self, file: AnswerFile) -> list[KeyedForm]:
        """Keys of copies of this form: most of the questions that both know are the same."""
        all_ = {id(key): key for keys in self.wordings.values() for key in keys}.values()
        return [
            key
            for key in all_
            if key.form == file.form
            and 2 * len(_same(key, file)) > len({i.id for i in file.items} & key.items.keys())
        ]


def _same(key: KeyedForm, file: AnswerFile) -> set[str]:
    """Questions of the file that the key has word for word."""
    return {i.id for i in file.items if i.id in key.items and key.items[i.id].hash == i.hash}


def mark_file(read: Read, group: str, form: KeyedForm | None, given: Given) -> Marked:
    """The file with marks. Without a key there are answers and no marks."""
    file = read.answers
    if form is None:
        plain = {item.id: _unmarked(item) for item in file.items}
        return Marked(name=read.name, group=group, file=file, answers=plain)
    by_id: dict[str, list[Item]] = {}
    for item in file.items:
        by_id.setdefault(item.id, []).append(item)
    person = pseudonym(file.student) or pseudonym(f"{NO_CODE} ({read.name})")
    who = (file.lesson, file.form, person)
    answers = {
        name: _marked(keyed, by_id.get(name, []), given.get((*who, name)))
        for name, keyed in form.items.items()
    }
    return Marked(name=read.name, group=group, file=file, answers=answers)


def lesson_title(lesson: str, keys: Iterable[KeyedForm | None]) -> str:
    """A lesson as people call it: as its key says, else by the name of its file."""
    named = (key.title for key in keys if key and key.title)
    return next(named, lesson.replace("-", " ").capitalize())


def told_apart(lessons: Iterable[dict[str, Any]]) -> list[dict[str, Any]]:
    """Lessons of one title, a lesson and a copy of it, by the names of their files or sites too."""
    told = list(lessons)
    for name in ("lesson", "site"):
        titles = Counter(one["title"] for one in told)
        told = [
            one if titles[one["title"]] == 1 else {**one, "title": f"{one['title']} ({one[name]})"}
            for one in told
        ]
    return told


def counted_items(files: Sequence[Marked]) -> tuple[str, ...]:
    """Items that are worth marks and wait for nobody, in any of these files: what totals are of.

    Files of an earlier text, with a key of their own, share some items only: those count.
    """
    if not files:
        return ()
    waiting = {name for file in files for name in file.waiting}
    shared = set.intersection(*(set(file.answers) for file in files)) - waiting
    return tuple(name for name, a in files[0].answers.items() if a.worth and name in shared)


def worth(files: Sequence[Marked], items: Sequence[str]) -> int:
    """What these items are worth together."""
    return sum(files[0].answers[name].worth for name in items) if files else 0


def _unmarked(item: Item) -> Answer:
    return Answer(
        id=item.id, type=item.type, value=item.value, sure=item.more.get("sure", ""), mark=None,
        item=item,
    )  # fmt: skip


def _marked(keyed: KeyedItem, items: list[Item], given: int | None) -> Answer:
    """The last answer to this wording of the question, or none."""
    fitting = [item for item in items if item.hash in ("", keyed.hash)]
    item = fitting[-1] if fitting else None
    mark = keyed.mark(item.value if item else None, item.own if item else None)
    if given is not None and mark.verdict == "open" and mark.of:
        marks = max(0, min(given, mark.of))
        verdict: Verdict = "right" if marks == mark.of else "partly" if marks else "wrong"
        mark = Mark(verdict, marks, mark.of)
    return Answer(
        id=keyed.question.id,
        type=keyed.question.KIND,
        value=item.value if item else None,
        sure=item.more.get("sure", "") if item else "",
        mark=mark,
        optional=keyed.optional,
        foreign=not fitting and any(not is_empty(item.value) for item in items),
        item=item,
    )
