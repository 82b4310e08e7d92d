"""The page “Class results”: files in, tables out, in both browsers, from a folder on the disk."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from sim.classroom.files.reading import Source
from tests.classroom.given.everything import a_class, left_in_english
from tests.classroom.given.makers import answers, bank, form, keys, random_class, sources, zipped
from tests.web.classroom.class_site import (
    BANK,
    KEY,
    NOTE_PRINT,
    PRINTED,
    choose,
    complete,
    saved,
)
from tests.web.conftest import OpenPage

pytestmark = pytest.mark.browser


def test_a_class_and_its_key_give_means_and_then_intervals(
    place: Path, open_page: OpenPage
) -> None:
    page = open_page(place)  # of its own: what starts late comes after what is read
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    expect(page.locator("carts-class[data-state=ready]")).to_have_count(1)
    choose(page, [*sources(random_class(BANK, 12)), KEY])
    means = page.locator(".carts-class-table.means")
    expect(means).to_contain_text("before (pre)", timeout=60_000)
    complete(page)
    expect(means).to_contain_text(" to ")
    expect(page.locator(".carts-class-report")).to_contain_text("Hake's gain")
    assert page.locator(".carts-class-plot circle").count() == 24
    assert not errors


@pytest.mark.one_browser
def test_what_is_still_read_when_everything_is_deleted_does_not_come_back(page: Page) -> None:
    came = page.evaluate(
        """async () => {
          const element = document.querySelector("carts-class");
          element.take([new File(["student,marks\\nA,1\\n"], "marks.csv")], 0);
          element.take([new File(["{"], "bad.json")], 0);
          element.clear();
          await element.complete;
          const { tables, refused } = element.classroom;
          return [tables.length, refused.length];
        }"""
    )
    assert came == [0, 0]
    expect(page.locator(".carts-class-status")).to_contain_text("Everything is deleted")


@pytest.mark.one_browser
def test_a_bad_file_in_a_zip_is_named_and_the_others_are_counted(page: Page) -> None:
    packed = zipped([*sources(random_class(BANK, 6)), Source("bad.json", b"{"), KEY])
    choose(page, [Source("class.zip", packed), Source("picture.png", b"\x89PNG\r\n\xff")])
    report = page.locator(".carts-class-report")
    expect(report).to_contain_text("12 of 12 files of answers", timeout=60_000)
    expect(report).to_contain_text("class.zip/bad.json: this file is damaged")
    expect(report).to_contain_text("picture.png: this is no text file")


@pytest.mark.one_browser
def test_slips_are_printed_alone_and_in_the_language_that_was_chosen(page: Page) -> None:
    choose(page, [*sources(random_class(BANK, 6)), KEY])
    expect(page.locator(".carts-class-table.means")).to_be_visible(timeout=60_000)
    page.evaluate(NOTE_PRINT)
    page.locator(".carts-class-language").select_option("ms")
    page.get_by_role("button", name="Print slips for students").click()
    slips = page.locator(".carts-slip")
    expect(slips).to_have_count(6)
    expect(page.locator("html.carts-class-paper-only")).to_have_count(1)
    expect(page.locator("carts-class")).to_have_attribute("data-printed", "yes")
    assert "Sebelum pelajaran" in (slips.first.text_content() or "")
    assert not slips.first.is_visible()
    page.emulate_media(media="print")
    expect(slips.first).to_be_visible()
    expect(page.locator(".carts-class-table.means")).to_be_hidden()
    page.evaluate(PRINTED)
    expect(slips.first).to_be_hidden()
    expect(page.locator(".carts-class-table.means")).to_be_visible()


SPOKEN = """() => {
  const all = [...document.querySelectorAll("carts-class *")];
  const own = (node) => [...node.childNodes].filter((n) => n.nodeType === 3).map((n) => n.data);
  const labels = ["aria-label", "placeholder", "title"].flatMap(
    (name) => all.map((node) => node.getAttribute(name) ?? ""));
  return [...all.flatMap(own), ...labels];
}"""


@pytest.mark.one_browser
def test_nothing_on_the_page_is_said_outside_the_catalogues(
    place: Path, open_page: OpenPage
) -> None:
    """In a language of blanks only names are left: of buttons, messages and of the report."""
    page = open_page(place.with_name("blanked.html"))
    expect(page.locator("carts-class[data-state=ready]")).to_have_count(1)
    said = set(page.evaluate(SPOKEN))
    page.locator(".carts-class-two").check()
    choose(page, [*a_class(), Source("t1.csv", b"student,pre,post\nA-1,2,z\n")])
    complete(page)
    page.locator(".carts-class-list > summary").click()
    page.locator(".carts-class-list li").first.wait_for()
    page.locator(".carts-class-reader > summary").click()
    said |= set(page.evaluate(SPOKEN))
    page.locator(".carts-class-clear").first.click()
    said |= set(page.evaluate(SPOKEN))
    said -= {BLANK_EXAMPLE}
    assert len(said) > 300
    assert left_in_english("\n".join(said)) == set()


BLANK_EXAMPLE = "BLUE-FOX-27 pre 7K2M-Q9ZD-03HX"


@pytest.mark.one_browser
def test_hostile_names_are_shown_and_never_run(page: Page) -> None:
    hostile = '<img src="x" onerror="window.hacked=1"><script>window.hacked=1</script>'
    file = answers(BANK, hostile, "pre", {"item-0": "a"}, lesson=hostile)
    choose(page, [Source(f"{hostile}.json", json.dumps(file).encode())])
    report = page.locator(".carts-class-report")
    expect(report.locator("h2", has_text="<img src=")).to_have_count(1, timeout=60_000)
    assert page.evaluate("window.hacked") is None
    assert report.locator("img, script").count() == 0


@pytest.mark.one_browser
def test_two_groups_stand_side_by_side(page: Page) -> None:
    page.locator(".carts-class-two").check()
    choose(page, [*sources(random_class(BANK, 8, seed=1, prefix="FOX")), KEY], group=0)
    choose(page, sources(random_class(BANK, 9, seed=2, prefix="OWL")), group=1)
    report = page.locator(".carts-class-report")
    expect(report).to_contain_text("Before teaching: experimental minus control", timeout=60_000)
    complete(page)
    expect(report).to_contain_text("Adjusted for the start")
    expect(report).to_contain_text("no p-value for the teaching is given")
    page.locator(".carts-class-name input").first.fill("new")
    expect(report).to_contain_text("Before teaching: new minus control")


@pytest.mark.one_browser
def test_a_file_that_is_left_out_does_not_count(page: Page) -> None:
    choose(page, [*sources(random_class(BANK, 6)), KEY])
    report = page.locator(".carts-class-report")
    expect(report).to_contain_text("12 of 12 files", timeout=60_000)
    page.locator(".carts-class-list > summary").click()
    page.locator(".carts-class-list input").first.uncheck()
    expect(report).to_contain_text("11 of 11 files")
    expect(page.locator(".carts-class-list > summary")).to_contain_text("1 left out")


@pytest.mark.one_browser
def test_who_works_by_keys_stays_where_they_were(page: Page) -> None:
    """The button that chose files, a file's box and a table's button are made anew meanwhile."""
    pick = page.locator(".carts-class-pick")
    pick.focus()
    tables = [Source(f"{k}.csv", b"student,pre\nA,1\n") for k in "ab"]
    choose(page, [*sources(random_class(BANK, 6)), *tables, KEY])
    expect(page.locator(".carts-class-report")).to_contain_text("12 of 12", timeout=60_000)
    expect(pick).to_be_focused()
    page.locator(".carts-class-list > summary").press("Enter")
    box = page.locator(".carts-class-list input").nth(2)
    box.press("Space")
    expect(page.locator(".carts-class-list > summary")).to_contain_text("1 left out")
    expect(box).to_be_focused()
    page.locator(".carts-class-tables li button").first.press("Enter")
    expect(page.locator(".carts-class-tables li")).to_have_count(1)
    expect(page.locator(".carts-class-tables li button")).to_be_focused()


@pytest.mark.one_browser
def test_the_key_that_was_dropped_is_printed_without_any_answers(page: Page) -> None:
    expect(page.locator(".carts-class-print-key")).to_be_hidden()
    choose(page, [KEY])
    page.evaluate(NOTE_PRINT)
    page.locator(".carts-class-print-key").click()
    expect(page.locator(".carts-class-paper .carts-sheet")).to_have_count(2, timeout=60_000)
    expect(page.locator("carts-class")).to_have_attribute("data-printed", "yes")
    assert "both forces" in (page.locator(".carts-class-paper").text_content() or "")
    page.evaluate(PRINTED)


@pytest.mark.one_browser
def test_typed_codes_are_counted_beside_files(page: Page) -> None:
    from sim.lesson.handin import encode

    choices = bank(8)
    code = encode([4] * 8, [1, 2, 3, 4, 1, 2, 3, 4], f"pre:{form('pre', choices).hash}")
    choose(page, [Source("key.json", keys(choices).encode())])
    expect(page.locator(".carts-class-list > summary")).to_contain_text("key for 2", timeout=60_000)
    page.locator(".carts-class-codes > summary").click()
    box = page.locator(".carts-class-codes textarea")
    box.fill(f"BLUE-FOX pre {code}\nRED-OWL pre {code[:-1]}")
    report = page.locator(".carts-class-report")
    expect(report).to_contain_text("1 of 1 files")
    expect(report).to_contain_text("typed, line 2: RED-OWL")
    page.locator(".carts-class-two").check()
    second = page.locator(".carts-class-codes textarea").nth(1)
    second.fill(f"GREY-ELK pre {code}")
    page.locator(".carts-class-name input").first.fill("new")  # what is drawn meanwhile
    page.locator(".carts-class-name input").first.fill("experimental")
    expect(report).to_contain_text("2 of 2 files")
    expect(second).to_have_value(f"GREY-ELK pre {code}")
    lines = saved(page, ".carts-class-save-csv").decode().replace('"', "").splitlines()
    rows = [line.split(",")[2:4] for line in lines[1:]]
    assert rows == [["experimental", "BLUE-FOX"], ["control", "GREY-ELK"]]


@pytest.mark.one_browser
def test_one_question_is_read_and_marked_by_keys_and_the_marks_are_saved(page: Page) -> None:
    choose(page, [*sources(random_class(BANK, 6)), KEY])
    reader = page.locator(".carts-class-reader")
    expect(reader).to_be_visible(timeout=60_000)
    complete(page)
    reader.locator("summary").click()
    asked = reader.locator("option").first
    expect(asked).to_have_text(re.compile(r"^Carts · before \(pre\) · Question \d+$"))
    count = int((reader.locator(".carts-class-quiet").last.inner_text()).split()[2])
    reader.locator(".carts-class-answer").focus()
    held = 'new KeyboardEvent("keydown", {key: "0", repeat: true, bubbles: true})'  # not let go of
    reader.locator(".carts-class-answer").evaluate(f"(card) => card.dispatchEvent({held})")
    expect(reader.locator(".carts-class-quiet").last).to_have_text(f"0 of {count} marked.")
    for key in "21" * (count // 2) + "0" * (count % 2):
        page.keyboard.press(key)
    expect(reader.locator(".carts-class-quiet").last).to_have_text(f"{count} of {count} marked.")
    expect(page.locator(".carts-class-table.means")).to_contain_text("10")
    marks = json.loads(saved(page, ".carts-class-save-marks"))
    assert marks["kind"] == "newtons-carts-marks"
    assert [row["marks"] for row in marks["marks"]][:2] in ([2, 1], [1, 2])
    assert len(marks["marks"]) == count
