"""Numbers of single questions, and what has no honest value."""

from __future__ import annotations

import math

import pytest
from scipy import stats

from sim.classroom.refusal import RefusalError
from sim.classroom.statistics.adjusted import adjusted, pairs_of
from sim.classroom.statistics.compare import cohen_d, paper_z, welch
from sim.classroom.statistics.item_numbers import curve, levels_of
from sim.classroom.statistics.spread import Spread
from tests.classroom.given.from_marks import (
    corrected_point_biserial,
    difficulty,
    discrimination,
    paired_t,
    wilcoxon,
)
from tests.classroom.given.random_marks import RANDOM, same


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


def test_the_curve_of_an_item_begins_with_the_weakest_quarter() -> None:
    marks, totals = [0, 0, 0, 1, 1, 1, 1, 1], [1, 2, 3, 4, 5, 6, 7, 8]
    assert curve(levels_of(marks, totals), 1, fewest=8) == [0.0, 0.5, 1.0, 1.0]
