"""Statistics against scipy.stats, a least-squares fit and published examples, on random classes."""

from __future__ import annotations

import math
import random
import statistics
from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from scipy import stats

from sim.classroom.refusal import RefusalError
from sim.classroom.statistics.adjusted import adjusted, pairs_of
from sim.classroom.statistics.compare import cohen_d, cohen_d_within, paper_z, welch
from sim.classroom.statistics.gain import hake_gain
from sim.classroom.statistics.spread import Spread, median, spread
from tests.classroom.given.from_marks import paired_t, wilcoxon
from tests.classroom.given.random_marks import RANDOM, same


def test_mean_and_deviation_are_those_of_the_standard_library() -> None:
    for before, after in RANDOM:
        found = spread(before + after)
        assert same(found.mean, statistics.mean(before + after))
        assert same(found.sd, statistics.stdev(before + after))


@pytest.mark.parametrize("marks", [[7], [1, 2], [3, 1, 2], [4, 0, 11, 5], [0, 0, 1, 1, 2, 9]])
def test_the_median_of_an_even_class_is_midway_between_the_two_in_the_middle(marks) -> None:
    assert median(marks) == statistics.median(marks)


def test_the_order_of_the_files_changes_no_digit() -> None:
    marks = [0.1 * k for k in range(40)]
    assert spread(marks) == spread(marks[::-1]) == spread(sorted(marks, key=math.sin))


def test_the_interval_of_a_mean_is_that_of_scipy() -> None:
    for before, _ in RANDOM:
        found = spread(before)
        if found.sd:
            low, high = stats.t.interval(0.95, found.n - 1, found.mean, found.se)
            assert same(found.interval()[0], low)
            assert same(found.interval()[1], high)


def test_the_paired_t_test_is_that_of_scipy() -> None:
    for before, after in RANDOM:
        found, theirs = paired_t(after, before), stats.ttest_rel(after, before)
        interval = theirs.confidence_interval()
        assert same(found.t, theirs.statistic)
        assert same(found.p, theirs.pvalue)
        assert same(found.low, interval.low)
        assert same(found.high, interval.high)


def test_welchs_test_is_that_of_scipy() -> None:
    for (one, _), (other, _) in pairwise(RANDOM):
        found = welch(spread(one), spread(other))
        theirs = stats.ttest_ind(one, other, equal_var=False)
        assert same(found.t, theirs.statistic)
        assert same(found.p, theirs.pvalue)
        assert same(found.df, theirs.df)
        assert same(found.low, theirs.confidence_interval().low)


def test_welchs_test_is_that_of_students_own_example() -> None:
    # Student (1908), extra hours of sleep; t = −1.8608, df = 17.776, p = 0.07939 as printed in
    # the help page of R's t.test for the same data.
    one = [0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0]
    other = [1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4]
    found = welch(spread(one), spread(other))
    assert (round(found.t, 4), round(found.df, 3), round(found.p, 5)) == (-1.8608, 17.776, 0.07939)
    assert round(paired_t(one, other).p, 6) == 0.002833


def test_wilcoxon_without_ties_is_that_of_scipy() -> None:
    dice = random.Random(8)
    for _ in range(300):
        before = [dice.random() for _ in range(dice.randint(5, 50))]
        after = [b + dice.gauss(0.2, 1) for b in before]
        found = wilcoxon(after, before)
        theirs = stats.wilcoxon(after, before, method="exact")
        assert found.statistic == theirs.statistic
        assert same(found.p, theirs.pvalue)


def test_wilcoxon_with_ties_counts_every_choice_of_signs() -> None:
    dice = random.Random(9)
    for _ in range(40):
        changes = [dice.choice([-3, -2, -1, 0, 1, 2, 3]) for _ in range(9)]
        changed = [c for c in changes if c]
        if len(changed) < 5:
            continue
        ranks = stats.rankdata(np.abs(changed))
        total, signs = (
            ranks.sum(),
            np.array(np.meshgrid(*[[0, 1]] * len(changed))).reshape(len(changed), -1),
        )
        sums = ranks @ signs
        mine = ranks[np.array(changed) > 0].sum()
        smaller = min(mine, total - mine)
        expected = min(1.0, 2 * np.mean(sums <= smaller))
        assert same(wilcoxon(changes, [0] * 9).p, float(expected))


def test_wilcoxon_of_many_is_the_normal_curve_of_scipy() -> None:
    dice = random.Random(10)
    for _ in range(50):
        before = [dice.randint(0, 11) for _ in range(120)]
        after = [b + dice.randint(-3, 4) for b in before]
        found = wilcoxon(after, before)
        assert found.way == "normal"
        assert found.p == found.p_normal


def test_the_normal_curve_of_wilcoxon_is_that_of_scipy() -> None:
    for before, after in RANDOM:
        if sum(a != b for a, b in zip(after, before, strict=True)) < 5:
            continue
        theirs = stats.wilcoxon(after, before, method="asymptotic", correction=False)
        found = wilcoxon(after, before)
        assert found.statistic == theirs.statistic
        assert same(found.p_normal, theirs.pvalue)


Exact = list[Fraction]


def least_squares(rows: list[Exact], y: Exact) -> tuple[Exact, Fraction]:
    """Coefficients of the fit, and the second entry of (XᵀX)⁻¹'s diagonal, by elimination."""
    size = len(rows[0])
    table = [
        [sum((r[i] * r[j] for r in rows), Fraction(0)) for j in range(size)]
        + [sum((r[i] * v for r, v in zip(rows, y, strict=True)), Fraction(0)), Fraction(i == 1)]
        for i in range(size)
    ]
    for k in range(size):
        pivot = table[k][k]
        table[k] = [value / pivot for value in table[k]]
        for i in range(size):
            if i != k:
                factor = table[i][k]
                table[i] = [a - factor * b for a, b in zip(table[i], table[k], strict=True)]
    return [row[size] for row in table], table[1][size + 1]


def test_the_adjusted_difference_is_that_of_an_exact_least_squares_fit() -> None:
    for (x1, y1), (x2, y2) in pairwise(RANDOM):
        found = adjusted(pairs_of(x1, y1), pairs_of(x2, y2))
        xs, ys = [*map(Fraction, x1 + x2)], [*map(Fraction, y1 + y2)]
        rows = [[Fraction(1), Fraction(k < len(x1)), x] for k, x in enumerate(xs)]
        fitted, corner = least_squares(rows, ys)
        left = len(ys) - 3
        rest = [
            y - sum(c * v for c, v in zip(fitted, row, strict=True))
            for row, y in zip(rows, ys, strict=True)
        ]
        se = math.sqrt(sum(r * r for r in rest) / left * corner)
        t = float(fitted[1]) / se
        assert same(found.test.difference, float(fitted[1]))
        assert same(found.slope, float(fitted[2]))
        assert same(found.test.se, se)
        assert same(found.test.p, 2 * stats.t.sf(abs(t), left))


def test_cohens_d_is_t_over_the_root_of_the_sizes() -> None:
    # t of the test with equal variances is d √(n₁ n₂/(n₁ + n₂)): another way to the same number.
    for (one, _), (other, _) in pairwise(RANDOM):
        n, m = len(one), len(other)
        t = stats.ttest_ind(one, other, equal_var=True).statistic
        assert same(cohen_d(spread(one), spread(other)), t / math.sqrt(n * m / (n + m)))


def test_cohens_d_of_one_class_does_not_depend_on_who_is_who() -> None:
    before, after = Spread(30, 4.0, 1.0), Spread(30, 5.0, 1.0)
    assert cohen_d_within(before, after) == 1.0


def test_the_papers_z_and_p_are_those_of_a_normal_curve() -> None:
    for (one, _), (other, _) in pairwise(RANDOM):
        found = paper_z(spread(one), spread(other))
        assert same(found.p, 2 * stats.norm.sf(abs(found.z)))
        assert same(found.inside, 1 - found.p)


def test_hakes_gain_is_the_share_of_what_could_be_gained() -> None:
    assert hake_gain(4, 7, 10) == 0.5
    assert hake_gain(4, 3, 10) == pytest.approx(-1 / 6)
    with pytest.raises(RefusalError, match="full marks before"):
        hake_gain(10, 10, 10)
