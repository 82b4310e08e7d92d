"""What every question has, whatever its kind, and what each kind must be able to do."""

from __future__ import annotations

import hashlib
import json
from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Self

from sim.lesson import keys
from sim.lesson.keys import PROSE, PROSES, TEXT, TEXTS, Key, one_of
from sim.lesson.mark import Mark
from sim.scene.fence.presentation import ID
from sim.scene.problem import Path, Problem

LEVELS = ("core", "support", "stretch")
CERTAINTY = ("guess", "think", "sure")

COMMON_KEYS = (
    Key("id", "name of the question, one of its kind in the site; never change it", "why-equal", {
        "type": "string", "pattern": f"^{ID.pattern}$"}, True),
    Key("type", "kind of question", "single", TEXT, True),
    Key("ask", "the question, in Markdown", '"What is the force on B by A?"', PROSE, True),
    Key("level", "for everybody, for who needs help, for who wants more", "core", one_of(*LEVELS)),
    Key("minutes", "how long it takes; `carts check` adds them up", "3", {
        "type": "integer", "minimum": 1}),
    Key("marks", "what a right answer is worth", "1", {"type": "integer", "minimum": 1}),
    Key("sure", "ask how sure the student is: guess, think, sure", "true", {"type": "boolean"}),
    Key("hints", "one hint or a list, shown one after the other", "Look at the v graph.", PROSES),
    Key("explain", "the answer explained; shown after a right answer, or on the third try",
        "The two forces are a pair.", PROSE),
    Key("topics", "words by which a form draws items from a bank", "[first-law, table]", TEXTS),
    Key("note", "for the teacher; never in the page", "Most choose A at first.", PROSE),
    Key("after", "id of the scene that is watched first; with “.forces” behind it: whose hidden "
        "forces are found first; “none”: this question is open at once", "two-carts"),
    Key("idea", "id of a first idea (type: idea), shown again beside this answer", "first-idea"),
)  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class Common:
    """The keys of every question. Texts are Markdown; an empty text: none."""

    id: str
    ask: str
    level: str = "core"
    minutes: int | None = None
    marks: int = 1
    sure: bool = False
    hints: tuple[str, ...] = ()
    explain: str = ""
    topics: tuple[str, ...] = ()
    note: str = ""
    idea: str = ""
    after: str = ""


def read_common(table: Mapping[str, Any], path: Path, problems: list[Problem]) -> Common:
    """The common keys of a block; what is missing or wrong becomes a problem."""
    identity = table.get("id")
    if not isinstance(identity, str) or not ID.fullmatch(identity):
        given = "id" in table
        problems.append(
            Problem(
                (*path, "id") if given else path,
                "bad-name" if given else "missing",
                f"“{str(identity)[:40]}” cannot be an id" if given else "id is missing",
                "small letters, digits and hyphens, one of its kind in the whole site: "
                "id: why-equal",
            )
        )
    return Common(
        id=str(identity),
        ask=keys.needed(table, "ask", path, problems, "ask: What is the force on B by A?"),
        level=keys.choice(table, "level", LEVELS, path, problems),
        minutes=keys.whole(table, "minutes", path, problems, default=1)
        if "minutes" in table
        else None,
        marks=keys.whole(table, "marks", path, problems, default=1),
        sure=keys.flag(table, "sure", path, problems, default=False),
        hints=keys.texts(table, "hints", path, problems, "hints: [Look at the v graph.]"),
        explain=keys.text(table, "explain", path, problems) or "",
        topics=keys.texts(table, "topics", path, problems, "topics: [first-law]"),
        note=keys.text(table, "note", path, problems) or "",
        idea=keys.text(table, "idea", path, problems) or "",
        after=keys.text(table, "after", path, problems) or "",
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class Question(ABC):
    """One question. Subclasses are the kinds; each is one file in sim/lesson/kinds."""

    KIND: ClassVar[str]
    SAYS: ClassVar[str]
    KEYS: ClassVar[tuple[Key, ...]] = ()
    MARKED: ClassVar[bool] = True
    """False: no answer is right or wrong, so that nobody marks one, the teacher neither."""
    common: Common

    @classmethod
    @abstractmethod
    def read(
        cls, table: Mapping[str, Any], common: Common, path: Path, problems: list[Problem]
    ) -> Self:
        """The question in `table`; problems are collected, and then the result is not used."""

    @classmethod
    @abstractmethod
    def from_key(cls, row: Mapping[str, Any], common: Common) -> Self:
        """The question again, from its row of a key file: what `asked` and `key` have written.

        Raises KeyError, TypeError or ValueError where the row is damaged.
        """

    @abstractmethod
    def asked(self) -> dict[str, Any]:
        """What the page must know to ask it. Never the key."""

    @abstractmethod
    def key(self) -> dict[str, Any]:
        """What the page or the teacher needs to mark it."""

    @abstractmethod
    def mark(self, value: object, own: float | None = None) -> Mark:
        """Marks an answer; `own` is the quantity in the student's own run, where that counts."""

    def texts(self) -> dict[str, str]:
        """Markdown that the page shows in any case, by the name of its place."""
        return {}

    def feedback(self) -> dict[str, str]:
        """Markdown that is part of the key, by its name in `Mark.shown`."""
        return {}

    def meaning(self) -> dict[str, Any]:
        """What the answer is an answer to: if this changes, an old answer is kept apart."""
        return {"texts": self.texts(), **self.asked()}

    @property
    def free(self) -> bool:
        """Whether the answer is the student's own words, which a person reads."""
        return False

    @property
    def id(self) -> str:
        """The question's id, as it is written by the author."""
        return self.common.id

    @property
    def hash(self) -> str:
        """Twelve hexadecimal digits that change when the meaning of an answer does."""
        meaning = _squeezed({"type": self.KIND, "ask": self.common.ask, **self.meaning()})
        text = json.dumps(meaning, ensure_ascii=False, sort_keys=True, separators=(",", ":"))
        return hashlib.sha256(text.encode("utf-8")).hexdigest()[:12]

    def data(self, *, key: bool) -> dict[str, Any]:
        """The facts for the page; with the key only where the page may mark."""
        c = self.common
        facts: dict[str, Any] = {
            "id": c.id, "hash": self.hash, "type": self.KIND, "level": c.level, "marks": c.marks,
            "sure": c.sure, **self.asked(),
        }  # fmt: skip
        if c.idea:
            facts["idea"] = c.idea
        if key:
            facts["key"] = self.key()
        return facts


def _squeezed(value: Any) -> Any:
    """The same value with every run of spaces as one: wrapping a line anew changes nothing."""
    if isinstance(value, str):
        return " ".join(value.split())
    if isinstance(value, Mapping):
        return {key: _squeezed(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_squeezed(item) for item in value]
    return value
