"""The bench fits own readings with what they call for; a lesson's film with what is chosen."""

from __future__ import annotations

import io
import zipfile
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.measured.makers import as_text, film, truth
from tests.web.conftest import SharePage
from tests.web.figures.measured_bench import LIVE, STARTS, benches, choose

__all__ = ["benches"]  # a fixture

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]

BRAKED = as_text(film(truth(
    v=(0.5, 0.0), gap=0.6, after=1.5, effects=({"friction": {"coefficient": 0.01}},),
), rate=60))  # fmt: skip


def e_of(page: Page) -> tuple[float, float]:
    row = page.evaluate(
        "document.querySelector('carts-measured').report.known.find((k) => k.key === 'e')"
    )
    return row["low"], row["high"]


def test_own_readings_are_fitted_with_what_they_call_for_unless_one_chooses(
    benches: Path, shared_page: SharePage
) -> None:
    page = shared_page(benches / "film.html")
    expect(page.locator(LIVE)).to_have_count(1, timeout=STARTS)
    effect = page.locator(".carts-measured-effect")
    expect(effect).to_have_value("none")  # of the lesson's film it is a question
    choose(page, "ours.txt", BRAKED)
    expect(page.locator(".carts-measured-said")).to_contain_text("ours.txt", timeout=STARTS)
    expect(effect).to_have_value("called")
    page.locator(".carts-measured-fit").click()
    result = page.locator(".carts-measured-result")
    expect(result).to_contain_text("Friction on each cart was added", timeout=2 * STARTS)
    low, high = e_of(page)
    assert low <= 0.8 <= high and high - low < 0.05
    expect(result).to_contain_text("coefficient of friction μ of A")
    # One measure of what is left, under the picture and in the comparison.
    spread = page.locator(".carts-measured-spread").inner_text()
    left = spread.split("root mean square is ")[1].split(" mm")[0]
    expect(result).to_contain_text(f"with friction on each cart: {left} mm")
    effect.select_option("none")
    page.locator(".carts-measured-fit").click()
    doubt = page.locator(".carts-measured-doubt")
    expect(doubt).to_contain_text("These readings call for friction", timeout=STARTS)
    assert e_of(page)[1] < 0.8
    page.locator(".carts-measured-own").click()
    expect(page.locator(".carts-measured-said")).to_contain_text("real-carts.txt")
    expect(effect).to_have_value("none")


def test_a_lessons_film_says_that_something_is_missing_and_not_what(
    benches: Path, shared_page: SharePage
) -> None:
    page = shared_page(benches / "film.html")
    expect(page.locator(LIVE)).to_have_count(1, timeout=STARTS)
    page.locator(".carts-measured-fit").click()
    doubt = page.locator(".carts-measured-doubt")
    expect(doubt).to_contain_text("does not fit these readings", timeout=2 * STARTS)
    assert "riction" not in doubt.inner_text() and "tilt" not in doubt.inner_text()
    page.locator(".carts-measured-effect").select_option("friction")
    page.locator(".carts-measured-fit").click()
    expect(page.locator(".carts-measured-known")).to_contain_text("coefficient", timeout=STARTS)
    expect(doubt).to_have_count(0)


def test_a_workbook_that_is_dropped_is_called_one(benches: Path, shared_page: SharePage) -> None:
    page = shared_page(benches / "empty.html")
    expect(page.locator(LIVE)).to_have_count(1, timeout=STARTS)
    expect(page.locator(".carts-measured-effect")).to_have_value("called")
    book = io.BytesIO()
    with zipfile.ZipFile(book, "w") as pack:
        pack.writestr("xl/workbook.xml", "<workbook/>")
    page.locator(".carts-measured-file").set_input_files(
        [{"name": "ours.xlsx", "mimeType": "application/zip", "buffer": book.getvalue()}]
    )
    faults = page.locator(".carts-measured-unread")
    expect(faults).to_contain_text("ours.xlsx was not read: this is a workbook", timeout=STARTS)
    expect(faults).to_contain_text("as CSV")
