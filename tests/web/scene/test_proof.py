"""“Prove these digits”: nothing before it is asked for; then bounds, and a band of tolerances."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from sim.bridge.certify_answer import PATIENCE
from sim.bridge.protocol import answer
from sim.pages.text.yaml.source import load
from sim.scene import read_fence
from tests.web.conftest import OpenPage
from tests.web.scene.given.widget_site import LIVE, in_node, live, on_scene

pytestmark = pytest.mark.browser

ROOT = Path(__file__).parents[3]
PROVED = 1000 * PATIENCE + LIVE  # ms; as long as the page itself goes on, and its start


def weighed() -> dict[str, Any]:
    """The scene of the page on certificates, as its author wrote it."""
    text = (ROOT / "docs" / "accuracy" / "certificates.md").read_text(encoding="utf-8")
    fence = text.partition("```scene\n")[2].partition("```")[0]
    return dict(read_fence(load(fence).plain).plain)


def opened(open_page: OpenPage, site: Path) -> Page:
    page = live(open_page(site / "accuracy" / "certificates.html", folder=site), "weighed")
    page.locator("#weighed .carts-how > summary").click()
    return page


def proved(page: Page) -> list[list[str]]:
    page.locator("#weighed .carts-proof-go").click()
    expect(page.locator("#weighed .carts-proof-told")).to_be_visible(timeout=PROVED)
    rows = page.locator("#weighed .carts-proof-told tbody tr")
    return [[cell.inner_text() for cell in row.locator("th, td").all()] for row in rows.all()]


@pytest.mark.one_browser
def test_a_page_carries_and_reads_nothing_of_a_proof_before_it_is_asked_for(
    open_page: OpenPage, site: Path
) -> None:
    page = live(open_page(site / "accuracy" / "certificates.html", folder=site), "weighed")
    read = "() => [...document.scripts].map((one) => one.src).filter((src) => /proof/.test(src))"
    assert page.evaluate(read) == []
    page.locator("#weighed .carts-how > summary").click()
    expect(page.locator("#weighed .carts-proof-go")).to_be_visible()
    assert [src.rpartition("/")[2] for src in page.evaluate(read)] == ["proof.js"]


@pytest.mark.one_browser
def test_beside_a_moving_camera_it_says_whose_places_are_proved(
    open_page: OpenPage, site: Path
) -> None:
    lesson = site / "worksheets" / "newtons-first-law.html"
    page = live(open_page(lesson, folder=site), "moving-camera")
    page.locator("#moving-camera input[type=radio]").first.check()
    page.locator("#moving-camera .carts-lock").click()
    page.locator("#moving-camera .carts-end:enabled").click()  # nothing is proved before
    page.locator("#moving-camera .carts-how > summary").click(timeout=PROVED)
    page.locator("#moving-camera .carts-proof-go").click()
    note = page.locator("#moving-camera .carts-proof-note")
    expect(note).to_contain_text("those on the track", timeout=PROVED)


@pytest.mark.one_browser
def test_the_page_proves_what_the_program_proves_and_draws_what_tolerances_allow(
    open_page: OpenPage, site: Path
) -> None:
    page = opened(open_page, site)
    rows = proved(page)
    header, _ = answer({"id": 1, "kind": "certify", "scene": weighed()})
    final = header["certificate"]["final"]
    assert [row[0] for row in rows[-4:]] == [
        f"{kind} of {cart} at the end" for cart in "AB" for kind in "xv"
    ]
    for row, (cart, kind) in zip(rows[-4:], ["Ax", "Av", "Bx", "Bv"], strict=True):
        low, high = (float(text.split()[0]) for text in row[1:3])
        least, most = map(float, final[kind][cart])
        wide = most - least
        # Balls and intervals are not equally wide: a few hundredths of what the inputs allow.
        assert (low, high) == pytest.approx((least, most), abs=0.03 * wide)
    note = page.locator("#weighed .carts-proof-note")
    expect(note).to_contain_text("The order of the events is proved.")
    expect(page.locator("#weighed .carts-band")).to_have_count(4)
    # Another mass: what was proved is no longer of this run.
    on_scene(page, 'await el.set({ "B.mass": 2 })', name="weighed")
    expect(page.locator("#weighed .carts-band")).to_have_count(0)
    expect(page.locator("#weighed .carts-proof-told")).to_be_hidden()


@pytest.mark.one_browser
def test_exact_inputs_have_nearly_all_digits_and_no_band(open_page: OpenPage, site: Path) -> None:
    page = opened(open_page, site)
    on_scene(page, 'await el.set({ "A.mass": 0.5 })', name="weighed")
    rows = proved(page)
    assert all(row[3] == "all" or int(row[3]) >= 15 for row in rows), rows
    on_scene(page, 'await el.set({ "A.mass": 0.5 })', name="weighed")  # a run of the same values
    expect(page.locator("#weighed .carts-proof-told")).to_be_visible()
    command = page.locator("#weighed .carts-proof code")  # for somebody who does not trust the page
    expect(command).to_have_text("carts run scene.yml --certify --json")
    expect(page.locator("#weighed .carts-band")).to_have_count(0)


def test_sure_digits_are_those_in_which_both_bounds_agree() -> None:
    cases = [
        (["0.7902756327831377", "0.7902756327831382"], 15),
        (["1.24205", "1.24811"], 2),
        (["0.2348", "0.4385"], 0),
        (["-0.12000000000000004", "-0.11999999999999998"], 16),
        (["0.0", "0.0"], None),
    ]
    found = in_node(
        "const rows = await import(`${source}/proof/rows.js`); give(data.map(rows.sureDigits));",
        [list(bounds) for bounds, _ in cases],
    )
    assert found == [digits for _, digits in cases]


def test_bounds_around_nought_say_to_how_many_decimals_it_is_nought() -> None:
    """Thirty noughts are no “none”; the bounds are powers of ten, never rounded inwards."""
    cases = {
        ("-1.0408e-30", "1.0408e-30"): (["−1.06 × 10⁻³⁰", "1.06 × 10⁻³⁰"], "0, to 29 decimals"),
        ("-3e-05", "0.00012"): (["−3.01 × 10⁻⁵", "1.21 × 10⁻⁴"], "0, to 3 decimals"),
        ("0.0", "9.99e-17"): (["0", "1.00 × 10⁻¹⁶"], "0, to 15 decimals"),
        ("-0.2", "0.4"): (None, "none"),
        ("1e-30", "3e-30"): (None, "none"),
        ("0.0", "0.0"): (["0.0", "0.0"], "all"),
    }
    found = in_node(
        "const rows = await import(`${source}/proof/rows.js`); give(data.map(rows.cells));",
        [list(bounds) for bounds in cases],
    )
    for told, (texts, count) in zip(found, cases.values(), strict=True):
        assert told["count"] == count
        assert texts is None or told["texts"] == texts
