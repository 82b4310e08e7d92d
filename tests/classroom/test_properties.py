"""Laws that hold for every class, whatever its numbers are."""

from __future__ import annotations

import json
import random
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim.classroom.files.reading import Reading, Source
from sim.classroom.refusal import RefusalError
from sim.classroom.report.report import Asked, class_report
from sim.classroom.statistics.adjusted import adjusted, pairs_of
from sim.classroom.statistics.compare import paper_z, welch
from sim.classroom.statistics.spread import spread
from tests.classroom.given.from_marks import (
    corrected_point_biserial,
    discrimination,
    paired_t,
    wilcoxon,
)
from tests.classroom.given.makers import bank, keys, random_class, sources

MARKS = st.lists(st.tuples(st.integers(0, 12), st.integers(0, 12)), min_size=5, max_size=40)


def columns(pairs: list[tuple[int, int]]) -> tuple[list[float], list[float]]:
    return [float(a) for a, _ in pairs], [float(b) for _, b in pairs]


@given(MARKS)
def test_before_and_after_exchanged_change_the_sign_and_nothing_else(
    pairs: list[tuple[int, int]],
) -> None:
    before, after = columns(pairs)
    try:
        there, back = paired_t(after, before), paired_t(before, after)
    except RefusalError:
        assert len({b - a for a, b in pairs}) == 1
        return
    assert there.t == -back.t
    assert there.p == back.p
    assert (there.low, there.high) == (-back.high, -back.low)


@given(MARKS)
def test_a_chance_lies_between_0_and_1_and_the_interval_decides_as_p_does(
    pairs: list[tuple[int, int]],
) -> None:
    before, after = columns(pairs)
    try:
        test = paired_t(after, before)
    except RefusalError:
        return
    assert 0 <= test.p <= 1
    if abs(test.p - 0.05) > 1e-9:
        assert (test.p < 0.05) == (test.low > 0 or test.high < 0)


@given(MARKS)
def test_signed_ranks_do_not_care_which_way_is_up(pairs: list[tuple[int, int]]) -> None:
    before, after = columns(pairs)
    try:
        there, back = wilcoxon(after, before), wilcoxon(before, after)
    except RefusalError:
        assert sum(a != b for a, b in pairs) < 5
        return
    assert (there.p, there.up, there.down) == (back.p, back.down, back.up)
    assert 0 < there.p <= 1
    assert there.up + there.down + there.same == len(pairs)


def is_spread_about_a_line(*groups: list[tuple[int, int]]) -> bool:
    """Whether the marks before differ, and those after do not follow from them, in the groups."""
    xx = xy = yy = Fraction(0)
    for pairs in groups:
        x, y = (Fraction(sum(marks), len(pairs)) for marks in zip(*pairs, strict=True))
        xx += sum((b - x) ** 2 for b, _ in pairs)
        xy += sum((b - x) * (a - y) for b, a in pairs)
        yy += sum((a - y) ** 2 for _, a in pairs)
    return xx * yy > xy * xy


@given(MARKS, MARKS)
def test_groups_exchanged_change_the_sign_and_nothing_else(
    one: list[tuple[int, int]], other: list[tuple[int, int]]
) -> None:
    a, b = (pairs_of(*columns(pairs)) for pairs in (one, other))
    spread_after = any(len({after for _, after in pairs}) > 1 for pairs in (one, other))
    for compare, told in (
        (lambda x, y: welch(x.after, y.after).t, spread_after),
        (lambda x, y: paper_z(x.after, y.after).z, spread_after),
        (lambda x, y: adjusted(x, y).test.difference, is_spread_about_a_line(one, other)),
    ):
        try:
            assert compare(a, b) == pytest.approx(-compare(b, a), abs=1e-12)
        except RefusalError as refused:
            assert "spread" in str(refused) or "adjust" in str(refused)
            assert not told


@given(MARKS, st.floats(-50, 50))
def test_moving_all_marks_moves_the_mean_alone(pairs: list[tuple[int, int]], by: float) -> None:
    marks, _ = columns(pairs)
    moved = spread([mark + by for mark in marks])
    assert moved.mean == pytest.approx(spread(marks).mean + by, abs=1e-9)
    assert moved.sd == pytest.approx(spread(marks).sd, abs=1e-9)


@given(st.lists(st.tuples(st.booleans(), st.integers(0, 9)), min_size=20, max_size=40))
def test_items_are_told_apart_between_minus_1_and_1(answers: list[tuple[bool, int]]) -> None:
    marks = [float(right) for right, _ in answers]
    totals = [float(right) + rest for right, rest in answers]
    one_mark, one_total = len(set(marks)) == 1, len(set(totals)) == 1
    one_rest = len({rest for _, rest in answers}) == 1
    for statistic, alike in (
        (lambda: corrected_point_biserial(marks, totals), one_mark or one_rest),
        (lambda: discrimination(marks, totals, 1), one_total),
    ):
        try:
            assert -1 - 1e-12 <= statistic() <= 1 + 1e-12
        except RefusalError as refused:
            assert "everybody" in str(refused)
            assert alike


def test_the_order_of_the_files_changes_no_number() -> None:
    source = bank(8)
    files = sources(random_class(source, 20))
    key = Source("key.json", keys(source).encode())

    def numbers(order: list[Source]) -> str:
        reading = Reading.of([*order, key])
        report = class_report([(f, "class") for f in reading.files], reading.keys, [], Asked())
        lesson = report["lessons"][0]
        return json.dumps(
            [lesson["gains"], lesson["forms"][0]["items"], lesson["forms"][1]["groups"]]
        )

    dice, first = random.Random(5), numbers(files)
    for _ in range(5):
        mixed = files.copy()
        dice.shuffle(mixed)
        assert numbers(mixed) == first
