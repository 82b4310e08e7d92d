"""Who was right at once, who later, and whom the run made think again."""

from __future__ import annotations

from typing import Any

import pytest

from sim.classroom.report.items.second_thoughts import thoughts
from tests.classroom.given.makers import answers, bank, keys
from tests.classroom.given.page_report import report_of

BANK = bank(1)
RIGHT, WRONG = "a", "b"


def item_of(*rows: dict[str, Any]) -> dict[str, Any]:
    """The only item of a report on students whose answer is made of each of these."""
    files = []
    for k, row in enumerate(rows):
        made = answers(BANK, f"FOX-{k}", "pre", {"item-0": row.get("value", RIGHT)})
        made["items"][0] |= {"tries": 3, **row}
        files.append(made)
    (item,) = report_of(files, keys(BANK))["lessons"][0]["forms"][0]["items"]
    found: dict[str, Any] = item
    return found


def test_presses_on_check_are_counted_until_the_answer_was_right() -> None:
    item = item_of(*[{"right": n} for n in (1, 1, 2, 3, 0)], {})  # the last one: an older file
    assert item["tries"] == {"first": 2, "later": 2, "not_yet": 1}
    assert thoughts(item) == ["Right at the first press on Check: 2, later: 2, not yet: 1."]


def test_what_stood_at_the_run_is_marked_as_what_stands_now() -> None:
    item = item_of(
        {"value": RIGHT, "before": {"value": WRONG, "said": "b"}},
        {"value": WRONG, "before": {"value": RIGHT}},
        {"value": "c", "before": {"value": WRONG}},
        {"value": WRONG, "before": {"value": WRONG}},
        {"value": RIGHT},
    )
    assert item["changed"] == {"n": 4, "changed": 3, "to_right": 1, "to_wrong": 1}
    (told,) = thoughts(item)
    assert told.startswith("4 answered before they watched the run; 3 of them changed it after")


def test_files_that_do_not_tell_are_not_counted() -> None:
    item = item_of({}, {"tries": 0})
    assert item["tries"] is None and item["changed"] is None
    assert thoughts(item) == []


@pytest.mark.parametrize("bad", [
    {"right": True}, {"right": -1}, {"right": 9}, {"right": "1"}, {"before": "a"},
    {"before": {"said": "a"}}, {"before": {"value": {"__proto__": 1}}},
])  # fmt: skip
def test_what_cannot_be_is_left_out_and_the_answer_counts(bad: dict[str, Any]) -> None:
    item = item_of(bad)
    assert (item["right"], item["tries"], item["changed"]) == (1, None, None)
