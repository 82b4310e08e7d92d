"""A table to fill in: each cell is marked, the points are drawn, and everything comes back."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from sim.pages.findings import AuthorError
from tests.web.conftest import OpenPage
from tests.web.question.answering import saved, saved_file
from tests.web.question.question_site import question_site, questions_page, ready, write_page

__all__ = ["question_site"]  # a fixture

TABLE = """
```question
id: gains
type: table
ask: Fill in the table.
columns: [push, velocity]
rows:
  - [0.1 N, {answer: 0.4 m/s, tolerance: 0.02 m/s}]
  - [0.2 N, {answer: 0.8 m/s, tolerance: 0.02 m/s}]
plot: [push, velocity]
```
"""


@pytest.mark.one_browser
@pytest.mark.browser
def test_cells_are_marked_one_by_one_and_drawn_and_come_back(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(write_page(question_site, "gains", TABLE)))
    cells, points = page.locator("#gains td input"), page.locator("#gains .carts-q-points circle")
    expect(points).to_have_count(0)
    cells.nth(0).fill("40 cm/s")
    expect(points).to_have_count(1)
    cells.nth(1).fill("0.7")
    expect(points).to_have_count(2)
    # Each number of an axis has its line, and each axis its unit.
    plot = page.locator("#gains .carts-q-plot")
    texts = plot.locator("text").all_text_contents()
    assert texts[-2:] == ["push in N", "velocity in m/s"]
    lines = (plot.locator(".carts-grid").get_attribute("d") or "").count("M")
    assert lines == len(texts) - 2 > 4
    heights = points.evaluate_all("all => all.map(one => Number(one.getAttribute('cy')))")
    assert heights[1] < heights[0]
    saved(page, "gains")
    page.locator("#gains .carts-q-check").click()
    expect(page.locator("#gains .carts-q-verdict")).to_contain_text("Partly right")
    marks = page.locator("#gains .carts-q-cell-mark")
    expect(marks).to_have_text(["✓ right", "✗ not yet"])
    cells.nth(1).fill("0,8")
    expect(marks).to_have_text(["", ""])
    page.locator("#gains .carts-q-check").click()
    expect(page.locator("#gains .carts-q-verdict")).to_have_text("Right.")
    saved(page, "gains")
    (item,) = saved_file(page)["items"]
    assert item["value"] == {"1-2": 0.4, "2-2": 0.8}
    # What has a unit gets no second one.
    first, second = item["said"].split("; ")
    assert first.endswith(": 40 cm/s") and second.endswith(": 0,8 m/s")
    page.reload()
    ready(page)
    expect(cells.nth(0)).to_have_value("40 cm/s")  # as typed, not as it was read
    expect(cells.nth(1)).to_have_value("0,8")
    expect(points).to_have_count(2)


@pytest.mark.parametrize(
    ("wrong", "code"),
    [
        (TABLE.replace("[0.1 N, {answer", "[{answer"), "wrong-count"),
        (TABLE.replace("0.4 m/s,", "0.4 mph,"), "wrong-unit"),
        (TABLE.replace(", tolerance: 0.02 m/s}]\n  - [0.2", "}]\n  - [0.2"), "missing"),
        (TABLE.replace("plot: [push, velocity]", "plot: [push, mass]"), "not-a-choice"),
        (TABLE.replace("- [0.1 N", "- [a little"), "not-a-number"),
        (TABLE.replace("columns: [push, velocity]", "columns: [push, push]"), "not-a-list"),
    ],
)
def test_a_table_that_makes_no_sense_is_refused(wrong: str, code: str) -> None:
    with pytest.raises(AuthorError) as refused:
        questions_page("lesson", wrong)
    assert code in {finding.code for finding in refused.value.findings}
