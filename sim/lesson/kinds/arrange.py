"""Putting things in order (`ordering`) and joining pairs (`matching`).

The page shows the parts in an order of its own, made from their texts: the names of the parts must
not give the right order away. The key names them by the letters under which they stand there.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, ClassVar, Self

from sim.lesson import keys
from sim.lesson.keys import PROSE, PROSES, Key
from sim.lesson.kinds.options import LETTERS
from sim.lesson.kinds.pictures import alike, places
from sim.lesson.mark import Mark, all_or_nothing, is_empty
from sim.lesson.question import Common, Question
from sim.scene.problem import Path, Problem, nearest
from sim.scene.tables import unknown_keys

PAIR_KEYS = (
    Key("left", "what stands on the left", "on A", PROSE, True),
    Key("right", "what belongs to it", "force on A by B", PROSE, True),
)


def shown_order(texts: tuple[str, ...], salt: str) -> tuple[int, ...]:
    """An order that tells nothing, the same in every build, and never the right one itself."""

    def place(k: int) -> str:
        return hashlib.sha256(f"{salt}\n{' '.join(texts[k].split())}".encode()).hexdigest()

    order = tuple(sorted(range(len(texts)), key=place))
    right = tuple(range(len(texts)))
    return order if order != right else (*order[1:], order[0])


@dataclass(frozen=True, slots=True, kw_only=True)
class Ordering(Question):
    """The value is the list of letters in the student's order."""

    KIND: ClassVar[str] = "ordering"
    SAYS: ClassVar[str] = "put the lines into the right order"
    KEYS: ClassVar[tuple[Key, ...]] = (
        Key("order", "the lines in the right order; the page shows them in another",
            "[A touches B, both forces grow, both forces fade]",
            {"type": "array", "items": PROSE, "minItems": 3}, True),
    )  # fmt: skip
    order: tuple[str, ...]

    @classmethod
    def read(
        cls, table: Mapping[str, Any], common: Common, path: Path, problems: list[Problem]
    ) -> Self:
        """Three lines or more, all different."""
        before, hint = len(problems), "order: [first, second, third]"
        lines = keys.texts(table, "order", path, problems, hint)
        if len(problems) == before and not 3 <= len(lines) <= len(LETTERS):
            where = (*path, "order") if "order" in table else path
            message = f"order lists 3 to {len(LETTERS)} different lines"
            problems.append(Problem(where, "not-a-list", message, hint))
        alike(lines, places((*path, "order"), lines), problems)
        return cls(common=common, order=lines)

    @classmethod
    def from_key(cls, row: Mapping[str, Any], common: Common) -> Self:
        """The lines of the page, in the order of the key."""
        texts = row["texts"]
        order = tuple(str(texts[f"line-{letter}"]) for letter in row["key"]["order"])
        return cls(common=common, order=order)

    @property
    def shown(self) -> tuple[int, ...]:
        """The places in `order` of the lines A, B, C … of the page."""
        return shown_order(self.order, self.common.id)

    def asked(self) -> dict[str, Any]:
        """The letters in the order shown."""
        return {"lines": list(LETTERS[: len(self.order)])}

    def key(self) -> dict[str, Any]:
        """The letters in the right order."""
        shown = self.shown
        right = [LETTERS[shown.index(k)] for k in range(len(self.order))]
        return {"order": right, "feedback": []}

    def texts(self) -> dict[str, str]:
        """The lines under their letters."""
        return {f"line-{LETTERS[at]}": self.order[k] for at, k in enumerate(self.shown)}

    def meaning(self) -> dict[str, Any]:
        """The lines under their letters."""
        return {"texts": self.texts()}

    def mark(self, value: object, own: float | None = None) -> Mark:
        """Right as a whole; partly if at least half of the neighbours follow each other rightly."""
        del own
        of = self.common.marks
        if is_empty(value):
            return Mark("empty", 0, of)
        right = self.key()["order"]
        if not isinstance(value, (list, tuple)) or sorted(map(str, value)) != sorted(right):
            return Mark("unclear", 0, of)
        followed = list(pairwise(right))
        kept = sum(pair in followed for pair in pairwise(value))
        return all_or_nothing(list(value) == right, 2 * kept >= len(followed), of)


@dataclass(frozen=True, slots=True, kw_only=True)
class Matching(Question):
    """The value is a table from the number on the left to the letter on the right."""

    KIND: ClassVar[str] = "matching"
    SAYS: ClassVar[str] = "find what belongs together"
    KEYS: ClassVar[tuple[Key, ...]] = (
        Key("pairs", "what belongs together, two pairs or more",
            "[{left: on A, right: force on A by B}, {left: on B, right: force on B by A}]",
            {"type": "array", "minItems": 2, "items": {"type": "object",
             "properties": {key.name: key.schema for key in PAIR_KEYS},
             "required": ["left", "right"], "additionalProperties": False}}, True),
        Key("others", "more on the right that belongs to nothing", "[force on A by the Earth]",
            PROSES),
    )  # fmt: skip
    left: tuple[str, ...]
    right: tuple[str, ...]  # those of `left` first, then the others

    @classmethod
    def read(
        cls, table: Mapping[str, Any], common: Common, path: Path, problems: list[Problem]
    ) -> Self:
        """Two pairs or more; on the right all different."""
        hint = (
            "pairs:\n    - {left: on A, right: force on A by B}"
            "\n    - {left: on B, right: force on B by A}"
        )
        listed = table.get("pairs")
        here = (*path, "pairs") if "pairs" in table else path
        if not isinstance(listed, (list, tuple)) or len(listed) < 2:
            problems.append(Problem(here, "not-a-list", "pairs lists two or more pairs", hint))
            return cls(common=common, left=(), right=())
        left, right, read = [], [], []
        for k, entry in enumerate(listed):
            known = keys.names(PAIR_KEYS)
            if not isinstance(entry, Mapping) or not any(nearest(str(e), known) for e in entry):
                message = "a pair has a left and a right"
                problems.append(Problem((*here, k), "not-a-table", message, hint))
                continue
            unknown_keys(entry, known, (*here, k), problems)
            read.append(k)
            left.append(keys.needed(entry, "left", (*here, k), problems, hint))
            right.append(keys.needed(entry, "right", (*here, k), problems, hint))
        others = keys.texts(table, "others", path, problems, "others: [something else]")
        right += others
        if len(right) > len(LETTERS):
            message = f"on the right stand at most {len(LETTERS)} texts"
            problems.append(Problem(here, "not-a-list", message, hint))
        several = isinstance(table.get("others"), (list, tuple))
        beside = places((*path, "others"), others) if several else [(*path, "others")]
        rows = [(*here, k, "right") for k in read]
        alike(right, [*rows, *beside[: len(others)]], problems)
        alike(left, [(*here, k, "left") for k in read], problems)
        return cls(common=common, left=tuple(left), right=tuple(right))

    @classmethod
    def from_key(cls, row: Mapping[str, Any], common: Common) -> Self:
        """The pairs in their order, then what belongs to nothing."""
        pairs, texts = row["key"]["pairs"], row["texts"]
        letters = [pairs[number] for number in row["left"]]
        others = [letter for letter in row["right"] if letter not in letters]
        question = cls(
            common=common,
            left=tuple(str(texts[f"left-{number}"]) for number in row["left"]),
            right=tuple(str(texts[f"right-{letter}"]) for letter in (*letters, *others)),
        )
        if question.key()["pairs"] != pairs:
            raise ValueError("the letters of this item are not those of the page")
        return question

    @property
    def shown(self) -> tuple[int, ...]:
        """The places in `right` of A, B, C … of the page."""
        return shown_order(self.right, self.common.id)

    def asked(self) -> dict[str, Any]:
        """Numbers on the left, letters on the right."""
        return {
            "left": [str(k + 1) for k in range(len(self.left))],
            "right": list(LETTERS[: len(self.right)]),
        }

    def key(self) -> dict[str, Any]:
        """The right letter for each number."""
        shown = self.shown
        pairs = {str(k + 1): LETTERS[shown.index(k)] for k in range(len(self.left))}
        return {"pairs": pairs, "feedback": []}

    def texts(self) -> dict[str, str]:
        """The texts under their numbers and letters."""
        left = {f"left-{k + 1}": text for k, text in enumerate(self.left)}
        return left | {f"right-{LETTERS[at]}": self.right[k] for at, k in enumerate(self.shown)}

    def meaning(self) -> dict[str, Any]:
        """The texts under their numbers and letters."""
        return {"texts": self.texts()}

    def mark(self, value: object, own: float | None = None) -> Mark:
        """Right as a whole; partly if at least one pair is. `shown` names those: `pair-1`."""
        del own
        of = self.common.marks
        if is_empty(value):
            return Mark("empty", 0, of)
        pairs = self.key()["pairs"]
        letters = set(LETTERS[: len(self.right)])
        if not isinstance(value, Mapping) or not all(
            number in pairs and letter in letters for number, letter in value.items()
        ):
            return Mark("unclear", 0, of)
        good = [number for number in pairs if value.get(number) == pairs[number]]
        shown = tuple(f"pair-{number}" for number in good)
        return all_or_nothing(len(good) == len(pairs), bool(good), of, shown=shown)
