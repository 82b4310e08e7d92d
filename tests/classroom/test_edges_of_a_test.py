"""A test in which many have nothing or everything right cannot show all differences."""

from __future__ import annotations

import pytest

from tests.classroom.given.tables import csv, reported

OF = 10
BETWEEN = [3, 4, 5, 6, 7]


def marks(nothing: int, everything: int) -> list[int]:
    """Those of 20 students, so many of them with 0 and with full marks."""
    others = 20 - nothing - everything
    return [*[0] * nothing, *[OF] * everything, *(BETWEEN * 4)[:others]]


def said(before: list[int], after: list[int]) -> list[str]:
    rows = [[f"s{k}", *pair] for k, pair in enumerate(zip(before, after, strict=True))]
    (gain,) = reported(csv(("name", "pre", "post"), rows), most=OF)["lessons"][0]["gains"]
    return [one for one in gain["sentences"] if "too hard" in one or "too easy" in one]


HARD = "20 % of the students have 0 marks: the test was too hard to show all differences."
EASY = "20 % have full marks: the test was too easy to show all differences."


@pytest.mark.parametrize(
    ("edges", "told"),
    [((4, 0), HARD), ((0, 4), EASY), ((4, 4), f"{HARD} {EASY}")],
    ids=["nothing", "everything", "both"],
)
def test_a_fifth_with_nothing_or_everything_right_is_told_of_the_test_it_is_in(
    edges: tuple[int, int], told: str
) -> None:
    assert said(marks(*edges), marks(0, 0)) == [f"Before: {told}"]
    assert said(marks(0, 0), marks(*edges)) == [f"After: {told}"]
    assert said(marks(*edges), marks(*edges)) == [f"Before: {told}", f"After: {told}"]


def test_three_of_twenty_are_as_many_as_may_be() -> None:
    assert said(marks(3, 3), marks(3, 3)) == []
