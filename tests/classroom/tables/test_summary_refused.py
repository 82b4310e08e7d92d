"""What is no summary of a school is refused, and mutations never break the sum."""

from __future__ import annotations

import json
import random
from typing import Any

import pytest

from sim.classroom.show.report_page import report_html
from sim.classroom.summary.document import Read, document
from sim.classroom.summary.handed_on import handed_on
from sim.classroom.summary.merge import merged
from sim.classroom.summary.numbers import SummaryError, exact, written
from sim.classroom.summary.reading import read_summary
from sim.classroom.summary.written import summary_file
from sim.classroom.tables.report import table_report
from sim.cli.classroom.text import report_as_text
from tests.classroom.given.school_summaries import HEAD, MOST, bits, of_table, school
from tests.classroom.given.tables import csv, judged


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"kind": "newtons-carts-summary"}', "\x00"])
def test_what_is_no_summary_is_refused_in_words(text: str) -> None:
    with pytest.raises(SummaryError):
        read_summary(text.encode())


def test_numbers_are_written_without_rounding() -> None:
    dice = random.Random(7)
    for _ in range(200):
        top = dice.randint(-(10**60), 10**60)
        number = exact(f"{top}/{dice.randint(1, 10**50)}")
        assert exact(json.loads(json.dumps(written(number)))) == number


def places(value: Any) -> list[tuple[Any, Any]]:
    """Every place in plain values."""
    rows: list[tuple[Any, Any]] = []
    keys_ = list(value) if isinstance(value, dict) else range(len(value))
    for key in keys_:
        rows.append((value, key))
        if isinstance(value[key], (dict, list)):
            rows += places(value[key])
    return rows


def test_a_form_of_somebodys_own_is_no_form() -> None:
    summary = summary_file(of_table(school(1, random.Random(1), (6, 6))))
    summary["lessons"][0]["forms"][0]["form"] = "<b>x</b>"
    with pytest.raises(SummaryError):
        read_summary(json.dumps(summary).encode())


def test_mutated_summaries_are_added_or_refused_and_never_break() -> None:
    dice = random.Random(11)
    seed = json.dumps(summary_file(of_table(school(1, dice, (8, 8)))))
    evil: list[Any] = [None, -1, 0, 3, 10**30, 1.5, "x", "1/0", "1/3", [], {}, True, "=1+1",
                       "<b>x</b>"]  # fmt: skip
    read = 0
    for _ in range(1_500):
        summary = json.loads(seed)
        for _ in range(dice.randint(1, 2)):
            where, key = dice.choice(places(summary))
            if dice.random() < 0.2 and isinstance(where, dict):
                del where[key]
            else:
                where[key] = dice.choice(evil)
        try:
            found = read_summary(json.dumps(summary).encode())
        except SummaryError as error:
            assert str(error)
            continue
        read += 1
        whole, _ = merged([("good", read_summary(seed.encode())), ("bad", found)])
        report = document(whole.lessons, whole.groups, Read(unit="summaries", read=2, counted=2))
        bits(report)
        report_as_text(report, {})
        assert "<b>x" not in report_html(report)
    assert read > 100


def test_a_table_report_counts_what_is_withheld_from_its_summary() -> None:
    found = judged(csv(HEAD, [MOST, *school(1, random.Random(2), (3, 8))]))
    assert table_report(found)["lessons"][0]["forms"][0]["n"] == 11
    assert handed_on([found.lesson], found.groups).groups == ("b",)
