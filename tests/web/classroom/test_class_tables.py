"""Tables of marks on the page “Class results”: whose they are, and what is counted as read."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page, expect

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]

TAKE = """async (files) => {
  const element = document.querySelector("carts-class");
  await element.take(files.map((name) => new File(["student,marks\\nA,1\\n"], name)), 0);
  return document.querySelector(".carts-class-progress").max;
}"""


def test_the_group_of_a_table_is_told_as_it_is_now(page: Page) -> None:
    page.evaluate(TAKE, ["marks.csv"])
    name = page.locator(".carts-class-tables bdi")
    expect(name).to_have_text("marks.csv")
    page.locator(".carts-class-two").check()
    group = page.locator(".carts-class-name input").first
    expect(name).to_have_text(f"marks.csv · {group.input_value()}")
    when = page.locator(".carts-class-tables select")
    when.select_option("post")
    group.fill("Class 3B")
    group.press("Enter")
    expect(name).to_have_text("marks.csv · Class 3B")
    expect(when).to_have_value("post")
    page.locator(".carts-class-two").uncheck()
    expect(name).to_have_text("marks.csv")


def test_another_table_in_the_place_of_one_is_shown(page: Page) -> None:
    page.evaluate(TAKE, ["marks.csv"])
    page.evaluate(
        """() => {
          const { classroom } = document.querySelector("carts-class");
          classroom.tables = [{ ...classroom.tables[0], name: "other.csv" }];
          return document.querySelector("carts-class").show();
        }"""
    )
    expect(page.locator(".carts-class-tables bdi")).to_have_text("other.csv")


def test_progress_counts_what_python_reads(page: Page) -> None:
    assert page.evaluate(TAKE, ["a.csv", "b.csv", "answers.json"]) == 1
