"""Two groups made of whole classes: the adjusted difference with an interval that knows it.

Students of one class are alike, so n students are fewer than n independent ones. The slope and the
difference are those of the analysis of covariance, y = a + b·group + c·x, by least squares of all
students; their variance is estimated from whole classes (Liang and Zeger, Biometrika 73 (1986) 13):

    V = A⁻¹ (Σ_c u_c u_cᵀ) A⁻¹ · G/(G − 1) · (N − 1)/(N − 3),   u_c = Σ of class c of row·residual

with A = Σ rowᵀrow, G classes and N students; the interval takes Student's t with G − 1 (Cameron and
Miller, J. Human Resources 50 (2015) 317). With fewer than eight classes it would be much too narrow
and is refused. All sums are exact, so that the order of classes changes no digit.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from sim.classroom.refusal import RefusalError
from sim.classroom.statistics.compare import TTest, t_test
from sim.classroom.statistics.pair_sums import PairSums
from sim.classroom.statistics.spread import root
from sim.scene.said import counted

FEWEST_CLASSES = 8

Vector = list[Fraction]
Halves = tuple[PairSums | None, PairSums | None]
"""One class: its students in the first and in the second group."""


def clustered(classes: Sequence[Halves]) -> TTest:
    """First minus second group, in marks. Needs scipy."""
    if len(classes) < FEWEST_CLASSES:
        raise RefusalError(counted(
            "1 class: at least {needed} are needed", "{n} classes: at least {needed} are needed",
            n=len(classes), needed=f"{FEWEST_CLASSES}",
        ))  # fmt: skip
    for which in (0, 1):
        if sum(halves[which] is not None for halves in classes) < 2:
            raise RefusalError("a group has one class only")
    normal = [[Fraction(0)] * 3 for _ in range(3)]
    right = [Fraction(0)] * 3
    for halves in classes:
        for first, sums in _parts(halves):
            row = _squares(sums, first)
            normal = [[a + b for a, b in zip(*rows, strict=True)]
                      for rows in zip(normal, row, strict=True)]  # fmt: skip
            products = (sums.y, sums.y * first, sums.xy)
            right = [a + b for a, b in zip(right, products, strict=True)]
    fit = _solved(normal, right)
    weights = _solved(normal, [Fraction(0), Fraction(1), Fraction(0)])  # a row of A⁻¹
    meat = sum((_score(halves, fit, weights) ** 2 for halves in classes), Fraction(0))
    count, students = len(classes), int(normal[0][0])
    if students <= 3:
        raise RefusalError("too few students for a slope")
    factor = Fraction(count, count - 1) * Fraction(students - 1, students - 3)
    return t_test(float(fit[1]), root(meat * factor), count - 1)


def _parts(halves: Halves) -> list[tuple[int, PairSums]]:
    """The halves that are there, with 1 for the first group and 0 for the second."""
    return [(1 - k, sums) for k, sums in enumerate(halves) if sums is not None]


def _squares(sums: PairSums, first: int) -> list[Vector]:
    """Σ rowᵀrow of students of one group, with row = (1, group, x)."""
    n, x, xx = map(Fraction, (sums.n, sums.x, sums.xx))
    return [[n, n * first, x], [n * first, n * first, x * first], [x, x * first, xx]]


def _score(halves: Halves, fit: Vector, weights: Vector) -> Fraction:
    """What a class adds to the error of the difference: weights · Σ row·residual."""
    score = Fraction(0)
    for first, sums in _parts(halves):
        level = fit[0] + fit[1] * first
        left = sums.y - level * sums.n - fit[2] * sums.x
        left_x = sums.xy - level * sums.x - fit[2] * sums.xx
        score += weights[0] * left + weights[1] * first * left + weights[2] * left_x
    return score


def _solved(matrix: list[Vector], right: Vector) -> Vector:
    """The exact solution of matrix · v = right."""
    rows = [[*line, value] for line, value in zip(matrix, right, strict=True)]
    for k in range(len(rows)):
        pivot = next((i for i in range(k, len(rows)) if rows[i][k]), None)
        if pivot is None:
            raise RefusalError("everybody had the same marks before: there is no slope")
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [value / rows[k][k] for value in rows[k]]
        for i in range(len(rows)):
            if i != k:
                rows[i] = [a - rows[i][k] * b for a, b in zip(rows[i], rows[k], strict=True)]
    return [line[-1] for line in rows]
