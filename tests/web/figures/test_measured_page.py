"""Readings of real carts in a page: from a folder on the disk, in both browsers."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from sim.measured.tracks import read_measured
from tests.measured.makers import as_text, film, truth
from tests.web.classroom.class_site import CATCH, LAST
from tests.web.conftest import OpenPage, SharePage
from tests.web.figures.measured_bench import LIVE, STARTS, benches, choose, opened
from tests.web.kept_store import MEASURED, written

__all__ = ["benches"]  # a fixture

pytestmark = pytest.mark.browser

MADE = truth(e=0.7, ratio=1.5)
TRACKER = as_text(film(MADE)).replace(".", ",").replace("-", "\u2212").replace("\n", "\r\n")


ASKED = ".carts-measured-unit:visible"


def units(page: Page, length: str = "m", time: str = "s") -> None:
    page.locator(".carts-measured-unit[data-kind=length]").select_option(length)
    page.locator(".carts-measured-unit[data-kind=time]").select_option(time)


def saved(page: Page, button: str) -> str:
    page.evaluate(CATCH)
    page.locator(button).click()
    return bytes(page.evaluate(LAST)).decode("utf-8")


def known(page: Page, key: str) -> dict[str, float]:
    found = page.evaluate(
        "key => document.querySelector('carts-measured').report.known.find((k) => k.key === key)",
        key,
    )
    return dict(found)


@pytest.mark.one_browser
def test_from_a_tracker_file_to_a_printed_page_with_e_and_its_uncertainty(
    benches: Path, shared_page: SharePage, browser_name: str
) -> None:
    page = opened(shared_page, benches / "empty.html")
    expect(page.locator(LIVE)).to_have_count(1, timeout=STARTS)
    choose(page, "our film.txt", TRACKER)
    faults = page.locator(".carts-measured-unread")
    expect(faults).to_contain_text(
        "Choose what times are in and what lengths are in", timeout=STARTS
    )
    said = page.locator(".carts-measured-said")
    axes = page.locator(".carts-measured-figure .carts-unit")
    expect(said).not_to_contain_text("as chosen")  # before anybody chose
    expect(page.locator(ASKED)).to_have_count(2)  # of forces there are none
    expect(axes).to_have_text(["x", "t"])
    units(page)
    expect(said).to_contain_text("t in s (as chosen); x in m (as chosen)")
    expect(axes).to_have_text(["x in m", "t in s"])
    expect(faults).to_be_empty()
    expect(page.locator(".carts-measured-said")).to_contain_text("decimal comma")
    page.locator(".carts-measured-masses input").first.fill("0.5")
    # What each cart did is found before any fit, and can be set by hand.
    edges = page.locator(".carts-measured-edge")
    expect(edges).to_have_count(4, timeout=2 * STARTS)
    edges.nth(0).press("ArrowLeft")
    expect(page.locator(".carts-measured-as-found")).to_be_visible(timeout=STARTS)
    expect(page.locator(".carts-measured-known")).to_have_count(0)
    page.locator(".carts-measured-as-found").click()
    expect(page.locator(".carts-measured-as-found")).to_have_count(0)
    page.locator(".carts-measured-fit").click()
    table = page.locator(".carts-measured-known")
    expect(table).to_contain_text("bounciness e", timeout=2 * STARTS)
    sentences = page.locator(".carts-measured-sentences")
    expect(sentences).to_contain_text("Weigh both carts")
    added = page.locator(".carts-measured-result")
    expect(added).to_contain_text("Nothing was added: these readings call for neither")
    for key, value in (("e", MADE.e), ("mass_ratio", MADE.ratio), ("mass", 0.75)):
        interval = known(page, key)
        assert interval["low"] <= value <= interval["high"]
    page.locator(".carts-measured-compare").click()
    expect(sentences).to_contain_text("do not call for them")
    back = read_measured([saved(page, ".carts-measured-tracker")])
    assert back.names == ("A", "B")
    assert "restitution" in saved(page, ".carts-measured-scene")
    expect(page.locator(".carts-measured-fence")).to_have_value(
        # the whole block stands there, to be put into a lesson
        re.compile(r"^```scene\nid: our-own-carts\n[\s\S]*```\n$")
    )
    # It is all there after the page is opened again.
    page.reload()
    expect(table).to_contain_text("bounciness e", timeout=2 * STARTS)
    assert known(page, "e")["low"] <= MADE.e <= known(page, "e")["high"]
    expect(sentences).to_contain_text("do not call for them")
    expect(page.locator(".carts-measured-said")).to_contain_text("our film.txt")
    if browser_name == "chromium":  # Firefox's driver cannot show paper
        page.emulate_media(media="print")
        expect(table).to_be_visible()
        expect(page.locator(".carts-measured-figure")).to_be_visible()
        expect(page.locator(".carts-measured-fit")).to_be_hidden()


@pytest.mark.one_browser
def test_a_model_set_by_hand_leaves_smaller_residuals_and_is_kept(
    benches: Path, shared_page: SharePage
) -> None:
    page = opened(shared_page, benches / "film.html")
    expect(page.locator(LIVE)).to_have_count(1, timeout=STARTS)
    left = page.locator(".carts-measured-spread")
    expect(left).to_contain_text("root mean square", timeout=STARTS)
    before = left.inner_text()
    for key, value in (("ratio", "1.99"), ("e", "0.84"), ("touch", "2.916"), ("va", "0.69")):
        box = page.locator(f"[data-hand={key}] input[type=text]")
        box.fill(value)
        box.press("Tab")
    expect(left).not_to_have_text(before)
    expect(left).to_contain_text("is 1")  # some 10 mm: friction is not in it
    slider = page.locator("[data-hand=e] input[type=range]")
    assert float(slider.input_value()) == pytest.approx(0.84, abs=0.01)
    slider.focus()
    page.keyboard.press("ArrowLeft")
    expect(page.locator("[data-hand=e] input[type=text]")).not_to_have_value("0.84")
    kept = page.locator("[data-hand=e] input[type=text]").input_value()
    written(page, MEASURED)
    page.reload()
    expect(page.locator("[data-hand=e] input[type=text]")).to_have_value(kept, timeout=STARTS)
    page.locator(".carts-measured-scrub").focus()
    place = page.locator(".carts-measured-stage g").first
    at_start = place.get_attribute("transform")
    for _ in range(3):
        page.keyboard.press("PageUp")
    assert place.get_attribute("transform") != at_start
    # Shorter readings end sooner, and so does the time that is shown.
    page.keyboard.press("End")
    rows = [f"{k / 30:.4f};{0.2 + 0.5 * k / 30:.4f};0.9" for k in range(30)]
    choose(page, "short.csv", "\n".join(["t;x_A;x_B", *rows]))
    expect(page.locator(".carts-measured-said")).to_contain_text("short.csv")
    clock = page.locator(".carts-measured-clock")
    assert float(clock.inner_text().split()[2]) == pytest.approx(29 / 30, abs=0.05)
    expect(page.locator(ASKED)).to_have_count(2)
    choose(page, "named.csv", "\n".join(["t (s);x_A (m);x_B (m)", *rows]))
    expect(page.locator(".carts-measured-said")).to_contain_text("x in m (as the file says)")
    expect(page.locator(ASKED)).to_have_count(0)  # the file has said it


@pytest.mark.one_browser
def test_typed_readings_are_read_kept_and_their_mistakes_told_by_row(
    benches: Path, shared_page: SharePage
) -> None:
    page = opened(shared_page, benches / "empty.html")
    expect(page.locator(LIVE)).to_have_count(1, timeout=STARTS)
    page.locator(".carts-measured-type summary").click()
    measured = film(MADE, rate=30)
    rows = list(zip(measured.tracks[0].t, *(t.value for t in measured.tracks), strict=True))
    block = "\n".join("\t".join(f"{value:.4f}" for value in row) for row in rows)
    first = page.locator(".carts-measured-grid input").first
    first.focus()
    first.evaluate(
        """(box, text) => { const data = new DataTransfer(); data.setData("text/plain", text);
        box.dispatchEvent(new ClipboardEvent("paste", {clipboardData: data, bubbles: true})); }""",
        block,
    )
    units(page)
    page.locator(".carts-measured-grid tr").nth(4).locator("input").nth(1).fill("near")
    page.locator(".carts-measured-typed-take").click()
    faults = page.locator(".carts-measured-unread")
    expect(faults).to_contain_text("row 4: “near” is not a number", timeout=STARTS)
    page.locator(".carts-measured-grid tr").nth(4).locator("input").nth(1).fill("0,5")
    page.locator(".carts-measured-typed-take").click()
    expect(faults).to_contain_text("row 4: “0,5” has another decimal sign than “0.0000” in row 1")
    page.locator(".carts-measured-grid tr").nth(4).locator("input").nth(1).fill(f"{rows[3][1]:.4f}")
    page.locator(".carts-measured-typed-take").click()
    expect(faults).to_be_empty()
    expect(page.locator(".carts-measured-model")).to_be_visible()
    page.locator(".carts-measured-paste summary").click()
    page.locator(".carts-measured-paste textarea").fill("half a text")
    written(page, MEASURED)
    page.reload()
    expect(page.locator(".carts-measured-model")).to_be_visible(timeout=STARTS)
    expect(page.locator(".carts-measured-paste textarea")).to_have_value("half a text")
    expect(page.locator(".carts-measured-grid input").first).to_have_value("0.0000")


@pytest.mark.one_browser
def test_two_sensors_are_compared_and_the_lessons_file_can_be_saved(
    benches: Path, shared_page: SharePage
) -> None:
    page = opened(shared_page, benches / "forces.html")
    expect(page.locator(".carts-measured-result")).to_contain_text(
        "equal in size and opposite", timeout=STARTS
    )
    expect(page.locator(".carts-measured-model")).to_be_hidden()
    built_in = "was told the third law"
    expect(page.locator(".carts-measured-result")).to_contain_text(built_in)
    text = saved(page, ".carts-measured-save")
    assert text.startswith("t (s);F_A (N);F_B (N)")
    choose(page, "ours.csv", text)  # a reader's own readings are evidence
    expect(page.locator(".carts-measured-result")).to_contain_text("read off the readings alone")
    expect(page.locator(".carts-measured-result")).not_to_contain_text(built_in)


@pytest.mark.one_browser
def test_hostile_names_are_shown_and_never_run_and_a_phone_is_wide_enough(
    benches: Path, shared_page: SharePage
) -> None:
    page = opened(shared_page, benches / "film.html")
    expect(page.locator(LIVE)).to_have_count(1, timeout=STARTS)
    hostile = "<img src=x onerror=window.hacked=1>"
    text = as_text(film(MADE)).replace("\tA\t", f"\t{hostile}\t")
    choose(page, f"{hostile}.txt", text)
    expect(page.locator(".carts-measured-legend")).to_contain_text("<img src=x", timeout=STARTS)
    assert page.evaluate("window.hacked ?? document.querySelector('carts-measured img')") is None
    page.set_viewport_size({"width": 360, "height": 700})
    assert page.evaluate("document.documentElement.scrollWidth") <= 360
    page.locator(".carts-measured-own").click()
    expect(page.locator(".carts-measured-said")).to_contain_text("real-carts.txt")


@pytest.mark.one_browser
def test_without_a_script_points_and_table_stand_there(benches: Path, open_page: OpenPage) -> None:
    page = open_page(benches / "film.html", java_script_enabled=False)
    expect(page.locator(".carts-measured-figure .carts-measured-dots")).to_have_count(2)
    page.locator(".carts-measured-table summary").click()
    expect(page.locator(".carts-measured-table tbody tr")).to_have_count(60)


def sheets(page: Page) -> int:
    return len(re.findall(rb"/Type\s*/Page\b", page.pdf(format="A4")))


@pytest.mark.one_browser
def test_the_lab_sheet_and_a_fitted_film_are_a_printed_page_each(
    site: Path, open_page: OpenPage
) -> None:
    page = open_page(site / "teachers" / "lab-sheet.html", folder=site)
    assert sheets(page) == 1
    page.goto((site / "worksheets" / "real-carts.html").as_uri())
    film_ = page.locator("#real-film")
    expect(film_).to_have_attribute("data-state", "live", timeout=STARTS)
    film_.locator(".carts-measured-fit").click()
    expect(film_.locator(".carts-measured-known")).to_be_visible(timeout=2 * STARTS)
    page.evaluate("window.print = () => {}")
    film_.locator(".carts-measured-print").click()
    assert sheets(page) == 1
