"""A goal for a reader's own runs: what one quantity of the run must be, beside another or a number.

    goal: v.A = 0                    the cart stops dead
    goal: largest F.A-B > 20 N       a hard blow
    goal: F.B = 2 F.A                twice the force (nobody has found one)

A quantity is x, v, a, p of a cart, F of a pair (`F.A-B`) or on a cart (`F.A`, of whatever touches
it). Its moment is `start`, `end` or `largest`; without one forces and accelerations are meant at
their largest, all else at the end of the run. Equal means equal within `NEAR`.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Literal, cast

from sim.lesson.units import OF_QUANTITY
from sim.scene.problem import Path, Problem
from sim.scene.quantity import Dimension, QuantityError, read_quantity

NEAR = 0.02
"""Of the larger side (of the largest such quantity in the run, beside 0): what a reader can set
with sliders and see on a graph."""

Relation = Literal["=", "<", ">"]
Moment = Literal["start", "end", "largest"]
EXAMPLE = "goal: v.A = 0, goal: largest F.A-B > 20 N or goal: F.B = 2 F.A"

_SIDES = re.compile(r"([^=<>]+)(=|<|>)([^=<>]+)")
_TERM = re.compile(
    r"(?:(?P<at>start|end|largest)\s+)?(?:(?P<factor>\d+(?:\.\d+)?|\.\d+)\s*[·*×]?\s*)?"
    r"(?P<quantity>[xvapF]\.[A-Za-z][\w-]*)"
)


@dataclass(frozen=True, slots=True)
class Term:
    """`factor` times a quantity at a moment; without a quantity `factor` is the number, in SI."""

    factor: float
    quantity: str = ""
    at: Moment = "end"


@dataclass(frozen=True, slots=True)
class Goal:
    """A comparison that a run fulfils or not."""

    left: Term
    relation: Relation
    right: Term

    @property
    def quantities(self) -> tuple[str, ...]:
        """Those that the scene must have."""
        return tuple(term.quantity for term in (self.left, self.right) if term.quantity)


def read_goal(value: object, path: Path, problems: list[Problem]) -> Goal | None:
    """The goal in `value`, or None and a problem."""
    sides = _SIDES.fullmatch(str(value).strip()) if isinstance(value, str) else None
    if sides is None:
        message = "a goal compares two things by =, < or >"
        problems.append(Problem(path, "not-a-goal", message, EXAMPLE))
        return None
    first, second = sides[1].strip(), sides[3].strip()
    found = {text: _term(text) for text in (first, second)}
    known = next((term for term in found.values() if term), None)
    if known is None:
        message = f"“{first[:40]}” is no quantity of a run"
        problems.append(Problem(path, "unknown-path", message, EXAMPLE))
        return None
    dimension = OF_QUANTITY[known.quantity[0]]
    left = found[first] or _number(first, dimension, path, problems)
    right = found[second] or _number(second, dimension, path, problems)
    if left is None or right is None:
        return None
    if len({term.quantity[:1] for term in (left, right) if term.quantity}) > 1:
        message = f"{left.quantity} and {right.quantity} are not of one kind"
        problems.append(Problem(path, "not-a-goal", message, EXAMPLE))
        return None
    return Goal(left, cast(Relation, sides[2]), right)


def _term(text: str) -> Term | None:
    match = _TERM.fullmatch(text)
    if match is None:
        return None
    quantity = match["quantity"]
    at: Moment = "largest" if quantity[0] in "Fa" else "end"
    if match["at"]:
        at = cast(Moment, match["at"])
    return Term(float(match["factor"] or 1), quantity, at)


def _number(text: str, dimension: Dimension, path: Path, problems: list[Problem]) -> Term | None:
    try:
        return Term(float(read_quantity(text, dimension)))
    except QuantityError as error:
        problems.append(Problem(path, error.code, error.message, error.hint or EXAMPLE))
        return None
