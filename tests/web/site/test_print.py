"""A lesson as it is printed: what is on paper says something there."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from sim.classroom.files.keyed import read_key_file
from sim.classroom.files.reading import Reading
from sim.classroom.handouts.paper import Handout, handout, handout_file
from sim.classroom.report.report import WHOLE, Asked
from sim.classroom.show.standalone import whole_file
from sim.pages.question.quiz import read_bank_text
from tests.classroom.given.makers import keys, random_class, sources
from tests.web.conftest import OpenPage
from tests.web.runtime.boot_site import ROOT
from tests.web.site.pages_of import SHEET

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]


def test_a_form_for_readings_that_nobody_has_chosen_is_not_printed(
    site: Path, open_page: OpenPage
) -> None:
    page = open_page(site / "worksheets" / "real-carts.html", folder=site)
    expect(page.locator("#real-own")).to_have_attribute("data-state", "live", timeout=60_000)
    page.emulate_media(media="print")
    expect(page.locator("#real-own")).to_be_hidden()
    expect(page.locator("#real-film .carts-measured-figure").first).to_be_visible()
    expect(page.locator("#real-film .carts-measured-unit").first).to_be_hidden()


def test_the_hard_cases_are_a_table_on_paper_of_few_sheets(site: Path, open_page: OpenPage) -> None:
    """As on a phone, each cell on a line of its own, they took fifteen sheets, mostly white."""
    page = open_page(site / "accuracy" / "hard-cases.html", folder=site)
    assert len(SHEET.findall(page.pdf(format="A4"))) <= 7


def test_what_leads_to_a_table_is_printed_above_it(site: Path, open_page: OpenPage) -> None:
    page = open_page(site / "accuracy" / "measured.html", folder=site)
    page.emulate_media(media="print")
    commands = page.locator("article p:has(+ .md-typeset__scrollwrap)")
    assert commands.count() > 5
    for command in commands.all():
        expect(command).to_have_css("break-after", "avoid")


def test_what_happens_in_a_run_is_not_told_on_two_sheets(site: Path, open_page: OpenPage) -> None:
    page = open_page(site / "physics" / "map.html", folder=site)
    page.emulate_media(media="print")
    expect(page.locator(".carts-story").first).to_have_css("break-inside", "avoid")


MM = 96 / 25.4  # px


def test_cards_are_printed_as_cards_to_be_cut(site: Path, open_page: OpenPage) -> None:
    page = open_page(site / "teachers" / "cards.html", folder=site)
    page.emulate_media(media="print")
    cards = page.locator("article td").locator("visible=true")
    expect(cards).to_have_count(40)
    assert cards.evaluate_all("(all) => Math.min(...all.map((one) => one.offsetHeight))") > 20 * MM
    expect(cards.first).to_have_css("border-bottom-style", "dashed")
    for words in ("h1", "p", "th"):
        assert page.locator(f"article {words}").locator("visible=true").count() == 0


def test_the_lesson_on_paper_is_two_sheets_of_lines_to_write_on(
    site: Path, open_page: OpenPage
) -> None:
    page = open_page(site / "teachers" / "paper-lesson.html", folder=site)
    assert len(SHEET.findall(page.pdf(format="A4"))) == 2
    page.emulate_media(media="print")
    expect(page.get_by_text("leave out part 5")).to_be_hidden()  # to the teacher
    apart = """(lines) => Math.min(...lines.slice(1).map((line, k) =>
        line.getBoundingClientRect().top - lines[k].getBoundingClientRect().top))"""
    assert page.locator("article hr").evaluate_all(apart) > 7 * MM


def test_the_lab_sheet_has_rows_to_write_in_as_wide_as_its_text(
    site: Path, open_page: OpenPage
) -> None:
    page = open_page(site / "teachers" / "lab-sheet.html", folder=site)
    page.emulate_media(media="print")
    rows = page.locator("article tbody tr").evaluate_all("(all) => all.map((r) => r.offsetHeight)")
    assert min(rows) >= 10.9 * MM


def test_four_slips_of_two_tests_are_a_sheet(tmp_path: Path, open_page: OpenPage) -> None:
    """Seventeen sheets for forty students, half of them white."""
    text = (ROOT / "worksheets" / "banks" / "forces-and-motion.yml").read_text(encoding="utf-8")
    bank, _ = read_bank_text(text, "forces-and-motion.yml")
    assert bank
    read = [(one, WHOLE) for one in Reading.of(sources(random_class(bank, 40))).files]
    wanted = Handout(what="slips", words={})
    html = handout_file(handout(read, read_key_file(keys(bank)), Asked(), wanted), wanted)
    (tmp_path / "slips.html").write_text(html, encoding="utf-8")
    page = open_page(tmp_path / "slips.html")
    assert len(SHEET.findall(page.pdf(format="A4"))) <= 11


def test_a_part_of_a_report_that_is_closed_is_not_printed(
    tmp_path: Path, open_page: OpenPage
) -> None:
    closed = "<details><summary>Question by question</summary><p>1</p></details>"
    (tmp_path / "report.html").write_text(whole_file(closed, "Report"), encoding="utf-8")
    page = open_page(tmp_path / "report.html")
    expect(page.locator("summary")).to_be_visible()
    page.emulate_media(media="print")
    expect(page.locator("summary")).to_be_hidden()
