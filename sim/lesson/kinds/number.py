"""A number with a unit and a stated tolerance."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, ClassVar, Self

from sim.lesson import keys, units
from sim.lesson.beliefs import BELIEFS
from sim.lesson.keys import NUMBER_OR_TEXT, PROSE, Key
from sim.lesson.kinds.measured_number import (
    TOLERANCE,
    as_asked,
    is_number,
    lacks_unit,
    read_number,
    read_right,
    read_tolerance,
    read_unit,
)
from sim.lesson.kinds.options import read_belief
from sim.lesson.mark import Mark, all_or_nothing, is_empty
from sim.lesson.question import Common, Question
from sim.scene.problem import Path, Problem
from sim.scene.quantity import Dimension

WRONG_KEYS = (
    Key("value", "a wrong answer that is often given", "0.60 m/s", NUMBER_OR_TEXT, True),
    Key("tolerance", "how near counts; default: the question's", "0.01 m/s", NUMBER_OR_TEXT),
    Key("belief", "tag of the belief behind it", "motion-needs-force", {"enum": sorted(BELIEFS)}),
    Key("feedback", "shown to who gave it", "That is the speed before the contact.", PROSE),
)
NEAR = 1 + 1e-9  # a number on the edge of the tolerance is inside, whatever its last bit
LAST_BITS = 1e-12  # of the answer: 70 cm/s are 0.7 m/s also where the tolerance is 0


@dataclass(frozen=True, slots=True, kw_only=True)
class Wrong:
    """A wrong answer that is known; numbers in the question's unit."""

    value: float
    tolerance: float
    belief: str = ""
    feedback: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Number(Question):
    """The value is the number in the question's unit, or the text that could not be read."""

    KIND: ClassVar[str] = "number"
    SAYS: ClassVar[str] = "type a number; any fitting unit may be typed with it"
    KEYS: ClassVar[tuple[Key, ...]] = (
        Key("answer", "the right number with its unit", "0.25 m/s", NUMBER_OR_TEXT, True),
        TOLERANCE,
        Key("wrong", "wrong answers with feedback of their own",
            "[{value: 0.60 m/s, belief: motion-needs-force}]",
            {"type": "array", "items": {"type": "object", "required": ["value"],
             "properties": {key.name: key.schema for key in WRONG_KEYS},
             "additionalProperties": False}}),
    )  # fmt: skip
    answer: float
    tolerance: float
    unit: str
    units: Mapping[str, float]
    wrong: tuple[Wrong, ...] = ()

    @classmethod
    def read(
        cls, table: Mapping[str, Any], common: Common, path: Path, problems: list[Problem]
    ) -> Self:
        """The answer's unit is the question's; a tolerance that nobody can meet is a problem."""
        before = len(problems)
        unit, dimension = read_unit(table, "answer", path, problems)
        others = units.of_others(_numbers(table), dimension) if "answer" in table else ""
        if len(problems) == before and others and is_number(table, "answer", path, problems):
            given = f"in {unit}" if unit else "a plain number"
            message = f"the answer is {given}, the other numbers of this question are in {others}"
            hint = f"answer: {_without(unit, table['answer'])} {others}"
            if unit and not table.get("wrong"):  # either of the two may be the slip
                hint += f", or tolerance: {_without(others, table['tolerance'])} {unit}"
            problems.append(Problem((*path, "answer"), "wrong-unit", message, hint))
        if len(problems) > before:  # whatever is said about the rest would follow from this
            return cls(common=common, answer=0, tolerance=0, unit="", units={})
        measured = unit, dimension
        right = read_right(table, measured, path, problems)
        wrong = _wrong(table, right, measured, path, problems)
        return cls(common=common, **as_asked(right, measured), wrong=wrong)

    @classmethod
    def from_key(cls, row: Mapping[str, Any], common: Common) -> Self:
        """The interval, and the wrong answers that are known."""
        key, said = row["key"], row.get("feedback", {})
        wrong = tuple(
            Wrong(
                value=float(w["value"]),
                tolerance=float(w["tolerance"]),
                belief=str(w["belief"]),
                feedback=str(said.get(f"wrong-{k}", "")),
            )
            for k, w in enumerate(key["wrong"])
        )
        units = {str(name): float(factor) for name, factor in row["units"].items()}
        return cls(
            common=common, answer=float(key["answer"]), tolerance=float(key["tolerance"]),
            unit=str(row["unit"]), units=units, wrong=wrong,
        )  # fmt: skip

    def asked(self) -> dict[str, Any]:
        """The unit beside the box, and all that may be typed instead."""
        return {"unit": self.unit, "units": dict(self.units)}

    def key(self) -> dict[str, Any]:
        """The interval, and the wrong answers that are known."""
        return {
            "answer": self.answer,
            "tolerance": self.tolerance,
            "wrong": [
                {"value": w.value, "tolerance": w.tolerance, "belief": w.belief} for w in self.wrong
            ],
            "feedback": sorted(self.feedback()),
        }

    def feedback(self) -> dict[str, str]:
        """The feedback of the known wrong answers."""
        return {f"wrong-{k}": w.feedback for k, w in enumerate(self.wrong) if w.feedback}

    def meaning(self) -> dict[str, Any]:
        """The unit."""
        return {"unit": self.unit}

    def mark(self, value: object, own: float | None = None) -> Mark:
        """Right within the tolerance."""
        del own
        return mark_number(value, self.answer, self.tolerance, self.common.marks, self.wrong)


def mark_number(
    value: object, answer: float, tolerance: float, of: int, wrong: tuple[Wrong, ...] = ()
) -> Mark:
    """Marks a number that is already in the question's unit."""
    if is_empty(value):
        return Mark("empty", 0, of)
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
        return Mark("unclear", 0, of)
    if abs(value - answer) <= tolerance * NEAR + LAST_BITS * abs(answer):
        return all_or_nothing(True, False, of)
    k = known_wrong(value, wrong)
    if k is None:
        return all_or_nothing(False, False, of)
    shown = (f"wrong-{k}",) if wrong[k].feedback else ()
    beliefs = (wrong[k].belief,) if wrong[k].belief else ()
    return all_or_nothing(False, False, of, shown=shown, beliefs=beliefs)


def known_wrong(value: float, wrong: Sequence[Wrong]) -> int | None:
    """Which known wrong number this one is, from 0: the first that is near enough."""
    near = (k for k, w in enumerate(wrong) if abs(value - w.value) <= w.tolerance * NEAR)
    return next(near, None)


def _without(unit: str, value: object) -> str:
    return str(value).strip().removesuffix(unit).strip()


def _numbers(table: Mapping[str, Any]) -> list[Any]:
    """Tolerance and known wrong answers, as far as they are written."""
    rows = table.get("wrong")
    rows = [row for row in rows if isinstance(row, dict)] if isinstance(rows, list) else []
    return [table.get("tolerance"), *(row.get("value") for row in rows)]


def _wrong(
    table: Mapping[str, Any],
    right: tuple[Fraction, Fraction],
    measured: tuple[str, Dimension],
    path: Path,
    problems: list[Problem],
) -> tuple[Wrong, ...]:
    unit, dimension = measured
    hint = "wrong:\n    - {value: 0.60 m/s, feedback: That is the speed before.}"
    found = []
    for here, row in keys.tables(table, "wrong", WRONG_KEYS, path, problems, hint):
        before = len(problems)
        value = read_number(row, "value", dimension, here, problems)
        if dimension is not units.RATIO:  # beside 50 % a plain 0.2 is 20 %, and is meant
            lacks_unit(row, measured, here, problems, "value")
        tolerance = (
            read_tolerance(row, value, measured, here, problems) if "tolerance" in row else right[1]
        )
        if len(problems) == before and abs(value - right[0]) <= right[1]:
            message = "this wrong answer lies within the tolerance of the right one"
            problems.append(Problem((*here, "value"), "unreachable", message, "narrow it"))
        found.append(
            Wrong(
                value=units.tidy(value, unit, dimension),
                tolerance=units.tidy(tolerance, unit, dimension),
                belief=read_belief(row, here, problems),
                feedback=keys.text(row, "feedback", here, problems) or "",
            )
        )
    return tuple(found)
