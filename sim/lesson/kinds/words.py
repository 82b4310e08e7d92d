"""Answers in words: a few (`short`) or several sentences (`long`)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Self

from sim.lesson import keys
from sim.lesson.keys import PROSE, PROSES, Key
from sim.lesson.kinds.known_words import (
    AS_WRITTEN,
    WRONG_KEYS,
    KnownWrong,
    of_key,
    read_accept,
    read_wrong,
)
from sim.lesson.kinds.plain_words import plain
from sim.lesson.mark import Mark, all_or_nothing, is_empty
from sim.lesson.question import Common, Question
from sim.scene.problem import Path, Problem
from sim.scene.tables import mapping

RUBRIC = Key(
    "rubric",
    "what an answer needs for 0, 1, 2 … marks, best with a sample; for the teacher, never in the "
    "page. The largest number is what the question is worth. Left out only where `accept` says "
    "what is right",
    "{2: names both forces, 1: names one, 0: “action = reaction” alone}",
    {"type": "object", "patternProperties": {"^[0-9]$": PROSE}, "additionalProperties": False},
)
START = Key(
    "start", "the beginning of a sentence, given to the student", "The force on B by A …", PROSE
)
WORDS = Key("words", "a bank of words to use", "[equal, opposite, pair]", PROSES)
MOST_MARKS = 9
"""Of one answer in words: one press of a key gives them."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Long(Question):
    """Free text, marked by a person with the rubric. The value is the text."""

    KIND: ClassVar[str] = "long"
    SAYS: ClassVar[str] = "write a few sentences"
    KEYS: ClassVar[tuple[Key, ...]] = (RUBRIC, START, WORDS)
    rubric: Mapping[int, str]
    start: str = ""
    words: tuple[str, ...] = ()

    @classmethod
    def read(
        cls, table: Mapping[str, Any], common: Common, path: Path, problems: list[Problem]
    ) -> Self:
        """Every text question has a rubric."""
        return cls(
            common=common,
            rubric=_rubric(table, path, problems, required=True),
            start=keys.text(table, "start", path, problems) or "",
            words=keys.texts(table, "words", path, problems, "words: [equal, pair]"),
        )

    @classmethod
    def from_key(cls, row: Mapping[str, Any], common: Common) -> Self:
        """The rubric; what helps with writing is the page's matter."""
        return cls(common=common, rubric=_rubric_of_key(row, common))

    @property
    def free(self) -> bool:
        """A person has to read it."""
        return True

    @property
    def worth(self) -> int:
        """The most marks that the rubric gives."""
        return max(self.rubric, default=self.common.marks)

    def asked(self) -> dict[str, Any]:
        """What helps with writing."""
        return {"start": self.start, "words": list(self.words), "marks": self.worth}

    def key(self) -> dict[str, Any]:
        """Nothing that a page could mark with."""
        return {"feedback": []}

    def meaning(self) -> dict[str, Any]:
        """The question alone: another beginning or word bank changes no answer."""
        return {}

    def mark(self, value: object, own: float | None = None) -> Mark:
        """A person has to read it."""
        del own
        if is_empty(value):
            return Mark("empty", 0, self.worth)
        if not isinstance(value, str):  # nobody can read it: no question may wait for that
            return Mark("unclear", 0, self.worth)
        return Mark("open", None, self.worth, ("explain",))


@dataclass(frozen=True, slots=True, kw_only=True)
class Short(Long):
    """A few words. With `accept` the page can tell right from wrong, else a person reads it."""

    KIND: ClassVar[str] = "short"
    SAYS: ClassVar[str] = "write a few words"
    KEYS: ClassVar[tuple[Key, ...]] = (
        Key("accept", "right answers; capitals, spaces and punctuation do not count, but for the "
            "point of a number", "[zero, 0, 0 N]", PROSES),
        Key("wrong", "wrong answers with feedback of their own",
            "[{text: A pushes harder, belief: mover-pushes-more}]",
            {"type": "array", "items": {"type": "object", "required": ["text"],
             "properties": {key.name: key.schema for key in WRONG_KEYS},
             "additionalProperties": False}}),
        RUBRIC,
        START,
        WORDS,
    )  # fmt: skip
    accept: tuple[str, ...] = ()
    wrong: tuple[KnownWrong, ...] = ()

    @classmethod
    def read(
        cls, table: Mapping[str, Any], common: Common, path: Path, problems: list[Problem]
    ) -> Self:
        """Either what is accepted, or a rubric."""
        before = len(problems)
        accept = read_accept(table, path, problems)
        alone = not accept and "answer" not in table and len(problems) == before
        return cls(
            common=common,
            rubric=_rubric(table, path, problems, required=alone),
            start=keys.text(table, "start", path, problems) or "",
            words=keys.texts(table, "words", path, problems, "words: [equal, pair]"),
            accept=accept,
            wrong=read_wrong(table, path, problems),
        )

    @classmethod
    def from_key(cls, row: Mapping[str, Any], common: Common) -> Self:
        """What is accepted and what is known to be wrong, beside the rubric."""
        key, said = row["key"], row.get("feedback", {})
        new = row.get(AS_WRITTEN) is True
        return cls(
            common=common,
            rubric=_rubric_of_key(row, common),
            accept=of_key(key["accept"], as_written=new),
            wrong=tuple(
                (
                    of_key(w["texts"], as_written=new),
                    str(w["belief"]),
                    str(said.get(f"wrong-{k}", "")),
                )
                for k, w in enumerate(key["wrong"])
            ),
        )

    @property
    def free(self) -> bool:
        """Without accepted texts a person has to read it."""
        return not self.accept

    def key(self) -> dict[str, Any]:
        """What is right and what is known to be wrong, as written: people read it too."""
        return {
            "accept": list(self.accept),
            "wrong": [{"texts": list(texts), "belief": belief} for texts, belief, _ in self.wrong],
            "feedback": sorted(self.feedback()),
        }

    def feedback(self) -> dict[str, str]:
        """The feedback of the known wrong answers."""
        return {f"wrong-{k}": given for k, (_, _, given) in enumerate(self.wrong) if given}

    def mark(self, value: object, own: float | None = None) -> Mark:
        """Right if it is one of the accepted texts."""
        if is_empty(value) or not isinstance(value, str) or not self.accept:
            return super(Short, self).mark(value, own)
        said = plain(value)
        right = said in [plain(text) for text in self.accept]
        shown: tuple[str, ...] = ()
        beliefs: tuple[str, ...] = ()
        if not right:
            for k, (texts, belief, given) in enumerate(self.wrong):
                if said in [plain(text) for text in texts]:
                    shown = (f"wrong-{k}",) if given else ()
                    beliefs = (belief,) if belief else ()
                    break
        return all_or_nothing(right, False, self.worth, shown=shown, beliefs=beliefs)


def _rubric_of_key(row: Mapping[str, Any], common: Common) -> Mapping[int, str]:
    found = {int(marks): str(text) for marks, text in row.get("rubric", {}).items()}
    return found or {common.marks: ""}


def _rubric(
    table: Mapping[str, Any], path: Path, problems: list[Problem], *, required: bool
) -> Mapping[int, str]:
    hint = "rubric:\n    1: says that the two forces are equal\n    0: anything else"
    if "rubric" not in table:
        if required:
            message = "rubric is missing: every text question says what its marks are given for"
            problems.append(Problem(path, "missing", message, hint))
        return {}
    rows = mapping(table["rubric"], (*path, "rubric"), problems, hint)
    if rows is None:
        return {}
    found = {}
    for key, value in rows.items():
        if not str(key).isdecimal() or not isinstance(value, (str, int)):
            message = "a rubric has whole numbers of marks on the left and a text on the right"
            problems.append(Problem((*path, "rubric", str(key)), "not-a-table", message, hint))
            return {}
        found[int(key)] = str(value)
    if sorted(found) != list(range(len(found))) or len(found) < 2:
        message = "a rubric names every number of marks from 0 up"
        if found and sorted(found) == list(range(1, len(found) + 1)):
            hint = "add 0: anything else"
        problems.append(Problem((*path, "rubric"), "out-of-range", message, hint))
    elif max(found) > MOST_MARKS:
        message = f"a rubric gives at most {MOST_MARKS} marks: a teacher gives them with one key"
        problems.append(Problem((*path, "rubric"), "out-of-range", message, hint))
    elif isinstance(marks := table.get("marks"), int) and marks != max(found):
        message = f"marks is {marks}, and the rubric gives up to {max(found)}"
        told = "leave marks out: the largest number of the rubric is what the question is worth"
        problems.append(Problem((*path, "marks"), "out-of-range", message, told))
    return dict(sorted(found.items()))
