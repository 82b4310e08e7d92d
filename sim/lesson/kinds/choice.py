"""Choosing: one answer (`single`) or several (`multiple`)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Self

from sim.lesson.keys import Key
from sim.lesson.kinds.options import (
    OPTIONS,
    RIGHT,
    Option,
    beliefs_of,
    options_of_key,
    read_options,
    texts_of,
)
from sim.lesson.mark import Mark, all_or_nothing, is_empty
from sim.lesson.question import Common, Question
from sim.scene.problem import Path, Problem


@dataclass(frozen=True, slots=True, kw_only=True)
class Single(Question):
    """One answer is right. The value is the id of the chosen answer."""

    KIND: ClassVar[str] = "single"
    SAYS: ClassVar[str] = "choose one answer"
    KEYS: ClassVar[tuple[Key, ...]] = (OPTIONS,)
    options: tuple[Option, ...]

    @classmethod
    def read(
        cls, table: Mapping[str, Any], common: Common, path: Path, problems: list[Problem]
    ) -> Self:
        """Two or more options, exactly one of them right."""
        options = read_options(table, path, problems)
        count = sum(option.correct for option in options)
        if options and count != 1:
            what = "no option is right" if not count else f"{count} options are right"
            problems.append(
                Problem(
                    (*path, "options"),
                    "no-correct-option" if not count else "two-correct-options",
                    f"{what}; a single choice has exactly one",
                    RIGHT
                    if not count
                    else "keep correct: true at one option, or write type: multiple",
                )
            )
        return cls(common=common, options=options)

    @classmethod
    def from_key(cls, row: Mapping[str, Any], common: Common) -> Self:
        """The options, in the order shown."""
        return cls(common=common, options=options_of_key(row))

    def asked(self) -> dict[str, Any]:
        """The ids in the order shown."""
        return {"options": [option.id for option in self.options]}

    def key(self) -> dict[str, Any]:
        """The right ids, and the belief behind each wrong one."""
        return {
            "correct": [option.id for option in self.options if option.correct],
            "beliefs": beliefs_of(self.options),
            "feedback": sorted(self.feedback()),
        }

    def texts(self) -> dict[str, str]:
        """The text of each option."""
        return texts_of(self.options)

    def feedback(self) -> dict[str, str]:
        """The feedback of each option that has one."""
        given = {f"option-{option.id}": option.feedback for option in self.options}
        return {name: text for name, text in given.items() if text}

    def meaning(self) -> dict[str, Any]:
        """Texts by id: another order of the same answers changes nothing."""
        return {"texts": self.texts()}

    def mark(self, value: object, own: float | None = None) -> Mark:
        """Right if the right one is chosen."""
        del own
        if is_empty(value):
            return Mark("empty", 0, self.common.marks)
        by_id = {option.id: option for option in self.options}
        chosen = by_id.get(value) if isinstance(value, str) else None
        if chosen is None:
            return Mark("unclear", 0, self.common.marks)
        return self._marked([chosen], chosen.correct, some=False)

    def _marked(self, chosen: list[Option], right: bool, *, some: bool) -> Mark:
        return all_or_nothing(
            right,
            some,
            self.common.marks,
            shown=tuple(f"option-{option.id}" for option in chosen if option.feedback),
            beliefs=tuple(option.belief for option in chosen if option.belief),
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class Multiple(Single):
    """Several answers may be right. The value is the list of chosen ids."""

    KIND: ClassVar[str] = "multiple"
    SAYS: ClassVar[str] = "choose every answer that fits"

    @classmethod
    def read(
        cls, table: Mapping[str, Any], common: Common, path: Path, problems: list[Problem]
    ) -> Self:
        """Two or more options, at least one of them right."""
        options = read_options(table, path, problems)
        if options and not any(option.correct for option in options):
            problems.append(
                Problem(
                    (*path, "options"),
                    "no-correct-option",
                    "no option is right",
                    RIGHT,
                )
            )
        return cls(common=common, options=options)

    def mark(self, value: object, own: float | None = None) -> Mark:
        """Right if exactly the right ones are chosen; partly if at least one of them is."""
        del own
        if is_empty(value):
            return Mark("empty", 0, self.common.marks)
        ids = {option.id for option in self.options}
        if not isinstance(value, (list, tuple)) or not all(
            isinstance(item, str) and item in ids for item in value
        ):
            return Mark("unclear", 0, self.common.marks)
        chosen = [option for option in self.options if option.id in value]
        right = {option.id for option in self.options if option.correct}
        exact = {option.id for option in chosen} == right
        return self._marked(chosen, exact, some=any(option.correct for option in chosen))
