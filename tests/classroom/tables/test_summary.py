"""Sums that leave a school: added they are all answers at once, to the last bit, in any order."""

from __future__ import annotations

import json
import random
from collections.abc import Sequence
from typing import Any

from hypothesis import given, settings
from hypothesis import strategies as st

from sim.classroom.files.reading import Reading, Source
from sim.classroom.report.report import Asked, class_report
from sim.classroom.summary.document import Read, document
from sim.classroom.summary.handed_on import Summary, handed_on
from sim.classroom.summary.merge import merged
from sim.classroom.summary.reading import read_summary
from sim.classroom.summary.written import summary_file
from sim.cli.classroom.summary import lessons_of_answers
from tests.classroom.given.class_reports import WHO, without
from tests.classroom.given.makers import bank, keys, random_class, sources
from tests.classroom.given.school_summaries import (
    HEAD,
    MOST,
    bits,
    of_table,
    school,
    through_a_file,
)
from tests.classroom.given.tables import csv, judged, reported

NAMES = ("files", "flags", "students", "sentences", "notes")


def report_of(summaries: Sequence[Summary]) -> dict[str, Any]:
    whole, refused = merged([(f"{k}.json", summary) for k, summary in enumerate(summaries)])
    assert refused == []
    return document(whole.lessons, whole.groups, Read(unit="summaries", read=0, counted=0))


@settings(max_examples=25)
@given(st.lists(st.tuples(st.integers(5, 9), st.integers(5, 9)), min_size=2, max_size=6),
       st.randoms(use_true_random=False))  # fmt: skip
def test_added_summaries_are_all_marks_at_once_in_any_order(
    counts: list[tuple[int, int]], dice: random.Random
) -> None:
    schools = [school(number, dice, both) for number, both in enumerate(counts)]
    whole = report_of([of_table([row for rows in schools for row in rows])])
    parts = [of_table(rows) for rows in schools]
    assert bits(report_of(parts)) == bits(whole)
    dice.shuffle(parts)
    assert bits(report_of(parts)) == bits(whole)
    half = len(parts) // 2
    steps = [merged([("", part) for part in some])[0] for some in (parts[:half], parts[half:])]
    assert bits(report_of([through_a_file(one) for one in steps])) == bits(whole)


def test_the_report_of_a_table_and_that_of_its_summaries_have_the_same_numbers() -> None:
    dice = random.Random(3)
    rows = [row for k in range(9) for row in school(k, dice, (6, 7))]
    table = reported(csv(HEAD, [MOST, *rows]))
    parts = [of_table([r for r in rows if str(r[0]).startswith(f"{k}-")]) for k in range(9)]
    assert "“MAX”" in table["notes"].pop(0)  # by the line where it stands
    assert without(report_of(parts), WHO) == without(table, WHO)
    assert table["lessons"][0]["comparison"]["clustered"]["classes"] == 18


BANK = bank(8, words=1)


def of_files(
    groups: Sequence[tuple[str, list[dict[str, Any]]]],
) -> tuple[dict[str, Any], Summary, str]:
    """Answer files by group: the whole report, the summary, and the summary's text."""
    reading = Reading.of([Source("key.json", keys(BANK).encode())])
    files = [(read, name) for name, made in groups for read in Reading.of(sources(made)).files]
    names = tuple(dict.fromkeys(name for name, _ in groups))
    asked = Asked(groups=names, classes={n: sum(g == n for g, _ in groups) for n in names})
    summary = handed_on(lessons_of_answers(files, reading.keys, asked), names, by_total=True)
    text = json.dumps(summary_file(summary))
    return class_report(files, reading.keys, [], asked), read_summary(text.encode()), text


def test_answer_files_of_many_schools_give_the_numbers_of_one_report() -> None:
    classes = [
        (name, random_class(BANK, 12 + k, seed=k, gain=gain, prefix=f"{name}{k}"))
        for k in range(4)
        for name, gain in (("new", 0.3), ("usual", 0.1))
    ]
    whole, _, _ = of_files(classes)
    parts = [of_files(classes[2 * k : 2 * k + 2])[1] for k in range(4)]
    random.Random(1).shuffle(parts)
    hidden = (*WHO, "curve", "words", "beliefs", "comparisons", "clustered", "predictions")
    mine, theirs = (without(report, hidden) for report in (report_of(parts), whole))
    assert mine["lessons"] == theirs["lessons"]
    assert mine["lessons"][0]["comparison"]["p_shown"] is True
    curves = [[i["curve"] for f in r["lessons"][0]["forms"] for i in f["items"]]
              for r in (report_of(parts), whole)]  # fmt: skip
    assert curves[0] == curves[1]


def test_a_file_of_another_wording_is_in_no_number_of_the_whole_test() -> None:
    files = random_class(BANK, 14, seed=4)
    for file in files[:6]:
        file["items"][0]["hash"] = "f" * 12
    whole, summary, _ = of_files([("class", files)])
    mine, theirs = (report["lessons"][0]["forms"] for report in (report_of([summary]), whole))
    assert len(mine) == 2
    for one, other in zip(mine, theirs, strict=True):
        assert any(student["foreign"] for student in other["students"])
        assert other["alpha"] is not None
        for name in ("n", "of", "alpha", "delta", "groups"):
            assert one[name] == other[name], name


def test_a_summary_does_not_tell_the_marks_of_who_answered_another_wording() -> None:
    files = random_class(BANK, 7, seed=4)
    for file in files[:2]:  # of one student
        file["items"][0]["hash"] = "f" * 12
    for file in files[2:6]:
        file["items"][1]["hash"] = "f" * 12
    _, summary, text = of_files([("class", [*files, *random_class(BANK, 9, prefix="OWL")])])
    assert "parts" not in text
    for form in summary.lessons[0].forms.values():
        group = form.groups["class"]
        assert (group.listed, group.n) == (16, 13)
        totals = sum(total * n for total, n in group.totals.items())
        for name in form.counted:
            item = group.items[name]
            assert (item.counts["n"], item.marks.n, item.marks.t) == (13, 13, totals)
        assert sum(group.items[name].marks.m for name in form.counted) == totals


def test_a_summary_holds_no_student_and_no_group_below_five() -> None:
    small = random_class(BANK, 4, seed=1, prefix="SMALL")
    large = random_class(BANK, 9, seed=2, prefix="LARGE")
    _, summary, text = of_files([("few", small), ("many", large)])
    assert summary.groups == ("many",)
    assert summary.withheld == 3  # before, after, and both
    for file in (*small, *large):
        assert file["student"] not in text
        assert file["saved"] not in text
        assert all(str(i["value"]) not in text for i in file["items"] if i["type"] == "long")
    assert "few" not in json.loads(text)["lessons"][0]["classes"]


def test_by_itself_a_summary_does_not_tell_marks_by_total() -> None:
    rows = school(1, random.Random(1), (30, 30))
    item = summary_file(of_table(rows, by_total=False))["lessons"][0]["forms"][0]["groups"]["a"][
        "items"
    ]["Q1"]
    assert item["levels"] is None
    assert item["options"] is None
    (row, *_) = report_of([of_table(rows, by_total=False)])["lessons"][0]["forms"][0]["items"]
    assert row["discrimination"] is None
    assert any("not handed on" in note for note in row["notes"])
    assert row["point_biserial"] is not None


def test_options_that_may_have_been_typed_are_pooled() -> None:
    rows = [[f"s{k}", "B" if k % 2 else "my name is Fox", "C"] for k in range(10)]
    found = judged(csv(("student", "Q1", "Q2"), [["KEY", "B", "C"], *rows]))
    text = json.dumps(summary_file(handed_on([found.lesson], found.groups, by_total=True)))
    assert "Fox" not in text
    assert '"other": 5' in text


def test_other_questions_are_named_and_not_added() -> None:
    dice = random.Random(5)
    good = [of_table(school(k, dice, (6, 6))) for k in range(3)]
    rows = school(9, dice, (6, 6))
    found = judged(csv([*HEAD[:-1], "post_Q4"], [MOST, *rows]))
    other = handed_on([found.lesson], found.groups, by_total=True)
    for order in ([*good, other], [other, *good]):
        whole, refused = merged([("other" if one is other else "good", one) for one in order])
        assert {name for name, _ in refused} == {"other"}
        assert whole.lessons[0].forms["post"].groups["a"].n == 18


def test_classes_below_five_are_left_out_of_the_pairs() -> None:
    dice = random.Random(6)
    rows = [row for k in range(8) for row in school(k, dice, (6, 6))]
    small = [[f"x{k}", "a", "tiny", *r[3:]] for k, r in enumerate(school(9, dice, (3, 0)))]
    summary = of_table([*rows, *small])
    assert bits(report_of([summary])["lessons"][0]["gains"]) == bits(
        report_of([of_table(rows)])["lessons"][0]["gains"]
    )
