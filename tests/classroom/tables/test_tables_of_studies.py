"""Published studies as tables: what was printed comes out again; statistics against numpy, scipy.

The printed tables give means and deviations. Marks of single students that have them are made up,
so that a table of such marks must give every printed digit.
"""

from __future__ import annotations

import random
from collections import Counter
from typing import Any

import numpy as np
import pytest
from scipy import stats

from sim.classroom.paper import Law, laws
from sim.classroom.paper import Tested as Group
from tests.classroom.given.paper_tables import text
from tests.classroom.given.tables import csv, judged, marks_with, paired_with, reported

PRINTED = laws(text("table-2.csv"), text("table-2-printed.csv"))
DIGIT = 1e-3
"""One unit in the last printed digit: the paper rounds each number for itself."""

SAME = 1e-12
"""Relative. Two ways of one computation in double precision."""


def students(tested: Group) -> tuple[list[int], list[int]]:
    """Marks before and after with the printed means and deviations, and deviation of the gain."""
    n = tested.before.n
    columns, around = [], []
    for test in (tested.before, tested.after):
        total = round(test.mean * n)
        squares = round(test.sd**2 * (n - 1) + total**2 / n)
        columns.append(marks_with(n, total, squares, tested.of))
        around.append(sum(m * m for m in columns[-1]))
    x, y = columns
    gained = tested.gain.sd**2 * (n - 1) + (sum(y) - sum(x)) ** 2 / n
    return x, paired_with(x, y, round((around[0] + around[1] - gained) / 2))


def study(law: Law) -> bytes:
    rows: list[list[object]] = []
    for group, tested in (("experimental", law.experimental), ("control", law.control)):
        for k, (before, after) in enumerate(zip(*students(tested), strict=True)):
            rows.append([f"{group[0]}{k}", group, before, after])
    random.Random(3).shuffle(rows)
    rows.sort(key=lambda row: str(row[1]) != "experimental")
    return csv(("student", "group", f"pre ({law.control.of})", f"post ({law.control.of})"), rows)


@pytest.mark.parametrize("name", PRINTED)
def test_the_papers_study_comes_out_to_the_printed_digits(name: str) -> None:
    law = PRINTED[name]
    lesson = reported(study(law))["lessons"][0]
    for row, tested in zip(lesson["gains"], (law.experimental, law.control), strict=True):
        assert row["n"] == tested.before.n
        for key, printed in (("pre", tested.before), ("post", tested.after)):
            assert round(row[key]["mean"], 3) == printed.mean
            assert row[key]["sd"] == pytest.approx(printed.sd, abs=DIGIT)
        assert row["change"]["difference"] == pytest.approx(tested.gain.mean, abs=DIGIT)
        assert row["gain"] == pytest.approx(tested.hake, abs=DIGIT)
    z = lesson["comparison"]["paper_z"]
    assert round(z["z"], 2) == law.printed_z
    assert z["inside"] == pytest.approx(law.printed_p, abs=2 * DIGIT)


def inventory(students: int = 650, items: int = 30, seed: int = 7) -> np.ndarray:
    """Marks 0 and 1 of students, some abler than others, in items, some harder than others."""
    dice = np.random.default_rng(seed)
    able, hard = dice.normal(0, 1, (students, 1)), dice.normal(0, 1, (1, items))
    return (dice.random((students, items)) < 1 / (1 + np.exp(hard - able))).astype(int)


def as_csv(marks: np.ndarray, delimiter: str = ",") -> bytes:
    head = ["student", *(f"Q{k + 1}" for k in range(marks.shape[1]))]
    rows = [[f"s{k}", *row] for k, row in enumerate(marks.tolist())]
    return csv(head, rows, delimiter)


@pytest.fixture(scope="module")
def report() -> dict[str, Any]:
    form: dict[str, Any] = reported(as_csv(inventory()))["lessons"][0]["forms"][0]
    return form


def test_alpha_is_that_of_variances_and_kr_20(report: dict[str, Any]) -> None:
    marks = inventory()
    k, totals = marks.shape[1], marks.sum(axis=1)
    by_variance = k / (k - 1) * (1 - marks.var(axis=0, ddof=1).sum() / totals.var(ddof=1))
    p = marks.mean(axis=0)
    kr_20 = k / (k - 1) * (1 - (p * (1 - p)).sum() / totals.var())
    assert report["alpha"] == pytest.approx(by_variance, rel=SAME)
    assert report["alpha"] == pytest.approx(kr_20, rel=SAME)


def test_delta_counts_the_pairs_of_students_that_a_test_tells_apart(report: dict[str, Any]) -> None:
    totals = inventory().sum(axis=1)
    n, k = len(totals), inventory().shape[1]
    apart = (totals[:, None] != totals[None, :]).sum()  # ordered pairs
    assert report["delta"] == pytest.approx(apart / n**2 * (k + 1) / k, rel=SAME)


def test_delta_is_one_where_all_totals_are_equally_frequent() -> None:
    rows = [[f"s{k}", k % 5] for k in range(20)]
    form = reported(csv(("student", "total (4)"), rows))["lessons"][0]["forms"][0]
    assert form["delta"] == 1


def test_items_are_those_of_scipy(report: dict[str, Any]) -> None:
    marks = inventory()
    totals = marks.sum(axis=1)
    for k, item in enumerate(report["items"]):
        assert item["difficulty"] == pytest.approx(marks[:, k].mean(), rel=SAME)
        whole = stats.pointbiserialr(marks[:, k], totals).statistic
        rest = stats.pointbiserialr(marks[:, k], totals - marks[:, k]).statistic
        assert item["point_biserial_total"] == pytest.approx(whole, rel=1e-11)
        assert item["point_biserial"] == pytest.approx(rest, rel=1e-11)


def test_upper_and_lower_parts_are_means_over_all_orders_of_equal_totals() -> None:
    marks = inventory(40, 6)
    totals = marks.sum(axis=1)
    item = reported(as_csv(marks))["lessons"][0]["forms"][0]["items"][2]
    dice = np.random.default_rng(1)
    found = []
    for _ in range(4000):
        order = np.lexsort((dice.random(40), totals))
        found.append([marks[part, 2].mean() for part in np.split(order, 4)])
    quarters = np.mean(found, axis=0)
    error = 4 * np.std(found, axis=0).max() / np.sqrt(4000)  # four standard errors of the mean
    assert item["curve"] == pytest.approx(quarters, abs=error)
    assert item["discrimination_quarter"] == pytest.approx(
        item["curve"][3] - item["curve"][0], rel=SAME
    )


def clustered_by_numpy(y: Any, x: Any, group: Any, classes: Any) -> tuple[float, float]:
    """Least squares with a sandwich of classes, from rows, with the usual factor."""
    design = np.column_stack([np.ones_like(x), group, x])
    bread = np.linalg.inv(design.T @ design)
    left = y - design @ bread @ design.T @ y
    meat = np.zeros((3, 3))
    for name in np.unique(classes):
        score = design[classes == name].T @ left[classes == name]
        meat += np.outer(score, score)
    count, n = len(np.unique(classes)), len(y)
    v = bread @ meat @ bread * count / (count - 1) * (n - 1) / (n - 3)
    return float((bread @ design.T @ y)[1]), float(np.sqrt(v[1, 1]))


def of_classes(count: int) -> tuple[list[list[object]], Any]:
    """Rows of `count` classes by turns in two groups, and the same as arrays."""
    dice, rows = random.Random(count), []
    for k in range(count):
        level = dice.gauss(0, 2)
        for s in range(dice.randint(8, 20)):
            before = dice.randint(2, 12)
            after = max(0, min(20, round(before + 3 + level + 2 * (k % 2) + dice.gauss(0, 2))))
            rows.append([f"s{k}-{s}", "ab"[k % 2], f"class {k}", before, after])
    return rows, np.array([[r[4], r[3], r[1] == "a", int(str(r[2])[6:])] for r in rows], float).T


@pytest.mark.parametrize("count", [8, 13, 30])
def test_from_eight_classes_on_the_interval_counts_classes(count: int) -> None:
    rows, (y, x, group, classes) = of_classes(count)
    made = reported(csv(("student", "group", "class", "pre (20)", "post (20)"), rows))
    comparison = made["lessons"][0]["comparison"]
    difference, se = clustered_by_numpy(y, x, group, classes)
    found = comparison["clustered"]
    assert found["classes"] == count
    assert found["difference"] == pytest.approx(difference, rel=1e-10)
    assert found["se"] == pytest.approx(se, rel=1e-10)
    assert found["difference"] == pytest.approx(comparison["adjusted"]["difference"], rel=1e-10)
    half = stats.t.ppf(0.975, count - 1) * se
    assert found["high"] - found["difference"] == pytest.approx(half, rel=1e-10)
    assert any("Counted by classes" in sentence for sentence in comparison["sentences"])


def test_with_seven_classes_it_is_said_why_there_is_none() -> None:
    rows, _ = of_classes(7)
    made = reported(csv(("student", "group", "class", "pre (20)", "post (20)"), rows))
    comparison = made["lessons"][0]["comparison"]
    assert comparison["clustered"] is None
    assert any("From eight classes on" in sentence for sentence in comparison["sentences"])


def test_hakes_gain_is_of_the_class_and_beside_it_the_mean_of_the_students() -> None:
    dice = random.Random(4)
    rows = [[f"s{k}", b := dice.randint(2, 30), dice.randint(b, 30)] for k in range(40)]
    rows += [["only before", 3, ""], ["only after", "-", 29]]
    row = reported(csv(("student", "pre /30", "post /30"), rows))["lessons"][0]["gains"][0]
    pairs = [(int(b), int(a)) for _, b, a in rows[:40]]  # type: ignore[call-overload]
    before, after = np.mean([b for b, _ in pairs]), np.mean([a for _, a in pairs])
    assert row["n"] == 40
    assert row["gain"] == pytest.approx((after - before) / (30 - before), rel=SAME)
    single = [(a - b) / (30 - b) for b, a in pairs if b < 30]
    assert row["gain_of_students"] == {
        "mean": pytest.approx(np.mean(single), rel=SAME),
        "n": len(single),
    }
    assert (row["without_after"], row["without_before"]) == (["only before"], ["only after"])


def test_totals_alone_and_marks_of_questions_give_the_same_gain() -> None:
    dice = random.Random(6)
    marks = [[[int(dice.random() < p) for _ in range(12)] for p in (0.4, 0.7)] for _ in range(25)]
    head = [f"{form}_Q{k}" for form in ("pre", "post") for k in range(12)]
    wide = csv(["student", *head], [[f"s{k}", *a, *b] for k, (a, b) in enumerate(marks)])
    totals = csv(
        ("student", "pre", "post"), [[f"s{k}", sum(a), sum(b)] for k, (a, b) in enumerate(marks)]
    )
    one, other = reported(wide)["lessons"][0], reported(totals, most=12)["lessons"][0]
    told_by_items = "The same questions were asked twice: part of the gain may be memory."
    (gain,) = one["gains"]
    assert gain["sentences"].pop() == told_by_items
    assert other["gains"] == [gain]


def test_more_than_two_groups_are_compared_two_by_two() -> None:
    dice = random.Random(8)
    rows = [[f"s{k}", "abc"[k % 3], dice.randint(0, 9), dice.randint(3, 12)] for k in range(60)]
    lesson = reported(csv(("student", "group", "pre", "post"), rows), most=12)["lessons"][0]
    assert lesson["comparison"] is None
    assert [row["groups"] for row in lesson["comparisons"]] == [["a", "b"], ["a", "c"], ["b", "c"]]
    one = csv(("student", "group", "pre", "post"), [row for row in rows if row[1] != "b"])
    alone = reported(one, most=12)["lessons"][0]["comparison"]
    assert lesson["comparisons"][1] == alone


def test_exact_marks_lose_nothing_to_their_order() -> None:
    dice = random.Random(2)
    rows = [[f"s{k}", *(dice.choice(["0.1", "0.3", "0.7", "1"]) for _ in range(6))]
            for k in range(30)]  # fmt: skip
    head = ["student", *(f"Q{k}" for k in range(6))]
    first = judged(csv(head, rows)).lesson
    dice.shuffle(rows)
    second = judged(csv(head, rows)).lesson
    (one,), (other,) = (lesson.forms["test"].groups.values() for lesson in (first, second))
    assert Counter(one.totals) == Counter(other.totals)
    for name, sums in one.items.items():
        assert sums.marks == other.items[name].marks
