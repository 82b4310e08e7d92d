"""What the page “Class results” saves, prints and deletes."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from sim.classroom.files.reading import Source
from tests.classroom.given.makers import random_class, sources
from tests.web.classroom.class_site import BANK, KEY, choose, complete, saved
from tests.web.conftest import OpenPage

pytestmark = pytest.mark.browser


SAVED = {
    "html": "<!doctype html>",
    "csv": "lesson,form,group,student",
    "items": "lesson,form,item",
}


@pytest.mark.one_browser
def test_reports_and_tables_are_saved(page: Page) -> None:
    choose(page, [*sources(random_class(BANK, 6)), KEY])
    complete(page)
    for name, begins in SAVED.items():
        text = saved(page, f".carts-class-save-{name}").decode("utf-8-sig")
        assert text.startswith(begins)
        assert "FOX-1" in text or name == "items"
    assert saved(page, ".carts-class-save-png").startswith(b"\x89PNG")


@pytest.mark.one_browser
def test_a_table_of_marks_is_dropped_told_apart_and_left_out(page: Page) -> None:
    before = "student,total\n" + "".join(f"S{k},{5 + k % 4}\n" for k in range(12))
    after = "student,total\n" + "".join(f"S{k},{9 + k % 5}\n" for k in range(12))
    choose(page, [Source("one.csv", before.encode()), Source("two.csv", after.encode())])
    tables = page.locator(".carts-class-tables")
    expect(tables.locator("li")).to_have_count(2, timeout=60_000)
    tables.locator("select").nth(0).select_option("pre")
    tables.locator("select").nth(1).select_option("post")
    tables.locator("input").fill("15")
    report = page.locator(".carts-class-report")
    expect(report).to_contain_text("Hake's gain", timeout=60_000)
    tables.get_by_role("button", name="Leave out").first.click()
    expect(tables.locator("li")).to_have_count(1)
    expect(report).not_to_contain_text("Hake's gain")


@pytest.mark.one_browser
def test_everything_can_be_deleted(page: Page) -> None:
    choose(page, [*sources(random_class(BANK, 6)), KEY])
    complete(page)
    page.get_by_role("button", name="Delete everything").click()
    page.get_by_role("button", name="Delete", exact=True).click()
    expect(page.locator(".carts-class-report")).to_be_empty()
    expect(page.locator(".carts-class-list > summary")).to_have_text("Files: 0, no key file")
    choose(page, [sources(random_class(BANK, 1))[0]])
    expect(page.locator(".carts-class-report")).to_contain_text("1 of 1 files")
    # What is there now is asked about anew.
    expect(page.get_by_role("button", name="Delete everything")).to_be_visible()
    expect(page.get_by_role("button", name="Delete", exact=True)).to_be_hidden()


BESIDE = """() => ["dragover", "drop"].map((kind) => {
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File(["{}"], "a.json"));
  const event = new DragEvent(kind, { bubbles: true, cancelable: true, dataTransfer });
  return !document.querySelector("h1").dispatchEvent(event);
})"""
STAYS = "() => !dispatchEvent(new Event('beforeunload', { cancelable: true }))"


def test_a_file_that_is_dropped_beside_the_field_opens_nothing_in_place_of_the_page(
    page: Page,
) -> None:
    assert page.evaluate(BESIDE) == [True, True]
    page.locator("carts-class").evaluate("element => element.remove()")
    assert page.evaluate(BESIDE) == [False, False]


@pytest.mark.one_browser
def test_the_browser_asks_before_marks_are_lost_that_were_not_saved(page: Page) -> None:
    choose(page, [*sources(random_class(BANK, 6)), KEY])
    complete(page)
    assert not page.evaluate(STAYS)  # the files are where they were
    page.locator(".carts-class-reader summary").click()
    page.locator(".carts-class-mark").first.click()
    assert page.evaluate(STAYS)
    marks = saved(page, ".carts-class-save-marks")
    assert not page.evaluate(STAYS)
    page.locator(".carts-class-codes > summary").click()
    page.locator(".carts-class-codes textarea").fill("BLUE-FOX pre")
    assert page.evaluate(STAYS)
    saved(page, ".carts-class-save-marks")
    assert page.evaluate(STAYS)  # typed codes are in no file
    page.get_by_role("button", name="Delete everything").click()
    page.get_by_role("button", name="Delete", exact=True).click()
    assert not page.evaluate(STAYS)
    choose(page, [Source("class.marks.json", marks)])  # they lie in a file
    expect(page.locator(".carts-class-status")).to_contain_text("1 file read")
    assert not page.evaluate(STAYS)


@pytest.mark.one_browser
def test_a_code_word_that_is_being_typed_stays_when_the_report_is_made_anew(page: Page) -> None:
    files = [{**one, "student": ""} for one in random_class(BANK, 6)[:2]]
    choose(page, sources(files))
    page.locator(".carts-class-list > summary").click()
    box = page.locator(".carts-class-whose").last
    box.press_sequentially("BLUE")
    page.locator("carts-class").evaluate("element => element.show()")
    expect(box).to_be_focused()
    box.press_sequentially("-FOX")
    expect(box).to_have_value("BLUE-FOX")
    box.press("Tab")
    expect(page.locator(".carts-class-list li").last).to_contain_text("BLUE-FOX")


@pytest.mark.one_browser
def test_it_prints_without_its_controls_and_fits_a_phone(page: Page) -> None:
    choose(page, [*sources(random_class(BANK, 6)), KEY])
    complete(page)
    page.set_viewport_size({"width": 360, "height": 700})
    assert page.evaluate("document.documentElement.scrollWidth") <= 360
    if page.context.browser and page.context.browser.browser_type.name == "chromium":
        page.emulate_media(media="print")  # Firefox's driver cannot
        expect(page.locator(".carts-class-controls")).to_be_hidden()
        expect(page.locator(".carts-class-table.means")).to_be_visible()


@pytest.mark.one_browser
def test_on_the_real_page_a_worksheet_needs_no_key_and_the_report_is_what_prints(
    site: Path, open_page: OpenPage
) -> None:
    from tests.classroom.given.site_keys import keys_of

    key = [k for k in keys_of(site) if k["lesson"] == "newtons-third-law"][-1]  # the original
    item = next(i for i in key["forms"][0]["items"] if i["type"] == "single")
    number = 1 + key["forms"][0]["items"].index(item)
    right = item["key"]["correct"][0]
    time = "2026-09-01T08:00:00.000Z"
    files = [
        {
            "format": 1, "kind": "newtons-carts-answers", "site": key["site"],
            "lesson": key["lesson"], "lessonHash": "", "student": f"FOX-{k}", "form": "worksheet",
            "created": time, "saved": time, "items": [
                {"id": item["id"], "hash": item["hash"], "type": "single", "tries": 1,
                 "value": right if k < 4 else "", "first": time, "last": time}
            ],
        }
        for k in range(6)
    ]  # fmt: skip
    page = open_page(site / "teachers" / "class-results.html", folder=site)
    expect(page.locator("carts-class[data-state=ready]")).to_have_count(1)
    choose(page, sources(files))
    cell = page.get_by_role("cell", name=f"Question {number}", exact=True)
    row = page.locator(".carts-class-table.overview tr").filter(has=cell)
    expect(row).to_contain_text("4 of 6", timeout=60_000)
    complete(page)
    if page.context.browser and page.context.browser.browser_type.name == "chromium":
        page.emulate_media(media="print")
        expect(page.locator("h1")).to_be_visible()
        expect(row).to_be_visible()
        expect(page.locator(".carts-class-controls")).to_be_hidden()
        expect(page.locator("#five-minutes")).to_be_hidden()
