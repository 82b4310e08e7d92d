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
from sim.classroom.statistics.compare import cohen_d, cohen_d_within, paired_t, paper_z, welch
from sim.classroom.statistics.gain import hake_gain
from sim.classroom.statistics.item_numbers import (
    corrected_point_biserial,
    difficulty,
    discrimination,
)
from sim.classroom.statistics.ranks import wilcoxon
from sim.classroom.statistics.spread import Spread, spread

CLASSES = 1_000
NEAR = 1e-12


def classes() -> list[tuple[list[float], list[float]]]:
    """Marks before and after of random classes; some easy, some hard, many ties."""
    dice = random.Random(7)
    made = []
    for _ in range(CLASSES):
        of, n = dice.randint(2, 15), dice.randint(5, 60)
        before = [float(sum(dice.random() < 0.4 for _ in range(of))) for _ in range(n)]
        after = [float(min(of, max(0, b + dice.randint(-2, 3)))) for b in before]
        made.append((before, after))
    return made


RANDOM = classes()


def same(mine: float, theirs: float) -> bool:
    """Equal to 1e-12 of the number, or of 1 where it is smaller."""
    return abs(mine - theirs) <= NEAR * max(1.0, abs(theirs))


def test_mean_and_deviation_are_those_of_the_standard_library() -> None:
    for before, after in RANDOM:
        found = spread(before + after)
        assert same(found.mean, statistics.mean(before + after))
        assert same(found.sd, statistics.stdev(before + after))


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


def test_the_point_biserial_is_the_correlation_with_the_other_items() -> None:
    for marks, rest in RANDOM:
        item = [float(m > 2) for m in marks]
        totals = [i + r for i, r in zip(item, rest, strict=True)]
        if len(set(item)) == 1 or len(set(rest)) == 1:
            continue
        mine = corrected_point_biserial(item, totals, fewest=5)
        assert same(mine, stats.pointbiserialr(item, rest).statistic)


def test_discrimination_is_the_difference_between_the_outer_parts() -> None:
    # 100 students: the best 27 all right, the last 27 all wrong, half of those between.
    totals = [float(k) for k in range(100)]
    item = [0.0] * 27 + [1.0] * 23 + [0.0] * 23 + [1.0] * 27
    assert discrimination(item, totals, 1) == 1.0
    assert discrimination(item[::-1], totals, 1) == -1.0
    assert difficulty(item, 1) == 0.5


def test_equal_totals_at_the_border_count_in_part() -> None:
    # 20 students, 27 % are 5.4; the ten best are level: 5.4 of their 10 answers, 5 of them right.
    totals = [1.0] * 10 + [2.0] * 10
    item = [0.0] * 10 + [1.0, 0.0] * 5
    assert discrimination(item, totals, 1) == pytest.approx(0.5)


REFUSED = {
    "nobody": ([], []),
    "one": ([1], [2]),
    "two": ([1, 2], [2, 3]),
    "four": ([1, 2, 3, 4], [2, 3, 3, 5]),
    "all equal": ([3] * 9, [3] * 9),
    "equal gains": ([1, 2, 3, 4, 5, 6], [2, 3, 4, 5, 6, 7]),
    "all missing": ([math.nan] * 8, [math.nan] * 8),
    "one missing": ([1, 2, 3, 4, 5, 6], [2, 2, math.nan, 4, 1, 2]),
    "not paired": ([1, 2, 3, 4, 5, 6], [1, 2, 3, 4, 5]),
    "endless": ([1, 2, 3, 4, 5, 6], [1, 2, 3, 4, 5, math.inf]),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_has_no_honest_value_is_refused_in_words(name: str) -> None:
    before, after = REFUSED[name]
    with pytest.raises(RefusalError) as refused:
        paired_t(after, before)
    assert len(str(refused.value)) > 10


def test_wilcoxon_refuses_a_class_that_did_not_change() -> None:
    with pytest.raises(RefusalError, match="0 students whose marks changed"):
        wilcoxon([3] * 30, [3] * 30)


def test_two_groups_without_spread_are_refused() -> None:
    flat = Spread(10, 3.0, 0.0)
    for test in (welch, paper_z, cohen_d):
        with pytest.raises(RefusalError, match="no spread"):
            test(flat, Spread(12, 4.0, 0.0))
    with pytest.raises(RefusalError, match="nothing to adjust"):
        adjusted(pairs_of([3] * 6, [1, 2, 3, 4, 5, 6]), pairs_of([2] * 6, [1, 2, 3, 4, 5, 6]))


def test_small_classes_get_no_item_numbers() -> None:
    marks, totals = [0.0, 1.0] * 9, [float(k % 5) for k in range(18)]
    for statistic in (corrected_point_biserial,):
        with pytest.raises(RefusalError, match="18 students: at least 20"):
            statistic(marks, totals)
    with pytest.raises(RefusalError, match="at least 20"):
        discrimination(marks, totals, 1)
    with pytest.raises(RefusalError, match="equally well"):
        corrected_point_biserial([1.0] * 25, [float(k) for k in range(25)])
