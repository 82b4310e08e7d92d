"""A law written in a page: run, judged, ended where it does not end, kept; from a folder."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.classroom.class_site import CATCH, LAST
from tests.web.conftest import OpenPage, SharePage
from tests.web.figures.law_site import build_law
from tests.web.figures.law_writing import HEAVY, SPRING, STARTS, bench, opened, press, write

__all__ = ["bench"]  # a fixture

pytestmark = pytest.mark.browser

TWO = """\
id: my-law
contact: {law: mine.py, pairs: {B-C: {law: another.py}}}
laws:
  another.py: |
    def force(overlap, rate):
        return 50 * overlap
  mine.py: |
    def force(overlap, rate):
        return 100 * overlap
carts:
  A: {mass: 2.0 kg, position: 0.40 m, velocity: 0.40 m/s}
  B: {mass: 0.5 kg, position: 1.20 m}
  C: {mass: 0.5 kg, position: 1.80 m}
until: 3 s
"""

LONG = f"{'# long' * 40}\n" * 30  # more than the box shows, and wider
SEEN = """(box, line) => {
  const height = parseFloat(getComputedStyle(box).lineHeight);
  return [(line - 1) * height - box.scrollTop, box.clientHeight - height, box.scrollLeft];
}"""


@pytest.mark.one_browser
def test_a_law_that_breaks_newtons_third_is_run_judged_and_its_worst_scene_shown(
    shared_page: SharePage, bench: Path
) -> None:
    page = opened(shared_page, bench)
    rows = page.locator(".carts-law-shown tr")
    expect(page.locator(".carts-law-shown figcaption")).to_have_text("The law that you begin with")
    expect(rows).to_have_count(0)  # a lesson may ask for them first
    press(page, "Run")
    expect(rows.filter(has_text="velocity of B at the end")).to_contain_text("0.640 m/s")
    note = page.locator(".carts-law-note")
    expect(note).to_have_text("Done: the new run is below.")  # on a phone it is out of sight
    write(page, HEAVY)
    press(page, "Run")
    expect(note).to_contain_text("do not push each other equally hard")
    pushes = rows.filter(has_text="greatest push on").all_inner_texts()
    numbers = [float(row.split("\t")[1].split()[0]) for row in pushes]
    assert numbers[1] == pytest.approx(4 * numbers[0], rel=0.02)
    expect(page.locator(".carts-law-shown figure svg:visible")).to_have_count(1)
    caption = page.locator(".carts-law-shown figcaption")
    expect(caption).to_have_text("Your law")
    write(page, HEAVY + "\n")
    expect(caption).to_have_text("Your law, before you changed it")
    head = page.locator(".carts-worlds-ends th[scope=col]")
    expect(head).to_have_text("Your law, before you changed it")
    write(page, HEAVY)
    expect(caption).to_have_text("Your law")
    press(page, "Judge")
    broken = page.locator(".carts-law-broken")
    assert "third-law" in broken.evaluate_all("all => all.map((one) => one.dataset.check)")
    expect(page.locator(".carts-law-verdicts li")).to_have_count(6)
    worst = page.locator("li[data-check=third-law]")
    assert "mass_other" in (worst.locator("pre").text_content() or "")
    worst.get_by_role("button").click()
    expect(page.locator(".carts-law-shown figcaption")).to_have_text(
        "A counterexample", timeout=STARTS
    )
    assert page.get_by_label("Your law, in Python").input_value() == HEAVY


@pytest.mark.one_browser
def test_what_was_judged_goes_with_the_law_that_it_was_of(
    shared_page: SharePage, bench: Path
) -> None:
    page = opened(shared_page, bench)
    write(page, HEAVY)
    press(page, "Judge")
    expect(page.locator(".carts-law-verdicts li")).to_have_count(6)
    expect(page.locator(".carts-law-shown figcaption")).to_have_text("Your law")  # its run, too
    expect(page.locator(".carts-law-note")).to_have_text("Judged: what was found is below.")
    box = page.get_by_label("Your law, in Python")
    box.press("End")
    page.keyboard.type(" ")
    expect(page.locator(".carts-law-verdicts")).to_have_count(0)
    note = page.locator(".carts-law-note")
    expect(note).to_have_text("Your law has changed: judge it again.")
    write(page, SPRING)
    page.get_by_role("button", name="Judge", exact=True).click()
    expect(note).to_contain_text("The judge looks", timeout=STARTS)
    write(page, HEAVY)  # while it still looks at the spring
    expect(note).to_have_text("Your law has changed: judge it again.", timeout=STARTS)
    expect(page.locator(".carts-law-verdicts")).to_have_count(0)
    press(page, "Judge")
    expect(page.locator("li[data-check=third-law]")).to_have_class("carts-law-broken")


@pytest.mark.one_browser
def test_a_second_law_of_the_scene_stays_and_the_blocks_own_is_judged(
    open_page: OpenPage, tmp_path: Path
) -> None:
    """It was sent without the text of the other one: “there is no text of the law”."""
    page = opened(open_page, build_law(tmp_path, TWO))
    press(page, "Run")
    expect(page.locator(".carts-law-fault")).to_have_text("")
    expect(page.locator(".carts-law-shown figcaption")).to_have_text("Your law")
    write(page, HEAVY)
    press(page, "Judge")
    expect(page.locator("li[data-check=third-law]")).to_have_class("carts-law-broken")


@pytest.mark.parametrize(
    ("text", "line", "words"),
    [
        ("def force(overlap, rate)\n    return 1\n", 1, "this is not Python"),
        ("def force(overlap, rate):\n    while True:\n        pass\n", 2, "goes on and on"),
        ("def force(overlap, rate):\n    x = 0\n    return 1 / x\n", 3, "ZeroDivisionError"),
        ("import os\ndef force(overlap):\n    return 1\n", 1, "cannot import"),
        (
            "def force(overlap):\n    x = [9]\n    x[0] **= 9 ** 8\n    return 1\n",
            3,
            "to the power",
        ),
        ("def force(overlap):\n    x = f'{1:{9}}'\n    return 1\n", 2, ":{*}"),
        (LONG + "def force(overlap)\n    return 1\n" + LONG, 31, "not Python"),
    ],
)
@pytest.mark.one_browser
def test_what_is_wrong_is_told_with_its_line_and_the_cursor_goes_there(
    shared_page: SharePage, bench: Path, text: str, line: int, words: str
) -> None:
    page = opened(shared_page, bench)
    write(page, text)
    press(page, "Run")
    fault = page.locator(".carts-law-fault")
    expect(fault).to_contain_text(f"line {line}:")
    expect(fault).to_contain_text(words)
    box = page.get_by_label("Your law, in Python")
    expect(box).to_be_focused()
    assert text[: box.evaluate("box => box.selectionStart")].count("\n") == line - 1
    assert box.input_value() == text
    top, height, left = box.evaluate(SEEN, line)
    assert 0 <= top < height, "the line is in the box"
    assert left == 0
    write(page, SPRING)
    press(page, "Run")
    expect(fault).to_have_text("")


def test_the_text_is_kept_survives_a_reload_and_is_in_the_answer_file(
    open_page: OpenPage, bench: Path
) -> None:
    page = opened(open_page, bench)
    write(page, HEAVY)
    page.wait_for_selector("carts-law[data-kept]")
    page.reload()
    page.wait_for_selector("carts-law[data-state=live]")
    box = page.get_by_label("Your law, in Python")
    expect(box).to_have_value(HEAVY)
    page.evaluate(CATCH)
    page.get_by_role("button", name="Save as a file", exact=True).click()
    assert bytes(page.evaluate(LAST)).decode("utf-8") == HEAVY
    kept = page.evaluate(
        """async () => {
          const open = indexedDB.open("carts:test-site");
          const db = await new Promise((done) => { open.onsuccess = () => done(open.result); });
          const name = db.objectStoreNames[0];
          const all = db.transaction(name).objectStore(name).getAll();
          return new Promise((done) => { all.onsuccess = () => done(JSON.stringify(all.result)); });
        }"""
    )
    assert "mass_other" in json.dumps(json.loads(kept))


@pytest.mark.one_browser
def test_the_tab_key_leads_on_and_enter_goes_on_below_the_first_letter(
    shared_page: SharePage, bench: Path
) -> None:
    page = opened(shared_page, bench)
    box = page.get_by_label("Your law, in Python")
    box.fill("def force(overlap, rate):")
    box.press("End")
    page.keyboard.press("Enter")
    page.keyboard.type("x = 1")
    page.keyboard.press("Enter")
    page.keyboard.type("return x")
    expect(box).to_have_value("def force(overlap, rate):\n    x = 1\n    return x")
    page.keyboard.press("Tab")
    expect(page.get_by_role("button", name="Run", exact=True)).to_be_focused()


@pytest.mark.one_browser
def test_on_paper_and_without_a_script_the_law_is_code(shared_page: SharePage, bench: Path) -> None:
    page = opened(shared_page, bench)
    write(page, HEAVY)
    page.emulate_media(media="print")
    expect(page.locator(".carts-law-paper code")).to_have_text(HEAVY)
    expect(page.locator(".carts-law-paper")).to_be_visible()
    expect(page.locator("carts-law textarea")).to_be_hidden()


@pytest.mark.one_browser
def test_only_pages_with_a_law_carry_what_runs_it(site: Path) -> None:
    laws = 0
    for path in site.rglob("*.html"):
        text = path.read_text(encoding="utf-8")
        named = "<carts-law " in text
        laws += named
        assert ("carts/law.js" in text) == named, path
    assert laws == 1
