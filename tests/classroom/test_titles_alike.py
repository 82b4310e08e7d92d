"""A lesson and a copy of it have one title: each part of a report says which of them it is of."""

from __future__ import annotations

import pytest

from sim.classroom.report.marked import told_apart


@pytest.mark.parametrize(
    ("lessons", "titles"),
    [
        ([("a", "third", "Third law"), ("a", "second", "Second law")], ["Third law", "Second law"]),
        (
            [("a", "third", "Third law"), ("a", "third-b", "Third law"), ("a", "x", "X")],
            ["Third law (third)", "Third law (third-b)", "X"],
        ),
        (
            [("a", "third", "Third law"), ("b", "third", "Third law")],
            ["Third law (third) (a)", "Third law (third) (b)"],
        ),
    ],
)
def test_lessons_of_one_title_are_told_apart(lessons, titles) -> None:
    rows = [dict(zip(("site", "lesson", "title"), one, strict=True)) for one in lessons]
    assert [one["title"] for one in told_apart(rows)] == titles
