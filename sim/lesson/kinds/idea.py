"""A first idea: kept as it is and never marked, to be looked at again with evidence."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, ClassVar, Self

from sim.lesson.keys import Key
from sim.lesson.kinds.options import (
    OPTIONS,
    Option,
    beliefs_of,
    options_of_key,
    read_options,
    texts_of,
)
from sim.lesson.mark import Mark, is_empty
from sim.lesson.question import Common, Question
from sim.scene.problem import Path, Problem


@dataclass(frozen=True, slots=True, kw_only=True)
class Idea(Question):
    """The value is the id of an option; without options a text. Nothing is right or wrong here."""

    KIND: ClassVar[str] = "idea"
    SAYS: ClassVar[str] = "say your first idea: it is kept, and never marked"
    MARKED: ClassVar[bool] = False
    KEYS: ClassVar[tuple[Key, ...]] = (
        replace(OPTIONS, example="[They are equal., A pushes harder.]", required=False),
    )
    options: tuple[Option, ...] = ()

    @classmethod
    def read(
        cls, table: Mapping[str, Any], common: Common, path: Path, problems: list[Problem]
    ) -> Self:
        """Two or more options, none of them right; or none at all."""
        options = read_options(table, path, problems) if "options" in table else ()
        for k, option in enumerate(options):
            if option.correct or option.feedback:
                name = "correct" if option.correct else "feedback"
                problems.append(
                    Problem(
                        (*path, "options", k, name),
                        "unknown-key",
                        "an idea is never marked: nothing is said to it",
                        f"remove {name}, or write type: single",
                    )
                )
        return cls(common=common, options=options)

    @classmethod
    def from_key(cls, row: Mapping[str, Any], common: Common) -> Self:
        """The options, in the order shown."""
        return cls(common=common, options=options_of_key(row))

    def asked(self) -> dict[str, Any]:
        """The ids in the order shown."""
        return {"options": [option.id for option in self.options], "marks": 0}

    def key(self) -> dict[str, Any]:
        """The belief that may be behind each option: for the teacher's table."""
        return {"correct": [], "beliefs": beliefs_of(self.options), "feedback": []}

    def texts(self) -> dict[str, str]:
        """The text of each option."""
        return texts_of(self.options)

    def meaning(self) -> dict[str, Any]:
        """Texts by id: another order of the same answers changes nothing."""
        return {"texts": self.texts()}

    def mark(self, value: object, own: float | None = None) -> Mark:
        """Nothing to mark."""
        del own
        if is_empty(value):
            return Mark("empty", 0, 0)
        known = {option.id for option in self.options}
        fits = isinstance(value, str) and (not known or value in known)
        return Mark("open" if fits else "unclear", None, 0)
