"""Why a lesson has no gain is always said: of tests whose most marks differ, or are half known."""

from __future__ import annotations

import pytest

from sim.classroom.show.report_page import report_html
from tests.classroom.given.tables import csv, reported

ROWS = [[f"s{k}", k, k + 5] for k in range(9)]


@pytest.mark.parametrize(
    ("heads", "says"),
    [
        (("pre", "post (30)"),
         "The most marks of the test before are not known, those of the test after are 30: no gain "
         "is computed."),
        (("pre (30)", "post"),
         "The most marks of the test after are not known, those of the test before are 30: no gain "
         "is computed."),
        (("pre (20)", "post (30)"),
         "The test before has 20 marks and the test after 30: no gain is computed."),
    ],
)  # fmt: skip
def test_tests_that_cannot_be_subtracted_are_said_to_be(heads: tuple[str, str], says: str) -> None:
    report = reported(csv(("student", *heads), ROWS))
    assert report["lessons"][0]["gains"] == []
    assert says in report["notes"]


def test_a_class_of_which_nobody_has_a_mark_gets_a_report() -> None:
    rows = [[f"s{k}", 0, 0] for k in range(9)]
    page = report_html(reported(csv(("student", "pre", "post"), rows)))
    assert "0 marks on average" in page
    assert "<svg" not in page
