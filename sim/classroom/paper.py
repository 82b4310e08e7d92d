"""The tables of the paper, as it printed them, and what can be computed from them.

The printed numbers stand in docs/evidence/*.csv. Nothing here is typed in: every Z, P, gain and
difference on the page comes from those files. Source: arXiv:1303.0081, Tables I to III.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from sim.classroom.statistics.adjusted import Adjusted, adjusted, from_deviations
from sim.classroom.statistics.compare import PaperZ, cohen_d, paper_z
from sim.classroom.statistics.gain import hake_gain
from sim.classroom.statistics.spread import Spread

LAWS = ("first", "third")
EXPERIMENTAL, CONTROL = "experimental", "control"
TOTAL = "total"


@dataclass(frozen=True, slots=True)
class Tested:
    """A group in Table II, before and after; `gain`: of the students one by one."""

    of: int
    before: Spread
    after: Spread
    gain: Spread

    @property
    def hake(self) -> float:
        """Hake's gain, from the means."""
        return hake_gain(self.before.mean, self.after.mean, self.of)


@dataclass(frozen=True, slots=True)
class Law:
    """Table II for one law. Differences are experimental minus control."""

    experimental: Tested
    control: Tested
    printed_z: float
    printed_p: float

    @property
    def z(self) -> PaperZ:
        """Equation (4) for the gains."""
        return paper_z(self.experimental.gain, self.control.gain)

    @property
    def baseline(self) -> PaperZ:
        """Equation (4) for the marks before anything was taught. Ours."""
        return paper_z(self.experimental.before, self.control.before)

    @property
    def d(self) -> float:
        """Cohen's d of the gains. Ours."""
        return cohen_d(self.experimental.gain, self.control.gain)

    @property
    def adjusted(self) -> Adjusted:
        """The difference after the same start. Ours. Needs scipy."""
        one, other = (
            from_deviations(t.before, t.after, t.gain.sd) for t in (self.experimental, self.control)
        )
        return adjusted(one, other)


@dataclass(frozen=True, slots=True)
class Later:
    """Table III for one law: marks in the mid-year examination."""

    of: int
    experimental: Spread
    control: Spread

    @property
    def z(self) -> PaperZ:
        """Equation (4), which the paper does not give here. Ours."""
        return paper_z(self.experimental, self.control)


def rows(text: str) -> list[dict[str, str]]:
    """The lines of a table by their headings; there is no comma in any cell."""
    head, *lines = [line.split(",") for line in text.splitlines() if line]
    return [dict(zip(head, line, strict=True)) for line in lines]


def sizes(text: str) -> tuple[dict[str, tuple[int, int]], tuple[int, int]]:
    """Table I: students by teacher (experimental, control), and the totals as printed."""
    found = {r["teacher"]: (int(r[EXPERIMENTAL]), int(r[CONTROL])) for r in rows(text)}
    return found, found.pop(TOTAL)


def laws(text: str, printed: str) -> dict[str, Law]:
    """Table II by law."""
    said = {row["law"]: row for row in rows(printed)}
    table = {(row["law"], row["group"]): _tested(row) for row in rows(text)}
    return {
        law: Law(
            table[law, EXPERIMENTAL],
            table[law, CONTROL],
            float(said[law]["z"]),
            float(said[law]["p"]),
        )
        for law in LAWS
    }


def later(text: str) -> dict[str, Later]:
    """Table III by law."""
    table = {(row["law"], row["group"]): row for row in rows(text)}
    return {
        law: Later(int(table[law, CONTROL]["of"]), *(
            _spread(table[law, group], "") for group in (EXPERIMENTAL, CONTROL)))
        for law in LAWS
    }  # fmt: skip


def largest_deviation(mean: float, n: int, of: float) -> float:
    """The largest sample deviation that n marks from 0 to `of` with this mean can have.

    All marks lie at one end or the other then: s² = n/(n − 1) · mean · (of − mean).
    """
    return math.sqrt(n / (n - 1) * mean * (of - mean))


def whole_total(mean: float, n: int, *, places: int = 3) -> int | None:
    """The sum of marks that gives this printed mean, or None if no whole number does."""
    total = round(mean * n)
    return total if round(total / n, places) == mean else None


def same_sums(parts: Sequence[tuple[int, int]], printed: tuple[int, int]) -> bool:
    """Whether the columns of Table I add up to what is printed below them."""
    return (sum(a for a, _ in parts), sum(b for _, b in parts)) == printed


def _tested(row: Mapping[str, str]) -> Tested:
    return Tested(
        int(row["of"]), _spread(row, "pre_"), _spread(row, "post_"), _spread(row, "gain_")
    )


def _spread(row: Mapping[str, str], prefix: str) -> Spread:
    return Spread(int(row["students"]), float(row[f"{prefix}mean"]), float(row[f"{prefix}sd"]))
