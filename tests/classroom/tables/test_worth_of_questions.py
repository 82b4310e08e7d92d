"""What a question is worth where no table tells it: the same in every test of a lesson."""

from __future__ import annotations

from tests.classroom.given.tables import csv, judged, reported

HEAD = ("student", "pre_Q1", "pre_Q3", "post_Q1", "post_Q3")
ROWS = [[f"s{k}", k % 2, k % 2, 1, 2 - k % 2] for k in range(10)]


def worths(*contents: bytes) -> dict[str, list[object]]:
    forms = judged(*contents).lesson.forms
    return {name: [meta["worth"] for meta in form.items] for name, form in forms.items()}


def test_a_question_that_nobody_had_quite_right_before_is_worth_the_same_after() -> None:
    assert worths(csv(HEAD, ROWS)) == {"pre": [1, 2], "post": [1, 2]}
    report = reported(csv(HEAD, ROWS))
    (gain,) = report["lessons"][0]["gains"]
    assert (gain["of"], gain["n"]) == (3, 10)
    assert gain["gain"] is not None
    (note,) = report["notes"][:1]
    assert "most marks of “Q3”" in note


def test_a_question_whose_worth_one_test_tells_is_worth_that_in_the_other() -> None:
    head = ("student", "pre_Q1", "pre_Q3 (4)", "post_Q1", "post_Q3")
    assert worths(csv(head, ROWS)) == {"pre": [1, 4], "post": [1, 4]}
    assert not any("does not tell" in note for note in reported(csv(head, ROWS))["notes"])


def test_worths_that_a_table_tells_may_differ_from_test_to_test() -> None:
    told = csv(HEAD, [["MAX", 1, 2, 1, 3], *ROWS])
    assert worths(told) == {"pre": [1, 2], "post": [1, 3]}
