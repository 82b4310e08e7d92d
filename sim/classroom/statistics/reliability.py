"""How far a whole test can be trusted, from sums: Cronbach's alpha and Ferguson's delta.

**alpha** = k/(k − 1) · (1 − Σ s_i²/s²), with k questions, the variance s_i² of the marks in each
and the variance s² of the totals, both with n − 1. For questions marked 0 or 1 it is KR-20.
Source: L. J. Cronbach, Psychometrika 16 (1951) 297.

**delta** = (k + 1)(N² − Σ f²)/(k N²), where f students of N have each total and k is the most
marks: 1 if all totals from 0 to k are equally frequent. Source: G. A. Ferguson, Psychometrika 14
(1949) 61; in physics L. Ding and R. Beichner, Phys. Rev. ST PER 5 (2009) 020103, equation (5).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

from sim.classroom.refusal import FEWEST, RefusalError, at_least
from sim.classroom.statistics.spread import Exact, around
from sim.scene.said import counted


def alpha(n: int, items: Sequence[tuple[Exact, Exact]], totals: Mapping[Exact, int]) -> float:
    """`items`: Σm and Σm² of each question. `totals`: how many of the n students have each."""
    at_least(n, FEWEST)
    k = len(items)
    if k < 2:
        raise RefusalError(
            counted(
                "1 question: at least 2 are needed", "{n} questions: at least 2 are needed", n=k
            )
        )
    whole = around(
        n, sum(t * f for t, f in totals.items()), sum(t * t * f for t, f in totals.items())
    )
    if whole == 0:
        raise RefusalError("everybody has the same marks in all")
    parts = sum((around(n, m, mm) for m, mm in items), Fraction(0))
    return float(Fraction(k, k - 1) * (1 - parts / whole))


def delta(n: int, totals: Mapping[Exact, int], of: Exact) -> float:
    """`of`: the most marks; refused where totals are no whole numbers, for then there is no k."""
    at_least(n, FEWEST)
    if any(Fraction(t).denominator != 1 for t in (of, *totals)):
        raise RefusalError("it needs whole marks")
    if of < 1:
        raise RefusalError("the test is worth no marks")
    squares = sum(f * f for f in totals.values())
    return float(Fraction((of + 1) * (n * n - squares)) / (of * n * n))
